# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What the tests of orthocone-solve share: problems, and a test case that runs the program in a folder of its own."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent.parent / "tools/studies/peers"))
import fclib_files  # noqa: E402

SOLVE = pathlib.Path(sys.argv[1]).resolve().parent / "orthocone-solve"
DONE, WRONG_INPUT, UNSOLVED, FILE_ERROR = 0, 2, 3, 4


def row_of_nodes(n):
    """W and q of n nodes that feel each other; pressed and pushed to all sides, some lifted."""
    near = np.exp(-0.7 * np.abs(np.subtract.outer(np.arange(n), np.arange(n))))
    block = np.array([[1, 0.1, -0.05], [0.1, 1.3, 0.1], [-0.05, 0.1, 1.2]])
    return np.kron(near, block), np.random.default_rng(1).uniform([-1, -0.4, -0.4], [0.3, 0.4, 0.4], (n, 3)).ravel()


def rigid_block(n):
    """A rigid block of mass 1 on n x n contacts, many more than its six degrees of freedom: W has rank 6. It falls, slides
    and turns."""
    x, y = (c.ravel() for c in np.meshgrid(*2 * [np.linspace(-1, 1, n)]))
    H = np.zeros((3 * n * n, 6))  # velocities (normal, x, y) by (v_x, v_y, v_z, turns about x, y, z)
    H[0::3, 2], H[0::3, 3], H[0::3, 4] = 1, y, -x
    H[1::3, 0], H[1::3, 4], H[1::3, 5] = 1, 0.5 * -1, -y
    H[2::3, 1], H[2::3, 3], H[2::3, 5] = 1, 0.5, x
    W = H @ np.diag([1, 1, 1, 3, 3, 2]) @ H.T
    return W, H @ [0.3, 0.1, -1, 0.1, 0.05, 0.2]


class ProblemCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        if fclib_files.library() is None:
            self.skipTest("FCLIB is not there")

    def solve(self, name, *options):
        return subprocess.run([SOLVE, self.folder / name, *options], text=True, capture_output=True, timeout=120, check=False)

    def row(self, name, *options, code=DONE):
        result = self.solve(name, "--csv", *options)
        self.assertEqual((result.returncode, result.stderr), (code, ""))
        names, values = result.stdout.splitlines()
        return dict(zip(names.split(","), values.split(",")))

    def assert_error(self, result, code, expression):
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertRegex(result.stderr, rf"\Aorthocone-solve: .*{expression}.*\n\Z")
        self.assertEqual(result.stdout, "")
