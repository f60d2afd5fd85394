# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What the tests of bad input share: a scratch folder, the program, and what a rejected run must and must not do."""
import json
import os
import pathlib
import re
import select
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
    batch = None  # the process that runs command lines

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

    def run_in_batch(self, *arguments):
        """The same by --batch, without the time of a start, which is most of the time that a rejection takes."""
        words = json.dumps(list(map(str, arguments)), ensure_ascii=False) + "\n"
        if self.batch is None:
            self.batch = subprocess.Popen([self.program, "--batch"], cwd=self.folder, text=True, stdin=subprocess.PIPE,
                                          encoding="utf-8", stdout=subprocess.PIPE, env={**os.environ, "LC_ALL": "C"})
            self.addCleanup(self.end_batch)
        self.batch.stdin.write(words)
        self.batch.stdin.flush()
        if not select.select([self.batch.stdout], [], [], 120)[0]:
            self.batch.kill()
            self.fail(f"no answer to {words}")
        answer = json.loads(self.batch.stdout.readline())
        return subprocess.CompletedProcess(arguments, answer["exit"], answer["output"], answer["message"])

    def end_batch(self):
        self.batch.stdin.close()
        self.batch.stdout.close()
        self.batch.wait()

    def run_rejected(self, arguments, options):
        """JSON holds no bytes that are not UTF-8."""
        try:
            "".join(map(str, arguments)).encode()
        except UnicodeEncodeError:
            return self.run_program(*arguments, **options)
        if set(options) - {"errors"}:
            return self.run_program(*arguments, **options)
        result = self.run_in_batch(*arguments)
        return result if "\ufffd" not in result.stderr else self.run_program(*arguments, **options)

    def assert_rejected(self, arguments, code, expression, **options):
        before = content_of(self.folder)
        result = self.run_rejected(arguments, options)
        self.assert_sentence(result, code, expression)
        self.assertEqual(content_of(self.folder), before, "the rejected run has changed the folder")
        return result


def main():
    RejectionTest.program = os.path.abspath(sys.argv.pop(1))
    unittest.main()
