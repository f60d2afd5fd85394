# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Runs of a batch that share a body: their results, lines that run at the same time, and keepers that fail.

Usage: test_shared_bodies.py PROGRAM [unittest options]"""
import contextlib
import json
import os
import shutil
import signal
import subprocess
import sys
import time

sys.dont_write_bytecode = True  # the source tree stays clean
from program import PROGRAM, ROOT, SCENE, RunTest, main  # noqa: E402

FILES = ("history.csv", "checks.csv", "cycles.csv", "parameters.prm", "contact-0001.vtu", "contact-0002.vtu")
DONE, WRONG_INPUT, KILLED = 0, 2, 137


class Batch:
    """A batch of runs with one thread, which share bodies. Each line is answered before the next one is written."""

    def __init__(self, folder):
        self.process = subprocess.Popen([PROGRAM, "--batch"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, cwd=folder)

    def begin(self, output, settings, file="s.prm"):
        words = [file, "--quiet", "--threads", "1", "--output", output, *(f"--set={setting}" for setting in settings)]
        self.process.stdin.write(json.dumps(words) + "\n")
        self.process.stdin.flush()

    def answer(self):
        return json.loads(self.process.stdout.readline())

    def run(self, output, settings=(), file="s.prm"):
        self.begin(output, settings, file)
        return self.answer()

    def children(self):
        return [int(pid) for pid in subprocess.run(["pgrep", "-P", str(self.process.pid)], capture_output=True, text=True,
                                                   check=False).stdout.split()]

    def end(self):
        self.process.stdin.close()
        self.process.stdout.close()
        return self.process.wait()


class SharedBodiesTest(RunTest):
    def setUp(self):
        super().setUp()
        (self.folder / "s.prm").write_text(SCENE)

    @contextlib.contextmanager
    def batch(self):
        batch = Batch(self.folder)
        try:
            yield batch
        finally:
            self.assertEqual(batch.end(), 0)

    def assert_is_single_run(self, output, settings, file="s.prm"):
        """The same files as from a process of its own."""
        result = self.run_program(f"{output}-alone", "--threads", "1", settings=settings, file=file)
        self.assertEqual(result.returncode, DONE, result.stderr)
        there = [name for name in FILES if (self.folder / f"{output}-alone" / name).exists()]
        self.assertIn("history.csv", there)
        self.assert_same_files(output, f"{output}-alone", there)

    def is_shared(self, output):
        """Whether a run took its body from an earlier one: it had no factorization, which would take some time."""
        return json.loads((self.folder / output / "summary.json").read_text())["seconds"]["factorization"] == 0

    def check(self, *all_settings, file="s.prm"):
        """All runs of a batch are as single runs are, and share the body of the second one, or search for a mesh."""
        with self.batch() as batch:
            for i, settings in enumerate(all_settings):
                answer = batch.run(f"run{i}", settings, file)
                self.assertEqual((answer["exit"], answer["message"]), (DONE, ""))
                self.assertEqual("line" in answer, False)
                self.assertEqual(self.is_shared(f"run{i}"), i > 0, settings)
        for i, settings in enumerate(all_settings):
            self.assert_is_single_run(f"run{i}", settings, file)

    def test_what_bodies_do_not_depend_on(self):
        self.check(["Friction/Coefficients=0.3, 0.1"], ["Friction/Coefficients=0.1, 0.25"], ["Contact solver/Method=gauss-seidel"],
                   ["Contact solver/Tolerance=1e-9", "Load program/Cycles=2"], ["Load program/Legs=0 0 -0.2 : 3 ; 0 0 -0.1 : 1"],
                   ["Obstacle/Gap=0.0001 * (x^2 + y^2)"], ["Wear/Law=archard", "Wear/Coefficient=1e-6"])

    def test_axes_of_friction_turn(self):
        self.check(*(["Mesh/Model=full", f"Friction/Orthotropy angle={angle}"] for angle in (30, 0, 90, 12.3)))

    def test_loads_and_supports(self):
        box = ["Geometry/Shape=box", "Geometry/Sizes=4, 3, 2", "Mesh/Cells=3, 2, 2", "Mesh/Model=full"]
        loads = [*box, "Load program/Loads=p: pressure on x-"]
        self.check(*([*loads, f"Load program/Legs=uz -0.01 p {p} : 2", f"Friction/Orthotropy angle={p}"] for p in (10, 20, 30)))
        supports = [*box, "Geometry/Supports=x+: x"]
        self.check(*([*supports, f"Load program/Legs=uz -0.01 ux {u} : 2"] for u in (0.001, 0.002, 0.003)))

    def test_two_bodies(self):
        lower = ["Obstacle/Kind=body", "Lower geometry/Radius=12", "Lower mesh/Core cells=2", "Lower mesh/Layers=2"]
        self.check(*([*lower, f"Friction/Coefficients={mu}, 0.2"] for mu in (0.1, 0.3, 0.3)))

    def test_half_space(self):
        self.check(*(["Obstacle/Kind=half-space", f"Obstacle/Young modulus={modulus}"] for modulus in (1e4, 1e5, 1e6)))

    def test_searches_for_the_mesh(self):
        """Their first levels are the same, and a finer one is made by the run that asks for it."""
        with self.batch() as batch:
            for i, mu in enumerate(("0.05", "0.1", "0.2")):
                answer = batch.run(f"run{i}", [f"Friction/Coefficients={mu}, {mu}", "Mesh/Core cells=8", "Mesh/Layers=4",
                                               "Mesh/Degree=2", "Mesh/Accuracy=2 %"])
                self.assertEqual((answer["exit"], answer["message"]), (DONE, ""))
        for i, mu in enumerate(("0.05", "0.1", "0.2")):
            self.assert_is_single_run(f"run{i}", [f"Friction/Coefficients={mu}, {mu}", "Mesh/Core cells=8", "Mesh/Layers=4",
                                                  "Mesh/Degree=2", "Mesh/Accuracy=2 %"])

    def test_other_bodies_are_not_shared(self):
        with self.batch() as batch:
            for i, modulus in enumerate((1e5, 1e5, 2e5, 2e5, 1e5)):
                self.assertEqual(batch.run(f"run{i}", [f"Material/Young modulus={modulus}"])["exit"], DONE)
                self.assertEqual(self.is_shared(f"run{i}"), i in (1, 3, 4))
                self.assert_is_single_run(f"run{i}", [f"Material/Young modulus={modulus}"])

    def test_a_changed_mesh_file_is_another_body(self):
        of_file = ["Geometry/Shape=file", "Geometry/Mesh file=part.msh", "Geometry/Contact surface=base", "Geometry/Held surface=top",
                   "Geometry/Symmetry surfaces=x0, y0"]
        with self.batch() as batch:
            for i, mesh in enumerate(("cylinder_coarse", "cylinder_coarse", "cylinder", "cylinder_coarse")):
                shutil.copy(ROOT / f"prm/import/{mesh}.msh", self.folder / "part.msh")
                self.assertEqual(batch.run(f"run{i}", of_file)["exit"], DONE)
                self.assertEqual(self.is_shared(f"run{i}"), i in (1, 3))
                self.assert_is_single_run(f"run{i}", of_file)

    def test_lines_at_the_same_time(self):
        settings = {f"run{i}": [f"Friction/Coefficients={0.05 * (i + 1)}, 0.1"] for i in range(9)}
        lines = [json.dumps(["s.prm", "-q", "--threads", "1", "-o", output, "--set", *values]) for output, values in settings.items()]
        result = subprocess.run([PROGRAM, "--batch", "--jobs", "3"], input="\n".join([*lines, "{}"]), text=True, capture_output=True,
                                cwd=self.folder, timeout=600, check=True)
        answers = [json.loads(line) for line in result.stdout.splitlines()]
        self.assertEqual(sorted((answer["line"], answer["exit"]) for answer in answers),
                         [(line, DONE) for line in range(1, 10)] + [(10, WRONG_INPUT)])
        self.assertTrue(all(self.is_shared(f"run{i}") for i in range(4, 9)))
        for output, values in settings.items():
            self.assert_is_single_run(output, values)

    def test_lines_with_a_keeper_that_fails_are_answered(self):
        """What is wrong with a line, its run says; and a keeper that is killed takes no run with it."""
        slow = ["Load program/Legs=0 0 -0.1 : 3000", "Output/Contact fields=0"]
        with self.batch() as batch:
            for _ in range(3):
                answer = batch.run("wrong", ["Geometry/Mesh file=none.msh", "Geometry/Shape=file", "Geometry/Held surface=a"])
                self.assertNotEqual(answer["exit"], DONE)
                self.assertIn("none.msh", answer["message"])
            for i in range(3):
                self.assertEqual(batch.run(f"run{i}")["exit"], DONE)
            self.assertTrue(self.is_shared("run2"))
            keeper, = batch.children()
            batch.begin("slow", slow)
            while not (self.folder / "slow/history.csv").exists():
                time.sleep(0.01)
            os.kill(keeper, signal.SIGKILL)
            self.assertEqual(batch.answer()["exit"], DONE)
            self.assertTrue(self.is_shared("slow"))
            self.assertEqual(batch.run("run3")["exit"], DONE)
            self.assertFalse(self.is_shared("run3"))
        self.assert_same_files("run0", "run3", FILES[:2])

    def test_a_run_that_is_killed_leaves_the_keeper(self):
        with self.batch() as batch:
            batch.run("run0")
            keeper, = batch.children()
            batch.begin("slow", ["Load program/Legs=0 0 -0.1 : 100000"])
            while not (self.folder / "slow/history.csv").exists():
                time.sleep(0.01)
            run, = set(batch.children()) - {keeper}
            os.kill(run, signal.SIGKILL)
            self.assertEqual(batch.answer()["exit"], KILLED)
            self.assertEqual(batch.run("run1")["exit"], DONE)
            self.assertTrue(self.is_shared("run1"))

    def test_interrupt_ends_with_the_runs(self):
        words = ["s.prm", "-q", "--threads", "1", "--set", "Load program/Legs=0 0 -0.1 : 100000", "-o"]
        process = subprocess.Popen([PROGRAM, "--batch", "--jobs", "2"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
                                   cwd=self.folder, start_new_session=True)
        process.stdin.write("".join(json.dumps([*words, f"run{i}"]) + "\n" for i in range(4)))
        process.stdin.flush()
        while process.poll() is None and not all((self.folder / f"run{i}/history.csv").exists() for i in range(2)):
            time.sleep(0.01)
        os.killpg(process.pid, signal.SIGINT)
        answers = [json.loads(line) for line in process.stdout]
        process.stdin.close()
        process.stdout.close()
        self.assertEqual((process.wait(), [answer["exit"] for answer in answers]), (130, [130, 130]))
        self.assertEqual(sorted(answer["line"] for answer in answers), [1, 2])

    def test_wrong_jobs_are_reported_in_a_line(self):
        for words, says in ((["--jobs", "2", "s.prm"], "without --batch"), (["--batch", "--jobs", "0"], "--jobs = 0"),
                            (["--batch", "--jobs", "2", "s.prm"], "--batch stands alone")):
            result = subprocess.run([PROGRAM, *words], capture_output=True, text=True, check=False, cwd=self.folder)
            self.assertEqual((result.returncode, result.stderr.count("\n")), (WRONG_INPUT, 1))
            self.assertIn(says, result.stderr)


if __name__ == "__main__":
    main()
