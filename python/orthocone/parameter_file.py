# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What a parameter file sets. Only the program judges it, so this passes over what it does not understand."""
import json
import os
import pathlib
import re

from .outside import BadFile, text_of

_MOST_NESTED = 20  # includes, as in the program


def entries_of(path):
    """{"Section/Entry": text} of a parameter file and of the files that it includes. Raises OSError and ValueError for files
    that cannot be read."""
    path = pathlib.Path(path)
    text = text_of(path, errors="surrogateescape")
    if path.suffix.lower() != ".json":
        return entries_of_text(text, path.parent)
    try:
        sections = json.loads(text)
        return {f"{section}/{entry}": value if isinstance(value, str) else json.dumps(value)
                for section, entries in sections.items() for entry, value in entries.items()}
    except (ValueError, AttributeError, RecursionError) as error:
        raise BadFile(f"{path}: is no JSON of sections and their entries") from error


def entries_of_text(text, folder):
    """The same of a text, whose included files lie in `folder`."""
    entries, section = {}, ""
    for line in _statements(text, pathlib.Path(folder), 0):
        if match := re.fullmatch(r"subsection +(.+)", line):
            section = match[1]
        elif match := re.fullmatch(r"set +(.+?) *=(.*)", line):
            entries[f"{section}/{match[1]}"] = match[2].strip()
    return entries


def _statements(text, folder, depth):
    """Lines without comments and blanks at their ends; those of included files in their places."""
    if depth > _MOST_NESTED:
        raise BadFile(f"{folder}: includes are nested more than {_MOST_NESTED} deep")
    text = re.sub(r"\r\n?", "\n", text).replace("\t", " ")
    for line in re.sub(r" *\\ *\n *", " ", text).split("\n"):
        line = line.partition("#")[0].strip()
        if match := re.fullmatch(r"include +(.+)", line):
            file = folder / match[1]
            yield from _statements(text_of(file, errors="surrogateescape"), file.parent, depth + 1)
        elif line:
            yield line


def with_whole_paths(text, folder, path_entries):
    """The text for a file in any folder: the files that it includes or that entries name are those of `folder`."""
    names = "|".join(sorted({re.escape(name.rpartition("/")[2]) for name in path_entries})) or "(?!)"
    pattern = re.compile(rf"^([ \t]*(?:include[ \t]+|set[ \t]+(?:{names})[ \t]*=[ \t]*))([^\s#][^#\r\n]*?)(?=[ \t]*(?:#|\r?$))",
                         re.MULTILINE)
    return pattern.sub(lambda match: match[1] + os.path.abspath(os.path.join(folder, match[2])), text)
