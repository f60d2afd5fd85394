# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Ten nodes in a row are pressed on a plane and pushed along both axes of friction: examples/library/ten_nodes.cc again."""
import numpy as np
import orthocone

places = np.arange(10)
near = np.exp(-0.5 * np.abs(np.subtract.outer(places, places)))
W = np.kron(near, 1e-5 * np.diag([1, 1.2, 1.2]))  # mm/N
q = np.array([-0.01, 0, 0]) + np.outer(places, [0, 0.0005, 0.0003])  # mm
solution = orthocone.solve(W, q, mu=(0.30, 0.15), p=(0.05, 0.20))
for force, status in zip(solution.force, solution.status):
    print(*force, status)
