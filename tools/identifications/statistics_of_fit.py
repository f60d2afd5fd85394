# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What n residuals with independent noise say of p parameters: intervals, and the directions that they do not tell.

Parameters are scaled, so that a change of 1 is one of the parameter's own size, and a direction among them can be judged."""
import dataclasses
import statistics

import numpy as np

CONFIDENCE = 0.95
UNTOLD = 0.5  # half-width of an interval, relative to the parameter, from which on a direction counts as not told
BLURRED, COMPENSATED = 0.1, 3  # from these half-widths on, absolute and over those of the parameters alone, several parameters
# whose changes compensate each other count as not told apart
INVOLVED = 0.2  # component of a unit direction from which on its parameter counts as part of it
ALONE = 0.95  # share of a parameter's own direction in what is not told from which on nothing of it is told
ERROR_OF_MODEL = 0.002  # of the force amplitude, from mesh and load steps: it may lie along a direction as no noise does


def student(dof):
    """The two-sided quantile of Student's t at CONFIDENCE (Cornish and Fisher's expansion, 0.003 off at 5 degrees of freedom)."""
    z = statistics.NormalDist().inv_cdf((1 + CONFIDENCE) / 2)
    return (z + (z**3 + z) / (4 * dof) + (5 * z**5 + 16 * z**3 + 3 * z) / (96 * dof**2) +
            (3 * z**7 + 19 * z**5 + 17 * z**3 - 15 * z) / (384 * dof**3))


@dataclasses.dataclass
class Information:
    """residual: (n,), and jacobian: (n, p), its derivative by the scaled parameters, both relative to the force amplitude.
    n_means: number of means that were taken off the residuals."""
    residual: np.ndarray
    jacobian: np.ndarray
    n_means: int = 0

    def __post_init__(self):
        n, p = self.jacobian.shape
        self.dof = max(n - p - self.n_means, 1)
        self.noise = float(np.sqrt(self.residual @ self.residual / self.dof))
        self.left, self.singular, self.directions = np.linalg.svd(self.jacobian, full_matrices=False)
        self.singular = np.maximum(self.singular, 1e-12 * max(self.singular.max(), 1e-300))

    def half_widths(self, noise=None):
        """(p,): half-widths of the intervals along the directions, relative to the parameters' sizes, with the error of the
        model."""
        noise = self.noise if noise is None else noise
        return (student(self.dof) * noise + ERROR_OF_MODEL * np.sqrt(len(self.residual))) / self.singular

    def told(self, noise=None):
        """(p,): whether a direction is told."""
        half = self.half_widths(noise)
        alone = half[0] * self.singular[0] / np.maximum(np.linalg.norm(self.jacobian, axis=0), 1e-300)  # others fixed
        involved = np.abs(self.directions) > INVOLVED
        compensated = half > COMPENSATED * np.max(np.where(involved, alone, 0), axis=1)
        return (half < UNTOLD) & ~((half > BLURRED) & (involved.sum(axis=1) > 1) & compensated)

    def step(self, noise):
        """(p,): the step of Gauss and Newton within the directions that are told at this noise."""
        told = self.told(noise)
        return -(self.directions[told].T / self.singular[told]) @ (self.left[:, told].T @ self.residual)

    def untold(self):
        """[(p,)]: unit vectors that span what is not told; parameters that are not told at all have one of their own."""
        space = self.directions[~self.told()]
        alone = np.sum(space**2, axis=0) > ALONE
        _, singular, others = np.linalg.svd(space * ~alone, full_matrices=False)
        return [*np.eye(len(alone))[alone], *others[singular > INVOLVED]]

    def identified(self):
        """(p,): parameters that are not part of a direction that is not told."""
        return np.sum(self.directions[~self.told()]**2, axis=0) < INVOLVED**2

    def covariance(self):
        """(p, p), of the scaled parameters within the directions that are told."""
        told = self.told()
        root = self.directions[told].T * (self.noise / self.singular[told])
        return root @ root.T

    def intervals(self):
        """(p,): half-widths of the 95 % intervals."""
        return student(self.dof) * np.sqrt(np.diag(self.covariance()))

    def correlation(self):
        """(p, p); 0 where a parameter has no variance."""
        covariance = self.covariance()
        deviation = np.sqrt(np.diag(covariance))
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.nan_to_num(covariance / np.outer(deviation, deviation))

    def bootstrap(self, sequences, n, seed=1):
        """(2, p): 2.5 and 97.5 % of the scaled change of the parameters in n linear fits to residuals that are drawn anew, in
        blocks of neighbours within each of the `sequences` (arrays of rows), so that it does not matter whether neighbours
        depend on each other."""
        chance, told, rows = np.random.default_rng(seed), self.told(), len(self.residual)
        drawn = np.zeros((n, rows))
        spread = (self.residual - self.residual.mean()) * np.sqrt(rows / self.dof)
        for sequence in sequences:
            length = max(1, round(len(sequence)**(1 / 3)))
            starts = chance.integers(len(sequence), size=(n, -(-len(sequence) // length)))
            at = (starts[:, :, None] + np.arange(length)).reshape(n, -1)[:, :len(sequence)] % len(sequence)
            drawn[:, sequence] = spread[sequence[at]]
        changes = drawn @ (self.left[:, told] / self.singular[told]) @ self.directions[told]
        tail = (1 - CONFIDENCE) / 2
        return np.quantile(changes, [tail, 1 - tail], axis=0)


def neighbours(residual, sequences):
    """Correlation of neighbouring residuals within sequences: near 0 where they are noise."""
    product = sum(residual[rows[1:]] @ residual[rows[:-1]] for rows in sequences)
    return float(product / max(residual @ residual, 1e-300))


def proportional(x, y):
    """Slope of y = slope * x by least squares, and the half-width of its 95 % interval."""
    slope = float(x @ y / (x @ x))
    dof = max(len(x) - 1, 1)
    deviation = np.sqrt(np.sum((y - slope * x)**2) / dof / (x @ x))
    return slope, float(student(dof) * deviation)
