# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Writes the problem files: each run of families.py once, and what is trivial left out."""
import csv
import dataclasses
import json
import os
import pathlib
import shlex
import shutil
import subprocess

import families
from points import ROOT, StudyError, program_point

FOLDER = "output/peers/problems"
MOST_NODES, LEAST_NODES = 450, 8  # a file of 450 nodes has 22 MB
ONE_THREAD = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}


@dataclasses.dataclass
class Problem:
    name: str
    family: str
    law: str
    path: pathlib.Path
    command: str


def command_of(run):
    """The command that writes the problems of a run, as rows and pages show it."""
    settings = {**run.settings, "Output/Problems": run.every, "Output/Contact fields": 0, "Output/Volume fields": 0}
    return program_point({}, run.file, settings, "--threads", "1")


def written_by(run, program, note):
    """Folder of a run that is done."""
    folder = ROOT / FOLDER / run.name
    point = command_of(run)
    done, text = folder / "done.json", json.dumps(point.words)
    if done.exists() and done.read_text(encoding="utf-8") == text:
        return folder
    shutil.rmtree(folder, ignore_errors=True)
    words = [str(program), *point.words[1:]]
    words[words.index("--output") + 1] = str(folder)
    result = subprocess.run(words, cwd=ROOT, env={**os.environ, **ONE_THREAD}, capture_output=True, text=True, check=False)
    if result.returncode not in (0, 3):  # 3: a step that no method solved ends a run; the steps before have their files
        raise StudyError(f"{run.name}: {result.stderr.strip()}")
    if result.returncode:
        note(f"{run.name}: {result.stderr.strip().splitlines()[0]}")
    for path in folder.glob("checkpoint"):
        shutil.rmtree(path)
    done.write_text(text, encoding="utf-8")
    return folder


def pressed_steps(folder):
    """Steps of a run in which something is pressed: without forces there is nothing to race."""
    with open(folder / "history.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    largest = max((abs(float(row["force_z"])) for row in rows), default=0)
    return {int(row["step"]) for row in rows if abs(float(row["force_z"])) > 1e-6 * largest}


def problems(runs, program, note):
    """All problems of the runs, in their order."""
    for run in runs:
        folder = written_by(run, program, note)
        steps = pressed_steps(folder)
        for path in sorted(folder.glob("problem-*.hdf5")):
            step = int(path.stem.split("-")[1])
            bytes_of_a_file = path.stat().st_size
            if step in steps and 108 * LEAST_NODES**2 < bytes_of_a_file < 1.05 * 108 * MOST_NODES**2:
                yield Problem(f"{run.name}/{step}", run.family, run.law, path, command_of(run).command)


def changed(other, base, program):
    """The problem of another one with another law."""
    path = ROOT / FOLDER / other.name / "problem-0001.hdf5"
    path.parent.mkdir(parents=True, exist_ok=True)
    words = ["build/orthocone-solve", base.path.relative_to(ROOT), "--friction", "%.6g,%.6g" % other.mu, "--slip",
             "%.6g,%.6g" % other.p, "--iterations", 20000, "--write", path.relative_to(ROOT)]
    command = shlex.join(str(word) for word in words)
    done = path.parent / "done.json"
    if not (done.exists() and done.read_text(encoding="utf-8") == command):
        result = subprocess.run([str(program), *(str(word) for word in words[1:])], cwd=ROOT, env={**os.environ, **ONE_THREAD},
                                capture_output=True, text=True, check=False)
        if not path.exists():
            raise StudyError(f"{other.name}: {result.stderr.strip()}")
        done.write_text(command, encoding="utf-8")
    return Problem(f"{other.name}/1", "changed law", other.law, path, command)


def listed(is_quick, programs, note):
    """All problems: those of runs, and those whose laws are changed."""
    found = list(problems(families.all_runs(is_quick), programs["orthocone"], note))
    named = {problem.name: problem for problem in found}
    for other in families.changed_laws(is_quick):
        if other.base in named:
            found.append(changed(other, named[other.base], programs["solve"]))
    return found
