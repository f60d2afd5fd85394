# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Runs of half-spaces without a mesh: axes, threads, gaps that are open at the start, borders, wear, and resuming.

Usage: test_half_space.py PROGRAM [unittest options]"""
import json
import math
import os
import subprocess
import sys

import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
from program import PROGRAM, ROOT, RunTest, main  # noqa: E402

COARSE = ["Mesh/Cells=32, 32"]
LOOP = ["Load program/Legs=Fx 20 : 2 ; Fx -20 : 4 ; Fx 20 : 4", "Load program/Cycles=2", "Output/Contact fields=0",
        "Material/Poisson ratio=0.3"]


class HalfSpaceTest(RunTest):
    FILE = ROOT / "prm/verification/ball_on_plate.prm"

    def run_good(self, name, *settings, **options):
        result = self.run_program(name, settings=settings, **options)
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def columns(self, name, *names):
        return np.array([[float(row[column]) for column in names] for row in self.rows(name)])

    def warnings(self, name):
        return json.loads((self.folder / name / "summary.json").read_text())["warnings"]


class AxesTest(HalfSpaceTest):
    """Friction may be turned against the grid."""

    def pulled(self, name, direction, angle, *settings):
        force = 17.5 * np.array([math.cos(math.radians(direction)), math.sin(math.radians(direction))])
        self.run_good(name, *COARSE, f"Load program/Legs=Fx {force[0]:.12g} Fy {force[1]:.12g} : 3",
                      f"Friction/Orthotropy angle={angle}", "Material/Poisson ratio=0.3", *settings)
        return self.columns(name, "max_slip", "total_dissipation", "stick_area")

    def test_a_quarter_turn_changes_nothing(self):
        plain = self.pulled("plain", 30, 0)
        turned = self.pulled("turned", 120, 90)
        swapped = self.pulled("swapped", 30, 90, "Friction/Coefficients=0.15, 0.3")
        self.assertLess(np.abs(turned - plain).max(), 1e-7 * plain.max())
        self.assertLess(np.abs(swapped - plain).max(), 1e-7 * plain.max())

    def test_an_oblique_turn_differs_by_the_grid(self):
        plain, turned = self.pulled("plain", 0, 0), self.pulled("turned", 30, 30)
        self.assertLess(abs(turned[-1, 1] / plain[-1, 1] - 1), 0.02)
        self.assertLess(abs(turned[-1, 2] / plain[-1, 2] - 1), 0.02)


class ScenesTest(HalfSpaceTest):
    def test_results_do_not_depend_on_the_number_of_threads(self):
        for threads in (1, 2):
            self.run_good(f"by-{threads}", "Load program/Legs=Fx 10 : 1", "Material/Poisson ratio=0.3",
                          env={**os.environ, "OPENBLAS_NUM_THREADS": str(threads)})
        self.assert_same_files("by-1", "by-2", ["history.csv", "contact-0002.vtu"])

    def test_a_force_finds_the_contact_from_an_open_gap(self):
        self.run_good("closed", *COARSE)
        self.run_good("open", *COARSE, "Obstacle/Gap=0.25+(x^2+y^2)/(2*100)")
        closed, opened = (self.columns(name, "uz", "force_z", "stick_area") for name in ("closed", "open"))
        self.assertLess(np.abs(opened[:, 0] + 0.25 - closed[:, 0]).max(), 1e-10)
        self.assertLess(np.abs(opened[:, 1:] - closed[:, 1:]).max(), 1e-6)

    def test_a_contact_at_the_border_is_warned_of(self):
        self.run_good("inside", *COARSE)
        self.assertEqual([text for text in self.warnings("inside") if "border" in text], [])
        self.run_good("beyond", *COARSE, "Geometry/Sizes=0.8, 0.8")
        self.assertRegex(" ".join(self.warnings("beyond")), r"the contact reaches the border of Geometry/Sizes, with \d+ % of the "
                                                           "normal force on the outermost patches")

    def test_a_gap_that_is_not_periodic_is_warned_of(self):
        periodic = ["Geometry/Sizes=1, 1", "Geometry/Periodic=yes", "Mesh/Cells=16, 16", "Load program/Legs=Fz -10 : 1",
                    "Load program/Preload="]
        for gap, is_warned in (("0.001*(1-cos(2*pi*x))", False), ("(x^2+y^2)/200", False), ("0.001*(x+0.5)", True),
                               ("0.001*(1-cos(3*pi*y+1))", True)):
            with self.subTest(gap):
                result = self.run_program("run", "--check", settings=[*periodic, f"Obstacle/Gap={gap}"])
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertEqual("between opposite borders, which are one place" in result.stdout, is_warned)

    def test_equal_bodies_give_way_alike(self):
        """A half-space on one of the same material moves twice as far as on a rigid plate, without friction."""
        free = ["Friction/Coefficients=0, 0", "Load program/Preload=Fz -175 : 1", "Load program/Legs=Fz -200 : 1", *COARSE]
        self.run_good("both", *free)
        self.run_good("rigid", *free, "Obstacle/Kind=rigid", "Material/Young modulus=105000")
        both, rigid = (self.columns(name, "uz", "max_pressure") for name in ("both", "rigid"))
        self.assertLess(np.abs(both / rigid - 1).max(), 1e-8)

    def test_wear_follows_dissipation(self):
        self.run_good("worn", *COARSE, *LOOP, "Wear/Law=energy", "Wear/Coefficient=1e-4")
        last = self.rows("worn", "cycles.csv")[-1]
        self.assertAlmostEqual(float(last["worn_volume"]) / (1e-4 * float(last["total_dissipation"])), 1, places=6)

    def test_resumes_to_the_last_bit(self):
        self.run_good("whole", *COARSE, *LOOP, "Output/Checkpoint=0")
        command = self.command("stopped", settings=[*COARSE, *LOOP, "Output/Checkpoint=0"])
        run = subprocess.Popen(command, cwd=self.folder, stderr=subprocess.PIPE)
        while run.poll() is None and len(self.started("stopped")) < 5:
            pass
        run.kill()
        run.communicate()
        result = self.run_program("stopped", "--resume", settings=[*COARSE, *LOOP, "Output/Checkpoint=0"])
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assert_same_files("whole", "stopped", ["history.csv", "cycles.csv"])

    def started(self, name):
        try:
            return (self.folder / name / "history.csv").read_text(encoding="ascii").splitlines()
        except OSError:
            return []

    def test_is_suggested_where_the_body_is_large(self):
        check = [PROGRAM, "--check", str(ROOT / "prm/verification/elliptic_hertz.prm")]
        text = subprocess.run(check, text=True, capture_output=True, check=True).stdout
        self.assertIn("simpler model  Geometry/Shape = half-space with Sizes = 3.5, 1.4 and Mesh/Cells = 64, 64", text)
        for other in ("paper/case_b", "verification/ball_on_plate", "verification/hertz"):
            check[2] = str(ROOT / f"prm/{other}.prm")
            self.assertNotIn("simpler model", subprocess.run(check, text=True, capture_output=True, check=True).stdout)


if __name__ == "__main__":
    main()
