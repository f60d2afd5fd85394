# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""How the studies evaluate contact files between their nodes: polynomials are reproduced.

Usage: test_studies.py PROGRAM [unittest options]"""
import pathlib
import sys

import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
from program import ROOT, SMALL, RunTest, main  # noqa: E402

sys.path[:0] = [str(ROOT / "tools/plots"), str(ROOT / "tools/studies")]
import contact_surface  # noqa: E402
from run_folder import ContactFile  # noqa: E402

SINGLE = 1e-6  # the files hold single precision
POINTS, WEIGHTS = contact_surface.quarter_rule()


class ContactSurfaceTest(RunTest):
    def contact_file(self, degree, model):
        settings = [*SMALL, f"Mesh/Degree={degree}", f"Mesh/Model={model}", "Load program/Legs=0 0 -0.1 : 1",
                    "Load program/Cycles=1", "Output/Volume fields=0"]
        finished = self.run_program("run", settings=settings, file=ROOT / "prm/paper/case_a.prm")
        self.assertEqual(finished.returncode, 0, finished.stderr)
        return ContactFile(pathlib.Path(self.folder) / "run/contact-0001.vtu")

    def test_solid_points_are_found_where_they_are(self):
        """Positions are polynomials of the degree of the cells; so every point inside has to find itself."""
        for degree in (1, 2, 3):
            for model in ("quarter", "full"):
                with self.subTest(degree=degree, model=model):
                    file = self.contact_file(degree, model)
                    file.data["place"] = file.points
                    file.data["plane"] = 3 + file.points @ [1., -2., 0.]
                    surface = contact_surface.SolidSurface(file)
                    inside = POINTS[np.linalg.norm(POINTS, axis=1) < 7]
                    surface.locate(inside)
                    self.assertLess(np.abs(surface["place"][:, :2] - inside).max(), 10 * SINGLE)
                    self.assertLess(np.abs(surface["plane"] - 3 - inside @ [1., -2.]).max(), 30 * SINGLE)

    def test_solid_points_beyond_the_chords_take_the_rim(self):
        surface = contact_surface.SolidSurface(self.contact_file(1, "quarter"))
        surface.locate(POINTS)
        sagitta = contact_surface.RADIUS * (1 - np.cos(np.pi / 8))  # of 8 chords
        self.assertLess(surface.distance.max(), 1.01 * sagitta)  # the nearest place but for a skew cell

    def test_solid_polynomials_of_the_cells_are_reproduced(self):
        """On the core's cells, which are squares, any polynomial of their degree, from Gauss-Lobatto nodes."""
        file = self.contact_file(3, "quarter")
        file.data["cubic"] = file.points[:, 0]**3 - file.points[:, 0] * file.points[:, 1]**2
        surface = contact_surface.SolidSurface(file)
        core = POINTS[(POINTS < 3.5).all(axis=1)]  # the core's half side is 5 / sqrt(2)
        surface.locate(core)
        self.assertLess(np.abs(surface["cubic"] - core[:, 0]**3 + core[:, 0] * core[:, 1]**2).max(), 100 * SINGLE)

    def test_revolved_polynomials_are_reproduced(self):
        for degree in (1, 2, 3, 4):
            with self.subTest(degree=degree):
                file = self.contact_file(degree, "axisymmetric")
                radius = np.linalg.norm(file.points, axis=1)
                file.data["power"] = (radius / 10)**degree
                file.data["vector"] = file.points.copy()
                surface = contact_surface.RevolvedSurface(file)
                surface.locate(POINTS)
                true = (np.linalg.norm(POINTS, axis=1) / 10)**degree
                self.assertLess(np.abs(surface["power"] - true).max(), 10 * SINGLE)
                self.assertLess(np.abs(surface["vector"][:, :2] - POINTS).max(), 30 * SINGLE)

    def test_norms_of_known_fields(self):
        self.assertAlmostEqual(WEIGHTS.sum() / (25 * np.pi), 1, 12)
        ones = np.ones(len(WEIGHTS))
        self.assertAlmostEqual(contact_surface.relative_l2(1.5 * ones, ones, WEIGHTS), 0.5, 12)
        # the norm of x - y on the quarter disc, relative to that of the radius: 1 - 2 <xy>/<r r> = 1 - 2/pi
        difference = contact_surface.relative_l2(POINTS[:, [1, 0]], POINTS, WEIGHTS)
        self.assertAlmostEqual(difference**2, 2 - 4 / np.pi, 6)


if __name__ == "__main__":
    main()
