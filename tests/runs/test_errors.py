# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Bad input: what is rejected, with which exit code and sentence, and that a rejected run touches nothing.

Usage: test_errors.py PROGRAM [unittest options]"""
import json
import os
import pathlib
import re
import resource
import socket
import subprocess
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
import rejection  # noqa: E402
import wrong_input as table  # noqa: E402
from rejection import FILE_ERROR, WRONG_INPUT, content_of  # noqa: E402

NOBODY = 65534
CASE_B = pathlib.Path(__file__).resolve().parent.parent.parent / "prm/paper/case_b.prm"


def settings(overrides):
    return [word for override in overrides for word in ("--set", override)]


class ErrorTest(rejection.RejectionTest):
    def setUp(self):
        super().setUp()
        self.put("good.prm", table.SCENE)

    def assert_accepted(self, arguments, model="quarter", **options):
        before = content_of(self.folder)
        result = self.run_program(*arguments, "--check", **options)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertRegex(result.stdout, rf"^model +{model}\b")
        self.assertEqual(content_of(self.folder), before, "--check has changed the folder")

    def run_as_nobody(self, *arguments):
        """Root may read and write everything, so root has this done by an ordinary user."""
        try:
            return self.run_program(*arguments, **({"user": NOBODY} if os.geteuid() == 0 else {}))
        except PermissionError:
            return self.skipTest("runs as root, who may read everything, and cannot start PROGRAM as another user")


class ParameterTest(ErrorTest):
    def test_wrong_value_in_file(self):
        line = len(table.SCENE.splitlines()) + 2
        for given, section, entry, value, allowed in table.WRONG_VALUES:
            with self.subTest(given):
                self.put("case.prm", table.SCENE + f"subsection {section}\n  set {entry} = {value}\nend\n")
                expression = re.escape(f"case.prm:{line}: {given}: allowed is {allowed}")
                self.assert_rejected(["case.prm"], WRONG_INPUT, expression)

    def test_wrong_value_on_command_line(self):
        for given, section, entry, value, allowed in table.WRONG_VALUES:
            with self.subTest(given):
                expression = re.escape(f"--set: {given}: allowed is {allowed}")
                self.assert_rejected(["good.prm", "--set", f"{section}/{entry}={value}"], WRONG_INPUT, expression)

    def test_contradiction(self):
        for overrides, expression in table.CONTRADICTIONS:
            with self.subTest(overrides=overrides):
                self.assert_rejected(["good.prm", *settings(overrides)], WRONG_INPUT, r"good\.prm: " + expression)

    def test_wrong_text(self):
        for text, code, expression in table.WRONG_TEXTS:
            with self.subTest(text=text[-50:]):
                self.put("case.prm", text)
                self.assert_rejected(["case.prm"], code, expression)

    def test_wrong_json(self):
        for content, expression in table.WRONG_JSON:
            with self.subTest(content=content):
                self.put("case.json", content if isinstance(content, str) else json.dumps(content))
                self.assert_rejected(["case.json"], WRONG_INPUT, expression)

    def test_command_line(self):
        for arguments, code, expression in table.COMMAND_LINES:
            with self.subTest(arguments=arguments):
                self.assert_rejected(arguments, code, expression)

    def test_message_is_one_piece(self):
        """Else words of mpirun may get in between. A socket for datagrams gives what is written piece by piece."""
        here, there = socket.socketpair(socket.AF_UNIX, socket.SOCK_DGRAM)
        with here, there:
            subprocess.run([self.program, "missing.prm"], cwd=self.folder, stderr=there, check=False,
                           timeout=60)
            self.assertRegex(here.recv(10000), rb"(?s)^orthocone: missing\.prm: .*\n$")

    def test_suggestion(self):
        for name, suggested in table.NAMES_ON_COMMAND_LINE:
            with self.subTest(name):
                expression = re.escape("--set: " + table.not_an_entry(name, suggested)) + "$"
                self.assert_rejected(["good.prm", "--set", f"{name}=1"], WRONG_INPUT, expression)

    def test_fault_in_included_file(self):
        self.put("case.prm", table.LEGS + "include parts/middle.prm\n")
        self.put("parts/middle.prm", "# comment\ninclude mesh.prm\n")
        for text, expression in table.FAULTS_OF_INCLUDED_FILE:
            with self.subTest(text=text):
                self.put("parts/mesh.prm", text)
                self.assert_rejected(["case.prm"], WRONG_INPUT, expression)

    def test_gap_file(self):
        self.put("parts/case.prm", table.SCENE + "subsection Obstacle\n  set Gap file = gap.txt\nend\n")
        for grid, expression in table.GAP_FILES:
            with self.subTest(grid=grid):
                self.put("parts/gap.txt", grid)
                self.assert_rejected(["parts/case.prm"], WRONG_INPUT, r"parts/case\.prm: \S*/parts/gap\.txt" + expression)
        (self.folder / "parts/gap.txt").unlink()
        self.assert_rejected(["parts/case.prm"], FILE_ERROR, r"\S*/parts/gap\.txt: cannot be read \(No such file")

    def test_fields_and_early_forces(self):
        for override, expression in table.FIELDS:
            with self.subTest(override=override):
                self.assert_rejected(["good.prm", *settings([override])], WRONG_INPUT, r"good\.prm: " + expression + "$")
        for overrides, expression in table.EARLY_FORCES:
            with self.subTest(overrides=overrides):
                self.assert_rejected(["good.prm", *settings(overrides)], WRONG_INPUT, r"good\.prm: " + expression + "$")

    def test_grid_that_is_too_small(self):
        self.put("gap.txt", "-1 2 2 -1 2 2\n0 0\n0 0\n")
        self.assert_rejected(["good.prm", *settings([f"Obstacle/Gap file={self.folder / 'gap.txt'}"])], WRONG_INPUT,
                             r"good\.prm: Obstacle/Gap file = \S*gap\.txt: allowed is a grid that covers the whole contact "
                             r"surface, also \(\S+, \S+\) mm; this one reaches from \(-1, -1\) mm to \(1, 1\) mm$")

    def test_unreadable_file(self):
        self.put("secret.prm", table.SCENE).chmod(0)
        result = self.run_as_nobody("secret.prm")
        self.assert_sentence(result, FILE_ERROR, r"secret\.prm: cannot be read \(Permission denied\)")

    def test_unusual_but_valid(self):
        for overrides, model in table.VALID:
            with self.subTest(overrides=overrides):
                self.assert_accepted(["good.prm", *settings(overrides)], model)

    def test_warnings(self):
        for overrides, expressions in table.WARNINGS:
            with self.subTest(overrides=overrides):
                result = self.run_program(str(CASE_B), *settings(overrides), "--check")
                self.assertEqual((result.returncode, result.stderr), (0, ""))
                warnings = [line for line in result.stdout.splitlines() if line.startswith("warning: ")]
                self.assertEqual(len(warnings), len(expressions), result.stdout)
                for warning, expression in zip(warnings, expressions):
                    self.assertRegex(warning, "^warning: " + expression)

    def test_valid_files(self):
        self.put("cases/case.prm", "include ../parts/scene.prm # from the folder of this file\n")
        self.put("parts/scene.prm", "include load.prm\n")
        self.put("parts/load.prm", table.SCENE)
        self.assert_accepted(["cases/case.prm"])
        self.assert_accepted(["../cases/case.prm"], folder="parts")
        self.put("case.json", json.dumps({"Mesh": {"Degree": 1}, "Load program": {"Legs": "0 0 -0.1 : 1"}}))
        self.assert_accepted(["case.json"])
        self.put("dos.prm", table.SCENE.replace("\n", "\r\n"))
        self.assert_accepted(["dos.prm"])
        self.put("defaults.prm", self.run_program("--defaults").stdout)
        self.assert_accepted(["defaults.prm", "--set", "Load program/Legs=0 0 -0.1 : 1"])


class RunFolderTest(ErrorTest):
    def test_folder_that_cannot_be_made(self):
        self.put("taken", "precious")
        self.put("output", "precious")
        for arguments, expression in [(["--output", "taken"], "taken: .*run folder.*file of this name.*--output"),
                                      (["--output", "taken/x"], r"taken/x: .*run folder \(Not a directory\)"),
                                      ([], r"output/good: .*run folder \(Not a directory\)"),
                                      (["--output", "/proc/x"], r"/proc/x: cannot be the run folder \(it belongs to the system")]:
            with self.subTest(arguments=arguments):
                self.assert_rejected(["good.prm", *arguments], FILE_ERROR, expression)

    def test_unwritable_run_folder(self):
        self.assertEqual(self.run_program("good.prm", "--output", "run", "--quiet").returncode, 0)
        before = content_of(self.folder)
        (self.folder / "run").chmod(0o555)
        result = self.run_as_nobody("good.prm", "--output", "run")
        self.assertEqual(content_of(self.folder), before)
        self.assert_sentence(result, FILE_ERROR, r"run\b.*\(Permission denied\)")

    def test_full_disk(self):
        """A limit on the size of files stands for the full disk: no file may appear under its name incomplete."""
        result = self.run_program("good.prm", "--output", "run", "--quiet", "--set", "Mesh/Core cells=24",
                                  restore_signals=False,  # keeps SIGXFSZ ignored, as Python has it
                                  preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (40000, 40000)))
        self.assert_sentence(result, FILE_ERROR, r"run/(contact-0001\.vtu|checkpoint/state)\S*: cannot be written \(File too large\)")
        self.assertFalse((self.folder / "run/contact-0001.vtu").exists())

    def test_detour_makes_no_folder(self):
        self.assertEqual(self.run_program("good.prm", "--output", "a/../b", "--quiet").returncode, 0)
        self.assertTrue((self.folder / "b/history.csv").exists())
        self.assertFalse((self.folder / "a").exists())

    def test_wrong_input_keeps_earlier_results(self):
        self.assertEqual(self.run_program("good.prm", "--quiet").returncode, 0)
        self.assertTrue((self.folder / "output/good/history.csv").exists())
        for overrides in (["Mesh/Degree=9"], ["Output/Probes=P: 11 0"], ["Mesh/Model=half", "Mesh/Core cells=3"]):
            with self.subTest(overrides=overrides):
                self.assert_rejected(["good.prm", *settings(overrides)], WRONG_INPUT, "")
        self.put("good.prm", table.SCENE + "nonsense\n")
        self.assert_rejected(["good.prm"], WRONG_INPUT, r"good\.prm:10: 'nonsense'")


if __name__ == "__main__":
    rejection.main()
