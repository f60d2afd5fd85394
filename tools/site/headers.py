# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The public headers for Doxygen. It would take signs of our comments for its own: they are escaped, and `words` between
such marks become code."""
import re

# Those of the components `contact` and `body` that `cmake --install` installs.
LIBRARIES = {
    "contact": ("Contact", "Laws and solvers of contact. They know a body by its compliance only."),
    "surface": ("Surface", "Contact nodes, their axes and compliance, and rigid motions."),
    "body": ("Body", "The elastic body on deal.II: meshes, materials, and what condenses it to its contact nodes."),
    "entries": ("Entries", "Sections and entries of parameter files, the codecs of their values, kinds, and the readers."),
    "base": ("Base", "What all others use: errors, seconds of phases, processes of a run."),
}
COMMENT = re.compile(r"(?:^ *///.*\n)+|///<.*\n", re.M)
MARK = re.compile(r"^ *///<?", re.M)


def names(root, library):
    """The headers of a library, as they are included."""
    folder = root / "include"
    return sorted(str(file.relative_to(folder)) for file in (folder / "orthocone" / library).rglob("*.h"))


def escaped(text):
    """What Doxygen prints as `text`."""
    text = text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
    return re.sub(r"([\\@#%])", r"\\\1", text)


def marked(comment):
    """A comment of a header as Doxygen must read it."""
    parts = MARK.sub("", comment).split("`")
    text = "".join(f"<tt>{escaped(part)}</tt>" if k % 2 else escaped(part) for k, part in enumerate(parts))
    return "".join(mark + line for mark, line in zip(MARK.findall(comment), text.splitlines(keepends=True)))


def write(root, include):
    """Copies of all headers to the folder `include`."""
    for library in LIBRARIES:
        for name in names(root, library):
            text = (root / "include" / name).read_text(encoding="utf-8")
            (include / name).parent.mkdir(parents=True, exist_ok=True)
            (include / name).write_text(COMMENT.sub(lambda match: marked(match[0]), text), encoding="utf-8")
