# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The runs of a parameter study, and the table of their summaries."""
import csv
import io
import json
import os
import pathlib
import queue
import signal
import subprocess
import sys
import threading

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

    def words(self, file, anew):
        """Arguments of the program. One thread a run: several run at a time."""
        words = [str(file), "--quiet", "--threads", "1", "--output", str(self.folder)]
        if self.folder.exists() and not anew:
            words.append("--resume")
        return words + [word for setting in self.settings for word in ("--set", setting)]


class Worker:
    """A process of the program that pays the time of a start once: loading its libraries takes longer than a small run."""

    def __init__(self, program):
        # All symbols are looked up at the start, not once more in every run; BLAS makes no threads of its own.
        environment = {**os.environ, "LD_BIND_NOW": "1", "OPENBLAS_NUM_THREADS": "1"}
        self.process = subprocess.Popen([program, "--batch"], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        encoding="utf-8", errors="replace", env=environment)

    def answer(self, words):
        try:
            self.process.stdin.write(json.dumps(words) + "\n")
            self.process.stdin.flush()
            return json.loads(self.process.stdout.readline())
        except (OSError, ValueError):
            return None  # it was killed

    def end(self):
        try:
            self.process.stdin.close()
        except OSError:
            pass  # it was killed
        self.process.wait()


def work_off(todo, options, done):
    worker = Worker(options.program)
    while not options.is_interrupted:
        try:
            run = todo.get_nowait()
        except queue.Empty:
            break
        answer = worker.answer(run.words(options.file, options.anew))
        if answer is None:
            worker.end()
            answer = {"exit": 137, "message": "the worker was killed", "cpu_seconds": None}
            worker = Worker(options.program)
        run.exit, run.message, run.cpu_seconds = answer["exit"], answer["message"].strip(), answer["cpu_seconds"]
        done(run)
    worker.end()


def run_all(runs, options):
    """Runs what is not complete, on `options.jobs` workers."""
    todo = queue.Queue()
    for run in runs:
        if not options.anew and run.is_complete():
            run.exit = 0
        else:
            run.folder.parent.mkdir(parents=True, exist_ok=True)
            todo.put(run)
    n_all, n_done, lock = todo.qsize(), 0, threading.Lock()
    print(f"{len(runs)} points, {n_all} to run", flush=True)

    def done(run):
        nonlocal n_done
        with lock:
            n_done += 1
            state = "complete" if run.exit == 0 else f"exit code {run.exit}: {run.message}"
            print(f"{n_done} of {n_all}: {run.folder.name}: {state}", flush=True,
                  file=sys.stdout if run.exit == 0 else sys.stderr)

    threads = [threading.Thread(target=work_off, args=(todo, options, done)) for _ in range(min(options.jobs, n_all))]
    def stop(*_):
        """The runs get the signal, too: each finishes its step, and the study can go on from there."""
        options.is_interrupted = True

    options.is_interrupted = False
    before = signal.signal(signal.SIGINT, stop)
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
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
