# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What the tests of bad input share: a scratch folder, the program, and what a rejected run must and must not do."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

WRONG_INPUT, FILE_ERROR = 2, 4

# Words of the libraries beneath, which mean nothing to users.
LIBRARY_TALK = re.compile(r"Line <|pattern|Boost|boost|assert|[Ee]xception|unspecified|declared|std::|dealii")


def content_of(folder):
    """Everything below a folder: path -> (bytes, time of the last change)."""
    files = sorted(pathlib.Path(folder).rglob("*"))
    return {str(file): (file.read_bytes() if file.is_file() else None, file.stat().st_mtime_ns) for file in files}


class RejectionTest(unittest.TestCase):
    program = ""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.folder.chmod(0o777)

    def put(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text.encode())
        return path

    def run_program(self, *arguments, folder=".", **options):
        options = {"errors": "replace", **options}
        return subprocess.run([self.program, *arguments], cwd=self.folder / folder, timeout=120, text=True,
                              capture_output=True, check=False, env={**os.environ, "LC_ALL": "C"}, **options)

    def assert_sentence(self, result, code, expression):
        lines = result.stderr.splitlines()
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertIn(len(lines), (1, 2), result.stderr)
        self.assertTrue(lines[0].startswith("orthocone: "), result.stderr)
        self.assertRegex(" ".join(lines), "^orthocone: (" + expression + ")")
        self.assertNotRegex(result.stderr, LIBRARY_TALK)
        self.assertEqual(result.stdout, "")

    def assert_rejected(self, arguments, code, expression, **options):
        before = content_of(self.folder)
        result = self.run_program(*arguments, **options)
        self.assert_sentence(result, code, expression)
        self.assertEqual(content_of(self.folder), before, "the rejected run has changed the folder")
        return result


def main():
    RejectionTest.program = os.path.abspath(sys.argv.pop(1))
    unittest.main()
