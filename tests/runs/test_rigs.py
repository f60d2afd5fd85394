# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The rigs of prm/rigs run, agree with theory where there is one, and can be copied.

Usage: test_rigs.py PROGRAM [unittest options]"""
import math
import subprocess
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
import program  # noqa: E402
from program import PROGRAM, ROOT  # noqa: E402

sys.path.insert(0, str(ROOT / "tools/runs"))
import run_folder  # noqa: E402

FOLDER = ROOT / "prm/rigs"
DONE, WRONG_INPUT, FILE_ERROR = 0, 2, 4
STEEL = 210000 / (1 - 0.3**2)  # E*, MPa, of steel on what is rigid; half of it on steel


class RigTest(program.RunTest):
    def done(self, name, *settings):
        """Rows of the history, and those behind the preload."""
        result = self.run_program("run", settings=["Output/Contact fields=0", *settings], file=FOLDER / f"{name}.prm")
        self.assertEqual(result.returncode, DONE, result.stderr)
        rows = [{key: float(value) for key, value in row.items() if key not in ("method", "driven")} for row in self.rows("run")]
        return rows, [row for row in rows if row["cycle"]]

    def assert_near(self, value, expected, share):
        self.assertAlmostEqual(value / expected, 1, delta=share)

    def assert_turns(self, rows, force, n_loading):
        """The program ends where it turned first, with the force that it had: so partial slip has it (Masing)."""
        self.assert_near(rows[-1][force], rows[n_loading - 1][force], 0.12)
        self.assert_near(rows[-1][force], -rows[-1 - 2 * n_loading][force], 0.12)

    def test_sphere_on_flat(self):
        rows, cycle = self.done("sphere_on_flat")
        force, shear, mu, radius = 250, 90, 0.5, 100
        a = (3 * force * radius / (4 * STEEL / 2)) ** (1 / 3)
        self.assert_near(rows[2]["max_pressure"], 3 * force / (2 * math.pi * a**2), 0.02)
        self.assert_near(math.sqrt(rows[2]["contact_area"] / math.pi), a, 0.06)  # half a cell
        stick = (1 - shear / (mu * force)) ** (1 / 3)
        self.assert_near(math.sqrt(cycle[5]["stick_area"] / cycle[5]["contact_area"]), stick, 0.06)
        self.assert_turns(cycle, "ux", 6)

    def test_cylinder_on_flat(self):
        rows, cycle = self.done("cylinder_on_flat")
        force, shear, mu, radius, thickness = 900, 350, 0.6, 50, 4
        a = math.sqrt(4 * force / thickness * radius / (math.pi * STEEL / 2))
        self.assert_near(rows[1]["max_pressure"], 2 * force / thickness / (math.pi * a), 0.005)
        cell = 0.036  # two of its nodes: the contact ends within
        self.assertAlmostEqual(rows[1]["contact_area"] / (2 * thickness), a, delta=cell)
        self.assertAlmostEqual(cycle[5]["stick_area"] / (2 * thickness), a * math.sqrt(1 - shear / (mu * force)), delta=cell)
        self.assert_turns(cycle, "ux", 6)

    def test_torsion(self):
        force, mu, radius = 400, 0.3, 100
        a = (3 * force * radius / (4 * STEEL)) ** (1 / 3)
        hertz = 3 * force / (2 * math.pi * a**2)
        rows, _ = self.done("torsion", "Friction/Coefficients=0, 0", "Load program/Legs=Fz -400 : 1")
        self.assert_near(rows[1]["max_pressure"], hertz, 0.005)
        rows, cycle = self.done("torsion")
        self.assert_near(rows[1]["max_pressure"], 1.08 * hertz, 0.005)  # what docs/rigs.md says of friction on a rigid sphere
        self.assertLess(cycle[5]["held_moment_z"], 3 * math.pi / 16 * mu * force * a)  # where all would slip
        self.assertGreater(cycle[5]["n_stick"], 0)
        self.assert_turns(cycle, "held_moment_z", 6)

    def test_brushed_plate(self):
        """Sliding along x, free along y: friction along -x, as long as the ellipse is there."""
        _, cycle = self.done("brushed_plate")
        along, across = math.cos(math.radians(30)) / 0.15, math.sin(math.radians(30)) / 0.3
        self.assert_near(cycle[9]["held_force_x"], 20000 / math.hypot(along, across), 1e-4)
        self.assertGreater(cycle[9]["uy"], 1e-3)
        self.assertLess(abs(cycle[9]["held_force_y"]), 2)

    def test_fretting_fatigue(self):
        """In phase with the shear, the bulk stress moves the stick zone away from the edge that both pull (Nowell and Hills)."""
        rows, cycle = self.done("fretting_fatigue", "Output/Contact fields=1")
        force, shear, mu, radius, thickness, bulk = 543, 155, 0.85, 50, 4, 100
        a = math.sqrt(4 * force / thickness * radius / (math.pi * STEEL / 2))
        p0 = 2 * force / thickness / (math.pi * a)
        self.assert_near(rows[1]["max_pressure"], p0, 0.005)
        stick, shift = a * math.sqrt(1 - shear / (mu * force)), bulk * a / (4 * mu * p0)
        contact = run_folder.RunFolder(self.folder / "run").contact(8)  # the first peak, behind two steps of the preload
        x, nodal = contact.points[:, 0].astype(float), contact["nodal_force"].astype(float)
        weights = mu * nodal[:, 2] + nodal[:, 0]  # what friction leaves of its limit: an ellipse where it sticks
        middle = float(weights @ x / sum(weights))
        self.assertAlmostEqual(middle, shift, delta=0.0015)  # a tenth of a node's spacing
        self.assert_near(2 * math.sqrt(weights @ (x - middle)**2 / sum(weights)), stick, 0.01)
        self.assertEqual(cycle[5]["bulk"], bulk)
        self.assert_turns(cycle, "ux", 6)

    def test_balance_of_the_others(self):
        for name, force, mu, n_loading in (("crossed_cylinders", 200, 0.4, 6), ("rounded_punch", 600, 0.4, 6),
                                           ("flat_on_flat", 4000, 0.3, 5)):
            with self.subTest(rig=name):
                rows, cycle = self.done(name)
                self.assert_near(rows[-1]["force_z"], force, 1e-9)
                self.assertLess(abs(cycle[n_loading - 1]["held_force_x"]), mu * force)
                self.assertGreater(cycle[n_loading - 1]["n_stick"], 0)
                self.assertGreater(cycle[n_loading - 1]["n_slip"], 0)
                self.assert_turns(cycle, "ux" if name == "rounded_punch" else "held_force_x", n_loading)

    def new(self, *words):
        return subprocess.run([PROGRAM, *words], cwd=self.folder, text=True, capture_output=True, timeout=60, check=False)

    def test_new_file(self):
        rig = (FOLDER / "torsion.prm").read_bytes()
        self.assertEqual(self.new("--new", "torsion", "my.prm").returncode, DONE)
        self.assertEqual((self.folder / "my.prm").read_bytes(), rig)
        for words, code, message in (
                (("torsion", "my.prm"), WRONG_INPUT, "my.prm exists: allowed is the name of a new file"),
                (("torsoin", "other.prm"), WRONG_INPUT, "; is torsion meant?"),
                (("../torsion", "other.prm"), WRONG_INPUT, "allowed are brushed_plate, "),
                (("torsion",), WRONG_INPUT, "allowed is the name of a new file that ends in .prm"),
                (("torsion", "other.txt"), WRONG_INPUT, "allowed is the name of a new file that ends in .prm"),
                (("torsion", "nowhere/other.prm"), FILE_ERROR, "nowhere/other.prm: cannot be written (No such file")):
            with self.subTest(words=words):
                result = self.new("--new", *words)
                self.assertEqual((result.returncode, result.stderr.count("\n")), (code, 1))
                self.assertIn(message, result.stderr)
        self.assertEqual([file.name for file in self.folder.iterdir()], ["my.prm"])

    def test_page_and_list_name_every_rig(self):
        page, listed = (ROOT / "docs/rigs.md").read_text(encoding="utf-8"), self.new("--list").stdout
        for file in FOLDER.glob("*.prm"):
            self.assertIn(f"| `{file.stem}` |", page)
            self.assertIn(file.name, listed)


if __name__ == "__main__":
    program.main()
