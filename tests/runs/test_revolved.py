# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The files of axisymmetric runs as VTK reads them: the whole disc, the section, agreement with the tables.

Usage: test_revolved.py PROGRAM [unittest options]"""
import csv
import functools
import math
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
from vtu_grid import LAGRANGE_QUADRILATERAL, QUADRILATERAL, TRIANGLE, Grid, line, nearest  # noqa: E402

PROGRAM = ""
SCRATCH = tempfile.TemporaryDirectory()
RADIUS, HEIGHT, SECTORS, PROBE = 10, 8, 32, np.array([-6.0, -3.0])
SCENE = f"""subsection Geometry
  set Radius = {RADIUS}
  set Height = {HEIGHT}
end
subsection Mesh
  set Core cells  = 2
  set Rings       = 3
  set Layers      = 3
  set Rim grading = 0.7
end
subsection Friction
  set Coefficients     = 0.2, 0.2
  set Slip potential   = 1, 1
  set Orthotropy angle = 20
end
subsection Load program
  set Legs = 0 0 -0.1 : 2 ; 0 0 -0.02 : 2
end
subsection Output
  set Volume fields = 1
  set Probes        = P: {PROBE[0]} {PROBE[1]} ; axis: 0 0
end
"""
SINGLE = 1e-5  # the files hold single precision
DEGREES, STEPS = (1, 2, 3, 4), (1, 2, 3, 4)


def run(folder, degree, *options, model="auto"):
    (folder / "case.prm").write_text(SCENE)
    command = [PROGRAM, "case.prm", "--quiet", "--output", "run", f"--set=Mesh/Degree={degree}",
               f"--set=Mesh/Model={model}", *options]
    subprocess.run(command, cwd=folder, check=True, timeout=300, stderr=subprocess.PIPE)
    return folder / "run"


@functools.lru_cache(maxsize=None)
def run_folder(degree, model="auto"):
    return run(pathlib.Path(tempfile.mkdtemp(dir=SCRATCH.name)), degree, model=model)


def row(degree, name, step):
    with open(run_folder(degree) / name, encoding="ascii") as file:
        return {key: value if key in ("status", "method", "driven") else float(value)
                for key, value in list(csv.DictReader(file))[step - 1].items()}


def each(kind):
    """Runs a test of one file for all degrees and steps."""
    def decorate(test):
        def run_all(self):
            for degree in DEGREES:
                for step in STEPS:
                    with self.subTest(degree=degree, step=step):
                        test(self, Grid(run_folder(degree) / f"{kind}-{step:04d}.vtu"), degree, step)
        return run_all
    return decorate


class RevolvedTest(unittest.TestCase):
    def assert_close(self, values, expected, scale=None, tolerance=SINGLE):
        scale = np.max(np.abs(expected)) if scale is None else scale
        self.assertLessEqual(np.max(np.abs(np.asarray(values) - expected)), tolerance * scale)

    def test_auto_says_why(self):
        self.assertRegex((run_folder(2) / "log.txt").read_text(), r"model +axisymmetric \(friction is isotropic and")

    @each("contact")
    def test_disc(self, data, degree, _step):
        self.assertEqual(data.types, {TRIANGLE, QUADRILATERAL})
        self.assertEqual(data.degree(), degree)
        area, least_jacobian = data.size()
        self.assertGreater(least_jacobian, 0)
        n_corners = SECTORS * degree
        self.assert_close(area, n_corners / 2 * RADIUS**2 * math.sin(2 * math.pi / n_corners))

    @each("contact")
    def test_each_node_is_one_point(self, data, degree, _step):
        self.assertEqual(len(data.points), data.n_places())
        self.assertEqual((len(data.points) - 1) % (SECTORS * degree), 0)  # the node on the axis, and rings

    @each("contact")
    def test_totals(self, data, _degree, step):
        expected = row(_degree, "history.csv", step)
        force = data["nodal_force"]
        self.assert_close(force.sum(axis=0), [0, 0, expected["force_z"]])
        carrying = data["pressure"] > 0
        area = force[carrying, 2] / data["pressure"][carrying]
        if carrying.all():
            self.assert_close(area.sum(), math.pi * RADIUS**2)
            self.assert_close((area * data["dissipated_energy"]).sum(), expected["total_dissipation"])
        radii = np.hypot(*data.points[:, :2].T)
        stuck, slips = data["status"] == 1, data["status"] == 2
        inner, outer = radii[stuck].max(initial=0), radii[slips].min(initial=RADIUS)
        self.assertTrue(inner < outer or step > 2)  # unloading: slip may begin inside
        if inner < outer:  # the stick zone is a disc, whose border runs between nodes
            self.assertLessEqual(math.pi * inner**2, (1 + SINGLE) * expected["stick_area"])
            self.assertLessEqual(expected["stick_area"], (1 + SINGLE) * math.pi * outer**2)
        self.assert_close(data["slip_magnitude"].max(), expected["max_slip"])

    def assert_sampled(self, data, places):
        """VTK finds every sample, and takes it from the place where it was asked for."""
        fields, found = data.samples(places)
        self.assertEqual(np.sum(~found), 0)
        self.assert_close(fields["place"], places, RADIUS)
        return fields

    @each("contact")
    def test_samples_on_diameters(self, data, degree, _step):
        nodes = np.flatnonzero(np.abs(data.points[:, 1]) < SINGLE)
        nodes = nodes[np.argsort(data.points[nodes, 0])]
        for angle in np.radians([0, 7.3, 45, 90, 101.3]):
            end = np.array([math.cos(angle), math.sin(angle), 0])
            end *= RADIUS if np.isclose(math.sin(4 * angle), 0) else RADIUS * math.cos(math.pi / SECTORS / degree)
            for n_samples in (1000, 1001):  # beside the axis and on it
                pressure = self.assert_sampled(data, line(-end, end, n_samples))["pressure"]
                if angle == 0:
                    radii = np.linspace(-RADIUS, RADIUS, n_samples)
                    expected = np.interp(radii, data.points[nodes, 0], data["pressure"][nodes])
                    self.assert_close(pressure, expected, tolerance=1e-3)  # VTK's reach beyond a cell

    @each("volume")
    def test_samples_in_the_section(self, data, _degree, _step):
        for start, end in (((0, 0), (RADIUS, 0)), ((0, HEIGHT), (RADIUS, 0)), ((3.3, 0), (3.3, HEIGHT))):
            self.assert_sampled(data, line((start[0], 0, start[1]), (end[0], 0, end[1])))

    @each("contact")
    def test_vectors_are_radial(self, data, _degree, _step):
        x, y = data.points[:, :2].T
        for name in ("slip", "friction_traction", "displacement", "nodal_force"):
            across = x * data[name][:, 1] - y * data[name][:, 0]
            self.assertLessEqual(np.abs(across).max(), SINGLE * RADIUS * np.abs(data[name]).max(), name)
        at_peak = row(_degree, "history.csv", 2)["max_slip"]
        outward = (x * data["slip"][:, 0] + y * data["slip"][:, 1]) / RADIUS
        self.assertGreaterEqual(outward.min(), -SINGLE * at_peak)

    @each("contact")
    def test_probe(self, data, degree, step):
        probe = row(degree, "probe-P.csv", step)
        radii = np.hypot(data.points[:, 0], data.points[:, 1])
        near = np.argmin(np.abs(radii - np.hypot(*PROBE)))
        direction = PROBE / np.hypot(*PROBE)
        outward = data.points[near, :2] / radii[near]
        for name, columns in (("slip", "slip_{}"), ("nodal_force", "force_{}"), ("friction_traction", "traction_{}")):
            expected = (data[name][near, :2] @ outward) * direction
            self.assert_close([probe[columns.format(axis)] for axis in "xy"], expected,
                              np.abs(data[name]).max())
        self.assert_close(probe["pressure"], data["pressure"][near])
        self.assertLess(abs(row(degree, "probe-axis.csv", step)["slip_x"]), 1e-12)  # mm; the top moves 0.1

    @each("volume")
    def test_section(self, data, degree, step):
        self.assertEqual(data.types, {QUADRILATERAL if degree == 1 else LAGRANGE_QUADRILATERAL})
        x, y, z = data.points.T
        self.assertEqual((x.min(), x.max(), np.abs(y).max(), z.min(), z.max()), (0, RADIUS, 0, 0, HEIGHT))
        top = row(degree, "history.csv", step)
        self.assert_close(data["displacement"][z == HEIGHT], np.tile([0, 0, top["uz"]], (np.sum(z == HEIGHT), 1)))
        stress = data["stress"].reshape(-1, 3, 3)
        deviator = stress - np.trace(stress, axis1=1, axis2=2)[:, None, None] / 3 * np.eye(3)
        self.assert_close(data["von_mises_stress"], np.sqrt(1.5 * (deviator**2).sum(axis=(1, 2))))
        for i, principal in enumerate(np.linalg.eigvalsh(stress)[:, ::-1].T, start=1):
            self.assert_close(data[f"principal_stress_{i}"], principal, scale=np.abs(stress).max())
        on_axis = x == 0
        self.assert_close(stress[on_axis, 0, 0], stress[on_axis, 1, 1], np.abs(stress).max())
        self.assertTrue(np.all(stress[:, 0, 1] == 0) and np.all(stress[:, 1, 2] == 0))

    def test_section_agrees_with_the_solid(self):
        """Displacements in the plane y = 0, to the difference between the two meshes."""
        section, solid = (Grid(run_folder(2, model) / "volume-0002.vtu") for model in ("auto", "quarter"))
        at, distances = nearest(solid.points, section.points)
        common = distances < SINGLE * RADIUS
        self.assertGreater(common.sum(), len(common) / 2)
        self.assert_close(section["displacement"][common], solid["displacement"][at[common]], scale=0.1, tolerance=0.01)

    def test_resume(self):
        """A run that is cut off goes on to the same bytes."""
        folder = pathlib.Path(tempfile.mkdtemp(dir=SCRATCH.name))
        whole = run_folder(3)
        with self.assertRaises(subprocess.CalledProcessError) as stopped:
            run(folder, 3, "--set=Output/Checkpoint=0", "--set=Checks/Energy defect=1e-12")
        self.assertEqual(stopped.exception.returncode, 3)
        self.assertLess(len(list((folder / "run").glob("contact-*"))), len(STEPS))
        run(folder, 3, "--set=Output/Checkpoint=0", "--resume")
        for name in ("history.csv", "probe-P.csv", "contact-0004.vtu", "volume-0004.vtu"):
            self.assertEqual((folder / "run" / name).read_bytes(), (whole / name).read_bytes(), name)
        shutil.rmtree(folder)


def tearDownModule():
    SCRATCH.cleanup()


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
