# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The table of Friction/Law = superellipse, as the program makes it of the formula: the cone |r_x/mu_x|^q + |r_y/mu_y|^q <= 1,
and slip along the normal of the superellipse with the semi-axes p and the exponent s, which at the angle b of the force is
tan a = (tan b)^(s - 1) (p_x/p_y)^s."""
import numpy as np
from rosette_law import Table, unit

N_ROWS = 90  # in a quadrant
MOST_SHARE = 1e-3  # of the other's angle that a and b take, for neither of them rests in a law


def quadrant(mu, p, exponent, slip_exponent):
    """Angles a and forces (n, 2) at even steps of a + b from one axis to the other, both axes included."""
    wanted = np.linspace(0, np.pi, N_ROWS + 1)
    low, high = np.full(N_ROWS + 1, -2000.), np.full(N_ROWS + 1, 2000.)  # of the logarithm of tan b
    with np.errstate(over="ignore"):
        for _ in range(80):
            middle = (low + high) / 2
            slip = np.arctan(np.exp((slip_exponent - 1) * middle + slip_exponent * np.log(p[0] / p[1])))
            is_low = slip + np.arctan(np.exp(middle)) < wanted
            low, high = np.where(is_low, middle, low), np.where(is_low, high, middle)
        b = np.arctan(np.exp(low))
    b[0], b[-1] = 0, np.pi / 2
    b = b + MOST_SHARE * min(1., abs(slip_exponent - 2)) * (wanted - 2 * b)
    e = unit(b)
    size = ((np.abs(e) / mu)**exponent).sum(axis=1)**(-1 / exponent)
    return wanted - b, e * size[:, None]


def superellipse_table(mu, p, exponent, slip_exponent):
    """Of semi-axes mu and p and both exponents."""
    angles, forces = quadrant(np.asarray(mu), p, exponent, slip_exponent)
    angles, forces = np.concatenate([angles, np.pi - angles[-2:0:-1]]), np.concatenate([forces, forces[-2:0:-1] * (-1, 1)])
    return Table.of_forces(np.concatenate([angles, np.pi + angles]), np.concatenate([forces, -forces]))
