# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The files of prm/verification give the known answers of their head comments.

Usage: test_verification.py PROGRAM [unittest options]"""
import math
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
import program  # noqa: E402
from program import ROOT  # noqa: E402


def angle_against_motion(row):
    return math.degrees(math.atan2(-row["force_y"], -row["force_x"]))


class VerificationTest(program.RunTest):
    def verified(self, name, *settings):
        """Numbers of the last step."""
        result = self.run_program("run", settings=settings, file=ROOT / f"prm/verification/{name}.prm")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return {key: float(value) for key, value in self.rows("run")[-1].items() if key not in ("method", "driven")}

    def test_patch_test(self):
        row = self.verified("patch_test")
        for pressure in (row["min_pressure"], row["max_pressure"]):
            self.assertAlmostEqual(pressure / 2100, 1, delta=1e-6)
        self.assertAlmostEqual(row["max_slip"] / 0.03, 1, delta=1e-6)
        self.assertAlmostEqual(row["force_z"] / (2100 * math.pi * 100), 1, delta=1e-3)  # the rim is a parabola a cell

    def test_gross_sliding(self):
        for slip_ellipse, ratio, angle in (("0.8, 0.4", 0.73756, 14.04), ("1, 1", 0.50596, 45)):
            row = self.verified("gross_sliding", f"Friction/Slip potential={slip_ellipse}")
            force = math.hypot(row["force_x"], row["force_y"])
            self.assertAlmostEqual(force / row["force_z"], ratio, delta=5e-6)
            self.assertAlmostEqual(angle_against_motion(row), angle, delta=5e-3)
            self.assertEqual(row["n_stick"], 0)  # some nodes at the trailing rim are lifted, the others slip

    def test_gross_sliding_under_a_given_normal_force(self):
        for method in ("newton", "gauss-seidel"):
            row = self.verified("gross_sliding_by_force", f"Contact solver/Method={method}")
            self.assertAlmostEqual(row["force_z"], 1e4, delta=1e-4)
            self.assertAlmostEqual(math.hypot(row["force_x"], row["force_y"]), 7375.6, delta=0.05)
            self.assertAlmostEqual(angle_against_motion(row), 14.04, delta=5e-3)
            self.assertEqual(row["n_stick"], 0)

    def test_torsion(self):
        n, a = 32, 2 * math.pi / 32
        polygon = n * 1e4 * math.sin(a) * (2 + math.cos(a)) / 12
        for degree, polar_moment in ((1, polygon), (3, math.pi / 2 * 1e4)):
            row = self.verified("torsion", f"Mesh/Degree={degree}")
            moment = -105000 * polar_moment * math.radians(0.5) / 10
            self.assertAlmostEqual(row["moment_z"] / moment, 1, delta=1e-8)
            self.assertEqual(row["n_slip"] + row["n_open"], 0)

    def test_box(self):
        for model in ("auto", "full", "quarter"):
            settings = [f"Mesh/Model={model}"] if model != "full" else []
            row = self.verified("box", *settings)
            for pressure in (row["min_pressure"], row["max_pressure"]):
                self.assertAlmostEqual(pressure / 1000, 1, delta=1e-9)
            self.assertAlmostEqual(row["force_z"] / 240000, 1, delta=1e-9)
            self.assertAlmostEqual(row["uz"] / (-8 / 210), 1, delta=1e-9)
            self.assertAlmostEqual(row["max_slip"] / (0.3 / 210 * math.hypot(10, 6)), 1, delta=1e-9)

    def test_a_load_that_nothing_carries_ends_the_run(self):
        file = ROOT / "prm/verification/gross_sliding_by_force.prm"
        legs = "Load program/Legs=Fz -1e4 : 1 ; Fx 1.5e4 : 4"  # friction carries 0.8 Fz along x
        result = self.run_program("run", settings=[legs], file=file)
        self.assertEqual(result.returncode, 3)
        self.assertRegex(result.stderr, r"load step 4 of 5 \(Fx = 11250 N, Fz = -10000 N\) has no equilibrium: ")
        carried = float(result.stderr.split("The first ")[1].split(" %")[0])
        self.assertAlmostEqual(carried, 100 * 8 / 15, delta=1.5)
        self.assertEqual(len(self.rows("run")), 3)
        self.assertIn("no equilibrium", (self.folder / "run/summary.json").read_text(encoding="utf-8"))

    def test_a_run_by_forces_goes_on_as_if_it_had_not_stopped(self):
        file = ROOT / "prm/verification/gross_sliding_by_force.prm"
        legs = "Load program/Legs=uz -0.002 : 1 ; Fz -1e4 Mz 1e3 : 4 ; Fx 6e3 : 4 ; uz -0.002 : 2"
        settings = [legs, "Output/Checkpoint=0"]
        self.assertEqual(self.run_program("whole", settings=settings, file=file).returncode, 0)
        cut = [*settings, "Contact solver/Tolerance=1e-10", "Contact solver/Maximum iterations=1"]
        self.assertEqual(self.run_program("run", settings=cut, file=file).returncode, 3)
        result = self.run_program("run", "--resume", settings=settings, file=file)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assert_same_files("whole", "run", ["history.csv", "checks.csv", "cycles.csv"])


if __name__ == "__main__":
    program.main()
