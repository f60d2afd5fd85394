# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""tools/wear_profile: a worn surface, written and read back as a gap file, is the surface that the run has left.

Usage: test_wear_profile.py PROGRAM [unittest options]"""
import os
import subprocess
import sys

import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
import program  # noqa: E402
from program import ROOT, main  # noqa: E402

sys.path.insert(0, str(ROOT / "tools/runs"))
import run_folder  # noqa: E402

# Of the obstacle: nothing is alike along x and y, or on both sides of the origin along x.
RADII, MIDDLE = (100, 50), 0.5  # mm
GAP = f"Obstacle/Gap=(x-{MIDDLE})^2/(2*{RADII[0]})+y^2/(2*{RADII[1]})"
# A last step at rest is solved on the surface that the file has.
WORN = ["Load program/Preload=uz -0.001 : 1 ; Fz -20 : 8", "Load program/Legs=ux 1 : 20 ; ux -1 : 40 ; ux 0 : 20 ; Fz -20 : 1",
        "Load program/Cycles=4", GAP, "Output/Contact fields=333"]
LAST = 333
BOX = ["Geometry/Shape=box", "Geometry/Sizes=8, 8, 4", "Mesh/Cells=16, 16, 4"]  # its nodes are evenly spaced
LIFTED = 0.001  # mm


class WearProfileTest(program.RunTest):
    FILE = ROOT / "prm/verification/worn_sphere.prm"

    def run_done(self, name, *settings):
        result = self.run_program(name, settings=settings)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return run_folder.RunFolder(self.folder / name)

    def tool(self, *words):
        command = [sys.executable, ROOT / "tools/runs/wear_profile.py", self.folder / "worn", self.folder / "gaps.txt", *words]
        return subprocess.run(command, capture_output=True, text=True, check=False)

    def worn_and_pressed(self, *mesh):
        """The contact fields that a run leaves, and those of a run on its profile: lifted, and pressed as far."""
        worn = self.run_done("worn", *mesh, *WORN)
        result = self.tool()
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        depth = worn.history["uz"][-1]
        pressed = self.run_done("pressed", *mesh, GAP, "Wear/Law=none", "Load program/Preload=", "Load program/Cycles=1",
                                f"Load program/Legs=uz {LIFTED} : 1 ; uz {float(depth)!r} : 1", "Output/Contact fields=1",
                                f"Obstacle/Gap file={self.folder / 'gaps.txt'}")
        self.assertAlmostEqual(worn.history["max_wear_depth"][-2], worn.history["max_wear_depth"][-1], delta=1e-9)
        return [(file, np.lexsort(np.round(file.points[:, :2].T, 6)))
                for file in (worn.contact(LAST), pressed.contact(1), pressed.contact(2))]

    def gap_errors(self, worn, lifted):
        """What the gaps of the profile and the depths of the run differ by, mm."""
        (file, order), (above, other) = worn, lifted
        np.testing.assert_allclose(file.points[order], above.points[other], atol=1e-6)
        x, y = above.points[other, :2].T
        gaps = above["gap"][other] - LIFTED - (x - MIDDLE)**2 / (2 * RADII[0]) - y**2 / (2 * RADII[1])
        return np.abs(gaps - file["wear_depth"][order])

    def test_evenly_spaced_nodes_find_their_depths_and_pressures(self):
        """Without friction, pressure follows from the surface and the motion: it is that of the worn run. Contact files
        have seven digits, of which a stiff body makes four of its pressure."""
        worn, lifted, pressed = self.worn_and_pressed(*BOX)
        self.assertGreater(worn[0]["wear_depth"].max(), 0.03)
        self.assertLess(self.gap_errors(worn, lifted).max(), 2e-7 * lifted[0]["gap"].max())
        expected, found = (file["pressure"][order] for file, order in (worn, pressed))
        self.assertGreater((expected > 0).sum(), 50)
        self.assertLess(np.abs(found - expected).max(), 1e-4 * expected.max())
        sphere = self.run_done("sphere", *BOX, GAP, "Wear/Law=none", "Load program/Preload=", "Load program/Cycles=1",
                               "Load program/Legs=uz -0.01 : 1 ; Fz -20 : 1").history
        self.assertGreater(sphere["max_pressure"][-1], 5 * expected.max())

    def test_other_nodes_err_by_what_the_surface_bends_within_a_cell_of_the_grid(self):
        """By a quarter of a cell times its change of slope, which is largest along the rim of what is worn."""
        worn, lifted, _ = self.worn_and_pressed()
        cell = 0.2
        with open(self.folder / "gaps.txt", encoding="ascii") as file:
            self.assertAlmostEqual(float(file.readlines()[1].split()[1]), cell)
        slope = np.sqrt(2 * worn[0]["wear_depth"].max() / min(RADII))
        self.assertLess(self.gap_errors(worn, lifted).max(), cell / 4 * slope)

    def test_wrong_words(self):
        self.run_done("worn", *BOX, "Load program/Cycles=1", "Output/Contact fields=8")
        self.assertEqual(self.tool("--step", "8", "--points", "9").returncode, 0)
        self.assertEqual(len((self.folder / "gaps.txt").read_text(encoding="ascii").splitlines()), 2 + 9)
        for words, message in ((("--step", "90"), r"has no contact file of step 90"), (("--points", "1"), "from 2 on")):
            result = self.tool(*words)
            self.assertEqual(result.returncode, 1)
            self.assertRegex(result.stderr, message)

    def test_damaged_files_are_a_line(self):
        self.run_done("worn", *BOX, "Load program/Cycles=1", "Output/Contact fields=8")
        file = sorted((self.folder / "worn").glob("contact-*.vtu"))[-1]
        text = file.read_text(encoding="ascii")
        file.write_text(text.replace("wear_depth", "other"), encoding="ascii")
        self.assertEqual((self.tool().returncode, self.tool().stderr), (4, "wear_profile: no field 'wear_depth' in the contact file\n"))
        file.unlink()
        os.mkfifo(file)
        result = self.tool()
        self.assertEqual(result.returncode, 4)
        self.assertRegex(result.stderr, r"^wear_profile: \S*contact-[0-9]*\.vtu: is no ordinary file, but a pipe; .*\n$")


if __name__ == "__main__":
    main()
