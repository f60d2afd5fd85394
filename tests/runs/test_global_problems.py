# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""orthocone-solve on FCLIB's global problems (M, H, f), and on those of many rigid bodies, whose W is sparse.

Usage: test_global_problems.py PROGRAM [unittest options]"""
import sys
import unittest

import numpy as np
from problem_program import FILE_ERROR, ProblemCase, fclib_files


def wall(n_rows, n_columns):
    """A wall of rigid bricks of 2 x 1 x 1 and mass 1, each on the four or eight corners of the two below. They fall and are
    shaken. Returns the bricks' masses M, H of the contacts (normal, x, y), and the velocities without contact."""
    centres = [(2 * j + i % 2, i) for i in range(n_rows) for j in range(n_columns)]
    contacts = []
    for upper, (x, row) in enumerate(centres):
        for lower, (x_lower, _) in enumerate(centres):
            if row > 0 and lower // n_columns == row - 1 and abs(x - x_lower) < 2:
                contacts += [(lower, upper, place, y) for place in (max(x, x_lower) - 1, min(x, x_lower) + 1) for y in (-.5, .5)]
        if row == 0:
            contacts += [(None, upper, x + side, y) for side in (-1, 1) for y in (-.5, .5)]
    H = np.zeros((6 * len(centres), 3 * len(contacts)))
    for k, (lower, upper, x, y) in enumerate(contacts):
        for body, sign in ((upper, 1), (lower, -1)):
            if body is not None:
                arm = np.array([x - centres[body][0], y, -0.5 * sign])
                for direction, axis in enumerate(np.eye(3)[[2, 0, 1]]):
                    H[6 * body:6 * body + 6, 3 * k + direction] = sign * np.concatenate([axis, np.cross(arm, axis)])
    M = np.diag(np.tile([1, 1, 1, 1 / 6, 5 / 12, 5 / 12], len(centres)))
    v = np.random.default_rng(1).normal(0, 0.003, 6 * len(centres))
    v[2::6] -= 0.01
    return M, H, v


class GlobalTest(ProblemCase):
    def test_global_problems(self):
        """Masses, a stiffness and two constraints, given as M, H, G, f, w and b, are the local problem that they make."""
        random = np.random.default_rng(2)
        M = np.diag(random.uniform(1, 3, 8)) + 0.3 * np.eye(8, k=1) + 0.3 * np.eye(8, k=-1)
        H, G = random.uniform(-1, 1, (8, 6)), random.uniform(-1, 1, (8, 2))
        H[:4, 3:] = 0
        f, w, b, mu = random.uniform(-1, 1, 8), np.array([-1, 0.1, 0.2, -1, 0.2, -0.1]), np.array([0.1, 0.2]), [0.3, 0.5]
        for kind in ("columns", "rows", "triplets"):
            for is_held in (False, True):
                with self.subTest(kind=kind, is_held=is_held):
                    free, moved = np.linalg.solve(M, f), np.linalg.solve(M, H)
                    W, q = H.T @ moved, H.T @ free + w
                    if is_held:
                        S = np.linalg.solve(G.T @ np.linalg.solve(M, G), np.column_stack([G.T @ moved, G.T @ free + b]))
                        W, q = W - moved.T @ G @ S[:, :6], q - moved.T @ G @ S[:, 6]
                    name = f"{kind}-{is_held}"
                    fclib_files.write_global(self.folder / name, M, H, f, w, mu, kind, *([G, b] if is_held else []))
                    self.row(name, "--write", self.folder / f"{name}-local")
                    read = fclib_files.Read(self.folder / f"{name}-local")
                    np.testing.assert_allclose(read.W, W, atol=1e-13)
                    np.testing.assert_allclose(read.q, q, atol=1e-13)
                    self.assertLess(read.error, 1e-8)
                    fclib_files.write_solution(self.folder / name, q + W @ read.r, read.r)
                    row = self.row(name, "--stored", "--tolerance=1e-8")
                    self.assertLess(float(row["stored_u_error"]), 1e-12)
        for name, matrix, expression in (("negative", M - 3 * np.eye(8), "M is not positive definite"),
                                         ("tilted", M + 0.01 * np.eye(8, k=3), "M is not symmetric: entries of rows")):
            fclib_files.write_global(self.folder / name, matrix, H, f, w, mu)
            self.assert_error(self.solve(name), FILE_ERROR, expression)

    def test_wall(self):
        """Rigid bricks: most blocks of W are zero, and W is singular. Impulses take away what lets the bricks fall into each
        other, within their cones."""
        M, H, v = wall(4, 4)
        n = H.shape[1] // 3
        fclib_files.write_global(self.folder / "wall", M, H, M @ v, np.zeros(3 * n), np.full(n, 0.5))
        for method in ("newton", "gauss-seidel"):
            self.row("wall", "--method", method, "--iterations=20000", "--tolerance=1e-8", "--write", self.folder / method)
            r = fclib_files.Read(self.folder / method).r
            u, r = (H.T @ (v + np.linalg.solve(M, H @ r))).reshape(-1, 3), r.reshape(-1, 3)
            size, speed = np.abs(r).max(), np.abs(u).max()
            self.assertGreater(u[:, 0].min(), -1e-6 * speed)
            self.assertLess((np.hypot(r[:, 1], r[:, 2]) - 0.5 * r[:, 0]).max(), 1e-6 * size)
            self.assertLess(np.abs(u[:, 0] * r[:, 0]).max(), 1e-6 * speed * size)


if __name__ == "__main__":
    del sys.argv[1]
    unittest.main()
