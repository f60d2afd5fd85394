# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""A run of the paper's case B in a scratch folder, and the command that makes a page of it."""
import pathlib
import subprocess
import sys
import tempfile

from program import PROGRAM, ROOT

REPORT = ROOT / "tools/report.py"
CASE_B = ROOT / "prm/paper/case_b.prm"
SCRATCH = tempfile.TemporaryDirectory()
COARSE = ["Mesh/Core cells=2", "Mesh/Layers=1", "Mesh/Degree=1", "Output/Volume fields=0"]


def run(name, *settings, code=0, file=CASE_B):
    folder = pathlib.Path(SCRATCH.name) / name
    folder.parent.mkdir(exist_ok=True)
    words = [f"--set={setting}" for setting in settings]
    done = subprocess.run([PROGRAM, file, "--quiet", "--output", folder, *words], capture_output=True, timeout=300,
                          check=False)
    assert done.returncode == code, done.stderr
    return folder


def report(*arguments):
    return subprocess.run([sys.executable, REPORT, *arguments], capture_output=True, text=True, timeout=120, check=False,
                          errors="surrogateescape")
