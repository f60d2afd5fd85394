# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""How many threads a run computes with, who says so, and that a resumed run goes on with as many.

Usage: test_threads.py PROGRAM [unittest options]"""
import json
import os
import signal
import subprocess
import sys
import time

sys.dont_write_bytecode = True  # the source tree stays clean
from program import SMALL, RunTest, main  # noqa: E402

VARIABLES = ("OPENBLAS_NUM_THREADS", "GOTO_NUM_THREADS", "OMP_NUM_THREADS")
FREE = {name: value for name, value in os.environ.items() if name not in VARIABLES}
# Large enough that the factors of one and of two threads may differ by rounding.
MIDDLING = ["Mesh/Core cells=6", "Load program/Cycles=1", "Output/Checkpoint=0"]


class ThreadTest(RunTest):
    def threads(self, output):
        return json.loads((self.folder / output / "summary.json").read_text())["threads"]

    def assert_done(self, output, *arguments, settings=(), env=None):
        result = self.run_program(output, *arguments, settings=settings, env=env or FREE)
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def test_who_says_how_many(self):
        self.assert_done("small", settings=SMALL)
        self.assertEqual(self.threads("small"), {"number": 1, "reason": "the model is small"})
        self.assert_done("environment", settings=SMALL, env={**FREE, "OPENBLAS_NUM_THREADS": "2"})
        self.assertEqual(self.threads("environment")["reason"], "OPENBLAS_NUM_THREADS")
        self.assert_done("line", "--threads", "2", settings=SMALL, env={**FREE, "OPENBLAS_NUM_THREADS": "1"})
        self.assertEqual(self.threads("line"), {"number": 2, "reason": "--threads"})
        self.assertIn("threads        2 (--threads)\n", (self.folder / "line/log.txt").read_text())

    def test_a_larger_model_looks_at_cores_and_load(self):
        self.assert_done("run", settings=MIDDLING)
        threads, cores = self.threads("run"), len(os.sched_getaffinity(0))
        self.assertTrue(1 <= threads["number"] <= cores, threads)
        if cores > 1:
            self.assertRegex(threads["reason"], r"^\d+ cores, others busy on \d+$")

    def test_resumed_runs_have_as_many_and_the_same_bytes(self):
        self.assert_done("whole", "--threads", "2", settings=MIDDLING)
        run = subprocess.Popen([*self.command("stopped", "--threads", "2", settings=MIDDLING)], cwd=self.folder, env=FREE,
                               stderr=subprocess.PIPE)
        while run.poll() is None and not (self.folder / "stopped/checkpoint/state").exists():
            time.sleep(0.001)
        run.send_signal(signal.SIGKILL)
        run.communicate()
        self.assert_done("stopped", "--resume", settings=MIDDLING)
        self.assertEqual(self.threads("stopped"), {"number": 2, "reason": "as in the run before"})
        self.assert_same_files("whole", "stopped", ["history.csv", "checks.csv", "cycles.csv"])

    def test_zones_do_not_depend_on_them(self):
        """Rounding does. Where the load is held, it would say of all nodes at the limit of friction whether they stick."""
        held = "Load program/Legs=uz -0.1 : 2 ; uz -0.1 : 1 ; uz -0.05 : 2 ; uz -0.05 : 1 ; uz -0.02 : 1"
        histories = []
        for number in ("1", "2"):
            self.assert_done(number, "--threads", number, settings=[*MIDDLING, held])
            histories.append([[float(row[name]) for name in ("stick_area", "n_stick", "n_slip")] for row in self.rows(number)])
        for one, other in zip(*histories):
            self.assertAlmostEqual(one[0], other[0], delta=1e-5)
            self.assertEqual(one[1:], other[1:])
        for rest in (2, 5):
            for before, behind in zip(histories[0][rest - 1], histories[0][rest]):
                self.assertAlmostEqual(before, behind, delta=1e-5)

    def test_wrong_numbers(self):
        for value in ("0", "-1", "1.5", "many", "1025", "", "2 2"):
            result = self.run_program("wrong", f"--threads={value}")
            self.assertEqual(result.returncode, 2, value)
            self.assertRegex(result.stderr, r"^orthocone: command line: .*--threads.*\n$")
            self.assertFalse((self.folder / "wrong").exists())


if __name__ == "__main__":
    main()
