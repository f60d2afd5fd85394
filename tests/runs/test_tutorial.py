# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The six files of prm/tutorial run, say what docs/tutorial.md says, and stand there as they are.

Usage: test_tutorial.py PROGRAM [unittest options]"""
import re
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
import program  # noqa: E402
from program import ROOT, main  # noqa: E402

FOLDER = ROOT / "prm/tutorial"
PAGE = (ROOT / "docs/tutorial.md").read_text(encoding="utf-8")
SLIDING = "Load program/Legs=ux 0.03 : 8 ; ux -0.03 : 16 ; ux 0 : 8"


class TutorialTest(program.RunTest):
    def history(self, name, *settings):
        """Rows of history.csv as numbers, where they are."""
        result = self.run_program("run", settings=["Output/Volume fields=0", *settings], file=FOLDER / f"{name}.prm")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        words = ("method", "driven")
        return [{key: value if key in words else float(value) for key, value in row.items()} for row in self.rows("run")]

    def assert_near(self, value, expected, share):
        self.assertAlmostEqual(value / expected, 1, delta=share)

    def test_page_names_every_file_and_shows_its_entries(self):
        files = sorted(FOLDER.glob("*.prm"))
        self.assertEqual(len(files), 6)
        written = {" ".join(line.split("#")[0].split()) for line in PAGE.splitlines()}
        for file in files:
            self.assertIn(f"./run prm/tutorial/{file.name}", PAGE)
            entries = {" ".join(line.split("#")[0].split()) for line in file.read_text(encoding="utf-8").splitlines()}
            section = PAGE.split(f"./run prm/tutorial/{file.name}")[0].split("\n## ")[-1]
            for line in re.findall(r"^  set .*$", section, re.MULTILINE):
                with self.subTest(file=file.name, line=line):
                    self.assertIn(" ".join(line.split("#")[0].split()), entries & written)

    def test_1_slip_is_largest_where_friction_is_weak(self):
        self.assert_near(self.history("1_case_b")[4]["max_slip"], 0.0186, 0.01)

    def test_2_no_plane_of_symmetry_is_left(self):
        self.assertEqual(self.run_program("run", "--check", file=FOLDER / "2_own_material.prm").returncode, 0)
        rows = self.history("2_own_material", "Mesh/Resolution=custom", "Mesh/Core cells=4", "Mesh/Rings=2", "Mesh/Layers=2")
        self.assert_near(rows[4]["max_slip"], 0.0216, 0.2)

    def test_3_partial_slip_and_sliding(self):
        partial = self.history("3_fretting")
        self.assertGreater(min(row["n_stick"] for row in partial), 0)
        self.assertLess(max(-row["force_x"] for row in partial), 0.8 * 30000)
        sliding = self.history("3_fretting", SLIDING)
        self.assert_near(max(-row["force_x"] for row in sliding), 30000, 1e-4)
        for row in sliding[5:]:
            self.assert_near(row["force_z"], 1e5, 1e-9)

    def test_4_hertz(self):
        for row in self.history("4_sphere"):
            self.assert_near(row["max_pressure"], 734.56 * (row["force_z"] / 384.615)**(1 / 3), 0.01)

    def test_5_part_carries_what_is_given(self):
        rows = self.history("5_part")
        self.assert_near(rows[9]["force_z"], 2000, 1e-9)
        self.assert_near(rows[-1]["force_z"], 200, 1e-9)
        self.assertGreater(rows[9]["n_stick"], 0)

    def test_6_the_middle_carries_what_wear_leaves(self):
        """With trilinear elements, and as far as the force has settled nearly."""
        rows = self.history("6_wear", "Mesh/Degree=1", "Load program/Cycles=20000")
        force = [row["force_z"] for row in rows if row["cycle"] > 0]
        self.assertLess(force[-1], 0.9 * force[0])
        self.assertGreater(rows[-1]["n_stick"], 0)


if __name__ == "__main__":
    main()
