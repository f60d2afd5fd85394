# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What the page of tools/report.py shows of surfaces that wear. Read in a real browser (Chromium without a window).

Usage: test_report_wear.py PROGRAM [unittest options]"""
import re
import sys
import unittest

import meshio
import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
from program import ROOT, main  # noqa: E402
from report_page import Page, column, table  # noqa: E402
from report_run import COARSE, SCRATCH, report, run  # noqa: E402

sys.path[:0] = [str(ROOT / "tools/runs"), str(ROOT / "tools/report")]
from worn import within  # noqa: E402

WEARING = [*COARSE, "Mesh/Core cells=4", "Wear/Law=archard", "Wear/Coefficient=1e-6"]
PRESSED = [*WEARING, "Mesh/Rings=6", "Friction/Coefficients=0.2, 0.2", "Friction/Slip potential=0.2, 0.2",
           "Load program/Legs=0 0 -0.1 : 3 ; 0 0 0 : 3", "Load program/Cycles=7"]
FRETTED = [*WEARING, "Friction/Orthotropy angle=20", "Load program/Preload=0 0 -0.05 : 2", "Load program/Cycles=40",
           "Load program/Legs=0.02 0.01 -0.05 : 2; -0.02 0 -0.05 : 4; 0 0 -0.05 : 2", "Wear/Largest depth of a jump=1e-4"]


class WithinTest(unittest.TestCase):
    def test_lines_reach_beyond_what_is_worn(self):
        place = np.arange(20.)
        for worn, rows in (([5], [4, 5, 6]), ([0, 1], [0, 1, 2]), ([19], [18, 19]), ([3, 13], range(2, 15)), ([], [])):
            depth = np.zeros((2, 20))
            depth[1, worn] = 1
            self.assertEqual(within(place, depth).tolist(), list(rows))


class WearTest(Page):
    def open(self, folder):
        result = report(folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.read(folder / "report.html")
        self.assert_sections()
        return table(folder, "cycles.csv")

    def profile(self, along):
        """Places, {name: depths}; the last name is that of the last step."""
        saved = self.saved_table(self.menu(f"Worn depth along {along}"))
        place, *names = saved[0]
        return column(saved, place), {name: column(saved, name) for name in names}

    def test_profile_holds_the_worn_volume(self):
        """Around the axis of a section: V = 2 pi int r h dr, from all steps on show, which wear the same each."""
        folder = run("pressed", *PRESSED)
        cycles = self.open(folder)
        volume = {row["cycle"]: float(row["worn_volume"]) for row in cycles}
        for along in "xy":
            r, depths = self.profile(along)
            self.assertGreaterEqual(len(depths), 5)
            for name, depth in depths.items():
                cycle = re.match(r"cycle (\d+) \(mm\)", name)
                rings = np.pi * np.sum((depth[1:] * np.abs(r[1:]) + depth[:-1] * np.abs(r[:-1])) / 2 * np.diff(r))
                if cycle:  # both sides of the axis are on the line
                    self.assertAlmostEqual(rings / volume[cycle[1]], 1, delta=0.03)
            lasting = [depth.max() for depth in depths.values()]
            self.assertEqual(lasting, sorted(lasting))
        self.assertRegex(list(depths)[-1], r"^cycle 7 \(mm\)$")

    def test_profiles_are_the_field(self):
        """Motions and friction without symmetry: nothing could hide a line that is turned or mirrored."""
        folder = run("fretted", *FRETTED)
        cycles = self.open(folder)
        self.assertGreater(max(int(row["n_cycles"]) for row in cycles), 1)
        saved = self.saved_table(self.menu("Worn volume"))
        np.testing.assert_allclose(column(saved, "worn volume (mm³)"), column(cycles, "worn_volume"), rtol=1e-6)
        saved = self.saved_table(self.menu("Largest worn depth"))
        np.testing.assert_allclose(column(saved, "largest depth (mm)"), column(cycles, "max_wear_depth"), rtol=1e-6)
        saved = self.saved_table(self.menu("Error of the worn volume"))
        np.testing.assert_allclose(column(saved, "error (mm³)"), column(cycles, "wear_error"), rtol=1e-6)
        file = meshio.read(sorted(folder.glob("contact-*.vtu"))[-1])
        x, y = file.points[:, :2].T
        for along, axis in (("x", 0), ("y", 1)):
            across = float(re.search(r"= (\S+) mm", self.chart(f"Worn depth along {along}").text)[1].replace("\u2212", "-"))
            self.assertLess(abs(across), 1)
            place, depths = self.profile(along)
            last = list(depths.values())[-1]
            on = np.flatnonzero(np.abs(file.points[:, 1 - axis] - across) < 1e-5)
            for node in on[(place[0] < file.points[on, axis]) & (file.points[on, axis] < place[-1])]:
                self.assertAlmostEqual(np.interp(file.points[node, axis], place, last),
                                       file.point_data["wear_depth"][node], delta=1e-4 * last.max())
            self.assertGreater(last.max(), 0.3 * file.point_data["wear_depth"].max())
        self.assertTrue(np.hypot(x, y).max() > np.abs(place).max() > 1)

    def test_nothing_of_runs_that_do_not_wear(self):
        for name, sections, settings in (("unworn", 0, [*COARSE, "Load program/Cycles=1"]),
                                         ("no_fields", 1, [*PRESSED, "Load program/Cycles=2", "Output/Contact fields=0"])):
            with self.subTest(name):
                self.open(run(name, *settings))
                self.assertEqual(self.script("return document.querySelectorAll('#wear, a[href=\"#wear\"]').length"),
                                 2 * sections)
                self.assertEqual(self.script("return document.querySelectorAll('#wear-profiles figure').length"), 0)
                if sections:
                    self.assertTrue(self.find("#no-profiles").is_displayed())
                    self.assertTrue(self.chart("Worn volume").is_displayed())


def tearDownModule():
    SCRATCH.cleanup()


if __name__ == "__main__":
    main()
