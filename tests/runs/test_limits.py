# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Limits that batch systems and containers set: memory, threads, signals. One line and a documented exit code each.

Usage: test_limits.py PROGRAM [unittest options]"""
import json
import os
import re
import resource
import signal
import subprocess
import sys
import time

sys.dont_write_bytecode = True  # the source tree stays clean
from program import PROGRAM, ROOT, RunTest, SMALL, main  # noqa: E402

DONE, WRONG_INPUT, UNSOLVED, INTERRUPTED = 0, 2, 3, 130
LARGE = ["Mesh/Core cells=64", "Mesh/Layers=48", "Mesh/Degree=2", "Mesh/Model=full", "Mesh/Backend=condensed"]
MIDDLING = ["Mesh/Core cells=16", "Mesh/Rings=8", "Mesh/Layers=1", "Mesh/Degree=2", "Mesh/Model=full",
            "Load program/Cycles=1", "Mesh/Backend=condensed"]


class MemoryTest(RunTest):
    def limited(self, kilobytes, *arguments, settings=SMALL):
        def limit():
            resource.setrlimit(resource.RLIMIT_AS, (1024 * kilobytes, 1024 * kilobytes))
        return self.run_program("run", *arguments, settings=settings, preexec_fn=limit)

    def can_begin(self, kilobytes):
        """Whether the loader and OpenBLAS let the program come to its first line."""
        try:
            return subprocess.run(["sh", "-c", f"ulimit -v {kilobytes}; exec '{PROGRAM}' --version"], timeout=10,
                                  capture_output=True, check=False).returncode == DONE
        except subprocess.TimeoutExpired:
            return False

    def test_address_space(self):
        """From where the libraries can be loaded on: never silent, never for ever (the timeout is the test)."""
        codes = set()
        for kilobytes in (600000, 800000, 950000, 1050000, 1100000, 1200000, 2000000):
            if not self.can_begin(kilobytes):
                continue
            result = self.limited(kilobytes)
            codes.add(result.returncode)
            with self.subTest(kilobytes=kilobytes):
                self.assertIn(result.returncode, (DONE, WRONG_INPUT))
                if result.returncode == WRONG_INPUT:
                    self.assertRegex(result.stderr, r"^orthocone: memory: 'ulimit -v' leaves \S+ GB .*; allowed is .*\n$")
                    self.assertFalse((self.folder / "run").exists())
        self.assertEqual(codes, {DONE, WRONG_INPUT})

    def test_a_model_that_cannot_fit_is_refused(self):
        result = self.run_program("run", settings=SMALL)
        before = {file: file.read_bytes() for file in (self.folder / "run").rglob("*") if file.is_file()}
        result = self.run_program("run", settings=LARGE)
        self.assertEqual(result.returncode, WRONG_INPUT, result.stderr)
        self.assertRegex(result.stderr, r"^orthocone: .*case_b\.prm: memory: the model needs about \S+ GB, and this machine "
                                        r"has \S+ GB; .* --insist runs all the same\n$")
        self.assertEqual({file: file.read_bytes() for file in (self.folder / "run").rglob("*") if file.is_file()}, before)

    def test_what_cannot_be_factorized_may_be_solved_by_multigrid(self):
        """The same model without a backend: --check chooses, and makes no mesh of what is too large for both."""
        def checked(*settings):
            command = [PROGRAM, self.FILE, "--check", *[f"--set={setting}" for setting in settings]]
            def limit():
                resource.setrlimit(resource.RLIMIT_AS, (1500000 * 1024, 1500000 * 1024))
            return subprocess.run(command, text=True, capture_output=True, timeout=60, check=True, preexec_fn=limit).stdout
        self.assertRegex(checked(*MIDDLING, "Mesh/Backend=auto"), r"(?m)^backend +multigrid about .*; condensed about ")
        self.assertNotRegex(checked(*LARGE, "Mesh/Backend=auto"), r"(?m)^backend ")

    def test_check_warns_and_still_prints_all(self):
        result = subprocess.run([PROGRAM, self.FILE, "--check", *[f"--set={setting}" for setting in LARGE]],
                                text=True, capture_output=True, timeout=60, check=True)
        for line in (r"^friction  ", r"^load steps +45$", r"^memory +more than \S+ GB; this machine has \S+ GB$",
                     r"^time +more than ", r"^warning: memory: the model needs about \S+ GB"):
            self.assertRegex(result.stdout, re.compile(line, re.MULTILINE))

    def test_a_limit_that_the_model_exceeds(self):
        """700 MB beside the libraries are enough for a small model, and not for one of 700 MB of compliance."""
        result = self.limited(1500000, settings=MIDDLING)
        self.assertEqual(result.returncode, WRONG_INPUT, result.stderr)
        self.assertRegex(result.stderr, r"memory: the model needs about \S+ GB, and 'ulimit -v' leaves \S+ GB")
        result = self.limited(1500000, "--insist", settings=MIDDLING)
        self.assertEqual(result.returncode, UNSOLVED, result.stderr)
        self.assertRegex(result.stderr, r"^orthocone: memory runs out")
        summary = json.loads((self.folder / "run/summary.json").read_text())
        self.assertRegex(summary["status"], "^memory runs out")
        self.assertEqual(summary["steps"]["solved"], 0)

    def test_a_resumed_run_that_memory_ends_says_so(self):
        self.run_program("run", settings=[*MIDDLING, "Contact solver/Method=box3", "Contact solver/Maximum iterations=1"])
        first = json.loads((self.folder / "run/summary.json").read_text())
        self.assertRegex(first["status"], "^load step 1 of 15 ")
        result = self.limited(1500000, "--insist", "--resume", settings=MIDDLING)
        self.assertEqual(result.returncode, UNSOLVED, result.stderr)
        second = json.loads((self.folder / "run/summary.json").read_text())
        self.assertRegex(second["status"], "^memory runs out")
        self.assertEqual({**second, "status": ""}, {**first, "status": ""})

    def test_many_steps_a_cycle(self):
        """What is remembered of them, for the starts of the next cycle, is bounded; so is the checkpoint."""
        settings = ["Mesh/Core cells=4", "Mesh/Rings=2", "Mesh/Layers=1", "Mesh/Degree=2", "Mesh/Model=full",
                    "Output/Contact fields=0", "Output/Volume fields=0", "Output/Probes=",
                    "Load program/Legs=0 0 -0.1 : 4500", "Load program/Cycles=1"]
        run = subprocess.Popen(self.command("run", settings=settings), cwd=self.folder, stderr=subprocess.PIPE)
        self.addCleanup(run.wait)
        self.addCleanup(run.kill)
        deadline = time.monotonic() + 300
        while run.poll() is None and time.monotonic() < deadline:
            time.sleep(0.1)
        self.assertEqual(run.returncode, DONE)
        self.assertLess((self.folder / "run/checkpoint/state").stat().st_size, 20e6)  # all of them: 23 MB


class ThreadTest(RunTest):
    def test_number_of_threads(self):
        """deal.II looks at it before the program does, so ./run does first."""
        for number in ("0", "abc", "-1", ""):
            result = subprocess.run([ROOT / "run", "nothing.prm"], cwd=self.folder, text=True, capture_output=True,
                                    timeout=60, check=False, env={**os.environ, "DEAL_II_NUM_THREADS": number})
            self.assertEqual(result.returncode, WRONG_INPUT)
            self.assertEqual(result.stderr, f"run: DEAL_II_NUM_THREADS = {number}: allowed is a whole number > 0\n")

    def test_number_of_threads_of_the_program_itself(self):
        """The program looks before deal.II does, for a package has no ./run."""
        for number in ("0", "abc", "-1", "", "000", "1" * 1000):
            result = subprocess.run([PROGRAM, "--version"], cwd=self.folder, text=True, capture_output=True, timeout=60,
                                    check=False, env={**os.environ, "DEAL_II_NUM_THREADS": number})
            self.assertEqual(result.returncode, WRONG_INPUT)
            self.assertEqual(result.stderr,
                             f"orthocone: DEAL_II_NUM_THREADS = {number[:40]}: allowed is a whole number > 0\n")

    def test_address_space_of_run(self):
        script = f"ulimit -v 500000; exec '{ROOT}/run' nothing.prm"
        result = subprocess.run(["sh", "-c", script], cwd=self.folder, text=True, capture_output=True, timeout=60, check=False)
        self.assertEqual(result.returncode, WRONG_INPUT)
        self.assertRegex(result.stderr, r"^run: 'ulimit -v' is 500000 kB: .*allowed is 1100000 and more, or unlimited\n$")


class SignalTest(RunTest):
    def test_sigterm_at_any_moment_of_the_set_up(self):
        """Also while METIS, which has a handler of its own, looks for the order."""
        settings = ["Mesh/Core cells=16", "Mesh/Layers=12", "Mesh/Model=full", "Mesh/Backend=condensed"]
        for moment in (0.3, 0.8, 1.3, 1.8, 2.3, 2.8):
            run = subprocess.Popen(self.command("run", settings=settings), cwd=self.folder, text=True, stderr=subprocess.PIPE)
            time.sleep(moment)
            begin = time.monotonic()
            run.send_signal(signal.SIGTERM)
            error = run.communicate(timeout=60)[1]
            with self.subTest(moment=moment):
                self.assertIn(run.returncode, (INTERRUPTED, -signal.SIGTERM), error)  # before main, the system's way
                self.assertLess(time.monotonic() - begin, 5)
                if run.returncode == INTERRUPTED:
                    self.assertRegex(error, "orthocone: interrupted during the set-up")


if __name__ == "__main__":
    main()
