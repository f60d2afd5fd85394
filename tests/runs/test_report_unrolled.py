# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Maps of contact surfaces that are not seen from above: the side of a shaft is unrolled.

Usage: test_report_unrolled.py PROGRAM [unittest options]"""
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
import numpy as np  # noqa: E402
from program import ROOT, main  # noqa: E402
from report_page import Page  # noqa: E402
from report_run import SCRATCH, report, run  # noqa: E402

sys.path.insert(0, str(ROOT / "tools/report"))
import unrolled  # noqa: E402


def tube(radius, n, places):
    """Points and quadrilaterals of a closed cylinder about z."""
    angles = 2 * np.pi * np.arange(n) / n
    points = np.array([[radius * np.cos(a), radius * np.sin(a), z] for z in places for a in angles])
    quads = [[n * k + i, n * k + (i + 1) % n, n * (k + 1) + (i + 1) % n, n * (k + 1) + i]
             for k in range(len(places) - 1) for i in range(n)]
    return points, np.array(quads)


class UnrolledTest(Page):
    def test_a_cylinder_has_its_circumference(self):
        """Every face keeps its size on the map, also behind the cut, and directions follow the surface."""
        points, quads = tube(5, 24, (0, 1, 3))
        for turn in (np.eye(3), np.eye(3)[[2, 0, 1]]):
            chart = unrolled.unrolled(points @ turn, quads)
            corners = chart.places[chart.quads]
            np.testing.assert_allclose(np.ptp(corners[:, :, 0], axis=1), 2 * np.pi * 5 / 24, rtol=1e-12)
            self.assertAlmostEqual(np.ptp(chart.places[:, 0]), 2 * np.pi * 5, places=9)
            self.assertEqual(np.ptp(chart.places[:, 1]), 3)
            radial = (points @ turn)[chart.points] @ turn.T
            along = np.einsum("nkd,nd->nk", chart.directions @ turn.T, np.column_stack([radial[:, :2], np.zeros(len(radial))]))
            np.testing.assert_allclose(along, 0, atol=1e-12)
            np.testing.assert_allclose(np.linalg.norm(chart.directions, axis=2), 1, rtol=1e-12)

    def test_a_cone_keeps_its_lengths(self):
        """Edges of small faces are as long on the map as on the cone, and directions lie along it."""
        points, quads = tube(1, 240, np.linspace(30, 34, 9))
        points[:, :2] *= 5 + 0.08 * (points[:, 2:] - 30)
        chart = unrolled.unrolled(points, quads)
        on_map = chart.places[chart.quads]
        in_space = points[chart.points[chart.quads]]
        for k in range(4):
            lengths = [np.linalg.norm(corners[:, k] - corners[:, k - 1], axis=1) for corners in (on_map, in_space)]
            np.testing.assert_allclose(*lengths, rtol=1e-4)
        step = on_map[:, 2] - on_map[:, 0]
        way = np.einsum("nd,ndk->nk", step, chart.directions[chart.quads[:, 0]])
        np.testing.assert_allclose(way, in_space[:, 2] - in_space[:, 0], atol=2e-2 * np.linalg.norm(way, axis=1).max())

    def test_what_is_seen_from_above_stays_as_it_is(self):
        points, quads = tube(5, 24, (0, 1, 3))
        self.assertIsNone(unrolled.unrolled(points * [1, 1, 0] + [0, 0, 2], quads))
        wall = np.array([[4, y, z] for z in (0, 1) for y in (0, 2)], dtype=float)
        chart = unrolled.unrolled(wall, np.array([[0, 1, 3, 2]]))
        self.assertAlmostEqual(np.ptp(chart.places[:, 0]), 2, msg="a plane wall, in its own plane")

    def test_the_page_shows_a_press_fit(self):
        folder = run("fit", file=ROOT / "prm/verification/press_fit.prm")
        result = report(folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.read(folder / "report.html")
        self.assert_sections()
        names = self.script("return [...document.querySelectorAll('#map-overlay text')].map(one => one.textContent)")
        self.assertEqual(names[:2], ["arc", "z"])
        self.assertIn("force along z", self.script("return document.querySelector('#step-text').textContent"))
        text = self.script("return document.querySelector('main, body').textContent")
        self.assertNotIn("largest normal force", text)
        self.assertTrue(self.script("return !document.querySelector('#space-panel').hidden"))
        self.assertEqual(self.turned("ArrowUp"), [True, False], "a view from higher up is another one")
        self.assertEqual(self.turned("ArrowDown"), [True, False])
        self.assertEqual(self.turned("Enter"), [True, True], "other keys do nothing")

    def turned(self, key):
        """Whether something is drawn, and whether it stays the same behind a key."""
        return self.script(f"""
            const canvas = document.querySelector('#space'), before = canvas.toDataURL();
            canvas.dispatchEvent(new KeyboardEvent('keydown', {{key: '{key}'}}));
            const pixels = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
            return [pixels.some(value => value > 0), before === canvas.toDataURL()];""")

    def test_a_flat_surface_is_not_drawn_in_space(self):
        folder = run("flat", "Load program/Legs=0 0 -0.01 : 2")
        self.assertEqual(report(folder).returncode, 0)
        self.read(folder / "report.html")
        self.assertTrue(self.script("return document.querySelector('#space-panel').hidden"))


def tearDownModule():
    SCRATCH.cleanup()


if __name__ == "__main__":
    main()
