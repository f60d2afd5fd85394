# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Fatigue parameters of tools/fatigues beside closed forms: bars, shear paths with known circles, strips and Hertz' contact.
test_fatigue_tool.py has runs.

Usage: test_fatigue.py PROGRAM [unittest options]"""
import pathlib
import sys
import types
import unittest

import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path[:0] = [str(ROOT / "tools/fatigues"), str(ROOT / "tools/runs")]
import fields  # noqa: E402
import material  # noqa: E402
from below import Below  # noqa: E402
from criteria import (  # noqa: E402
    FatemiSocie, Findley, SmithWatsonTopper, crossland, dang_van, on_critical_planes, ruiz, shear_amplitude)
from critical_distance import along_line, below_surface  # noqa: E402
from cycle_stresses import Body  # noqa: E402
from edges import edge_stress  # noqa: E402
from enclosing_ball import enclosing_balls  # noqa: E402
from fatigue_vtu import text_of_vtu  # noqa: E402
from run_folder import Vtu  # noqa: E402
from stresses import deviatoric, of_deviatoric, of_tensors, tensors  # noqa: E402

YOUNG, POISSON, YIELD = 72100.0, 0.33, 350.0
TURN = 2 * np.pi * np.arange(48) / 48
XX, YY, ZZ, XY, XZ, YZ = range(6)
INTO_SPECIMEN = Below.plane(np.zeros((1, 3)), -1)


def history(**components):
    """(1, steps, 6) of {component: (steps,)}."""
    steps = max(len(values) for values in components.values())
    stress = np.zeros((1, steps, 6))
    for name, values in components.items():
        stress[0, :, ("xx", "yy", "zz", "xy", "xz", "yz").index(name)] = values
    return stress


def rotations(n, seed=3):
    return [np.linalg.qr(matrix)[0] for matrix in np.random.default_rng(seed).normal(size=(n, 3, 3))]


class EnclosingTest(unittest.TestCase):
    """Paths whose circle is known."""

    def test_circles_of_paths(self):
        square = np.array([[-3, -2], [3, -2], [3, 2], [-3, 2]]) + [7, -5]
        sides = np.concatenate([np.linspace(one, other, 9) for one, other in zip(square, np.roll(square, 1, axis=0))])
        ring = 4 * np.stack([np.cos(TURN), np.sin(TURN)], axis=1)
        triangle = 2 * np.stack([np.cos(TURN[::16]), np.sin(TURN[::16])], axis=1)
        for path, radius in ((sides, np.hypot(3, 2)), (ring + 1, 4), (triangle, 2), (ring * [1, 0.3], 4), (ring[:13] + 5, 4 / np.sqrt(2)),
                             (np.outer(np.linspace(-1, 2, 7), [3, 4]), 7.5), (np.ones((5, 2)), 0)):
            self.assertAlmostEqual(float(shear_amplitude(path)), radius, delta=1e-9)

    def test_balls_hold_all_points_and_none_is_smaller(self):
        """Of the smallest ball, no half has all of the points on its border."""
        paths = np.random.default_rng(1).normal(size=(200, 30, 5))
        paths[:50, :, 2:] = 0
        centres, radii = enclosing_balls(paths)
        ways = paths - centres[:, None]
        lengths = np.linalg.norm(ways, axis=2)
        np.testing.assert_allclose(lengths.max(axis=1), radii, rtol=1e-9)
        for way, length, radius in zip(ways, lengths, radii):
            border = way[length > radius * (1 - 1e-7)]
            shares, residual = np.linalg.lstsq(np.vstack([border.T, np.ones(len(border))]), [0] * 5 + [1], rcond=None)[:2]
            self.assertGreater(shares.min(), -1e-6)
            self.assertLess(np.sum(residual), 1e-10)

    def test_deviators(self):
        stress = np.random.default_rng(2).normal(size=(50, 6))
        matrices = tensors(stress)
        deviators = matrices - np.trace(matrices, axis1=1, axis2=2)[:, None, None] / 3 * np.eye(3)
        np.testing.assert_allclose((deviatoric(stress)**2).sum(axis=1), (deviators**2).sum(axis=(1, 2)) / 2)
        np.testing.assert_allclose(tensors(of_deviatoric(deviatoric(stress))), deviators, atol=1e-14)


class BarTest(unittest.TestCase):
    """Bars by hand."""
    SIZE, MEAN, K = 200.0, 60.0, 0.26

    def assert_plane(self, criterion, stress, value, normal):
        """The value within 0.1 %, the normal within 1 degree (up to its sign)."""
        found, plane = on_critical_planes(criterion, stress)
        self.assertAlmostEqual(found[0] / value, 1, delta=1e-3)
        self.assertGreater(max(abs(plane[0] @ one) for one in np.reshape(normal, (-1, 3))), np.cos(np.radians(1)))

    def test_tension(self):
        size, mean, k = self.SIZE, self.MEAN, self.K
        bar = history(xx=mean + size * np.sin(TURN))
        self.assert_plane(SmithWatsonTopper(YOUNG, POISSON), bar, (mean + size) * size / YOUNG, [1, 0, 0])
        reversed_bar = history(xx=size * np.sin(TURN))
        found, plane = on_critical_planes(Findley(k), reversed_bar)
        self.assertAlmostEqual(found[0] / (size / 2 * (k + np.sqrt(1 + k**2))), 1, delta=1e-5)
        self.assertAlmostEqual(np.degrees(np.arccos(abs(plane[0, 0]))), np.degrees(np.arctan(1 / k)) / 2, delta=0.5)
        angles = np.radians(np.arange(0, 90, 0.01))
        shear, normal = size / 2 * np.sin(2 * angles), (mean + size) * np.cos(angles)**2
        values = shear * 2 * (1 + POISSON) / YOUNG * (1 + normal / YIELD)
        found, plane = on_critical_planes(FatemiSocie(YOUNG, POISSON, YIELD, 1), bar)
        self.assertAlmostEqual(found[0] / values.max(), 1, delta=1e-5)
        self.assertAlmostEqual(np.arccos(abs(plane[0, 0])), angles[np.argmax(values)], delta=np.radians(0.5))
        self.assertAlmostEqual(crossland(bar, 0.2)[0], size / np.sqrt(3) + 0.2 * (mean + size) / 3)
        self.assertAlmostEqual(dang_van(bar, 0.3)[0], size / 2 + 0.3 * (mean + size) / 3)

    def test_torsion(self):
        size, k = self.SIZE, self.K
        for pair, normals in (("xy", [[1, 1, 0], [1, -1, 0]]), ("xz", [[1, 0, 1], [1, 0, -1]]), ("yz", [[0, 1, 1], [0, 1, -1]])):
            bar = history(**{pair: size * np.sin(TURN)})
            self.assert_plane(SmithWatsonTopper(YOUNG, POISSON), bar, size**2 * (1 + POISSON) / YOUNG, np.array(normals) / np.sqrt(2))
            self.assertAlmostEqual(on_critical_planes(Findley(k), bar)[0][0] / (size * np.sqrt(1 + k**2)), 1, delta=1e-5)
            self.assertAlmostEqual(crossland(bar, 0.2)[0], size)
            self.assertAlmostEqual(dang_van(bar, 0.3)[0], size)

    def test_plane_strain(self):
        """The strain of a bar that is held along y is smaller by nu^2; compression has no SWT parameter."""
        size = self.SIZE * np.sin(TURN)
        self.assert_plane(SmithWatsonTopper(YOUNG, POISSON), history(xx=size, yy=POISSON * size),
                          self.SIZE**2 * (1 - POISSON**2) / YOUNG, [1, 0, 0])
        pressed = history(xx=size - self.SIZE, yy=size - self.SIZE, zz=size - self.SIZE)
        self.assertEqual(on_critical_planes(SmithWatsonTopper(YOUNG, POISSON), pressed)[0][0], 0)

    def test_planes_out_of_the_section(self):
        """Largest shear of a section under sigma_yy alone is on planes that lean out of it."""
        found, plane = on_critical_planes(Findley(0), history(yy=self.SIZE * np.sin(TURN)))
        self.assertAlmostEqual(found[0], self.SIZE / 2, delta=1e-5 * self.SIZE)
        self.assertAlmostEqual(abs(plane[0, 1]), np.sqrt(0.5), delta=0.01)

    def test_tension_and_torsion_out_of_phase(self):
        """Deviators run along an ellipse with the semi-axes sigma/sqrt(3) and tau; at tau = sigma/2 Tresca's shear is constant."""
        for shear, radius in ((150, 150), (80, 200 / np.sqrt(3))):
            bar = history(xx=200 * np.sin(TURN), xy=shear * np.cos(TURN))
            self.assertAlmostEqual(crossland(bar, 0)[0], radius)
        self.assertAlmostEqual(dang_van(history(xx=200 * np.sin(TURN), xy=100 * np.cos(TURN)), 0.3)[0], 100 + 0.3 * 200 / 3)

    def test_out_of_phase_shear(self):
        """On the plane normal to x the shear runs around a triangle, whose circle is larger than half of any chord, or around
        a rectangle."""
        triangle = history(xy=100 * np.cos(TURN[::16]), xz=100 * np.sin(TURN[::16]))
        value, plane = on_critical_planes(Findley(0), triangle)
        self.assertAlmostEqual(value[0], 100, delta=0.01)
        self.assertGreater(abs(plane[0, 0]), np.cos(np.radians(0.5)))
        box = history(xy=[-90., 90, 90, -90], xz=[-40., -40, 40, 40])
        self.assertAlmostEqual(Findley(0).values(box, np.array([[[1., 0, 0]]]))[0, 0], np.hypot(90, 40))

    def test_constants_of_limits(self):
        """Both limits give the same value."""
        hard = material.material_of()
        bending, torsion = (history(**{pair: np.array([-size, size])}) for pair, size in
                            (("xx", hard.bending_limit), ("xy", hard.torsion_limit)))
        for name in ("findley", "crossland", "dang_van"):
            one, other = (fields.fields_of([name], hard, stress)[name] for stress in (bending, torsion))
            self.assertAlmostEqual(one.values[0] / other.values[0], 1, delta=1e-5)
            self.assertAlmostEqual(one.values[0] / one.reference, 1, delta=1e-9)


class InvarianceTest(unittest.TestCase):
    CRITERIA = (SmithWatsonTopper(YOUNG, POISSON), FatemiSocie(YOUNG, POISSON, YIELD, 1), Findley(0.3))

    def test_axes_change_nothing(self):
        """Planes turn with the axes."""
        stress = 100 * np.random.default_rng(7).normal(size=(8, 12, 6))
        for turn in rotations(2):
            turned = of_tensors(turn @ tensors(stress) @ turn.T)
            for criterion in self.CRITERIA:
                (value, plane), (other, leaning) = (on_critical_planes(criterion, one, finest=1e-8) for one in (stress, turned))
                np.testing.assert_allclose(other, value, rtol=1e-10)
                np.testing.assert_allclose(np.abs(np.sum(plane @ turn.T * leaning, axis=1)), 1, atol=1e-8)
            np.testing.assert_allclose(crossland(turned, 0.2), crossland(stress, 0.2), rtol=1e-10)
            np.testing.assert_allclose(dang_van(turned, 0.2), dang_van(stress, 0.2), rtol=1e-10)

    def test_order_and_repetition_of_steps_change_nothing(self):
        stress = 100 * np.random.default_rng(8).normal(size=(5, 12, 6))
        other = stress[:, [3, 1, 2, 0, 5, 4, 4, 4, 11, 10, 9, 8, 7, 6, 3]]
        for criterion in self.CRITERIA:
            np.testing.assert_allclose(on_critical_planes(criterion, other)[0], on_critical_planes(criterion, stress)[0], rtol=1e-9)
        np.testing.assert_allclose(dang_van(other, 0.2), dang_van(stress, 0.2), rtol=1e-9)

    def test_a_section_is_searched_as_a_solid(self):
        """Half of the planes, the same answer, as without xy and yz both sides are alike."""
        stress = 100 * np.random.default_rng(9).normal(size=(4, 12, 6))
        stress[..., [XY, YZ]] = 0
        nearly = stress.copy()
        nearly[..., XY] = 1e-9
        for criterion in self.CRITERIA:
            np.testing.assert_allclose(*(on_critical_planes(criterion, one, finest=1e-6)[0] for one in (stress, nearly)), rtol=1e-8)


class StripTest(unittest.TestCase):
    """The rig of fretting fatigue: cylinder of 50 mm on a flat specimen, in-phase bulk stress, fully reversed; half-planes in
    partial slip (Nowell and Hills 1987). Its largest stress along x at the trailing edge is 311.19 MPa."""
    A, P0, C, SHIFT, FRICTION, BULK = 0.462190, 186.9818, 0.376671, 0.072701, 0.85, 100.0

    def side(self, x, half_width):
        """-(1/pi) times the principal value of the integral of sqrt(1 - s^2/h^2)/(x - s), in units of h, by hand."""
        ratio = np.abs(x) / half_width
        return -np.sign(x) * (ratio - np.sqrt(np.maximum(ratio**2 - 1, 0)))

    def stress(self, x):
        """(points, 2, 6) on the surface of the specimen, at both ends of the load."""
        circle = np.sqrt(np.maximum(1 - (x / self.A)**2, 0))
        inner = np.sqrt(np.maximum(1 - ((x - self.SHIFT) / self.C)**2, 0))
        peak = self.FRICTION * self.P0
        shear = peak * (circle - self.C / self.A * inner)
        along = 2 * peak * (self.side(x, self.A) - self.C / self.A * self.side(x - self.SHIFT, self.C)) + self.BULK
        found = np.zeros((len(x), 2, 6))
        for step, sign in enumerate((1, -1)):
            found[:, step, XX] = -self.P0 * circle + sign * along
            found[:, step, ZZ] = -self.P0 * circle
            found[:, step, XZ] = -sign * shear
        found[..., YY] = POISSON * (found[..., XX] + found[..., ZZ])
        return found

    def by_hand(self, x):
        """SWT over the planes of the section, by Mohr's circle and Hooke's law in plane strain."""
        stress, angles = self.stress(x), np.radians(np.arange(0, 180, 0.25))
        xx, zz, xz = (stress[:, :, None, one] for one in (XX, ZZ, XZ))
        normal = (xx + zz) / 2 + (xx - zz) / 2 * np.cos(2 * angles) + xz * np.sin(2 * angles)
        strain = (1 + POISSON) / YOUNG * (normal - POISSON * (xx + zz))
        values = np.maximum(normal.max(axis=1), 0) * np.ptp(strain, axis=1) / 2
        return values.max(axis=1), angles[np.argmax(values, axis=1)]

    def test_swt_along_the_surface(self):
        x = np.concatenate([np.linspace(-1.5, 1.5, 61) * self.A, [-self.A]])
        expected, angles = self.by_hand(x)
        value, plane = on_critical_planes(SmithWatsonTopper(YOUNG, POISSON), self.stress(x))
        np.testing.assert_allclose(value, expected, rtol=0.01, atol=1e-3 * expected.max())
        high = expected > 0.1 * expected.max()
        normals = np.stack([np.cos(angles), 0 * angles, np.sin(angles)], axis=1)
        self.assertGreater(np.abs((plane * normals).sum(axis=1))[high].min(), np.cos(np.radians(5)))
        self.assertEqual(x[np.argmax(value)], -self.A)

    def test_trailing_edge(self):
        """A bar in plane strain, fully reversed: the crack is straight down, and the parameters are those by hand."""
        stress, largest = self.stress(np.array([-self.A])), 311.19
        self.assertAlmostEqual(stress[0, 0, XX] / largest, 1, delta=2e-4)
        value, plane = on_critical_planes(SmithWatsonTopper(YOUNG, POISSON), stress)
        self.assertAlmostEqual(value[0] / (largest**2 * (1 - POISSON**2) / YOUNG), 1, delta=0.01)
        self.assertLess(INTO_SPECIMEN.inclination(plane)[0], 1)
        value, plane = on_critical_planes(Findley(0.26), stress)
        self.assertAlmostEqual(value[0] / (largest / 2 * (0.26 + np.sqrt(1 + 0.26**2))), 1, delta=0.01)
        self.assertAlmostEqual(INTO_SPECIMEN.inclination(plane)[0], np.degrees(np.arctan(1 / 0.26)) / 2, delta=1)
        j2 = largest**2 * (1 - POISSON + POISSON**2) / 3
        self.assertAlmostEqual(crossland(stress, 0.2)[0] / (np.sqrt(j2) + 0.2 * largest * (1 + POISSON) / 3), 1, delta=0.01)
        self.assertAlmostEqual(dang_van(stress, 0.3)[0] / (largest / 2 + 0.3 * largest * (1 + POISSON) / 3), 1, delta=0.01)

    def test_edge_between_nodes(self):
        """Exact stress and pressure at nodes of which none is at the edge: the tip of the stress there within 1 %, however the nodes
        lie, none of which has more than 98 % of it. Nodes five times as far apart say nothing."""
        exact = self.stress(np.array([-self.A]))[0, :, XX]
        for offset in (0.1, 0.35, 0.6, 0.85):
            x = np.arange(-50, 51) * 0.018 + offset * 0.018
            points, stress = self.edges(x)
            self.assertEqual(len(points), 1)  # the other edge has too few nodes that slip
            self.assertAlmostEqual(points[0, 0], -self.A, delta=0.0015)
            np.testing.assert_allclose(stress[0, :, XX], exact, rtol=0.01)
            np.testing.assert_allclose(stress[0, :, YY], POISSON * exact, rtol=0.01)
            self.assertEqual(np.abs(stress[0][:, [ZZ, XZ]]).max(), 0)
            self.assertLess(self.stress(x)[:, 0, XX].max(), 0.98 * exact[0])
        self.assertEqual(len(self.edges(np.arange(-8, 9) * 0.1 + 0.03)[0]), 0)

    def edges(self, x):
        """edge_stress of a body with these nodes. Slip grows from the stick zone on."""
        body = types.SimpleNamespace(points=np.stack([x, 0 * x, 0 * x], axis=1), stress=self.stress(x), on_surface=np.arange(len(x)))
        pressure = self.P0 * np.sqrt(np.maximum(1 - (x / self.A)**2, 0))
        slip = np.maximum(np.abs(x - self.SHIFT) - self.C, 0)
        return edge_stress(body, POISSON, x, np.stack([pressure, pressure], axis=1), np.stack([0 * slip, slip], axis=1))

    def test_ruiz(self):
        """By hand: half of the range of slip, the largest traction, tension along slip; opened steps count for nothing."""
        x = np.array([-0.95 * self.A])
        stress = self.stress(x)
        shear = np.abs(stress[0, 0, XZ])
        traction, slip = np.zeros((2, 1, 2, 2))
        traction[0, :, 0], slip[0, :, 0] = [shear, -shear], [3e-4, -1e-4]
        energy, tension = ruiz(stress, traction, slip, np.ones((1, 2), dtype=bool))
        self.assertAlmostEqual(energy[0], shear * 2e-4)
        self.assertAlmostEqual(tension[0], shear * 2e-4 * stress[0, 0, XX])
        energy, _ = ruiz(stress, traction, slip, np.array([[True, False]]))
        self.assertEqual(energy[0], 0)


class BelowTest(unittest.TestCase):
    def hertz(self, depth):
        """On the axis of Hertz' point contact, unit radius and pressure, nu = 0.3: from no load to the full one."""
        axial = -1 / (1 + depth**2)
        radial = -(1 + 0.3) * (1 - depth * np.arctan(1 / depth)) + 0.5 / (1 + depth**2)
        stress = np.zeros((len(depth), 2, 6))
        stress[:, 1, :3] = np.stack([radial, radial, axial], axis=1)
        return stress

    def test_hertz_on_the_axis(self):
        """The largest shear, 0.310 p0 in the depth 0.481 a, comes and goes: half of it is the amplitude, on planes of 45
        degrees."""
        depth = np.arange(0.2, 1, 0.002)
        stress = self.hertz(depth)
        coarse = stress[::5]
        found, plane = on_critical_planes(Findley(0), coarse)
        self.assertAlmostEqual(found.max() / (0.310 / 2), 1, delta=0.01)
        self.assertAlmostEqual(depth[::5][np.argmax(found)], 0.481, delta=0.01)
        np.testing.assert_allclose(Below.plane(0 * plane, 1).inclination(plane), 45, atol=1)
        for values in (dang_van(stress, 0), crossland(stress, 0) * np.sqrt(3) / 2):
            self.assertAlmostEqual(values.max() / (0.310 / 2), 1, delta=0.01)
            self.assertAlmostEqual(depth[np.argmax(values)], 0.481, delta=0.005)

    def test_critical_distance(self):
        """Means of a stress that falls linearly are those of the middle, along lines and below the surface of a section."""
        depth = np.linspace(0, 1, 11)
        points = np.stack([0 * depth, 0 * depth, -depth], axis=1)
        stress = np.zeros((11, 2, 6))
        stress[:, 0, 0], stress[:, 1, 0] = 100 - 60 * depth, 60 * depth - 100
        for method, expected in (("line", 100 - 60 * 0.3), ("point", 100 - 60 * 0.15)):
            mean = along_line(depth, points, stress, 0.3, method)
            np.testing.assert_allclose(mean[0, :, 0], [expected, -expected])
        self.assertIsNone(along_line(depth, points, stress, 0.6, "line"))
        self.assertIsNone(along_line(depth, points[:, ::-1], stress, 0.3, "line"))
        grid = np.stack(np.meshgrid([0., 1, 2], [0., -0.5, -1], indexing="ij"), axis=-1).reshape(-1, 2)
        places = np.stack([grid[:, 0], 0 * grid[:, 0], grid[:, 1]], axis=1)
        cells = np.array([[0, 3, 4, 1], [1, 4, 5, 2], [3, 6, 7, 4], [4, 7, 8, 5]])
        of_body = np.zeros((9, 2, 6))
        of_body[:, 0, 0] = 100 + 60 * grid[:, 1] + grid[:, 0]
        at, mean = below_surface(Body("lower body", -1, {}, places, of_body, [(9, cells)]), 0.3, "line")
        np.testing.assert_array_equal(at, [0, 3, 6])
        np.testing.assert_allclose(mean[:, 0, 0], 82 + np.arange(3))

    def test_angles(self):
        """A plane that leans by 30 degrees towards +x as it goes down, in a body above and below the surface."""
        for inward, normal in ((1, [np.cos(np.pi / 6), 0, -0.5]), (-1, [np.cos(np.pi / 6), 0, 0.5])):
            for sign in (1, -1):
                plane = sign * np.array([normal])
                below = Below.plane(np.zeros((1, 3)), inward)
                self.assertAlmostEqual(below.inclination(plane)[0], 30)
                self.assertAlmostEqual(below.azimuth(plane)[0], 0)

    def test_angles_below_a_curved_surface(self):
        """The side of a cylinder, radius 2: inclination and depth are to its normals."""
        angles, y = np.meshgrid(np.radians(np.arange(0, 91, 2)), [0., 1], indexing="ij")
        nodes = np.stack([2 * np.sin(angles), y, -2 * np.cos(angles)], axis=-1).reshape(-1, 3)
        triangles = np.array([[k, k + 1, k + 2] for k in range(len(nodes) - 2)])
        place = np.array([[np.sin(0.7), 0, -np.cos(0.7)]])
        below = Below.curved(1.5 * place, nodes, triangles)
        self.assertAlmostEqual(below.depths[0], 0.5, delta=0.01)
        self.assertAlmostEqual(below.inclination(place)[0], 90, delta=3)
        self.assertAlmostEqual(below.inclination(place[:, [2, 1, 0]] * [1, 1, -1])[0], 0, delta=3)
        self.assertTrue(np.isnan(below.azimuth(place)[0]))

    def test_files_are_read_back(self):
        import tempfile
        random = np.random.default_rng(5)
        points, one, three = random.normal(size=(9000, 3)), random.normal(size=9000), random.normal(size=(9000, 3))
        cells = [(9, random.integers(0, 9000, size=(7, 4))), (12, random.integers(0, 9000, size=(5, 8)))]
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "fatigue.vtu"
            path.write_text(text_of_vtu(points, cells, {"one": one, "three": three}), encoding="ascii")
            file = Vtu(path)
        np.testing.assert_array_equal(file.points, points)
        np.testing.assert_array_equal(file.fields["three"], three)
        np.testing.assert_array_equal(file.fields["one"], one)
        for (kind, block), (expected_kind, expected) in zip(file.blocks, cells):
            self.assertEqual(kind, expected_kind)
            np.testing.assert_array_equal(block, expected)


if __name__ == "__main__":
    del sys.argv[1]
    unittest.main()
