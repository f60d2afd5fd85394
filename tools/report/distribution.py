# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""How much of the area in contact carries which pressure: what roughness changes most."""
import numpy as np

N_CLASSES = 40


def node_areas(places, quads):
    """A quarter of each quadrilateral (corners in order around it) for each of its corners, in the unit of the places."""
    first, second = (places[quads[:, k + 2]] - places[quads[:, k]] for k in (0, 1))
    areas = np.zeros(len(places))
    np.add.at(areas, quads, (np.abs(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]) / 8)[:, None])
    return areas


def distribution(fields, areas):
    """Of frames {name: values of the nodes}: the largest pressure of all, MPa, and for each frame the percentage of the area in
    contact in each of the classes of pressure between zero and that. A frame without contact has zeros."""
    top = max(float(frame["pressure"].max()) for frame in fields)
    shares = []
    for frame in fields:
        touches = frame["touches"] > 0
        counts, _ = np.histogram(frame["pressure"][touches], bins=N_CLASSES, range=(0, top or 1), weights=areas[touches])
        shares.append([float(f"{share:.4g}") for share in 100 * counts / (areas[touches].sum() or 1)])
    return {"top": top, "shares": shares}
