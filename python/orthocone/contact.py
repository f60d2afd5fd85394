# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Laws and solvers of contact on NumPy arrays. Source of the law: Feng, Hjiaj, de Saxce, Mroz, Int. J. Non-Linear Mech. 41
(2006) 936-948; docs/theory.md, section 1.

Everywhere mu are the semi-axes of the friction ellipse, without units: a number, (2,) or (n, 2) for n nodes; 0 in both
directions is no friction. p are the semi-axes of the slip ellipse, in the same shapes; only their ratio matters. None is
p = mu, the associated slip rule. Arrays that are no numbers, or have another shape, raise ValueError."""
import dataclasses
import enum
import warnings

import numpy as np

from . import _contact


class Status(enum.IntEnum):
    """The status of a node; the numbers are those of the field `status` of a run."""
    OPEN = 0
    STICK = 1
    SLIP = 2


@dataclasses.dataclass(frozen=True)
class Report:
    """A report on a solution, computed from its forces alone.

    converged: whether the residual is within the tolerance, and the forces have a bound. iterations: sweeps and steps of
    the solver. residual: norm of the natural map, relative to the forces. worst_node: the node with the largest part of the
    residual. verdict: how the solver ended: converged, slow, rounding, cycling, diverged or several. law_errors:
    {penetration, complementarity, friction_cone, slip_rule: number}, relative errors of the law in its own terms. trace:
    (k, 4), a row for each residual that the solver has evaluated: iterations, residual, norm of the forces (N), seconds.
    notes: sentences that say how much rounding in W was tolerated."""
    converged: bool
    iterations: int
    residual: float
    worst_node: int
    verdict: str
    law_errors: dict
    trace: np.ndarray
    notes: tuple = ()


@dataclasses.dataclass(frozen=True)
class Solution:
    """Forces and displacements of n nodes.

    force: (n, 3), N. displacement: (n, 3), mm, d = q + W r. status: (n,), numbers of Status. report: Report."""
    force: np.ndarray
    displacement: np.ndarray
    status: np.ndarray
    report: Report


class NotConverged(RuntimeError):
    """Raised when a solver does not reach the tolerance. `solution` is its last state, a Solution."""

    def __init__(self, message, solution):
        super().__init__(message)
        self.solution = solution

    def __reduce__(self):  # by both arguments, or another process cannot make it again, and a pool waits for ever
        return type(self), (self.args[0], self.solution)


def methods():
    """The contact methods, {word: what it does}; the first one is the recommended one (docs/theory.md, section 3)."""
    return _contact.methods()


def solve(W, q, mu, p=None, *, method="newton", tolerance=1e-10, maximum_iterations=5000, start=None):
    """Forces r (N) and displacements d = q + W r (mm) of n nodes that obey the law of contact and friction.

    W: (3 n, 3 n), mm/N, symmetric, with r . W r >= 0 for all forces r. Rows and columns of zeros are directions in which a
    node cannot move. q: (n, 3) or (3 n,), mm, the gap and slip that the nodes would have without forces. mu: a number, (2,)
    or (n, 2), without units, the semi-axes of the friction ellipse. p: a number, (2,) or (n, 2), without units, the
    semi-axes of the slip ellipse; None is p = mu. method: a word of methods(). tolerance: the bound of
    Report.residual. maximum_iterations: the bound of sweeps and steps together. start: (n, 3) or (3 n,), N, the forces to
    start from.

    If rounding has left W a little unsymmetric or indefinite, as single precision does, the symmetric part of W is taken, and
    Report.notes and a warning say so. If W is singular, forces may not exist, and need not be unique (docs/manual.md,
    Problems of FCLIB, says what is checked and promised).

    W is used in place if it is contiguous and float64. Some copies are still made: `newton` and `plain-newton` copy W in
    single precision, or in 16 bits where it is large, for their linear systems; up to 200 nodes a factorization of a copy
    checks W before all else; and a W with directions in which nodes cannot move is copied, too.

    Returns a Solution. Raises NotConverged, and ValueError for arguments of another form. The methods are explained in
    docs/theory.md, section 3."""
    W = _matrix(W)
    n = W.shape[0] // 3
    q = _rows(q, 3, "q", n)
    start = np.zeros((n, 3)) if start is None else _rows(start, 3, "start", n)
    if not isinstance(method, str) or method not in methods():
        raise ValueError(f"method = {method!r}: allowed is {', '.join(methods())}")
    tolerance = float(_scalar(tolerance, "tolerance", "0 < tolerance < 1", lambda value: 0 < value < 1))
    _scalar(maximum_iterations, "maximum_iterations", "a whole number > 0 and < 2^32",
            lambda value: 1 <= value < 2**32 and value == int(value))
    force, displacement, status, report = _contact.solve(W, q, _laws(mu, p, n), start, method, tolerance,
                                                         int(maximum_iterations))
    solution = Solution(force, displacement, status[:, 0].astype(int), Report(**report))
    for note in solution.report.notes:
        warnings.warn(note, stacklevel=2)
    if not solution.report.converged:
        raise NotConverged(f"{method}: {solution.report.verdict}, residual {solution.report.residual:.2g} after "
                           f"{solution.report.iterations} iterations, tolerance {tolerance:g}", solution)
    return solution


def project(force, mu):
    """The nearest points of the friction cone ||r_t||_m <= r_n.

    force: (n, 3) or (3,), N. mu: a number, (2,) or (n, 2), without units. Returns (n, 3) or (3,), N."""
    return _of_nodes(_contact.project, force, 3, "force", mu, None)


def modified_displacement(displacement, mu, p=None):
    """G(d) = (d_n + ||Q^2 d_t||*_m, Q^2 d_t) with Q^2 = (p/mu)^2. The law is r = project(r - rho G(d)) for any rho > 0, up
    to the length of p.

    displacement: (n, 3) or (3,), mm, the gap, and the slip since the last step. mu: a number, (2,) or (n, 2), without units.
    p: a number, (2,) or (n, 2), without units; None is p = mu. Returns (n, 3) or (3,), mm."""
    return _of_nodes(_contact.modified_displacement, displacement, 3, "displacement", mu, p)


def friction_norm(force, mu):
    """||r_t||_m = sqrt((r_x/mu_x)^2 + (r_y/mu_y)^2): the normal force under which a node with this
    tangential force just slips.

    force: (n, 2) or (2,), N. mu: a number, (2,) or (n, 2), without units, > 0. Returns (n,) or a number, N."""
    return _of_nodes(_contact.friction_norm, force, 2, "force", mu, None)[..., 0]


def dual_norm(slip, mu):
    """||v_t||*_m = sqrt((mu_x v_x)^2 + (mu_y v_y)^2): the energy that an associated slip dissipates per unit of
    normal force.

    slip: (n, 2) or (2,), mm. mu: a number, (2,) or (n, 2), without units. Returns (n,) or a number, mm."""
    return _of_nodes(_contact.dual_norm, slip, 2, "slip", mu, None)[..., 0]


def slip_direction(force, p):
    """The direction in which a node slips under a tangential force, -(r_x/p_x^2, r_y/p_y^2), not normalized.

    force: (n, 2) or (2,), N. p: a number, (2,) or (n, 2), without units. Returns (n, 2) or (2,), N: only the direction
    counts."""
    return _of_nodes(_contact.slip_direction, force, 2, "force", 1., p)


def sliding_traction(slip, mu, p=None):
    """The tangential force on the body per unit of normal force in steady slip along `slip`.

    slip: (n, 2) or (2,), mm, not zero. mu: a number, (2,) or (n, 2), without units. p: a number, (2,) or (n, 2), without
    units; None is p = mu. Returns (n, 2) or (2,), without units."""
    return _of_nodes(_contact.sliding_traction, slip, 2, "slip", mu, p)


def _of_nodes(function, values, n_columns, name, mu, p):
    values = _real(values, name)
    rows = _rows(values, n_columns, name)
    result = function(rows, _laws(mu, p, len(rows)))
    return result[0] if values.ndim == 1 and len(result) else result


def _has_mask(values, depth=3):
    """Also within lists of arrays."""
    if depth and isinstance(values, (list, tuple)):
        return any(_has_mask(row, depth - 1) for row in values)
    return isinstance(values, np.ma.MaskedArray) and np.ma.is_masked(values)


def _scalar(value, name, allowed, is_allowed):
    """A number, for which is_allowed() holds."""
    if np.ndim(value) or np.asarray(value).dtype.kind not in "iuf" or not is_allowed(value):
        raise ValueError(f"{name} = {value!r}: allowed is {allowed}")
    return value


def _real(values, name):
    """An array of real numbers, all of which count. NumPy would drop imaginary parts and masks without an error, also those of
    arrays in a list, and would take words, truth values and dates for numbers."""
    if _has_mask(values):
        raise ValueError(f"{name} has masked entries: allowed are numbers; leave their nodes out of all arguments")
    try:
        array = np.asarray(values)
    except ValueError as error:
        raise ValueError(f"{name} has rows of different lengths: allowed is an array of numbers") from error
    if array.dtype.kind == "c":
        raise ValueError(f"{name} has complex entries: allowed are real ones")
    if array.dtype.kind not in "iuf":
        raise ValueError(f"{name} is of type {type(values).__name__} with entries of type {array.dtype}: allowed are numbers, or "
                         "arrays and lists of them in rows of one length")
    return np.asarray(array, dtype=float)


def _matrix(W):
    W = _real(W, "W")
    if W.ndim != 2 or W.shape[0] != W.shape[1] or W.shape[0] % 3 or not W.size:
        raise ValueError(f"W has the shape {W.shape}: allowed is (3 n, 3 n), n > 0")
    if not (W.flags.c_contiguous or W.flags.f_contiguous):
        W = np.ascontiguousarray(W)
    return W


def _rows(values, n_columns, name, n=None):
    values = _real(values, name)
    wanted = "n" if n is None else n
    if values.ndim == 1 and values.size % n_columns == 0:
        values = values.reshape(-1, n_columns)
    if values.ndim != 2 or values.shape[1] != n_columns or n not in (None, len(values)):
        raise ValueError(f"{name} has the shape {values.shape}: allowed is ({wanted}, {n_columns})")
    if not np.isfinite(values).all():
        raise ValueError(f"{name} has entries that are no numbers")
    return np.ascontiguousarray(values)


def _pairs(values, name, n):
    values = _real(values, name)
    if values.ndim and values.shape not in ((2,), (n, 2)):
        raise ValueError(f"{name} has the shape {values.shape}: allowed is a number, (2,) or ({n}, 2)")
    return np.broadcast_to(values, (n, 2))


def _laws(mu, p, n):
    """Rows (mu_x, mu_y, p_x, p_y)."""
    mu = _pairs(mu, "mu", n)
    is_without = (mu == 0).all(axis=1)
    if not (np.isfinite(mu) & ((mu > 0) | is_without[:, None])).all():
        raise ValueError("mu: allowed are numbers > 0, or 0 in both directions")
    if p is None:
        p = np.where(is_without[:, None], 1, mu)
    p = _pairs(p, "p", n)
    if not (np.isfinite(p) & (p > 0)).all():
        raise ValueError("p: allowed are numbers > 0")
    return np.ascontiguousarray(np.concatenate([mu, p], axis=1))
