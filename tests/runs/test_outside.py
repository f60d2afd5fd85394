# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Programs that add an obstacle, a friction law, a rule that ends a run and a material from outside of the tree:
tests/examples/outside is built on the installed libraries alone, and what it computes is right.

Usage: test_outside.py PROGRAM [unittest options]"""
import csv
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
OUTSIDE = ROOT / "tests/examples/outside"
PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()


def run(*command):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)


class OutsideTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = pathlib.Path(temporary.name)
        for component in ("contact", "body", "app"):
            made = run("cmake", "--install", PROGRAM.parent, "--component", component, "--prefix", cls.folder / "installed")
            assert made.returncode == 0, made.stderr
        cls.programs = cls.folder / "build"
        # deal.II's flags would optimize for a minute.
        fast = "<CMAKE_CXX_COMPILER> <DEFINES> <INCLUDES> <FLAGS> -O0 -g0 -U_FORTIFY_SOURCE -o <OBJECT> -c <SOURCE>"
        made = run("cmake", "-S", OUTSIDE, "-B", cls.programs, "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={cls.folder / 'installed'}",
                   "-DCMAKE_BUILD_TYPE=Release", f"-DCMAKE_CXX_COMPILE_OBJECT={fast}")
        assert made.returncode == 0, made.stderr
        made = run("cmake", "--build", cls.programs, "-j1")
        assert made.returncode == 0, made.stdout

    def run_scene(self, name, output, *settings, words=()):
        return run(self.programs / name, OUTSIDE / f"{name}.prm", "--quiet", "--output", self.folder / output, *words,
                   *(f"--set={setting}" for setting in settings))

    def table(self, name, output, *settings, words=(), table="history.csv"):
        """The rows of a run that must succeed, as numbers where they are."""
        result = self.run_scene(name, output, *settings, words=words)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return self.rows(output, table)

    def rows(self, output, table):
        with open(self.folder / output / table, encoding="ascii") as file:
            return list(csv.DictReader(file))

    def forces(self, *words):
        rows = self.table(*words)
        return np.array([[float(row[f"force_{axis}"]) for axis in "xyz"] for row in rows])

    def assert_same(self, forces, expected, accuracy):
        self.assertEqual(forces.shape, expected.shape)
        self.assertLess(np.abs(forces - expected).max(), accuracy * np.abs(expected).max())

    def test_all_else_is_the_program(self):
        """Each has its own entries besides those of the program, where and as they are."""
        own = {"cone": "Slope", "lobes": "Depth of lobes", "worn_volume": "Stop at worn volume", "transverse": "Axial modulus"}
        entries = [line for line in run(PROGRAM, "--defaults").stdout.splitlines() if line.startswith("  set ")]
        self.assertGreater(len(entries), 50)
        for name, entry in own.items():
            printed = [line for line in run(self.programs / name, "--defaults").stdout.splitlines() if line.startswith("  set ")]
            names = [line.split("=")[0].strip() for line in printed]
            self.assertIn("set " + entry, names)
            self.assertEqual([line for line in names if line in {other.split("=")[0].strip() for other in entries}],
                             [line.split("=")[0].strip() for line in entries])

    def test_cone_is_the_expression_of_a_cone(self):
        cone = self.forces("cone", "cone")
        expression = self.forces("cone", "expression", "Obstacle/Kind=rigid", "Obstacle/Gap=0.004*sqrt(x^2+y^2)")
        plane = self.forces("cone", "plane", "Obstacle/Kind=rigid")
        self.assert_same(cone, expression, 1e-9)
        self.assertLess(cone[2, 2], 0.9 * plane[2, 2])
        self.assertGreater(cone[-1, 0] ** 2, 1)

    def test_lobes_without_depth_are_a_circle(self):
        circle = ("Friction/Law=ellipses", "Friction/Coefficients=0.2, 0.2")
        own = self.forces("lobes", "none", "Friction/Depth of lobes=0")
        self.assert_same(own, self.forces("lobes", "circle", *circle), 1e-8)
        deep = self.forces("lobes", "deep")
        self.assertGreater(np.abs(own - deep)[:, 0].max(), 0.01 * np.abs(own)[:, 0].max())

    def test_lobes_hold_at_every_probe(self):
        """Forces are in the cone, and on it where a node slips, against its slip."""
        self.table("lobes", "law")
        n_slipping = n_stuck = 0
        for probe in "ABCDEF":
            rows = self.rows("law", f"probe-{probe}.csv")
            at = {name: np.array([float(row[name]) for row in rows]) for name in rows[0] if name != "status"}
            force, slip = (np.stack((at[f"{name}_x"], at[f"{name}_y"])) for name in ("force", "slip"))
            load = np.linalg.norm(force, axis=0) / (0.2 * (1 + 0.2 * np.cos(4 * np.arctan2(force[1], force[0]))))
            self.assertTrue((load <= at["force_n"] * (1 + 1e-8)).all())
            for step, (change, status) in enumerate(zip(np.diff(slip, axis=1).T, [row["status"] for row in rows[1:]]), 1):
                n_stuck += status == "stick"
                if status == "slip":
                    n_slipping += 1
                    self.assertAlmostEqual(load[step] / at["force_n"][step], 1, delta=1e-7)
                    sizes = np.linalg.norm(change) * np.linalg.norm(force[:, step])
                    self.assertAlmostEqual(change @ force[:, step] / sizes, -1, delta=1e-6)
        self.assertGreater(n_slipping, 5)
        self.assertGreater(n_stuck, 2)

    def test_lobes_are_described_by_what_counts(self):
        """Entries of ellipses do not count, and a formula that asks for ellipses gives no number."""
        self.table("lobes", "described")
        log = (self.folder / "described/log.txt").read_text(encoding="utf-8")
        self.assertIn("friction       Law = lobes; Mean friction = 0.2; Depth of lobes = 0.2; Orthotropy angle = 0\n", log)
        self.assertRegex(log, "critical friction not known, because .* friction ellipses only\n")

    def test_lobes_have_the_mirrors_that_their_forces_have(self):
        """About the axes of a pressed body, unless its own are turned."""
        for angle, model in (("0", "quarter"), ("90", "quarter"), ("30", "full")):
            result = run(self.programs / "lobes", OUTSIDE / "lobes.prm", "--check",
                         "--set=Load program/Legs=0 0 -0.02 : 1", f"--set=Friction/Orthotropy angle={angle}")
            self.assertRegex(result.stdout, f"model +{model} ")

    def test_bad_values_of_outside_get_one_line(self):
        result = self.run_scene("lobes", "bad", "Contact solver/Method=feng2006")
        self.assertEqual((result.returncode, result.stderr.count("\n")), (2, 1))
        self.assertIn("Method = feng2006 needs friction ellipses, and Friction/Law = lobes has none", result.stderr)
        result = self.run_scene("lobes", "bad", "Friction/Depth of lobes=2")
        self.assertRegex(result.stderr, "Friction/Depth of lobes.*2.*allowed is.*\n$")
        result = run(self.programs / "lobes", OUTSIDE / "lobes.prm", "--check", "--set=Friction/Coefficients=1, 2")
        self.assertIn("Friction/Coefficients = 1, 2 is ignored with Friction/Law = lobes", result.stdout + result.stderr)
        result = self.run_scene("cone", "bad", "Obstacle/Slope=-1")
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, "Obstacle/Slope.*-1.*allowed is.*\n$")
        result = self.run_scene("worn_volume", "bad", "Wear/Law=none", "Load program/Stop at worn volume=1")
        self.assertEqual((result.returncode, result.stderr.count("\n")), (2, 1))
        self.assertIn("Stop at worn volume = 1 with Wear/Law = none", result.stderr)
        result = self.run_scene("transverse", "bad", "Material/Plane ratio=1.1")
        self.assertEqual((result.returncode, result.stderr.count("\n")), (2, 1))
        self.assertIn("Material/Law = transverse", result.stderr)

    def test_run_ends_at_the_first_cycle_that_wears_the_volume(self):
        whole = self.table("worn_volume", "whole", table="cycles.csv")
        volumes = [float(row["worn_volume"]) for row in whole]
        self.assertEqual(len(volumes), 6)
        self.assertTrue(all(first < second for first, second in zip([0, *volumes], volumes)))
        wanted = f"Load program/Stop at worn volume={(volumes[2] + volumes[3]) / 2}"
        self.assertEqual(self.table("worn_volume", "stopped", wanted, table="cycles.csv"), whole[:4])
        log = (self.folder / "stopped/log.txt").read_text(encoding="utf-8")
        self.assertRegex(log, r"worn volume \S+ mm\^3 after cycle 4\n")
        # The run stays complete, until it is asked for more.
        again = self.table("worn_volume", "stopped", wanted, words=("--resume",), table="cycles.csv")
        self.assertEqual(again, whole[:4])
        more = self.table("worn_volume", "stopped", words=("--resume",), table="cycles.csv")
        self.assertEqual([row["cycle"] for row in more], [row["cycle"] for row in whole])
        np.testing.assert_allclose([float(row["worn_volume"]) for row in more], volumes, rtol=1e-9)

    def test_rule_is_asked_behind_jumps(self):
        jumps = ("Wear/Largest depth of a jump=1", "Load program/Cycles=200")
        whole = self.table("worn_volume", "jumped", *jumps, table="cycles.csv")
        volumes = [float(row["worn_volume"]) for row in whole]
        jump = next(i for i in range(1, len(whole)) if int(whole[i]["cycle"]) > int(whole[i - 1]["cycle"]) + 1)
        wanted = f"Load program/Stop at worn volume={(volumes[jump - 1] + volumes[jump]) / 2}"
        for words in ((), ("--resume",)):
            self.assertEqual(self.table("worn_volume", "behind", wanted, *jumps, words=words, table="cycles.csv"),
                             whole[:jump + 1])

    def test_isotropic_constants_are_the_isotropic_law(self):
        shear = 210000 / 2.6
        own = self.forces("transverse", "own", "Material/Axial modulus=210000", "Material/Axial ratio=0.3",
                          f"Material/Axial shear modulus={shear}", "Material/Plane modulus=210000", "Material/Plane ratio=0.3")
        isotropic = self.forces("transverse", "isotropic", "Material/Law=isotropic", "Material/Young modulus=210000",
                                "Material/Poisson ratio=0.3")
        self.assert_same(own, isotropic, 1e-8)

    def test_transverse_constants_are_nine_of_the_orthotropic_law(self):
        """nu_xz / E_x = nu_zx / E_z. Also with projected quadrature, for which the law has an isotropic average."""
        nine = ("Material/Law=orthotropic", "Material/Young moduli=9000, 9000, 140000",
                f"Material/Poisson ratios=0.4, {0.28 * 9000 / 140000}, {0.28 * 9000 / 140000}",
                f"Material/Shear moduli={9000 / 2.8}, 6000, 6000")
        for quadrature in ("full", "projected"):
            with self.subTest(quadrature):
                setting = f"Mesh/Volumetric quadrature={quadrature}"
                own = self.forces("transverse", f"own {quadrature}", setting)
                self.assert_same(own, self.forces("transverse", f"nine {quadrature}", setting, *nine), 1e-8)
        stiff = self.forces("transverse", "stiff", "Material/Axial modulus=280000")
        self.assertGreater(stiff[2, 2], 1.1 * own[2, 2])

    def test_what_needs_another_material_says_so(self):
        result = self.run_scene("transverse", "revolved", "Mesh/Model=axisymmetric", "Friction/Coefficients=0.2, 0.2")
        self.assertEqual(result.returncode, 2)
        self.assertIn("Material/Law = transverse has axes along x and y", result.stderr)


if __name__ == "__main__":
    unittest.main()
