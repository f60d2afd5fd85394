# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The Python module under test, and problems for it."""
import pathlib
import sys

import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
BUILT = pathlib.Path(sys.argv[1]).resolve().parent / "python"
sys.path.insert(0, str(BUILT))
import orthocone  # noqa: E402, F401


def row_of_nodes(n, seed):
    """W and q of n nodes that feel each other the less the farther they are; pressed and pushed to all sides."""
    random = np.random.default_rng(seed)
    near = np.exp(-0.7 * np.abs(np.subtract.outer(np.arange(n), np.arange(n))))
    block = np.array([[1, 0.1, -0.05], [0.1, 1.3, 0.1], [-0.05, 0.1, 1.2]])
    return np.kron(near, block), random.uniform([-1, -0.4, -0.4], [0.3, 0.4, 0.4], (n, 3))
