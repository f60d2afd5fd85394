# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Runs that are killed, interrupted, or cannot write, and go on as if nothing had been.

Usage: test_resume.py PROGRAM [unittest options]"""
import json
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import time

sys.dont_write_bytecode = True  # the source tree stays clean
from program import RunTest, SMALL, main  # noqa: E402

DONE, WRONG_INPUT, UNSOLVED, FILE_ERROR, INTERRUPTED = 0, 2, 3, 4, 130
EVERY_STEP = "Output/Checkpoint=0"
RESULTS = ["history.csv", "checks.csv", "cycles.csv", "probe-P.csv", "contact.pvd", "volume.pvd", "contact-0045.vtu",
           "volume-0045.vtu"]


class ResumeTest(RunTest):
    def whole(self, settings, results=RESULTS):
        """An uninterrupted run, for comparison."""
        result = self.run_program("whole", settings=settings)
        self.assertEqual((result.returncode, result.stderr), (DONE, ""))
        self.results = results

    def assert_resumes(self, name, settings):
        result = self.run_program(name, "--resume", settings=settings)
        self.assertEqual((result.returncode, result.stderr), (DONE, ""))
        self.assert_same_files("whole", name, self.results)
        self.assertEqual(json.loads((self.folder / name / "summary.json").read_text())["status"], "complete")
        names = {kind: sorted(file.name for file in (self.folder / name).iterdir() if file.name != "report.html")
                 for kind in ("whole", name)}
        self.assertEqual(names[name], names["whole"])

    def start(self, name, settings, *arguments):
        return subprocess.Popen(self.command(name, *arguments, settings=settings), cwd=self.folder, text=True,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE)


class KillTest(ResumeTest):
    def test_kill_at_any_moment(self):
        """Case B, killed at 25 random moments, of which many fall into the writing of files."""
        settings = [EVERY_STEP]
        start = time.monotonic()
        self.whole(settings)
        seconds = time.monotonic() - start
        moments = random.Random(2006)
        solved = []
        for number in range(25):
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


class SignalTest(ResumeTest):
    # So many steps that a run is not done before a busy machine lets the test send its signal.
    LONG = ["Mesh/Core cells=6", "Mesh/Degree=1", "Mesh/Model=full", "Load program/Cycles=9"]

    def test_signals_finish_the_step(self):
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


class RefusalTest(ResumeTest):
    """What cannot be resumed is told in a line, and nothing is touched."""
    SETTINGS = [*SMALL, EVERY_STEP, "Load program/Cycles=1", "Output/Volume fields=0"]

    def setUp(self):
        super().setUp()
        self.assertEqual(self.run_program("run", settings=self.SETTINGS).returncode, DONE)

    def content(self):
        return {file: file.read_bytes() for file in sorted(self.folder.rglob("*")) if file.is_file()}

    def assert_refused(self, code, expression, settings=(), file=None):
        before = self.content()
        result = self.run_program("run", "--resume", settings=[*self.SETTINGS, *settings], file=file)
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertRegex(result.stderr, r"^orthocone: " + expression)
        self.assertEqual(result.stderr.count("\n"), 1)
        self.assertEqual(self.content(), before)

    def test_other_parameters(self):
        self.assert_refused(WRONG_INPUT, r".*case_b\.prm: Mesh/Degree = 2, but the run in .*run was started with 1; ",
                            ["Mesh/Degree=2"])
        self.assert_refused(WRONG_INPUT, r".*: Friction/Coefficients = 0\.3, 0\.2, but .* with 0\.3, 0\.15; ",
                            ["Friction/Coefficients=0.3, 0.2"])
        self.assert_refused(WRONG_INPUT, r".*: Output/Probes = , but .* with P: 6\.72 6\.72; allowed .* these probes and",
                            ["Output/Probes="])

    def test_damaged_checkpoint(self):
        state = self.folder / "run/checkpoint/state"
        good = state.read_bytes()
        middle = len(good) // 2
        for bad, expression in ((b"", "is not a checkpoint"), (b"hello\n", "is not a checkpoint"),
                                (good[:middle], "is cut off"), (good + b"x", "is cut off"),
                                (good[:middle] + bytes([good[middle] ^ 1]) + good[middle + 1:], "is damaged"),
                                (good.replace(b" 4 ", b" 5 ", 1), "has format version 5, and this program reads")):
            state.write_bytes(bad)
            self.assert_refused(FILE_ERROR, r".*checkpoint/state: " + expression + r".*; without --resume")

    def test_tables_that_lost_lines(self):
        history = self.folder / "run/history.csv"
        history.write_bytes(history.read_bytes()[:-30])
        self.assert_refused(FILE_ERROR, r".*history\.csv: cannot be continued \(it is shorter")
        history.unlink()
        self.assert_refused(FILE_ERROR, r".*history\.csv: cannot be continued \(it is missing")

    def test_changed_tables_and_lost_fields(self):
        history = self.folder / "run/history.csv"
        good = history.read_bytes()
        history.write_bytes(good.replace(b"\n", b"\r\n"))
        self.assert_refused(FILE_ERROR, r".*history\.csv: cannot be continued \(it was changed")
        digit = good.index(b"0.0") + 2
        history.write_bytes(good[:digit] + b"9" + good[digit + 1:])
        self.assert_refused(FILE_ERROR, r".*history\.csv: cannot be continued \(it was changed")
        history.write_bytes(good)
        field = self.folder / "run/contact-0010.vtu"
        whole = field.read_bytes()
        for part in (b"", whole[:-20]):
            field.write_bytes(part)
            self.assert_refused(FILE_ERROR, r".*contact-0010\.vtu: is cut off")
        (self.folder / "run/contact-0010.vtu").unlink()
        result = self.run_program("run", "--resume", settings=self.SETTINGS)
        self.assertEqual(result.returncode, FILE_ERROR)
        self.assertRegex(result.stderr, r"contact-0010\.vtu: is missing")

    def test_lost_checkpoint(self):
        (self.folder / "run/checkpoint/state").unlink()
        self.assert_refused(FILE_ERROR, r".*checkpoint/state: is missing, and the folder holds results of other",
                            ["Mesh/Degree=2"])

    def test_complete_run(self):
        before = self.content()
        result = self.run_program("run", "--resume", settings=self.SETTINGS)
        self.assertEqual((result.returncode, result.stderr), (DONE, ""))
        after = self.content()
        changed = {file.name for file in after if after[file] != before.get(file)}
        self.assertLessEqual(changed, {"log.txt", "summary.json", "state", "contact.pvd"})  # a date in its comment

    def test_an_unsolved_step_can_be_tried_otherwise(self):
        file = self.FILE.with_name("case_c_q1.prm")
        stuck = ["Contact solver/Method=feng2006", "Contact solver/Maximum iterations=3",
                 "Mesh/Model=auto", "Load program/Legs=0 0 -0.1 : 1 ; 0 0 -0.08 : 1"]
        result = self.run_program("failed", settings=[*SMALL, *stuck], file=file)
        self.assertEqual(result.returncode, UNSOLVED)
        better = [*SMALL, *stuck, "Contact solver/Method=newton", "Contact solver/Maximum iterations=5000"]
        result = self.run_program("failed", "--resume", settings=better, file=file)
        self.assertEqual((result.returncode, result.stderr), (DONE, ""))
        self.assertEqual(len(self.rows("failed")), 2)


class ExtensionTest(ResumeTest):
    """What lies ahead of a run may change, what it has computed may not."""
    SETTINGS = [*SMALL, "Load program/Legs=0 0 -0.1 : 3 ; 0 0 -0.02 : 4", "Output/Volume fields=0"]

    def run_to(self, name, *settings, resume=True):
        result = self.run_program(name, *(["--resume"] if resume else []), settings=[*self.SETTINGS, *settings])
        self.assertEqual((result.returncode, result.stderr), (DONE, ""))

    def test_more_cycles(self):
        self.run_to("whole", "Load program/Cycles=5", resume=False)
        self.run_to("run", "Load program/Cycles=2", resume=False)
        self.run_to("run", "Load program/Cycles=5")
        self.assert_same_files("whole", "run", ["history.csv", "checks.csv", "cycles.csv", "probe-P.csv", "contact.pvd",
                                                "contact-0035.vtu", "parameters.prm"])
        result = self.run_program("run", "--resume", settings=[*self.SETTINGS, "Load program/Cycles=4"])
        self.assertEqual(result.returncode, WRONG_INPUT)
        self.assertRegex(result.stderr, "Load program/Cycles = 4, but .* with 5; allowed .* the 35 load steps that are done")

    def test_other_fields_and_more_probes(self):
        self.run_to("run", "Load program/Cycles=2", "Output/Contact fields=4", resume=False)
        later = ["Load program/Cycles=4", "Output/Contact fields=5", "Output/Volume fields=7",
                 "Output/Probes=rim: 9 0; P: 6.72 6.72"]
        self.run_to("run", *later)
        names = sorted(file.name for file in (self.folder / "run").glob("*-*.vtu"))
        self.assertEqual(names, [f"contact-{step:04d}.vtu" for step in (4, 8, 12, 14, 15, 20, 25, 28)] +
                         [f"volume-{step:04d}.vtu" for step in (21, 28)])
        listed = (self.folder / "run/contact.pvd").read_text()
        self.assertEqual([name for name in names if name in listed], names[:8])
        self.assertEqual([row["step"] for row in self.rows("run", "probe-rim.csv")], [str(step) for step in range(15, 29)])
        self.assertEqual(len(self.rows("run", "probe-P.csv")), 28)
        self.run_to("run", *later)  # the same again: nothing to do, nothing lost
        self.assertEqual(sorted(file.name for file in (self.folder / "run").glob("*-*.vtu")), names)


class FullDiskTest(ResumeTest):
    SETTINGS = ["Mesh/Core cells=4", "Mesh/Degree=1", EVERY_STEP, "Output/Volume fields=5"]

    def assert_stopped(self, result, cause):
        """Exit code and one line; what is there under its name is whole."""
        self.assertEqual(result.returncode, FILE_ERROR, result.stderr)
        self.assertRegex(result.stderr, rf"^orthocone: \S+: .*{cause}.*\n$")
        self.assertEqual(result.stderr.count("\n"), 1)
        for file in (self.folder / "full").rglob("*"):
            self.assertNotEqual(file.suffix, ".part")
            if file.suffix == ".csv":
                self.assertIn(file.read_bytes()[-1:], (b"\n", b""), f"{file.name} ends with half a line")

    def test_files_that_may_not_grow(self):
        """Limits on the size of files; the larger ones stop the growing tables."""
        self.whole(self.SETTINGS)
        sizes = sorted({file.stat().st_size for file in (self.folder / "whole").rglob("*") if file.is_file()})
        limits = [0, 100, 1000, 2000, 4000, 6000, 8000, *[size - 1 for size in sizes if size > 9000][:3]]
        for limit in limits:
            result = self.run_program("full", settings=self.SETTINGS, restore_signals=True, preexec_fn=lambda size=limit:
                                      resource.setrlimit(resource.RLIMIT_FSIZE, (size, size)))
            with self.subTest(limit=limit):
                self.assert_stopped(result, "File too large")
                self.assert_resumes("full", self.SETTINGS)
            shutil.rmtree(self.folder / "full")

    def test_earlier_results_stay_if_there_is_no_room_for_a_new_run(self):
        self.whole(self.SETTINGS)
        before = {file: file.read_bytes() for file in (self.folder / "whole").rglob("*") if file.is_file()}
        result = self.run_program("whole", settings=[*self.SETTINGS, "Material/Poisson ratio=0.2"], preexec_fn=lambda:
                                  resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100)))
        self.assertEqual(result.returncode, FILE_ERROR)
        after = {file: file.read_bytes() for file in (self.folder / "whole").rglob("*")
                 if file.is_file() and file.suffix != ".part"}
        self.assertEqual(after, before)

    def test_full_file_system(self):
        """A small file system of its own, full at ten different moments, then enlarged."""
        disk = self.folder / "full"
        disk.mkdir()
        if os.geteuid() != 0 or not self.mount("-t", "tmpfs", "-o", "size=4k", "none", disk):
            self.skipTest("file systems cannot be mounted here; the limits on the size of files stand for it")
        self.addCleanup(subprocess.run, ["umount", "-l", disk], check=False)
        self.whole(self.SETTINGS)
        total = sum(file.stat().st_size for file in (self.folder / "whole").rglob("*"))
        for number in range(10):
            size = 4096 + number * total // 11
            with self.subTest(size=size):
                self.assertTrue(self.mount("-o", f"remount,size={size}", disk))
                self.assert_stopped(self.run_program("full", settings=self.SETTINGS), "No space left on device")
                self.assertTrue(self.mount("-o", "remount,size=1g", disk))
                self.assert_resumes("full", self.SETTINGS)
            for file in disk.iterdir():
                shutil.rmtree(file) if file.is_dir() else file.unlink()

    @staticmethod
    def mount(*arguments):
        return subprocess.run(["mount", *arguments], capture_output=True, check=False).returncode == 0


if __name__ == "__main__":
    main()
