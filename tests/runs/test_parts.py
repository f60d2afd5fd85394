# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The parts of prm/parts: balance of forces, closed forms, symmetry.

Usage: test_parts.py PROGRAM [unittest options]"""
import json
import math
import sys

import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
import program  # noqa: E402
from program import ROOT  # noqa: E402

FOLDER = ROOT / "prm/parts"
DONE = 0


class PartTest(program.RunTest):
    def done(self, name, *settings):
        """Rows of the history, of a run that warns of nothing."""
        result = self.run_program(name, settings=settings, file=FOLDER / f"{name}.prm")
        self.assertEqual((result.returncode, result.stderr), (DONE, ""))
        self.assertEqual(self.summary(name)["warnings"], [])
        return [{key: float(value) for key, value in row.items() if key not in ("method", "driven")}
                for row in self.rows(name)]

    def summary(self, name):
        return json.loads((self.folder / name / "summary.json").read_text(encoding="utf-8"))

    def assert_near(self, value, expected, share):
        self.assertAlmostEqual(value / expected, 1, delta=share)

    def test_dovetail(self):
        """Both flanks alike; where all slips, the pull is 2 N (cos 45 + mu sin 45) of the normal force N of a flank."""
        rows = self.done("dovetail")
        for row in rows:
            self.assert_near(-row["force_z"], row["held_force_z"], 1e-7)
            for key in ("normal_force", "force_z", "max_pressure", "total_dissipation"):
                self.assert_near(row[f"left_{key}"], row[f"right_{key}"], 1e-4)
        top = rows[3]
        self.assertEqual(top["n_stick"], 0)
        # The normals along which the bodies meet are those of the flanks.
        self.assert_near(top["held_force_z"], 2 * top["right_normal_force"] * (1 + 0.4) / math.sqrt(2), 1e-6)
        self.assert_near(rows[-1]["total_dissipation"] - rows[19]["total_dissipation"], 0.0374, 0.05)  # of docs/parts.md

    def test_shaft_in_hub(self):
        """Lame's pressure, the moment of sliding, and the energy that it dissipates at the slip."""
        rows = self.done("shaft_in_hub")
        radius, core, rim, mu, nu = 10, 3, 15, 0.15, 0.3
        flexibility = (1 + nu) * radius / 210000
        hub = ((1 - 2 * nu) + (rim / radius)**2) / ((rim / radius)**2 - 1)
        shaft = (1 - 2 * nu) * (1 - (core / radius)**2) / (1 + (1 - 2 * nu) * (core / radius)**2)
        lame = 0.01 / (flexibility * (hub + shaft))
        self.assert_near(lame, 65.3644, 1e-6)
        self.assert_near(rows[1]["min_pressure"], lame, 1e-3)
        self.assert_near(rows[1]["max_pressure"], lame, 5e-3)  # at the keys
        slides = 2 * math.pi * mu * lame * radius**2
        self.assert_near(rows[9]["held_moment_y"], slides, 2e-3)
        self.assertEqual(rows[9]["n_stick"], 0)
        self.assert_near(rows[25]["held_moment_y"], -rows[9]["held_moment_y"], 1e-6)
        slip = rows[9]["max_slip"]
        self.assert_near(rows[41]["total_dissipation"] - rows[9]["total_dissipation"],
                         4 * rows[9]["held_moment_y"] * slip / radius, 0.01)

    def test_bent_shaft(self):
        """A side force to either side has the mirror image of the other; slip at the end of the seat dissipates energy."""
        rows = self.done("bent_shaft", "Load program/Preload=fit 1 : 1 ; Fx 4000 Fz 0 My 0 : 3",
                         "Load program/Legs=Fx -4000 : 5 ; Fx 4000 : 5")
        for row in rows[1:]:
            self.assertAlmostEqual(row["force_x"] + row["held_force_x"], 0, delta=1e-5)
        turned, back = rows[-6], rows[-1]  # the ends of the last half cycles
        np.testing.assert_allclose((turned["held_force_x"], back["held_force_x"]), (-4000, 4000), rtol=1e-9)
        self.assert_near(turned["ux"], -back["ux"], 0.01)
        self.assert_near(turned["max_pressure"], back["max_pressure"], 0.01)
        energy = back["total_dissipation"] - rows[-11]["total_dissipation"]
        self.assertGreater(energy, 0)
        self.assertGreater(back["n_stick"], back["n_slip"])

    def test_pin_in_lug(self):
        """Hertz' line contact at small pulls; the contact of the whole lug balances the pull."""
        light = self.done("pin_in_lug", "Friction/Coefficients=0, 0", "Load program/Preload=", "Load program/Cycles=1",
                          "Load program/Legs=Fz 25 : 1 ; Fz 100 : 1", "Mesh/Refinements=1", "Lower mesh/Refinements=1")
        for row, share in zip(light, (0.012, 0.05)):
            half_width = math.sqrt(4 * row["held_force_z"] * 10 * 9.95 / 0.05 / (math.pi * 210000 / (2 * (1 - 0.3**2))))
            self.assert_near(row["max_pressure"], 2 * row["held_force_z"] / (math.pi * half_width), share)
            self.assert_near(row["contact_area"], 2 * half_width, 0.06)
        rows = self.done("pin_in_lug", "Load program/Cycles=1")
        self.assert_near(-rows[9]["force_z"], 4000, 1e-7)
        self.assert_near(rows[9]["max_pressure"], rows[-1]["max_pressure"], 1e-3)
        self.assertGreater(rows[-1]["total_dissipation"], rows[9]["total_dissipation"])
        self.assertGreater(rows[9]["contact_area"] / (2 * 10), math.radians(60))

    def test_ball_in_socket(self):
        """Hertz at a small force, and more than Hertz at a large one, on a contact that is smaller."""
        rows = self.done("ball_in_socket", "Friction/Coefficients=0, 0", "Load program/Preload=", "Load program/Cycles=1",
                         "Load program/Legs=Fz -250 : 1 ; Fz -5000 : 1")
        stiffness = 1 / ((1 - 0.3**2) / 210000 + (1 - 0.34**2) / 100000)
        shares = []
        for row in rows:
            self.assert_near(row["force_z"], -row["held_force_z"], 1e-7)
            a = (3 * row["force_z"] * 10 * 10.1 / 0.1 / (4 * stiffness)) ** (1 / 3)
            disc = math.pi * a**2
            shares.append((row["max_pressure"] / (1.5 * row["force_z"] / disc), row["contact_area"] / disc))
        np.testing.assert_allclose(shares[0], 1, atol=0.06)
        self.assertGreater(shares[1][0], 1.05)
        self.assertLess(shares[1][1], 0.95)

    def test_page_and_list_name_every_part(self):
        page = (ROOT / "docs/parts.md").read_text(encoding="utf-8")
        for file in FOLDER.glob("*.prm"):
            self.assertIn(f"| `{file.stem}` |", page)
            result = self.run_program("none", "--check", file=file)
            self.assertEqual((result.returncode, result.stderr), (DONE, ""))
            self.assertNotIn("warning", result.stdout)


if __name__ == "__main__":
    program.main()
