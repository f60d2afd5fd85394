# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""One elastic body on another one: files of both, resumed runs, what --check says.

Usage: test_two_bodies.py PROGRAM [unittest options]"""
import json
import math
import sys

import meshio
import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
import program  # noqa: E402
from program import ROOT, main  # noqa: E402

FILE = ROOT / "prm/two_bodies/steel_on_aluminium.prm"
CYLINDER = ROOT / "prm/import/cylinder.msh"
SURFACES = ("Contact surface=base", "Held surface=top", "Symmetry surfaces=x0, y0")
SMALL = ["Mesh/Core cells=4", "Mesh/Rings=3", "Mesh/Layers=3", "Lower mesh/Core cells=2", "Lower mesh/Rings=4",
         "Lower mesh/Layers=3", "Load program/Legs=0 0 -0.1 : 2 ; 0.02 0 -0.1 : 2", "Output/Volume fields=1"]


# Two slabs, 1 mm thick, which cannot stretch along y: one is curved like a cylinder with a radius of 30 mm. In the plane both
# have 210000 MPa and 0.3.
STRIP = {"Geometry/Shape": "box", "Geometry/Sizes": "8, 1, 6", "Mesh/Cells": "28, 2, 8", "Mesh/Edge grading": "1.3",
         "Mesh/Layer grading": "0.55", "Mesh/Degree": "2", "Material/Law": "orthotropic",
         "Material/Young moduli": "230769.231, 2.1e9, 230769.231", "Material/Poisson ratios": "0, 0.428571429, 0",
         "Material/Shear moduli": "2.1e9, 80769.231, 2.1e9"}
LINE_CONTACT = {**STRIP, **{f"Lower {entry[0].lower()}{entry[1:]}": value for entry, value in STRIP.items()},
                "Obstacle/Kind": "body", "Obstacle/Gap": "x^2/60", "Friction/Coefficients": "0.5, 0.5",
                "Load program/Preload": "Fz -200 : 2", "Load program/Legs": "Fx 50 : 3", "Load program/Cycles": "1",
                "Output/Probes": ""}


class LineContactTest(program.RunTest):
    FILE = ROOT / "prm/paper/scene.prm"

    def test_slabs_that_one_direction_makes_stiff(self):
        """Moduli that differ 10000-fold leave Newton's method its digits. Pressure of Hertz's line contact,
        p0^2 = P E*/(pi R), to the 2 % of this mesh (Johnson, Contact Mechanics, 1985, section 4.2)."""
        settings = [f"{entry}={value}" for entry, value in LINE_CONTACT.items()]
        result = self.run_program("run", settings=settings)
        self.assertEqual(result.returncode, 0, result.stderr)
        pressure = math.sqrt(200 * 210000 / (2 * (1 - 0.3**2)) / (math.pi * 30))
        for row in self.rows("run")[2:]:
            self.assertLess(abs(float(row["max_pressure"]) / pressure - 1), 0.02)
            self.assertLess(float(row["residual"]), 1e-10)


class TwoBodiesTest(program.RunTest):
    FILE = FILE

    def run_well(self, name, *arguments, settings):
        result = self.run_program(name, *arguments, settings=settings)
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def body(self, name, kind, step):
        grid = meshio.read(self.folder / name / f"{kind}-{step:04}.vtu")
        return grid.points, grid.point_data

    def test_fields_of_both_bodies(self):
        """Both end where they are held; where they are pressed together their surfaces move alike."""
        self.run_well("run", settings=SMALL)
        for step, u_x in ((2, 0), (4, 0.02)):
            upper, of_upper = self.body("run", "volume", step)
            lower, of_lower = self.body("run", "lower", step)
            self.assertEqual((upper[:, 2].min(), upper[:, 2].max()), (0, 10))
            self.assertEqual((lower[:, 2].min(), lower[:, 2].max()), (-10, 0))
            np.testing.assert_allclose(of_upper["displacement"][upper[:, 2] == 10], [[u_x, 0, -0.1]] * int(
                np.sum(upper[:, 2] == 10)), atol=1e-8)
            self.assertEqual(np.abs(of_lower["displacement"][lower[:, 2] == -10]).max(), 0)
            on_axis = [u["displacement"][np.abs(x).max(axis=1) < 1e-9][0] for x, u in ((upper, of_upper),
                                                                                      (lower, of_lower))]
            np.testing.assert_allclose(*on_axis, atol=2e-4)  # the axis sticks
            # What gives way more is the softer one, by about the ratio of the moduli.
            self.assertLess(on_axis[1][2], -0.06)

    def test_forces_of_both_bodies_balance(self):
        """The stress at the held end of the lower one carries what the other one is pressed with."""
        settings = [*SMALL, "Lower mesh/Refinements=1", "Lower material/Poisson ratio=0", "Mesh/Model=full"]
        self.run_well("run", settings=settings)
        force = float(self.rows("run")[-1]["force_x"]), float(self.rows("run")[-1]["force_z"])
        grid = meshio.read(self.folder / "run/lower-0004.vtu")
        sums = np.zeros(2)
        for cell in grid.cells_dict["hexahedron"]:
            at_end = cell[grid.points[cell, 2] == -10]
            if len(at_end) == 4:
                x, y = grid.points[at_end, :2].T
                order = np.argsort(np.arctan2(y - y.mean(), x - x.mean()))
                x, y = x[order], y[order]
                area = abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))) / 2
                stress = grid.point_data["stress"][at_end].mean(axis=0).reshape(3, 3)
                sums += area * stress[2, [0, 2]]
        self.assertAlmostEqual(abs(sums[1]) / abs(force[1]), 1, delta=0.05)
        self.assertAlmostEqual(abs(sums[0]) / abs(force[0]), 1, delta=0.1)

    def test_killed_runs_go_on(self):
        settings = [*SMALL, "Output/Checkpoint=0"]
        self.run_well("whole", settings=settings)
        for seconds in (0.3, 0.6):
            self.kill_after("killed", settings, seconds, file=FILE)
        self.run_well("killed", "--resume", settings=settings)
        names = sorted(file.name for file in (self.folder / "whole").iterdir())
        self.assertEqual(names, sorted(file.name for file in (self.folder / "killed").iterdir()))
        for name in (name for name in names if name.endswith((".vtu", ".pvd")) or name == "history.csv"):
            self.assertEqual((self.folder / "whole" / name).read_bytes(), (self.folder / "killed" / name).read_bytes(), name)

    def test_lost_fields_of_the_lower_body_are_found(self):
        settings = [*SMALL, "Output/Checkpoint=0"]
        self.run_well("run", settings=settings)
        (self.folder / "run/lower-0002.vtu").unlink()
        result = self.run_program("run", "--resume", settings=[*settings, "Load program/Cycles=2"])
        self.assertEqual(result.returncode, 4)
        self.assertRegex(result.stderr, r"lower-0002\.vtu: is missing")

    def test_an_imported_body_below(self):
        """The paper's cylinder, meshed by gmsh or by the program, under a smaller one."""
        small = [*SMALL[:3], "Geometry/Radius=8", "Load program/Legs=0 0 -0.1 : 1"]
        self.run_well("own", settings=[*small, "Lower mesh/Refinements=1", *SMALL[3:6]])
        self.run_well("file", settings=[*small, "Lower geometry/Shape=file", f"Lower geometry/Mesh file={CYLINDER}",
                                        *(f"Lower geometry/{entry}" for entry in SURFACES)])
        own, file = (float(self.rows(name)[-1]["force_z"]) for name in ("own", "file"))
        self.assertAlmostEqual(file / own, 1, delta=0.02)

    def test_check_draws_up_both(self):
        result = self.run_program("run", "--check", settings=SMALL)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertIn("obstacle       elastic body (cylinder, radius 10 mm, height 10 mm), E 70000 MPa, nu 0.33\n",
                      result.stdout)
        self.assertRegex(result.stdout, r"\nlower mesh     \d+ hexahedra of degree 2, \d+ unknowns, \d+ contact nodes\n")
        self.assertFalse((self.folder / "run").exists())

    IMPORTED = [*SMALL[:3], "Geometry/Radius=8", "Load program/Legs=0 0 -0.1 : 1", "Lower geometry/Shape=file",
                *(f"Lower geometry/{entry}" for entry in SURFACES), "Lower mesh/Refinements=1"]
    FACETS = "Lower mesh/Refinements: the cells of the file have plane faces"

    def test_check_draws_up_an_imported_lower_body(self):
        result = self.run_program("run", "--check", settings=[*self.IMPORTED, f"Lower geometry/Mesh file={CYLINDER}"])
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        for line in (r"lower mesh file      \S+cylinder\.msh", r"lower volume         body \(5\): 88 cells, 780\.361 mm\^3",
                     r"lower surface        base \(1\): 22 faces, 78\.0361 mm\^2", r"lower worst cell     at \(.*\) mm, scaled",
                     r"lower contact height 0 to 0 mm above z = 0", f"warning: {self.FACETS}"):
            self.assertRegex(result.stdout, rf"(?m)^{line}")
        self.assertNotRegex(result.stdout, r"(?m)^(mesh file|warning: Mesh)")

    def test_runs_warn_of_an_imported_lower_body(self):
        """Kept are the file's facets. Another mesh in the same file is another scene."""
        mesh = self.folder / "own.msh"
        text = CYLINDER.read_text(encoding="ascii")
        mesh.write_text(text, encoding="ascii")
        settings = [*self.IMPORTED, f"Lower geometry/Mesh file={mesh}", "Lower mesh/Degree=1"]
        self.run_well("run", settings=settings)
        self.assertIn(f"warning: {self.FACETS}", (self.folder / "run/log.txt").read_text(encoding="utf-8"))
        warnings = json.loads((self.folder / "run/summary.json").read_text(encoding="utf-8"))["warnings"]
        self.assertEqual([warning[:len(self.FACETS)] for warning in warnings if "is ignored" not in warning], [self.FACETS])
        self.run_well("run", "--resume", settings=settings)
        mesh.write_text(text.replace("\n10 0 10\n", "\n10 0 10.5\n"), encoding="ascii")
        result = self.run_program("run", "--resume", settings=settings)
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, r"Lower geometry/Mesh file = \S+own\.msh: has other content than when the run in ")

    def test_entries_without_a_lower_body_are_warned_of(self):
        result = self.run_program("run", "--check", settings=["Obstacle/Kind=rigid"])
        self.assertIn("warning: Lower material/Young modulus = 70000 is ignored with Obstacle/Kind = rigid\n",
                      result.stdout)


if __name__ == "__main__":
    main()
