# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The pages for who has installed a package and has no source tree: their commands are those of the package.

What stands between `<!-- source tree -->` and `<!-- end source tree -->` is left out, and installed.md takes the place of the
first such part of README.md. Pages for who changes the program stay as they are, because that takes the source tree."""
import pathlib
import re

HERE = pathlib.Path(__file__).resolve().parent
OF_SOURCES = ("CONTRIBUTING", "CHANGELOG", "docs/architecture", "docs/extending")
ONLY_SOURCES = re.compile(r"<!-- source tree -->\n?.*?<!-- end source tree -->\n?", re.S)
MODULE = re.compile(r'^export PYTHONPATH="\$PWD/build/python".*\n', re.M)

# What differs between the packages: where they have their files, and the Python that has their module.
PACKAGES = {
    "deb": {"FOLDER": "/usr", "PYTHON": "/usr/bin/python3", "MPIRUN": "mpirun",
            "WHERE": "The package `orthocone` of this system brought these pages."},
    "portable": {"FOLDER": "$ORTHOCONE_HOME", "PYTHON": "orthocone-python", "MPIRUN": "orthocone-mpirun",
                 "WHERE": "These pages are of the folder that was unpacked. `$ORTHOCONE_HOME` stands for its path, and its `bin` is in the "
                          "`PATH`: `export ORTHOCONE_HOME=FOLDER PATH=\"FOLDER/bin:$PATH\"`."},
}
COMMANDS = (
    (r"\./run (?=\S)", "orthocone "),
    (r"\bbuild/orthocone", "orthocone"),
    (r"\btools/report\.py", "orthocone-report"),
    (r"\btools/(sweep|import|rosette|fatigue|identify|topography)\b(?![/.])", r"orthocone-\1"),
    (r"\btools/wear_profile\b(?!\.)", "orthocone-wear-profile"),
    (r"\btools/fretting_map\b(?!\.)", "orthocone-fretting-map"),
    (r"\btools/paraview/", "@FOLDER@/share/orthocone/tools/paraview/"),
    (r"\bmpirun(?= -n)", "@MPIRUN@"),
    (r"/usr/bin/python3", "@PYTHON@"),
)


def filled(text, package):
    for name, value in PACKAGES[package].items():
        text = text.replace(f"@{name}@", value)
    return text


def page(name, text, package):
    """A page of the repository as the package has it."""
    if name in OF_SOURCES:
        return text
    if name == "README":
        text, found = ONLY_SOURCES.subn(lambda _: (HERE / "installed.md").read_text(encoding="utf-8"), text, count=1)
        if not found:
            raise ValueError("README.md: no part of it is marked as one on the source tree")
    text = MODULE.sub("", ONLY_SOURCES.sub("", text))
    for before, after in COMMANDS:
        text = re.sub(before, after, text)
    return filled(text, package)
