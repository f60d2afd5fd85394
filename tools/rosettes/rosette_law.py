# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Measured friction: the law that a table of it becomes, as docs/theory.md (section 1, "The circle") has it.

This is a second implementation, beside the one of the program, with which a test compares it. Angles are in radians. The
force f(a) per unit normal force acts against slip along -e(a), and e' is e turned by 90 degrees to the left."""
import dataclasses

import numpy as np

LEAST_ROWS, MOST_ROWS = 8, 3600
TURN, SAME_ANGLE = 2 * np.pi, 1e-9
N_CANDIDATES, N_PLACES, MOST_ROUNDS = 3, 16, 40
CONDITIONS = ("along", "kappa", "turning")
REASONS = {"along": ("mu_along", "friction opposes slip"),
           "turning": ("the turn of the force, d b/da,", "a force has one direction of slip"),
           "kappa": ("kappa = mu_along + d mu_across/da", "one push on a node has one slip")}


class RosetteError(ValueError):
    """A table that is no law: what is wrong, and what is allowed."""


class NotWellPosed(RosetteError):
    """A table that breaks one of the three conditions."""


def unit(angles):
    """e(a), along the last axis."""
    return np.stack([np.cos(angles), np.sin(angles)], axis=-1)


def cross(v, w):
    return v[..., 0] * w[..., 1] - v[..., 1] * w[..., 0]


def degrees(radians):
    return f"{np.round(np.degrees(radians), 3) + 0:g} degrees"


@dataclasses.dataclass
class Table:
    """Rows in the order of their angles, from 0 to 2 pi."""
    angles: np.ndarray
    along: np.ndarray
    across: np.ndarray

    def __post_init__(self):
        angles = np.asarray(self.angles, dtype=float) % TURN
        order = np.argsort(angles, kind="stable")
        self.angles, self.along, self.across = (np.asarray(values, dtype=float)[order]
                                                for values in (angles, self.along, self.across))

    def __len__(self):
        return len(self.angles)

    @property
    def steps(self):
        """From each row to the next one, all around."""
        return np.diff(self.angles, append=self.angles[:1] + TURN)

    @property
    def forces(self):
        """f (n, 2) of the rows."""
        e = unit(self.angles)
        return self.along[:, None] * e + self.across[:, None] * np.stack([-e[:, 1], e[:, 0]], axis=-1)

    @staticmethod
    def of_forces(angles, forces):
        """The table of forces (n, 2) against slip along -e(a)."""
        e = unit(np.asarray(angles))
        return Table(angles, (forces * e).sum(axis=1), cross(e, forces))

    def check_rows(self):
        """Enough of them, at angles of their own, with coefficients whose squares are numbers."""
        if len(self) and not 1e-100 < np.hypot(self.along, self.across).max() < 1e100:
            raise RosetteError(f"has coefficients up to {np.hypot(self.along, self.across).max():g}: allowed are such of friction, about 1")
        if len(self) < LEAST_ROWS:
            raise RosetteError(f"has {len(self)} rows: allowed are {LEAST_ROWS} and more")
        for angle, step in zip(self.angles, self.steps):
            if step < SAME_ANGLE:
                raise RosetteError(f"has the angle {degrees(angle)} twice: allowed is a row for each angle, where 0 and 360 "
                                   "are the same")
            if step > np.pi / 2 + 1e-9:
                raise RosetteError(f"has no angle between {degrees(angle)} and {degrees(angle + step)}: allowed are steps up "
                                   "to 90 degrees all around")


def refuse(name, value, place):
    words, reason = REASONS[name]
    raise NotWellPosed(f"{words} is {value:.6g} {place}: allowed is a number > 0 at every angle, because {reason}")


def _slopes_of_chords(g, k_before, k):
    """Half the derivative of G^2 by b at rows: that of a tangent between the chords to both neighbours."""
    before, after = np.roll(g, 1), np.roll(g, -1)
    ahead = (np.sqrt(g * after) - g * np.cos(k)) / np.sin(k)
    behind = -(np.sqrt(g * before) - g * np.cos(k_before)) / np.sin(k_before)
    return (ahead * k_before + behind * k) / (k_before + k)


def _slopes_within(reach, h, k, g, chords):
    """d b/da and half the derivative of G^2 by b, those of two ellipses through a row and the ones `reach` before and behind
    it; NaN where these span half a turn, but for reach 1."""
    def span(steps):
        behind = sum(np.roll(steps, 1 + by) for by in range(reach))
        return behind, sum(np.roll(steps, -by) for by in range(reach))
    (h0, h1), (k0, k1) = span(h), span(k)
    with np.errstate(all="ignore"):
        cot = 1 / np.tan(np.stack([h0, h1, k0, k1]))
        total = cot[2] + cot[3]
        turning = (cot[0] + cot[1]) / total
        size = (np.roll(g, -reach) / np.sin(k1)**2 - np.roll(g, reach) / np.sin(k0)**2
                - g * (cot[3]**2 - cot[2]**2)) / (2 * total)
    wide = np.maximum(h0 + h1, k0 + k1) > 0.999 * np.pi
    if reach == 1:
        return np.where(wide, (k0 / h0 + k1 / h1) / 2, turning), np.where(wide, chords, size)
    return np.where(wide, np.nan, turning), np.where(wide, np.nan, size)


def _slopes_of_five(h, k, g, three, wide):
    """Richardson's rule, where it corrects by little."""
    def weight(steps):
        product = np.roll(steps, 1) * steps
        wide_product = (np.roll(steps, 1) + np.roll(steps, 2)) * (steps + np.roll(steps, -1))
        return product / (wide_product - product)
    with np.errstate(all="ignore"):
        turning = weight(h) * np.log(three[0] / wide[0])
        size = weight(k) * (three[1] - wide[1])
        takes = (np.abs(turning) < 0.25) & (np.abs(size) < 0.25 * g)
        return np.where(takes, three[0] * np.exp(turning), three[0]), np.where(takes, three[1] + size, three[1])


class RosetteLaw:
    """The law of a table. Raises RosetteError where the program refuses the table; with `anyway` the law of a table that
    breaks a condition is made as far as forces turn with the slip from row to row."""

    def __init__(self, table, anyway=False):
        table.check_rows()
        self.table = table
        self._a, self._h = table.angles, table.steps
        self._b = self._a + np.arctan2(table.across, table.along)
        for angle, value in zip(self._a, table.along):
            if not value > 0:
                refuse("along", value, "at " + degrees(angle))
        self._g = 1 / (table.along**2 + table.across**2)
        self._k = np.diff(self._b, append=self._b[:1] + TURN)
        for angle, step, turn in zip(self._a, self._h, self._k):
            place = f"between {degrees(angle)} and {degrees((angle + step) % TURN)}"
            if not turn > 0:
                refuse("turning", turn / step, place)
            if turn > np.radians(179):
                raise NotWellPosed(f"the force turns by {degrees(turn)} {place}: allowed are 179 degrees, and a remedy is a "
                                   "row between them")
        self._join()
        if not anyway:
            for name in ("along", "turning", "kappa"):
                value, angle = self.least[name]
                if not value > 0:
                    refuse(name, value, "at " + degrees(angle))

    # --- joining the rows ---

    def _join(self):
        """Sectors that fail take safer slopes at their rows, and then tension."""
        n, h, k, g = len(self.table), self._h, self._k, self._g
        chords = _slopes_of_chords(g, np.roll(k, 1), k)
        three = _slopes_within(1, h, k, g, chords)
        five = _slopes_of_five(h, k, g, three, _slopes_within(2, h, k, g, chords))
        self._candidates = np.array([five, three, (three[0], chords)])  # candidate, d b/da or G^2, row
        self._taken, self._tension = np.zeros(n, dtype=int), np.zeros(n)
        for rounds in range(MOST_ROUNDS):
            self._set_sectors()
            values, angles = self._looked_at()
            failing = np.flatnonzero(~(values["kappa"].min(axis=1) > 0))
            if not len(failing) or rounds + 1 == MOST_ROUNDS:
                break
            for i in failing:
                self._improve(i)
        self.least = {}
        for name, all_values in values.items():
            i, place = np.unravel_index(np.argmin(all_values), all_values.shape)
            self.least[name] = float(all_values[i, place]), float(angles[i, place] % TURN)

    def _improve(self, i):
        rows = [row for row in (i, (i + 1) % len(self.table)) if self._taken[row] + 1 < N_CANDIDATES]
        for row in rows:
            self._taken[row] += 1
        if not rows:
            self._tension[i] = 2 * self._tension[i] or 1

    def _set_sectors(self):
        turning, size = self._candidates[self._taken, :, np.arange(len(self.table))].T
        h, k, g = self._h, self._k, self._g
        ratio = np.sin(h) / np.sin(k)
        self._alpha, self._beta = np.sqrt(turning * ratio), 1 / np.sqrt(np.roll(turning, -1) * ratio)
        self._m0 = size * np.sin(k) + g * np.cos(k)
        self._m1 = -np.roll(size, -1) * np.sin(k) + np.roll(g, -1) * np.cos(k)

    def _looked_at(self):
        """Conditions at even steps of the slip and of the force within each sector (n, 32), and the angles of slip there."""
        part = np.arange(N_PLACES) / N_PLACES
        sector = np.arange(len(self.table))[:, None]
        h, k = self._h[:, None], self._k[:, None]
        places = np.concatenate([part * h, self._within_slip(sector, part * k)], axis=1)
        values = dict(zip(CONDITIONS, self._conditions(sector, places)))
        return {name: np.where(np.isnan(one), -np.inf, one) for name, one in values.items()}, self._a[:, None] + places

    def _within_slip(self, i, t):
        """The angle of slip within sector i, from the angle t of the force within it: the root p of a quadratic equation."""
        h, k, alpha, beta = self._h[i], self._k[i], self._alpha[i], self._beta[i]
        with np.errstate(divide="ignore"):
            q = np.sin(t) / np.sin(k - t)
        square, linear, constant = alpha * beta**2, alpha * (alpha * beta - q), beta * q
        root = np.sqrt(linear**2 + 4 * square * constant)
        p = np.where(linear > 0, 2 * constant / (linear + root), (root - linear) / (2 * square))
        return np.arctan2(p * np.sin(h), 1 + p * np.cos(h))

    # --- the law within sectors ---

    def _both(self, i, t):
        """The force at the angle t within sectors i, and its derivative by the angle."""
        h, k, alpha, beta = self._h[i], self._k[i], self._alpha[i], self._beta[i]
        # Coordinates of e(a) in the slip directions of the two rows, but for sin h, and those of the force.
        x, y, dx, dy = np.sin(h - t), np.sin(t), -np.cos(h - t), np.cos(t)
        one, two = x * (beta * x + alpha * y), alpha * beta * y * (alpha * x + beta * y)
        mixed = dx * y + x * dy
        d_one, d_two = 2 * beta * x * dx + alpha * mixed, alpha * beta * (alpha * mixed + 2 * beta * y * dy)
        first, second = unit(self._b[i]), unit(self._b[i] + k)
        v = one[..., None] * first + two[..., None] * second
        dv = d_one[..., None] * first + d_two[..., None] * second
        square, (by_one, by_two) = self._square(i, one, two)
        slope = by_one * d_one + by_two * d_two
        with np.errstate(invalid="ignore", divide="ignore"):  # no gauge where its square is negative
            gauge = np.sqrt(square)[..., None]
            return v / gauge, (dv - v * (slope / (2 * square))[..., None]) / gauge

    def _square(self, i, x, y):
        """G^2 of the coordinates (x, y) of a force, and its derivatives by both."""
        g0, g1, m0, m1, t = self._g[i], np.roll(self._g, -1)[i], self._m0[i], self._m1[i], self._tension[i]
        mixed = m0 + m1 + t * np.sqrt(g0 * g1)
        below = x * x + (2 + t) * x * y + y * y
        m = (m0 * x * x + mixed * x * y + m1 * y * y) / below
        m_x = (2 * m0 * x + mixed * y - m * (2 * x + (2 + t) * y)) / below
        m_y = (mixed * x + 2 * m1 * y - m * ((2 + t) * x + 2 * y)) / below
        slopes = 2 * (g0 * x + m * y + x * y * m_x), 2 * (g1 * y + m * x + x * y * m_y)
        return g0 * x * x + 2 * m * x * y + g1 * y * y, slopes

    def _conditions(self, i, t):
        force, slope = self._both(i, t)
        e = unit(self._a[i] + t)
        return ((force * e).sum(axis=-1), cross(e, slope),
                cross(force, slope) / (force**2).sum(axis=-1))

    def _sectors(self, angles, starts):
        """Which sector has each of the angles, and the angle within it."""
        angles = np.asarray(angles, dtype=float)
        from_first = (angles - starts[0]) % TURN
        i = np.searchsorted(starts - starts[0], from_first, side="right") - 1
        return i, from_first - (starts[i] - starts[0])

    # --- what it is asked ---

    def force(self, angles):
        """f(a), along the last axis."""
        return self._both(*self._sectors(angles, self._a))[0]

    def derivative(self, angles):
        """d f/da, along the last axis."""
        return self._both(*self._sectors(angles, self._a))[1]

    def conditions(self, angles):
        """mu_along, kappa = mu_along + d mu_across/da and d b/da, each of the shape of the angles."""
        return self._conditions(*self._sectors(angles, self._a))

    def coefficients(self, angles):
        """mu_along and mu_across."""
        force, e = self.force(angles), unit(np.asarray(angles))
        return (force * e).sum(axis=-1), cross(e, force)

    def slip_angle(self, force_angles):
        """The angle a of e(a) for the angle b of the force."""
        i, t = self._sectors(force_angles, self._b)
        return self._a[i] + self._within_slip(i, t)

    def limit(self, force_angles):
        """R(b), the largest force in this direction per unit normal force."""
        return np.linalg.norm(self.force(self.slip_angle(force_angles)), axis=-1)


def mean_table(first, second, share):
    """The weighted mean of two tables, f = (1 - share) f_1 + share f_2, at the rows of both, as `Rosette weight` has it."""
    angles = np.sort(np.concatenate([first.angles, second.angles]))
    angles = angles[np.diff(angles, prepend=angles[-1] - TURN) > SAME_ANGLE]
    forces = [(weight, RosetteLaw(table).force(angles)) for weight, table in ((1 - share, first), (share, second))]
    return Table.of_forces(angles, sum(weight * force for weight, force in forces))


def ellipse_forces(angles, mu, p, turn=0.):
    """f(a) of a friction ellipse with the semi-axes mu and a slip ellipse with p, whose axes are turned by `turn`."""
    e = unit(np.asarray(angles) - turn) * np.square(p)
    local = e / np.linalg.norm(e / np.asarray(mu), axis=-1, keepdims=True)
    c, s = np.cos(turn), np.sin(turn)
    return np.stack([c * local[..., 0] - s * local[..., 1], s * local[..., 0] + c * local[..., 1]], axis=-1)
