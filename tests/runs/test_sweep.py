# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Parameter studies: --batch of the program, and tools/sweep around it.

Usage: test_sweep.py PROGRAM [unittest options]"""
import csv
import json
import os
import shutil
import signal
import subprocess
import sys
import time

sys.dont_write_bytecode = True  # the source tree stays clean
from program import PROGRAM, ROOT, SCENE, RunTest, main  # noqa: E402

SWEEP = ROOT / "tools/sweeps/sweep.py"


class BatchTest(RunTest):
    def answers(self, *lines):
        text = "".join(line if isinstance(line, str) else json.dumps(line) + "\n" for line in lines)
        result = subprocess.run([PROGRAM, "--batch"], input=text, text=True, capture_output=True, cwd=self.folder, timeout=600,
                                check=False)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return [json.loads(line) for line in result.stdout.splitlines()]

    def setUp(self):
        super().setUp()
        (self.folder / "s.prm").write_text(SCENE)

    def test_runs_are_those_of_the_program_alone(self):
        self.run_program("alone", file="s.prm")
        first, second = self.answers(["s.prm", "-o", "one"], ["s.prm", "--quiet", "--output", "two"])
        for answer in (first, second):
            self.assertEqual((answer["exit"], answer["message"]), (0, ""))
            self.assertGreater(answer["cpu_seconds"], 0)
        for folder in ("one", "two"):
            self.assert_same_files("alone", folder, ["history.csv", "checks.csv", "parameters.prm"])

    def test_every_line_gets_an_answer(self):
        version, *answers = self.answers(["--version"], ["none.prm"], "not JSON\n", ["s.prm", 3], "{}\n", ["s.prm", "--set", "Mesh/Degree=9"], [],
                               ["s.prm", "--quiet", "--set", "Contact solver/Maximum iterations=1"], ["s.prm"])
        self.assertEqual([answer["exit"] for answer in answers], [4, 2, 2, 2, 2, 2, 3, 0])
        self.assertRegex(version["output"], r"^orthocone \S+")
        self.assertIn("none.prm: cannot be read", answers[0]["message"])
        self.assertIn("allowed is a JSON array of words", answers[1]["message"])
        self.assertIn("Mesh/Degree = 9: allowed is", answers[4]["message"])

    def test_a_run_that_dies_leaves_the_others(self):
        slow = ["s.prm", "-o", "slow", "--set", "Load program/Legs=0 0 -0.1 : 100000"]
        process = subprocess.Popen([PROGRAM, "--batch"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
                                   cwd=self.folder)
        process.stdin.write(json.dumps(slow) + "\n" + json.dumps(["s.prm"]) + "\n")
        process.stdin.close()
        while process.poll() is None and not (self.folder / "slow/history.csv").exists():
            time.sleep(0.01)
        subprocess.run(["pkill", "-KILL", "-P", str(process.pid)], check=True)
        answers = [json.loads(line) for line in process.stdout]
        process.wait()
        process.stdout.close()
        self.assertEqual([answer["exit"] for answer in answers], [137, 0])

    def test_interrupt_ends_with_the_run(self):
        slow = json.dumps(["s.prm", "-o", "slow", "--set", "Load program/Legs=0 0 -0.1 : 100000"]) + "\n"
        process = subprocess.Popen([PROGRAM, "--batch"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
                                   cwd=self.folder, start_new_session=True)
        process.stdin.write(slow + slow)
        process.stdin.close()
        while process.poll() is None and not (self.folder / "slow/history.csv").exists():
            time.sleep(0.01)
        os.killpg(process.pid, signal.SIGINT)
        answers = [json.loads(line) for line in process.stdout]
        process.stdout.close()
        self.assertEqual((process.wait(), [answer["exit"] for answer in answers]), (130, [130]))

    def test_stands_alone(self):
        result = subprocess.run([PROGRAM, "--batch", "s.prm"], capture_output=True, text=True, check=False, cwd=self.folder)
        self.assertEqual(result.returncode, 2)
        self.assertIn("--batch stands alone", result.stderr)


class SweepTest(RunTest):
    def sweep(self, *words, code=0):
        result = subprocess.run(["/usr/bin/python3", SWEEP, "s.prm", "--program", PROGRAM, *words], capture_output=True,
                                text=True, check=False, cwd=self.folder, timeout=600)
        self.assertEqual(result.returncode, code, result.stderr)
        return result

    def table(self, folder="output/sweep-s"):
        with open(self.folder / folder / "sweep.csv", encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))

    def setUp(self):
        super().setUp()
        (self.folder / "s.prm").write_text(SCENE)

    GRID = ("--vary", "mu=0.1:0.3:3", "--vary", "Material/Poisson ratio=0.2,0.4", "--set",
            "Friction/Coefficients={mu}, 0.1")

    def test_a_row_is_the_run_of_its_point(self):
        self.sweep(*self.GRID)
        rows = self.table()
        self.assertEqual([(row["mu"], row["Material/Poisson ratio"]) for row in rows],
                         [(mu, nu) for mu in ("0.1", "0.2", "0.3") for nu in ("0.2", "0.4")])
        result = self.run_program("alone", file="s.prm", settings=["Friction/Coefficients=0.3, 0.1", "Material/Poisson ratio=0.4"])
        self.assertEqual(result.returncode, 0)
        summary = json.loads((self.folder / "alone/summary.json").read_text())
        self.assertEqual(float(rows[-1]["max_slip"]), summary["peaks"]["slip_mm"]["value"])
        self.assertEqual(float(rows[-1]["total_dissipation"]), summary["total_dissipation_Nmm"])
        page = (self.folder / "output/sweep-s/sweep.html").read_text()
        self.assertEqual(page.count("<tr"), 7)
        self.assertIn("largest slip", page)
        self.assertEqual(page.count("<svg"), 1)

    def test_goes_on_with_what_is_missing(self):
        self.sweep(*self.GRID)
        before = {path: os.stat(path).st_mtime_ns for path in self.folder.glob("output/sweep-s/runs/*/history.csv")}
        self.assertEqual(len(before), 6)
        lost = self.folder / "output/sweep-s/runs/mu=0.2,Poisson ratio=0.4"
        shutil.rmtree(lost)
        table = self.table()
        self.assertIn("6 points, 1 to run", self.sweep(*self.GRID).stdout)
        for path, time in before.items():
            self.assertEqual(os.stat(path).st_mtime_ns == time, path.parent != lost, path)
        for row, earlier in zip(self.table(), table):
            self.assertEqual(row["max_slip"], earlier["max_slip"])
        finer = ("--vary", "mu=0.1:0.3:5", *self.GRID[2:])
        self.assertIn("10 points, 4 to run", self.sweep(*finer).stdout)

    def test_a_run_that_fails_is_a_row(self):
        result = self.sweep("--vary", "Contact solver/Maximum iterations=1,1000", code=3)
        self.assertIn("Maximum iterations=1: exit code 3", result.stderr)
        failed, solved = self.table()
        self.assertEqual((failed["exit"], solved["exit"]), ("3", "0"))
        self.assertIn("Maximum iterations", failed["status"])
        self.assertIn("1 of 2 runs are not complete", (self.folder / "output/sweep-s/sweep.html").read_text())

    def test_interrupted_studies_go_on(self):
        words = ["/usr/bin/python3", SWEEP, "s.prm", "--program", PROGRAM, "--jobs", "1", "--vary", "Material/Poisson ratio=0.2,0.3",
                 "--set", "Load program/Legs=0 0 -0.1 : 400", "--set", "Output/Checkpoint=0"]
        process = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=self.folder,
                                   start_new_session=True)
        while process.poll() is None and not list(self.folder.glob("output/sweep-s/runs/*/checkpoint/state")):
            time.sleep(0.01)
        os.killpg(process.pid, signal.SIGINT)  # as a terminal does
        _, error = process.communicate(timeout=120)
        self.assertEqual(process.returncode, 130, error)
        first, second = self.table()
        self.assertEqual((first["exit"], second["status"]), ("130", "not run"))
        done = int(json.loads((self.folder / "output/sweep-s" / first["folder"] / "summary.json").read_text())["steps"]["solved"])
        self.assertGreater(done, 0)
        subprocess.run(words, check=True, capture_output=True, cwd=self.folder, timeout=600)
        self.assertEqual([row["steps_solved"] for row in self.table()], ["400", "400"])
        self.assertIn("resumed after load step", (self.folder / "output/sweep-s" / first["folder"] / "log.txt").read_text())

    def test_a_changed_file_is_another_study(self):
        self.sweep("--vary", "Mesh/Degree=1,2")
        (self.folder / "s.prm").write_text(SCENE.replace("-0.1", "-0.2"))
        self.sweep("--vary", "Mesh/Degree=1,2", "--anew")
        (self.folder / "s.prm").write_text(SCENE)
        error = self.sweep("--vary", "Mesh/Degree=1,2", code=2).stderr
        self.assertRegex(error, r"^sweep: output/sweep-s: holds a study of \S*s\.prm as it was before it changed; --output DIR .*\n$")

    def test_a_changed_mesh_is_another_study(self):
        mesh = self.folder / "part.msh"
        whole = (ROOT / "prm/import/cylinder_coarse.msh").read_bytes()
        entries = ["Geometry/Shape=file", "Geometry/Contact surface=base", "Geometry/Held surface=top",
                   "Geometry/Symmetry surfaces=x0, y0"]
        legs = "subsection Load program\n  set Legs = 0 0 -0.1 : 1\nend\n"
        words = ["--vary", "Mesh/Degree=1,2", *(word for entry in entries for word in ("--set", entry))]
        for named_by, scene, more in (("set", "", ["--set", "Geometry/Mesh file=part.msh"]),
                                      ("file", "subsection Geometry\n  set Mesh file = part.msh\nend\n", [])):
            mesh.write_bytes(whole)
            (self.folder / "s.prm").write_text(legs + scene)
            self.sweep(*words, *more, "-o", named_by)
            mesh.write_bytes(whole + b"\n")
            self.assertIn("as it was before it changed", self.sweep(*words, *more, "-o", named_by, code=2).stderr)

    def test_wrong_studies_are_reported_in_a_line(self):
        for words, says in ((("--vary", "iterations=1,2"), r"iterations is a column of the table"),
                            (("--vary", "mu=1:2:3"), r"mu stands in no --set"), (("--vary", "mu"), r"allowed is NAME=VALUES"),
                            (("--vary", "a=1:2:1", "--set", "{a}"), r"FIRST:LAST:NUMBER"),
                            (("--vary", "a=1,,2", "--set", "{a}"), r"words separated by commas"),
                            (("--vary", "a=1,1", "--set", "{a}"), r"each of them once"),
                            (("--vary", "a=1,2", "--set", "{a}{b}"), r"\{b\} is not varied; allowed are a"),
                            (("--vary", "a=0:1:1000000000", "--set", "{a}"), r"a count from 2 to 100000"),
                            (("--vary", "a=0:inf:3", "--set", "{a}"), r"FIRST:LAST:NUMBER with two numbers"),
                            (("--vary", "a=0:1:9999", "--vary", "b=0:1:9999", "--set", "{a}{b}"), r"makes 99980001 runs"),
                            (("--vary", "Mesh/Degree=1,2", "--jobs", "0"), r"--jobs = 0")):
            error = self.sweep(*words, code=2).stderr
            self.assertRegex(error, r"^sweep: .*\n$")
            self.assertRegex(error, says)
        self.assertFalse((self.folder / "output").exists())

    def test_what_cannot_be_read_or_written_is_named(self):
        (self.folder / "taken").write_text("a file\n")
        self.assertRegex(self.sweep("--vary", "Mesh/Degree=1,2", "-o", "taken/x", code=4).stderr, r"^sweep: taken/x.*: Not a directory\n$")
        (self.folder / "s.prm").unlink()
        self.assertEqual(self.sweep("--vary", "Mesh/Degree=1,2", code=4).stderr, "sweep: s.prm: No such file or directory\n")
        self.assertFalse((self.folder / "output").exists())

    def test_a_folder_holds_one_study(self):
        self.sweep("--vary", "Mesh/Degree=1,2")
        error = self.sweep("--vary", "Mesh/Degree=1,2", "--set", "Load program/Cycles=2", code=2).stderr
        self.assertRegex(error, r"^sweep: output/sweep-s: holds a study of other runs .*--output DIR takes another folder\n$")


    def test_damaged_and_special_files_are_reported_in_a_line(self):
        study = self.folder / "output/sweep-s/sweep.json"
        self.sweep("--vary", "Mesh/Degree=1,2")
        whole = study.read_text()
        for text in ("", "{", whole[:-20], "[]", "1", "{}", whole.replace('"set": []', '"set": 3'), "\0" * 9, "[" * 100000):
            with self.subTest(text[:20]):
                study.write_text(text)
                error = self.sweep("--vary", "Mesh/Degree=1,2", code=2).stderr
                self.assertRegex(error, r"^sweep: output/sweep-s/sweep.json: is (damaged|no JSON of a run).* --output DIR takes another folder\n$")
                self.assertEqual(study.read_text(), text)
        study.unlink()
        os.mkfifo(study)
        self.assertRegex(self.sweep("--vary", "Mesh/Degree=1,2", code=2).stderr, r"^sweep: .*sweep.json: is no ordinary file")
        (self.folder / "s.prm").unlink()
        for make in (os.mkfifo, lambda path: path.symlink_to("/dev/zero"), os.mkdir):
            make(self.folder / "s.prm")
            self.assertRegex(self.sweep("--vary", "Mesh/Degree=1,2", code=2).stderr, r"^sweep: s.prm: is no ordinary file, but .*\n$")
            os.rmdir(self.folder / "s.prm") if make is os.mkdir else (self.folder / "s.prm").unlink()


if __name__ == "__main__":
    main()
