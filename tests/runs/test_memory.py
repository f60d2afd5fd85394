# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Friction with memory: a factor that follows slip, energy, pressure, speed and cycles, its jumps, and runs that go on.

Usage: test_memory.py PROGRAM [unittest options]"""
import csv
import json
import math
import random
import sys
import time

sys.dont_write_bytecode = True  # the source tree stays clean
import numpy as np  # noqa: E402
import program  # noqa: E402
from program import ROOT, SMALL, main  # noqa: E402

sys.path.insert(0, str(ROOT / "tools/studies"))
import paths  # noqa: E402, F401 (finds the modules of all studies)
import run_folder  # noqa: E402

FOLDER = ROOT / "prm/memory"
RUNNING_IN, LUBRICANT = FOLDER / "running_in.prm", FOLDER / "lubricant.prm"
UNSOLVED = 3
OWN = ("min_friction_factor", "mean_friction_factor", "max_friction_factor", "friction_factor_error")
# Dragged until it slides; nothing tilts or presses it otherwise.
BLOCK = ["Geometry/Shape=box", "Geometry/Sizes=4, 4, 1", "Mesh/Cells=4, 4, 1", "Mesh/Degree=1", "Material/Poisson ratio=0",
         "Friction/Coefficients=0.3, 0.3", "Friction/Slip potential=associated", "Output/Volume fields=0", "Output/Probes=",
         "Load program/Cycles=1"]


class MemoryRuns(program.RunTest):
    def solved(self, name, *settings, file=None):
        result = self.run_program(name, settings=settings, file=file)
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def cycles(self, name):
        return [{key: float(value) for key, value in row.items()} for row in self.rows(name, "cycles.csv")]

    def text(self, name, file="log.txt"):
        return (self.folder / name / file).read_text()

    def assert_same_columns(self, first, second, without=()):
        for table in ("history.csv", "checks.csv", "cycles.csv"):
            rows = [[{key: value for key, value in row.items() if key not in without} for row in self.rows(name, table)]
                    for name in (first, second)]
            self.assertEqual(*rows, table)


class MemoryTest(MemoryRuns):
    def test_a_constant_factor_is_other_coefficients(self):
        """To the last bit: of numbers that are twice the others, nothing is rounded."""
        settings = [*SMALL, "Load program/Cycles=2", "Friction/Slip potential=associated", "Mesh/Model=full"]
        self.solved("factor", *settings, "Friction/Factor=2")
        self.solved("given", *settings, "Friction/Coefficients=0.6, 0.3")
        self.assert_same_columns("factor", "given", without=OWN)
        self.assertEqual({row["mean_friction_factor"] for row in self.rows("factor")} - {"nan"}, {"2"})
        folders = [run_folder.RunFolder(self.folder / name) for name in ("factor", "given")]
        for field in ("friction_criterion", "status", "pressure"):
            np.testing.assert_array_equal(*(folder.contact(12)[field] for folder in folders))
        self.assertNotIn("friction_factor", folders[1].contact(12).data)
        summaries = [json.loads(self.text(name, "summary.json")) for name in ("factor", "given")]
        self.assertEqual(*(summary["critical_friction"] for summary in summaries))

    def test_friction_that_falls_when_slip_begins(self):
        """The peak is the static friction, the rest the kinetic one, and the jump between them the same however short steps are."""
        thin = ["Geometry/Sizes=4, 4, 0.01", "Mesh/Cells=1, 1, 1", "Friction/Factor=if(k, 1, 1.3)"]  # all nodes slip at once
        pressed, moved, height = 1e-4, 2e-4, 0.01
        for n in (10, 20, 40):
            self.run_program(f"fall{n}", settings=[*BLOCK, *thin, f"Load program/Legs=uz {-pressed} : 1 ; ux {moved} : {n}"])
            rows = [{key: float(row[key]) for key in ("force_x", "force_z", "max_slip")} for row in self.rows(f"fall{n}")]
            shares = [abs(row["force_x"] / row["force_z"]) for row in rows]
            peak = int(np.argmax(shares))
            self.assertAlmostEqual(shares[peak], 0.39, delta=2e-3)
            np.testing.assert_allclose(shares[peak + 2:], 0.3, atol=1e-9)
            jump = rows[peak + 1]["max_slip"] - rows[peak]["max_slip"] - moved / n
            # (mu_s - mu_k) p over the shear stiffness G/h, with nu = 0.
            self.assertAlmostEqual(jump / (0.09 * 2 * pressed), 1, delta=0.02)
            self.assertIn("was set free where friction fell as nodes began to slip", self.text(f"fall{n}"))

    def test_without_a_factor_nothing_changes(self):
        self.solved("one", *SMALL, "Friction/Factor=1")
        self.solved("none", *SMALL)
        self.assert_same_files("one", "none", ["history.csv", "checks.csv", "cycles.csv", "contact-0012.vtu", "probe-P.csv"])
        self.assertNotIn("friction_factor", self.text("none", "history.csv") + self.text("none", "cycles.csv"))
        self.solved("frictionless", *SMALL, "Friction/Coefficients=0, 0", "Friction/Factor=1 + s")
        self.assertIn("warning: Friction/Factor = 1 + s is ignored with Friction/Coefficients = 0, 0",
                      self.text("frictionless"))

    def test_a_factor_on_measured_friction(self):
        for name, factor in (("once", 1), ("twice", 2)):
            rows = (f"{angle} {factor * (0.25 + 0.05 * math.cos(3 * math.radians(angle)))} {factor * 0.03}"
                    for angle in range(0, 360, 5))
            (self.folder / f"{name}.txt").write_text("\n".join(rows) + "\n", encoding="ascii")
        settings = [*SMALL, "Mesh/Model=full", "Friction/Law=rosette", "Contact solver/Tolerance=1e-13",
                    "Load program/Legs=0 0 -0.1 : 3 ; 0.02 0.01 -0.1 : 4 ; 0 0 -0.05 : 3"]
        self.solved("factor", *settings, "Friction/Rosette=once.txt", "Friction/Factor=2")
        self.solved("given", *settings, "Friction/Rosette=twice.txt")
        forces = [np.array([[float(row[f"force_{axis}"]) for axis in "xyz"] for row in self.rows(name)])
                  for name in ("factor", "given")]
        np.testing.assert_allclose(*forces, atol=1e-10 * np.abs(forces[0]).max())

    def test_speed_of_slip(self):
        """2 mm/s for a while, then 0.5 mm/s: mu = 0.3/(1 + v)."""
        lines = ["time,ux", *(f"{0.5 * k},{k}" for k in range(1, 7)), *(f"{3 + 2 * k},{6 + k}" for k in range(1, 7))]
        (self.folder / "slide.csv").write_text("\n".join(lines) + "\n", encoding="ascii")
        self.solved("run", *BLOCK, "Friction/Factor=1/(1 + v)", "Load program/Preload=Fz -1600 : 1",
                    "Load program/Program file=slide.csv")
        rows = self.rows("run")
        for row, speed in ((rows[0], 0), (rows[1], 0), (rows[6], 2), (rows[-1], 0.5)):
            self.assertAlmostEqual(float(row["mean_friction_factor"]), 1 / (1 + speed), delta=1e-6)
        for row, speed in ((rows[6], 2), (rows[-1], 0.5)):
            self.assertAlmostEqual(-float(row["force_x"]) / float(row["force_z"]), 0.3 / (1 + speed), delta=1e-6)

    def test_a_factor_that_is_no_number(self):
        settings = [*BLOCK, "Friction/Factor=1 - s/3", "Load program/Preload=Fz -1600 : 1", "Load program/Legs=ux 5 : 10"]
        result = self.run_program("run", settings=settings)
        self.assertEqual(result.returncode, UNSOLVED)
        self.assertRegex(result.stderr, r"^orthocone: load step 9 of 11 \(.*\) is not solved: Friction/Factor = 1 - s/3 is -\d"
                         r"[^ ]* at \([^)]*\) mm, where s = [\d.]+ mm, w = [\d.]+ N/mm, p = [\d.]+ MPa, n = 1: allowed is a "
                         r"finite number > 0; .*\. The files of earlier steps are kept\n")
        self.assertEqual([row["step"] for row in self.rows("run")], [str(step) for step in range(1, 9)])
        self.assertEqual(len(list((self.folder / "run").glob("contact-*.vtu"))), 8)
        again = self.run_program("run", "--resume", settings=settings)
        self.assertEqual((again.returncode, again.stderr), (UNSOLVED, result.stderr))

    def test_a_factor_that_changes_fast_is_warned_of(self):
        settings = [*BLOCK, "Friction/Factor=exp(-s)", "Load program/Preload=Fz -1600 : 1"]
        self.solved("few", *settings, "Load program/Legs=ux 2 : 5")
        self.assertRegex(self.text("few"), r"warning: load step \d: Friction/Factor of a node is \d\d % off that of the step")
        self.solved("many", *settings, "Load program/Legs=ux 2 : 20")
        self.assertNotIn("Friction/Factor of a node", self.text("many"))


    def test_friction_that_grows_beyond_the_critical_one_is_warned_of(self):
        """The critical friction is that of the first factor, here 1; later the warning names the step."""
        self.solved("run", "Friction/Factor=min(1 + 50*s, 4)", "Load program/Cycles=1", "Output/Contact fields=0",
                    file=FOLDER / "third_body.prm")
        critical = json.loads(self.text("run", "summary.json"))["critical_friction"]["factor"]
        self.assertGreater(critical, 1)
        grown = max(float(row["max_friction_factor"]) for row in self.rows("run"))
        self.assertGreater(grown, critical)
        self.assertRegex(self.text("run"), r"warning: load step \d+: Friction/Factor has grown to " +
                         f"{grown:.6g}"[:4].replace(".", r"\.") + r".*, and critical friction")


class CyclesTest(MemoryRuns):
    def test_jumps_follow_running_in(self):
        """Beside a run that computes all cycles; shorter jumps come nearer."""
        settings = ["Load program/Cycles=120", "Output/Contact fields=0"]
        self.solved("all", *settings, "Load program/Jump change of friction=0", file=RUNNING_IN)
        whole, errors = self.cycles("all")[-1], []
        for change in (0.1, 0.025):
            self.solved(f"jumps{change}", *settings, f"Load program/Jump change of friction={change}", file=RUNNING_IN)
            rows = self.cycles(f"jumps{change}")
            self.assertEqual(sum(row["n_cycles"] for row in rows), 120)
            self.assertEqual(rows[-1]["last_step"], whole["last_step"])
            self.assertLess(len(rows), 80)
            errors.append(abs(rows[-1]["mean_friction_factor"] - whole["mean_friction_factor"]))
            self.assertLess(errors[-1], 2 * abs(rows[-1]["friction_factor_error"]) + 1e-6)
            for name in ("total_dissipation", "max_accumulated_slip"):
                self.assertAlmostEqual(rows[-1][name] / whole[name], 1, delta=0.3 * change)
        self.assertLess(errors[1], 0.5 * errors[0])
        self.assertGreater(whole["mean_friction_factor"], 1.5)

    def test_killed_runs_go_on(self):
        """The same bytes, whatever the runs were doing."""
        settings = ["Load program/Cycles=60", "Output/Checkpoint=0", "Output/Contact fields=16"]
        start = time.monotonic()
        self.solved("whole", *settings, file=RUNNING_IN)
        seconds, moments = time.monotonic() - start, random.Random(3)
        for _ in range(3):
            self.kill_after("killed", settings, moments.uniform(0.3, 0.7) * seconds, file=RUNNING_IN)
        result = self.run_program("killed", "--resume", settings=settings, file=RUNNING_IN)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        fields = sorted(file.name for file in (self.folder / "whole").glob("contact-*.vtu"))
        self.assert_same_files("whole", "killed", ["history.csv", "checks.csv", "cycles.csv", "contact.pvd", *fields])

    def test_the_shipped_scenes_run(self):
        for file in sorted(FOLDER.glob("*.prm")):
            with self.subTest(file.stem):
                self.solved(file.stem, file=file)
                self.assertNotIn("Friction/Factor", "".join(line for line in self.text(file.stem).splitlines()
                                                            if line.startswith("warning")))
        first, last = self.cycles("running_in")[0], self.cycles("running_in")[-1]
        self.assertLess(first["mean_friction_factor"], 1.1)
        self.assertGreater(last["mean_friction_factor"], 2)
        bed = self.cycles("third_body")[-1]
        self.assertLess(bed["mean_friction_factor"], 0.6)
        film = self.cycles("lubricant")
        self.assertLess(film[0]["max_friction_factor"], 0.3)
        self.assertGreater(film[-1]["max_friction_factor"], 0.9)
        with open(self.folder / "lubricant/history.csv", encoding="ascii") as table:
            self.assertIn("max_friction_factor", csv.DictReader(table).fieldnames)


if __name__ == "__main__":
    main()
