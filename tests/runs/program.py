# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The program under test and a scratch folder to run it in."""
import csv
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PROGRAM = os.path.abspath(sys.argv[1])

# A mesh that is solved in no time, with the paper's load program.
SMALL = ["Mesh/Core cells=2", "Mesh/Rings=2", "Mesh/Layers=2", "Mesh/Degree=1"]

# The same as a file of its own, with a program of two steps.
SCENE = """subsection Mesh
  set Core cells = 2
  set Layers     = 1
  set Degree     = 1
end
subsection Load program
  set Legs = 0 0 -0.1 : 2
end
"""


class RunTest(unittest.TestCase):
    FILE = ROOT / "prm/paper/case_b.prm"

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def command(self, output, *arguments, settings=(), file=None):
        words = [f"--set={setting}" for setting in settings]
        return [PROGRAM, file or self.FILE, "--quiet", "--output", self.folder / output, *words, *arguments]

    def run_program(self, output, *arguments, settings=(), file=None, **options):
        return subprocess.run(self.command(output, *arguments, settings=settings, file=file), cwd=self.folder,
                              text=True, capture_output=True, timeout=600, check=False, **options)

    def run_all(self, *commands):
        """Runs of one start of the program, each in a process of its own: loading the libraries takes longer than a small
        scene. What --batch answers to each: exit, message and more."""
        lines = "".join(json.dumps([str(word) for word in command[1:]]) + "\n" for command in commands)
        batch = subprocess.run([PROGRAM, "--batch"], input=lines, cwd=self.folder, text=True, capture_output=True, timeout=1200,
                               check=True)
        return [json.loads(line) for line in batch.stdout.splitlines()]

    def kill_after(self, name, settings, seconds, file=None):
        """Goes on with a run, and kills it."""
        run = subprocess.Popen(self.command(name, "--resume", settings=settings, file=file), cwd=self.folder,
                               stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        time.sleep(seconds)
        run.kill()
        run.communicate()

    def rows(self, output, table="history.csv"):
        with open(self.folder / output / table, encoding="ascii") as file:
            return list(csv.DictReader(file))

    def assert_same_files(self, first, second, names):
        for name in names:
            self.assertEqual((self.folder / first / name).read_bytes(), (self.folder / second / name).read_bytes(), name)


def main():
    del sys.argv[1]
    unittest.main()
