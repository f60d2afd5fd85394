# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Bodies solved by multigrid: the states that a factorization finds, and runs that go on to the last bit.

Usage: test_multigrid.py PROGRAM [unittest options]"""
import json
import signal
import sys
import time

sys.dont_write_bytecode = True  # the source tree stays clean
from multigrid_scenes import ISOTROPIC, ONE_CYCLE, SCENES, differences, numbers  # noqa: E402
from program import ROOT, RunTest, main  # noqa: E402
from resumed_runs import DONE, EVERY_STEP, ResumeTest  # noqa: E402

class SameStatesTest(RunTest):
    BACKENDS = ("condensed", "multigrid")

    def compared(self, name):
        results = []
        for backend in self.BACKENDS:
            folder = f"{name}, {backend}"
            results.append(numbers(self.rows(folder)))
            solver = json.loads((self.folder / folder / "summary.json").read_text())["contact_solver"]
            self.assertEqual("v_cycles" in solver, backend == "multigrid")
        return results

    def test_scenes(self):
        """What differences() compares, to ten times the tolerance of its scale."""
        runs = {(name, backend): self.command(f"{name}, {backend}", settings=[*settings, f"Mesh/Backend={backend}"],
                                              file=ROOT / "prm" / file)
                for name, (file, settings) in SCENES.items() for backend in self.BACKENDS}
        answers = dict(zip(runs, self.run_all(*runs.values()), strict=True))
        for name, (_, settings) in SCENES.items():
            with self.subTest(scene=name):
                for backend in self.BACKENDS:
                    answer = answers[name, backend]
                    self.assertEqual((answer["exit"], answer["message"]), (DONE, ""))
                condensed, multigrid = self.compared(name)
                self.assertEqual(condensed["cycle"], multigrid["cycle"])
                self.assertEqual(condensed["worn_volume"][-1] > 0, "Wear/Law=archard" in settings)
                for column, difference in differences(condensed, multigrid).items():
                    self.assertLessEqual(difference, 10, column)

    def test_a_loose_tolerance_leaves_the_body_in_equilibrium(self):
        """Checks/Equilibrium does not get looser with the contact solver."""
        result = self.run_program("run", settings=[*ISOTROPIC, *ONE_CYCLE, "Mesh/Backend=multigrid", "Mesh/Refinements=1",
                                                   "Contact solver/Tolerance=1e-4"])
        self.assertEqual((result.returncode, result.stderr), (DONE, ""))

    def test_a_response_that_is_periodic_takes_no_iterations(self):
        """In the second cycle of case B, every state is that of the first one, and so is every body."""
        result = self.run_program("run", settings=[*ISOTROPIC, "Mesh/Backend=multigrid", "Mesh/Refinements=1",
                                                   "Load program/Cycles=2"])
        self.assertEqual((result.returncode, result.stderr), (DONE, ""))
        iterations = [int(row["iterations"]) for row in self.rows("run")]
        self.assertGreater(sum(iterations[:15]), 15)
        self.assertEqual(sum(iterations[15:]), 0)
        v_cycles = [int(row["v_cycles"]) for row in self.rows("run", "timing.csv")]
        summary = json.loads((self.folder / "run/summary.json").read_text())
        self.assertEqual(sum(v_cycles), summary["contact_solver"]["v_cycles"])
        self.assertEqual(sum(v_cycles[15:]), 0)
        self.assertEqual(max(v_cycles[1:5]), 0)  # proportional to the first


    def test_a_step_costs_few_elastic_solutions(self):
        """In the first cycle: mean and worst step. An elastic solution is seven V-cycles."""
        elastic = 7
        for case, mean, worst in (("b", 2, 3.5), ("c", 3, 6)):
            result = self.run_program(case, file=ROOT / f"prm/paper/case_{case}.prm", settings=[
                *ISOTROPIC, "Mesh/Backend=multigrid", "Mesh/Refinements=2", "Load program/Cycles=1",
                "Contact solver/Tolerance=1e-8", "Output/Volume fields=0"])
            self.assertEqual((result.returncode, result.stderr), (DONE, ""))
            v_cycles = [int(row["v_cycles"]) for row in self.rows(case, "timing.csv")]
            self.assertLessEqual(sum(v_cycles), mean * elastic * len(v_cycles))
            self.assertLessEqual(max(v_cycles), worst * elastic)


class ResumedTest(ResumeTest):
    SETTINGS = [*ISOTROPIC, "Mesh/Refinements=1", "Mesh/Backend=multigrid", "Load program/Cycles=2", EVERY_STEP]
    RESULTS = ["history.csv", "checks.csv", "cycles.csv", "contact.pvd", "contact-0030.vtu"]

    def assert_goes_on(self, settings, n_steps):
        """Kills a run after some steps, and resumes it."""
        name = f"after-{n_steps}"
        run = self.start(name, settings)
        history = self.folder / name / "history.csv"
        while run.poll() is None and (not history.exists() or history.read_text().count("\n") <= n_steps):
            time.sleep(0.002)
        run.send_signal(signal.SIGKILL)
        run.communicate()
        self.assertEqual(run.returncode, -signal.SIGKILL, "it has ended before")
        self.assert_resumes(name, settings)

    def test_to_the_last_bit(self):
        """What later steps start from is in the checkpoint, wherever the run was interrupted."""
        self.whole(self.SETTINGS, self.RESULTS)
        for n_steps in (3, 8, 20):
            with self.subTest(steps=n_steps):
                self.assert_goes_on(self.SETTINGS, n_steps)

    def test_every_coarser_mesh_has_a_history(self):
        """Three meshes, each of which starts from the one below it."""
        settings = [*self.SETTINGS, "Mesh/Degree=1", "Mesh/Refinements=2", "Load program/Cycles=1"]
        self.whole(settings, ["history.csv", "checks.csv", "contact-0015.vtu"])
        self.assert_goes_on(settings, 8)

    def test_halved_cells_are_not_searched_again(self):
        settings = [*self.SETTINGS, "Mesh/Adaptive=1", "Load program/Cycles=1"]
        self.whole(settings, ["history.csv", "checks.csv", "parameters.prm", "contact-0015.vtu"])
        self.assert_goes_on(settings, 8)


class UnsolvedTest(RunTest):
    def test_what_is_named_as_a_remedy_is_there(self):
        """Slip axes that differ a millionfold are too much for continuation, too."""
        settings = [*ISOTROPIC, "Load program/Legs=0 0 -0.1 : 1", "Load program/Cycles=1", "Mesh/Refinements=1",
                    "Friction/Slip potential=0.000001, 1"]
        result = self.run_program("multigrid", settings=[*settings, "Mesh/Backend=multigrid"])
        self.assertEqual(result.returncode, 3)
        self.assertIn("Mesh/Backend = condensed", result.stderr)
        self.assertNotIn("gauss-seidel", result.stderr)
        result = self.run_program("condensed", settings=[*settings, "Mesh/Backend=condensed"])
        self.assertEqual((result.returncode, result.stderr), (DONE, ""))


    def test_a_body_that_cannot_be_solved_ends_the_run_at_its_step(self):
        """Multigrid gives up on bodies that hardly change their volume, after 200 iterations."""
        result = self.run_program("run", settings=[*ISOTROPIC, *ONE_CYCLE, "Mesh/Backend=multigrid",
                                                   "Material/Poisson ratio=0.499999"])
        self.assertEqual(result.returncode, 3)
        self.assertRegex(result.stderr, r"^orthocone: load step 1 of 6 \(u_z = -0.05 mm\) is not solved: multigrid: .*"
                                        r"not in equilibrium.*Poisson ratio.*The files of earlier steps are kept\n"
                                        r"In .*: log\.txt describes every step")
        summary = json.loads((self.folder / "run/summary.json").read_text())
        self.assertEqual(summary["steps"], {"planned": 6, "solved": 0})
        self.assertIn("is not solved: multigrid", summary["status"])
        resumed = self.run_program("run", "--resume", settings=[*ISOTROPIC, *ONE_CYCLE, "Mesh/Backend=multigrid",
                                                                "Material/Poisson ratio=0.499999"])
        self.assertEqual((resumed.returncode, resumed.stderr), (3, result.stderr))


class ChosenTest(RunTest):
    """Mesh/Backend = auto."""
    SETTINGS = [*ISOTROPIC, "Load program/Cycles=1"]

    def test_a_run_reports_and_keeps_its_choice(self):
        result = self.run_program("run", settings=[*self.SETTINGS, *ONE_CYCLE, "Mesh/Refinements=1"])
        self.assertEqual((result.returncode, result.stderr), (DONE, ""))
        self.assertRegex((self.folder / "run/log.txt").read_text(),
                         r"backend +condensed about \S+ s and \S+ GB; multigrid about \S+ s and \S+ GB\n")
        self.assertRegex((self.folder / "run/parameters.prm").read_text(), r"set Backend += condensed\n")

    def test_check_reports_it(self):
        result = self.run_program("run", "--check", settings=[*self.SETTINGS, "Mesh/Refinements=3"])
        self.assertEqual((result.returncode, result.stderr), (DONE, ""))
        self.assertRegex(result.stdout, r"backend +multigrid about .*; condensed about .*\n")
        self.assertIn("elastic body   multigrid", result.stdout)

    def test_nothing_is_said_where_nothing_is_chosen(self):
        result = self.run_program("run", "--check", settings=self.SETTINGS)
        self.assertNotIn("backend", result.stdout)

    def test_stretched_cells_are_warned_of(self):
        flat = [*self.SETTINGS, "Geometry/Height=0.2", "Mesh/Refinements=1", "Load program/Legs=0 0 -1e-3 : 1"]
        warning = "multigrid takes V-cycles in proportion"
        for backend in ("condensed", "multigrid"):
            result = self.run_program(backend, settings=[*flat, f"Mesh/Backend={backend}"])
            self.assertEqual((result.returncode, result.stderr), (DONE, ""))
            self.assertEqual(warning in (self.folder / backend / "summary.json").read_text(), backend == "multigrid")


class SearchedTest(RunTest):
    def test_an_accuracy_keeps_the_backend(self):
        result = self.run_program("run", file=ROOT / "prm/paper/case_b.prm", settings=[
            "Mesh/Accuracy=3 %", "Mesh/Backend=multigrid", "Load program/Cycles=1", "Output/Volume fields=0"])
        self.assertEqual((result.returncode, result.stderr), (DONE, ""))
        summary = json.loads((self.folder / "run/summary.json").read_text())
        self.assertEqual(summary["model"]["backend"], "multigrid")
        self.assertTrue(summary["accuracy"]["reached"])


class RefusedTest(RunTest):
    def refused(self, *settings, file="paper/case_b.prm"):
        result = self.run_program("run", settings=["Mesh/Backend=multigrid", *settings], file=ROOT / "prm" / file)
        self.assertEqual(result.returncode, 2)
        self.assertEqual(result.stderr.count("\n"), 1)
        self.assertFalse((self.folder / "run").exists())
        return result.stderr

    def test_sections(self):
        self.assertIn("Mesh/Backend = multigrid with the axisymmetric model", self.refused(file="paper/case_a.prm"))

    def test_methods_that_need_a_matrix(self):
        for method in ("gauss-seidel", "uzawa", "box3", "feng2006", "plain-newton"):
            self.assertIn(f"Contact solver/Method = {method}", self.refused(f"Contact solver/Method={method}"))


if __name__ == "__main__":
    main()
