# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What the book reads of a run: it takes what users read, fields at the contact nodes and columns of history.csv."""
import math

import numpy as np


def of_history(column, step=-1, factor=1.0):
    """A measure: the entry of a step (from 1; -1 the last) of a column, times a factor."""
    row = step if step < 0 else step - 1
    return lambda runs, scene: factor * float(runs(scene).history[column][row])


def on_surface(run, step, name):
    """Distances from the axis and a field, each place once."""
    contact = run.contact(step)
    radius = np.hypot(*contact.points[:, :2].T)
    chosen = np.unique(np.round(radius, 6), return_index=True)[1]
    return radius[chosen], contact[name][chosen]


def along_x(run, step, name):
    """Places x >= 0 on the x axis and a field there."""
    contact = run.contact(step)
    x, y = contact.points[:, :2].T
    on = np.flatnonzero((np.abs(y) < 1e-6) & (x > -1e-6))
    on = on[np.argsort(x[on])]
    return x[on].astype(float), contact[name][on].astype(float)


def on_line(run, step, name):
    """Places along x and a field, on one side of the strip of plane strain."""
    contact = run.contact(step)
    side = np.flatnonzero(contact.points[:, 1] < contact.points[:, 1].min() + 1e-4)
    side = side[np.argsort(contact.points[side, 0])]
    return contact.points[side, 0].astype(float), contact[name][side].astype(float)


def fitted_circle(r, pressure, most=0.8):
    """Where the half-ellipsoid (or ellipse) through pressures at r ends, and its largest value: the line through their squares
    in the inner part of the contact."""
    reach = np.abs(r[pressure > 0]).max()
    inner = (np.abs(r) < most * reach) & (pressure > 0)
    slope, square = np.polyfit(r[inner] ** 2, pressure[inner] ** 2, 1)
    return math.sqrt(-square / slope), math.sqrt(square)


def fitted_ellipse(contact, inner):
    """Semi-axes along x and y and the largest value of the half-ellipsoid through the pressures where inner(x, y)."""
    x, y = contact.points[:, :2].T.astype(float)
    chosen = (contact["pressure"] > 0) & inner(x, y)
    columns = np.stack([np.ones(np.sum(chosen)), x[chosen]**2, y[chosen]**2], axis=1)
    square, along_x, along_y = np.linalg.lstsq(columns, contact["pressure"][chosen].astype(float)**2, rcond=None)[0]
    return math.sqrt(-square / along_x), math.sqrt(-square / along_y), math.sqrt(square)


def fitted_size(r, pressure, profile, low, high):
    """The size a of the contact whose pressures profile(r, a) are next to those of the nodes, by least squares."""
    chosen = (np.abs(r) < 0.97 * np.abs(r[pressure > 0]).max()) & (pressure > 0)
    places, values = np.abs(r[chosen]), pressure[chosen]

    def miss(a):
        return float(np.sum((profile(places, a) - values)**2))

    golden = (math.sqrt(5) - 1) / 2
    first, second = high - golden * (high - low), low + golden * (high - low)
    of_first, of_second = miss(first), miss(second)
    while high - low > 1e-8 * high:
        if of_first < of_second:
            high, second, of_second = second, first, of_first
            first = high - golden * (high - low)
            of_first = miss(first)
        else:
            low, first, of_first = first, second, of_second
            second = low + golden * (high - low)
            of_second = miss(second)
    return (low + high) / 2


def largest_difference(x, values, exact, inner):
    """Of values(x) and exact(x) at the nodes where |x| < inner."""
    chosen = np.abs(x) < inner
    return float(np.abs(values[chosen] - exact(x[chosen])).max())


def end_of_stick(r, criterion, sticks):
    """Where the friction criterion of the nodes that stick comes to 0, for a zone that grows: it does so with the power 3/2, so
    that its power 2/3 is nearly straight there. The line through the outer tenth of these nodes."""
    end = np.abs(r[sticks]).max()
    outer = sticks & (np.abs(r) > 0.9 * end)
    slope, middle = np.polyfit(np.abs(r[outer]), np.maximum(0, -criterion[outer]) ** (2 / 3), 1)
    return float(-middle / slope)


def gyration(run, step, weight):
    """Root of the mean squares of x and y (mm), weighted with weight(nodal forces (n, 3)). Nodal forces balance the body, so
    that their moments are those of tractions; these scatter from node to node, their moments do not. The half-ellipsoid of
    radius c has c^2/5 along each, the half-ellipse c^2/4."""
    contact = run.contact(step)
    weights = weight(contact["nodal_force"].astype(float))
    return np.sqrt(weights @ contact.points[:, :2].astype(float)**2 / np.sum(weights))


def circle_of(weight, step):
    """A measure: the radius of the half-ellipsoid that has the second moment of these weights."""
    return lambda runs, scene: math.sqrt(2.5) * float(np.hypot(*gyration(runs(scene), step, weight)))


def strip_of(weight, step):
    """A measure: the half width of the half-ellipse along x that has the second moment of these weights."""
    return lambda runs, scene: 2 * float(gyration(runs(scene), step, weight)[0])


def normal(force):
    return force[:, 2]


def left_by_slip(mu, angle, sign=1):
    """Weights mu r_n - r_t: 0 where friction is at its limit mu along `angle` (degrees), so that what sticks is left. Cattaneo's
    solution is the half-ellipsoid (or half-ellipse) of its size there."""
    along = np.array([math.cos(math.radians(angle)), math.sin(math.radians(angle)), 0])
    return lambda force: mu * force[:, 2] + sign * (force @ along)


def deepest_shear(run, step, reach):
    """Half of the largest |zz - xx| of the stress (MPa) on the axis up to the height `reach` (mm), and where it is."""
    volume = run.contact(step, "volume")
    on_axis = np.all(np.abs(volume.points[:, :2]) < 1e-6, axis=1) & (volume.points[:, 2] < 2 * reach)
    stress = volume["stress"][on_axis].reshape(-1, 9).astype(float)
    heights, node = np.unique(np.round(volume.points[on_axis, 2].astype(float), 6), return_inverse=True)
    shear = np.bincount(node, np.abs(stress[:, 8] - stress[:, 0]) / 2) / np.bincount(node)  # cells differ at their borders
    top = heights[np.argmax(shear)]
    near = (heights > 0.5 * top) & (heights < 1.7 * top)
    curve = np.polynomial.Polynomial.fit(heights[near], shear[near], 4)  # stresses of cells scatter about it
    places = np.linspace(0.6 * top, 1.5 * top, 2001)
    return float(curve(places).max()), float(places[np.argmax(curve(places))])
