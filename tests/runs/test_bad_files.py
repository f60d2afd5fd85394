# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The bad parameter files of tests/errors, one fault each: each is rejected with the message that it expects.

Most are rows of the tables tests/errors/*.py, from which the files are made. What only a file can be (bytes, encodings,
line ends, includes) is a file. The message stands in the first lines of a file, as '# expect: MESSAGE', or in
FILE.expect where a file cannot hold it; {file} stands for the file's path as given, {folder} for that of its folder.
Parts that others include are in folders named 'included'.

Usage: test_bad_files.py PROGRAM [unittest options]"""
import os
import pathlib
import re
import runpy
import shutil
import sys
import tempfile

sys.dont_write_bytecode = True  # the source tree stays clean
import rejection  # noqa: E402

SOURCE = pathlib.Path(__file__).resolve().parent.parent / "errors"
SCRATCH = tempfile.TemporaryDirectory()
ERRORS = pathlib.Path(SCRATCH.name)
KINDS = {"contradictions", "files", "grammar", "json", "names", "surfaces", "values"}
MARK = "# expect: "

# Messages on a file as a whole quote nothing of it: there the content distinguishes one fault from another.
ON_WHOLE_FILE = re.compile("is empty|is not a text file|is not valid JSON|sets no entry")


def write_rows(table):
    """Makes the files of a table. JSON has no comments: there the message stands beside the file."""
    for name, text, message in table["ROWS"]:
        is_json = table["FOLDER"] == "json"
        path = ERRORS / table["FOLDER"] / (name + (".json" if is_json else ".prm"))
        if path.exists():
            raise FileExistsError(f"{path.name} is made twice")
        path.parent.mkdir(exist_ok=True)
        head = "" if is_json else "".join(f"{MARK}{line}\n" for line in message.split("\n"))
        path.write_bytes((head + text).encode())
        if is_json:
            path.with_name(path.name + ".expect").write_bytes((message + "\n").encode())


def make_files():
    shutil.copytree(SOURCE, ERRORS, dirs_exist_ok=True, ignore=shutil.ignore_patterns("*.py", "__pycache__"))
    for table in sorted(SOURCE.glob("*.py")):
        write_rows(runpy.run_path(str(table)))


def text_of(path):
    """Any bytes, also those of a file that is no text."""
    return path.read_bytes().decode("utf-8", "surrogateescape")


def bad_files():
    """Paths relative to ERRORS."""
    files = (path.relative_to(ERRORS) for path in sorted(ERRORS.rglob("*")) if path.is_file())
    return [file for file in files if file.suffix != ".expect" and "included" not in file.parts]


def expectation(file):
    """The message that a file expects, with {file}, {folder} and {absolute}, its absolute path."""
    sibling = ERRORS / f"{file}.expect"
    if sibling.exists():
        return text_of(sibling).rstrip("\n")
    lines = []
    for line in re.split("\r?\n", text_of(ERRORS / file)):
        if not line.startswith(MARK):
            break
        lines.append(line[len(MARK):])
    return "\n".join(lines)


def fault(file):
    """The message without the place; messages of two files that differ in nothing else are of the same fault."""
    message = re.sub(r"\{file\}(:\d+)?: ", "", expectation(file))
    return (message, text_of(ERRORS / file) if ON_WHOLE_FILE.search(message) else "")


class BadFileTest(rejection.RejectionTest):
    """The program works in an empty folder, on a copy of tests/errors beside it."""

    def setUp(self):
        super().setUp()
        copy = tempfile.TemporaryDirectory()
        self.addCleanup(copy.cleanup)
        self.errors = pathlib.Path(copy.name)
        shutil.copytree(ERRORS, self.errors, dirs_exist_ok=True)
        before = rejection.content_of(self.errors)
        self.addCleanup(lambda: self.assertEqual(rejection.content_of(self.errors), before, "beside the bad files"))

    def assert_message(self, file, given):
        message = expectation(file).replace("{file}", given).replace("{folder}", str(pathlib.Path(given).parent))
        message = message.replace("{absolute}", str((self.errors / file).parent))  # as the program shows mesh files
        result = self.assert_rejected([given], rejection.WRONG_INPUT, "", errors="surrogateescape")
        self.assertEqual(result.stderr, f"orthocone: {message}\n")

    def test_messages(self):
        for file in bad_files():
            with self.subTest(str(file)):
                self.assert_message(file, os.path.relpath(self.errors / file, self.folder))

    def test_absolute_path(self):
        for kind in sorted(KINDS):
            file = next(file for file in bad_files() if file.parts[0] == kind)
            with self.subTest(str(file)):
                self.assert_message(file, str(self.errors / file))

    def test_every_file_has_an_expectation(self):
        files = bad_files()
        self.assertEqual({file.parts[0] for file in files}, KINDS)
        for file in files:
            with self.subTest(str(file)):
                self.assertRegex(expectation(file), r"\S")
        files_with_siblings = {path.with_suffix("") for path in ERRORS.rglob("*.expect")}
        self.assertLessEqual(files_with_siblings, {ERRORS / file for file in files})

    def test_at_least_a_hundred_distinct_faults(self):
        first = {}
        for file in bad_files():
            with self.subTest(str(file)):
                self.assertEqual(first.setdefault(fault(file), file), file, "both have the same fault")
        self.assertGreaterEqual(len({message for message, _ in first}), 100)

    def test_every_entry_is_tried(self):
        """Each entry has a file with a wrong value."""
        messages = "\n".join(expectation(file) for file in bad_files() if file.parts[0] == "values")
        section = ""
        for line in self.run_program("--defaults").stdout.splitlines():
            if opening := re.fullmatch(r"subsection (.*)", line):
                section = opening[1]
            if entry := re.match(r" +set (.*?) *=", line):
                with self.subTest(f"{section}/{entry[1]}"):
                    self.assertIn(f": {section}/{entry[1]} = ", messages)


if __name__ == "__main__":
    make_files()
    rejection.main()
