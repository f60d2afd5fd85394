# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Runs of solid models with files of every step, for the tests that read them with VTK."""
import csv
import functools
import pathlib
import subprocess
import tempfile
import unittest

import numpy as np

from vtu_grid import Grid

PROGRAM = []  # its path, from the command line of the test
SCRATCH = tempfile.TemporaryDirectory()
RADIUS, HEIGHT, CORE_CELLS, N_STEPS = 10, 8, 2, 4
MU = np.array([0.3, 0.15])
PROBE = np.array([-6, -3])
SCENE = f"""subsection Geometry
  set Radius = {RADIUS}
  set Height = {HEIGHT}
end
subsection Mesh
  set Core cells = {CORE_CELLS}
  set Rings      = 2
  set Layers     = 2
end
subsection Friction
  set Coefficients   = {MU[0]}, {MU[1]}
  set Slip potential = 0.05, 0.2
end
subsection Output
  set Contact fields = 1
  set Volume fields  = 1
  set Probes         = P: {PROBE[0]} {PROBE[1]}
end
"""
CASES = [(degree, model) for degree in (1, 2, 3) for model in ("full", "half", "quarter")]
SHARE = {"full": 1, "half": 1 / 2, "quarter": 1 / 4}
OPEN, STICK, SLIP = 0, 1, 2
SINGLE = 1e-5  # the files hold single precision
CONTACT_FIELDS = {"displacement": 3, "slip": 3, "slip_magnitude": 1, "accumulated_slip": 1, "gap": 1, "pressure": 1,
                  "friction_traction": 3, "friction_criterion": 1, "status": 1, "nodal_force": 3,
                  "dissipated_energy": 1, "wear_depth": 1, "surface_id": 1}
VOLUME_FIELDS = {"displacement": 3, "stress": 9, "von_mises_stress": 1, "principal_stress_1": 1, "principal_stress_2": 1,
                 "principal_stress_3": 1, "stress_error": 1, "region": 1}


@functools.lru_cache(maxsize=None)
def run_folder(degree, model, *more, legs="0 0 -0.1 : 2 ; 0 0 -0.05 : 2"):
    """`more` are further entries, ENTRY=VALUE."""
    folder = pathlib.Path(tempfile.mkdtemp(dir=SCRATCH.name))
    (folder / "case.prm").write_text(SCENE)
    kind = "auto" if model == "quarter" else model
    settings = [f"--set={entry}" for entry in (f"Mesh/Degree={degree}", f"Mesh/Model={kind}", f"Load program/Legs={legs}", *more)]
    subprocess.run([*PROGRAM, "case.prm", "--quiet", "--output", "run", *settings], cwd=folder, check=True, timeout=300)
    return folder / "run"


@functools.lru_cache(maxsize=None)
def grid(degree, model, kind, step, *more):
    return Grid(run_folder(degree, model, *more) / f"{kind}-{step:04d}.vtu")


def table(degree, model, name, *more):
    """Rows of a .csv file: column -> number, or text where it is none."""
    def value(text):
        try:
            return float(text)
        except ValueError:
            return text
    with open(run_folder(degree, model, *more) / name, encoding="ascii") as file:
        return [{key: value(text) for key, text in row.items()} for row in csv.DictReader(file)]


def each(kind, cases=tuple(CASES)):
    """Runs a test of one file for the files of all cases and steps."""
    def decorate(test):
        def run_all(self):
            for degree, model in cases:
                for step in range(1, N_STEPS + 1):
                    with self.subTest(degree=degree, model=model, step=step):
                        test(self, grid(degree, model, kind, step), degree, model, step)
        return run_all
    return decorate


class VtkTest(unittest.TestCase):
    """Comparison of fields."""

    def assert_close(self, values, expected, scale=None, tolerance=SINGLE):
        """Largest difference relative to the largest value expected."""
        if scale is None:
            scale = np.max(np.abs(expected))
        self.assertLessEqual(np.max(np.abs(np.asarray(values) - expected)), tolerance * scale)


def run_tests(words):
    """Runs the tests of a script with the command line PROGRAM [unittest options]."""
    PROGRAM.append(str(pathlib.Path(words.pop(1)).resolve()))
    unittest.main()
