# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What prm/verification shows besides the rows of the book (test_book.py): other methods and models, limits, errors.

Usage: test_verification.py PROGRAM [unittest options]"""
import json
import math
import sys

import meshio
import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
import program  # noqa: E402
from program import ROOT  # noqa: E402

sys.path.insert(0, str(ROOT / "tools/studies"))
import paths  # noqa: E402, F401 (finds the modules of all studies)
import answers  # noqa: E402
import measure  # noqa: E402
import run_folder  # noqa: E402


def angle_against_motion(row):
    return math.degrees(math.atan2(-row["force_y"], -row["force_x"]))


class VerificationTest(program.RunTest):
    def verified(self, name, *settings):
        """Numbers of the last step."""
        result = self.run_program("run", settings=settings, file=ROOT / f"prm/verification/{name}.prm")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return {key: float(value) for key, value in self.rows("run")[-1].items() if key not in ("method", "driven")}

    def test_gross_sliding_by_sweeps(self):
        row = self.verified("gross_sliding_by_force", "Contact solver/Method=gauss-seidel")
        self.assertAlmostEqual(row["force_z"], 1e4, delta=1e-4)
        self.assertAlmostEqual(math.hypot(row["force_x"], row["force_y"]), 7375.6, delta=0.05)
        self.assertAlmostEqual(angle_against_motion(row), 14.04, delta=5e-3)
        self.assertEqual(row["n_stick"], 0)

    def test_stress_of_the_patch_test(self):
        """One pressure along z in all of the body: of the section, and of a solid."""
        for model in ("auto", "quarter"):
            self.verified("patch_test", "Output/Volume fields=1", f"Mesh/Model={model}")
            run = self.folder / "run"
            volume = (run_folder.RunFolder(run).contact(1, "volume").data if model == "auto"
                      else meshio.read(run / "volume-0001.vtu").point_data)
            stress = np.asarray(volume["stress"]).reshape(-1, 3, 3)
            self.assertLess(np.abs(stress - np.diag([0, 0, -2100])).max(), 1e-3)
            for name, value in (("principal_stress_1", 0), ("principal_stress_2", 0), ("principal_stress_3", -2100)):
                self.assertLess(np.abs(volume[name] - value).max(), 1e-3, (model, name))

    @staticmethod
    def polar_moment_of_parabolas(n):
        """Of the disc of radius 10 whose n edges are parabolas through three points of the circle, mm^4: the integral of
        r^2 (x dy - y dx) / 4 along them."""
        moment, (points, weights) = 0, np.polynomial.legendre.leggauss(5)
        shapes = np.array([points * (points - 1) / 2, 1 - points**2, points * (points + 1) / 2])
        slopes = np.array([points - 0.5, -2 * points, points + 0.5])
        for edge in range(n):
            angles = np.pi / n * (2 * edge + np.arange(3))
            corners = 10 * np.array([np.cos(angles), np.sin(angles)])
            (x, y), (dx, dy) = corners @ shapes, corners @ slopes
            moment += np.sum(weights * (x**2 + y**2) * (x * dy - y * dx)) / 4
        return moment

    def test_torsion_of_polygons(self):
        n, a = 32, 2 * math.pi / 32
        polygon = n * 1e4 * math.sin(a) * (2 + math.cos(a)) / 12
        for degree, polar_moment in ((1, polygon), (2, self.polar_moment_of_parabolas(n))):
            row = self.verified("torsion", f"Mesh/Degree={degree}", "Mesh/Quadrature points=4", "Mesh/Model=full")
            moment = -105000 * polar_moment * math.radians(0.5) / 10
            self.assertAlmostEqual(row["moment_z"] / moment, 1, delta=1e-8)
            self.assertEqual(row["n_slip"] + row["n_open"], 0)

    def contact(self, name, step, *settings):
        """Distances from the axis and fields at the contact nodes after a step."""
        self.verified(name, *settings)
        contact = run_folder.RunFolder(self.folder / "run").contact(step)
        return np.hypot(*contact.points[:, :2].T), contact

    def test_hertz_below_the_surface(self):
        """On the axis (Johnson, Contact Mechanics, equation 3.45): the largest shear is 0.310 p0 at a depth of 0.481 a."""
        self.verified("hertz", "Output/Volume fields=4")
        volume, a, p0 = run_folder.RunFolder(self.folder / "run").contact(4, "volume"), 0.5, 734.56
        on_axis = np.flatnonzero(volume.points[:, 0] == 0)
        depth = volume.points[on_axis, 2] / a
        largest, least = (np.ravel(volume[f"principal_stress_{i}"])[on_axis] / p0 for i in (1, 3))
        near = (depth > 0) & (depth < 2)
        zeta = depth[near]
        radial = -1.3 * (1 - zeta * np.arctan(1 / zeta)) + 0.5 / (1 + zeta**2)
        self.assertLess(np.abs(least[near] + 1 / (1 + zeta**2)).max(), 0.02)
        self.assertLess(np.abs(largest[near] - radial).max(), 0.02)
        shear = (largest - least) / 2
        self.assertAlmostEqual(shear.max(), 0.310, delta=0.005)
        self.assertAlmostEqual(depth[shear.argmax()], 0.481, delta=0.08)  # half the distance of nodes

    def test_hertz_of_a_nearly_incompressible_body(self):
        """The default is right, where full quadrature locks and says so."""
        scene = ("Material/Poisson ratio=0.4999", "Mesh/Core cells=10", "Mesh/Rings=6", "Mesh/Core ratio=0.08",
                 "Mesh/Rim grading=1.6", "Mesh/Layers=10", "Mesh/Layer grading=0.5")
        sphere = answers.Sphere(384.615, poisson=0.4999)
        radius, contact = self.contact("hertz", 4, *scene)
        self.assertAlmostEqual(contact["pressure"][radius.argmin()] / sphere.largest_pressure, 1, delta=0.05)
        a, p0 = measure.fitted_circle(radius, contact["pressure"])
        self.assertAlmostEqual(a / sphere.contact_radius, 1, delta=0.02)
        self.assertAlmostEqual(p0 / sphere.largest_pressure, 1, delta=0.02)
        locked = self.run_program("run", "--check", settings=[*scene, "Mesh/Volumetric quadrature=full"],
                                  file=ROOT / "prm/verification/hertz.prm")
        self.assertIn("full volumetric quadrature: the elements lock", locked.stdout + locked.stderr)

    def test_half_space_stands_in_the_summary(self):
        radius, contact = self.contact("hertz_half_space", 4, "Mesh/Core cells=8")
        self.assertEqual(contact["pressure"][radius > 0.7].max(), 0)
        counterface = json.loads((self.folder / "run/summary.json").read_text(encoding="utf-8"))["scene"]["counterface"]
        self.assertEqual(counterface, {"kind": "half-space", "young_modulus_MPa": 70000, "poisson_ratio": 0.33})

    def test_hertz_far_field_is_of_first_order(self):
        """With the height of the radius the approach lacks what the body has not: half of it at half of a / R."""
        errors = []
        for radius in (5, 10, 20):
            row = self.verified("hertz", f"Geometry/Radius={radius}", f"Geometry/Height={radius}",
                                f"Mesh/Core ratio={1 / radius}")
            errors.append(-row["uz"] / answers.Sphere(384.615).approach - 1)
        self.assertAlmostEqual(errors[0], -0.053, delta=0.003)  # a / R = 0.1
        for wide, narrow in zip(errors, errors[1:]):
            self.assertAlmostEqual(wide / narrow, 2, delta=0.2)

    def test_polar_friction(self):
        """The section that is chosen, and the quarter. With full quadrature, because rectangles of the section and curved
        cells of the quarter have polynomials of their own for the projected divergence, and so other errors."""
        mesh = ("Mesh/Degree=3", "Mesh/Volumetric quadrature=full")
        section = self.verified("polar_friction", *mesh)
        self.assertIn("model          axisymmetric (friction and gap are the same all around",
                      (self.folder / "run/log.txt").read_text(encoding="utf-8"))
        peak = self.rows("run")[4]
        quarter = self.verified("polar_friction", *mesh, "Mesh/Model=quarter")
        for name, bound in (("force_z", 1e-6), ("max_slip", 1e-5), ("total_dissipation", 1e-3), ("stick_area", 0.1)):
            self.assertAlmostEqual(float(self.rows("run")[4][name]) / float(peak[name]), 1, delta=bound)
        self.assertAlmostEqual(quarter["total_dissipation"] / section["total_dissipation"], 1, delta=1e-3)

    def test_pressed_by_force(self):
        self.verified("pressed_by_force", "Contact solver/Tolerance=1e-12")
        by_motion = self.rows("run")
        legs = " ; ".join(f"Fz -{row['force_z']} ux {row['ux']} : 1" for row in by_motion)
        self.verified("pressed_by_force", "Contact solver/Tolerance=1e-12", f"Load program/Legs={legs}")
        by_force = self.rows("run")
        for name in by_motion[0]:
            if name in ("driven", "method", "iterations", "residual", "phase"):
                continue
            both = np.array([[float(row[name]) for row in rows] for rows in (by_motion, by_force)])
            self.assertLessEqual(np.abs(both[1] - both[0]).max(), 1e-8 * np.abs(both).max(), name)

    def test_forces_cost_what_motions_cost(self):
        """Iterations of Newton's method, for a program of the same legs."""
        self.verified("pressed_by_force")
        rows = self.rows("run")
        iterations = {}
        for name, text in (("motion", "uz {uz} ux {ux} : 1"), ("force", "Fz -{force_z} Fx {reversed_x} : 1")):
            legs = " ; ".join(text.format(**row, reversed_x=-float(row["force_x"])) for row in rows)
            self.verified("pressed_by_force", f"Load program/Legs={legs}")
            iterations[name] = sum(int(row["iterations"]) for row in self.rows("run"))
        self.assertGreater(iterations["motion"], len(rows))
        self.assertLessEqual(iterations["force"], 1.1 * iterations["motion"])

    def test_box_and_patch_test_in_a_quarter(self):
        row = self.verified("patch_test", "Mesh/Model=quarter")
        for pressure in (row["min_pressure"], row["max_pressure"]):
            self.assertAlmostEqual(pressure / 2100, 1, delta=1e-6)
        self.assertAlmostEqual(row["force_z"] / (2100 * math.pi * 100), 1, delta=1e-3)  # the rim is a parabola a cell
        row = self.verified("box", "Mesh/Model=quarter")  # the full model could drift sideways with a guided top
        for pressure in (row["min_pressure"], row["max_pressure"]):
            self.assertAlmostEqual(pressure / 1000, 1, delta=1e-9)
        self.assertAlmostEqual(row["force_z"] / 240000, 1, delta=1e-9)

    def test_a_load_that_nothing_carries_ends_the_run(self):
        file = ROOT / "prm/verification/gross_sliding_by_force.prm"
        legs = "Load program/Legs=Fz -1e4 : 1 ; Fx 1.5e4 : 4"  # friction carries 0.8 Fz along x
        result = self.run_program("run", settings=[legs], file=file)
        self.assertEqual(result.returncode, 3)
        self.assertRegex(result.stderr, r"load step 4 of 5 \(Fx = 11250 N, Fz = -10000 N\) has no equilibrium: ")
        carried = float(result.stderr.split("The first ")[1].split(" %")[0])
        self.assertAlmostEqual(carried, 100 * 8 / 15, delta=1.5)
        self.assertEqual(len(self.rows("run")), 3)
        self.assertIn("no equilibrium", (self.folder / "run/summary.json").read_text(encoding="utf-8"))

    def test_a_pull_ends_the_run(self):
        file = ROOT / "prm/verification/gross_sliding_by_force.prm"
        result = self.run_program("run", settings=["Load program/Legs=uz -0.002 : 1 ; Fz 100 : 1"], file=file)
        self.assertEqual(result.returncode, 3)
        self.assertRegex(result.stderr, r"load step 2 of 2 \(Fz = 100 N\) has no equilibrium: ")
        pressing = float(self.rows("run")[0]["force_z"])
        carried = float(result.stderr.split("The first ")[1].split(" %")[0])
        self.assertAlmostEqual(carried, 100 * pressing / (pressing + 100), delta=1.5)

    def test_a_run_by_forces_goes_on_as_if_it_had_not_stopped(self):
        file = ROOT / "prm/verification/gross_sliding_by_force.prm"
        legs = "Load program/Legs=uz -0.002 : 1 ; Fz -1e4 Mz 1e3 : 4 ; Fx 6e3 : 4 ; uz -0.002 : 2"
        settings = [legs, "Output/Checkpoint=0"]
        self.assertEqual(self.run_program("whole", settings=settings, file=file).returncode, 0)
        cut = [*settings, "Contact solver/Tolerance=1e-10", "Contact solver/Maximum iterations=1"]
        self.assertEqual(self.run_program("run", settings=cut, file=file).returncode, 3)
        result = self.run_program("run", "--resume", settings=settings, file=file)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assert_same_files("whole", "run", ["history.csv", "checks.csv", "cycles.csv"])


if __name__ == "__main__":
    program.main()
