# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""docs/parameters.md and docs/results.md: every entry of a parameter file, and every column and field of the results, as
`orthocone --defaults` and `orthocone --columns` have them; docs/python.md: the docstrings of the Python module.
tools/report/defaults.json: the defaults alone, which a report needs to tell changed entries from the others."""
import argparse
import json
import pathlib
import re
import subprocess
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
from python_page import python_page  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PARAMETERS = """# Parameters
This page lists every entry of a parameter file with its default, its meaning and its allowed values. A file needs only the
entries that differ from their defaults. Units are mm, N, MPa and degrees. [manual.md](manual.md), *Parameter files*, explains
how a file is written, and what the entries do together.

`build/orthocone --defaults` prints the same as a commented file. `tools/reference_pages` writes this page, and
`ctest -R run_reference_pages` checks that it is current.
"""
RESULTS = """# Columns and fields
This page lists every column of the tables and every field of the VTU files that a run writes, with its unit and its meaning.
[manual.md](manual.md), *The run folder*, explains the other files, and how to read the numbers. The files `lower-NNNN.vtu` of
a second body have the fields of `volume-NNNN.vtu`. Forces, moments and tractions act from the counterface on the body, if not
stated otherwise, and errors that are called relative have no unit.

`build/orthocone --columns` prints the same as text. `tools/reference_pages` writes this page, and
`ctest -R run_reference_pages` checks that it is current.
"""


def sections(text):
    """[(section, [(entry, default, help, allowed)])] of a complete parameter file."""
    found, comment = [], []
    for line in text.splitlines():
        if match := re.match(r"subsection (.+)", line):
            found.append((match[1], []))
        elif match := re.match(r"  # ?(.*)", line):
            comment.append(match[1])
        elif match := re.match(r"  set (.+?) *= ?(.*)", line):
            meaning, allowed = " ".join(comment).rsplit("Allowed: ", 1)
            found[-1][1].append((match[1], match[2].strip(), meaning.strip(), allowed.rstrip(".")))
            comment = []
    return found


def cell(text):
    """Without what Markdown would take for its own."""
    return re.sub(r"([\\|*_<>])", r"\\\1", text)


def code(text):
    return f"`{text}`".replace("|", "\\|") if text else ""


def parameters_page(text):
    out = PARAMETERS
    for section, entries in sections(text):
        out += f"\n## {section}\n| entry | default | what it is | allowed |\n|---|---|---|---|\n"
        for entry, default, meaning, allowed in entries:
            out += f"| **{entry}** | {code(default)} | {cell(meaning)} | {cell(allowed)} |\n"
    return out


def defaults_file(text):
    return json.dumps({f"{section}/{entry}": default for section, entries in sections(text)
                       for entry, default, _, _ in entries}, indent=0) + "\n"


def results_page(text):
    out, last = RESULTS, None
    for line in text.splitlines():
        file, name, unit, meaning = line.split("\t")
        if file != last:
            kind = "field" if file.endswith(".vtu") else "column"
            out += f"\n## {file}\n| {kind} | unit | what it is |\n|---|---|---|\n"
            last = file
        out += f"| {code(name)} | {unit} | {cell(meaning)} |\n"
    return out


def main():
    parser = argparse.ArgumentParser(prog="tools/reference_pages", description=__doc__)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/orthocone")
    parser.add_argument("--output", metavar="DIR", type=pathlib.Path, help="of all files (docs, and tools/report)")
    options = parser.parse_args()
    docs, report = options.output or ROOT / "docs", options.output or ROOT / "tools/report"
    try:
        for path, option, page in ((docs / "parameters.md", "--defaults", parameters_page),
                                   (docs / "results.md", "--columns", results_page),
                                   (report / "defaults.json", "--defaults", defaults_file)):
            text = subprocess.run([options.program, option], capture_output=True, text=True, check=True).stdout
            path.write_text(page(text), encoding="utf-8")
        (docs / "python.md").write_text(python_page(ROOT / "python/orthocone"), encoding="utf-8")
    except (OSError, subprocess.CalledProcessError) as error:
        sys.exit(f"reference_pages: {error}")


if __name__ == "__main__":
    main()
