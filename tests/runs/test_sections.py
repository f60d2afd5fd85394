# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Sections: torsion with the twist, plane strain with and without u_y, and the files that they write.

Usage: test_sections.py PROGRAM [unittest options]"""
import math
import sys

import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
import program  # noqa: E402
from program import ROOT  # noqa: E402

sys.path.insert(0, str(ROOT / "tools/studies"))
import paths  # noqa: E402, F401 (finds the modules of all studies)
import run_folder  # noqa: E402

VERIFICATION = ROOT / "prm/verification"
FORCE, THICKNESS, HALF_WIDTH = 453.11435, 2, 0.5
LARGEST = 2 * FORCE / (math.pi * HALF_WIDTH)


class SectionTest(program.RunTest):
    def done(self, name, *settings):
        """Rows of the history, numbers where they are; standard error is returned, too."""
        result = self.run_program("run", settings=settings, file=VERIFICATION / f"{name}.prm")
        self.assertEqual(result.returncode, 0, result.stderr)
        return [{key: float(value) for key, value in row.items() if key not in ("method", "driven")}
                for row in self.rows("run")], result.stderr

    def log(self):
        return (self.folder / "run/log.txt").read_text(encoding="utf-8")

    def line(self, step):
        """Places along x and fields at the contact nodes of one side of the strip, in their order."""
        contact = run_folder.RunFolder(self.folder / "run").contact(step)
        side = np.flatnonzero(contact.points[:, 1] < -THICKNESS / 2 + 1e-6)
        side = side[np.argsort(contact.points[side, 0])]
        return contact.points[side, 0], {name: contact[name][side] for name in ("pressure", "friction_traction", "slip")}


class TorsionTest(SectionTest):
    """Lubkin's torsion of a pressed sphere."""

    def test_partial_slip_and_reversal(self):
        rows, _ = self.done("pressed_sphere_in_torsion")
        self.assertIn("model          axisymmetric with twist", self.log())
        shear, force, mu, a = 210000 / (2 * 1.4999), 466.6, 0.3, 0.5
        unit = mu * force / (shear * a * a)
        of_body = 10 / (shear * math.pi / 2 * 10**4)
        for row, moment, rotation in ((3, 0.17634538, 0.03851388), (6, 0.40973848, 0.12343625), (9, 0.52857597, 0.22571186)):
            given = -rows[row]["moment_z"]
            self.assertAlmostEqual(given / (moment * mu * force * a), 1, delta=1e-5)
            self.assertAlmostEqual((math.radians(rows[row]["rz"]) - of_body * given) / (unit * rotation), 1, delta=0.005)
        loop = rows[-1]["total_dissipation"] - rows[9]["total_dissipation"]
        self.assertAlmostEqual(loop / (0.15218641 * mu**2 * force**2 / (shear * a)), 1, delta=0.01)


class LineContactTest(SectionTest):
    def test_hertz(self):
        rows, _ = self.done("line_contact")
        self.assertIn("model          plane strain, half (u_y is 0", self.log())
        self.assertAlmostEqual(rows[-1]["force_z"] / (FORCE * THICKNESS), 1, delta=1e-9)
        x, fields = self.line(1)
        inside = np.abs(x) < 0.9 * HALF_WIDTH
        exact = LARGEST * np.sqrt(1 - (x[inside] / HALF_WIDTH) ** 2)
        self.assertLess(np.abs(fields["pressure"][inside] - exact).max(), 0.01 * LARGEST)
        self.assertAlmostEqual(fields["pressure"].max() / LARGEST, 1, delta=0.003)
        self.assertEqual(fields["pressure"][np.abs(x) > 1.08 * HALF_WIDTH].max(), 0)

    def largest_shear(self, *settings):
        """(sigma_1 - sigma_3) / 2 on the axis, means over the elements that meet at a node."""
        self.done("line_contact", "Output/Volume fields=1", *settings)
        file = run_folder.RunFolder(self.folder / "run").contact(1, "volume")
        on_axis = np.flatnonzero(np.abs(file.points[:, 0]) < 1e-9)
        depth = np.round(file.points[on_axis, 2], 6)
        shear = np.ravel(file["principal_stress_1"] - file["principal_stress_3"])[on_axis] / 2
        return max(shear[depth == z].mean() for z in set(depth))

    def test_stress_below_the_surface(self):
        """Hertz: 0.3003 of the largest pressure. The body is no half-plane, which adds a stress of P'/height."""
        low = self.largest_shear()
        high = self.largest_shear("Geometry/Sizes=40, 2, 20", "Mesh/Edge grading=1.18", "Mesh/Layer grading=0.64")
        self.assertGreater(low, high)
        self.assertAlmostEqual((2 * high - low) / LARGEST, 0.3003, delta=0.003)

    def test_orthotropic_partial_slip(self):
        """Exact for every Poisson's ratio: the shear out of the plane does not see the pressure."""
        stick = 0.6 * HALF_WIDTH
        for poisson in (0.1, 0.3, 0.45):
            modulus = 210000 * (1 - poisson**2) / (1 - 0.3**2)
            rows, _ = self.done("orthotropic_line_contact", f"Material/Poisson ratio={poisson}",
                                       f"Material/Young modulus={modulus!r}")
            self.assertIn("with u_y (u_y is modelled because the load program", self.log())
            self.assertAlmostEqual(rows[5]["force_y"], -173.9959, delta=1e-5)
            for step, sign in ((6, -1), (14, 1)):
                x, fields = self.line(step)
                inside = np.abs(x) < 0.9 * HALF_WIDTH
                exact = np.sqrt(np.maximum(0, 1 - (x / HALF_WIDTH) ** 2))
                exact -= stick / HALF_WIDTH * np.sqrt(np.maximum(0, 1 - (x / stick) ** 2))
                traction = sign * fields["friction_traction"][:, 1]
                self.assertLess(np.abs(traction - 0.3 * LARGEST * exact)[inside].max(), 0.02 * 0.3 * LARGEST)
                along = np.abs(fields["slip"][:, 1])
                self.assertLess(along[np.abs(x) < 0.9 * stick].max(), 1e-6 * along.max())


if __name__ == "__main__":
    program.main()
