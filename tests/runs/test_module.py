# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The Python module: laws and solvers have the properties that mathematics gives them, and bad input is an exception.

Usage: test_module.py PROGRAM [unittest options]"""
import pickle
import signal
import subprocess
import sys
import unittest

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as some
from python_module import BUILT, row_of_nodes

import orthocone
from orthocone import Status, solve

wide = some.floats(-3, 3).map(lambda power: 10**power)
laws = some.tuples(wide, wide)
vectors = some.tuples(*3 * [some.floats(-1e3, 1e3)]).map(np.array)
slips = some.floats(0, 2 * np.pi).map(lambda angle: np.array([np.cos(angle), np.sin(angle)]))
# Friction with which Newton's method need not search long, and every problem has one solution.
mild = some.tuples(some.floats(0.02, 0.4), some.floats(0.02, 0.4))
seeds = some.integers(0, 10**6)
quick = settings(deadline=None, max_examples=40, derandomize=True)
many = settings(deadline=None, max_examples=300, derandomize=True)


class LawTest(unittest.TestCase):
    def assert_small(self, value, scale, precision=1e-12):
        self.assertLessEqual(abs(value), precision * scale)

    @many
    @given(vectors, laws)
    def test_moreau(self, tau, mu):
        """tau is the sum of two orthogonal parts, one in the cone, one in its polar. A cone a thousand times flatter than
        its normal is long is known to that many digits less."""
        inside = orthocone.project(tau, mu)
        rest = tau - inside
        size, steep = np.hypot.reduce(tau), max(1, *mu, *np.reciprocal(mu))
        self.assert_small(inside @ rest, size**2, 1e-13 * steep)
        self.assertLessEqual(orthocone.friction_norm(inside[1:], mu) - inside[0], 1e-13 * steep * size)
        self.assertLessEqual(rest[0] + orthocone.dual_norm(rest[1:], mu), 1e-13 * steep * size)

    @many
    @given(vectors, vectors, laws)
    def test_monotone(self, first, second, mu):
        """A projection is firmly non-expansive."""
        moved = orthocone.project(first, mu) - orthocone.project(second, mu)
        scale = max(np.linalg.norm(first), np.linalg.norm(second))
        self.assertGreaterEqual(moved @ (first - second) - moved @ moved, -1e-10 * scale**2)

    @many
    @given(vectors, laws, wide)
    def test_projection_in_other_units(self, tau, mu, factor):
        self.assert_small(np.linalg.norm(orthocone.project(factor * tau, mu) - factor * orthocone.project(tau, mu)),
                          factor * np.linalg.norm(tau), 1e-11)

    @many
    @given(slips, laws, laws)
    def test_slip_rule_both_ways(self, slip, mu, p):
        """The traction of a slip lies on the friction ellipse, and slips along it."""
        traction = orthocone.sliding_traction(slip, mu, p)
        self.assertAlmostEqual(orthocone.friction_norm(traction, mu), 1, delta=1e-12)
        self.assertLessEqual(traction @ slip, 0)
        direction = orthocone.slip_direction(traction, p)
        self.assert_small(np.linalg.norm(direction / np.linalg.norm(direction) - slip), 1, 1e-10)

    @many
    @given(slips, laws)
    def test_associated_rule_dissipates_most(self, slip, mu):
        """Support function of the friction ellipse."""
        self.assertAlmostEqual(-(orthocone.sliding_traction(slip, mu) @ slip) / orthocone.dual_norm(slip, mu), 1, delta=1e-12)


class SolveTest(unittest.TestCase):
    def assert_near(self, first, second, scale, precision=1e-7):
        self.assertLessEqual(np.abs(first - second).max(), precision * scale)

    @quick
    @given(seeds, mild, laws)
    def test_solution_is_a_fixed_point(self, seed, mu, p):
        W, q = row_of_nodes(6, seed)
        p = np.array(p) ** 0.3 * mu  # slip ellipses up to eight times longer or shorter than friction
        solution = solve(W, q, mu, p)
        r, d = solution.force, solution.displacement
        self.assert_near(d, q + (W @ r.ravel()).reshape(-1, 3), np.abs(q).max(), 1e-12)
        normal_length = p / np.max(p / mu)
        g = orthocone.modified_displacement(d, mu, normal_length)
        self.assert_near(r, orthocone.project(r - 0.5 * g, mu), np.abs(r).max(), 1e-8)
        self.assertTrue((d[solution.status == Status.STICK, 1:] < 1e-8).all())
        self.assertTrue((r[solution.status == Status.OPEN] == 0).all())

    @quick
    @given(seeds, mild)
    def test_scaling_map(self, seed, mu):
        """D = diag(1, mu_x, mu_y) makes the friction ellipse of an associated law a circle of radius 1."""
        W, q = row_of_nodes(6, seed)
        D = np.tile([1, *mu], 6)
        forces = solve(W, q, mu).force
        scaled = solve(D[:, None] * W * D, D * q.ravel(), 1.).force
        self.assert_near(forces.ravel(), D * scaled.ravel(), np.abs(forces).max())

    def assert_isotropic(self, W, q, mu, p, force):
        """In the scale D = diag(1, mu_x, mu_y), C = diag(1, Q^2) forces of any law obey the isotropic, associated one with
        mu = 1 and the unsymmetric W' = D C W D: Coulomb's cone, no penetration, and slip against the force."""
        D, C = np.tile([1, *mu], len(q)), np.tile([1, *(np.divide(p, mu) / np.max(np.divide(p, mu)))**2], len(q))
        r = force.ravel() / D
        u = ((D * C)[:, None] * W * D @ r + D * C * q.ravel()).reshape(-1, 3)
        r = r.reshape(-1, 3)
        slip = np.linalg.norm(u[:, 1:], axis=1)
        length, size = np.abs(q).max(), np.abs(force).max()
        self.assertLessEqual((np.linalg.norm(r[:, 1:], axis=1) - r[:, 0]).max(), 1e-9 * size)
        self.assertGreaterEqual(u[:, 0].min(), -1e-9 * length)
        # The product is a sum of two parts that are never negative: r_n u_n, and what slip dissipates less than r_n |u_t|.
        self.assertLessEqual(np.abs((r * u).sum(axis=1) + r[:, 0] * slip).max(), 2e-9 * size * length)

    @many
    @given(seeds, laws, laws, some.sampled_from(["newton", "gauss-seidel"]))
    def test_any_law_is_solved(self, seed, mu, p, method):
        """Ellipses of all lengths from 0.001 to 1000, whatever one has to do with the other."""
        W, q = row_of_nodes(6, seed)
        self.assert_isotropic(W, q, mu, p, solve(W, q, mu, p, method=method).force)

    @quick
    @given(seeds, laws, laws, some.sampled_from(list(orthocone.methods())))
    def test_a_method_solves_or_says_that_it_does_not(self, seed, mu, p, method):
        W, q = row_of_nodes(6, seed)
        try:
            self.assert_isotropic(W, q, mu, p, solve(W, q, mu, p, method=method, maximum_iterations=1000).force)
        except orthocone.NotConverged as error:
            self.assertNotIn(method, ("newton", "gauss-seidel"))
            self.assertIn(error.solution.report.verdict, ("slow", "rounding", "cycling", "diverged"))

    @quick
    @given(seeds, mild, some.permutations(range(6)))
    def test_order_of_nodes(self, seed, mu, order):
        W, q = row_of_nodes(6, seed)
        places = (3 * np.array(order)[:, None] + range(3)).ravel()
        mus = np.multiply.outer(np.linspace(0.5, 1, 6), mu)
        forces = solve(W, q, mus).force
        self.assert_near(solve(W[np.ix_(places, places)], q[order], mus[order]).force, forces[order], np.abs(forces).max())

    @quick
    @given(seeds, mild, wide, wide, some.sampled_from(list(orthocone.methods())[:2]))
    def test_units(self, seed, mu, force, length, method):
        W, q = row_of_nodes(4, seed)
        one = solve(W, q, mu, (0.2, 0.1), method=method)
        other = solve(length / force * W, length * q, mu, (0.2, 0.1), method=method)
        self.assert_near(other.force / force, one.force, np.abs(one.force).max())
        self.assertEqual(other.status.tolist(), one.status.tolist())

    def test_start_from_the_solution(self):
        W, q = row_of_nodes(8, 1)
        forces = solve(W, q, 0.3).force
        self.assertEqual(solve(W, q, 0.3, start=forces).report.iterations, 0)

    def test_without_friction(self):
        W, q = row_of_nodes(8, 1)
        solution = solve(W, q, 0.)
        self.assertEqual(np.abs(solution.force[:, 1:]).max(), 0)
        self.assertLess(np.abs(solution.force[:, 0] * solution.displacement[:, 0]).max(), 1e-9)

    def test_directions_in_which_nodes_cannot_move(self):
        """The others are solved as if these were not there; W itself stays as it is."""
        W, q = row_of_nodes(4, 1)
        W[2::3], W[:, 2::3], q[:, 2] = 0, 0, 0
        before = W.copy()
        held = solve(W, q, 0.3)
        W[2::3, 2::3] = np.eye(4)
        self.assert_near(held.force, solve(W, q, 0.3).force, np.abs(held.force).max())
        self.assertEqual(np.abs(held.force[:, 2]).max(), 0)
        W[2::3, 2::3] = 0
        np.testing.assert_array_equal(W, before)
        q[1, 2] = 0.1
        with self.assertRaisesRegex(ValueError, "W is zero along y of node 1, .* but slips by 0.1"):
            solve(W, q, 0.3)

    def test_failure_has_what_there_is(self):
        W, q = row_of_nodes(8, 1)
        with self.assertRaisesRegex(orthocone.NotConverged, "uzawa: slow, residual .* after 3 iterations") as caught:
            solve(W, q, 0.3, method="uzawa", maximum_iterations=3)
        self.assertEqual(caught.exception.solution.force.shape, (8, 3))
        # Another process hands it over by pickle, whose default makes exceptions again by their message alone.
        copy = pickle.loads(pickle.dumps(caught.exception))
        self.assertEqual((type(copy), str(copy)), (orthocone.NotConverged, str(caught.exception)))
        np.testing.assert_array_equal(copy.solution.force, caught.exception.solution.force)
        self.assertEqual(caught.exception.solution.report.trace.shape[1], 4)

    def test_signals_stop_a_solution(self):
        """What a handler raises ends the iteration, as Ctrl-C does, and the next problem is solved as ever."""
        W, q = row_of_nodes(250, 1)

        def stop(number, frame):
            raise InterruptedError

        before = signal.signal(signal.SIGALRM, stop)
        self.addCleanup(signal.signal, signal.SIGALRM, before)
        for method in ("uzawa", "gauss-seidel", "newton"):
            signal.setitimer(signal.ITIMER_REAL, 0.3)
            with self.subTest(method), self.assertRaises(InterruptedError):
                while True:  # newton is done before the signal comes
                    solve(W, q, 0.3, method=method, tolerance=1e-30 if method != "newton" else 1e-10,
                          maximum_iterations=10**9, start=np.zeros_like(q))
        self.assertLess(solve(W, q, 0.3).report.residual, 1e-9)

    def test_bad_input(self):
        W, q = row_of_nodes(3, 1)
        holed, tilted = W.copy(), W.copy()
        holed[0, 3], tilted[0, 3] = np.nan, 2 * W[0, 3]
        for words, arguments in (("W has the shape", (W[:8, :8], q, 0.3)), ("W has the shape", (W[:0, :0], q, 0.3)),
                                 ("W has entries", (holed, q, 0.3)), ("W has the entry", (-W, q, 0.3)),
                                 ("W is indefinite", (W - 0.5 * np.ones(W.shape), q, 0.3)),
                                 ("W is not symmetric", (tilted, q, 0.3)), ("q has the shape", (W, q[:2], 0.3)),
                                 ("q has entries", (W, np.inf * q, 0.3)), ("mu has the shape", (W, q, [1, 2, 3])),
                                 ("mu: allowed", (W, q, -0.3)), ("mu: allowed", (W, q, (0.3, 0))),
                                 ("p: allowed", (W, q, 0.3, 0.)), ("p: allowed", (W, q, 0.3, np.nan)),
                                 ("mu is of type str .*: allowed are numbers", (W, q, "much")), ("q has complex", (W, q + 1j, 0.3)),
                                 ("mu has complex", (W, q, 0.3 + 0j)), ("p has complex", (W, q, 0.3, [0.1, 1j])),
                                 ("W has complex", (W + 0j, q, 0.3)), ("q has masked", (W, np.ma.masked_less(q, q.max()), 0.3)),
                                 ("W has masked", (np.ma.masked_equal(W, W[0, 0]), q, 0.3)),
                                 ("q has masked", (W, [np.ma.masked_less(row, q.max()) for row in q], 0.3)),
                                 ("mu has masked", (W, q, [0.3, np.ma.masked])), ("q has complex", (W, [*q[:2], q[2] + 1j], 0.3)),
                                 ("W is of type ndarray with entries of type object", (W.astype(object), q, 0.3)),
                                 ("q is of type list with entries of type <U", (W, q.astype(str).tolist(), 0.3)),
                                 ("mu is of type bool", (W, q, True)), ("p is of type dict", (W, q, 0.3, {})),
                                 ("mu is of type datetime64", (W, q, np.datetime64("2026"))),
                                 ("mu is of type int with entries of type object", (W, q, 10**30)),
                                 ("q has rows of different lengths", (W, [*q[:2].tolist(), [1, 2]], 0.3))):
            with self.subTest(words), self.assertRaisesRegex(ValueError, words):
                solve(*arguments)
        for words, options in (("method = 'best': allowed is newton, ", {"method": "best"}),
                               ("tolerance", {"tolerance": 0}), ("maximum_iterations", {"maximum_iterations": 0}),
                               ("method = \\[\\]", {"method": []}), ("tolerance = 'x'", {"tolerance": "x"}),
                               ("tolerance = None", {"tolerance": None}), ("tolerance = array", {"tolerance": q[0]}),
                               ("maximum_iterations = True", {"maximum_iterations": True}),
                               ("maximum_iterations = inf", {"maximum_iterations": np.inf}),
                               ("start has the shape", {"start": q[:1]})):
            with self.subTest(words), self.assertRaisesRegex(ValueError, words):
                solve(W, q, 0.3, **options)

    def test_rounded_matrix(self):
        """A rigid block whose W another program computed in single precision is solved as its symmetric part is, in either
        order of the entries, and not without a word. More than rounding is refused."""
        x, y = (c.ravel() for c in np.meshgrid([-1, 1], [-1, 0.5]))
        H = np.zeros((12, 6))
        H[0::3, 0], H[0::3, 3], H[0::3, 4] = 1, y, -x
        H[1::3, 1], H[1::3, 4], H[1::3, 5] = 1, -0.4, -y
        H[2::3, 2], H[2::3, 3], H[2::3, 5] = 1, 0.4, x
        W, q = H @ np.diag([1, 1, 1, 3, 3, 2]) @ H.T, H @ [-1, 0.1, 0.05, 0.1, 0.02, 0.1]
        tilted = W + 5e-5 * np.random.default_rng(1).uniform(-1, 1, W.shape)
        for matrix in (tilted, np.asfortranarray(tilted)):
            with self.assertWarnsRegex(UserWarning, "symmetric part"):
                rounded = solve(matrix, q, 0.4)
            self.assertRegex(rounded.report.notes[0], "W is not symmetric: .* symmetric part")
            d = q + ((tilted + tilted.T) / 2) @ rounded.force.ravel()
            np.testing.assert_allclose(rounded.displacement.ravel(), d, atol=1e-12)
            np.testing.assert_allclose(H.T @ rounded.force.ravel(), H.T @ solve(W, q, 0.4).force.ravel(), atol=1e-3)
        self.assertEqual(solve(W, q, 0.4).report.notes, ())
        with self.assertRaisesRegex(ValueError, r"not symmetric: mirror images of nodes .* give \(W \+ W\^T\)/2"):
            solve(W + 0.02 * np.triu(W), q, 0.4)

    def test_matrix_is_not_copied(self):
        """The largest memory of a process that solves, beyond that of a small problem. Newton's methods make a copy in
        single precision, half as large as the matrix."""
        code = """import numpy as np, orthocone, sys
def peak():
    return [int(line.split()[1]) for line in open('/proc/self/status') if line.startswith('VmHWM')][0]
def solve(n):
    W = np.full((3 * n, 3 * n), 1e-3)
    W[np.diag_indices(3 * n)] = 10
    before = peak()
    result = orthocone.solve(W, np.full((n, 3), -1.), 0.3, method=sys.argv[1], tolerance=1e-3)
    return 1024 * (peak() - before) / W.nbytes
solve(10)
print(solve(900))"""
        for method in orthocone.methods():
            with self.subTest(method):
                result = subprocess.run([sys.executable, "-B", "-c", code, method], capture_output=True, text=True, check=False,
                                        env={"PYTHONPATH": str(BUILT), "OPENBLAS_NUM_THREADS": "1"})
                self.assertEqual((result.returncode, result.stderr), (0, ""))
                copies = float(result.stdout)
                self.assertLess(copies, 0.6 if "newton" in method else 0.1)


if __name__ == "__main__":
    del sys.argv[1]
    unittest.main()
