# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Bodies of prm/import: their meshes, and the pressure on the contact surface; of tools/study verification."""
import itertools

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

import docs_page
from disc_map import Surface, levels_of
from imported_body import ImportedBody
from outline import outline
from panels import BLUE

# Name, step, and whence the body is seen (degrees).
BODIES = (("pin", 10, (-22, -60)), ("dovetail", 6, (-28, -115)))
PALE, LIT = "#dfe5ec", BLUE


def all_parts(body, faces):
    """Corners of the faces and of their mirror images."""
    factors = [(1, -1) if mirrored else (1,) for mirrored in body.mirrored]
    corners = body.points[faces]
    return np.concatenate([corners * [x, y, 1] for x, y in itertools.product(*factors)])


def is_cut(body, faces):
    """Of the section along which a symmetric body was cut, and which is inside it."""
    small = 1e-6 * np.ptp(body.points)
    return np.any([body.mirrored[axis] & np.all(np.abs(body.points[faces][..., axis]) < small, axis=1)
                   for axis in (0, 1)], axis=0)


def draw_mesh(ax, body, view):
    """From below, where the contact surface is."""
    faces = body.border[~is_cut(body, body.border)]
    contact = {tuple(sorted(face)) for face in body.contact.tolist()}
    touching = np.array([tuple(sorted(face)) in contact for face in faces.tolist()])
    for chosen, colour in ((~touching, PALE), (touching, LIT)):
        ax.add_collection3d(Poly3DCollection(all_parts(body, faces[chosen]), facecolor=colour, edgecolor="0.25",
                                             linewidth=0.3))
    corners = all_parts(body, faces).reshape(-1, 3)
    low, high = corners.min(axis=0), corners.max(axis=0)
    ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
    ax.set_box_aspect(high - low, zoom=1.15)
    ax.view_init(*view)
    ax.set_axis_off()


def draw_field(ax, surface, values, colours):
    """Where nothing touches, the mesh remains white."""
    levels = levels_of(0, values.max(), 10)
    values = np.where(surface["pressure"] > 0, values, -levels[1])
    shown = ax.tricontourf(surface.triangulation(), surface.with_centres(values), levels=levels, cmap=colours)
    ax.add_collection(PolyCollection(surface.points[surface.quadrilaterals], facecolor="none", edgecolor="0.5", linewidth=0.3))
    for polygon in outline(surface.points, surface.quadrilaterals):
        ax.plot(*np.concatenate([polygon, polygon[:1]]).T, color="0.3", linewidth=0.8)
    ax.grid(False)
    ax.set(aspect="equal", xlabel="x (mm)", ylabel="y (mm)")
    return shown


def picture(runs):
    """Meshes on the left, pressures on the right."""
    figure = plt.figure(figsize=(docs_page.WIDTH, 5.6))
    for row, (name, step, view) in enumerate(BODIES):
        run = runs.run(f"import-{name}", f"../import/{name}", "Output/Probes=", "Load program/Cycles=1")
        body = ImportedBody.of(run.parameters["Geometry"])
        mesh = figure.add_subplot(2, 2, 2 * row + 1, projection="3d")
        draw_mesh(mesh, body, view)
        mesh.set_title(f"{name}: {len(np.concatenate([cells for cells, _ in body.blocks('hexahedron')]))} cells, from below")
        ax = figure.add_subplot(2, 2, 2 * row + 2)
        surface = Surface(run, step)
        figure.colorbar(draw_field(ax, surface, 1e-3 * surface["pressure"], "cividis"), ax=ax, label="pressure (GPa)", shrink=0.9)
        ax.set_title(f"{name}: contact surface at full load")
        if name == "pin":
            ax.set(xlim=(-1, 1), ylim=(-1, 1))
    docs_page.headline(figure, "Pin and dovetail touch on small parts of their contact surfaces")
    return figure
