# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The ellipses of friction and slip that come nearest to a table, by least squares of the forces at its rows, found by the
method of Levenberg and Marquardt from several starts."""
import dataclasses

import numpy as np
from rosette_law import ellipse_forces


@dataclasses.dataclass(frozen=True)
class Ellipses:
    """mu along both axes, the ratio p_y/p_x, the angle of the first axis (radians), and the misfit of the forces."""
    mu: tuple
    ratio: float
    turn: float
    rms: float
    largest: float

    @property
    def p(self):
        """Of any length, for only the ratio matters: the larger semi-axis is 1."""
        return (1 / max(self.ratio, 1), self.ratio / max(self.ratio, 1))

    def forces(self, angles):
        return ellipse_forces(angles, self.mu, self.p, self.turn)


def forces_of(angles, unknowns):
    log_mu, log_ratio, turn = unknowns[:2], unknowns[2], unknowns[3]
    return ellipse_forces(angles, np.exp(log_mu), np.exp([-log_ratio / 2, log_ratio / 2]), turn)


def improved(angles, forces, unknowns):
    """The unknowns of least misfit near the given ones, and its square."""
    def misfit(at):
        return (forces_of(angles, at) - forces).ravel()
    damping, present = 1e-3, misfit(unknowns)
    for _ in range(200):
        step = 1e-6
        matrix = np.stack([(misfit(unknowns + step * way) - misfit(unknowns - step * way)) / (2 * step) for way in np.eye(4)], axis=1)
        square, gradient = matrix.T @ matrix, matrix.T @ present
        damped = square + damping * (np.diag(np.diag(square)) + 1e-12 * np.trace(square) * np.eye(4))
        change = -np.linalg.lstsq(damped, gradient, rcond=None)[0]  # semi-axes that vanish leave it singular
        change = np.clip(change, -0.7, 0.7)
        after = misfit(unknowns + change)
        if after @ after <= present @ present:
            unknowns, present, damping = unknowns + change, after, max(damping / 5, 1e-12)
            if np.abs(change).max() < 1e-9:
                break
        else:
            damping *= 4
            if damping > 1e12:
                break
    return unknowns, present @ present


def best_ellipses(table):
    """Of all rows alike, however near to each other they are."""
    angles, forces = table.angles, table.forces
    mean = np.log(np.linalg.norm(forces, axis=1).mean())
    starts = [(mean + skew, mean - skew, ratio, turn) for skew in (-0.3, 0.3) for ratio in (-0.5, 0.5)
              for turn in np.radians((-30, 0, 30))]
    unknowns, _ = min((improved(angles, forces, np.array(start)) for start in starts), key=lambda found: found[1])
    mu, ratio, turn = np.exp(unknowns[:2]), np.exp(unknowns[2]), unknowns[3]
    if np.allclose(mu[0], mu[1], rtol=1e-6) and abs(ratio - 1) < 1e-6:  # isotropic: any axes will do
        turn = 0.
    quarters = np.round(turn / (np.pi / 2))
    turn -= quarters * np.pi / 2  # from -45 to 45 degrees
    if quarters % 2:
        mu, ratio = mu[::-1], 1 / ratio
    distances = np.linalg.norm(forces_of(angles, unknowns) - forces, axis=1)
    return Ellipses(tuple(map(float, mu)), float(ratio), float(turn), float(np.sqrt((distances**2).mean())), float(distances.max()))
