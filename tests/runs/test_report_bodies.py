# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Contact surfaces of any form on the page of tools/report.py: their border, their place in the pictures, and the body from
the side. Read in a real browser (Chromium without a window).

Usage: test_report_bodies.py PROGRAM [unittest options]"""
import itertools
import json
import pathlib
import re
import subprocess
import sys
import unittest

import meshio
import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
from program import PROGRAM, ROOT, main  # noqa: E402
from report_page import CUT_LABELS, Page  # noqa: E402
from report_run import SCRATCH, report  # noqa: E402

sys.path.insert(0, str(ROOT / "tools/studies"))
import paths  # noqa: E402, F401 (finds the modules of all studies)

sys.path.insert(0, str(ROOT / "tools/report"))  # before a study of the same name
import outline  # noqa: E402
import verification_import  # noqa: E402
from imported_body import ImportedBody  # noqa: E402
from run_data import RunData  # noqa: E402

ANGLE = ((5, 0), (6, 0), (5, 1))  # lower left corners (x, y) of three cells
HEXAHEDRON = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))


def write_angle(path):
    """Three cubes of 1 mm on z = 0, as Gmsh writes them."""
    numbers, elements = {}, []

    def node(place):
        return numbers.setdefault(tuple(place), len(numbers) + 1)

    for x, y in ANGLE:
        corners = [node(np.add((x, y, 0), corner)) for corner in HEXAHEDRON]
        elements += [(5, 3, corners), (3, 1, corners[:4]), (3, 2, corners[4:])]
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "3", '2 1 "base"', '2 2 "top"', '3 3 "all"',
             "$EndPhysicalNames", "$Nodes", str(len(numbers))]
    lines += [f"{k} {x} {y} {z}" for (x, y, z), k in numbers.items()] + ["$EndNodes", "$Elements", str(len(elements))]
    lines += [f"{k} {kind} 2 {tag} {tag} {' '.join(map(str, corners))}"
              for k, (kind, tag, corners) in enumerate(elements, start=1)]
    path.write_text("\n".join([*lines, "$EndElements", ""]))


def run(name, file, *settings):
    folder = pathlib.Path(SCRATCH.name) / name
    subprocess.run([PROGRAM, file, "--quiet", "--output", folder, *(f"--set={setting}" for setting in settings)],
                   check=True, timeout=300)
    return folder


class OutlineTest(unittest.TestCase):
    def ring(self, n, turned):
        """Cells between circles of radius 1 and 2; every other one runs clockwise."""
        angles = 2 * np.pi * np.arange(n) / n
        circle = np.stack([np.cos(angles), np.sin(angles)], axis=1)
        k, following = np.arange(n), (np.arange(n) + 1) % n
        quads = np.stack([k, k + n, following + n, following], axis=1)
        quads[::2] = quads[::2, ::-1] if turned else quads[::2]
        return np.concatenate([circle, 2 * circle]), quads

    def test_a_ring_has_two_borders(self):
        for turned in (False, True):
            polygons = outline.outline(*self.ring(40, turned))
            self.assertEqual([len(polygon) for polygon in polygons], [40, 40])
            areas = sorted(outline.area(polygon) for polygon in polygons)
            of_unit = 20 * np.sin(2 * np.pi / 40)
            np.testing.assert_allclose(areas, [-of_unit, 4 * of_unit])

    def test_straight_edges_have_ends_alone(self):
        x, y = np.meshgrid(np.arange(5.), np.arange(4.), indexing="ij")
        number = np.arange(20).reshape(5, 4)
        quads = np.stack([number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]], axis=-1).reshape(-1, 4)
        places = np.stack([x.ravel(), y.ravel()], axis=1) + [3, 7]
        (polygon,) = outline.outline(places, quads)
        self.assertEqual(sorted(polygon.tolist()), [[3, 7], [3, 10], [7, 7], [7, 10]])
        centre, radius = outline.extent([polygon])
        self.assertEqual((centre.tolist(), radius), ([5, 8.5], 2.5))

    def test_cells_that_touch_at_a_corner(self):
        places = np.array(list(itertools.product((0., 1., 2.), repeat=2)))
        polygons = outline.outline(places, np.array([[0, 3, 4, 1], [4, 7, 8, 5]]))
        self.assertAlmostEqual(sum(map(outline.area, polygons)), 2)

    def test_clipped(self):
        circle = outline.outline(*self.ring(40, False))[0] + [0.5, 0]
        half = outline.clipped(circle, 1)
        self.assertAlmostEqual(abs(outline.area(half) / outline.area(circle)), 0.5)
        self.assertGreaterEqual(half[:, 1].min(), 0)
        self.assertEqual(len(outline.clipped(circle - [9, 0], 0)), 0)


class BodiesTest(Page):
    def page_of(self, folder):
        result = report(folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.read(folder / "report.html")
        self.assert_sections()
        return json.loads(self.text("#data"))

    def test_shipped_bodies(self):
        """The border encloses the area that the program has summed over its faces, where these are plane."""
        for name, cells in (("dovetail", 48), ("cylinder", 88)):
            with self.subTest(name):
                folder = run(name, ROOT / f"prm/import/{name}.prm", "Load program/Cycles=1", "Output/Volume fields=0")
                data = self.page_of(folder)
                area = json.loads((folder / "summary.json").read_text())["scene"]["area_mm2"]
                self.assertAlmostEqual(sum(outline.area(one) for one in data["outline"]) / area, 1, delta=1e-6)
                self.assertIn(f"{cells} cells of degree 2", self.text("#model"))
                self.assertIn("blue: contact surface", self.text("#model"))
                self.assertNotIn("radius", self.text("#model"))
                self.assert_phone_and_paper()

    def test_without_contact_fields(self):
        """The mesh file has the outline; where it is gone, the page says what it cannot draw."""
        folder = run("bare", ROOT / "prm/import/cylinder.prm", "Load program/Cycles=1", "Output/Volume fields=0",
                     "Output/Contact fields=0")
        data = self.page_of(folder)
        area = json.loads((folder / "summary.json").read_text())["scene"]["area_mm2"]
        self.assertAlmostEqual(sum(outline.area(one) for one in data["outline"]) / area, 1, delta=1e-6)
        parameters = folder / "parameters.prm"
        parameters.write_text(re.sub(r"Mesh file *= .*", "Mesh file = gone.msh", parameters.read_text()))
        self.assertEqual(self.page_of(folder)["outline"], [])
        self.assertIn("The body is not drawn", self.text("#warnings"))
        self.assertIn("no contact fields, so no mesh; nor outline", self.text("#model"))

    def test_an_angle_far_from_the_centre(self):
        mesh = pathlib.Path(SCRATCH.name) / "angle.msh"
        write_angle(mesh)
        parameters = mesh.with_suffix(".prm")
        parameters.write_text("subsection Geometry\nset Shape = file\nset Mesh file = angle.msh\nset Contact surface = base\n"
                              "set Held surface = 2\nset Symmetry surfaces =\nend\n"
                              "subsection Friction\nset Coefficients = 0.3, 0.3\nend\n"
                              "subsection Load program\nset Legs = 0 0 -0.001 : 1 ; 0.001 0 -0.001 : 2\nend\n")
        folder = run("angle", parameters, "Output/Probes=P: 6.5 0.5", "Mesh/Refinements=1")
        data = self.page_of(folder)
        self.assertEqual(data["centre"], [6, 1])
        self.assertEqual(sorted(data["outline"][0]), [[5, 0], [5, 2], [6, 1], [6, 2], [7, 0], [7, 1]])
        places = np.array([(5.2, 1.8), (6.8, 0.2), (6.8, 1.8), (5.5, 0.5)])
        alpha = self.map_colours(places - [6, 1], data["radius"])[:, 3]
        self.assertEqual(alpha.tolist(), [255, 255, 0, 255])  # nothing stands where the angle is open
        np.testing.assert_allclose(RunData(folder).area, 3)
        saved = self.saved_table(self.menu("Pressure along x"))  # on y = 1, through the centre
        places = meshio.read(folder / "contact-0003.vtu").points
        on = np.unique(places[np.abs(places[:, 1] - 1) < 1e-6, 0])
        self.assertGreaterEqual(len(on), 5)
        np.testing.assert_allclose([float(row["x (mm)"]) for row in saved], on, rtol=1e-5)

    # --- a second body, or a half-space, from the side ---

    FILE_BELOW = ["Lower geometry/Shape=file", *(f"Lower geometry/{entry}" for entry in (
        f"Mesh file={ROOT / 'prm/import/pin.msh'}", "Contact surface=cap", "Held surface=top", "Symmetry surfaces=x0, y0"))]
    BLOCK_BELOW = ["Lower geometry/Shape=box", "Lower geometry/Sizes=9, 8, 3", "Lower mesh/Cells=4, 4, 2"]
    TINY = ["Load program/Legs=0 0 -0.01 : 1", "Load program/Cycles=1", "Mesh/Degree=1", "Lower mesh/Degree=1"]
    SMALL_CYLINDER = ["Geometry/Radius=2", "Geometry/Height=4", "Mesh/Core cells=2", "Mesh/Layers=2"]

    def from_the_side(self, folder, css):
        """Left, top, right and bottom (pixels) of what has a class in the last drawing of the model, from the top on."""
        self.page_of(folder)
        self.assertEqual(self.script(CUT_LABELS), [])
        boxes = self.script("""
            return [...[...document.querySelectorAll("#model svg")].pop().querySelectorAll(arguments[0])]
                .map(element => element.getBBox()).map(box => [box.x, box.y, box.x + box.width, box.y + box.height])""", css)
        return np.array(sorted(boxes, key=lambda box: box[1]))

    def test_a_body_below(self):
        """Both to one scale, the lower one upside down: its contact surface is at the upper one's base."""
        for name, file, settings, sizes in (
                ("blocks", "two_bodies/steel_on_aluminium.prm", [*self.SMALL_CYLINDER, *self.BLOCK_BELOW], [(4, 4), (9, 3)]),
                ("file-below", "two_bodies/steel_on_aluminium.prm", [*self.SMALL_CYLINDER, *self.FILE_BELOW], [(4, 4), (6, 6)]),
                ("below-file", "import/pin.prm", self.BLOCK_BELOW, [(6, 6), (9, 3)])):
            with self.subTest(name):
                folder = run(name, ROOT / "prm" / file, *self.TINY, "Obstacle/Kind=body", *settings)
                upper, lower = boxes = self.from_the_side(folder, "rect.disc, path.side")
                found = (boxes[:, 2:] - boxes[:, :2]) / (upper[3] - upper[1]) * sizes[0][1]
                np.testing.assert_allclose(found, sizes, rtol=2e-3)
                self.assertAlmostEqual(upper[3], lower[1], delta=0.1)
                self.assertAlmostEqual(upper[0] + upper[2], lower[0] + lower[2], delta=0.2)
                for _, top, _, bottom in self.from_the_side(folder, "path.touching"):
                    self.assertLess(max(abs(top - upper[3]), abs(bottom - upper[3])), 0.2 * (upper[3] - upper[1]))
                self.assertIn("elastic body, ", self.text("#model"))

    def test_a_body_below_whose_file_is_gone(self):
        folder = run("lost", ROOT / "prm/two_bodies/steel_on_aluminium.prm", *self.TINY, *self.SMALL_CYLINDER, *self.FILE_BELOW)
        parameters = folder / "parameters.prm"
        parameters.write_text(re.sub(r"Mesh file *= .*pin.msh", "Mesh file = gone.msh", parameters.read_text()))
        self.assertEqual(len(self.from_the_side(folder, "rect.disc, path.side")), 1)
        self.assertIn("The lower body is not drawn", self.text("#warnings"))

    def test_a_half_space(self):
        """It goes on to both sides, and has no body's outline."""
        folder = run("half-space", ROOT / "prm/paper/case_b.prm", *self.TINY[:3], "Mesh/Core cells=2", "Mesh/Layers=2",
                     "Obstacle/Kind=half-space")
        (body,), (ground,) = (self.from_the_side(folder, f"rect.{css}") for css in ("disc", "side"))
        self.assertEqual(body[3], ground[1])
        self.assertLess(ground[0] + 30, body[0])
        self.assertGreater(ground[2] - 30, body[2])
        self.assertIn("elastic half-space", self.text("#model"))

    def test_supports_and_loads(self):
        """Arrows at their faces, and a line for each, also where legs begin with the name of a load."""
        folder = run("pushed", ROOT / "prm/verification/pushed_block.prm", "Mesh/Cells=4, 1, 4")
        (body,) = self.from_the_side(folder, "rect.disc")
        heads = self.from_the_side(folder, "polygon.load")
        self.assertEqual((int(np.sum(heads[:, 3] < body[1])), int(np.sum(heads[:, 2] < body[0]))), (3, 3))
        for words in ("support x+: x", "load top: pressure on top, 50 MPa", "load side: pressure on x-, 150 MPa", "top face free"):
            self.assertIn(words, self.text("#model"))

    def test_border_encloses_the_body(self):
        """Faces look outwards, and with their mirror images leave no hole: Gauss' theorem gives the volume."""
        for name, volume, surfaces in (("cylinder", 4 * 780.361, ("base", "top", "x0, y0")),
                                       ("dovetail", 64 * 6, ("flank", "neck", "middle"))):
            geometry = dict(zip(("Contact surface", "Held surface", "Symmetry surfaces"), surfaces))
            body = ImportedBody.of({"Mesh file": ROOT / f"prm/import/{name}.msh", **geometry})
            faces = body.border[~verification_import.is_cut(body, body.border)]
            parts = verification_import.all_parts(body, faces).reshape(-1, len(faces), 4, 3)
            signs = [x * y for x, y in itertools.product(*((1, -1)[:1 + mirrored] for mirrored in body.mirrored))]
            found = sum(sign * np.sum(np.linalg.det(part[:, corners]) / 6) for part, sign in zip(parts, signs)  # mirrors
                        for corners in ([0, 1, 2], [0, 2, 3]))  # turn faces round
            self.assertAlmostEqual(found / volume, 1, delta=1e-5)

    def test_body_from_the_side(self):
        """Of the quarter of a cylinder both sides are drawn, of the dovetail the whole profile and no seam."""
        for name, size, mirrored in (("cylinder", (20, 10), [True, True]),
                                     ("dovetail", (10 * 2**0.5, 8 * 2**0.5), [False, True])):
            geometry = {"Mesh file": ROOT / f"prm/import/{name}.msh", "Contact surface": "base", "Held surface": "top",
                        "Symmetry surfaces": "x0, y0"}
            if name == "dovetail":
                geometry.update({"Contact surface": "flank", "Held surface": "neck", "Symmetry surfaces": "middle"})
            body = ImportedBody.of(geometry)
            low, high = body.box()
            np.testing.assert_allclose(high - low, size, rtol=1e-6)
            self.assertEqual(body.mirrored, mirrored)
            covered = sum(abs(outline.area(corners)) for side in body.seen(body.faces) for corners in side)
            # The dovetail's profile is a polygon of 64 mm^2; of the cylinder the rectangle is seen.
            self.assertAlmostEqual(covered / (200 if name == "cylinder" else 64), 1, delta=1e-6)
        self.assertIsNone(ImportedBody.of({**geometry, "Mesh file": "nowhere.msh"}))
        self.assertIsNone(ImportedBody.of({**geometry, "Held surface": "z = 99"}))
        self.assertIsNone(ImportedBody.of({**geometry, "Held surface": "nothing"}))

    def test_surfaces_by_place(self):
        """The same faces as those of the names."""
        cylinder = {"Mesh file": ROOT / "prm/import/cylinder.msh"}
        named = ImportedBody.of({**cylinder, "Contact surface": "base", "Held surface": "top", "Symmetry surfaces": "x0, y0"})
        placed = ImportedBody.of({**cylinder, "Contact surface": "z min", "Held surface": "z = 10",
                                  "Symmetry surfaces": "x = 0, y min"})
        for part in ("contact", "held"):
            faces = [np.unique(np.sort(getattr(body, part), axis=1), axis=0) for body in (named, placed)]
            np.testing.assert_array_equal(*faces)
        self.assertEqual(placed.mirrored, [True, True])


def tearDownModule():
    SCRATCH.cleanup()


if __name__ == "__main__":
    main()
