# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The points of a study: each one is a command, run once, and a row of a table that carries this command."""
import concurrent.futures
import contextlib
import csv
import dataclasses
import os
import pathlib
import shlex
import subprocess
import tempfile
import threading
import time

from paths import ROOT

INTERRUPTED = 130  # exit code of the program
RUN_FOLDER = "output/point"  # of commands as rows show them


class StudyError(Exception):
    """Something could not be run."""


@dataclasses.dataclass
class Result:
    """What came of a process; `folder` has its files as long as its row is being made."""
    code: int
    output: str
    errors: str
    seconds: float  # wall
    cpu_seconds: float
    gigabytes: float
    folder: pathlib.Path


@dataclasses.dataclass
class Point:
    """Columns that say where the point lies, and the words of its command. Words are relative to the root of the
    project; RUN_FOLDER stands for a folder of its own."""
    columns: dict
    words: list

    @property
    def command(self):
        return shlex.join(str(word) for word in self.words)


def program_point(columns, file, settings, *options):
    """The program with `file` (relative to prm/) and {entry: value}."""
    words = ["build/orthocone", f"prm/{file}", "--quiet", "--output", RUN_FOLDER, *options]
    for entry, value in settings.items():
        words += ["--set", f"{entry}={value}"]
    return Point(columns, words)


def tool_point(columns, *words):
    """The program of small experiments."""
    return Point(columns, ["build/studies", *(str(word) for word in words)])


def _run(words, folder, threads):
    environment = {**os.environ, **({"OPENBLAS_NUM_THREADS": str(threads)} if threads else {})}
    begin = time.perf_counter()
    with open(folder / "stdout", "w+", encoding="utf-8") as output, \
            open(folder / "stderr", "w+", encoding="utf-8") as errors:
        try:
            process = subprocess.Popen(words, cwd=ROOT, stdout=output, stderr=errors, env=environment)
        except OSError as error:
            raise StudyError(f"{words[0]} could not be started: {error.strerror}") from error
        _, status, usage = os.wait4(process.pid, 0)
        seconds = time.perf_counter() - begin
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode < 0 or process.returncode == INTERRUPTED:
            raise StudyError("interrupted; the same command goes on")
        output.seek(0)
        errors.seek(0)
        return Result(process.returncode, output.read(), errors.read(), seconds, usage.ru_utime + usage.ru_stime,
                      usage.ru_maxrss / 1e6, folder / "run")


@contextlib.contextmanager
def ran(words, programs, threads=None):
    """Runs the command in a folder that is gone afterwards; `programs` maps words to files."""
    with tempfile.TemporaryDirectory(prefix="orthocone-study-") as name:
        folder = pathlib.Path(name)
        real = [str(programs.get(word, word)) if word != RUN_FOLDER else str(folder / "run") for word in words]
        yield _run(real, folder, threads)


def write_rows(path, rows):
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, list(rows[0]), extrasaction="ignore")
        writer.writeheader()
        writer.writerows(rows)


class Table:
    """Rows of a study in a CSV file, which grows with every point."""

    def __init__(self, path, anew):
        self.path = pathlib.Path(path)
        self._lock = threading.Lock()
        self._known = {}
        if anew:
            self.path.unlink(missing_ok=True)
        elif self.path.exists():
            with open(self.path, newline="", encoding="utf-8") as file:
                self._known = {row["command"]: row for row in csv.DictReader(file) if row.get("command")}

    def find(self, command):
        return self._known.get(command)

    def add(self, row):
        with self._lock:
            self._known[row["command"]] = {name: str(value) for name, value in row.items()}
            is_new = not self.path.exists()
            if is_new:
                write_rows(self.path, [row])
                return
            with open(self.path, "r+", newline="", encoding="utf-8") as file:
                if next(csv.reader(file)) != list(row):
                    raise StudyError(f"{self.path} has other columns: remove it, or call with --anew")
                file.seek(0, os.SEEK_END)
                csv.DictWriter(file, list(row)).writerow(row)


def measure(table, points, extract, programs, jobs=1, threads=None, note=print):
    """The rows of all points, in their order, as texts. `extract(result, point)` gives the figures of a row."""
    repetitions = [point.command for point in points if "run" in point.columns]
    if len(set(repetitions)) < len(repetitions):
        raise StudyError("runs with the same command would be one run, and its time no median: give each a probe of its own")
    missing = [point for point in points if table.find(point.command) is None]
    done = len(points) - len(missing)
    begin = time.perf_counter()

    def make(point):
        with ran(point.words, programs, threads) as result:
            table.add({**point.columns, **extract(result, point), "command": point.command})

    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        futures = [pool.submit(make, point) for point in missing]
        try:
            for count, future in enumerate(concurrent.futures.as_completed(futures), 1):
                future.result()
                if count % 50 == 0 or count == len(missing):
                    note(f"{done + count} of {len(points)} points, {time.perf_counter() - begin:.0f} s")
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise
    return [table.find(point.command) for point in points]
