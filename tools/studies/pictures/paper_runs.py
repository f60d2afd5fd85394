# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The runs behind the figures and tables of docs/paper.md: which file, which settings, in which folder."""
import dataclasses
import pathlib
import subprocess

import numpy as np

import run_folder
from docs_page import ProgramError
from paths import ROOT



@dataclasses.dataclass(frozen=True)
class Mesh:
    title: str
    file_ending: str
    settings: tuple = ()


# The paper prints neither the size of the core block nor the thickness of the rings. The two numbers of `fitted` are
# fitted to the smallest and the largest nodal force of its case A; the four forces of cases B and C are then a check.
# `third` puts the core's corners where its fig. 6 has the four minima.
# All three cases on the same solid meshes: auto would take the axisymmetric model for case A.
SOLID = ("Mesh/Model=quarter",)
MESHES = {
    "bricks": Mesh("the paper's bricks", "_q1"),
    "fitted": Mesh("bricks, fitted", "_q1", ("Mesh/Core ratio=0.286", "Mesh/Rim grading=0.9118")),
    "third": Mesh("bricks, core to R/3", "_q1", ("Mesh/Core ratio=0.3333",)),
    "q2": Mesh("Q2", "", SOLID),
    "refined": Mesh("refined", "", (*SOLID, "Mesh/Degree=3", "Mesh/Core cells=8", "Mesh/Rings=8", "Mesh/Layers=6",
                                    "Mesh/Rim grading=0.5", "Mesh/Layer grading=0.5")),
}
# P is on the 45-degree line, where the paper says. R, its neighbour on the rim at 33.75 degrees, fits the printed
# forces better.
PROBES = {"P": (6.72, 6.72), "R": (8.31, 5.55)}


class Runs:
    """Runs the program, each run once, in folders below `folder`. `last` settings override all others."""

    def __init__(self, program, folder, last=()):
        self.program, self.folder, self.last = pathlib.Path(program), pathlib.Path(folder), tuple(last)
        self.done = {}

    def run(self, name, file, *settings):
        """The run folder of prm/paper/`file`.prm with these settings."""
        if name not in self.done:
            self._start(self.folder / name, file, settings)
            self.done[name] = run_folder.RunFolder(self.folder / name)
        return self.done[name]

    def _start(self, out, file, settings):
        probes = " ; ".join(f"{name}: {x} {y}" for name, (x, y) in PROBES.items())
        settings = ("Output/Volume fields=0", f"Output/Probes={probes}", *settings, *self.last)
        command = [str(self.program), str(ROOT / f"prm/paper/{file}.prm"), "--quiet", "--output", str(out),
                   *(f"--set={setting}" for setting in settings)]
        try:
            result = subprocess.run(command, stderr=subprocess.PIPE, text=True, check=False)
        except OSError as error:
            raise ProgramError(f"{self.program} could not be started: {error.strerror}; ./run builds it") from error
        if result.returncode:
            raise ProgramError(f"run {out.name} ended with code {result.returncode}: {result.stderr.strip()}")

    def case(self, case, mesh):
        """Case a, b or c on one of the MESHES, with all its cycles."""
        return self.run(f"{case}-{mesh}", f"case_{case}{MESHES[mesh].file_ending}", *MESHES[mesh].settings)


def command(file, *settings):
    """What a user types for the same run, in Markdown."""
    return "`" + " ".join([f"./run prm/paper/{file}.prm", *(f'--set "{setting}"' for setting in settings)]) + "`"


def probe_node(run, name):
    """Where (x, y) the program measured a probe: at the contact node next to the place asked for."""
    points = run.contact(run.contact_steps()[0]).points[:, :2]
    return points[np.argmin(np.hypot(*(points - PROBES[name]).T))]


def place(run, name):
    """The same in words."""
    x, y = probe_node(run, name)
    return f"r = {np.hypot(x, y):.2f} mm, {np.degrees(np.arctan2(y, x)):.1f}°"


def slip_length(probe):
    return np.hypot(probe["slip_x"], probe["slip_y"])
