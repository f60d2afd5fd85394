# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The theory of critical distances (Taylor 1999): below a contact stress falls within a grain or two, and what counts is not
its largest value at a point of the surface. The line method takes the mean of the stress over the length 2 L below the surface,
the point method the stress in the depth L/2. L = (Delta K_th/Delta sigma_0)^2/pi is a length of the material. The mean is that
of the stress tensor in each step; the parameters of the mean history follow."""
import numpy as np
from interpolation import interpolated

METHODS = ("line", "point")
_PARTS = 40


def depths_and_weights(length, method):
    """Depths (mm), and the weights with which stress there makes the mean."""
    if method == "point":
        return np.array([length / 2]), np.ones(1)
    weights = np.full(_PARTS + 1, 1 / _PARTS)
    weights[[0, -1]] /= 2
    return np.linspace(0, 2 * length, _PARTS + 1), weights


def below_surface(body, length, method):
    """Of a section: numbers of the points of its surface below which the length lies within the body, (k,), and their mean
    histories, (k, steps, 6), MPa."""
    depths, weights = depths_and_weights(length, method)
    at = body.on_surface
    places = np.stack(np.broadcast_arrays(body.points[at, :1], body.inward * depths), axis=2)
    rows, shares, inside = body.triangles.weights(places.reshape(-1, 2))
    inside = inside.reshape(len(at), -1)
    inside[:, 0] |= depths[0] == 0  # rounding of places on the border
    whole = inside.all(axis=1)
    flat = interpolated(body.stress.reshape(len(body.points), -1), rows, shares)
    stress = flat.reshape(len(at), len(depths), *body.stress.shape[1:])
    return at[whole], np.einsum("d,kdsc->ksc", weights, stress[whole])


def along_line(distances, points, stress, length, method):
    """The mean history, (1, steps, 6), of a line from its first end on; None of a line that is too short, or does not go
    down."""
    depths, weights = depths_and_weights(length, method)
    goes_down = abs(points[-1, 2]) - abs(points[0, 2]) > distances[-1] / 2
    if depths[-1] > distances[-1] * (1 + 1e-9) or not goes_down:
        return None
    flat = stress.reshape(len(stress), -1)
    at_depths = np.stack([np.interp(depths, distances, column) for column in flat.T], axis=1)
    return (weights @ at_depths).reshape(1, *stress.shape[1:])
