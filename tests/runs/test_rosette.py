# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Measured friction: tables of the force over the direction of slip.

Usage: test_rosette.py PROGRAM [unittest options]"""
import math
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
import numpy as np  # noqa: E402
import program  # noqa: E402
from program import main  # noqa: E402

LAW = ["Friction/Law=rosette", "Friction/Rosette=friction.txt"]
BLOCK = ["Mesh/Core cells=4", "Mesh/Rings=2", "Mesh/Layers=2", "Mesh/Degree=1"]
SLIDE = "0 0 -0.02 : 1 ; {} {} -0.02 : 8"  # the last steps slide along the motion, to rounding
WRONG_INPUT = 2


def ellipses(angle, mu=(0.3, 0.15), p=(0.3, 0.15)):
    """The force against slip along -e(angle), along and across e(angle)."""
    e = np.array([math.cos(angle), math.sin(angle)])
    force = np.square(p) * e
    force /= np.hypot(*(force / mu))
    return force @ e, force @ (-e[1], e[0])


def ratchet(angle):
    """Neither symmetric nor convex nor chiral by halves, and well posed."""
    return 0.25 * (1 + 0.4 * math.cos(angle - 0.5) + 0.2 * math.cos(3 * angle)), 0.06 * (1 + math.sin(2 * angle))


class RosetteTest(program.RunTest):
    def write(self, law, step=1):
        rows = [f"{angle}, {law(math.radians(angle))[0]:.17g}; {law(math.radians(angle))[1]:.17g}"
                for angle in reversed(range(0, 360, step))]
        (self.folder / "friction.txt").write_text("# angle along across\n" + "\n".join(rows) + "\n", encoding="ascii")

    def forces(self, output):
        return np.array([[float(row[f"force_{axis}"]) for axis in "xyz"] for row in self.rows(output)])

    def test_a_table_of_the_ellipses_repeats_their_history(self):
        settings = [*BLOCK, "Mesh/Model=full", "Load program/Legs=0 0 -0.1 : 3 ; 0.02 0.01 -0.1 : 4 ; 0 0 -0.05 : 3"]
        self.assertEqual(self.run_program("ellipses", settings=settings).returncode, 0)
        largest = np.abs(self.forces("ellipses")).max()
        for step in (30, 1):
            self.write(ellipses, step)
            result = self.run_program(f"rosette{step}", settings=[*settings, *LAW])
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            np.testing.assert_allclose(self.forces(f"rosette{step}"), self.forces("ellipses"), atol=1e-8 * largest)

    def test_gross_sliding_along_all_directions(self):
        """The resultant is that of the table, for slip of the body along each direction."""
        self.write(ratchet, 10)
        angles = np.radians(np.arange(0, 360, 40))
        for k, angle in enumerate(angles):
            settings = [*BLOCK, *LAW, "Load program/Legs=" + SLIDE.format(*(-5 * np.array([math.cos(angle), math.sin(angle)])))]
            result = self.run_program(f"slide{k}", settings=settings)
            self.assertEqual(result.returncode, 0, result.stderr)
            x, y, z = self.forces(f"slide{k}")[-1]
            along, across = ratchet(angle)
            expected = along * np.array([math.cos(angle), math.sin(angle)]) + across * np.array([-math.sin(angle), math.cos(angle)])
            np.testing.assert_allclose([x / z, y / z], expected, atol=1e-9)

    def test_energy_around_a_circle(self):
        """Friction takes energy in every step, and the balance of energy holds as for ellipses."""
        self.write(ratchet, 10)
        circle = " ; ".join(f"{0.03 * math.cos(a)} {0.03 * math.sin(a)} -0.05 : 1" for a in np.radians(np.arange(0, 361, 30)))
        result = self.run_program("circle", settings=[*BLOCK, *LAW, f"Load program/Legs=0 0 -0.05 : 2 ; {circle} ; 0 0 0 : 3", "Load program/Cycles=1"])
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        dissipated = [float(row["dissipation"]) for row in self.rows("circle")]
        self.assertGreater(min(dissipated), 0)
        checks = self.rows("circle", "checks.csv")
        for name in ("energy_identity", "friction_cone", "slip_rule"):
            self.assertLess(max(float(row[name]) for row in checks), 1e-8, name)

    def test_a_law_without_symmetry_has_no_half_model(self):
        self.write(ratchet)
        shown = self.run_program("check", "--check", settings=[*BLOCK, *LAW])
        self.assertIn("model          full", shown.stdout)
        self.assertIn("Friction/Law = rosette", shown.stdout)
        refused = self.run_program("half", settings=[*BLOCK, *LAW, "Mesh/Model=half"])
        self.assertEqual(refused.returncode, WRONG_INPUT)
        self.assertIn("Friction/Law = rosette", refused.stderr)
        self.write(ellipses)
        shown = self.run_program("check", "--check", settings=[*BLOCK, *LAW])
        self.assertIn("model          quarter", shown.stdout)

    def write_tables(self, *laws):
        text = ""
        for law in laws:
            rows = [f"{angle} {law(math.radians(angle))[0]:.17g} {law(math.radians(angle))[1]:.17g}" for angle in range(0, 360, 5)]
            text += "table\n" + "\n".join(rows) + "\n"
        (self.folder / "friction.txt").write_text(text, encoding="ascii")

    def test_tables_by_place(self):
        """The second of two tables alone; half of both; and each on its half of the surface."""
        settings = [*BLOCK, *LAW, "Geometry/Shape=box", "Geometry/Sizes=8, 8, 8", "Mesh/Cells=4, 4, 3", "Output/Probes=", "Load program/Legs=" + SLIDE.format(-5, 0)]
        forces = {}
        for name, laws, weight in (("first", (ellipses,), "0"), ("second", (ratchet,), "0"), ("chosen", (ellipses, ratchet), "1"),
                                   ("mean", (ellipses, ratchet), "0.5"), ("halves", (ellipses, ratchet), "if(x<0.1,0,1)")):
            self.write_tables(*laws)
            more = [] if weight == "0" else [f"Friction/Rosette weight={weight}"]
            result = self.run_program(name, settings=[*settings, *more])
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            forces[name] = self.forces(name)
        np.testing.assert_array_equal(forces["chosen"], forces["second"])
        shares = {name: force[-1] / force[-1][2] for name, force in forces.items()}
        np.testing.assert_allclose(shares["mean"], (shares["first"] + shares["second"]) / 2, atol=1e-9)
        below = [min(shares["first"][i], shares["second"][i]) for i in range(2)]
        above = [max(shares["first"][i], shares["second"][i]) for i in range(2)]
        self.assertTrue(all(low + 0.01 < of_halves < high - 0.01 for low, of_halves, high in zip(below, shares["halves"], above)), shares)
        refused = self.run_program("beyond", settings=[*settings, "Friction/Rosette weight=x"])
        self.assertEqual((refused.returncode, refused.stderr.count("\n")), (WRONG_INPUT, 1))
        self.assertRegex(refused.stderr, "Friction/Rosette weight = x is -?[0-9.]+ at .* allowed are numbers from 0 to 1, because .*friction.txt has 2 tables")

    def test_plane_strain_with_axes_of_its_own(self):
        """A table along an axis across the section is that of the ellipses there, of which the section takes the other
        semi-axis."""
        self.write(ellipses)
        line = ["Geometry/Kind=plane strain", "Geometry/Shape=box", "Geometry/Sizes=4, 1, 2", "Mesh/Cells=4, 1, 2", "Mesh/Degree=1",
                "Output/Probes=", "Load program/Legs=uz -0.01 : 1 ; ux 0.05 : 4"]
        for name, axes in (("constant", "Friction/Orthotropy angle=90"), ("varying", "Friction/Orthotropy angle=90+0*x"),
                           ("given", "Friction/First axis=0, 1, 0")):
            for law, more in (("e", []), ("r", LAW)):
                result = self.run_program(name + law, settings=[*line, axes, *more])
                self.assertEqual(result.returncode, 0, result.stderr)
            found, expected = self.forces(name + "r")[-1], self.forces(name + "e")[-1]
            self.assertAlmostEqual(abs(expected[0] / expected[2]), 0.15, places=6)
            np.testing.assert_allclose(found, expected, atol=1e-5 * abs(expected[2]))

    def test_wrong_tables(self):
        good = "".join(f"{angle} 0.3 0\n" for angle in range(0, 360, 30))
        for text, message in (
                ("0 0.3\n" + good, "friction.txt:1: '0 0.3': allowed is a line 'angle mu_along mu_across' of three numbers"),
                ("table\n" + good + "table\n0 0.3 0\n", "friction.txt:14: the table that begins here has 1 rows: allowed are 8 and more"),
                (good + "15 0.3 zero\n", "friction.txt:13: '15 0.3 zero': allowed is a line"),
                (good + "15 0.3 0 1\n", "friction.txt:13: '15 0.3 0 1': allowed is a line"),
                (good + "360 0.3 0\n", "friction.txt: has the angle 0 degrees twice"),
                ("0 0.3 0\n90 0.3 0\n", "friction.txt: has 2 rows: allowed are 8 and more"),
                (good + "15 -0.3 0\n", "friction.txt: mu_along is -0."),
                (good + "15 0.3 0.9\n", "friction.txt: the turn of the force, d b/da, is -3.77")):
            (self.folder / "friction.txt").write_text(text, encoding="ascii")
            result = self.run_program("wrong", settings=[*BLOCK, *LAW])
            self.assertEqual((result.returncode, result.stdout), (WRONG_INPUT, ""), text)
            self.assertIn(message, result.stderr)
            self.assertEqual(result.stderr.count("\n"), 1)
        result = self.run_program("wrong", settings=[*BLOCK, LAW[0]])
        self.assertIn("Friction/Law = rosette without Friction/Rosette", result.stderr)
        (self.folder / "friction.txt").unlink()
        self.assertEqual(self.run_program("wrong", settings=[*BLOCK, *LAW]).returncode, 4)

    def test_resumed_with_the_same_table_only(self):
        self.write(ratchet)
        settings = [*BLOCK, *LAW, "Load program/Cycles=1", "Load program/Legs=0 0 -0.05 : 2 ; 0 0 0 : 2"]
        self.assertEqual(self.run_program("run", settings=settings).returncode, 0)
        more = [*settings, "Load program/Cycles=2"]
        self.write(ellipses)
        refused = self.run_program("run", "--resume", settings=more)
        self.assertEqual(refused.returncode, WRONG_INPUT)
        self.assertIn("friction.txt", refused.stderr)
        self.write(ratchet)
        self.assertEqual(self.run_program("run", "--resume", settings=more).returncode, 0)
        self.assertEqual(self.run_program("both", settings=more).returncode, 0)
        self.assert_same_files("run", "both", ["history.csv", "cycles.csv"])


if __name__ == "__main__":
    main()
