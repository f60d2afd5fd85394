# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Prints CHANGELOG.md as the changelog of a Debian package: debian_changelog.py CHANGELOG.md VERSION MAINTAINER

What is not released yet is in the package of the version before, so it stands in the entry of that version."""
import datetime
import pathlib
import re
import sys
import textwrap

VERSION = re.compile(r"^## \[([^\]]+)\](?: - (\d{4}-\d\d-\d\d))?\n", re.M)


def plain(text):
    """Markdown without its marks."""
    return re.sub(r"\[([^\]]+)\]\([^)]+\)", r"\1", " ".join(text.split())).replace("`", "").replace("**", "")


def lines(section):
    """The paragraphs and items of a version, each of them an item, below their headings."""
    for block in re.split(r"\n(?=- |\n)", re.sub(r"^(#.*)$", r"\n\1\n", section, flags=re.M)):
        text = plain(block.strip().lstrip("#-"))
        if block.strip().startswith("#") or text.endswith(":"):
            yield f"  [ {text.strip(': ')} ]"
        elif text:
            yield textwrap.fill(text.strip(), 78, initial_indent="  * ", subsequent_indent="    ", break_on_hyphens=False)


def main():
    file, version, maintainer = sys.argv[1:]
    parts = VERSION.split(pathlib.Path(file).read_text(encoding="utf-8"))[1:]
    found = list(zip(parts[0::3], parts[1::3], parts[2::3]))  # names, dates, texts
    above = []
    for name, date, text in found:
        if date is None:
            above += [f"  [ After {version} ]", *lines(text), ""]
            continue
        day = datetime.date.fromisoformat(date).strftime("%a, %d %b %Y 00:00:00 +0000")
        entry = "\n".join([*above, *lines(text)])
        print(f"orthocone ({name}) unstable; urgency=medium\n\n{entry}\n\n -- {maintainer}  {day}\n")
        above = []


if __name__ == "__main__":
    main()
