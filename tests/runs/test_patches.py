# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What docs/extending.md promises: its table is that of tests/examples, and each patch there applies to this tree, touches as
few existing files as the table says, and compiles.

Usage: test_patches.py PROGRAM [unittest options]"""
import json
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
EXAMPLES = ROOT / "tests/examples"
PATCHES = sorted((EXAMPLES / "patches").glob("*.patch"))
BUILD = pathlib.Path(sys.argv.pop(1)).resolve().parent
MOST_FILES = 3


def files(patch):
    """The files of a patch that are there before it, and those that are not."""
    old, new = [], []
    for part in re.split(r"^diff --git ", patch.read_text(encoding="utf-8"), flags=re.MULTILINE)[1:]:
        (new if re.search(r"^new file mode", part, re.MULTILINE) else old).append(re.match(r"a/(\S+)", part)[1])
    return old, new


def rows():
    """What changes, the examples that are named, and the number of existing files."""
    page = (ROOT / "docs/extending.md").read_text(encoding="utf-8")
    for line in page.splitlines():
        cells = [cell.strip() for cell in line.split("|")[1:-1]]
        if len(cells) == 4 and re.match(r"\d+\b", cells[2]):
            yield cells[0], re.findall(r"\]\(\.\./tests/examples/([^)]+)\)", cells[1]), int(re.match(r"\d+", cells[2])[0])


class PatchTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = pathlib.Path(temporary.name)
        cls.commands = json.loads((BUILD / "compile_commands.json").read_text(encoding="utf-8"))

    def tree(self, name):
        tree = self.folder / name
        for folder in ("source", "include"):
            shutil.copytree(ROOT / folder, tree / folder)
        return tree

    def command(self, tree, source):
        """The compiler's command of another source of the same library, for this one and with the headers of its tree."""
        library = f"/orthocone_{pathlib.Path(source).parts[1]}.dir/"
        words = next(words for words in (shlex.split(entry["command"]) for entry in self.commands)
                     if any(library in word for word in words) and "-o" in words)
        words = words[:words.index("-o")]
        return [words[0], f"-I{tree / 'include'}", *words[1:], "-Werror", "-fsyntax-only", str(tree / source)]

    def test_each_patch_applies_and_compiles(self):
        self.assertGreater(len(PATCHES), 4)
        for patch in PATCHES:
            with self.subTest(patch.stem):
                tree = self.tree(patch.stem)
                applied = subprocess.run(["git", "apply", str(patch)], cwd=tree, capture_output=True, text=True, check=False)
                self.assertEqual((applied.returncode, applied.stderr), (0, ""))
                old, new = files(patch)
                self.assertLessEqual(len(old), MOST_FILES)
                for source in (name for name in old + new if name.endswith(".cc")):
                    self.assertNotEqual((tree / source).read_text(encoding="utf-8"),
                                        (ROOT / source).read_text(encoding="utf-8") if (ROOT / source).exists() else "")
                    made = subprocess.run(self.command(tree, source), cwd=BUILD, capture_output=True, text=True, check=False)
                    self.assertEqual(made.returncode, 0, f"{source}\n{made.stderr}")

    def test_a_patch_that_does_not_compile_is_seen(self):
        tree = self.tree("broken")
        (tree / "source/scene/legs.cc").write_text("#include <orthocone/scene/legs.h>\nint f() { return none; }\n",
                                                   encoding="utf-8")
        made = subprocess.run(self.command(tree, "source/scene/legs.cc"), cwd=BUILD, capture_output=True, text=True, check=False)
        self.assertNotEqual(made.returncode, 0)
        self.assertIn("none", made.stderr)

    def test_table_names_the_examples_and_counts_their_files(self):
        named = []
        for change, examples, number in rows():
            with self.subTest(change):
                self.assertGreater(len(examples), 0)
                self.assertLessEqual(number, MOST_FILES)
                touched = [len(files(EXAMPLES / example)[0]) for example in examples if example.endswith(".patch")]
                self.assertEqual(max(touched, default=0), number)
                named += examples
        there = [str(path.relative_to(EXAMPLES)) for path in [*EXAMPLES.glob("*.cc"), *(EXAMPLES / "outside").glob("*.cc"), *PATCHES]]
        self.assertEqual(sorted(named), sorted(there))


if __name__ == "__main__":
    unittest.main()
