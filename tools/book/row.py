# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Scenes of prm/verification and rows of the book; runs of the program, each scene once."""
import dataclasses
import math
import pathlib
import subprocess
import typing

import run_folder

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


class ProgramError(Exception):
    """The program stopped with an error."""


@dataclasses.dataclass(frozen=True)
class Scene:
    """A file of prm/verification with settings, and the exit code that its run has."""

    file: str
    settings: tuple = ()
    code: int = 0

    def set(self, *settings):
        """The same with further settings, which override those before them."""
        return dataclasses.replace(self, settings=(*self.settings, *settings))

    def command(self):
        """What a user types."""
        return " ".join([f"./run prm/verification/{self.file}.prm", *(f'--set "{setting}"' for setting in self.settings)])


@dataclasses.dataclass(frozen=True)
class Row:
    """A known answer.

    measured(runs, scene) is ours; `bound` the largest difference from `reference` that passes, relative to `scale` (without
    one, the reference). `limit` says what the theory neglects, `printed` what other programs print, `source` who gave the
    answer. `meshes` are the settings of three meshes, each twice as fine as the one before, where ours has an order of
    convergence, which is at least `order`."""

    id: str
    scene: Scene
    quantity: str
    measured: typing.Callable
    reference: float
    bound: float
    source: str
    limit: str = ""
    printed: str = ""
    scale: float = 0
    meshes: tuple = ()
    order: float = 0

    def difference(self, ours):
        """Of ours, relative."""
        return (ours - self.reference) / (self.scale or abs(self.reference))

    def passes(self, ours):
        return abs(self.difference(ours)) <= self.bound

    def order_of(self, runs):
        """Of convergence, from what ours changes by from mesh to mesh: log2 of the ratio of both changes."""
        coarse, middle, fine = (self.measured(runs, self.scene.set(*settings)) for settings in self.meshes)
        if middle == fine or coarse == middle:
            return math.inf
        return math.log2(abs(coarse - middle) / abs(middle - fine))


class Runs:
    """Runs the program, each scene once, in folders below `folder`."""

    def __init__(self, program, folder):
        self.program, self.folder = pathlib.Path(program), pathlib.Path(folder)
        self._done = {}

    def __call__(self, scene):
        """The run folder of a scene."""
        if scene not in self._done:
            folder = self.folder / f"{scene.file}-{len(self._done)}"
            self._start(scene, folder)
            self._done[scene] = run_folder.RunFolder(folder)
        return self._done[scene]

    def _start(self, scene, folder):
        command = [str(self.program), str(ROOT / f"prm/verification/{scene.file}.prm"), "--quiet", "--output", str(folder),
                   *(f"--set={setting}" for setting in scene.settings)]
        try:
            result = subprocess.run(command, stderr=subprocess.PIPE, text=True, check=False)
        except OSError as error:
            raise ProgramError(f"{self.program} could not be started: {error.strerror}; ./run builds it") from error
        if result.returncode != scene.code:
            raise ProgramError(f"{scene.command()} ended with code {result.returncode}: {result.stderr.strip()}")
