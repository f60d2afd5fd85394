# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Runs that stop and go on, and what an uninterrupted one leaves."""
import json
import subprocess

from program import RunTest

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
