# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The bodies of prm/import: their meshes, and a field on the contact surface; of tools/study verification."""
import itertools

import matplotlib.pyplot as plt
import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

from disc_map import Surface
from imported_body import ImportedBody
from outline import outline
from panels import BLUE

# Name, step, field with its title and unit, colours, and whence the body is seen (degrees).
BODIES = (("cylinder", 5, "slip_magnitude", "slip (mm)", "viridis", (-22, -60)),
          ("pin", 10, "pressure", "pressure (MPa)", "plasma", (-22, -60)),
          ("dovetail", 6, "pressure", "pressure (MPa)", "plasma", (-28, -115)))
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


def draw_field(ax, surface, field, colours):
    values = surface.with_centres(surface[field])
    shown = ax.tripcolor(surface.triangulation(), values, shading="gouraud", cmap=colours, vmin=0, rasterized=True)
    for polygon in outline(surface.points, surface.quadrilaterals):
        ax.plot(*np.concatenate([polygon, polygon[:1]]).T, color="0.3", linewidth=0.8)
    ax.set(aspect="equal", xlabel="x (mm)", ylabel="y (mm)")
    return shown


def picture(runs):
    """Meshes above, fields below."""
    figure = plt.figure(figsize=(11, 6.2), layout="constrained")
    for column, (name, step, field, title, colours, view) in enumerate(BODIES, start=1):
        run = runs.run(f"import-{name}", f"../import/{name}", "Output/Probes=", "Load program/Cycles=1")
        body = ImportedBody.of(run.parameters["Geometry"])
        mesh = figure.add_subplot(2, 3, column, projection="3d")
        draw_mesh(mesh, body, view)
        mesh.set_title(f"{name}.msh: {len(np.concatenate([cells for cells, _ in body.blocks('hexahedron')]))} cells")
        ax = figure.add_subplot(2, 3, 3 + column)
        figure.colorbar(draw_field(ax, Surface(run, step), field, colours), ax=ax, label=title, shrink=0.9)
        ax.set_title(f"step {step}")
    return figure
