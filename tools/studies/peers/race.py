# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Solves problem files by our methods and by Siconos' solvers, to the same error in the same measure, in turns."""
import csv
import hashlib
import os
import resource
import signal
import statistics
import subprocess

from points import ROOT, StudyError

BOUND = 1e-8        # of the error that siconos_solve measures on the forces of every solver
LOOSER = 100        # the first tolerance of the peers over the bound
BOUNDS = (1e-2, 1e-4, 1e-6, 1e-8, 1e-10)  # of the chart of time against error
OURS = ("newton", "gauss-seidel", "uzawa", "plain-newton")
PEERS = ("nsgs-ac", "nsgs-pli", "nsn-ac", "nsn-ac-new", "nsn-hybrid", "admm", "admm-balanced")
SOLVERS = OURS + PEERS
TIMES_OF_NEWTON, LEAST_LIMIT, MOST_LIMIT = 100, 0.2, 10.  # seconds of CPU time for one solution
ROUNDS, ATTEMPTS = 2, 10
START = 0.3  # s of CPU time, of a process that reads a file
ENOUGH, MOST_REPEATS = 0.05, 9  # seconds, solutions of a process whose median is taken; siconos_solve does the same
FAILURES = {3: "slow, cycling or diverging", -27: "time", -9: "time", -6: "abort"}
COLUMNS = ("problem", "family", "law", "nodes", "solver", "verdict", "iterations", "tolerance", "seconds", "error", "merit",
           "difference", "fingerprint")


class Fingerprints:
    """What a row depends on, in twelve digits: the solvers' programs and the file of the problem."""

    def __init__(self, tools):
        self._programs = hashlib.sha256()
        for name in ("solve", "judge", "siconos"):
            self._programs.update(tools[name].read_bytes() if name in tools else b"")

    def of(self, problem):
        digest = self._programs.copy()
        digest.update(problem.path.read_bytes())
        return digest.hexdigest()[:12]


class Racer:
    """Runs one process at a time. `tools` has the programs: orthocone-solve, judge_forces, the clock, and siconos_solve if it
    is there."""

    def __init__(self, tools, folder, bound=BOUND):
        self._tools = tools
        self._solvers = SOLVERS if "siconos" in tools else OURS
        self._bound = bound
        self._answer = folder / "answer.hdf5"
        self._environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1",
                             "LD_PRELOAD": str(tools["clock"])}

    def _run(self, words, seconds):
        """Exit code and the values of the last line."""
        code, lines = self._lines(words, seconds)
        return code, lines[-1].split(",") if lines else []

    def _lines(self, words, seconds):
        """Exit code and output. The kernel ends what takes longer."""
        def bound():
            signal.setitimer(signal.ITIMER_PROF, seconds)  # outlives exec
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        result = subprocess.run([str(word) for word in words], cwd=ROOT, env=self._environment, capture_output=True, text=True,
                                preexec_fn=bound, check=False)
        return result.returncode, result.stdout.strip().splitlines()

    def _judged(self, path):
        code, values = self._run([self._tools["judge"], path, self._answer], 60)
        if code:
            raise StudyError(f"{path}: cannot be judged")
        return dict(zip(("error", "merit", "difference"), map(float, values)))

    def ours(self, path, method, tolerance, limit, repeats, is_written):
        """A row, without judgement unless the forces are written."""
        words = [self._tools["solve"], path, "--method", method, "--tolerance", tolerance, "--iterations", 10000000, "--csv",
                 "--repeat", repeats, *(["--write", self._answer] if is_written else [])]
        self._answer.unlink(missing_ok=True)
        code, values = self._run(words, limit * repeats + START)
        if len(values) < 7 or (is_written and not self._answer.exists()):
            return {"verdict": FAILURES.get(code, f"exit code {code}")}
        row = {"nodes": values[0], "verdict": values[3], "iterations": values[4], "tolerance": f"{tolerance:.3g}",
               "seconds": float(values[5])}
        if row["seconds"] > limit:
            return {"verdict": "time", "nodes": values[0]}
        return {**row, **(self._judged(path) if is_written else {})}

    def our_first(self, path, method, limit):
        """The row of a tolerance that does."""
        tolerance = self._bound
        for _ in range(ATTEMPTS):
            row = self.ours(path, method, tolerance, limit, 1, True)
            if "error" not in row or row["error"] <= self._bound or row["verdict"] != "converged":
                break
            tolerance *= min(0.5, 0.7 * self._bound / row["error"])
        if "error" in row and row["error"] <= self._bound:
            row["verdict"] = "solved"
        elif row["verdict"] == "converged":
            row["verdict"] = "error"
        return row

    def peer(self, path, solver, limit):
        code, values = self._run([self._tools["siconos"], path, "solve", solver, self._bound, LOOSER * self._bound, limit],
                                 (limit + 1) * ATTEMPTS)
        if len(values) < 7:
            return {"verdict": FAILURES.get(code, f"exit code {code}")}
        row = {"iterations": values[1], "tolerance": values[2], "seconds": float(values[3]), "error": float(values[4]),
               "merit": float(values[5]), "difference": float(values[6])}
        return {"verdict": "solved" if code == 0 else "error", **row}

    def first(self, path, solver, limit):
        return self.our_first(path, solver, limit) if solver in OURS else self.peer(path, solver, limit)

    def round(self, path, rows):
        """{solver: seconds} of one more solution of each, with the tolerances that did."""
        seconds = {}
        for row in rows:
            if row["solver"] in OURS:
                repeats = min(MOST_REPEATS, max(1, int(ENOUGH / row["seconds"])))
                again = self.ours(path, row["solver"], float(row["tolerance"]), 10 * MOST_LIMIT, repeats, False)
                seconds[row["solver"]] = again["seconds"]
        peers = [row for row in rows if row["solver"] in PEERS]
        words = [word for row in peers for word in (row["solver"], row["tolerance"])]
        if words:
            lines = self._lines([self._tools["siconos"], path, "time", *words], 60 * MOST_LIMIT)[1]
            seconds.update({row["solver"]: float(line) for row, line in zip(peers, lines)})
        return seconds

    def of_solvers(self, problem, solvers):
        """Rows of one solution by each of these solvers of Siconos."""
        return [{**about(problem), "solver": solver, **self.peer(problem.path, solver, MOST_LIMIT)} for solver in solvers]

    def race(self, problem, n_rounds=ROUNDS):
        """Rows of all solvers of a problem, newton's first: it sets the limit of the others, unless it fails."""
        rows, limit = [], MOST_LIMIT
        for solver in self._solvers:
            rows.append({"solver": solver, **self.first(problem.path, solver, limit)})
            if solver == "newton" and rows[0]["verdict"] == "solved":
                limit = min(MOST_LIMIT, max(LEAST_LIMIT, TIMES_OF_NEWTON * rows[0]["seconds"]))
        solved = [row for row in rows if row["verdict"] == "solved"]
        rounds = [self.round(problem.path, solved) for _ in range(n_rounds)]
        for row in solved:
            row["seconds"] = f"{statistics.median(seconds[row['solver']] for seconds in rounds):.4g}"
        nodes = self._run([self._tools["judge"], problem.path], 60)[1][0]
        return [{**row, **about(problem), "nodes": nodes} for row in rows]


def about(problem):
    return {"problem": problem.name, "family": problem.family, "law": problem.law}


def within_limits(rows):
    """The same rows; what took longer than the limit has failed, though it was let go on."""
    newton = {row["problem"]: float(row["seconds"]) for row in rows if row["solver"] == "newton" and row["verdict"] == "solved"}
    for row in rows:
        limit = max(LEAST_LIMIT, TIMES_OF_NEWTON * newton[row["problem"]]) if row["problem"] in newton else MOST_LIMIT
        is_late = row["verdict"] == "solved" and float(row["seconds"]) > min(limit, MOST_LIMIT)
        yield {**row, "verdict": "time"} if is_late else row


class Answers:
    """Rows in a file that grows with every problem: what is there is not computed again, unless it is of another program or
    problem. `fingerprints` are those of the problems by their names."""

    def __init__(self, path, fingerprints, is_anew=False):
        self.path = path
        self._fingerprints = fingerprints
        known = []
        if path.exists():
            with open(path, newline="", encoding="utf-8") as file:
                known = list(csv.DictReader(file))
        self.rows = [row for row in known if self._is_right(row) and not (is_anew and row["problem"] in fingerprints)]
        self._write("w", self.rows)

    def _is_right(self, row):
        """Rows of problems that are not asked for stay as they are."""
        print_of_row = row.get("fingerprint", "")
        return print_of_row == self._fingerprints.get(row["problem"], print_of_row)

    def _write(self, mode, rows):
        with open(self.path, mode, newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, COLUMNS)
            if mode == "w":
                writer.writeheader()
            writer.writerows(rows)

    def missing(self):
        """Names of problems without rows, in their order."""
        done = {row["problem"] for row in self.rows}
        return [name for name in self._fingerprints if name not in done]

    def add(self, rows):
        rows = [{**row, "fingerprint": self._fingerprints[row["problem"]]} for row in rows]
        self._write("a", rows)
        self.rows += [{name: str(row.get(name, "")) for name in COLUMNS} for row in rows]

    def asked_for(self):
        """The rows of the problems that have a fingerprint."""
        return [row for row in self.rows if row["problem"] in self._fingerprints]
