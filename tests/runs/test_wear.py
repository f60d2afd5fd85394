# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Surfaces that wear: known answers, jumps over cycles, resumed runs, warnings.

Usage: test_wear.py PROGRAM [unittest options]"""
import math
import random
import sys
import time

import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
import program  # noqa: E402
from program import ROOT, main  # noqa: E402

sys.path.insert(0, str(ROOT / "tools/studies"))
import paths  # noqa: E402, F401 (finds the modules of all studies)
import run_folder  # noqa: E402

SPHERE = ROOT / "prm/verification/worn_sphere.prm"
FRETTING = ROOT / "prm/verification/fretting_wear.prm"
PUNCH = ROOT / "prm/verification/worn_punch.prm"
SMALL = ["Mesh/Degree=1", "Mesh/Layers=6", "Material/Poisson ratio=0.3", "Mesh/Volumetric quadrature=full",
         "Load program/Cycles=20000"]


class WearTest(program.RunTest):
    def worn(self, name, file, *settings):
        """Rows of cycles.csv as numbers."""
        result = self.run_program(name, settings=settings, file=file)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return [{key: float(value) for key, value in row.items()} for row in self.rows(name, "cycles.csv")]

    def test_worn_room_is_a_cap_of_the_sphere(self):
        rows = self.worn("run", SPHERE, "Output/Contact fields=8")
        self.assert_cap_of_radius_a(rows)
        for row in rows:
            self.assertAlmostEqual(row["worn_volume"] / (1e-3 * 20 * 4 * row["cycle"]), 1, delta=1e-5)
        cap = math.pi * 100 * rows[-1]["max_wear_depth"]**2
        self.assertAlmostEqual(rows[-1]["worn_volume"] / cap, 1, delta=0.01)
        self.assertNotIn("flickers", self.text("run", "log.txt"))

    def assert_cap_of_radius_a(self, rows):
        """V = pi a^4 / (4 R) in every cycle, so that a^4 grows as the way does. a is where the depth, which is linear in
        r^2, vanishes: that is between nodes. The area in contact jumps by whole nodes, by 5 % here."""
        volumes, of_rim, of_area = np.array([row["worn_volume"] for row in rows]), [], []
        for row in rows:
            contact = run_folder.RunFolder(self.folder / "run").contact(8 + 80 * int(row["cycle"]))
            radius, depth, pressure = np.hypot(*contact.points[:, :2].T), contact["wear_depth"], contact["pressure"]
            slope, middle = np.polyfit(radius[depth > 0]**2, depth[depth > 0], 1)
            rim, touching = math.sqrt(-middle / slope), pressure > 0
            self.assertLess(radius[depth > 0].max(), 1.01 * rim)
            self.assertGreater(radius[depth == 0].min(), 0.99 * rim)
            of_rim.append(math.pi * rim**4 / 400)
            of_area.append(np.sum(contact["nodal_force"][touching, 2] / pressure[touching])**2 / (400 * math.pi))
        np.testing.assert_allclose(of_rim, volumes, rtol=0.025)
        self.assertAlmostEqual(np.polyfit(np.log(volumes), np.log(of_rim), 1)[0], 1, delta=0.01)
        np.testing.assert_allclose(of_area, volumes, rtol=0.2)
        self.assertAlmostEqual(np.mean(of_area / volumes), 1, delta=0.04)

    def text(self, name, file):
        return (self.folder / name / file).read_text()

    def test_steps_that_wear_too_deep_are_warned_of(self):
        self.worn("run", SPHERE, "Wear/Coefficient=0.01", "Load program/Cycles=1", "Wear/Deep steps=explicit")
        self.assertRegex(self.text("run", "log.txt"), r"warning: load step \d+: wears a node [\d.]+ times as deep as")

    def test_strokes_far_longer_than_the_contact(self):
        """A pin on a disc: Archard's volume coefficient x force x way, and the depth of the cap that has it, 2 pi R h^2 / 2.
        Steps of 50 mm wear a hundred times as deep as pressure flattens, by the energy law as by Archard's."""
        pin = ["Mesh/Core cells=8", "Mesh/Rings=5", "Mesh/Layers=4", "Mesh/Degree=1", "Geometry/Radius=2", "Geometry/Height=4",
               "Mesh/Core ratio=0.2", "Obstacle/Gap=(x^2+y^2)/20", "Material/Young modulus=2e5", "Material/Poisson ratio=0.3",
               "Friction/Coefficients=0.3, 0.3", "Load program/Preload=Fz -30 : 2", "Load program/Cycles=3",
               "Load program/Legs=ux 100 : 2 ; ux 0 : 2"]
        for law, coefficient in (("archard", 2e-7), ("energy", 2e-7 / 0.3)):
            row = self.worn(law, SPHERE, *pin, f"Wear/Law={law}", f"Wear/Coefficient={coefficient}")[-1]
            volume = 2e-7 * 30 * 600
            self.assertAlmostEqual(row["worn_volume"] / volume, 1, delta=1e-4)
            self.assertAlmostEqual(row["max_wear_depth"] / math.sqrt(volume / (10 * math.pi)), 1, delta=0.05)
            self.assertNotIn("flickers", self.text(law, "log.txt"))

    def test_pressure_of_a_dragged_punch_becomes_even(self):
        """Friction tilts the pressure; where more is carried more is worn, until all of it is 10 MPa."""
        self.worn("run", PUNCH)
        rows = self.rows("run")
        largest = [float(row["max_pressure"]) for row in rows[1:]]
        self.assertGreater(largest[0], 15)
        self.assertEqual(largest, sorted(largest, reverse=True))
        self.assertAlmostEqual(largest[-1], 10, delta=1e-3)
        self.assertAlmostEqual(float(rows[-1]["worn_volume"]) / 40, 1, delta=1e-4)
        contact = run_folder.RunFolder(self.folder / "run").contact(401)
        self.assertAlmostEqual(contact["pressure"].min(), 10, delta=2e-3)

    def test_energy_law_holds_over_jumps(self):
        rows = self.worn("run", FRETTING, *SMALL, "Wear/Law=energy", "Wear/Coefficient=1e-5")
        self.assertGreater(max(row["n_cycles"] for row in rows), 20)
        for row in rows:
            self.assertAlmostEqual(row["worn_volume"] / (1e-5 * row["total_dissipation"]), 1, delta=1e-9)

    def test_jumps_err_by_less_than_they_say(self):
        short = self.worn("short", FRETTING, *SMALL, "Wear/Largest depth of a jump=5e-6")[-1]
        long = self.worn("long", FRETTING, *SMALL)[-1]
        difference = abs(long["worn_volume"] - short["worn_volume"])
        self.assertLess(difference, 0.01 * short["worn_volume"])
        self.assertLess(difference, 1.5 * (abs(long["wear_error"]) + abs(short["wear_error"])))

    def test_contact_retreats_to_what_sticks(self):
        """Popov 2014: the annulus that slips carries nothing in the end, the circle that sticks never wears. What the
        annulus carries decays with the cycles. The border of the circle is known to a node."""
        last = 800016
        self.worn("run", FRETTING, f"Output/Contact fields={last}")
        first = next(row for row in self.rows("run") if row["cycle"] == "1" and row["phase"] == "3")
        stick = math.sqrt(float(first["stick_area"]) / math.pi)
        contact = run_folder.RunFolder(self.folder / "run").contact(last)
        radius, pressure, depth = np.hypot(*contact.points[:, :2].T), contact["pressure"], contact["wear_depth"]
        force, outside = contact["nodal_force"][:, 2], radius > stick
        self.assertLess(pressure[outside].max(), 2e-5 * pressure.max())
        self.assertLess(force[outside].sum(), 5e-6 * force.sum())
        spacing = 0.07  # of the nodes, mm
        edge = radius[pressure > 1e-4 * pressure.max()].max()
        self.assertLess(edge, stick)
        self.assertGreater(edge, stick - spacing)
        self.assertLess(depth[radius < stick - 1.5 * spacing].max(), 0.01 * depth.max())
        self.assertGreater(pressure[radius < stick - 1.5 * spacing].min(), 0.5 * pressure.max())

    def test_killed_runs_go_on(self):
        """The same bytes, also of the depths at every node."""
        settings = [*SMALL, "Load program/Cycles=4000", "Output/Checkpoint=0", "Output/Contact fields=8"]
        start = time.monotonic()
        self.worn("whole", FRETTING, *settings)
        seconds, moments = time.monotonic() - start, random.Random(7)
        for _ in range(3):
            self.kill_after("killed", settings, moments.uniform(0.2, 0.7) * seconds, file=FRETTING)
        result = self.run_program("killed", "--resume", settings=settings, file=FRETTING)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        fields = sorted(file.name for file in (self.folder / "whole").glob("contact-*.vtu"))
        self.assertEqual(fields, sorted(file.name for file in (self.folder / "killed").glob("contact-*.vtu")))
        self.assertGreater(run_folder.ContactFile(self.folder / "whole" / fields[-1])["wear_depth"].max(), 1e-5)
        self.assert_same_files("whole", "killed", ["history.csv", "checks.csv", "cycles.csv", "contact.pvd", *fields])


if __name__ == "__main__":
    main()
