# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The scenes of prm/rosette: a strip on a ratchet walks as far as statics say, laws and their mirror images have slips that are
mirror images, and stick zones have the form of the law. How many slips a push has on springs.

Usage: test_rosette_scenes.py PROGRAM [unittest options]"""
import sys

import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
import program  # noqa: E402
from program import ROOT, main  # noqa: E402

sys.path.insert(0, str(ROOT / "tools/studies"))
import paths  # noqa: E402, F401 (finds the modules of all studies)
import rosette_file  # noqa: E402
import several_slips  # noqa: E402
from nearest import is_well_posed  # noqa: E402
from rosette_law import RosetteLaw, Table, ellipse_forces  # noqa: E402
from run_folder import SLIP, STICK, ContactFile  # noqa: E402

FOLDER = ROOT / "prm/rosette"
COARSE = ["Mesh/Core cells=4", "Mesh/Layers=2", "Mesh/Degree=1", "Load program/Legs=uz -0.05 : 3 ; ux 0.012 : 3"]


class WalkerTest(program.RunTest):
    FILE = FOLDER / "walker.prm"

    def walk(self, name, *settings):
        """Way of the middle in each of the last three cycles, µm."""
        result = self.run_program(name, settings=settings)
        self.assertEqual(result.returncode, 0, result.stderr)
        slip = np.array([1e3 * float(row["slip_x"]) for row in self.rows(name, "probe-middle.csv")])
        return np.diff(slip[8::8])

    def test_it_walks_as_far_as_a_strip_that_does_not_bend(self):
        """The rest falls with the weight, and so with friction."""
        rest = []
        for weight in (2, 1):
            found = self.walk(f"weight_{weight}", f"Load program/Preload=weight {weight} : 1")
            self.assertLess(np.ptp(found), 1e-7 * found[0])
            rest.append(4 * 0.91 / 210 * (0.4 - 0.001 * weight) * 1000 / found[0] - 1)
        self.assertLess(rest[1], 3.5e-4)
        self.assertAlmostEqual(rest[0] / rest[1], 2, delta=0.02)

    def test_without_a_ratchet_it_stays(self):
        found = self.walk("stays", "Friction/Law=ellipses", "Friction/Coefficients=0.25, 0.25")
        self.assertLess(np.abs(found).max(), 1e-6)

    def test_a_turned_ratchet_walks_back(self):
        there, back = self.walk("there"), self.walk("back", "Friction/Orthotropy angle=180")
        np.testing.assert_allclose(back, -there, rtol=1e-8)


class SceneTest(program.RunTest):
    def contact(self, name, table=None, step=3):
        settings = [*COARSE, *([f"Friction/Rosette={self.folder / table}"] if table else [])]
        output = f"{name} {table}" if table else name
        result = self.run_program(output, settings=[*settings, "Mesh/Model=full"], file=FOLDER / f"{name}.prm")
        self.assertEqual(result.returncode, 0, result.stderr)
        return ContactFile(self.folder / output / f"contact-{step:04d}.vtu")

    def test_all_tables_are_well_posed(self):
        names = {path.stem for path in FOLDER.glob("*.txt")} - {"scattered"}
        self.assertEqual(names, {"chiral", "four_lobes", "ratchet"})
        for name in names:
            table, = rosette_file.read(FOLDER / f"{name}.txt")
            self.assertTrue(is_well_posed(table))
        scattered, = rosette_file.read(FOLDER / "scattered.txt")
        self.assertFalse(is_well_posed(scattered))

    def test_handedness_turns_the_slip_and_its_mirror_image_turns_it_back(self):
        table, = rosette_file.read(FOLDER / "chiral.txt")
        image = Table(table.angles, table.along, -table.across)
        (self.folder / "image.txt").write_text(rosette_file.text_for([image]), encoding="ascii")
        turns = []
        for file in (self.contact("chiral"), self.contact("chiral", "image.txt")):
            x, y = file.points[:, 0], file.points[:, 1]
            slip = file["slip"]
            turns.append(np.arctan2((x * slip[:, 1] - y * slip[:, 0]).sum(), (x * slip[:, 0] + y * slip[:, 1]).sum()))
        self.assertAlmostEqual(turns[0], -turns[1], delta=1e-6)
        free = np.arctan(0.1 / 0.25)  # of a node alone
        self.assertTrue(0.75 * free < abs(turns[0]) < free)

    def test_four_arms_stick(self):
        """On the diagonals the pressed base sticks farther out than on the axes."""
        file = self.contact("four_lobes")
        x, y = file.points[:, 0], file.points[:, 1]
        radius, sticks = np.hypot(x, y), file["status"] == STICK
        on_axes, on_diagonals = np.minimum(abs(x), abs(y)) < 0.1, abs(abs(x) - abs(y)) < 0.1
        self.assertGreater(radius[sticks & on_diagonals].max(), 1.3 * radius[sticks & on_axes].max())

    def test_a_ratchet_spreads_to_one_side(self):
        file = self.contact("ratchet")
        slips = file["status"] == SLIP
        x, slip = file.points[slips, 0], file["slip"][slips, 0]
        self.assertGreater(slip[x > 5].max(), 4 * abs(slip[x < -5]).max())
        lateral = np.array([[float(row[f"force_{axis}"]) for axis in "xyz"] for row in self.rows("ratchet")])[:3]
        self.assertLess(abs(lateral[:, 1] / lateral[:, 2]).max(), 1e-8)


class SeveralSlipsTest(program.RunTest):
    def test_springs_that_differ_by_less_than_the_bound(self):
        """cot^2(delta/2), for the axes of springs for which it is sharp: one solution below it, and three above."""
        angles = 2 * np.pi * np.arange(72) / 72
        case_c = Table.of_forces(angles, ellipse_forces(angles, (0.3, 0.15), (0.05, 0.2), np.pi / 4))
        chiral = Table(angles, np.full(72, 0.25), np.full(72, 0.1))
        for table, angle in ((case_c, np.arcsin(63 / 65)), (chiral, np.arctan(0.1 / 0.25))):
            bound = 1 / np.tan(self.departure(table, angle) / 2)**2
            law = RosetteLaw(table)
            for share, n in ((0.98, 1), (1.03, 3)):
                self.assertEqual(several_slips.Node(law, share * bound).most_solutions(), n)

    def departure(self, table, expected):
        """Largest angle between e and the normal of the curve of forces, which is that of a closed form."""
        law, angles = RosetteLaw(table), np.linspace(0, 2 * np.pi, 7201)
        slope = law.derivative(angles)
        lean = np.arctan2(slope[:, 1], slope[:, 0]) - angles - np.pi / 2
        found = np.abs(np.angle(np.exp(1j * lean))).max()
        self.assertAlmostEqual(found, expected, delta=1e-3)
        return found

    def test_equal_springs_and_associated_friction(self):
        random = np.random.default_rng(2)
        angles = 2 * np.pi * np.arange(36) / 36
        associated = Table.of_forces(angles, ellipse_forces(angles, (0.3, 0.1), (0.3, 0.1), 0.4))
        for ratio in (0.01, 100):
            self.assertEqual(several_slips.Node(RosetteLaw(associated), ratio).most_solutions(), 1)
        for _ in range(5):
            along = 0.3 + 0.05 * np.cos(angles + random.random()) + 0.03 * np.sin(3 * angles)
            law = RosetteLaw(Table(angles, along, 0.05 * np.cos(2 * angles + 6 * random.random())))
            self.assertEqual(several_slips.Node(law, 1).most_solutions(), 1)


if __name__ == "__main__":
    main()
