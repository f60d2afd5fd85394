# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""docs/parameters.md: every entry of a parameter file, as `orthocone --defaults` has it."""
import argparse
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
HEAD = """# Parameters
Every entry of a parameter file with its default, as `build/orthocone --defaults` prints them.
`tools/parameters_page` writes this page, and `ctest -R run_parameters_page` checks that it is current.
A file needs only the entries that differ from their defaults. Units are mm, N, MPa and degrees.
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


def page(text):
    out = HEAD
    for section, entries in sections(text):
        out += f"\n## {section}\n| entry | default | what it is | allowed |\n|---|---|---|---|\n"
        for entry, default, meaning, allowed in entries:
            out += f"| **{entry}** | {code(default)} | {cell(meaning)} | {cell(allowed)} |\n"
    return out


def main():
    parser = argparse.ArgumentParser(prog="tools/parameters_page", description=__doc__)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/orthocone")
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "docs/parameters.md")
    options = parser.parse_args()
    try:
        defaults = subprocess.run([options.program, "--defaults"], capture_output=True, text=True, check=True).stdout
        options.output.write_text(page(defaults), encoding="utf-8")
    except (OSError, subprocess.CalledProcessError) as error:
        sys.exit(f"parameters_page: {error}")


if __name__ == "__main__":
    main()
