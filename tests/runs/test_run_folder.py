# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The run folder: whose files it may replace, and what becomes of files that something else touches.

Usage: test_run_folder.py PROGRAM [unittest options]"""
import functools
import json
import os
import shutil
import subprocess
import sys
import time

sys.dont_write_bytecode = True  # the source tree stays clean
from program import PROGRAM, ROOT, RunTest, SCENE, SMALL, main  # noqa: E402

DONE, BAD_INPUT, FILE_ERROR = 0, 2, 4


class RunFolderTest(RunTest):
    def start(self, *arguments, folder="."):
        return subprocess.run([PROGRAM, *arguments], cwd=self.folder / folder, text=True, capture_output=True,
                              timeout=60, check=False)

    def put(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def content(self, name):
        return {str(file): file.read_bytes() for file in sorted((self.folder / name).rglob("*")) if file.is_file()}

    def test_files_of_users_are_safe(self):
        """parameters.prm is what users of deal.II call their input."""
        mine = {"parameters.prm": SCENE, "log.txt": "my log", "history.csv": "1,2,3\n", "report.html": "<html>mine</html>"}
        for names in (list(mine), ["parameters.prm"], ["report.html"], ["orthocone-run.txt"]):
            with self.subTest(names=names):
                folder = "-".join(names)
                for name in names:
                    self.put(f"{folder}/{name}", mine.get(name, "mine"))
                self.put("case.prm", SCENE)
                before = self.content(folder)
                for arguments in ((), ("--resume",)):
                    result = self.start("../case.prm", "--output", ".", *arguments, folder=folder)
                    self.assertEqual(result.returncode, FILE_ERROR, result.stderr)
                    self.assertRegex(result.stderr, r"^orthocone: \.: cannot be the run folder \(it holds a .*, and no run "
                                                    r"has left it there; --output DIR takes another one\)\n$")
                    self.assertEqual(self.content(folder), before)

    def test_files_of_the_input_may_go_while_a_run_goes_on(self):
        """A run of hours ends with its summary, whatever became of a gap file since its start."""
        self.put("gap.txt", "-10 10 3 -10 10 3\n" + 3 * "0 0 0\n")
        settings = [*SMALL, "Mesh/Layers=2", "Obstacle/Gap=(x^2+y^2)/200", "Obstacle/Gap file=gap.txt",
                    "Load program/Legs=0 0 -0.01 : 150 ; 0 0 0 : 150", "Load program/Cycles=1"]
        command = self.command("run", settings=settings, file=ROOT / "prm/paper/scene.prm")
        with subprocess.Popen(command, cwd=self.folder, text=True, stderr=subprocess.PIPE) as going:
            history = self.folder / "run/history.csv"
            while going.poll() is None and not (history.exists() and history.stat().st_size):
                time.sleep(0.01)
            (self.folder / "gap.txt").unlink()
            said = going.communicate(timeout=100)[1]
        self.assertEqual((going.returncode, said), (DONE, ""))
        summary = json.loads((self.folder / "run/summary.json").read_text())
        self.assertEqual(summary["status"], "complete")
        self.assertIn("Mesh: the layer of cells at the contact is 5 mm high", "\n".join(summary["warnings"]))

    def test_a_copy_of_parameters_marks_no_folder(self):
        self.put("case.prm", SCENE)
        self.assertEqual(self.start("case.prm", "--output", "run").returncode, DONE)
        self.put("mine/parameters.prm", (self.folder / "run/parameters.prm").read_text())
        before = self.content("mine")
        self.assertEqual(self.start("parameters.prm", "--output", ".", folder="mine").returncode, FILE_ERROR)
        self.assertEqual(self.content("mine"), before)

    def test_bodies_that_do_not_meet_replace_nothing(self):
        """The sizes of both bodies are right. Only their meshes tell that one is not under the other."""
        self.put("case.prm", SCENE)
        self.assertEqual(self.start("case.prm", "--output", "run").returncode, DONE)
        before = self.content("run")
        narrow = ("--set", "Obstacle/Kind=body", "--set", "Lower geometry/Radius=9", "--set", "Lower mesh/Layers=1")
        for arguments in (("--output", "run"), ("--output", "run", "--insist"), ("--check",)):
            result = self.start("case.prm", *arguments, *narrow)
            self.assertEqual(result.returncode, BAD_INPUT, result.stderr)
            self.assertRegex(result.stderr, r"^orthocone: case\.prm: Obstacle/Kind = body: the lower body is under \d+ % of the face "
                                            r"of the contact surface about \(.*\) mm: allowed are 90 and more of every face; .*\n$")
            self.assertEqual(self.content("run"), before)

    def test_folders_of_earlier_versions_are_replaced(self):
        """They had no marker, but a checkpoint."""
        self.put("case.prm", SCENE)
        self.assertEqual(self.start("case.prm", "--output", "run").returncode, DONE)
        (self.folder / "run/orthocone-run.txt").unlink()
        self.assertEqual(self.start("case.prm", "--output", "run").returncode, DONE)
        self.assertTrue((self.folder / "run/orthocone-run.txt").exists())

    def test_two_files_of_one_stem(self):
        for name in ("a/case.prm", "b/case.prm"):
            self.put(name, SCENE)
        self.assertNotIn("another file", self.start("a/case.prm").stdout)
        self.assertNotIn("another file", self.start("a/case.prm").stdout)
        result = self.start("b/case.prm")
        self.assertEqual(result.returncode, DONE)
        self.assertRegex(result.stdout, r"warning: output/case held the results of another file, .*/a/case\.prm; ")
        self.assertIn("a/case.prm", (self.folder / "output/case/log.txt").read_text())

    def test_links_are_not_followed(self):
        """Somebody else may write into a folder that is shared."""
        self.put("case.prm", SCENE)
        self.assertEqual(self.start("case.prm", "--output", "run").returncode, DONE)
        self.put("precious", "precious")
        for name in ("history.csv", "history.csv.part", "parameters.prm.part", "summary.json.part", "contact.pvd.part",
                     "contact-0001.vtu.part", "log.txt", "checkpoint/state.part"):
            with self.subTest(name):
                path = self.folder / "run" / name
                path.unlink(missing_ok=True)
                path.symlink_to(self.folder / "precious")
                self.assertEqual(self.start("case.prm", "--output", "run").returncode, DONE)
                self.assertEqual((self.folder / "precious").read_text(), "precious")
                self.assertFalse(path.is_symlink())

    def test_a_folder_from_somebody_else(self):
        """Whatever its files say: a new run and a resumed one remove, cut and write inside of it, or end with one line."""
        self.put("case.prm", SCENE)
        self.put("home/thesis.csv", "mine")
        self.put("home/state", "mine")
        for arguments in ((), ("--resume",)):
            for name, change in self.foreign_changes().items():
                with self.subTest(name, arguments=arguments):
                    self.assertEqual(self.start("case.prm", "--output", "run").returncode, DONE)
                    change(self.folder / "run")
                    result = self.start("case.prm", "--output", "run", *arguments)
                    self.assertIn(result.returncode, (DONE, FILE_ERROR), result.stderr)
                    self.assertLessEqual(result.stderr.count("\n"), 1, result.stderr)
                    self.assertEqual({file.name: file.read_text() for file in (self.folder / "home").iterdir()},
                                     {"thesis.csv": "mine", "state": "mine"})
                    shutil.rmtree(self.folder / "run")

    def foreign_changes(self):
        """What somebody may have done to a run folder."""
        home = self.folder / "home"

        def marker(run):
            with open(run / "orthocone-run.txt", "a", encoding="ascii") as file:
                file.write(f"probe-x/../../home/thesis.csv\nprobe-{home}/thesis.csv\n../home/thesis.csv\n")
            (run / "probe-x").mkdir()

        def link(name, target, run):
            path = run / name
            if path.is_dir():
                shutil.rmtree(path)
            path.unlink(missing_ok=True)
            path.symlink_to(target)

        def pipe(name, run):
            (run / name).unlink(missing_ok=True)
            os.mkfifo(run / name)

        def large(name, run):
            os.truncate(run / name, 10 ** 13)

        changes = {"names in the marker": marker, "checkpoint elsewhere": lambda run: link("checkpoint", home, run)}
        for name in ("orthocone-run.txt", "history.csv", "checkpoint/state", "parameters.prm", "summary.json"):
            changes[name + " a link"] = functools.partial(link, name, home / "thesis.csv")
            changes[name + " a device"] = functools.partial(link, name, "/dev/zero")
            changes[name + " a pipe"] = functools.partial(pipe, name)
        for name in ("orthocone-run.txt", "checkpoint/state", "parameters.prm"):
            changes[name + " large"] = functools.partial(large, name)
        return changes

    def test_folders_of_the_system(self):
        self.put("case.prm", SCENE)
        for name in ("/", "/proc/self", "/usr/share"):
            result = self.start("case.prm", "--output", name)
            self.assertEqual(result.returncode, FILE_ERROR, result.stderr)
            self.assertRegex(result.stderr, rf"^orthocone: {name}: cannot be the run folder \(it .*; --output DIR takes another one\)\n$")

    def run_while(self, name, touch):
        """A run whose folder is touched after its third step."""
        settings = [*SMALL, "Load program/Cycles=200", "Output/Contact fields=3", "Output/Volume fields=0"]
        run = subprocess.Popen(self.command(name, settings=settings), cwd=self.folder, text=True, stderr=subprocess.PIPE)
        while not (self.folder / name / "contact-0003.vtu").exists() and run.poll() is None:
            time.sleep(0.001)
        touch(self.folder / name / "history.csv")
        return run.communicate(timeout=60)[1], run.returncode

    def test_tables_that_vanish_or_change(self):
        def longer(path):
            with open(path, "a", encoding="ascii") as file:
                file.write("mine\n")
        for name, touch, expression in (("less", os.remove, "was removed during the run"),
                                        ("more", longer, "was changed during the run")):
            with self.subTest(expression):
                error, code = self.run_while(name, touch)
                self.assertEqual(code, FILE_ERROR, error)
                self.assertRegex(error, rf"^orthocone: .*{name}/history\.csv: {expression}.*\n$")


if __name__ == "__main__":
    main()
