# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The distribution of pressure and the damping curves on the page of tools/report.py. Read in a real browser (Chromium without
a window).

Usage: test_report_roughness.py PROGRAM [unittest options]"""
import math
import pathlib
import sys
import unittest

import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
from program import ROOT, main  # noqa: E402
from report_page import Page, column, table  # noqa: E402
from report_run import SCRATCH, report, run  # noqa: E402

sys.path.insert(0, str(ROOT / "tools/report"))
from distribution import distribution, node_areas  # noqa: E402

BALL = ROOT / "prm/verification/ball_on_plate.prm"
ENERGY, STIFFNESS = "Damping: energy of a cycle over its amplitude", "Tangential stiffness over the amplitude"


def growing(folder, forces):
    """A program file with a cycle of each force."""
    rows = ["cycle,Fz [N],Fx [N]", "0,-175,0"]
    rows += [f"{cycle},-175,{share * force:g}" for cycle, force in enumerate(forces, 1) for share in (0.5, 1, 0, -1, 0)]
    path = folder / "growing.csv"
    path.write_text("\n".join(rows) + "\n")
    return path


class DistributionTest(unittest.TestCase):
    def test_a_quadrilateral_is_shared_by_its_corners(self):
        places = np.array([[0., 0], [2, 0], [2, 1], [0, 1], [5, 0], [5, 1]])
        np.testing.assert_allclose(node_areas(places, np.array([[0, 1, 2, 3], [1, 4, 5, 2]])), [0.5, 1.25, 1.25, 0.5, 0.75, 0.75])

    def test_classes_have_their_part_of_the_area_in_contact(self):
        areas = np.array([1., 1, 2, 4])
        frame = {"pressure": np.array([0., 0.1, 99, 100]), "touches": np.array([False, True, True, True])}
        found = distribution([frame, {**frame, "pressure": 0 * areas, "touches": areas < 0}], areas)
        self.assertEqual((found["top"], found["shares"][0][0]), (100, 14.29))
        self.assertAlmostEqual(found["shares"][0][-1], 600 / 7, delta=0.01)
        self.assertEqual(sum(found["shares"][1]), 0)


class RoughnessTest(Page):
    def open(self, *folders):
        result = report(*folders)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.read(folders[0] / "report.html")

    def titles(self):
        return self.script("return [...document.querySelectorAll('figcaption')].map(one => one.firstChild.textContent)")

    def ball(self, name, *settings):
        return run(name, "Mesh/Cells=24, 24", *settings, file=BALL)

    def test_pressure_of_hertz(self):
        """The area of a ball under less than p is 1 - (p / p0)^2 of all, so that classes grow in proportion to p."""
        folder = self.ball("hertz", "Mesh/Cells=96, 96", "Load program/Preload=", "Load program/Legs=Fz -175 : 1", "Output/Contact fields=1")
        self.open(folder)
        saved = self.saved_table(self.menu("Area in contact over its pressure, step 1"))
        shares = column(saved, "share (%)")
        self.assertAlmostEqual(sum(shares), 100, delta=0.05)
        halves = sum(shares[:20]), sum(shares[20:])
        self.assertAlmostEqual(halves[0], 25, delta=2)
        self.assertAlmostEqual(halves[1], 75, delta=2)

    def test_cycles_that_grow_have_a_damping_curve(self):
        """Cattaneo's loops: secant stiffness falls, and energy grows with a power of the amplitude near three."""
        forces = (10, 20, 40)
        folder = self.ball("growing", "Friction/Coefficients=0.3, 0.3", f"Load program/Program file={growing(pathlib.Path(SCRATCH.name), forces)}",
                           "Load program/Preload=", "Load program/Steps per row=4", "Output/Contact fields=0")
        self.open(folder)
        rows = table(folder, "cycles.csv")
        energy, stiffness = self.saved_table(self.menu(ENERGY)), self.saved_table(self.menu(STIFFNESS))
        for k, row in enumerate(rows):
            self.assertAlmostEqual(column(stiffness, "secant Q*/δ* (N/mm)")[k],
                                   2 * float(row["tangential_force"]) / float(row["stroke"]), delta=1)
            self.assertAlmostEqual(column(energy, "dissipated by friction (N mm)")[k] / float(row["dissipation"]), 1, delta=1e-4)
        power = math.log(float(rows[1]["dissipation"]) / float(rows[0]["dissipation"])) / math.log(forces[1] / forces[0])
        self.assertTrue(2.5 < power < 4, power)

    def test_runs_of_several_amplitudes_have_one(self):
        folders = [self.ball(f"loop {force}", "Friction/Coefficients=0.3, 0.3", "Output/Contact fields=0",
                             f"Load program/Legs=Fx {force} : 2 ; Fx -{force} : 4 ; Fx {force} : 4") for force in (10, 20, 30)]
        self.open(*folders)
        self.assertIn(ENERGY, self.titles())
        self.open(folders[0])
        self.assertNotIn(ENERGY, self.titles())


def tearDownModule():
    SCRATCH.cleanup()


if __name__ == "__main__":
    main()
