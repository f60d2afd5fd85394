# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The runs of a parameter study, and the table of their summaries."""
import csv
import io
import json
import os
import pathlib
import signal
import subprocess
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent / "runs"))
from run_folder import RunFolder, write_whole  # noqa: E402

# Column, unit, and where summary.json has it.
COLUMNS = [
    ("contact_nodes", "", ("model", "contact_nodes")),
    ("steps_solved", "", ("steps", "solved")),
    ("max_slip", "mm", ("peaks", "slip_mm", "value")),
    ("max_pressure", "MPa", ("peaks", "pressure_MPa", "value")),
    ("max_force_z", "N", ("peaks", "force_z_N", "value")),
    ("total_dissipation", "N mm", ("total_dissipation_Nmm",)),
    ("work", "N mm", ("energy", "work_Nmm")),
    ("critical_friction", "", ("critical_friction", "factor")),
    ("iterations", "", ("contact_solver", "iterations")),
    ("largest_residual", "", ("contact_solver", "largest_residual")),
    ("seconds", "s", ("seconds", "total")),
]
OWN_COLUMNS = {"exit", "status", "cpu_seconds", "folder"} | {name for name, _, _ in COLUMNS}
UNITS = {name: unit for name, unit, _ in COLUMNS}


class Run:
    """A point, its folder and its settings; `exit` and `message` once it was run, or found complete."""

    def __init__(self, point, folder, settings):
        self.point, self.folder, self.settings = point, folder, settings
        self.exit, self.message, self.cpu_seconds = None, "", None

    def summary(self):
        """{} where the run has not come so far."""
        try:
            return RunFolder(self.folder).summary
        except (OSError, ValueError):
            return {}

    def is_complete(self):
        return self.summary().get("status") == "complete"

    def has_failed(self):
        return self.exit != 0

    def state(self):
        """Words about a run that has ended."""
        return f"exit code {self.exit}: {self.message}" if self.has_failed() else "complete"

    def words(self, file, anew):
        """Arguments of the program. One thread a run: several run at a time."""
        words = [str(file), "--quiet", "--threads", "1", "--output", str(self.folder)]
        if self.folder.exists() and not anew:
            words.append("--resume")
        return words + [word for setting in self.settings for word in ("--set", setting)]


class Worker:
    """A process of the program that runs several points at a time. It pays the time of a start once: loading its libraries
    takes longer than a small run. Points that have the same body share it."""

    def __init__(self, program, jobs):
        # All symbols are looked up at the start, not once more in every run; BLAS makes no threads of its own.
        environment = {**os.environ, "LD_BIND_NOW": "1", "OPENBLAS_NUM_THREADS": "1"}
        self.process = subprocess.Popen([program, "--batch", "--jobs", str(jobs)], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, encoding="utf-8", errors="replace", env=environment)
        self.n_lines, self.running = 0, {}  # runs by numbers of their lines

    def begin(self, run, words):
        self.n_lines += 1
        self.running[self.n_lines] = run
        try:
            self.process.stdin.write(json.dumps(words) + "\n")
            self.process.stdin.flush()
        except OSError:
            pass  # it was killed, and gives no answer

    def answer(self):
        """The next run that has ended, and what the program says of it; None where the process has ended."""
        try:
            answer = json.loads(self.process.stdout.readline())
            return self.running.pop(answer["line"]), answer
        except (OSError, ValueError):
            return None

    def end(self):
        try:
            self.process.stdin.close()
        except OSError:
            pass  # it was killed
        self.process.wait()
        self.process.stdout.close()


def work_off(todo, options, done):
    """Runs a list of runs on one worker, and on another one if that is killed."""
    worker, jobs = Worker(options.program, options.jobs), options.jobs
    while worker.running or (todo and not options.is_interrupted):
        while todo and len(worker.running) < jobs and not options.is_interrupted:
            run = todo.pop(0)
            worker.begin(run, run.words(options.file, options.anew))
        if found := worker.answer():
            run, answer = found
            run.exit, run.message, run.cpu_seconds = answer["exit"], answer["message"].strip(), answer["cpu_seconds"]
            done(run)
            continue
        worker.end()
        for run in worker.running.values() if not options.is_interrupted else ():
            run.exit, run.message = 137, "the worker was killed"
            done(run)
        worker = Worker(options.program, jobs)
    worker.end()


def run_all(runs, options):
    """Runs what is not complete, `options.jobs` runs at a time."""
    todo = []
    for run in runs:
        if not options.anew and run.is_complete():
            run.exit = 0
        else:
            run.folder.parent.mkdir(parents=True, exist_ok=True)
            todo.append(run)
    n_all, n_done = len(todo), 0
    print(f"{len(runs)} points, {n_all} to run", flush=True)

    def done(run):
        nonlocal n_done
        n_done += 1
        print(f"{n_done} of {n_all}: {run.folder.name}: {run.state()}", flush=True,
              file=sys.stderr if run.has_failed() else sys.stdout)

    def stop(*_):
        """The runs get the signal, too: each finishes its step, and the study can go on from there."""
        options.is_interrupted = True

    options.is_interrupted = False
    before = signal.signal(signal.SIGINT, stop)
    if todo:
        work_off(todo, options, done)
    signal.signal(signal.SIGINT, before)


def value_at(summary, path):
    """A number; None where the summary has none."""
    for key in path:
        summary = summary.get(key) if isinstance(summary, dict) else None
    is_number = isinstance(summary, (int, float)) and abs(summary) <= sys.float_info.max
    return summary if is_number else None


def write_table(runs, path):
    """sweep.csv, a row a run. Returns the rows as dictionaries."""
    rows = []
    for run in runs:
        summary = run.summary() if run.exit in (0, 3) else {}
        row = {**run.point, "exit": run.exit, "status": str(summary.get("status", run.message or "not run"))}
        row |= {name: value_at(summary, where) for name, _, where in COLUMNS}
        rows.append(row | {"cpu_seconds": run.cpu_seconds, "folder": f"runs/{run.folder.name}"})
    text = io.StringIO(newline="")
    writer = csv.DictWriter(text, rows[0].keys())
    writer.writeheader()
    writer.writerows(rows)
    write_whole(path, text.getvalue())
    return rows
