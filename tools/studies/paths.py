# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Where things lie: whoever imports this first finds the modules of all studies, and the readers of run folders."""
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path[:0] = [str(folder) for folder in (HERE, HERE / "pictures", HERE / "benchmark", HERE / "peers", HERE.parent / "book",
                                          HERE.parent / "runs", HERE.parent / "rosettes")]
