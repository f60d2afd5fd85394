# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Files have at most 300 lines, functions 40, a folder a quarter of the code; headers and sources mirror each other."""
import collections
import pathlib
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
MOST_LINES, MOST_OF_FUNCTION, MOST_OF_FOLDER = 300, 40, 0.25


def files(*folders):
    return [path for folder in folders for path in sorted((ROOT / folder).rglob("*")) if path.suffix in (".cc", ".h")]


def bodies(path):
    """Blocks between braces of their own at the left margin: functions, classes and structs. Yields (line, length)."""
    opened = None
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if line == "{":
            opened = number
        elif line.startswith("}") and opened:
            if line == "}":
                yield opened, number - opened + 1
            opened = None


class SizeTest(unittest.TestCase):
    def test_files(self):
        for path in files("source", "include", "tests", "examples"):
            with self.subTest(path.relative_to(ROOT)):
                self.assertLessEqual(len(path.read_text(encoding="utf-8").splitlines()), MOST_LINES)

    def test_functions(self):
        found = 0
        for path in files("source", "tests", "examples"):
            for line, length in bodies(path):
                found += 1
                with self.subTest(f"{path.relative_to(ROOT)}:{line}"):
                    self.assertLessEqual(length, MOST_OF_FUNCTION)
        self.assertGreater(found, 1000)

    def test_folders(self):
        lines = collections.Counter()
        for path in files("source", "include/orthocone"):
            below = path.relative_to(ROOT / ("source" if (ROOT / "source") in path.parents else "include/orthocone"))
            lines[below.parts[0]] += len(path.read_text(encoding="utf-8").splitlines())
        for folder, count in lines.items():
            with self.subTest(folder):
                self.assertLessEqual(count, MOST_OF_FOLDER * sum(lines.values()))


if __name__ == "__main__":
    unittest.main()
