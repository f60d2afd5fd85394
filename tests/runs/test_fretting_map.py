# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Fretting maps: regimes beside what theory says of them, and what tools/fretting_map refuses.

Usage: test_fretting_map.py PROGRAM [unittest options]"""
import csv
import math
import subprocess
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
import numpy as np  # noqa: E402
from program import PROGRAM, ROOT, SCENE, RunTest, main  # noqa: E402

sys.path.insert(0, str(ROOT / "tools/sweeps"))
import map_points  # noqa: E402

MAP = ROOT / "tools/sweeps/fretting_map.py"
RIG = ROOT / "prm/rigs/sphere_on_flat.prm"
DONE, WRONG, NOT_COMPLETE, FILE_ERROR = 0, 2, 3, 4
COARSE = ("Mesh/Core cells=4", "Mesh/Rings=3", "Mesh/Layers=4", "Mesh/Degree=1")
MU = 0.5  # of the rig


class FrettingMapTest(RunTest):
    def map(self, *words, file=RIG, settings=COARSE, code=DONE):
        words = [*words, *(word for setting in settings for word in ("--set", setting))]
        result = subprocess.run(["/usr/bin/python3", MAP, file, "--program", PROGRAM, "-o", "map", *words], capture_output=True,
                                text=True, check=False, cwd=self.folder, timeout=600)
        self.assertEqual(result.returncode, code, result.stderr)
        return result

    def table(self):
        with open(self.folder / "map/map.csv", encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))

    def test_partial_slip_ends_where_friction_does(self):
        """A body that forces drive slides where Q exceeds mu P (Cattaneo, Mindlin)."""
        result = self.map("--x", "normal=150,250,350", "--y", "tangential=60,100,140")
        rows = self.table()
        self.assertEqual(len(rows), 9)
        for row in rows:
            normal, tangential = float(row["normal"]), float(row["tangential"])
            self.assertEqual(row["regime"] == map_points.GROSS, tangential >= MU * normal, row)
            self.assertEqual(math.isnan(float(row["dissipation"])), tangential >= MU * normal)
            self.assertLess(float(row["stick_share"]), 1)
        self.assertIn("tangential amplitude (N) over normal load (N), 150 to 350", result.stdout)
        self.assertIn("G gross slip: 3", result.stdout)
        self.assertTrue((self.folder / "map/map.png").read_bytes().startswith(b"\x89PNG"))
        self.assertIn("9 points, 0 to run", self.map("--x", "normal=150,250,350", "--y", "tangential=60,100,140").stdout)

    def test_stick_zone_of_a_cylinder(self):
        """At the peak of the force it covers sqrt(1 - Q/(mu P)) of the contact (Cattaneo)."""
        self.map("--x", "normal=600,1200", "--y", "tangential=200,400", file=ROOT / "prm/rigs/cylinder_on_flat.prm",
                 settings=("Load program/Cycles=2",))
        rows = {(int(row["normal"]), int(row["tangential"])): row for row in self.table()}
        for (normal, tangential), row in rows.items():
            share = 1 - tangential / (0.6 * normal)
            self.assertEqual(row["regime"], map_points.PARTIAL if share > 0 else map_points.GROSS)
            if share > 0:
                self.assertAlmostEqual(float(row["stick_share"]), math.sqrt(share), delta=0.08)  # two nodes
        energy = {point: float(row["dissipation"]) for point, row in rows.items()}
        self.assertGreater(energy[600, 200], energy[1200, 200])
        self.assertGreater(energy[1200, 400], 4 * energy[1200, 200])

    def test_motion_slides_at_a_stroke(self):
        """A motion of nothing lets a flat cylinder stick at its middle, and a large one drives all of it along."""
        words = ("--x", "normal=2000,4000", "--y", "tangential=0,0.1")
        self.map(*words, file=ROOT / "prm/rigs/flat_on_flat.prm",
                 settings=("Obstacle/Kind=rigid", "Mesh/Core cells=2", "Mesh/Rings=2", "Mesh/Layers=2", "Mesh/Degree=1"))
        for row in self.table():
            self.assertEqual(row["regime"] == map_points.GROSS, row["tangential"] == "0.1", row)
            if row["tangential"] == "0.1":
                self.assertEqual(float(row["stick_share"]), 0)
                self.assertGreater(float(row["slip_ratio"]), 0.8)
                # A rigid slide: 2 mu P along every stroke of 2 amplitudes, but for the shear of the body.
                self.assertAlmostEqual(float(row["dissipation"]) / (4 * 0.1 * 0.3 * float(row["normal"])), 1, delta=0.3)

    def test_any_two_quantities(self):
        (self.folder / "s.prm").write_text(SCENE)
        self.map("--x", "mu=0.1,0.3", "--y", "Material/Poisson ratio=0.2,0.3", "--set", "Friction/Coefficients={mu}, {mu}",
                 "--picture", "own.svg", file="s.prm", settings=())
        self.assertEqual([(row["mu"], row["Material/Poisson ratio"]) for row in self.table()],
                         [("0.1", "0.2"), ("0.1", "0.3"), ("0.3", "0.2"), ("0.3", "0.3")])
        self.assertIn("<svg", (self.folder / "own.svg").read_text())

    def test_fatigue_and_wear(self):
        legs = "Load program/Legs=Fx {tangential} : 3 ; Fx -{tangential} : 5 ; Fx {tangential} : 5"  # takes the place of the file's
        self.map("--x", "normal=900,1200", "--y", "tangential=200,300", "--fatigue", "swt", file=ROOT / "prm/rigs/cylinder_on_flat.prm",
                 settings=(legs, "Wear/Law=archard", "Wear/Coefficient=1e-8"))
        rows = {(row["normal"], row["tangential"]): row for row in self.table()}
        self.assertGreater(float(rows["900", "300"]["swt"]), float(rows["900", "200"]["swt"]))
        self.assertGreater(float(rows["900", "300"]["worn_volume"]), float(rows["900", "200"]["worn_volume"]))
        self.assertGreater(float(rows["1200", "200"]["worn_volume"]), 0)

    def test_regimes(self):
        def regime(stick, slip, areas, share=0.9):
            steps = {"n_stick": stick, "n_slip": slip, "stick_area": areas, "contact_area": [1] * len(areas)}
            return map_points.regime_of({name: np.array(values) for name, values in steps.items()}, share)
        self.assertEqual(regime([5, 5], [0, 1], [1, 0.95]), map_points.STICK)
        self.assertEqual(regime([5, 5], [0, 1], [1, 0.95], 1), map_points.PARTIAL)
        self.assertEqual(regime([5, 4], [0, 1], [1, 0.8]), map_points.PARTIAL)
        self.assertEqual(regime([5, 0, 3], [0, 5, 2], [1, 0, 0.6]), map_points.GROSS)

    def test_wrong_maps_are_reported_in_a_line(self):
        (self.folder / "s.prm").write_text(SCENE)
        for words, says in ((("--x", "mu"), r"--x: 'mu': allowed is NAME=VALUES"), (("--x", "normal=1:x:2"), r"--x: '1:x:2': allowed"),
                            (("--y", "tangential=5"), r"two values and more"), (("--points", "3"), r"--points = 3"),
                            (("--x", "mu=1,2"), r"mu stands in no --set"), (("--y", "regime=1,2"), r"regime is a column"),
                            (("--x", "tangential"), r"both are tangential"), (("--jobs", "0"), r"--jobs = 0"),
                            (("--set", "Load program/Legs=rz 1 : 2"), r"tangential: .*allowed are legs with Fx or ux"),
                            (("--set", "Load program/Legs=Fx 9 : 2 ; Fx 4 : 2"), r"legs with one size of Fx"),
                            (("--stick-share", "2"), r"--stick-share = 2"), (("--picture", "map.pdf"), r"--picture map.pdf"), (("--nonsense",), r"--nonsense")):
            error = self.map(*words, settings=(), code=WRONG).stderr
            self.assertRegex(error, r"^fretting_map: .*\n$")
            self.assertRegex(error, says)
        error = self.map(file="s.prm", settings=(), code=WRONG).stderr
        self.assertRegex(error, r"^fretting_map: normal: Load program/Preload = : allowed are legs with Fz or uz .*\n$")
        self.assertRegex(self.map(file="none.prm", code=FILE_ERROR).stderr, r"^fretting_map: none.prm: No such file or directory\n$")
        self.assertFalse((self.folder / "map").exists())

    def test_points_that_fail_are_holes(self):
        (self.folder / "s.prm").write_text(SCENE)
        result = self.map("--x", "Contact solver/Maximum iterations=1,1000", "--y", "Material/Poisson ratio=0.2,0.3", file="s.prm",
                          settings=(), code=NOT_COMPLETE)
        self.assertIn("? not solved: 2", result.stdout)
        self.assertEqual([row["regime"] == "" for row in self.table()], [True, True, False, False])


if __name__ == "__main__":
    main()
