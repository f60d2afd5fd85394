# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Writes the problem files: each run of families.py once, and what is trivial left out. Finds those that are at hand."""
import dataclasses
import json
import os
import pathlib
import shlex
import shutil
import subprocess

import families
import fclib_files
from points import ROOT, StudyError, program_point
from run_folder import RunFolder

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


def process(words):
    return subprocess.run([str(word) for word in words], cwd=ROOT, env={**os.environ, **ONE_THREAD}, capture_output=True,
                          text=True, check=False)


def relative(path):
    """As commands show it, which are called in the root of the project."""
    return path.relative_to(ROOT) if path.is_relative_to(ROOT) else path


class Writer:
    """Writes problems below `folder`; what is there is not written again. `programs` has orthocone and orthocone-solve (solve);
    `note` takes sentences for the user."""

    def __init__(self, folder, programs, note):
        self._folder, self._programs, self._note = folder.resolve(), programs, note

    def _is_done(self, name, command):
        done = self._folder / name / "done.json"
        try:
            return json.loads(done.read_text(encoding="utf-8")) == {"command": command}
        except (FileNotFoundError, ValueError):  # ValueError: the machine stopped before it was written
            return False

    def _set_done(self, name, command):
        (self._folder / name / "done.json").write_text(json.dumps({"command": command}), encoding="utf-8")

    def folder_of(self, run):
        """Folder of a run that is done."""
        folder, point = self._folder / run.name, command_of(run)
        if self._is_done(run.name, point.command):
            return folder
        shutil.rmtree(folder, ignore_errors=True)
        words = [self._programs["orthocone"], *point.words[1:]]
        words[words.index("--output") + 1] = folder
        result = process(words)
        if result.returncode not in (0, 3):  # 3: a step that no method solved ends a run, and leaves its problem, too
            raise StudyError(f"{run.name}: {result.stderr.strip()}")
        if result.returncode:
            self._note(f"{run.name}: {result.stderr.strip().splitlines()[0]}")
        shutil.rmtree(folder / "checkpoint", ignore_errors=True)
        self._set_done(run.name, point.command)
        return folder

    def of_run(self, run):
        """Its problems, without those in which nothing is pressed. Those of steps that it did not solve are a family."""
        done = RunFolder(self.folder_of(run))
        pressed = pressed_steps(done.history)
        for step, path in done.problems().items():
            is_solved = step in pressed
            if (not is_solved or pressed[step]) and 108 * LEAST_NODES**2 < path.stat().st_size < 1.05 * 108 * MOST_NODES**2:
                yield Problem(f"{run.name}/{step}", run.family if is_solved else families.UNSOLVED, run.law, path,
                              command_of(run).command)

    def of_stack(self, stack):
        """A stack of rigid plates; without a solution, for forces are not unique."""
        path = self._folder / stack.name / "problem-0001.hdf5"
        command = f"tools/study peers --only problems --families rigid # {stack.n_plates} plates, {stack.n_contacts} contacts each"
        if not self._is_done(stack.name, command):
            path.parent.mkdir(parents=True, exist_ok=True)
            path.unlink(missing_ok=True)  # FCLIB adds to what is there
            W, q, mu = stack.problem()
            fclib_files.write(path, W, q, mu)
            self._set_done(stack.name, command)
        return Problem(f"{stack.name}/1", "rigid", "isotropic", path, command)

    def changed(self, other, base):
        """The problem of another one with another law."""
        path = self._folder / other.name / "problem-0001.hdf5"
        words = ["build/orthocone-solve", relative(base.path), "--friction", "%.6g,%.6g" % other.mu, "--slip",
                 "%.6g,%.6g" % other.p, "--iterations", 20000, "--write", relative(path)]
        command = shlex.join(str(word) for word in words)
        if not self._is_done(other.name, command):
            path.parent.mkdir(parents=True, exist_ok=True)
            path.unlink(missing_ok=True)
            result = process([self._programs["solve"], *words[1:]])
            if not path.exists():
                raise StudyError(f"{other.name}: {result.stderr.strip()}")
            self._set_done(other.name, command)
        return Problem(f"{other.name}/1", other.family, other.law, path, command)


def pressed_steps(history):
    """{solved step: whether something is pressed}: without forces there is nothing to race."""
    forces = abs(history["force_z"]) if history else ()
    return {int(step): force > 1e-6 * max(forces) for step, force in zip(history.get("step", ()), forces)}


def listed(writer, is_quick, wanted):
    """All problems of the wanted families: those of runs, those of rigid bodies, and those whose laws are changed."""
    changed = [law for law in families.changed_laws(is_quick) if law.family in wanted]
    bases = {law.base.split("/")[0] for law in changed}
    found = []
    for run in families.all_runs(is_quick):
        if run.family in wanted or run.name in bases:
            found += writer.of_run(run)
    if "rigid" in wanted:
        found += [writer.of_stack(stack) for stack in families.stacks(is_quick)]
    named = {problem.name: problem for problem in found}
    found += [writer.changed(other, named[other.base]) for other in changed if other.base in named]
    return [problem for problem in found if problem.family in wanted]


def refusal(path, programs):
    """Why a file of FCLIB is not raced; nothing if it is."""
    size = process([programs["judge"], path])
    if size.returncode == 0 and int(size.stdout) > MOST_NODES:
        return f"has {size.stdout.strip()} nodes; at most {MOST_NODES} are raced"
    ours = process([programs["solve"], path, "--method", "gauss-seidel", "--iterations", 1])
    if ours.returncode not in (0, 3) or ours.stderr:
        return ours.stderr.strip().removeprefix(f"orthocone-solve: {path}").lstrip(": ")
    return size.stderr.strip() if size.returncode else ""


def at_hand(folder, programs, note):
    """The problems of FCLIB below a folder. Those that are refused are named."""
    paths = sorted(folder.resolve().rglob("*.hdf5"))
    if not paths:
        raise StudyError(f"{folder}: there is no file *.hdf5 in it")
    for path in paths:
        name = path.relative_to(folder.resolve()).with_suffix("")
        why = refusal(path, programs)
        if why:
            note(f"{name}.hdf5 is not raced: {why}")
        else:
            yield Problem(str(name), "fclib", "isotropic", path, f"# a file of FCLIB: {name}.hdf5")
