# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""No entry, option, column, field or exit code of the program without its line in the pages, as the program is today.

Usage: test_reference_pages.py PROGRAM [unittest options]"""
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True  # the source tree stays clean
from program import PROGRAM, ROOT, SMALL, main  # noqa: E402


def printed(option):
    return subprocess.run([PROGRAM, option], cwd=ROOT, capture_output=True, text=True, check=True).stdout


def page(name):
    return (ROOT / name).read_text(encoding="utf-8")


def options_of(text):
    """Long options that a help text lists."""
    return re.findall(r"^  (?:-\w(?:, | \[ ))?--([a-z-]+)", text, re.MULTILINE)


class ReferencePagesTest(unittest.TestCase):
    def test_pages_are_current(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, ROOT / "tools/site/reference_pages.py", "--program", PROGRAM, "--output",
                            folder], check=True)
            for name in ("docs/parameters.md", "docs/results.md", "docs/python.md", "tools/report/defaults.json"):
                made = pathlib.Path(folder) / pathlib.Path(name).name
                self.assertEqual(made.read_text(encoding="utf-8"), page(name), "tools/reference_pages writes it anew")

    def test_every_entry_has_a_row(self):
        """Found in another way than the page is made."""
        entries = re.findall(r"^  set (.+?) *=", printed("--defaults"), re.MULTILINE)
        rows = re.findall(r"^\| \*\*(.+?)\*\* \|", page("docs/parameters.md"), re.MULTILINE)
        self.assertEqual(rows, entries)
        self.assertGreater(len(entries), 60)

    def test_every_column_and_field_of_a_run_has_a_row(self):
        """From the files that a run writes whose friction has memory, so that all columns are there."""
        with tempfile.TemporaryDirectory() as folder:
            run = pathlib.Path(folder) / "run"
            settings = [*SMALL, "Output/Volume fields=1", "Output/Probes=P: 5 0",
                        "Output/Lines=L: 0 0 0 to 0 0 1, 2", "Load program/Legs=0 0 -0.01 : 1",
                        "Load program/Cycles=1", "Friction/Factor=2"]
            subprocess.run([PROGRAM, ROOT / "prm/paper/case_b.prm", "-q", "-o", run,
                            *[f"--set={setting}" for setting in settings]], check=True)
            found = {name.name: name.read_text().splitlines()[0].split(",") for name in run.glob("*.csv")}
            for name in ("contact-0001.vtu", "volume-0001.vtu"):
                data = (run / name).read_bytes().partition(b"<PointData")[2].partition(b"</PointData>")[0]
                found[name] = re.findall(r'<DataArray [^>]*Name="(\w+)"', data.decode("ascii", "replace"))
        self.assertEqual(len(found), 8)
        for name, names in found.items():
            heading = re.sub(r"-0001\.", "-NNNN.", name).replace("probe-P", "probe-NAME").replace("line-L", "line-NAME")
            section = page("docs/results.md").partition(f"\n## {heading}\n")[2].partition("\n## ")[0]
            self.assertEqual(re.findall(r"^\| `(\w+)` \|", section, re.MULTILINE), names, name)

    def test_every_option_is_in_the_manual(self):
        manual = page("docs/manual.md")
        programs = [([PROGRAM], 12)]
        if (solve := pathlib.Path(PROGRAM).parent / "orthocone-solve").exists():
            programs.append(([solve], 7))
        programs += [([sys.executable, ROOT / "tools" / script], 1) for script in ("report.py", "sweeps/sweep.py")]
        for program, least in programs:
            result = subprocess.run([*program, "--help"], capture_output=True, text=True, check=True)
            options = options_of(result.stdout)
            self.assertGreaterEqual(len(options), least, program)
            for option in options:
                self.assertTrue(f"`--{option}" in manual, f"docs/manual.md lacks `--{option}` of {program[-1]}")

    def test_every_exit_code_is_in_the_manual(self):
        codes = re.findall(r"^  (?:\w+) = (\d+)", page("include/orthocone/base/errors.h"), re.MULTILINE)
        self.assertEqual(len(codes), 5)
        for code in codes:
            self.assertRegex(page("docs/manual.md"), rf"(?m)^- {code}: ")
            self.assertRegex(printed("--help"), rf"\b{code} \w")

    def test_every_shipped_scene_is_listed_by_a_short_sentence(self):
        lines = printed("--list").splitlines()
        files = sorted(str(file.relative_to(ROOT)) for file in (ROOT / "prm").rglob("*.prm"))
        self.assertEqual([line.split()[0] for line in lines], files)
        sentences = [line.split(maxsplit=1)[1] for line in lines]
        for sentence in sentences:
            self.assertRegex(sentence, r"^[A-Z].{9,79}$")
        self.assertEqual(len(set(sentences)), len(sentences))


if __name__ == "__main__":
    main()
