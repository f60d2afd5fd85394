# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""tools/sweep with names, scenes and folders that nobody would give on purpose: it runs, or says in a line why it does not.

Usage: test_sweep_inputs.py PROGRAM [unittest options]"""
import os
import subprocess
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
from program import PROGRAM, ROOT, SCENE, RunTest, main  # noqa: E402

SWEEP = ROOT / "tools/sweeps/sweep.py"
DEGREES = ("--vary", "Mesh/Degree=1,2")


class SweepInputTest(RunTest):
    def setUp(self):
        super().setUp()
        (self.folder / "s.prm").write_text(SCENE)

    def sweep(self, *words, file="s.prm", code=0):
        result = subprocess.run(["/usr/bin/python3", SWEEP, file, "--program", PROGRAM, *words], capture_output=True, text=True,
                                errors="surrogateescape", check=False, cwd=self.folder, timeout=120)
        self.assertEqual(result.returncode, code, result.stderr)
        return result

    def assert_refused(self, says, *words, code=2, **options):
        with self.subTest(says):
            self.assertRegex(self.sweep(*words, code=code, **options).stderr, rf"^sweep: .*{says}.*\n$")

    def test_words_that_are_refused(self):
        other = os.fsencode(self.folder) + b"/s\xff.prm"
        with open(other, "w", encoding="ascii") as file:
            file.write(SCENE)
        self.assert_refused(r"'s\\udcff\.prm' is no UTF-8: allowed are words and names", *DEGREES, file=b"s\xff.prm")
        self.assert_refused(r"'o\\udcff' is no UTF-8", *DEGREES, "--output", b"o\xff")
        self.assert_refused("makes names of folders of 302 bytes: allowed are 255", "--vary", f"a={'x' * 300},2", "--set", "{a}")
        self.assert_refused("the name has 4001 bytes and 2001 parts", *DEGREES, "--output", "a/" * 2000 + "b")
        self.assert_refused("jobs = 100000000: allowed is a whole number from 1 to 400", *DEGREES, "--jobs", "100000000")
        self.assert_refused("FIRST:LAST:NUMBER with two numbers", "--vary", "a=-1e308:1e308:3", "--set", "{a}")
        self.assert_refused("nothing: is no program", *DEGREES, "--program", "nothing")
        self.assert_refused("unrecognized arguments: --nope; '--help' explains", *DEGREES, "--nope")
        self.assertFalse((self.folder / "output").exists())

    def test_files_that_cannot_be_read_or_replaced(self):
        with open(self.folder / "s.json", "w", encoding="ascii") as file:
            file.write("[" * 100000)
        self.assertIn("exit code 2: orthocone: s.json", self.sweep(*DEGREES, file="s.json", code=3).stderr)
        with open(self.folder / "large.prm", "wb") as file:
            file.truncate(10**10)
        self.assert_refused("large.prm: has 10000000000 bytes; allowed are at most", *DEGREES, file="large.prm")
        self.sweep(*DEGREES, "--output", "study")
        for name in ("sweep.csv", "sweep.html"):
            file = self.folder / "study" / name
            for make in (os.mkfifo, os.mkdir):
                file.unlink()
                make(file)
                self.assert_refused(f"{name}: is no ordinary file, and stays as it is", *DEGREES, "--output", "study")
            os.rmdir(file)

    def test_scenes_that_are_no_text_run(self):
        (self.folder / "s.prm").write_bytes(SCENE.encode() + b"# \xff\xfe\n")
        self.assertEqual(self.sweep(*DEGREES).stderr, "")

    def test_includes_that_multiply(self):
        """500 times 500 lines that name two files: each is read once."""
        for name, included in (("s", "a"), ("a", "b"), ("b", "c")):
            (self.folder / f"{name}.prm").write_text(f"include {included}.prm\n" * 500)
        (self.folder / "c.prm").write_text(SCENE)
        self.assertIn("exit code 2: orthocone: ", self.sweep(*DEGREES, code=3).stderr)

    def test_names_with_signs(self):
        """Mathematics of matplotlib, and elements of HTML."""
        (self.folder / "$s$<b>.prm").write_text(SCENE)
        self.assertEqual(self.sweep(*DEGREES, "--vary", "$x$=0.1,0.2", "--set", "Friction/Coefficients={$x$}, 0.1",
                                    file="$s$<b>.prm").stderr, "")
        self.assertEqual(self.sweep("--vary", r"$\frac$=0.1,0.2", "--set", r"Friction/Coefficients={$\frac$}, 0.1").stderr, "")
        self.assertNotIn("<b>", (self.folder / "output/sweep-$s$<b>/sweep.html").read_text(encoding="utf-8"))


if __name__ == "__main__":
    main()
