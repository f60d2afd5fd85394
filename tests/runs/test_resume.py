# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Runs that are killed or interrupted, and go on as if nothing had been.

Usage: test_resume.py PROGRAM [unittest options]"""
import json
import random
import shutil
import signal
import subprocess
import sys
import time

sys.dont_write_bytecode = True  # the source tree stays clean
from program import SMALL, main  # noqa: E402
from resumed_runs import DONE, EVERY_STEP, FILE_ERROR, INTERRUPTED, ResumeTest  # noqa: E402


class KillTest(ResumeTest):
    def test_kill_at_any_moment(self):
        """Case B, killed at 16 random moments, of which many fall into the writing of files."""
        settings = [EVERY_STEP]
        start = time.monotonic()
        self.whole(settings)
        seconds = time.monotonic() - start
        moments = random.Random(2006)
        solved = []
        for number in range(16):
            run = self.start("killed", settings)
            step = moments.randint(-1, 44)  # in time alone, starting takes as long as all steps
            while run.poll() is None and self.n_solved("killed") < step:
                time.sleep(0.001)
            time.sleep(moments.uniform(0, 2) * seconds / 45)
            run.kill()
            run.communicate()
            solved.append(self.n_solved("killed"))
            with self.subTest(number=number, solved=solved[-1]):
                self.assert_resumes("killed", settings)
            shutil.rmtree(self.folder / "killed")
        self.assertGreater(len(set(solved)), 8, f"the moments were too much alike: {solved}")

    def n_solved(self, name):
        """Rows of history.csv; -1 without one."""
        history = self.folder / name / "history.csv"
        return history.read_text().count("\n") - 1 if history.exists() else -1

    def test_kill_and_resume_again_and_again(self):
        settings = [*SMALL, EVERY_STEP]
        self.whole(settings)
        moments = random.Random(45)
        for _ in range(12):
            run = self.start("killed", settings, "--resume")
            time.sleep(moments.uniform(0.2, 0.5))
            run.kill()
            run.communicate()
        self.assert_resumes("killed", settings)

    def test_methods_keep_nothing_else(self):
        """What the solvers and their starts need is in the checkpoint: also within and between cycles."""
        for method in ("newton", "gauss-seidel", "uzawa", "feng2006"):
            settings = [*SMALL, f"Contact solver/Method={method}", "Contact solver/Tolerance=1e-6", EVERY_STEP]
            self.whole(settings)
            run = self.start("stopped", settings)
            while not list((self.folder / "stopped").glob("contact-0008.vtu")) and run.poll() is None:
                time.sleep(0.001)
            run.kill()
            run.communicate()
            with self.subTest(method):
                self.assert_resumes("stopped", settings)
            shutil.rmtree(self.folder / "stopped")

    def test_loads_and_supports_go_on_to_the_last_bit(self):
        """A body without a held face, whose loads, and the motion that the contact leaves it, are in the state."""
        for backend in ("condensed", "multigrid"):
            settings = ["Geometry/Shape=box", "Geometry/Sizes=4, 3, 2", "Output/Probes=", "Geometry/Supports=x-: x", "Geometry/Top face=free",
                        "Mesh/Cells=2, 2, 1", "Mesh/Refinements=1", f"Mesh/Backend={backend}", "Load program/Cycles=3",
                        "Load program/Loads=down: pressure on top ; bulk: traction on x+ along x ; lift: force on y+ along z",
                        "Load program/Preload=down 10 : 1", "Load program/Legs=bulk 5 lift 2 : 3 ; bulk -5 : 3", EVERY_STEP]
            with self.subTest(backend):
                self.whole(settings, ["history.csv", "checks.csv", "cycles.csv", "contact-0019.vtu"])
                run = self.start("stopped", settings)
                while not (self.folder / "stopped/contact-0009.vtu").exists() and run.poll() is None:
                    time.sleep(0.001)
                run.kill()
                run.communicate()
                self.assert_resumes("stopped", settings)
            for name in ("stopped", "whole"):
                shutil.rmtree(self.folder / name)


class SignalTest(ResumeTest):
    # So many steps that a run is not done before a busy machine lets the test send its signal.
    LONG = ["Mesh/Core cells=6", "Mesh/Degree=1", "Mesh/Model=full", "Load program/Cycles=9"]

    def test_a_step_without_end_is_stopped(self):
        """Between two iterations, since a scheduler waits for half a minute. No step is lost, and another method goes on. That
        nothing of the stopped step is left, to the last bit, is what March.StopsBetweenIterationsAndLosesNothing shows."""
        settings = self.LONG
        run = self.start("stopped", settings)
        while not (self.folder / "stopped/contact-0005.vtu").exists() and run.poll() is None:
            time.sleep(0.001)
        run.terminate()
        run.communicate()
        endless = ["Contact solver/Method=uzawa", "Contact solver/Maximum iterations=10000000", "Contact solver/Rho factor=1e-6"]
        run = self.start("stopped", [*settings, *endless], "--resume")
        log = self.folder / "stopped/log.txt"
        while "uzawa" not in log.read_text() and run.poll() is None:
            time.sleep(0.01)
        time.sleep(0.5)
        run.terminate()
        self.assertRegex(run.communicate(timeout=30)[1], r"orthocone: interrupted after load step \d+ of 135; .*--resume")
        self.assertEqual(run.returncode, INTERRUPTED)
        before = (self.folder / "stopped/history.csv").read_bytes()
        self.assertEqual(self.run_program("stopped", "--resume", settings=settings).returncode, 0)
        after = (self.folder / "stopped/history.csv").read_bytes()
        self.assertTrue(after.startswith(before))
        self.assertEqual(after.count(b"\n"), 1 + 135)

    def test_signals_stop_the_run(self):
        settings = self.LONG
        self.whole(settings)
        for number in (signal.SIGINT, signal.SIGTERM):
            run = self.start("stopped", settings)
            while not (self.folder / "stopped/contact-0003.vtu").exists() and run.poll() is None:
                time.sleep(0.001)
            run.send_signal(number)
            error = run.communicate()[1]
            self.assertEqual(run.returncode, INTERRUPTED, error)
            self.assertRegex(error, r"orthocone: interrupted after load step \d+ of 135; .*--resume")
            summary = json.loads((self.folder / "stopped/summary.json").read_text())
            self.assertRegex(summary["status"], "^interrupted")
            self.assertEqual(len(self.rows("stopped")), summary["steps"]["solved"])
            self.assertLess(summary["steps"]["solved"], 135)
            with self.subTest(number):
                self.assert_resumes("stopped", settings)
            shutil.rmtree(self.folder / "stopped")

    def test_signal_during_the_set_up_does_not_wait(self):
        run = self.start("stopped", ["Mesh/Core cells=20", "Mesh/Rings=16", "Mesh/Model=full"])
        while not (self.folder / "stopped/log.txt").exists() and run.poll() is None:
            time.sleep(0.001)
        run.terminate()
        error = run.communicate(timeout=10)[1]  # the set-up alone takes a minute
        self.assertEqual(run.returncode, INTERRUPTED)
        self.assertRegex(error, "interrupted during the set-up")

    def test_a_screen_that_is_gone_stops_nothing(self):
        self.whole(SMALL)
        command = [word for word in self.command("run", settings=SMALL) if word != "--quiet"]
        run = subprocess.Popen(command, cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        run.stdout.close()
        run.stderr.close()
        self.assertEqual(run.wait(), DONE)
        self.assert_same_files("whole", "run", self.results)

    def test_second_run_refuses(self):
        settings = self.LONG
        self.whole(settings)
        run = self.start("run", settings)
        while not (self.folder / "run/contact-0001.vtu").exists() and run.poll() is None:
            time.sleep(0.001)
        run.send_signal(signal.SIGSTOP)  # or it may be done before the others begin
        for arguments in ((), ("--resume",)):
            second = self.run_program("run", *arguments, settings=settings)
            self.assertEqual(second.returncode, FILE_ERROR)
            self.assertRegex(second.stderr, r"^orthocone: .*run: .*another run is writing there; .*--output DIR.*\n$")
        run.send_signal(signal.SIGCONT)
        self.assertEqual(run.communicate()[1], "")
        self.assertEqual(run.returncode, DONE)
        self.assert_same_files("whole", "run", self.results)


if __name__ == "__main__":
    main()
