# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The nearest table that is well posed: mu_along and mu_across of the rows change as little as possible, by least squares,
until the three conditions hold at the rows and along the straight lines from the force of each row to that of the next one.
Then the law may be joined between the rows whatever else they are (docs/theory.md, section 1).

With the forces f of two rows, their slip directions e and e' across e, the conditions are inequalities g >= margin:

    f_0 . e_0,   f_0 . e_1,   f_1 . e_0         friction opposes slip there, also along the line
    (f_1 - f_0) . e'_0,   (f_1 - f_0) . e'_1    kappa along the line, times the step of the angle
    f_0 x f_1                                   the force turns with the slip

All but the last one are linear. The program linearizes that one again and again, and each time solves a problem of least
squares with linear inequalities by an interior-point method."""
import numpy as np
from rosette_law import NotWellPosed, RosetteLaw, Table, cross, unit

MARGIN = 0.01  # of the mean coefficient, and of an even turn of the force
MOST_CHANGE = 1e3  # of the unknowns, which are about 1
MOST_ROWS = 720  # matrices of twice this size are factorized some hundred times


class NoTable(Exception):
    """None was found."""


class Conditions:
    """The conditions of a table with the mean coefficient 1, as functions of the unknowns (n, 2), mu_along and mu_across of
    the rows. There are six of each row i and the next one, so that arrays of them have the shape (6, n)."""

    def __init__(self, table, margin):
        self.mean = np.linalg.norm(table.forces, axis=1).mean()
        self.wanted = np.stack([table.along, table.across], axis=1) / self.mean
        e = unit(table.angles)
        self.axes = np.stack([e, np.stack([-e[:, 1], e[:, 0]], axis=1)], axis=1)  # row, e or e', x or y
        one, other, none = self.axes, np.roll(self.axes, -1, axis=0), np.zeros_like(e)
        # Vectors by which f_0 and f_1 are multiplied.
        self.vectors = np.array([(one[:, 0], none), (other[:, 0], none), (none, one[:, 0]), (-one[:, 1], one[:, 1]),
                                 (-other[:, 1], other[:, 1])])
        self.least = margin * np.array([np.ones(len(table))] * 3 + [table.steps] * 3)

    def linearized(self, x):
        """Matrices (6, n, 2, 2), by the unknowns of row i and of the next one, and the least values of their products."""
        forces = np.einsum("ni,nij->nj", x, self.axes)
        after = np.roll(forces, -1, axis=0)
        turning = np.array([[after[:, 1], -after[:, 0]], [-forces[:, 1], forces[:, 0]]]).transpose(0, 2, 1)
        both = np.stack([self.axes, np.roll(self.axes, -1, axis=0)])
        matrix = np.einsum("cknj,knij->cnki", np.concatenate([self.vectors, turning[None]]), both)
        least = self.least.copy()
        least[5] += cross(forces, after)  # the product is twice that
        return matrix, least


def times(matrix, x):
    return np.einsum("cnki,nki->cn", matrix, np.stack([x, np.roll(x, -1, axis=0)], axis=1))


def transposed_times(matrix, values):
    products = np.einsum("cnki,cn->nki", matrix, values)
    return products[:, 0] + np.roll(products[:, 1], 1, axis=0)


def normal_matrix(matrix, weights):
    """1 + the product of the matrix with itself."""
    n = len(matrix[0])
    blocks = np.einsum("cnki,cn,cnlj->nkilj", matrix, weights, matrix)
    full, row, after = np.zeros((n, 2, n, 2)), np.arange(n), np.roll(np.arange(n), -1)
    rows = (row, after)
    for k in range(2):
        for other in range(2):
            full[rows[k], :, rows[other], :] += blocks[:, k, :, other, :]
    return np.eye(2 * n) + full.reshape(2 * n, 2 * n)


def step_to_border(values, steps):
    """The share of the steps, up to 1, with which all values stay positive."""
    falling = steps < 0
    return min(1., 0.995 * np.min(-values[falling] / steps[falling], initial=np.inf))


def least_squares(wanted, matrix, least, most_iterations=80):
    """x nearest to `wanted` with products that are at least `least`: Mehrotra's predictor and corrector."""
    x = wanted.copy()
    slack = np.maximum(times(matrix, x) - least, 1.)
    force = np.ones_like(slack)
    for _ in range(most_iterations):
        gradient, lack = x - wanted - transposed_times(matrix, force), times(matrix, x) - slack - least
        gap = (slack * force).mean()
        if gap < 1e-12 and np.abs(lack).max() < 1e-10 and np.abs(gradient).max() < 1e-8:
            break
        normal = normal_matrix(matrix, force / slack)

        def direction(product):
            right = -gradient - transposed_times(matrix, (product + force * lack) / slack)
            dx = np.linalg.solve(normal, right.ravel()).reshape(x.shape)
            d_slack = times(matrix, dx) + lack
            return dx, d_slack, -(product + force * d_slack) / slack
        _, d_slack, d_force = direction(slack * force)
        share = min(step_to_border(slack, d_slack), step_to_border(force, d_force))
        after = ((slack + share * d_slack) * (force + share * d_force)).mean()
        dx, d_slack, d_force = direction(slack * force + d_slack * d_force - gap * (after / gap)**3)
        share = min(step_to_border(slack, d_slack), step_to_border(force, d_force))
        x, slack, force = x + share * dx, slack + share * d_slack, force + share * d_force
    return x


def is_well_posed(table):
    try:
        RosetteLaw(table)
    except NotWellPosed:
        return False
    return True


def nearest(table, margin=MARGIN):
    """The nearest table that the program takes; the table itself if it does."""
    if is_well_posed(table):
        return table
    if len(table) > MOST_ROWS:
        raise NoTable(f"has {len(table)} rows: allowed are {MOST_ROWS} where the nearest table is wanted")
    conditions = Conditions(table, margin)
    isotropic = np.tile([1., 0.], (len(table), 1))
    for start, share in ((conditions.wanted, 1.), (isotropic, 1.), (isotropic, 0.3)):
        x = settled(conditions, start, share)
        if x is not None:
            found = Table(table.angles, *(conditions.mean * x).T)
            if is_well_posed(found):
                return found
    raise NoTable("no table that is well posed was found near this one")


def settled(conditions, x, share):
    """Unknowns that linearized conditions no longer change; None if there are none. Each step goes a share of the way."""
    for _ in range(60):
        try:
            with np.errstate(all="ignore"):  # where no table meets the linearized conditions, numbers grow
                after = least_squares(conditions.wanted, *conditions.linearized(x))
        except np.linalg.LinAlgError:
            return None
        if not np.abs(after).max() < MOST_CHANGE:
            return None
        change, x = np.abs(after - x).max(), x + share * (after - x)
        if change < 1e-7:
            break
    return x
