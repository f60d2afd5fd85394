# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What VTK finds in the .vtu files along lines, as ParaView's Plot Over Line does: every sample, at its own place.

Usage: test_samples.py PROGRAM [unittest options]"""
import math
import sys

import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
from vtk_runs import CONTACT_FIELDS, CORE_CELLS, HEIGHT, RADIUS, SCRATCH, SINGLE, VtkTest, each, run_tests  # noqa: E402
from vtu_grid import gauss_lobatto, line  # noqa: E402


class SampleTest(VtkTest):
    def assert_sampled(self, data, places):
        """Every sample is found and comes from the place where it was asked for."""
        fields, found = data.samples(places)
        self.assertEqual(np.sum(~found), 0)
        self.assert_close(fields["place"], places)
        return fields

    @each("contact")
    def test_diameters(self, data, degree, _model, _step):
        half_gap = math.pi / (4 * CORE_CELLS) * np.diff(gauss_lobatto(degree)).max()
        for angle in np.radians([0, 12, 45, 90, 101.3, 135]):
            along, across = np.array([[math.cos(angle), math.sin(angle), 0], [-math.sin(angle), math.cos(angle), 0]])
            ends_at_nodes = np.isclose(math.sin(4 * angle), 0)
            reach = RADIUS * (1 if ends_at_nodes else math.cos(half_gap))
            for offset in (0, 1e-6, 0.017) if not ends_at_nodes else (0,):
                half = math.sqrt(reach**2 - offset**2) * along
                fields = self.assert_sampled(data, line(offset * across - half, offset * across + half))
                self.assertGreaterEqual(fields["pressure"].min(), 0)
                self.assertLessEqual(fields["pressure"].max(), data["pressure"].max() * (1 + SINGLE))

    @each("contact")
    def test_pressure_between_nodes(self, data, _degree, _model, _step):
        """Along an axis, where edges of the elements are."""
        samples = line((-RADIUS, 0, 0), (RADIUS, 0, 0))
        nodes = np.flatnonzero(np.abs(data.points[:, 1]) < SINGLE)
        nodes = nodes[np.argsort(data.points[nodes, 0])]
        places, pressure = data.points[nodes, 0], data["pressure"][nodes]
        sampled = self.assert_sampled(data, samples)["pressure"]
        expected = np.interp(samples[:, 0], places, pressure)
        self.assert_close(sampled, expected, tolerance=1e-3)
        # A sample nearer to a node than a thousandth of a cell's diagonal, VTK may extrapolate from the cell beyond.
        corners = data.points[data.cells()]
        diagonal = np.linalg.norm(corners[:, 3] - corners[:, 0], axis=1).max()
        is_between = np.abs(samples[:, :1] - places).min(axis=1) > 1e-3 * diagonal
        self.assertGreater(is_between.mean(), 0.9)
        self.assert_close(sampled[is_between], expected[is_between])

    @each("contact")
    def test_nodes(self, data, _degree, _model, _step):
        fields = self.assert_sampled(data, data.points)
        for name in CONTACT_FIELDS:
            self.assert_close(fields[name], data[name], np.abs(data["displacement" if name == "gap" else name]).max())

    @each("volume")
    def test_body(self, data, _degree, _model, _step):
        reach = 0.9 * RADIUS  # degree 1 is a polygon of eight sides
        for angle in np.radians([0, 12, 45, 90]):
            for low, high in ((0, 0), (HEIGHT, HEIGHT), (0.3 * HEIGHT, 0.6 * HEIGHT)):
                end = reach * np.array([math.cos(angle), math.sin(angle)])
                fields = self.assert_sampled(data, line((0, 0, low), (*end, high)))
                self.assertTrue(np.all(fields["von_mises_stress"] <= data["von_mises_stress"].max() * (1 + SINGLE)))


def tearDownModule():
    SCRATCH.cleanup()


if __name__ == "__main__":
    run_tests(sys.argv)
