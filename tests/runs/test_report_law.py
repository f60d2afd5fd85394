# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The friction law on the page of tools/report.py: its drawing, and the limit of friction in charts. Read in a real browser
(Chromium without a window).

Usage: test_report_law.py PROGRAM [unittest options]"""
import pathlib
import re
import shutil
import sys

import meshio
import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
from program import ROOT, main  # noqa: E402
from report_page import Page  # noqa: E402
from report_run import COARSE, SCRATCH, report, run  # noqa: E402

sys.path[:0] = [str(ROOT / "tools/rosettes"), str(ROOT / "tools/runs")]
from rosette_law import RosetteLaw, Table  # noqa: E402

OBLIQUE = [*COARSE, "Mesh/Core cells=4", "Friction/Orthotropy angle=30", "Load program/Cycles=1",
           "Load program/Legs=0.02 0.01 -0.05 : 3; -0.01 0 -0.05 : 3"]
CAPTION, NOTE = "Measured friction, per unit normal force", "The friction law is not drawn: its table is not where the run has found it."
OUTLINE = "return data.limits.map((size, k) => limitOutline()[k])"


class LawTest(Page):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        angles = np.radians(np.arange(0, 360, 10))
        cls.table = Table(angles, 0.25 * (1 + 0.4 * np.cos(angles - 0.5) + 0.2 * np.cos(3 * angles)), 0.06 * (1 + np.sin(2 * angles)))
        cls.path = pathlib.Path(SCRATCH.name) / "friction xy.txt"
        cls.path.write_text("".join(f"{angle} {along!r} {across!r}\n" for angle, along, across in
                                    zip(range(0, 360, 10), cls.table.along.tolist(), cls.table.across.tolist())), encoding="ascii")
        cls.law = ["Friction/Law=rosette", f"Friction/Rosette={cls.path}"]

    def page(self, folder):
        result = report(folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return (folder / "report.html").read_text(encoding="utf-8")

    def test_a_table_and_its_limit(self):
        """The drawing goes through the rows; charts have the limit of the law, which slipping nodes reach."""
        folder = run("table", *OBLIQUE, *self.law)
        text = self.page(folder)
        self.assertIn(CAPTION, text)
        self.assertIn("36 rows of friction xy.txt", text)
        self.assertNotIn(NOTE, text)
        self.assertEqual(text.count('class="row-of-table"'), 36)
        self.read(folder / "report.html")
        outline = np.array(self.script(OUTLINE))
        turn = np.radians(30)
        directions = np.arctan2(outline[:, 1], outline[:, 0]) - turn
        np.testing.assert_allclose(np.hypot(*outline.T), RosetteLaw(self.table).limit(directions), rtol=1e-6)
        file = meshio.read(folder / "contact-0006.vtu")
        slips = (file.point_data["status"] == 2) & (file.point_data["pressure"] > 0)
        pressure, friction = file.point_data["pressure"][slips], file.point_data["friction_traction"][slips]
        self.assertGreater(len(pressure), 5)
        limits = self.script("return arguments[0].map(([p, x, y]) => frictionLimit(data, p, x, y))",
                             np.column_stack([pressure, friction[:, :2]]).tolist())
        np.testing.assert_allclose(np.linalg.norm(friction, axis=1) / limits, 1, atol=2e-3)

    def test_ellipses_are_drawn_as_before(self):
        text = self.page(run("ellipses", *OBLIQUE))
        self.assertIn("Ellipses of friction and slip", text)
        self.assertNotIn(CAPTION, text)
        self.assertEqual(len(re.findall('class="slip-arrow head"', text)), 16)

    def test_axes_that_vary(self):
        """The law is drawn at the centre, and no chart has one limit for all places."""
        text = self.page(run("varies", *OBLIQUE, *self.law, "Friction/Orthotropy angle=10*x"))
        self.assertIn("; at the centre", text)
        self.assertIn('"limits":null', text)
        text = self.page(run("varies_too", *OBLIQUE, "Friction/Coefficients=0.3+0.001*x, 0.15"))
        self.assertIn("; at the centre", text)
        self.assertIn('"mu":null', text)

    def changed(self, name, folder, **entries):
        """A copy of a run folder with other entries of section Friction."""
        copy = shutil.copytree(folder, folder.parent / name)
        text = (copy / "parameters.prm").read_text(encoding="utf-8")
        head, friction, rest = re.split(r"(?<=\n)(subsection Friction\n.*?\nend\n)", text, maxsplit=1, flags=re.DOTALL)
        for entry, value in entries.items():
            line = f"  set {entry.replace('_', ' ')} = {value}"
            friction, found = re.subn(rf"  set {entry.replace('_', ' ')} *=.*", lambda _, line=line: line, friction)
            friction = friction if found else friction.replace("\nend\n", f"\n{line}\nend\n")
        (copy / "parameters.prm").write_text(head + friction + rest, encoding="utf-8")
        return copy

    def test_several_tables(self):
        """The one that holds, the mean of two, or a drawing of each where they vary."""
        rows = self.path.read_text(encoding="ascii")
        both = self.path.with_name("both.txt")
        both.write_text(f"table\n{rows}table\n" + "".join(f"{angle} 0.3 0\n" for angle in range(0, 360, 30)), encoding="ascii")
        folder = run("for_tables", *OBLIQUE, *self.law)
        text = self.page(self.changed("second", folder, Rosette=both, Rosette_weight=1))
        self.assertIn("12 rows of both.txt", text)
        self.assertEqual(text.count('class="row-of-table"'), 12)
        text = self.page(self.changed("mean", folder, Rosette=both, Rosette_weight=0.5))
        self.assertIn("mean of two tables of both.txt", text)
        self.assertNotIn('"limits":null', text)
        text = self.page(self.changed("chosen", folder, Rosette=both, Rosette_weight="if(x<0,0,1)"))
        self.assertIn("table 0 of 2 in both.txt", text)
        self.assertIn("table 1 of 2 in both.txt", text)
        self.assertIn("Rosette weight = if(x&lt;0,0,1) says which of its tables holds at a place", text)
        self.assertIn('"limits":null', text)
        self.assertIn(NOTE, self.page(self.changed("missing", folder, Rosette=both, Rosette_weight=2)))

    def test_superellipses(self):
        folder = run("for_formulas", *OBLIQUE)
        law = {"Law": "superellipse", "Coefficients": "0.3, 0.15", "Exponent": 4}
        text = self.page(self.changed("formula", folder, **law))
        self.assertIn("superellipse, exponents 4, 4", text)
        self.assertIn("associated; arrow at a force", text)
        self.assertIn("off the normal; arrow", self.page(self.changed("collinear", folder, **law, Slip_potential="collinear")))
        self.assertIn("The friction law is not drawn: its semi-axes vary", self.page(self.changed("formula_varies", folder, **{
            **law, "Coefficients": "0.3+0.01*x, 0.15"})))

    def test_a_factor_leaves_no_limit(self):
        folder = run("for_factors", *OBLIQUE, *self.law)
        text = self.page(self.changed("factor", folder, Factor="1+2*(1-exp(-s))"))
        self.assertIn("; for the factor 1", text)
        self.assertIn('"limits":null', text)

    def test_a_table_that_is_gone(self):
        folder = run("gone", *OBLIQUE, *self.law)
        kept = self.path.read_bytes()
        try:
            for change in (self.path.unlink, lambda: self.path.write_bytes(b"0 0.3 zero\n")):
                change()
                text = self.page(folder)
                self.assertNotIn(CAPTION, text)
                self.assertIn(NOTE, text)
        finally:
            self.path.write_bytes(kept)


if __name__ == "__main__":
    main()
