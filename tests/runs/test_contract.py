# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What a run leaves behind: names, columns, exit codes, repeatability. And that the shipped parameter files are read.

Usage: test_contract.py PROGRAM [unittest options]"""
import csv
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = ""
ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
CASE_B = ROOT / "prm/paper/case_b.prm"
SMALL = ["Mesh/Core cells=2", "Mesh/Rings=2", "Mesh/Layers=2", "Mesh/Degree=1"]
HISTORY = ("step,ux,uy,uz,force_x,force_y,force_z,max_slip,max_accumulated_slip,min_pressure,max_pressure,n_open,"
           "n_stick,n_slip,stick_area,dissipation,total_dissipation,elastic_energy,method,iterations,residual")
PROBE = "step,uz,slip_x,slip_y,accumulated_slip,force_n,force_x,force_y,pressure,traction_x,traction_y,status"
PHASES = {"mesh", "assembly", "factorization", "condensation", "contact", "checks", "output", "mesh_search", "total"}


class ContractTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_program(self, *arguments, settings=(), file=CASE_B):
        words = [f"--set={setting}" for setting in settings]
        return subprocess.run([PROGRAM, file, *words, *arguments], cwd=self.folder, text=True, capture_output=True,
                              timeout=300, check=False)

    def history(self, name="run"):
        with open(self.folder / name / "history.csv", encoding="ascii") as file:
            return list(csv.DictReader(file))

    def test_run_folder(self):
        result = self.run_program("--output", "run", settings=SMALL)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        run = self.folder / "run"
        self.assertEqual((run / "input.prm").read_text(), CASE_B.read_text())
        self.assertEqual((run / "history.csv").read_text().splitlines()[0], HISTORY)
        self.assertEqual((run / "probe-P.csv").read_text().splitlines()[0], PROBE)
        self.assertEqual((run / "timing.csv").read_text().splitlines()[0], "step,seconds,iterations")
        self.assertEqual([row["step"] for row in self.history()], [str(step) for step in range(1, 46)])
        for kind in ("contact", "volume"):
            self.assertEqual(len(list(run.glob(f"{kind}-*.vtu"))), 45)
        summary = json.loads((run / "summary.json").read_text())
        self.assertEqual(set(summary["seconds"]), PHASES)
        self.assertEqual((summary["status"], summary["steps"]["solved"]), ("complete", 45))
        self.assertEqual(summary["peaks"]["force_z_N"]["step"], 5)
        self.assertGreater(summary["critical_friction"]["factor"], 1)
        self.assertIn("BLAS", (run / "log.txt").read_text())
        self.assertEqual(result.stdout.count("\nstep "), 45)
        self.assertFalse(list(run.glob("*.part")))

    def test_friction_beyond_the_critical_one_is_told_once(self):
        settings = ["Friction/Coefficients=6, 3", "Load program/Legs=0 0 -0.01 : 1"]
        result = self.run_program("--output", "run", settings=[*SMALL, *settings, "Load program/Cycles=1"])
        self.assertEqual(result.stdout.count("warning: critical friction"), 1, result.stdout)
        summary = json.loads((self.folder / "run/summary.json").read_text())
        self.assertLess(summary["critical_friction"]["factor"], 1)
        self.assertRegex(summary["warnings"][-1], "^critical friction .* several solutions")

    def test_parameters_repeat_the_run(self):
        self.run_program("--output", "first", settings=["Mesh/Core cells=4", "Load program/Cycles=1"])
        again = self.run_program("--output", "second", file=self.folder / "first/parameters.prm")
        self.assertEqual(again.returncode, 0, again.stderr)
        for name in ("history.csv", "probe-P.csv", "contact-0007.vtu", "volume-0007.vtu"):
            with self.subTest(name):
                self.assertEqual((self.folder / "first" / name).read_bytes(), (self.folder / "second" / name).read_bytes())

    def test_files_of_an_earlier_run_do_not_mix(self):
        self.run_program("--output", "run", settings=SMALL)
        (self.folder / "run/notes.txt").write_text("mine")
        self.run_program("--output", "run", settings=[*SMALL, "Load program/Cycles=1", "Output/Volume fields=4"])
        self.assertEqual(len(self.history()), 15)
        names = sorted(file.name for file in (self.folder / "run").glob("volume-*.vtu"))
        self.assertEqual(names, [f"volume-{step:04d}.vtu" for step in (4, 8, 12, 15)])
        self.assertEqual((self.folder / "run/notes.txt").read_text(), "mine")

    def test_files_that_no_run_left_are_safe(self):
        (self.folder / "mine").mkdir()
        (self.folder / "mine/log.txt").write_text("precious")
        result = self.run_program("--output", "mine", settings=SMALL)
        self.assertEqual(result.returncode, 4)
        self.assertRegex(result.stderr, r"^orthocone: mine: cannot be the run folder \(it holds a log\.txt that no run left")
        self.assertEqual([(file.name, file.read_text()) for file in (self.folder / "mine").iterdir()],
                         [("log.txt", "precious")])

    def test_full_standard_output(self):
        with open("/dev/full", "w", encoding="ascii") as full:
            result = subprocess.run([PROGRAM, "--defaults"], stdout=full, stderr=subprocess.PIPE, text=True, check=False)
        self.assertEqual((result.returncode, result.stderr), (4, "orthocone: standard output: cannot be written\n"))

    def test_terminal_line_shows_the_times(self):
        try:
            leader, follower = os.openpty()
        except OSError as error:
            self.skipTest(f"no pseudo-terminal here ({error})")
        with subprocess.Popen([PROGRAM, CASE_B, *[f"--set={setting}" for setting in SMALL]], stdout=follower,
                              cwd=self.folder) as process:
            os.close(follower)
            text = b""
            while piece := self.read_from(leader):
                text += piece
            self.assertEqual(process.wait(), 0)
        os.close(leader)
        lines = text.decode().split("\r\x1b[K")[1:]
        self.assertEqual(len(lines), 45)
        for line in lines:
            self.assertRegex(line, r"^step \d+ of 45, \d+\.\d s, \d+\.\d s left: ")

    @staticmethod
    def read_from(descriptor):
        try:
            return os.read(descriptor, 65536)
        except OSError:  # the other side is closed
            return b""

    def test_unsolved_step(self):
        settings = [*SMALL, "Contact solver/Method=feng2006", "Friction/Slip potential=0.01, 0.3",
                    "Contact solver/Maximum iterations=50", "Load program/Legs=0 0 0 : 1 ; 0 0 -0.1 : 2"]
        result = self.run_program("--output", "run", settings=settings)
        self.assertEqual(result.returncode, 3)
        self.assertRegex(result.stderr, r"^orthocone: load step 2 of 9 .*feng2006.*residual .* > tolerance .*worst node "
                                        r"at \(.*\n.*newton")
        self.assertEqual(len(result.stderr.splitlines()), 2)
        self.assertEqual([row["step"] for row in self.history()], ["1"])
        self.assertTrue((self.folder / "run/contact-0001.vtu").exists())
        self.assertFalse((self.folder / "run/contact-0002.vtu").exists())
        summary = json.loads((self.folder / "run/summary.json").read_text())
        self.assertEqual(summary["steps"], {"planned": 9, "solved": 1})
        self.assertIn("load step 2", summary["status"])

    def test_quiet_and_default_folder(self):
        result = self.run_program("--quiet", settings=SMALL)
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))
        self.assertTrue((self.folder / "output/case_b/history.csv").exists())

    def test_information(self):
        for option, expected in (("--help", "--set"), ("--version", "deal.II 9"), ("--defaults", "subsection Mesh")):
            result = self.run_program(option)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            self.assertIn(expected, result.stdout)
        self.assertEqual(list(self.folder.iterdir()), [])

    def verified(self, name, *settings):
        file = ROOT / f"prm/verification/{name}.prm"
        result = self.run_program("--output", "run", "--quiet", settings=settings, file=file)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return {key: float(value) for key, value in self.history()[-1].items() if key != "method"}

    def test_patch_test(self):
        row = self.verified("patch_test")
        for pressure in (row["min_pressure"], row["max_pressure"]):
            self.assertAlmostEqual(pressure / 2100, 1, delta=1e-6)
        self.assertAlmostEqual(row["max_slip"] / 0.03, 1, delta=1e-6)
        self.assertAlmostEqual(row["force_z"] / (2100 * math.pi * 100), 1, delta=1e-3)  # the rim is a parabola a cell

    def test_gross_sliding(self):
        for slip_ellipse, ratio, angle in (("0.8, 0.4", 0.73756, 14.04), ("1, 1", 0.50596, 45)):
            row = self.verified("gross_sliding", f"Friction/Slip potential={slip_ellipse}")
            force = math.hypot(row["force_x"], row["force_y"])
            self.assertAlmostEqual(force / row["force_z"], ratio, delta=5e-6)
            self.assertAlmostEqual(math.degrees(math.atan2(-row["force_y"], -row["force_x"])), angle, delta=5e-3)
            self.assertEqual(row["n_stick"], 0)  # some nodes at the trailing rim are lifted, the others slip

    def test_shipped_files_are_read(self):
        files = sorted((ROOT / "prm/paper").rglob("*.prm"))
        self.assertGreaterEqual(len(files), 9)
        for file in files:
            if file.name in ("scene.prm", "bricks.prm"):
                continue  # parts that the cases include
            with self.subTest(file.name):
                result = self.run_program("--check", file=file)
                self.assertEqual((result.returncode, result.stderr), (0, ""))
                expected = ("full" if file.stem.endswith(("_q1", "_printed")) else
                            "axisymmetric" if file.stem == "case_a" else "quarter")
                self.assertRegex(result.stdout, rf"^model +{expected}\b")


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
