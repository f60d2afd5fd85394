# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The book of known answers (tools/verification): every row is within its bound, and its formulas are right.

Usage: test_book.py PROGRAM [unittest options]"""
import csv
import io
import math
import re
import subprocess
import sys
import tempfile
import unittest

import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
import program  # noqa: E402
from program import PROGRAM, ROOT  # noqa: E402

BOOK = ROOT / "tools/book"
sys.path[:0] = [str(BOOK), str(ROOT / "tools/studies")]
import paths  # noqa: E402, F401 (finds the modules of all studies)
import answers  # noqa: E402
import book  # noqa: E402
import loaded  # noqa: E402
import sheared  # noqa: E402
import spheres  # noqa: E402
import prism_mesh  # noqa: E402
import square_mesh  # noqa: E402
import strips  # noqa: E402
from row import Runs  # noqa: E402
from rows import CHAPTERS, ROWS  # noqa: E402

SCRATCH = tempfile.TemporaryDirectory()
RUNS = Runs(PROGRAM, SCRATCH.name)
PAGE = (ROOT / "docs/verification.md").read_text(encoding="utf-8")


def tearDownModule():
    SCRATCH.cleanup()


class RowsTest(unittest.TestCase):
    """A test of each chapter, so that its name says what fails."""

    def check(self, chapter):
        for row in CHAPTERS[chapter]:
            with self.subTest(row.id):
                ours = row.measured(RUNS, row.scene)
                self.assertTrue(row.passes(ours), f"{row.quantity}: {ours!r} is not {row.reference!r} within {row.bound}")
                if row.meshes:
                    self.assertGreaterEqual(row.order_of(RUNS), row.order)


for _chapter in CHAPTERS:
    setattr(RowsTest, f"test_{_chapter}", lambda self, chapter=_chapter: self.check(chapter))


class WrongScenesTest(unittest.TestCase):
    """Rows fail where the scene is another one."""

    def fails(self, row_id, *settings):
        row = next(row for row in ROWS if row.id == row_id)
        self.assertFalse(row.passes(row.measured(RUNS, row.scene.set(*settings))), row_id)

    def test_collinear_slip_fails_partial_slip_along_a_cylinder(self):
        for row in ("across.c", "across.traction", "across.back"):
            self.fails(row, "Friction/Slip potential=collinear")

    def test_another_modulus_radius_or_friction(self):
        self.fails("hertz.a", "Material/Young modulus=212000")
        self.fails("hertz.shear", "Material/Poisson ratio=0.25")
        self.fails("square.mises", "Material/Poisson ratio=0.2")
        self.fails("cone.approach", "Obstacle/Gap=0.0101*sqrt(x^2+y^2)")
        self.fails("line.p0", "Obstacle/Gap=x^2/(2*101)")
        self.fails("nafems.a", "Lower material/Young modulus=71000")
        self.fails("torsion.0.7", "Friction/Coefficients=0.31, 0.31")
        self.fails("squeezed.0.2", "Friction/Coefficients=0.205, 0.205")
        self.fails("cattaneo.c", "Friction/Coefficients=0.31, 0.31")
        self.fails("wedge.push", "Friction/Coefficients=0.201, 0.201")
        self.fails("pushed.5", "Material/Young modulus=130200")
        self.fails("warm.pressure", "Material/Thermal expansion=1.2001e-5")

    def test_another_bulk_stress(self):
        """It is the bulk stress that shifts what sticks, and turned about, it shifts it to the other side."""
        for bulk in (0, 90, -100):
            for row in ("fatigue.e", "fatigue.stress"):
                self.fails(row, f"Load program/Legs=Fx 155 bulk {bulk} : 1")

    def test_one_load_step_fails_what_friction_uses_up(self):
        self.fails("spence.35", "Friction/Coefficients=0, 0")
        one = sheared.SPENCE.set(sheared.legs_of_spence(1))
        self.assertLess(sheared.spence_stick(1)(RUNS, one), 0.3)


class FormulasTest(unittest.TestCase):
    """Each closed form against an integration that does not use it."""

    @staticmethod
    def pressed_by(pressure, a, power=1):
        """Force of an axisymmetric pressure: r = a sin(u) takes the root at the rim away."""
        return answers.integral(lambda u: 2 * math.pi * pressure(a * np.sin(u)) * a * a * np.sin(u)**power * np.cos(u), 0, math.pi / 2)

    def test_elliptic_integrals(self):
        for k in (0.1, 0.5, 0.9, 0.99):
            root = (lambda u, k=k: np.sqrt(1 - (k * np.sin(u))**2))
            first, second = answers.elliptic(k)
            self.assertAlmostEqual(first, answers.integral(lambda u: 1 / root(u), 0, math.pi / 2), delta=1e-7)
            self.assertAlmostEqual(second, answers.integral(root, 0, math.pi / 2), delta=1e-10)

    def test_pressures_carry_the_forces(self):
        sphere = spheres.STEEL
        self.assertAlmostEqual(self.pressed_by(sphere.pressure, sphere.contact_radius), sphere.force, delta=1e-8)
        a = spheres.QUARTIC_RADIUS
        self.assertAlmostEqual(self.pressed_by(lambda r: spheres.of_quartic(r, a), a), 1000, delta=1e-6)
        a = spheres.CONE_RADIUS
        whole = self.pressed_by(lambda r: spheres.E_STAR * 0.005 * np.arccosh(a / r), a)
        self.assertAlmostEqual(whole, 1000, delta=0.01)
        a, b, largest, _ = spheres.ELLIPSE
        self.assertAlmostEqual(2 / 3 * math.pi * a * b * largest, 1000, delta=1e-8)

    def test_ellipse_touches_where_its_pressure_bends_the_surface(self):
        """Chords of the half-ellipsoid at the angle u through the middle: its deflection there and its curvatures are integrals of
        p0 a b / E* over 1 / s and over sin^2 u / s^3, s^2 = b^2 cos^2 u + a^2 sin^2 u."""
        a, b, largest, approach = spheres.ELLIPSE
        factor = largest * a * b / spheres.E_STAR
        scale = (lambda u: np.sqrt((b * np.cos(u))**2 + (a * np.sin(u))**2))
        middle = factor * answers.integral(lambda u: 1 / scale(u), 0, math.pi / 2)
        self.assertAlmostEqual(middle / approach, 1, delta=1e-9)
        for part, radius in ((np.sin, 400), (np.cos, 100)):
            bent = factor * answers.integral(lambda u, part=part: part(u)**2 / scale(u)**3, 0, math.pi / 2)
            self.assertAlmostEqual(bent * 2 * radius, 1, delta=1e-7)

    def test_truncated_sphere(self):
        """Sneddon: g(x) = x times the integral of f'(r) / sqrt(x^2 - r^2), approach g(a), P = 2 E* times that of g(a) - g."""
        for force, (a, approach) in ((500, spheres.FIRST_FLAT), (3000, spheres.SECOND_FLAT)):
            # f' = r / 10 from b on; r^2 = x^2 - t^2.
            shape = (lambda x: x * answers.integral(lambda t: np.full_like(t, 0.1), 0, math.sqrt(max(0, x * x - 0.25))))
            self.assertAlmostEqual(shape(a), approach, delta=1e-12)
            grown = answers.integral(lambda s: np.array([2 * v * shape(0.5 + v * v) for v in s]), 0, math.sqrt(a - 0.5))
            self.assertAlmostEqual(2 * spheres.E_STAR * (a * approach - grown), force, delta=1e-4)

    def test_torsion(self):
        """Printed values, and the moment of a shear that is integrated: stiffness 16/3 G a^3 where c/a is next to 1."""
        sphere = sheared.SPHERE
        unit = sphere.mu * sphere.force
        a, shear = sphere.contact_radius, sphere.shear_modulus
        for c, rotation, moment in ((0.9, 0.03851388, 0.17634538), (0.7, 0.12343625, 0.40973848), (0.5, 0.22571186, 0.52857597)):
            self.assertAlmostEqual(sphere.rotation(c) * shear * a * a / unit, rotation, delta=1e-8)
            self.assertAlmostEqual(sphere.moment(c) / (unit * a), moment, delta=1e-8)
        self.assertAlmostEqual(sphere.moment(1 - 1e-5) / sphere.rotation(1 - 1e-5) / (16 / 3 * shear * a**3), 1, delta=1e-4)
        self.assertAlmostEqual(sphere.moment(1e-4) / (3 * math.pi / 16 * unit * a), 1, delta=1e-4)
        for c, loop in ((0.8, 0.01089990), (0.5, 0.15218641)):
            self.assertAlmostEqual(sphere.loop_of_torsion(c) * shear * a / unit**2, loop, delta=1e-8)
            # The same by rectangles, along the loop.
            ends = np.linspace(c, 1, 400)
            moments, turns = np.array([sphere.moment(x) for x in ends]), np.array([sphere.rotation(x) for x in ends])
            area = np.sum((moments[1:] + moments[:-1]) / 2 * (turns[:-1] - turns[1:]))
            self.assertAlmostEqual((8 * area - 4 * moments[0] * turns[0]) / sphere.loop_of_torsion(c), 1, delta=1e-3)

    def test_sheared_spheres_carry_their_force(self):
        for sphere, shear in ((sheared.SPHERE, sheared.Q), (sheared.SOFT_SPHERE, sheared.PULL)):
            outer = self.pressed_by(lambda r, s=sphere: s.mu * s.pressure(r), sphere.contact_radius)
            stick = sphere.stick_radius(shear)
            inner = self.pressed_by(lambda r, s=sphere, q=shear: s.mu * s.pressure(r) - s.traction(r, q), stick)
            self.assertAlmostEqual(outer - inner, shear, delta=1e-6)
            turns = np.linspace(-shear, shear, 4001)
            back = np.array([sphere.unloading_shift(shear, turn) for turn in turns])
            area = 2 * np.sum((back[1:] + back[:-1]) / 2 * np.diff(turns))
            self.assertAlmostEqual(area / sphere.loop_area(shear), 1, delta=1e-4)
        self.assertAlmostEqual(sheared.SOFT_SPHERE.shift(sheared.PULL), 0.0081724, delta=1e-6)

    def test_line_contact(self):
        for cylinder, shear in ((strips.PAIR, strips.ALONG / 2), (strips.CYLINDER, strips.PULL / 2)):
            a, stick = cylinder.half_width, cylinder.stick(shear)
            normal = answers.integral(lambda u: cylinder.circle(a * np.sin(u), a) / 0.3 * a * np.cos(u), -math.pi / 2, math.pi / 2)
            inner = answers.integral(lambda u: cylinder.circle(stick * np.sin(u), stick) * stick * np.cos(u), -math.pi / 2,
                                     math.pi / 2)
            self.assertAlmostEqual(normal, cylinder.force, delta=1e-8)
            self.assertAlmostEqual(0.3 * normal - inner, shear, delta=1e-8)
        self.assertAlmostEqual(strips.ROLLER.half_width, 6.21463, delta=1e-5)
        self.assertAlmostEqual(strips.ROLLER.largest_pressure, 3585.36, delta=5e-3)

    def test_fretted_pad(self):
        """Its friction carries the shear and strains what sticks by as much as half of the bulk stress, by principal values as
        below; the stress at the edge by the integral of friction(s) / (-a - s), where s = a sin u takes the root away."""
        for pad, known in ((loaded.fretted(10, 0.85), 543.19), (loaded.fretted(50, 0.85), 311.19), (loaded.fretted(50, 2.0), 446.40),
                           (loaded.fretted(30, 0.6, 200, 60), None)):
            a = pad.half_width
            u = np.pi * (np.arange(20000) + 0.5) / 20000 - np.pi / 2
            x, weight = a * np.sin(u), a * np.cos(u) * np.pi / 20000
            friction = pad.friction(x)
            self.assertAlmostEqual(np.sum(weight * friction), pad.shear, delta=1e-4)
            self.assertAlmostEqual(pad.bulk + 2 / math.pi * np.sum(weight * friction / (a + x)), pad.edge_stress, delta=1e-3)
            if known:
                self.assertAlmostEqual(pad.edge_stress, known, delta=5e-3)
            for place in (pad.shift, pad.shift - 0.6 * pad.stick(pad.shear), pad.shift + 0.5 * pad.stick(pad.shear)):
                here = pad.friction(place)
                value = np.sum(weight * (friction - here) / (place - x)) + here * math.log((a + place) / (a - place))
                self.assertAlmostEqual(value / math.pi / (pad.bulk / 4), 1, delta=2e-3)

    def test_height_of_a_specimen(self):
        """A wave of pressure cos k x on a strip -h < z < h, by the stress function (A cosh k z + B k z sinh k z) cos k x: the
        stress along x at the surface, less that of a half-plane, is what the formula integrates."""
        for t in (0.1, 1, 3):
            c, s = math.cosh(t), math.sinh(t)
            # z-stress -k^2 f = -1 and no shear k^2 (A s + B (s + t c)) = 0 at k z = t, with k = 1.
            first, second = np.linalg.solve([[c, t * s], [s, s + t * c]], [1, 0])
            along = first * c + second * (2 * c + t * s)
            self.assertAlmostEqual(along + 1, 2 * (2 * t) / (math.sinh(2 * t) + 2 * t), delta=1e-12)
        pad = loaded.fretted(50, 0.85, shear=0)
        x = np.linspace(1e-9, 60, 600001)
        grown = np.sum(x / (np.sinh(x) + x)) * (x[1] - x[0])
        self.assertAlmostEqual(pad.stress_of_height(20) / (pad.force / 20 * grown / math.pi), 1, delta=1e-4)

    def test_rounded_punch(self):
        """Its pressure carries its force and fits the punch: the slope of the surface, by the principal value of the pressure
        over x - s, is that of the edge."""
        punch = strips.EDGE
        for a, force in ((1.1, 355.8405), (1.25, 1473.8682)):
            self.assertAlmostEqual(punch.force(a), force, delta=1e-3)
            self.assertAlmostEqual(punch.half_width(force), a, delta=1e-6)
            x = a * np.sin(np.pi * (np.arange(2000) + 0.5) / 2000 - np.pi / 2)
            pressure, weight = np.array([punch.pressure(abs(s), a) for s in x]), np.pi / 2000 * np.sqrt(a * a - x * x)
            self.assertAlmostEqual(np.sum(weight * pressure) / force, 1, delta=1e-4)
            for place in (0.4, 1.06):
                here = punch.pressure(place, a)
                rest = np.sum(weight * (pressure - here) / (place - x)) + here * math.log((a + place) / (a - place))
                slope = 2 / (math.pi * punch.modulus) * rest
                self.assertAlmostEqual(slope, max(0, place - 1) / 10, delta=2e-5)

    def test_below_square(self):
        """By the stresses of Boussinesq's forces, spread over the square."""
        nodes, weights = np.polynomial.legendre.leggauss(60)
        x, y = np.meshgrid(nodes / 2, nodes / 2)
        area = np.outer(weights, weights) / 4
        for depth in (0.2, 0.4, 0.9):
            distance = np.sqrt(x * x + y * y + depth * depth)
            along = -np.sum(area * 3 * depth**3 / (2 * math.pi * distance**5))
            total = -np.sum(area * (1 + 0.28) * depth / (math.pi * distance**3))
            np.testing.assert_allclose(answers.below_square(depth, 0.28), (abs(along - (total - along) / 2), total / 3), rtol=1e-9)

    def test_the_mesh_of_the_square_is_the_one_that_is_made(self):
        self.assertEqual((ROOT / "prm/verification/pressed_square.msh").read_text(), square_mesh.text())

    def test_the_meshes_of_prisms_are_those_that_are_made(self):
        for name in prism_mesh.SHAPES:
            self.assertEqual((ROOT / f"prm/verification/{name}.msh").read_text(), prism_mesh.text(name))

    def test_deepest_shear(self):
        """Stresses on the axis by Boussinesq's and Flamant's point and line forces under Hertz' pressures."""
        def below(poisson, z):
            x, pressure, area = np.sin(angles), np.cos(angles), np.cos(angles)  # of unit contacts, x = sin u
            far = np.sqrt(x * x + z * z)
            if poisson is None:
                return np.sum(weights * pressure * area / math.pi * z * (z * z - x * x) / far**4)
            across = (1 - 2 * poisson) * z / far**3 - 3 * x * x * z / far**5
            return np.sum(weights * pressure * area * x * (3 * z**3 / far**5 + across / 2)) / 2

        for poisson, start in ((0.3, 0), (0.1, 0), (None, -math.pi / 2)):
            angles, weights = np.polynomial.legendre.leggauss(400)
            half = (math.pi / 2 - start) / 2
            angles, weights = start + half * (1 + angles), half * weights
            largest, depth = answers.deepest_shear(poisson)
            self.assertAlmostEqual(below(poisson, depth), largest, delta=1e-8)
            for near in (0.97, 1.03):
                self.assertLess(below(poisson, near * depth), largest)


class CommandTest(unittest.TestCase):
    def run_book(self, *words):
        return subprocess.run([sys.executable, "-B", BOOK / "book.py", f"--program={PROGRAM}", f"--output={SCRATCH.name}/book", *words],
                              text=True, capture_output=True, check=False)

    def test_csv(self):
        result = self.run_book("--csv", "patch", "box.motion")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        rows = list(csv.DictReader(io.StringIO(result.stdout)))
        self.assertEqual([row["id"] for row in rows], ["patch.least", "patch.largest", "patch.slip", "box.motion"])
        self.assertEqual(list(rows[0]), ["id", "quantity", "ours", "reference", "difference", "bound"])
        for row in rows:
            self.assertLessEqual(abs(float(row["ours"]) / float(row["reference"]) - 1), float(row["bound"]))

    def test_unknown_row_and_a_program_that_is_not_there(self):
        result = self.run_book("hetz")
        self.assertEqual(result.returncode, 2)
        self.assertIn("no row begins with 'hetz': --list names them", result.stderr)
        result = self.run_book("patch", "--program=/nowhere")
        self.assertEqual((result.returncode, result.stdout), (1, ""))
        self.assertIn("verification: /nowhere could not be started", result.stderr)

    def test_page_has_the_rows(self):
        self.assertGreaterEqual(len(ROWS), 40)
        self.assertEqual(len({row.id for row in ROWS}), len(ROWS))
        for name, rows in CHAPTERS.items():
            with self.subTest(name):
                text = re.search(rf"<!-- table {name}[^>]*-->\n(.*?)<!-- end {name} -->", PAGE, re.S)[1]
                for row, line in zip(rows, text.splitlines()[2:], strict=True):
                    cells = [cell.strip() for cell in line.strip("|").split("|")]
                    self.assertEqual(cells[:2] + [cells[3], cells[5]],
                                     [f"`{row.id}`", row.quantity, book.shown(row.reference), book.percent(row.bound)])


if __name__ == "__main__":
    program.main()
