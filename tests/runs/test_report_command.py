# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What of tools/report.py needs no browser: errors, what is left on the disk, and how much of a long run the page holds.

Usage: test_report_command.py PROGRAM [unittest options]"""
import json
import os
import pathlib
import re
import shutil
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True  # the source tree stays clean
from program import main  # noqa: E402
from report_page import table  # noqa: E402
from report_run import COARSE, SCRATCH, report, run  # noqa: E402


class CommandTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = run("command", *COARSE, "Load program/Cycles=1")

    def assert_error(self, result, code, pattern):
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertRegex(result.stderr, rf"^report: .*{pattern}.*\n$")
        self.assertEqual(result.stderr.count("\n"), 1)

    def test_wrong_usage(self):
        self.assert_error(report(), 2, "RUN_FOLDER")
        self.assert_error(report(self.folder, "--colour"), 2, "--colour")

    def test_no_run_folder(self):
        self.assert_error(report(self.folder / "nothing"), 4, "nothing: no such folder")
        empty = tempfile.mkdtemp(dir=SCRATCH.name)
        self.assert_error(report(empty), 4, "not a run folder, for history.csv and parameters.prm are missing")

    def test_bad_files(self):
        for name, text in (("contact-0003.vtu", "<VTKFile>"), ("history.csv", "step,ux\n1"), ("summary.json", "{"),
                           ("summary.json", "{}x"), ("parameters.prm", "subsection Friction\nend")):
            with self.subTest(name):
                bad = pathlib.Path(tempfile.mkdtemp(dir=SCRATCH.name)) / "bad"
                shutil.copytree(self.folder, bad)
                (bad / name).write_text(text)
                self.assert_error(report(bad), 4, f"{name}: cannot be understood")
                self.assertFalse(list(bad.glob("*report*")) + list(bad.glob(".report*")))

    def test_output(self):
        page = self.folder / "page.html"
        self.assertEqual(report(self.folder, "--output", page).returncode, 0)
        first = page.read_bytes()
        self.assertEqual(report(self.folder, "--output", page).returncode, 0)
        self.assertEqual(page.read_bytes(), first)
        self.assertFalse(list(self.folder.glob(".report*")))
        self.assertNotIn(str(self.folder.parent).encode(), first)
        self.assert_error(report(self.folder, "--output", self.folder), 4, "is no ordinary file")
        pipe = self.folder / "pipe"
        os.mkfifo(pipe)
        self.assert_error(report(self.folder, "--output", pipe), 4, "pipe: is no ordinary file")
        self.assert_error(report(self.folder, "--output", self.folder / "none/page.html"), 4, "none: no such folder")

    def test_long_run(self):
        folder = run("long", *COARSE, "Load program/Cycles=70")
        self.assertEqual((report(folder).returncode, len(table(folder))), (0, 1050))
        text = (folder / "report.html").read_text()
        self.assertLess(len(text), 5e6)
        self.assertIn("The maps show 60 of the 1050 steps", text)
        data = json.loads(re.search(r'id="data">(.*?)</script>', text)[1])
        steps = [frame["step"] for frame in data["maps"]["frames"]]
        self.assertEqual(steps[:15] + steps[-15:], [*range(1, 16), *range(1036, 1051)])
        self.assertTrue(set(steps) <= set(data["runs"][0]["history"]["step"]))


def tearDownModule():
    SCRATCH.cleanup()


if __name__ == "__main__":
    main()
