# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Stress at the edges of a contact in a section. Outside of an edge the stress along the surface falls as a root, so that no mesh
has a node on its tip. In the zone that slips the stress less that across the surface is smooth, as are the traction-free parts
beside it; so they go on to the edge, where the surface has no traction."""
import numpy as np

XX, YY, ZZ, XY = range(4)  # of the six components
OUTER = 0.65  # of the width of the zone that slips: from the edge on, nodes that are taken
FEWEST, MOST = 4, 8  # nodes
SLIDES = 1e-3  # of the largest slip
SAME = 1e-6


def edge_of(x, pressure):
    """Where the pressure ends that falls like a root towards the first of the places x (n,), mean over the steps. pressure: (n,
    steps), > 0. A parabola goes through its squares; the end lies between the neighbours of the first place."""
    distance = (x - x[0]) / (x[1] - x[0])
    order = min(2, len(x) - 1)
    ends = []
    for column in (pressure / pressure.max(axis=0)).T:
        roots = np.polynomial.polynomial.polyroots(np.polynomial.polynomial.polyfit(distance, column**2, order))
        near = roots.real[np.abs(roots.imag) < 1e-9]
        ends.append(near[np.argmin(np.abs(near))] if len(near) else 0)
    return x[0] + (x[1] - x[0]) * float(np.clip(np.mean(ends), -1, 1))


def zones(x, pressure, slip):
    """[(place of the edge, places of the nodes that slip behind it)] of nodes in the order of x (n,). pressure, slip: (n, steps).
    An edge that moves by more than a node over the steps is left out, and a contact that ends with the body."""
    moved, pressed = np.ptp(slip, axis=1), pressure > 0
    slides = pressed.all(axis=1) & (moved > SLIDES * moved.max(initial=0))
    found = []
    for step in (1, -1):
        first = [np.flatnonzero(column)[0 if step > 0 else -1] for column in pressed.T if column.any()]
        if len(first) < pressed.shape[1] or np.ptp(first) > 1:
            continue
        at = max(first) if step > 0 else min(first)
        end = at
        while 0 <= end < len(x) and slides[end]:
            end += step
        nodes = np.arange(at, end, step)
        if 0 <= at - step < len(x) and len(nodes) > FEWEST:
            found.append((edge_of(x[nodes[:MOST]], pressure[nodes[:MOST]]), x[nodes[1:]]))
    return found


def gone_on(x, values, edge, zone):
    """values (n, ...) at places x along a surface, extrapolated to the edge by a parabola through those in the zone that
    slips; None where there are too few."""
    share = (x - edge) / (zone[-1] - edge)
    taken = (share > (zone[0] - edge) / (zone[-1] - edge) - SAME) & (share < OUTER)
    if np.sum(taken) < FEWEST:
        return None
    flat = values[taken].reshape(np.sum(taken), -1)
    return np.polynomial.polynomial.polyfit(share[taken], flat, 2)[0].reshape(values.shape[1:])


def edge_stress(body, poisson, surface_x, pressure, slip):
    """Points (m, 3) and stress (m, steps, 6) of the edges that could be found, from the nodes of the contact surface in the order
    of their x."""
    at = body.on_surface[np.argsort(body.points[body.on_surface, 0])]
    x, stress = body.points[at, 0], body.stress[at]
    smooth = np.stack([stress[..., XX] - stress[..., ZZ], stress[..., YY] - poisson * (stress[..., XX] + stress[..., ZZ]),
                       stress[..., XY]], axis=-1)
    points, histories = [], []
    for edge, zone in zones(surface_x, pressure, slip):
        found = gone_on(x, smooth, edge, zone)
        if found is None:
            continue
        history = np.zeros((len(found), 6))
        history[:, XX], history[:, XY] = found[:, 0], found[:, 2]
        history[:, YY] = found[:, 1] + poisson * found[:, 0]
        points.append([edge, 0, 0])
        histories.append(history)
    return np.array(points).reshape(-1, 3), np.array(histories).reshape(-1, stress.shape[1], 6)
