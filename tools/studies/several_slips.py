# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""How many slips one push has: a node on two springs, pressed by a given normal force, whose friction is measured.

Springs with the stiffnesses k_x and k_y pull the node towards a place, its push away from where it sticks. With the normal
force 1 and the compliance W = diag(1/k_x, 1/k_y) the node slips by m e(a), where W f(a) + m e(a) is the push and m > 0; it sticks
where W^-1 times the push is within the curve of the forces."""
import docs_page
import numpy as np
from disc_map import LINES
from matplotlib.colors import ListedColormap
from matplotlib.patches import Patch
from rosette_law import RosetteLaw, Table, cross, unit

plt = docs_page.plt
ALONG = 0.25
N_ROWS, N_ANGLES, N_DIRECTIONS = 72, 720, 60
KAPPAS, RATIOS = np.linspace(0.02, 1, 25), np.geomspace(1, 100, 29)
COLOURS = ("#dfe9f2", "#f0b04a", "#c04f00")  # of 1, 3 and 5 solutions


def law_of(kappa):
    """The same friction along every direction, and a pull to the side that makes the least kappa this share of it."""
    across = (1 - kappa) / 2 * ALONG
    angles = 2 * np.pi * np.arange(N_ROWS) / N_ROWS
    return RosetteLaw(Table(angles, np.full(N_ROWS, ALONG), -across * np.sin(2 * angles)))


class Node:
    """On springs of which the one along y has `ratio` times the stiffness of the one along x; their geometric mean is 1."""

    def __init__(self, law, ratio):
        self.law, self.compliance = law, np.array([ratio**0.5, ratio**-0.5])
        self.angles = np.linspace(0, 2 * np.pi, N_ANGLES + 1)
        self.forces = law.force(self.angles)

        self.turns = cross(unit(self.angles), self.compliance * law.derivative(self.angles))  # e' . W f'

    def least_turn(self):
        """Where it is positive, every push has one slip."""
        return self.turns.min()

    def misfit(self, angles, forces, push):
        """What W f + m e lacks of the push across e(a): zero at the angles of slips."""
        return cross(unit(angles), push - self.compliance * forces)

    def slips(self, push):
        """Angles of all slips: every change of sign between even angles, by bisection."""
        values = self.misfit(self.angles, self.forces, push)
        low = self.angles[:-1][values[:-1] * values[1:] < 0]
        high = low + 2 * np.pi / N_ANGLES
        sign = np.sign(self.misfit(low, self.law.force(low), push))
        for _ in range(45):
            middle = (low + high) / 2
            is_before = np.sign(self.misfit(middle, self.law.force(middle), push)) == sign
            low, high = np.where(is_before, middle, low), np.where(is_before, high, middle)
        size = (unit(low) * (push - self.compliance * self.law.force(low))).sum(axis=1)
        return low[size > 0]

    def sticks(self, push):
        force = push / self.compliance
        return np.hypot(*force) <= self.law.limit(np.arctan2(force[1], force[0]))

    def n_solutions(self, push):
        return len(self.slips(push)) + int(self.sticks(push))

    def counts(self, pushes):
        """The same for many pushes (n, 2), by the changes of sign alone: wrong where two slips are as good as one."""
        e = unit(self.angles)
        lack = pushes[:, None, :] - (self.compliance * self.forces)[None]
        values, size = cross(e[None], lack), (e[None] * lack).sum(axis=2)
        changes = (values[:, :-1] * values[:, 1:] < 0) & (size[:, :-1] + size[:, 1:] > 0)
        force = pushes / self.compliance
        sticks = np.hypot(*force.T) <= self.law.limit(np.arctan2(force[:, 1], force[:, 0]))
        return changes.sum(axis=1) + sticks

    def pushes(self):
        """Near the border of what sticks, all around; and those with the slip m e(a), m between 0 and -e' . W f', if there are
        any. There the push turns against the slip, which it can do for one of several slips alone."""
        directions = np.linspace(0, 2 * np.pi, N_DIRECTIONS, endpoint=False) + 0.003
        edge, slope = self.compliance * self.law.force(directions), self.compliance * self.law.derivative(directions)
        normals = np.stack([slope[:, 1], -slope[:, 0]], axis=1) / np.hypot(*slope.T)[:, None]
        near = [edge + share * np.abs(edge).max() * normals for share in (-0.05, 0.005, 0.05, 0.3)]
        back = self.turns < 0
        at, slip = (self.compliance * self.forces)[back], -self.turns[back, None] * unit(self.angles[back])
        return np.concatenate(near + [at + share * slip for share in (0.1, 0.5, 0.9)])

    def most_solutions(self):
        """Largest number over all these pushes, counted by `counts` and confirmed by bisection."""
        pushes = self.pushes()
        counts = self.counts(pushes)
        for row in np.argsort(-counts, kind="stable"):
            if counts[row] <= 1 or self.n_solutions(pushes[row]) == counts[row]:
                return int(counts[row])
        return 1


def counted_map():
    """The largest number of solutions over the ratio of stiffnesses and the least kappa, and the least e' . W f'."""
    counts, turns = np.empty((len(RATIOS), len(KAPPAS)), dtype=int), np.empty((len(RATIOS), len(KAPPAS)))
    for j, kappa in enumerate(KAPPAS):
        law = law_of(kappa)
        for i, ratio in enumerate(RATIOS):
            node = Node(law, ratio)
            counts[i, j], turns[i, j] = node.most_solutions(), node.least_turn()
    return counts, turns


def draw_map(ax):
    counts, turns = counted_map()
    ax.pcolormesh(KAPPAS, RATIOS, counts, cmap=ListedColormap(COLOURS), vmin=0, vmax=2 * len(COLOURS), shading="nearest")
    ax.contour(KAPPAS, RATIOS, turns, levels=[0], colors="black", linewidths=1)
    ax.set(yscale="log", xlabel="least kappa / mu_along", ylabel="k_y / k_x", yticks=(1, 10, 100))
    ax.yaxis.set_major_formatter("{x:g}")
    ax.set_title("most solutions that a push has")
    ax.grid(False)


def draw_pushes(ax, kappa=0.1, ratio=20):
    """Near the end of the pushes that stick which lies along the soft spring."""
    node = Node(law_of(kappa), ratio)
    edge = node.compliance * node.forces
    x, y = np.meshgrid(np.linspace(0.95, 1.35, 401), np.linspace(-0.08, 0.08, 401))
    counts = node.counts(np.stack([x.ravel(), y.ravel()], axis=1)).reshape(x.shape)
    ax.contourf(x, y, counts, levels=2 * np.arange(len(COLOURS) + 1), colors=COLOURS)
    ax.plot(*edge.T, color=LINES[0])
    ax.set(xlabel="push along x, the soft spring", ylabel="push along y", xlim=(x.min(), x.max()), ylim=(y.min(), y.max()))
    ax.set_title(f"least kappa {kappa:g} mu, k_y = {ratio:g} k_x")
    ax.grid(False)


def picture():
    figure, (left, right) = plt.subplots(1, 2, figsize=(docs_page.WIDTH, 3.6))
    draw_map(left)
    draw_pushes(right)
    handles = [Patch(color=colour) for colour in COLOURS[:2]]
    handles += [plt.Line2D([], [], color="black"), plt.Line2D([], [], color=LINES[0])]
    labels = ["1 solution", "3 solutions", "least e'·W f' is 0", "sticks to the left"]
    docs_page.legend_below(figure, handles, labels, 4)
    docs_page.headline(figure, "On unequal springs a push may have several slips although kappa > 0")
    return figure
