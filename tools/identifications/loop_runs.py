# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Runs a scene along measured loops, by a worker process of the program; run folders are removed as soon as they are read."""
import pathlib
import re
import shutil
import sys
import tempfile

import numpy as np

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent / "sweeps"))
from loop_curves import Curves, first_ways, sense  # noqa: E402
from run_folder import RunFolder  # noqa: E402
from sweep_runs import Worker  # noqa: E402

WRONG_INPUT = 2  # exit code of the program
FIXED = ["Load program/Legs=", "Load program/Cycles=1", "Load program/Steps per row=1", "Output/Contact fields=0",
         "Output/Volume fields=0", "Output/Checkpoint=1e9"]


class FailedRun(RuntimeError):
    """A run of the model that did not end well: the exit code and the words of the program."""

    def __init__(self, code, words):
        super().__init__(re.sub(r"^orthocone: ", "", words.strip()) or f"the program ended with exit code {code}")
        self.code = code


class Model:
    """A parameter file whose preload presses the bodies, and whose legs the measured motions replace."""

    def __init__(self, scene, program, settings=(), jobs=2):
        self.scene, self.program, self.settings, self.n_runs = scene, program, list(settings), 0
        self._folder = tempfile.TemporaryDirectory(prefix="orthocone-identify-")
        self._worker, self._jobs = None, jobs

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self._worker:
            self._worker.end()
        self._folder.cleanup()

    def curves(self, wanted):
        """[Curves] of [(direction of the motion (2,), {branch: ways of the model, mm}, settings)]."""
        return [found for found, _, _ in self._run(wanted)]

    def probe(self, loop):
        """Normal force (N) when the loop begins, and the entries of the scene, {section: {entry: text}}."""
        return self._run([(loop.direction, first_ways(loop.direction, loop.amplitude), [])])[0][1:]

    def _run(self, wanted):
        """[(Curves, normal force (N) when the loop begins, entries of the scene)], in the order of what is wanted."""
        self._worker = self._worker or Worker(self.program, self._jobs)
        for place, (direction, ways, settings) in enumerate(wanted):
            self._worker.begin(place, self._words(place, direction, ways, settings))
        found, failures = [None] * len(wanted), []
        while self._worker.running:
            ended = self._worker.answer()
            if ended is None:
                self._worker.end()
                self._worker = None
                raise FailedRun(137, "the worker was killed")
            place, answer = ended
            if answer["exit"] != 0:
                failures.append(FailedRun(answer["exit"], answer["message"]))
            else:
                found[place] = self._read(place, *wanted[place][:2])
        self.n_runs += len(wanted)
        if failures:
            raise failures[0]
        return found

    def _words(self, place, direction, ways, settings):
        folder = self._folder_of(place)
        shutil.rmtree(folder, ignore_errors=True)  # of a run that failed
        signal = folder.with_suffix(".csv")
        signal.write_text(signal_of(direction, ways), encoding="utf-8")
        words = [str(self.scene), "--quiet", "--threads", "1", "--output", str(folder)]
        for setting in (*self.settings, *FIXED, f"Load program/Program file={signal}", *settings):
            words += ["--set", setting]
        return words

    def _read(self, place, direction, ways):
        run = RunFolder(self._folder_of(place))
        counts = {name: len(way) for name, way in ways.items()}
        found = curves_of(run.history, direction, counts), float(run.history["force_z"][-1 - sum(counts.values())]), run.parameters
        shutil.rmtree(run.path)
        return found

    def _folder_of(self, place):
        return pathlib.Path(self._folder.name) / str(place)


def signal_of(direction, ways):
    """The program file that moves the model from rest to the upper end of a loop, and around it twice."""
    place, rows, columns = 0., [], np.flatnonzero(direction)
    for name, way in ways.items():
        start = place
        for step in way:
            place = start + sense(name) * step
            rows.append(",".join(f"{place * direction[axis]:.12g}" for axis in columns))
    return ",".join(f"u{'xy'[axis]} [mm]" for axis in columns) + "\n" + "\n".join(rows) + "\n"


def curves_of(history, direction, counts):
    """The branches of a run, whose last rows are the steps of the signal: {branch: number of steps}."""
    n = sum(counts.values())
    if len(history["step"]) < n + 1:
        raise FailedRun(WRONG_INPUT, "the scene has no Preload, which presses the bodies before the loop")
    motion = np.stack([history["ux"], history["uy"]], axis=1)[-n - 1:] @ direction
    force = np.stack([history["held_force_x"], history["held_force_y"]], axis=1)[-n - 1:]
    branches, row = {}, 0
    for name, count in counts.items():
        rows = slice(row, row + count + 1)
        branches[name] = np.abs(motion[rows] - motion[row]), force[rows] - force[row]
        row += count
    return Curves(direction, branches)
