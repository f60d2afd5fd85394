# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The .vtu and .pvd files as VTK reads them: names, kinds of cells, geometry, values, agreement with the tables.

Usage: test_vtk.py PROGRAM [unittest options]"""
import csv
import functools
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
from vtu_grid import HEXAHEDRON, QUADRILATERAL, Grid, gauss_lobatto, line, nearest  # noqa: E402

PROGRAM = ""
SCRATCH = tempfile.TemporaryDirectory()
RADIUS, HEIGHT, CORE_CELLS, N_STEPS = 10, 8, 2, 4
MU = np.array([0.3, 0.15])
PROBE = np.array([-6, -3])
SCENE = f"""subsection Geometry
  set Radius = {RADIUS}
  set Height = {HEIGHT}
end
subsection Mesh
  set Core cells = {CORE_CELLS}
  set Rings      = 2
  set Layers     = 2
end
subsection Friction
  set Coefficients   = {MU[0]}, {MU[1]}
  set Slip potential = 0.05, 0.2
end
subsection Output
  set Contact fields = 1
  set Volume fields  = 1
  set Probes         = P: {PROBE[0]} {PROBE[1]}
end
"""
CASES = [(degree, model) for degree in (1, 2, 3) for model in ("full", "half", "quarter")]
SHARE = {"full": 1, "half": 1 / 2, "quarter": 1 / 4}
OPEN, STICK, SLIP = 0, 1, 2
SINGLE = 1e-5  # the files hold single precision
CONTACT_FIELDS = {"displacement": 3, "slip": 3, "slip_magnitude": 1, "accumulated_slip": 1, "gap": 1, "pressure": 1,
                  "friction_traction": 3, "friction_criterion": 1, "status": 1, "nodal_force": 3,
                  "dissipated_energy": 1}
VOLUME_FIELDS = {"displacement": 3, "stress": 9, "von_mises_stress": 1}


@functools.lru_cache(maxsize=None)
def run_folder(degree, model, legs="0 0 -0.1 : 2 ; 0 0 -0.05 : 2"):
    folder = pathlib.Path(tempfile.mkdtemp(dir=SCRATCH.name))
    (folder / "case.prm").write_text(SCENE)
    kind = "auto" if model == "quarter" else model
    settings = [f"--set=Mesh/Degree={degree}", f"--set=Mesh/Model={kind}", f"--set=Load program/Legs={legs}"]
    subprocess.run([PROGRAM, "case.prm", "--quiet", "--output", "run", *settings], cwd=folder, check=True, timeout=300)
    return folder / "run"


@functools.lru_cache(maxsize=None)
def grid(degree, model, kind, step):
    return Grid(run_folder(degree, model) / f"{kind}-{step:04d}.vtu")


def table(degree, model, name):
    """Rows of a .csv file: column -> number, or text where it is none."""
    def value(text):
        try:
            return float(text)
        except ValueError:
            return text
    with open(run_folder(degree, model) / name, encoding="ascii") as file:
        return [{key: value(text) for key, text in row.items()} for row in csv.DictReader(file)]


def each(kind, cases=tuple(CASES)):
    """Runs a test of one file for the files of all cases and steps."""
    def decorate(test):
        def run_all(self):
            for degree, model in cases:
                for step in range(1, N_STEPS + 1):
                    with self.subTest(degree=degree, model=model, step=step):
                        test(self, grid(degree, model, kind, step), degree, model, step)
        return run_all
    return decorate


def polygon(nodes):
    """Area of the polygon whose corners stand so on each edge of the rim."""
    angles = 2 * math.pi / (4 * CORE_CELLS) * np.diff(nodes)
    return 4 * CORE_CELLS * RADIUS**2 / 2 * np.sin(angles).sum()


class VtkTest(unittest.TestCase):
    def assert_close(self, values, expected, scale=None, tolerance=SINGLE):
        """Largest difference relative to the largest value expected."""
        if scale is None:
            scale = np.max(np.abs(expected))
        self.assertLessEqual(np.max(np.abs(np.asarray(values) - expected)), tolerance * scale)

    def assert_disc(self, area, degree):
        """Disc, but for bricks of degree 1 a polygon."""
        self.assert_close(area, polygon([0, 1]) if degree == 1 else math.pi * RADIUS**2,
                          tolerance={1: SINGLE, 2: 1e-3, 3: 1e-4}[degree])

    def assert_contract(self, data, fields, cell_type):
        self.assertGreater(data.grid.GetNumberOfCells(), 0)
        self.assertEqual(data.types, {cell_type})
        self.assertEqual(data.components, fields)
        for name in fields:
            self.assertTrue(np.all(np.isfinite(data[name])), name)


class FileTest(VtkTest):
    def test_collections(self):
        for degree, model in CASES:
            for kind in ("contact", "volume"):
                with self.subTest(degree=degree, model=model, kind=kind):
                    folder = run_folder(degree, model)
                    records = xml.etree.ElementTree.parse(folder / f"{kind}.pvd").getroot().findall(".//DataSet")
                    self.assertEqual([float(record.get("timestep")) for record in records], [1, 2, 3, 4])
                    names = [record.get("file") for record in records]
                    self.assertEqual(names, [f"{kind}-{step:04d}.vtu" for step in range(1, N_STEPS + 1)])
                    self.assertEqual(names, sorted(file.name for file in folder.glob(f"{kind}-*")))

    def test_auto_takes_quarter(self):
        self.assertRegex((run_folder(2, "quarter") / "log.txt").read_text(), r"model +quarter\b")

    @each("contact")
    def test_contact_contract(self, data, degree, _model, _step):
        self.assert_contract(data, CONTACT_FIELDS, QUADRILATERAL)
        self.assertEqual(data.degree(), degree)

    @each("volume")
    def test_volume_contract(self, data, _degree, _model, _step):
        self.assert_contract(data, VOLUME_FIELDS, HEXAHEDRON)


class ContactTest(VtkTest):
    @each("contact")
    def test_disc(self, data, degree, _model, _step):
        """The cells cover the whole disc, seen from above."""
        radii = np.hypot(data.points[:, 0], data.points[:, 1])
        self.assertLessEqual(radii.max(), RADIUS * (1 + 1e-6))
        self.assertEqual(np.abs(data.points[:, 2]).max(), 0)
        area, least_jacobian = data.size()
        self.assertGreater(least_jacobian, 0)
        self.assert_close(area, polygon(gauss_lobatto(degree)))

    @each("contact")
    def test_each_node_is_one_point(self, data, degree, _model, _step):
        self.assertEqual(len(data.points), data.n_places())
        self.assertEqual(len(data.points), len(np.unique(data.cells())))
        n_edges = degree * CORE_CELLS
        self.assertEqual(len(data.points), (n_edges + 1)**2 + 4 * n_edges * 2 * degree)  # core, and 2 rings

    @each("contact")
    def test_ranges(self, data, _degree, _model, _step):
        self.assertLessEqual(set(data["status"]), {OPEN, STICK, SLIP})
        self.assertGreaterEqual(data["friction_criterion"].min(), -1)
        self.assertLessEqual(data["friction_criterion"].max(), 1e-6)
        self.assertGreaterEqual(data["gap"].min(), -1e-6)
        for name in ("pressure", "accumulated_slip"):
            self.assertGreaterEqual(data[name].min(), 0, name)
        self.assertGreaterEqual(data["dissipated_energy"].min(), -SINGLE * data["dissipated_energy"].max())
        self.assertTrue(np.all(data["accumulated_slip"] >= data["slip_magnitude"] * (1 - SINGLE)))

    @each("contact")
    def test_fields_fit_together(self, data, _degree, _model, _step):
        for name in ("slip", "friction_traction"):
            self.assertEqual(np.abs(data[name][:, 2]).max(), 0, name)
        self.assert_close(data["slip_magnitude"], np.linalg.norm(data["slip"], axis=1))
        self.assert_close(data["slip"][:, :2], data["displacement"][:, :2])
        self.assert_close(data["gap"], data["displacement"][:, 2], scale=1)
        traction, pressure, force = data["friction_traction"][:, :2], data["pressure"], data["nodal_force"]
        self.assert_close(traction * force[:, 2:], force[:, :2] * pressure[:, None], np.max(force) * np.max(pressure))
        is_open = data["status"] == OPEN
        ratio = np.linalg.norm(traction / MU, axis=1) / np.where(is_open, 1, pressure)
        self.assert_close(data["friction_criterion"], np.where(is_open, -1, ratio - 1))
        self.assertTrue(np.all(pressure[is_open] == 0))
        self.assertTrue(np.all(data["gap"][~is_open] <= 1e-6))
        self.assertTrue(np.all(np.abs(data["friction_criterion"][data["status"] == SLIP]) <= SINGLE))

    @each("contact")
    def test_totals_of_history(self, data, degree, model, step):
        row = table(degree, model, "history.csv")[step - 1]
        force = data["nodal_force"]
        self.assert_close(force.sum(axis=0), [row["force_x"], row["force_y"], row["force_z"]])
        for status, name in ((OPEN, "n_open"), (STICK, "n_stick"), (SLIP, "n_slip")):
            self.assertEqual(np.sum(data["status"] == status), row[name], name)
        for name in ("pressure", "slip_magnitude", "accumulated_slip"):
            self.assert_close(data[name].max(), row["max_" + name.replace("_magnitude", "")])
        self.assert_close(data["pressure"].min(), row["min_pressure"], row["max_pressure"])
        if row["n_open"] == 0:  # then nodal force / pressure is the area of the node
            area = force[:, 2] / data["pressure"]
            self.assert_disc(area.sum(), degree)
            self.assert_close((area * data["dissipated_energy"]).sum(), row["total_dissipation"])

    @each("contact")
    def test_pressure_carries_force(self, data, degree, model, step):
        """As the polynomial of the elements."""
        force = table(degree, model, "history.csv")[step - 1]["force_z"]
        self.assert_close(data.integral(data["pressure"], data.faces(), gauss_lobatto(degree))[0], force)

    @each("contact")
    def test_probe(self, data, degree, model, step):
        row = table(degree, model, "probe-P.csv")[step - 1]
        near = np.argmin(np.linalg.norm(data.points[:, :2] - PROBE, axis=1))
        self.assertEqual(row["uz"], table(degree, model, "history.csv")[step - 1]["uz"])
        self.assertEqual(row["status"], ("open", "stick", "slip")[int(data["status"][near])])
        self.assert_close(data["slip"][near, :2], [row["slip_x"], row["slip_y"]])
        self.assert_close(data["nodal_force"][near], [row["force_x"], row["force_y"], row["force_n"]])
        self.assert_close(data["friction_traction"][near, :2], [row["traction_x"], row["traction_y"]])
        for name in ("pressure", "accumulated_slip"):
            self.assert_close(data[name][near], row[name])


    def test_open(self):
        data = Grid(run_folder(2, "half", "0 0 -0.1 : 1 ; 0 0 0.02 : 1") / "contact-0002.vtu")
        self.assertEqual((set(data["status"]), set(data["friction_criterion"])), ({OPEN}, {-1}))
        for name in ("pressure", "friction_traction", "nodal_force"):
            self.assertEqual(np.abs(data[name]).max(), 0, name)
        self.assert_close(data["gap"], np.full(len(data.points), 0.02))


def elements(data, degree):
    """Points of the elements of a volume file, each with its own, and where they stand in it."""
    return np.arange(len(data.points)).reshape(-1, (degree + 1)**3), np.linspace(0, 1, degree + 1)


class VolumeTest(VtkTest):
    @each("volume")
    def test_body(self, data, degree, model, _step):
        x, y, z = data.points.T
        self.assertLessEqual(np.hypot(x, y).max(), RADIUS * (1 + 1e-6))
        self.assertEqual((z.min(), z.max()), (0, HEIGHT))
        volume, least_jacobian = data.size()
        self.assertGreater(least_jacobian, 0)
        self.assert_close(volume / HEIGHT / SHARE[model], polygon(np.linspace(0, 1, degree + 1)),
                          tolerance=SINGLE if degree < 3 else 2e-4)  # points of degree 3 are not the nodes on the rim
        volume, least_jacobian = data.integral(np.ones(len(data.points)), *elements(data, degree))
        self.assertGreater(least_jacobian, 0)
        self.assert_disc(volume / HEIGHT / SHARE[model], degree)

    @each("volume")
    def test_displacement(self, data, degree, model, step):
        """Prescribed at the top, that of the contact file at the base."""
        row = table(degree, model, "history.csv")[step - 1]
        top = data["displacement"][data.points[:, 2] == HEIGHT]
        self.assert_close(top, np.tile([row["ux"], row["uy"], row["uz"]], (len(top), 1)))
        base = data.points[:, 2] == 0
        contact = grid(degree, model, "contact", step)
        at, distances = nearest(contact.points, data.points[base])
        is_common = distances < SINGLE * RADIUS
        # The nodes of degree 3 are not equidistant, so that the files share the corners of the cells only.
        self.assertTrue(np.all(is_common) if degree < 3 else np.any(is_common))
        self.assert_close(data["displacement"][base][is_common], contact["displacement"][at[is_common]],
                          scale=abs(row["uz"]))

    @each("volume")
    def test_stress(self, data, degree, model, step):
        """Symmetric, of the right von Mises stress, and as large as equilibrium over the height wants it."""
        stress = data["stress"].reshape(-1, 3, 3)
        self.assert_close(stress, stress.transpose(0, 2, 1))
        deviator = stress - np.trace(stress, axis1=1, axis2=2)[:, None, None] / 3 * np.eye(3)
        self.assert_close(data["von_mises_stress"], np.sqrt(1.5 * (deviator**2).sum(axis=(1, 2))))
        force = table(degree, model, "history.csv")[step - 1]["force_z"]
        total = data.integral(stress[:, 2, 2], *elements(data, degree))[0]
        self.assert_close(total / HEIGHT / SHARE[model], -force, tolerance=1e-3)


class SampleTest(VtkTest):
    """What VTK finds along lines, as ParaView's Plot Over Line does."""

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


class ModelTest(VtkTest):
    """Half and quarter models give the values of the full model, point by point."""

    @each("contact", [case for case in CASES if case[1] != "full"])
    def test_contact(self, data, degree, _model, step):
        full = grid(degree, "full", "contact", step)
        self.assertEqual(len(full.points), len(data.points))
        self.assert_same(data, full, CONTACT_FIELDS, *nearest(data.points, full.points))

    @each("volume", [case for case in CASES if case[1] != "full"])
    def test_volume(self, data, degree, model, step):
        full = grid(degree, "full", "volume", step)
        self.assertEqual(len(full.points) * SHARE[model], len(data.points))
        at, distances = nearest(full.keys((degree + 1)**3), data.keys((degree + 1)**3))
        self.assert_same(full, data, VOLUME_FIELDS, at, distances)

    def assert_same(self, data, expected, fields, at, distances):
        """The values of `data` at its points `at` are those of `expected`."""
        self.assertLess(distances.max(), SINGLE * RADIUS)
        for name in fields:
            with self.subTest(field=name):
                scale_field = "displacement" if name == "gap" else name  # the gap may vanish everywhere
                self.assert_close(data[name][at], expected[name], np.max(np.abs(data[scale_field])))


def tearDownModule():
    SCRATCH.cleanup()


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
