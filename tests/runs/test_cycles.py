# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Many cycles: the table of cycles, stopping when the response is periodic, jumping cycles, and resuming such runs.

Usage: test_cycles.py PROGRAM [unittest options]"""
import json
import random
import shutil
import sys
import time

import meshio
import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
from program import ROOT, RunTest, SMALL, main  # noqa: E402

STEPS = 6
CYCLES = 40
# Unloading to a fifth keeps a history, which takes some ten cycles to settle.
MANY = [*SMALL, f"Load program/Legs=0 0 -0.1 : 3 ; 0 0 -0.02 : {STEPS - 3}", f"Load program/Cycles={CYCLES}",
        "Output/Volume fields=0", "Output/Contact fields=100"]
TOLERANCE = 1e-4
STOP = f"Load program/Stop when periodic={TOLERANCE}"
JUMP = f"Load program/Jump when periodic={TOLERANCE}"
COLUMNS = ("cycle,n_cycles,last_step,peak_force_z,force_z,max_slip,max_accumulated_slip,accumulated_slip,dissipation,"
           "total_dissipation,work,change,iterations,worn_volume,max_wear_depth,wear_error,stroke,tangential_force,slip_ratio,"
           "energy_ratio,friction_largest,friction_energy,friction_geometric,loop_stiffness,worst_energy,worst_wear")


class CyclesTest(RunTest):
    def run_many(self, name, *settings):
        result = self.run_program(name, settings=[*MANY, *settings])
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def numbers(self, name, table):
        return [{key: float(value) for key, value in row.items() if key not in ("method", "driven")}
                for row in self.rows(name, table)]

    def cycles(self, name):
        return self.numbers(name, "cycles.csv")

    def summary(self, name):
        return json.loads((self.folder / name / "summary.json").read_text())

    def text(self, name, file):
        return (self.folder / name / file).read_text()


class TableTest(CyclesTest):
    def test_rows_agree_with_those_of_the_steps(self):
        self.run_many("run", "Load program/Preload=0 0 -0.05 : 2", "Load program/Cycles=4")
        self.assertEqual(self.text("run", "cycles.csv").splitlines()[0], COLUMNS)
        steps, checks = self.numbers("run", "history.csv")[2:], self.numbers("run", "checks.csv")[2:]
        cycles = self.cycles("run")
        self.assertEqual([row["cycle"] for row in cycles], [1, 2, 3, 4])
        for number, row in enumerate(cycles):
            part = steps[number * STEPS:(number + 1) * STEPS]
            self.assertEqual(row["n_cycles"], 1)
            self.assertEqual(row["last_step"], part[-1]["step"])
            self.assertEqual(row["peak_force_z"], max(step["force_z"] for step in part))
            self.assertEqual(row["max_slip"], max(step["max_slip"] for step in part))
            for name in ("force_z", "max_accumulated_slip", "total_dissipation"):
                self.assertEqual(row[name], part[-1][name])
            self.assertEqual(row["iterations"], sum(step["iterations"] for step in part))
            self.assertAlmostEqual(row["dissipation"] / sum(step["dissipation"] for step in part), 1, delta=1e-9)
            work = sum(check["work"] for check in checks[number * STEPS:(number + 1) * STEPS])
            self.assertAlmostEqual(row["work"] / work, 1, delta=1e-9)
        self.assertEqual(self.text("run", "log.txt").count("\ncycle "), 4)

    def loop_defect(self, refinement):
        """Work of a loop that its dissipation and the change of elastic energy leave unexplained."""
        legs = f"Load program/Legs=0 0 -0.1 : {3 * refinement} ; 0 0 -0.02 : {3 * refinement}"
        self.run_many("run", legs, "Load program/Cycles=2")
        energies = [row["elastic_energy"] for row in self.numbers("run", "history.csv")]
        last = self.cycles("run")[-1]
        change = energies[-1] - energies[6 * refinement - 1]
        return abs(last["work"] - last["dissipation"] - change) / last["dissipation"]

    def test_work_of_a_loop_is_dissipated(self):
        """As well as the steps resolve it."""
        coarse, fine = self.loop_defect(1), self.loop_defect(4)
        self.assertLess(coarse, 0.2)
        self.assertLess(fine, coarse / 4)

    def test_the_wear_measure(self):
        """dissipated_energy is per area: its integral over the disc is the total dissipation."""
        self.run_many("run", "Load program/Cycles=3", "Mesh/Model=full")
        mesh = meshio.read(self.folder / f"run/contact-{3 * STEPS:04d}.vtu")
        total = 0
        for corners in mesh.cells[0].data:
            points, values = mesh.points[corners, :2], mesh.point_data["dissipated_energy"][corners]
            total += integral(points, values)
        self.assertAlmostEqual(total / self.cycles("run")[-1]["total_dissipation"], 1, delta=1e-6)


def integral(points, values):
    """Of a bilinear function over a quadrilateral, by 2 x 2 Gauss points, which are exact."""
    total = 0
    for xi in (-1 / np.sqrt(3), 1 / np.sqrt(3)):
        for eta in (-1 / np.sqrt(3), 1 / np.sqrt(3)):
            corners = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
            shapes = (1 + xi * corners[:, 0]) * (1 + eta * corners[:, 1]) / 4
            along_xi = corners[:, 0] * (1 + eta * corners[:, 1]) / 4
            along_eta = corners[:, 1] * (1 + xi * corners[:, 0]) / 4
            jacobian = np.linalg.det(np.array([along_xi @ points, along_eta @ points]))
            total += abs(jacobian) * (shapes @ np.ravel(values))
    return total


class LoopTest(CyclesTest):
    """A flat block, one cell high, under an even pressure shears like a spring and slides as a whole."""
    HEIGHT, SIDE, MU, YOUNG, STROKE = 0.001, 10, 0.3, 210000, 0.002
    BLOCK = ["Geometry/Shape=box", f"Geometry/Sizes={SIDE}, {SIDE}, {HEIGHT}", "Mesh/Cells=1, 1, 1", "Mesh/Degree=1",
             "Mesh/Model=full", f"Material/Young modulus={YOUNG}", "Material/Poisson ratio=0", "Load program/Cycles=2",
             "Load program/Preload=uz -1e-5 : 1", "Output/Contact fields=0"]

    def loops(self, legs, *settings):
        path = self.folder / "block.prm"
        path.write_text(f"subsection Friction\n  set Coefficients = {self.MU}, {self.MU}\nend\n")
        result = self.run_program("run", settings=[*self.BLOCK, f"Load program/Legs={legs}", *settings], file=path)
        self.assertEqual(result.returncode, 0, result.stderr)
        return self.cycles("run")

    def test_gross_slip(self):
        """Corners of the parallelogram are ends of steps. Along x, and obliquely; shear makes normal forces uneven by
        HEIGHT/SIDE."""
        pressed = self.YOUNG * 1e-5 / self.HEIGHT * self.SIDE**2
        stiffness = 0.5 * self.YOUNG * self.SIDE**2 / self.HEIGHT
        give = self.MU * pressed / stiffness  # 6e-6 mm
        for x, y in ((1, 0), (0.6, 0.8)):
            there, turned, back = (f"ux {x * place} uy {y * place} : {steps}" for place, steps in (
                (self.STROKE / 2, 1), (self.STROKE / 2 - 2 * give, 1), (-self.STROKE / 2, 4)))
            returned = f"ux {x * (2 * give - self.STROKE / 2)} uy {y * (2 * give - self.STROKE / 2)} : 1"
            for row in self.loops(" ; ".join([there, turned, back, returned, there])):
                self.assertAlmostEqual(row["stroke"], self.STROKE, delta=1e-12)
                self.assertAlmostEqual(row["tangential_force"] / (self.MU * pressed), 1, delta=1e-3)
                ratio = 1 - give / (self.STROKE / 2)
                for name, value in (("slip_ratio", ratio), ("energy_ratio", ratio), ("friction_largest", self.MU),
                                    ("friction_energy", self.MU), ("friction_geometric", self.MU),
                                    ("loop_stiffness", stiffness)):
                    self.assertAlmostEqual(row[name] / value, 1, delta=1e-3, msg=(name, x, row))
            # Of the second cycle: every place loses the same, a force times twice the way that it slides.
            self.assertAlmostEqual(row["worst_energy"] / (4 * ratio * self.STROKE / 2 * self.MU * pressed / self.SIDE**2), 1,
                                   delta=0.02)

    def test_no_loop(self):
        """Pressing alone; the worst place wears by Archard's law."""
        row = self.loops("uz -2e-5 : 2 ; uz -1e-5 : 2")[-1]
        self.assertEqual((row["stroke"], row["tangential_force"], row["worst_energy"], row["worst_wear"]), (0, 0, 0, 0))
        for name in ("slip_ratio", "energy_ratio", "friction_largest", "friction_energy", "friction_geometric",
                     "loop_stiffness"):
            self.assertTrue(np.isnan(row[name]), name)
        rows = self.loops("ux 1e-3 : 4 ; ux -1e-3 : 4", "Wear/Law=archard", "Wear/Coefficient=1e-12")
        self.assertAlmostEqual(rows[1]["worst_wear"] / (rows[1]["max_wear_depth"] - rows[0]["max_wear_depth"]), 1, delta=1e-6)

    def test_partial_slip_by_force(self):
        """A sphere between +-0.6 of its limit, along y: the residual motion at zero force is Cattaneo's and Mindlin's."""
        result = self.run_program("run", settings=["Load program/Legs=Fy 83.99 : 4 ; Fy -83.99 : 8 ; Fy 83.99 : 8",
                                                   "Output/Contact fields=0"],
                                  file=ROOT / "prm/verification/cattaneo_mindlin.prm")
        self.assertEqual(result.returncode, 0, result.stderr)
        row, = self.cycles("run")
        poisson, load, radius, q = 0.4999, 466.6, 0.5, 0.6
        slide = 3 * 0.3 * load * (2 - poisson) / (16 * radius * 210000 / (2 * (1 + poisson)))

        def shift(share):
            return slide * (1 - (1 - share)**(2 / 3))
        residual = shift(q) - 2 * shift(q / 2)
        self.assertAlmostEqual(row["slip_ratio"] * row["stroke"] / 2 / residual, 1, delta=0.05)
        self.assertAlmostEqual(row["friction_largest"], 0.3 * q, delta=1e-4)
        area = 4 * row["energy_ratio"] * row["tangential_force"] * row["stroke"] / 2
        loop = 4.8 * 0.3 * load * slide * (1 - (1 - q)**(5 / 3) - 5 * q / 6 * (1 + (1 - q)**(2 / 3)))
        self.assertAlmostEqual(area / loop, 1, delta=0.05)


class PeriodicTest(CyclesTest):
    def test_stop(self):
        """The rows are the first of the whole run; the last fields are written."""
        self.run_many("whole")
        self.run_many("stopped", STOP)
        for table in ("history.csv", "checks.csv", "probe-P.csv", "cycles.csv"):
            self.assertTrue(self.text("whole", table).startswith(self.text("stopped", table)), table)
        rows = self.cycles("stopped")
        self.assertLess(len(rows), CYCLES)
        self.assertGreater(len(rows), 1)
        self.assertEqual([row["change"] <= TOLERANCE for row in rows], [False] * (len(rows) - 1) + [True])
        summary = self.summary("stopped")
        self.assertEqual(summary["status"], "complete")
        self.assertEqual(summary["steps"], {"planned": STEPS * CYCLES, "solved": STEPS * len(rows)})
        self.assertEqual(summary["cycles"], {"completed": len(rows), "jumped_steps": 0, "change": rows[-1]["change"],
                                             "periodic_since_cycle": len(rows)})
        last = f"contact-{STEPS * len(rows):04d}.vtu"
        self.assertTrue((self.folder / "stopped" / last).exists())
        self.assertIn(last, self.text("stopped", "contact.pvd"))
        self.assertRegex(self.text("stopped", "log.txt"), rf"\nperiodic since cycle {len(rows)}: change .*; stops after")
        # What is complete stays so.
        before = {file.name: file.read_bytes() for file in (self.folder / "stopped").iterdir() if file.suffix != ".txt"
                  and file.is_file()}
        result = self.run_program("stopped", "--resume", settings=[*MANY, STOP])
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        for name, old in before.items():
            if name != "summary.json":
                self.assertEqual((self.folder / "stopped" / name).read_bytes(), old, name)

    def test_jump(self):
        """What has added up is that of the computed cycles, as far as the criterion promises."""
        self.run_many("computed")
        computed = self.cycles("computed")[-1]
        for most in (4, 100):
            with self.subTest(most=most):
                self.run_many("jumped", JUMP, f"Load program/Jump cycles={most}")
                rows = self.cycles("jumped")
                last = rows[-1]
                self.assertEqual(sum(row["n_cycles"] for row in rows), CYCLES)
                self.assertLessEqual(max(row["n_cycles"] for row in rows), most)
                self.assertEqual((last["cycle"], last["n_cycles"], last["last_step"]), (CYCLES, 1, CYCLES * STEPS))
                bound = CYCLES * TOLERANCE
                for name in ("total_dissipation", "max_accumulated_slip", "force_z", "max_slip"):
                    self.assertAlmostEqual(last[name] / computed[name], 1, delta=bound, msg=name)
                self.assertAlmostEqual(sum(row["dissipation"] for row in rows) / last["total_dissipation"], 1, delta=1e-9)
                steps = [int(row["step"]) for row in self.rows("jumped")]
                self.assertEqual(steps, sorted(set(steps)))
                self.assertEqual(steps[-1], CYCLES * STEPS)
                summary = self.summary("jumped")
                self.assertEqual(summary["steps"]["solved"], len(steps))
                self.assertEqual(summary["cycles"]["jumped_steps"], CYCLES * STEPS - len(steps))
                # One definition of the energies of a run: that of all cycles, whether computed or jumped.
                energy = summary["energy"]
                self.assertAlmostEqual(energy["dissipation_Nmm"] / last["total_dissipation"], 1, delta=1e-9)
                self.assertAlmostEqual(energy["work_Nmm"] / sum(row["work"] for row in rows), 1, delta=1e-9)
                rest = energy["work_Nmm"] - energy["dissipation_Nmm"] - energy["stored_Nmm"]
                self.assertLessEqual(abs(rest), energy["missing_Nmm"] * (1 + 1e-6) + 1e-6)
                # A jump is no step: nothing of it is in the energy balance of the next one.
                self.assertLess(max(row["energy_defect"] for row in self.numbers("jumped", "checks.csv")[-STEPS:]), 0.05)
                self.assertIn("; jumps ", self.text("jumped", "log.txt"))
                fields = meshio.read(self.folder / f"jumped/contact-{CYCLES * STEPS:04d}.vtu").point_data
                whole = meshio.read(self.folder / f"computed/contact-{CYCLES * STEPS:04d}.vtu").point_data
                for name in ("accumulated_slip", "dissipated_energy"):
                    self.assertLess(np.max(np.abs(fields[name] - whole[name])), bound * np.max(whole[name]))

    def test_full_unloading_is_jumped_at_once(self):
        """The paper's cycle leaves nothing: all other cycles are like the first one."""
        self.run_many("run", "Load program/Legs=0 0 -0.1 : 3 ; 0 0 0 : 3", "Load program/Cycles=1000",
                      "Load program/Jump when periodic=1e-8", "Load program/Jump cycles=1000")
        rows = self.cycles("run")
        self.assertEqual([(row["cycle"], row["n_cycles"]) for row in rows], [(1, 1), (999, 998), (1000, 1)])
        self.assertAlmostEqual(rows[-1]["total_dissipation"] / rows[0]["dissipation"] / 1000, 1, delta=1e-8)
        self.assertAlmostEqual(rows[-1]["max_accumulated_slip"] / rows[0]["max_accumulated_slip"] / 1000, 1, delta=1e-8)

    def test_more_steps_than_may_be_computed_are_jumped(self):
        """1.2 million steps, of which twelve are computed."""
        self.run_many("run", "Load program/Legs=0 0 -0.1 : 3 ; 0 0 0 : 3", "Load program/Cycles=200000",
                      "Load program/Jump when periodic=1e-8", "Load program/Jump cycles=1000000")
        rows = self.cycles("run")
        self.assertEqual([(row["cycle"], row["n_cycles"]) for row in rows], [(1, 1), (199999, 199998), (200000, 1)])
        self.assertAlmostEqual(rows[-1]["total_dissipation"] / rows[0]["dissipation"] / 200000, 1, delta=1e-8)

    def test_a_bound_below_the_solver_is_warned_of(self):
        file = ROOT / "prm/benchmarks/thousand_cycles.prm"
        settings = ["--set=Load program/Stop when periodic=1e-10"]
        result = self.run_program("run", "--check", *settings, file=file)
        self.assertRegex(result.stdout, "warning: Load program/Stop when periodic = 1e-10 .*Contact solver/Tolerance = 1e-10")
        result = self.run_program("run", "--check", "--set=Load program/Jump when periodic=1e-6", file=file)
        self.assertNotIn("when periodic", result.stdout)


class ResumeCyclesTest(CyclesTest):
    RESULTS = ["history.csv", "checks.csv", "probe-P.csv", "cycles.csv", "contact.pvd"]

    def test_killed_runs_go_on(self):
        """Killed again and again, with fields of some jumped steps due, and resumed to the last bit."""
        for kind in (JUMP, STOP):
            settings = [*MANY, kind, "Load program/Jump cycles=7", "Output/Checkpoint=0", "Output/Contact fields=5"]
            start = time.monotonic()
            self.assertEqual(self.run_program("whole", settings=settings).returncode, 0)
            seconds = time.monotonic() - start
            moments = random.Random(1000)
            for _ in range(6):
                self.kill_after("killed", settings, moments.uniform(0.2, 0.7) * seconds)
            result = self.run_program("killed", "--resume", settings=settings)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            with self.subTest(kind):
                self.assert_same_files("whole", "killed", self.RESULTS)
                names = [sorted(file.name for file in (self.folder / name).iterdir()) for name in ("whole", "killed")]
                self.assertEqual(*names)
                self.assertEqual(self.summary("killed")["cycles"], self.summary("whole")["cycles"])
            for name in ("whole", "killed"):
                shutil.rmtree(self.folder / name)


if __name__ == "__main__":
    main()
