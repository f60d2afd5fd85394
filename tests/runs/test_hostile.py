# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Hostile and honest input of every kind, none of which another test has: what the program promises holds for each.

Usage: test_hostile.py PROGRAM [--list] [WORD...]
The words choose the rows whose group or name has one of them; --list prints the rows and runs nothing."""
import os
import pathlib
import sys
import time

sys.dont_write_bytecode = True  # the source tree stays clean
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "hostile"))
import command_lines  # noqa: E402
import environments  # noqa: E402
import folders  # noqa: E402
import json_files  # noqa: E402
import parameter_files  # noqa: E402
import promises  # noqa: E402
import relations  # noqa: E402
import values  # noqa: E402
from bench import Bench, Worker  # noqa: E402

GROUPS = {"command lines": command_lines, "parameter files": parameter_files, "JSON files": json_files,
          "values": values, "relations": relations, "run folders": folders,
          "environment and signals": environments}
# In which the way that a process starts is no part of what is tried.
SHARED = {"parameter files", "JSON files", "values", "relations"}
LEAST_ROWS = 220


def faults_of(row, program, worker):
    """What does not hold of a row."""
    with Bench(program, worker) as bench:
        if row.script:
            return row.script(bench)
        for name, content in row.files.items():
            bench.put(name, content)
        if row.prepare:
            row.prepare(bench.folder)
        before = bench.content()
        code, out, err = bench.call(*row.arguments, shell=row.shell, environment=row.environment)
        faults = promises.of_exit(code, row.code) + promises.of_error_output(code, err, row.says)
        run = row.run if code in (promises.DONE, promises.UNSOLVED) else ""
        faults += promises.of_files(code, before, bench.content(), run, row.may_leave)
        faults += ["nothing is printed"] * (code == promises.DONE and not row.run and not out)
        return faults + (promises.of_run(bench.folder / run, code) if run and row.run else [])


def checked(row, program, worker):
    """What a row leaves undone must not stop the others."""
    try:
        return faults_of(row, program, worker)
    except Exception as error:  # pylint: disable=broad-except
        return [f"{type(error).__name__}: {error}"]


def chosen(words):
    rows = [(group, row) for group, module in GROUPS.items() for row in module.ROWS]
    return [(group, row) for group, row in rows if not words or any(word in f"{group}: {row.name}" for word in words)]


def main():
    program, words = os.path.abspath(sys.argv[1]), sys.argv[2:]
    rows = chosen([word for word in words if word != "--list"])
    if "--list" in words:
        print("\n".join(f"{group}: {row.name!r}" for group, row in rows))
        return 0
    start, failed, worker = time.monotonic(), 0, Worker(program)
    for group, row in rows:
        if faults := checked(row, program, worker if group in SHARED and not row.prepare else None):
            failed += 1
            print(f"FAILED {group}: {row.name!r}: " + "; ".join(faults))
    worker.end()
    numbers = {group: sum(group == other for other, _ in rows) for group in GROUPS}
    counts = ", ".join(f"{number} {group}" for group, number in numbers.items() if number)
    print(f"hostile: {len(rows)} inputs ({counts}), {failed} failed, {time.monotonic() - start:.0f} s")
    return failed > 0 or len(rows) < (1 if words else LEAST_ROWS)


if __name__ == "__main__":
    sys.exit(main())
