# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""tools/study benchmark in its quick mode: every kernel and phase is there with positive figures, bad options and failing
programs are refused. Says nothing about speed.

Usage: test_benchmark.py PROGRAM [unittest options]"""
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from matplotlib.image import imread

from program import PROGRAM, ROOT, main

sys.path.insert(0, str(ROOT / "tools/studies"))
import paths  # noqa: E402, F401 (finds the modules of all studies)

import benchmark_ratios  # noqa: E402
import docs_page  # noqa: E402

KERNELS = {"projection/mixed", "projection/slip", "trial_force/slip", "one_node/slip_guessed",
           "one_node/slip_unguessed", "residual", "sweep", "newton_iteration", "contact_step", "assembly",
           "factorization", "factorization_free", "condensation", "one_solve", "assembled_product",
           "matrix_free_product/single", "matrix_free_product/double", "ordering/metis", "ordering/amd",
           "ordering/metis_contact_last", "ordering/amd_contact_last", "ordering/camd_contact_last"}
FIGURES = {"start_up", "process", "gigabytes", "mesh", "assembly", "factorization", "condensation", "contact", "checks",
           "output"}
# On a busy machine the threads of the BLAS wait for each other.
ENVIRONMENT = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}


def benchmark(*arguments, program=PROGRAM):
    command = [sys.executable, ROOT / "tools/studies/study.py", "benchmark", "--program", program, "--kernels",
               pathlib.Path(PROGRAM).parent / "kernels", *arguments]
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, env=ENVIRONMENT, timeout=600,
                          check=False)


class QuickTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.folder = pathlib.Path(scratch.name) / "new/results"
        cls.process = benchmark("--quick", "--output", cls.folder)

    def setUp(self):
        self.assertEqual((self.process.returncode, self.process.stderr), (0, ""))
        self.result = json.loads((self.folder / "benchmark.json").read_text())

    def test_every_kernel_has_a_time(self):
        self.assertEqual({entry["kernel"] for entry in self.result["kernels"]}, KERNELS)
        for entry in self.result["kernels"]:
            self.assertTrue(0 < entry["seconds"] < 100, entry)

    def test_every_phase_has_a_time(self):
        self.assertEqual([program["core_cells"] for program in self.result["programs"]], [2, 4])
        for program in self.result["programs"]:
            self.assertEqual((program["steps"], len(program["samples"])), (45, 1))
            for figures in (program["median"], *program["samples"]):
                self.assertEqual(set(figures), FIGURES)
                self.assertGreater(min(figures.values()), 0)
                phases = sum(figures[phase] for phase in benchmark_ratios.PHASES)
                self.assertLess(phases, figures["process"])

    def test_ratios(self):
        self.assertEqual(set(self.result["ratios"]), {*benchmark_ratios.RATIOS, *benchmark_ratios.KERNEL_RATIOS})
        for name, values in self.result["ratios"].items():
            self.assertEqual(set(values), {"2", "4"})
            for value in values.values():
                self.assertTrue(0 < value < math.inf)
            self.assertIn(f"| {name} |", self.process.stdout)

    def test_charts_show_something(self):
        for name in ("cost", "shares"):
            picture = imread(self.folder / f"{name}.png")[::5, ::5, :3]
            self.assertTrue(0.2 < (picture == 1).all(axis=2).mean() < 0.98, name)

    def test_page_has_a_place_for_every_table(self):
        page = self.folder / "performance.md"
        page.write_text((ROOT / "docs/performance.md").read_text(encoding="utf-8"), encoding="utf-8")
        tables = {name: make(self.result) for name, make in benchmark_ratios.TABLES.items()}
        docs_page.write_tables(tables, page, "benchmark")
        for table in tables.values():
            self.assertIn(table, page.read_text(encoding="utf-8"))

    def test_nothing_shows_where_it_ran(self):
        self.assertNotIn(str(ROOT), (self.folder / "benchmark.json").read_text())


class AgainstTest(unittest.TestCase):
    def test_a_program_that_sleeps_first_takes_longer(self):
        with tempfile.TemporaryDirectory() as folder:
            slow = pathlib.Path(folder) / "slow"
            slow.write_text(f'#!/bin/sh\nsleep 1\nexec "{PROGRAM}" "$@"\n')
            slow.chmod(0o755)
            process = benchmark("--quick", "--against", slow)
        self.assertEqual((process.returncode, process.stderr), (0, ""))
        rows = [line.strip("| ").split(" | ") for line in process.stdout.splitlines() if line.startswith("| ")][1:]
        self.assertEqual([row[0] for row in rows if row[1] == "whole process"], ["2", "4"])
        for row in rows:
            if row[1] == "whole process":
                self.assertLess(float(row[4]), 1)
                self.assertAlmostEqual(float(row[4]), float(row[2]) / float(row[3]), 2)


class ExponentTest(unittest.TestCase):
    def test_power_law_of_the_finer_meshes(self):
        sizes = benchmark_ratios.np.array([3., 10., 20., 50.])
        seconds = 7 * sizes**2.5
        seconds[0] *= 100  # too small a mesh for the law
        self.assertAlmostEqual(benchmark_ratios.exponent(sizes, seconds), 2.5)


class RefusalTest(unittest.TestCase):
    def test_bad_options(self):
        for arguments in (["--runs", "0"], ["--runs", "few"], ["--finest", "7"], ["--quick", "--docs"], ["--against", "x", "--docs"], ["--fast"]):
            with self.subTest(arguments):
                process = benchmark(*arguments)
                self.assertEqual((process.returncode, process.stdout), (2, ""))
                self.assertIn("tools/study benchmark: error: ", process.stderr)

    def test_failing_program(self):
        for program, sentence in (("/bin/false", "ended with code 1"), ("/nowhere/orthocone", "could not be started")):
            process = benchmark("--quick", program=program)
            self.assertEqual(process.returncode, 1)
            self.assertRegex(process.stderr, rf"^benchmark: {program} {sentence}")
            self.assertEqual(len(process.stderr.splitlines()), 1)


if __name__ == "__main__":
    main()
