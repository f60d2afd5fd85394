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
           "n_stick,n_slip,stick_area,dissipation,total_dissipation,elastic_energy,method,iterations,residual,"
           "rx,ry,rz,moment_x,moment_y,moment_z,cycle,phase,driven,worn_volume,max_wear_depth,contact_area,"
           "held_force_x,held_force_y,held_force_z,held_moment_x,held_moment_y,held_moment_z,time")
PROBE = "step,uz,slip_x,slip_y,accumulated_slip,force_n,force_x,force_y,pressure,traction_x,traction_y,status,slip_z,force_z,traction_z"
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
        for line in CASE_B.read_text().splitlines():
            self.assertTrue(line.startswith("include ") or line in (run / "input.prm").read_text(), line)
        self.assertEqual((run / "history.csv").read_text().splitlines()[0], HISTORY)
        self.assertEqual((run / "probe-P.csv").read_text().splitlines()[0], PROBE)
        self.assertEqual((run / "timing.csv").read_text().splitlines()[0], "step,seconds,iterations,v_cycles,gmres_iterations")
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

    def test_friction_beyond_the_critical_one_is_reported_once(self):
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
        self.assertEqual(result.returncode, 4, result.stderr)
        self.assertRegex(result.stderr, r"^orthocone: mine: cannot be the run folder \(it holds a log\.txt, and no run ")
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
        for step, line in enumerate(lines, start=1):
            self.assertRegex(line, rf"^\[#*-*\] step {step} of 45, \d+\.\d s, \d+\.\d s left: ")
            self.assertLess(len(line.splitlines()[0]), 80)
            self.assertEqual(line.partition("]")[0].count("#"), 10 * step // 45)

    @staticmethod
    def read_from(descriptor):
        try:
            return os.read(descriptor, 65536)
        except OSError:  # the other side is closed
            return b""

    def test_models_agree_where_nodes_lift_off(self):
        """The smallest part that is exact is exact in every column, also where nodes leave the plane."""
        common = ["Geometry/Radius=12", "Geometry/Height=9", "Material/Young modulus=1000", "Friction/Coefficients=0.4, 0.2",
                  "Friction/Slip potential=0.3, 0.25", "Contact solver/Tolerance=1e-12", "Mesh/Core cells=4",
                  "Mesh/Layers=2", "Mesh/Degree=1", "Output/Probes=", "Load program/Cycles=2"]
        for models, legs in ((("full", "half"), "0 0 -0.05 : 3; 0.03 0 -0.05 : 5; 0.03 0 0.01 : 1"),
                             (("full", "half", "quarter"), "0 0 -0.05 : 3; 0 0 0.01 : 1; 0 0 -0.02 : 1")):
            for model in models:
                result = self.run_program("--output", model, settings=[*common, f"Mesh/Model={model}",
                                                                       f"Load program/Legs={legs}"])
                self.assertEqual(result.returncode, 0, result.stderr)
            for table, left_out in (("history.csv", {"method", "iterations", "residual"}), ("cycles.csv", {"iterations"})):
                whole = self.columns("full", table)
                for model in models[1:]:
                    part = self.columns(model, table)
                    for name in set(whole) - left_out:
                        # What cancels in a component is rounding of the others.
                        alike = [key for key in whole if key.split("_")[0] == name.split("_")[0] or key == name or
                                 (key, name.split("_")[0]) == ("force_z", "moment")]
                        largest = max((abs(value) for key in alike for value in whole[key] if not math.isnan(value)), default=0)
                        for a, b in zip(whole[name], part[name]):
                            self.assertEqual(math.isnan(a), math.isnan(b), f"{model} {table} {name}")
                            if not math.isnan(a):
                                self.assertLessEqual(abs(a - b), 1e-8 * largest,
                                                     f"{model} {table} {name}")

    def columns(self, name, table):
        with open(self.folder / name / table, encoding="ascii") as file:
            rows = list(csv.DictReader(file))
        return {key: [float(row[key]) for row in rows] for key in rows[0] if key not in ("method", "driven")}

    def test_friction_is_associated_unless_set_otherwise(self):
        """Without Slip potential isotropic coefficients are isotropic, and orthotropic ones slip normal to their ellipse."""
        for settings, expected in ((["Friction/Coefficients=0.2, 0.2"], (True, True)),
                                   (["Friction/Coefficients=0.1, 0.4"], (True, False)),
                                   (["Friction/Coefficients=0.1, 0.4", "Friction/Slip potential=1, 1"], (False, True))):
            file = self.folder / "case.prm"
            file.write_text("subsection Mesh\n  set Core cells = 2\n  set Layers = 1\n  set Degree = 1\nend\n"
                            "subsection Load program\n  set Legs = 0 0 -0.1 : 2\nend\n")
            result = self.run_program("--output", "run", settings=settings, file=file)
            self.assertEqual(result.returncode, 0, result.stderr)
            friction = json.loads((self.folder / "run/summary.json").read_text())["friction"]
            self.assertEqual((friction["associated"], friction["collinear"]), expected)
            line = f"friction       mu {settings[0][22:]}; {'' if expected[0] else 'not '}associated"
            self.assertIn(line, result.stdout)
            self.assertIn(line, (self.folder / "run/log.txt").read_text())
            self.assertIn(line, self.run_program("--check", settings=settings, file=file).stdout)
        given, _ = [self.run_program("--output", name, settings=[*SMALL, "Friction/Coefficients=0.1, 0.4",
                                                              f"Friction/Slip potential={p}"])
                   for name, p in (("given", "0.1, 0.4"), ("word", "associated"))]
        self.assertEqual(given.returncode, 0)
        self.assertEqual((self.folder / "given/history.csv").read_bytes(), (self.folder / "word/history.csv").read_bytes())

    def test_no_friction(self):
        """Without friction no force is tangential, nothing is dissipated, and all that touches slips."""
        settings = [*SMALL, "Mesh/Model=full", "Friction/Coefficients=0, 0",
                    "Load program/Legs=0 0 -0.1 : 2; 0.05 0.02 -0.1 : 2; 0 0 0 : 2"]
        for method in ("newton", "gauss-seidel", "uzawa"):
            result = self.run_program("--output", "run", settings=[*settings, f"Contact solver/Method={method}"])
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            for row in self.history():
                self.assertEqual((row["n_stick"], float(row["total_dissipation"])), ("0", 0))
                self.assertLessEqual(max(abs(float(row["force_x"])), abs(float(row["force_y"]))), 1e-9)
            self.assertGreater(float(self.history()[1]["force_z"]), 1000)
        self.assertIsNone(json.loads((self.folder / "run/summary.json").read_text())["critical_friction"])
        # Next to none: forces of nodes that slip are next to none, too, and unloading is no trouble.
        for friction in ("1e-12, 1e-12", "1e-14, 1e-12"):
            result = self.run_program("--output", "run", settings=[*settings, f"Friction/Coefficients={friction}"])
            self.assertEqual((result.returncode, result.stderr), (0, ""), friction)

    def test_energy_shows_too_few_steps(self):
        """What is missing in the balance falls with the steps, as the error of the dissipation does."""
        missing = []
        for legs in ("0 0 -0.1 : 1; 0 0 -0.02 : 2", "0 0 -0.1 : 4; 0 0 -0.02 : 8", "0 0 -0.1 : 8; 0 0 -0.02 : 16"):
            result = self.run_program("--output", "run", settings=[*SMALL, f"Load program/Legs={legs}"])
            self.assertEqual(result.returncode, 0, result.stderr)
            summary = json.loads((self.folder / "run/summary.json").read_text())
            energy, row = summary["energy"], self.history()[-1]
            missing.append(energy["missing_percent_of_dissipation"])
            self.assertAlmostEqual(energy["dissipation_Nmm"] / float(row["total_dissipation"]), 1, delta=1e-12)
            rest = energy["work_Nmm"] - energy["dissipation_Nmm"] - float(row["elastic_energy"])
            self.assertLessEqual(abs(rest), energy["missing_Nmm"] * (1 + 1e-9) + 1e-9)
            self.assertEqual(any("because slip reverses" in warning for warning in summary["warnings"]), missing[-1] > 1)
            self.assertIn("energy: work of the held face", result.stdout)
        self.assertGreater(missing[0], 1)
        self.assertGreater(missing[0], 4 * missing[1])
        self.assertGreaterEqual(missing[1], missing[2])

    def test_unsolved_step(self):
        settings = [*SMALL, "Contact solver/Method=feng2006", "Friction/Slip potential=0.01, 0.3",
                    "Contact solver/Maximum iterations=50", "Load program/Legs=0 0 0 : 1 ; 0 0 -0.1 : 2"]
        result = self.run_program("--output", "run", settings=settings)
        self.assertEqual(result.returncode, 3)
        self.assertRegex(result.stderr, r"^orthocone: load step 2 of 9 .*feng2006.*residual .* > tolerance .*worst node "
                                        r"at \(.*\n.*newton.*\nIn run: log\.txt describes every step, history\.csv ")
        self.assertEqual(len(result.stderr.splitlines()), 3)
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
        for words in ("-h [ --help ]", "-o [ --output ]", "-q [ --quiet ]", "--insist", "example: orthocone prm/paper/"):
            self.assertIn(words, self.run_program("-h").stdout)
        result = self.run_program("-q", "-o", "short", settings=SMALL)
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))
        self.assertTrue((self.folder / "short/history.csv").exists())

    def test_blas_has_kernels_of_this_processor(self):
        """Also where OpenBLAS is older than the processor. What the environment asks for, it gets."""
        features = pathlib.Path("/proc/cpuinfo").read_text(encoding="ascii").split()
        usual = {name: value for name, value in os.environ.items() if name != "OPENBLAS_CORETYPE"}
        of = lambda environment: subprocess.run([PROGRAM, "--version"], text=True, capture_output=True, timeout=60,
                                                check=True, env=environment).stdout
        if "OpenBLAS" not in of(usual) or not {"avx2", "fma"} <= set(features):
            self.skipTest("no OpenBLAS, or no AVX2")
        self.assertNotIn("Prescott", of(usual))
        if {"avx512cd", "avx512bw", "avx512dq", "avx512vl"} <= set(features):
            self.assertNotIn("Haswell", of(usual))
        self.assertIn("Prescott", of({**usual, "OPENBLAS_CORETYPE": "Prescott"}))

    def test_dissipation_is_never_negative(self):
        """Also where all is rounding: a disc of the width of a galaxy, pressed by a tenth of a millimetre."""
        result = self.run_program("--output", "run", settings=[*SMALL, "Geometry/Radius=1e18", "Output/Probes="])
        self.assertEqual(result.returncode, 0, result.stderr)
        for row in self.history():
            self.assertGreaterEqual(min(float(row["dissipation"]), float(row["total_dissipation"])), 0)

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
