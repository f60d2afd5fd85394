# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The reader of run folders of the Python module, for the tools: it needs no compiled part, and here its tables are arrays,
whatever is installed."""
import functools
import pathlib
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent.parent / "python"))
from orthocone.outside import (  # noqa: E402, F401
    BadFile, check_ordinary, content_of, object_of, one_line, rows_of, text_of, write_whole)
from orthocone.run_folder import OPEN, SLIP, STICK, ContactFile, Run, lattice_of, read_csv  # noqa: E402, F401
from orthocone.vtu import Vtu  # noqa: E402, F401

RunFolder = functools.partial(Run, pandas=False)
