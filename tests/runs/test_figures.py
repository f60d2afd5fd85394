# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The paper's figures and tables from small runs: every file appears and shows something, every number of the table
is that of the run folder, and a program that fails stops the tool.

Usage: test_figures.py PROGRAM [unittest options]"""
import csv
import math
import os
import pathlib
import re
import shutil
import sys
import tempfile
import unittest

import meshio

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tools/studies"))
import paths  # noqa: E402, F401 (finds the modules of all studies)

import docs_page  # noqa: E402
import paper_figures  # noqa: E402
import paper_tables  # noqa: E402
from matplotlib.image import imread  # noqa: E402
from paper_runs import ProgramError, Runs  # noqa: E402

PROGRAM = ""
SMALL = ("Mesh/Core cells=2", "Mesh/Rings=2", "Mesh/Layers=2")
FIGURES = [*(f"fig{number:02d}" for number in range(5, 13)), "cases"]
MESHES = ("bricks", "fitted", "q2", "refined")  # columns of the table behind the printed numbers


def rows_of(path):
    with open(path, encoding="ascii") as file:
        return list(csv.DictReader(file))


class FiguresTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.folder = pathlib.Path(scratch.name)
        cls.runs = Runs(PROGRAM, cls.folder / "runs", last=SMALL)

    def test_every_figure_appears_and_shows_something(self):
        images = self.folder / "images"
        images.mkdir()
        docs_page.draw("figures", paper_figures.FIGURES, self.runs, self.folder / "figures", images)
        self.assertEqual(sorted(file.stem for file in images.iterdir()), sorted(FIGURES))
        for name in FIGURES:
            with self.subTest(name):
                self.assertLess((images / f"{name}.png").stat().st_size, 150e3)
                picture = imread(self.folder / f"figures/{name}.png")[::5, ::5, :3]
                self.assertGreater(min(picture.shape[:2]), 100)
                background = (picture == 1).all(axis=2).mean()
                self.assertTrue(0.2 < background < 0.98, background)

    def test_numbers_of_the_table_are_those_of_the_runs(self):
        lines = [line.strip("| ").split(" | ") for line in paper_tables.comparison(self.runs).splitlines()[2:]]
        table = {(line[0], line[1]): line[2:] for line in lines}
        self.assertEqual(table["B", "largest slip (mm)"][0], "0.02044")
        for case in "abc":
            for column, mesh in enumerate(MESHES, start=1):
                run = self.folder / f"runs/{case}-{mesh}"
                contact = meshio.read(run / "contact-0005.vtu").point_data
                force = contact["nodal_force"][:, 2]
                slip = float(rows_of(run / "history.csv")[4]["max_slip"])
                self.assertAlmostEqual(slip, contact["slip_magnitude"].max(), delta=1e-9)
                expected = {"largest slip (mm)": f"{slip:.5f}", "smallest nodal force (N)": f"{force.min():.0f}",
                            "largest nodal force (N)": f"{force.max():.0f}"}
                for quantity, value in expected.items():
                    with self.subTest(case=case, mesh=mesh, quantity=quantity):
                        self.assertEqual(table[case.upper(), quantity][column], value)
        self.check_probe(table)

    def check_probe(self, table):
        for column, mesh in enumerate(MESHES, start=1):
            probe = rows_of(self.folder / f"runs/b-{mesh}/probe-P.csv")[:15]
            slip = math.hypot(float(probe[4]["slip_x"]), float(probe[4]["slip_y"]))
            self.assertEqual(table["B", "slip at P, peak (mm)"][column], f"{slip:.5f}")
            force = [float(row["force_x"]) for row in probe]
            self.assertEqual(table["B", "r_x at P (N)"][column], f"{min(force):.0f} to {max(force):.0f}")

    def write_tables(self, page):
        docs_page.write_tables({name: make(self.runs) for name, make in paper_tables.TABLES.items()}, page, "figures")

    def test_tables_replace_only_what_is_between_their_markers(self):
        page = self.folder / "paper.md"
        shutil.copy(ROOT / "docs/paper.md", page)
        self.write_tables(page)
        first = page.read_text(encoding="utf-8")
        self.write_tables(page)
        self.assertEqual(page.read_text(encoding="utf-8"), first)
        before = (ROOT / "docs/paper.md").read_text(encoding="utf-8")
        prose = [re.sub(r"(<!-- table .*?-->).*?(<!-- end)", r"\1\2", text, flags=re.S) for text in (before, first)]
        self.assertEqual(prose[0], prose[1])
        self.assertEqual(first.count("\n| 7. Cycles |"), 1)
        self.assertTrue(all(f"images/{name}.png" in first for name in FIGURES))

    def test_page_without_markers(self):
        page = self.folder / "empty.md"
        page.write_text("# nothing\n")
        with self.assertRaisesRegex(SystemExit, "empty.md: the markers of the table 'comparison' stand there 0 times"):
            self.write_tables(page)
        self.assertEqual(page.read_text(), "# nothing\n")

    def test_program_that_fails(self):
        runs = Runs(PROGRAM, self.folder / "failed", last=("Mesh/Degree=9",))
        with self.assertRaisesRegex(ProgramError, "run a-q2 ended with code 2: .*Degree"):
            runs.case("a", "q2")
        with self.assertRaisesRegex(ProgramError, "nowhere could not be started"):
            Runs(self.folder / "nowhere", self.folder / "failed").case("a", "q2")


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
