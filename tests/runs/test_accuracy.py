# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Mesh/Resolution and Mesh/Accuracy: what the run folder says of the mesh, and how such a run goes on.

Usage: test_accuracy.py PROGRAM [unittest options]"""
import json
import signal
import subprocess
import sys
import time

sys.dont_write_bytecode = True  # the source tree stays clean
from program import ROOT, RunTest, main  # noqa: E402

PROGRAM = "Load program/Legs=0 0 -0.1 : 1; 0 0 -0.08 : 2"
SETTINGS = [PROGRAM, "Load program/Cycles=2", "Output/Volume fields=0", "Output/Checkpoint=0"]
ACCURACY = [*SETTINGS, "Mesh/Accuracy=10 %"]
QUANTITIES = ["largest_slip_mm", "peak_force_N", "dissipation_Nmm", "stick_area_mm2"]


class AccuracyTest(RunTest):
    def summary(self, output):
        return json.loads((self.folder / output / "summary.json").read_text())

    def quantities(self, output):
        """Those of the first cycle, from the history."""
        rows = self.rows(output)[:3]
        return [max(float(row["max_slip"]) for row in rows), float(rows[0]["force_z"]),
                float(rows[2]["total_dissipation"]), float(rows[0]["stick_area"])]

    def assert_done(self, output, *arguments, **options):
        result = self.run_program(output, *arguments, **options)
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def test_estimates_stand_beside_the_values(self):
        self.assert_done("run", settings=ACCURACY)
        accuracy = self.summary("run")["accuracy"]
        self.assertEqual(accuracy["wanted_percent"], 10)
        self.assertTrue(accuracy["reached"])
        log = (self.folder / "run/log.txt").read_text()
        for name, value in zip(QUANTITIES, self.quantities("run")):
            self.assertAlmostEqual(accuracy[name]["value"] / value, 1, 6)
            self.assertTrue(0 <= accuracy[name]["estimated_error_percent"] <= 10, accuracy)
            self.assertIn(name, log)
        self.assertIn("10 % wanted, reached", log)

    def test_only_named_quantities_count(self):
        """Without the stick area the search ends on an earlier level, whose own estimate of the stick area is too large: only
        then has the entry saved anything."""
        wanted = [*ACCURACY, "Mesh/Accuracy=1 %"]
        self.assert_done("all", settings=wanted)
        self.assert_done("named", settings=[*wanted, "Mesh/Accuracy of=dissipation, peak force"])
        of_all, named = (self.summary(run)["accuracy"] for run in ("all", "named"))
        self.assertEqual((of_all["of"], named["of"]), ("all", "peak force, dissipation"))
        self.assertTrue(of_all["reached"] and named["reached"])
        nodes = [self.summary(run)["model"]["contact_nodes"] for run in ("all", "named")]
        self.assertGreater(nodes[0], nodes[1])
        for name in ("peak_force_N", "dissipation_Nmm"):
            self.assertLessEqual(named[name]["estimated_error_percent"], 1)
        others = [named[name]["estimated_error_percent"] for name in ("largest_slip_mm", "stick_area_mm2", "loop_area_Nmm")]
        self.assertGreater(max(others), 1)
        self.assertIn("1 % wanted of peak force, dissipation, reached", (self.folder / "named/log.txt").read_text())
        self.assertRegex((self.folder / "named/parameters.prm").read_text(), r"(?m)set Accuracy of += all$")

    def test_parameters_of_the_run_are_those_of_the_chosen_mesh(self):
        self.assert_done("run", settings=ACCURACY)
        complete = self.folder / "run/parameters.prm"
        self.assertRegex(complete.read_text(), r"(?m)set Accuracy += 0$")
        self.assert_done("again", file=complete)
        models = [self.summary(output)["model"] for output in ("again", "run")]
        for model in models:
            model.pop("reason")  # the cells are those of one model, which the parameters name
        self.assertEqual(*models)
        self.assertNotIn("accuracy", self.summary("again"))
        for row, other in zip(self.rows("run"), self.rows("again")):
            for name in ("max_slip", "force_z", "total_dissipation", "stick_area"):
                self.assertAlmostEqual(float(row[name]), float(other[name]), delta=1e-6 * abs(float(row[name])))

    def test_adaptive_cells_stand_in_the_parameters(self):
        for model in ("quarter", "axisymmetric"):
            with self.subTest(model=model):
                settings = [*SETTINGS, f"Mesh/Model={model}", "Friction/Coefficients=0.2, 0.2", "Friction/Slip potential=associated",
                            "Mesh/Core cells=2",
                            "Mesh/Rings=2", "Mesh/Layers=2"]
                self.assert_done("adapted", settings=[*settings, "Mesh/Adaptive=2"])
                complete = self.folder / "adapted/parameters.prm"
                self.assertRegex(complete.read_text(), r"(?m)set Adaptive += 0$")
                self.assertRegex(complete.read_text(), r"(?m)set Refined cells += [0-9 -]+; [0-9 -]+$")
                self.assertRegex((self.folder / "adapted/log.txt").read_text(), "(?m)^adaptive +round 2, .* cells follow$")
                self.assert_done("again", file=complete)
                self.assert_same_files("adapted", "again", ["history.csv", "probe-P.csv"])
                self.assert_done("even", settings=settings)
                self.assertGreater(self.summary("again")["model"]["contact_nodes"],
                                   self.summary("even")["model"]["contact_nodes"])

    def test_check_announces_rounds_to_come(self):
        result = self.run_program("none", "--check", settings=[*SETTINGS, "Mesh/Adaptive=3"])
        self.assertEqual(result.returncode, 0)
        self.assertIn("adaptive       3 rounds of refinement by the run", result.stdout)

    def test_estimates_bound_the_differences_to_a_finer_mesh(self):
        """tools/studies/error_estimates.py does this for many scenes and accuracies."""
        for case in ("b", "c"):
            file = ROOT / f"prm/paper/case_{case}.prm"
            self.assert_done(case, file=file, settings=[*SETTINGS, "Mesh/Accuracy=5 %"])
            self.assert_done("finer", file=file, settings=[*SETTINGS, "Mesh/Resolution=fine"])
            accuracy = self.summary(case)["accuracy"]
            for name, truth in zip(QUANTITIES, self.quantities("finer")):
                value, estimate = accuracy[name]["value"], accuracy[name]["estimated_error_percent"]
                self.assertGreaterEqual(estimate, 100 * abs(value / truth - 1) / 3, f"{name} of case {case}")

    def test_resumes_on_the_same_mesh_without_a_search(self):
        self.assert_done("whole", settings=ACCURACY)
        run = subprocess.Popen(self.command("stopped", settings=ACCURACY), cwd=self.folder, stderr=subprocess.PIPE)
        while run.poll() is None and not (self.folder / "stopped/checkpoint/state").exists():
            time.sleep(0.01)
        run.send_signal(signal.SIGTERM)
        run.communicate()
        (self.folder / "stopped/log.txt").write_text("")
        self.assert_done("stopped", "--resume", settings=ACCURACY)
        self.assertNotIn("level", (self.folder / "stopped/log.txt").read_text())
        self.assert_same_files("whole", "stopped", ["history.csv", "probe-P.csv", "parameters.prm"])
        self.assertEqual(self.summary("stopped")["accuracy"], self.summary("whole")["accuracy"])

    def test_a_folder_that_cannot_be_used_is_reported_before_the_search(self):
        (self.folder / "run").mkdir()
        (self.folder / "run/history.csv").write_text("of somebody else\n")
        result = subprocess.run([word for word in self.command("run", settings=ACCURACY) if word != "--quiet"],
                                capture_output=True, text=True, timeout=60, check=False, cwd=self.folder)
        self.assertEqual((result.returncode, result.stdout), (4, ""))
        self.assertRegex(result.stderr, r"^orthocone: .*run: cannot be the run folder.*history\.csv.*\n$")
        self.assertEqual((self.folder / "run/history.csv").read_text(), "of somebody else\n")

    def test_another_accuracy_is_another_run(self):
        self.assert_done("run", settings=ACCURACY)
        result = self.run_program("run", "--resume", settings=[*SETTINGS, "Mesh/Accuracy=9 %"])
        self.assertEqual(result.returncode, 2)
        self.assertIn("Mesh/Accuracy = 9 %, but the run in ", result.stderr)

    def test_check_says_who_chooses_the_mesh(self):
        result = self.run_program("none", "--check", settings=ACCURACY)
        self.assertEqual(result.returncode, 0)
        self.assertIn("mesh           is chosen by the run, for errors of 10 %\n", result.stdout)
        self.assertFalse((self.folder / "none").exists())

    def test_a_resolution_stands_for_entries(self):
        self.assert_done("run", settings=[*SETTINGS, "Mesh/Resolution=coarse"])
        text = (self.folder / "run/parameters.prm").read_text()
        self.assertRegex(text, r"set Resolution += custom")
        self.assertRegex(text, r"set Core cells += 4")
        check = self.run_program("none", "--check", settings=["Mesh/Resolution=coarse"]).stdout
        self.assertIn(f"contact nodes  {self.summary('run')['model']['contact_nodes']}\n", check)

    def test_paper_is_the_mesh_without_any_entry(self):
        paper, custom = (self.run_program("none", "--check", settings=settings).stdout.split("\nmemory")[0]
                         for settings in (["Mesh/Resolution=paper"], []))
        self.assertIn("contact nodes", paper)
        self.assertEqual(paper, custom)


class StepAccuracyTest(RunTest):
    """Load program/Accuracy. What it promises of the true errors is in tests/unit/accuracy/step_search.cc."""
    SETTINGS = ["Load program/Legs=0 0 -0.1 : 1; 0 0 0 : 4", "Load program/Cycles=2", "Output/Volume fields=0",
                "Output/Checkpoint=0"]
    ACCURACY = [*SETTINGS, "Load program/Accuracy=1 %"]

    def summary(self, output):
        return json.loads((self.folder / output / "summary.json").read_text())

    def assert_done(self, output, *arguments, **options):
        result = self.run_program(output, *arguments, **options)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return result

    def test_states_are_written_at_the_steps_of_the_legs(self):
        self.assert_done("run", settings=self.ACCURACY)
        self.assert_done("given", settings=self.SETTINGS)
        rows, given = self.rows("run"), self.rows("given")
        self.assertEqual([row["uz"] for row in rows], [row["uz"] for row in given])
        self.assertEqual(len(rows), 10)
        legs = self.summary("run")["scene"]["legs"]
        self.assertRegex(legs, r"^0 0 -0\.1 : 1; 0 0 0 : 4 \* \d+$", "nothing errs while all is proportional")
        accuracy = self.summary("run")["step_accuracy"]
        self.assertEqual((accuracy["wanted_percent"], accuracy["reached"]), (1, True))
        error = abs(float(given[-1]["total_dissipation"]) / float(rows[-1]["total_dissipation"]) - 1)
        self.assertGreater(error, 0.01, "given steps are not good enough")
        log = (self.folder / "run/log.txt").read_text()
        self.assertRegex(log, r"load steps +10 in \d+ parts\n")

    def test_divided_legs_are_those_of_the_parameters_kept(self):
        self.assert_done("run", settings=self.ACCURACY)
        self.assert_done("again", file=self.folder / "run/parameters.prm")
        self.assert_same_files("run", "again", ["history.csv", "cycles.csv", "checks.csv", "parameters.prm"])

    def test_both_accuracies_share_the_error(self):
        self.assert_done("run", settings=[*self.SETTINGS, "Mesh/Accuracy=10 %", "Load program/Accuracy=4 %"])
        summary = self.summary("run")
        self.assertEqual(summary["step_accuracy"]["wanted_percent"], 3)
        self.assertTrue(summary["accuracy"]["reached"])
        for name, errors in summary["estimated_errors_percent"].items():
            self.assertLessEqual(errors["mesh"] + errors["steps"], 10, name)
            self.assertLess(errors["solver"], 1e-3, name)

    def test_resumes_with_the_same_parts_without_a_search(self):
        self.assert_done("whole", settings=self.ACCURACY)
        run = subprocess.Popen(self.command("stopped", settings=self.ACCURACY), cwd=self.folder, stderr=subprocess.PIPE)
        while run.poll() is None and not (self.folder / "stopped/checkpoint/state").exists():
            time.sleep(0.001)
        run.kill()
        run.communicate()
        (self.folder / "stopped/log.txt").write_text("")
        self.assert_done("stopped", "--resume", settings=self.ACCURACY)
        self.assertNotIn("accuracy  ", (self.folder / "stopped/log.txt").read_text())
        self.assert_same_files("whole", "stopped", ["history.csv", "checks.csv", "cycles.csv", "parameters.prm"])
        self.assertEqual(self.summary("stopped")["step_accuracy"], self.summary("whole")["step_accuracy"])

    def test_check_says_who_divides_the_steps(self):
        result = self.run_program("none", "--check", settings=self.ACCURACY)
        self.assertIn("load steps     10, divided by the run for errors of 1 %\n", result.stdout)
        result = self.run_program("none", "--check", settings=["Load program/Legs=0 0 -0.1 : 2 * 3; 0 0 0 : 4"])
        self.assertIn("load steps     18 in 30 parts\n", result.stdout)


if __name__ == "__main__":
    main()
