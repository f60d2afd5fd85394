# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""tools/rosette: its law is that of the program, the nearest table is well posed and the nearest, the best ellipses are those
of the table, pictures show where a table fails, wrong files are refused in a line.

Usage: test_rosette_tool.py PROGRAM [unittest options]"""
import os
import subprocess
import sys

import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
import program  # noqa: E402
from program import ROOT, main  # noqa: E402

sys.path[:0] = [str(ROOT / "tools/rosettes"), str(ROOT / "tools/runs")]
import nearest  # noqa: E402
import rosette_file  # noqa: E402
from best_ellipses import best_ellipses  # noqa: E402
from rosette_curve import Curve  # noqa: E402
from rosette_law import NotWellPosed, RosetteError, RosetteLaw, Table, cross, ellipse_forces, unit  # noqa: E402
from superellipse import superellipse_table  # noqa: E402

TOOL = ROOT / "tools/rosettes/rosette.py"
BLOCK = ["Mesh/Core cells=4", "Mesh/Rings=2", "Mesh/Layers=2", "Mesh/Degree=1", "Friction/Law=rosette", "Friction/Rosette=friction.txt",
         "Load program/Cycles=1"]
WRONG_INPUT, FILE_ERROR = 2, 4
ALL_AROUND = np.radians(np.arange(0.7, 360, 1.3))


def ratchet(angles):
    """Neither symmetric nor associated, and smooth."""
    e = unit(angles)
    along, across = 0.25 * (1 + 0.4 * np.cos(angles - 0.5) + 0.2 * np.cos(3 * angles)), 0.06 * (1 + np.sin(2 * angles))
    return along[:, None] * e + across[:, None] * np.stack([-e[:, 1], e[:, 0]], axis=1)


def table_of(forces, n, first=0.1):
    """Rows that are not evenly spaced."""
    angles = first + 2 * np.pi * np.arange(n) / n
    angles = angles + 0.4 / n * np.sin(3 * angles)
    return Table.of_forces(angles, forces(angles))


def jagged(n=16, seed=4, share=0.5):
    """Coarse rows that turn by much, of which some sectors take safer slopes and tension."""
    random = np.random.default_rng(seed)
    table = table_of(lambda angles: 0.3 * unit(angles), n)
    table.along *= 1 + share * (random.random(n) - 0.5)
    table.across += 0.3 * share * (random.random(n) - 0.5)
    return nearest.nearest(table)


class LawTest(program.RunTest):
    def write(self, table, name="friction.txt"):
        rows = [f"{angle!r} {along!r} {across!r}" for angle, along, across in
                zip(*(values.tolist() for values in (np.degrees(table.angles), table.along, table.across)))]
        (self.folder / name).write_text("\n".join(rows) + "\n", encoding="ascii")

    def test_forces_are_those_of_the_program(self):
        """A block that slides along many directions, in turn, until it has forgotten the last one."""
        angles = np.radians(np.arange(3, 360, 11.25))
        places = np.cumsum(-5 * unit(angles), axis=0)
        legs = " ; ".join(["0 0 -0.02 : 1", *(f"{x!r} {y!r} -0.02 : 8" for x, y in places.tolist())])
        for name, table in (("smooth", table_of(ratchet, 24)), ("jagged", jagged())):
            self.write(table)
            result = self.run_program(name, settings=[*BLOCK, f"Load program/Legs={legs}", "Output/Contact fields=0"])
            self.assertEqual(result.returncode, 0, result.stderr)
            x, y, z = (np.array([float(row[f"force_{axis}"]) for row in self.rows(name)[8::8]]) for axis in "xyz")
            np.testing.assert_allclose(np.stack([x / z, y / z], axis=1), RosetteLaw(table).force(angles), atol=1e-9, err_msg=name)

    def test_superellipses_are_those_of_the_program(self):
        angles = np.radians(np.arange(3, 360, 22.5))
        places = np.cumsum(-5 * unit(angles), axis=0)
        legs = " ; ".join(["0 0 -0.02 : 1", *(f"{x!r} {y!r} -0.02 : 8" for x, y in places.tolist())])
        for exponents in ((4, 4), (1.5, 3)):
            result = self.run_program("formula", settings=[
                *BLOCK[:4], "Load program/Cycles=1", f"Load program/Legs={legs}", "Output/Contact fields=0", "Friction/Law=superellipse",
                f"Friction/Exponent={exponents[0]}", f"Friction/Slip exponent={exponents[1]}", "Friction/Slip potential=0.2, 0.25"])
            self.assertEqual(result.returncode, 0, result.stderr)
            x, y, z = (np.array([float(row[f"force_{axis}"]) for row in self.rows("formula")[8::8]]) for axis in "xyz")
            law = RosetteLaw(superellipse_table((0.3, 0.15), (0.2, 0.25), *exponents))
            np.testing.assert_allclose(np.stack([x / z, y / z], axis=1), law.force(angles), atol=1e-9, err_msg=str(exponents))

    def test_ellipses_are_themselves_and_others_come_near_with_the_fourth_power(self):
        for mu, p in (((0.3, 0.15), (0.3, 0.15)), ((0.3, 0.15), (0.05, 0.2)), ((0.2, 0.2), (1, 1))):
            law = RosetteLaw(table_of(lambda angles, mu=mu, p=p: ellipse_forces(angles, mu, p, 0.3), 8))
            np.testing.assert_allclose(law.force(ALL_AROUND), ellipse_forces(ALL_AROUND, mu, p, 0.3), atol=1e-13)
        errors = [np.abs(RosetteLaw(table_of(ratchet, n)).force(ALL_AROUND) - ratchet(ALL_AROUND)).max() for n in (24, 48, 96)]
        self.assertLess(errors[1], errors[0] / 12)
        self.assertLess(errors[2], errors[1] / 12)

    def test_derivatives_conditions_and_inverse(self):
        for table in (table_of(ratchet, 18), jagged()):
            law, h = RosetteLaw(table), 1e-6
            np.testing.assert_allclose(law.force(table.angles), table.forces, atol=1e-14)
            slopes = (law.force(ALL_AROUND + h) - law.force(ALL_AROUND - h)) / (2 * h)
            np.testing.assert_allclose(law.derivative(ALL_AROUND), slopes, atol=1e-7)
            force = law.force(ALL_AROUND)
            along, kappa, turning = law.conditions(ALL_AROUND)
            np.testing.assert_allclose(along, (force * unit(ALL_AROUND)).sum(axis=1), atol=1e-14)
            np.testing.assert_allclose(kappa, cross(unit(ALL_AROUND), slopes), atol=1e-7)
            np.testing.assert_allclose(turning, cross(force, slopes) / (force**2).sum(axis=1), atol=1e-6)
            b = np.arctan2(force[:, 1], force[:, 0])
            np.testing.assert_allclose(np.exp(1j * law.slip_angle(b)), np.exp(1j * ALL_AROUND), atol=1e-10)
            np.testing.assert_allclose(law.limit(b), np.linalg.norm(force, axis=1), atol=1e-10)

    def test_the_nearest_table_is_taken_by_the_program(self):
        table = table_of(ratchet, 36)
        table.across = table.across + 0.05 * np.random.default_rng(3).normal(size=36)
        self.write(table, "measured.txt")
        refused = self.run_program("check", "--check", settings=[*BLOCK, "Friction/Rosette=measured.txt"])
        self.assertEqual(refused.returncode, WRONG_INPUT)
        result = subprocess.run([sys.executable, TOOL, "measured.txt", "--nearest", "friction.txt"], cwd=self.folder, text=True,
                                capture_output=True, check=False)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertIn("the program refuses it", result.stdout)
        taken = self.run_program("check", "--check", settings=BLOCK)
        self.assertEqual(taken.returncode, 0, taken.stderr)


class NearestTest(program.RunTest):
    def test_a_well_posed_table_stays(self):
        table = table_of(ratchet, 12)
        self.assertIs(nearest.nearest(table), table)

    def test_what_changes_is_held_by_conditions(self):
        """The change is a sum of the normals of those conditions that hold with their margin and no more, with weights > 0."""
        table = table_of(ratchet, 24)
        table.across = table.across + 0.05 * np.random.default_rng(5).normal(size=24)
        found = nearest.nearest(table)
        conditions = nearest.Conditions(table, nearest.MARGIN)
        x = np.stack([found.along, found.across], axis=1) / conditions.mean
        matrix, least = conditions.linearized(x)
        values = nearest.times(matrix, x) - least
        self.assertGreater(values.min(), -1e-6)
        active = np.argwhere(values < 1e-6)
        normals = np.zeros((len(active), 24, 2))
        for normal, (condition, i) in zip(normals, active):
            normal[[i, (i + 1) % 24]] += matrix[condition, i]
        weights, *_ = np.linalg.lstsq(normals.reshape(len(active), -1).T, (x - conditions.wanted).ravel(), rcond=None)
        self.assertGreater(weights.min(), -1e-6)
        np.testing.assert_allclose(np.einsum("a,aij->ij", weights, normals), x - conditions.wanted, atol=1e-6)

    def test_no_table_is_nearer(self):
        """In a convex set all others lie on the far side of the nearest point: seen from there, the angle between the way
        back and the way to another one is not less than a right angle."""
        table = table_of(ratchet, 24)
        table.across = table.across + 0.05 * np.random.default_rng(5).normal(size=24)
        with self.assertRaises(NotWellPosed):
            RosetteLaw(table)
        found = nearest.nearest(table)
        others = [Table.of_forces(table.angles, law(table.angles)) for law in
                  (ratchet, lambda a: 0.3 * unit(a), lambda a: ellipse_forces(a, (0.3, 0.2), (0.3, 0.2)))]
        for other in others:
            back, there = ([getattr(one, name) - getattr(found, name) for name in ("along", "across")] for one in (table, other))
            self.assertLess(np.sum(np.multiply(back, there)), 1e-9)

    def test_best_ellipses(self):
        for mu, p, turn in (((0.3, 0.15), (0.05, 0.2), 0.3), ((0.1, 0.3), (1, 0.1), -1.2), ((0.2, 0.2), (1, 1), 0.)):
            table = table_of(lambda angles, mu=mu, p=p, turn=turn: ellipse_forces(angles, mu, p, turn), 17)
            found = best_ellipses(table)
            self.assertLess(found.largest, 1e-9)
            self.assertLessEqual(abs(found.turn), np.pi / 4 + 1e-12)
            np.testing.assert_allclose(found.forces(ALL_AROUND), ellipse_forces(ALL_AROUND, mu, p, turn), atol=1e-9)


class ToolTest(program.RunTest):
    def tool(self, *words):
        return subprocess.run([sys.executable, TOOL, *words], cwd=self.folder, text=True, capture_output=True, check=False)

    def write(self, table, name="table.txt"):
        (self.folder / name).write_text(rosette_file.text_for([table], "a comment"), encoding="utf-8")

    def test_what_is_said_and_drawn(self):
        self.write(table_of(lambda angles: ellipse_forces(angles, (0.3, 0.15), (0.05, 0.2), 0.3), 36))
        result = self.tool("table.txt", "--ellipses", "--picture", "table.png", "--nearest", "same.txt")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        for words in ("36 rows", "well posed, and the program takes it", "set Coefficients     = 0.3, 0.15", "to and fro mu_along is the same",
                      "set Slip potential   = 0.25, 1", "set Orthotropy angle = 17.19", "same.txt: the same rows"):
            self.assertIn(words, result.stdout)
        self.assertEqual((self.folder / "table.png").read_bytes()[:4], b"\x89PNG")
        np.testing.assert_allclose(rosette_file.read(self.folder / "same.txt")[0].forces,
                                   rosette_file.read(self.folder / "table.txt")[0].forces)

    def test_several_tables(self):
        """One is looked at, and the others stay as they are."""
        bad = table_of(ratchet, 12)
        bad.across[3] += 0.2
        text = rosette_file.text_for([table_of(ratchet, 24), bad])
        (self.folder / "table.txt").write_text(text, encoding="ascii")
        result = self.tool("table.txt", "--table", "1", "--nearest", "other.txt")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertIn("table.txt (table 1 of 2): 12 rows", result.stdout)
        first, second = rosette_file.read(self.folder / "other.txt")
        np.testing.assert_allclose(first.forces, table_of(ratchet, 24).forces, atol=1e-6)
        self.assertEqual(Curve(second).refusal, "")
        self.assertIn("(table 0 of 2): 24 rows", self.tool("table.txt").stdout)
        result = self.tool("table.txt", "--table", "2")
        self.assertEqual((result.returncode, result.stderr), (WRONG_INPUT, "rosette: table.txt: --table 2: allowed are 0 to 1\n"))
        (self.folder / "table.txt").write_text(text + "table\n0 0.3 0\n", encoding="ascii")
        self.assertIn("line 40: the table that begins here has 1 rows", self.tool("table.txt").stderr)

    def test_a_picture_says_where_a_table_fails(self):
        table = table_of(ratchet, 36)
        table.across[7] += 0.1
        self.write(table)
        self.assertTrue(any(Curve(table).failing().values()))
        result = self.tool("table.txt", "--picture", "table.svg")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertIn("the program refuses it, because", result.stdout)
        self.assertIn("--nearest OUT.txt", result.stdout)
        self.assertIn("kappa ≤ 0", (self.folder / "table.svg").read_text(encoding="utf-8"))

    def test_wrong_files(self):
        good = "".join(f"{angle} 0.3 0\n" for angle in range(0, 360, 30))
        for text, words in (("0 0.3\n" + good, "line 1: '0 0.3': allowed is a line 'angle mu_along mu_across' of three numbers"),
                            (good + "15 0.3 nan\n", "line 13: '15 0.3 nan': allowed is a line"),
                            (good + "360 0.3 0\n", "has the angle 0 degrees twice"), ("0 0.3 0\n", "has 1 rows: allowed are 8 and more"),
                            ("", "has 0 rows: allowed are 8 and more"),
                            ("".join(f"{angle} 0.3 0\n" for angle in range(0, 200, 20)), "allowed are steps up to 90 degrees")):
            (self.folder / "table.txt").write_text(text, encoding="ascii")
            with self.assertRaises(RosetteError):
                rosette_file.read(self.folder / "table.txt")
            result = self.tool("table.txt")
            self.assertEqual((result.returncode, result.stdout), (WRONG_INPUT, ""))
            self.assertRegex(result.stderr, r"^rosette: table\.txt: [^\n]*\n$")
            self.assertIn(words, result.stderr)

    def test_tables_of_any_numbers(self):
        """Friction that drives, or differs by orders of magnitude from row to row: there is a nearest table."""
        random, angles = np.random.default_rng(7), 2 * np.pi * np.arange(12) / 12
        for along, across in ((0.2 + 0.3 * random.normal(size=12), 0.2 * random.normal(size=12)), (np.full(12, -0.3), np.zeros(12)),
                              (10.**random.integers(-6, 6, size=12), random.normal(size=12)), (np.full(12, 0.3), 10 * random.normal(size=12))):
            self.write(Table(angles, along, across))
            result = self.tool("table.txt", "--nearest", "nearest.txt", "--ellipses")
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            self.assertTrue(nearest.is_well_posed(rosette_file.read(self.folder / "nearest.txt")[0]))
        for size in (1e300, 1e-300, 0):
            self.write(Table(angles, np.full(12, size), np.zeros(12)))
            self.assertEqual(self.tool("table.txt").returncode, WRONG_INPUT)

    def test_wrong_command_lines_and_lost_files(self):
        self.write(table_of(ratchet, 12))
        os.mkfifo(self.folder / "pipe")
        (self.folder / "text").write_bytes(b"\xff\xfe")
        for words, code in ((("none.txt",), FILE_ERROR), (("pipe",), FILE_ERROR), (("text",), FILE_ERROR), ((".",), FILE_ERROR),
                            (("table.txt", "--picture", "no/folder.png"), FILE_ERROR), (("table.txt", "--nearest", "pipe"), FILE_ERROR),
                            (("table.txt", "--picture", "table.gif"), WRONG_INPUT), (("table.txt", "--nearest", "table.txt"), WRONG_INPUT),
                            (("table.txt", "--margin", "0"), WRONG_INPUT), ((), WRONG_INPUT)):
            result = self.tool(*words)
            self.assertEqual(result.returncode, code, words)
            self.assertRegex(result.stderr, r"^rosette: [^\n]*\n$")
        self.assertEqual(self.tool("--help").returncode, 0)


if __name__ == "__main__":
    main()
