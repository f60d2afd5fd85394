# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The bodies of a section, (r, z) or (x, z): all of it with its mesh, and the mesh about the first touch drawn larger."""
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection

import marks
from labels import Labels
from loads import drawn_loads, outward
from parts import CONTACT, GROUND, HELD, MESH, SUPPORT, mirrors

STROKES = 12  # of the hatching of a support


def view(points):
    """x (or r) to the right, z up."""
    return np.asarray(points)[..., [0, 2]]


def from_above(points):
    """The same from a little above, for what turns about z."""
    points = np.asarray(points)
    return np.stack([points[..., 0], points[..., 2] + 0.3 * points[..., 1]], axis=-1)


def draw_cells(ax, body, linewidth=0.35, least=-np.inf, largest=np.inf):
    """Those that are between two places along x."""
    cells = [view(cell) for cell in body.cells if cell[:, 0].max() >= least and cell[:, 0].min() <= largest]
    ax.add_collection(PolyCollection(cells, facecolors=body.colour,
                                     edgecolors=MESH if body.has_mesh else body.colour, linewidths=linewidth, zorder=2))


def lines_of(surface, copies):
    return [view(face * copy) for copy in copies for face in surface.faces]


def draw_surfaces(ax, body, copies, size):
    """Lines on the surfaces: coloured where they have a role, dashed where symmetry adds them."""
    points = body.points()
    inside = (points.min(axis=0) + points.max(axis=0)) / 2
    for surface in body.surfaces:
        if surface.has("symmetry") or surface.has("axis"):
            ax.add_collection(LineCollection(lines_of(surface, copies[:1]), colors="0.3", linewidths=1,
                                             linestyles=(0, (8, 3, 1, 3)), zorder=4))
            continue
        ax.add_collection(LineCollection(lines_of(surface, copies[1:]), colors="0.55", linewidths=0.7, linestyles=(0, (4, 3)),
                                         zorder=1))
        colour, width = ((CONTACT, 3) if surface.has("contact") else (HELD, 3) if surface.has("held") else
                         (SUPPORT, 2.2) if surface.has("support") else ("0.2", 0.9))
        ax.add_collection(LineCollection(lines_of(surface, copies[:1]), colors=colour, linewidths=width, zorder=5))
        if surface.has("support"):
            hatch(ax, surface, inside, 0.02 * size)


def hatch(ax, surface, inside, depth):
    """Strokes outside of a support, evenly along all of it."""
    axis = int(np.argmax(np.ptp(surface.points(), axis=0)))
    ends = sorted((face[[0, -1]][np.argsort(face[[0, -1], axis])] for face in surface.faces), key=lambda pair: pair[0][axis])
    knots = np.concatenate(ends)
    strokes = []
    for place in np.linspace(knots[0][axis], knots[-1][axis], STROKES):
        start = np.array([np.interp(place, knots[:, axis], knots[:, k]) for k in range(3)])
        face = min(surface.faces, key=lambda one: abs(one.mean(axis=0)[axis] - place))
        out = outward(face, inside)
        strokes.append(view([start, start + depth * (out + [out[2], 0, -out[0]])]))
    ax.add_collection(LineCollection(strokes, colors=SUPPORT, linewidths=0.9, zorder=4))


def draw_ground(ax, scene, body, copies):
    """The obstacle below z = 0; returns its corners."""
    places = np.concatenate([view(surface.points() * copy) for surface in body.with_role("contact") for copy in copies])
    low, high = places[:, 0].min(), places[:, 0].max()
    margin = 0.1 * (high - low)
    depth = (0.25 if scene["obstacle"]["kind"] != "rigid" else 0.04) * (high - low)
    corners = np.array([[low - margin, 0], [high + margin, 0], [high + margin, -depth], [low - margin, -depth]])
    ax.add_collection(PolyCollection([corners], facecolors=GROUND, edgecolors="none", zorder=1))
    ax.plot(*corners[:2].T, color="0.3", linewidth=1.2, zorder=3)
    return corners


def label_surfaces(labels, bodies):
    for body in bodies:
        for surface in body.surfaces:
            if surface.has("axis"):
                continue
            colour = CONTACT if surface.has("contact") else HELD if surface.has("held") else SUPPORT if surface.has(
                "support") else "0.35"
            middle = surface.middle()
            nearest = min(surface.faces, key=lambda face: np.linalg.norm(face.mean(axis=0) - middle))
            place = nearest.mean(axis=0)
            if surface.has("contact") or surface.has("held"):  # at an end, so that no line runs over the mesh
                side = 1 if surface.has("contact") else -1
                place = max((face.mean(axis=0) for face in surface.faces), key=lambda point: side * point[0])
            labels.add(view(place), body.words_of(surface), colour)


def draw(ax, scene, bodies):
    copies = mirrors(scene)
    labels, corners = Labels(), np.zeros((0, 2))
    normals = marks.normals_of(scene)
    if len(bodies) == 1 and normals is None:
        corners = draw_ground(ax, scene, bodies[0], copies)
    points = np.concatenate([*(view(body.points() * copy) for body in bodies for copy in copies), corners])
    size = np.ptp(points, axis=0).max()
    for body in bodies:
        draw_cells(ax, body)
        draw_surfaces(ax, body, copies, size)
    shapes = [points]
    for load in drawn_loads(scene, bodies, 0.2 * size):
        shapes += marks.draw_load(ax, view, load, labels, from_above)
    label_surfaces(labels, bodies)
    if normals is not None:
        shapes.append(marks.draw_normals(ax, view, normals, 0.08 * size, labels))
    elif scene["obstacle"]["kind"] != "body":
        words = scene["obstacle"]["text"].partition(";")[0] if scene["obstacle"]["kind"] != "rigid" else "rigid counterface"
        labels.add(corners[2] + [-0.05 * size, 0.3 * (corners[1] - corners[2])[1]], words, "0.35")
    marks.set_limits(ax, np.concatenate(shapes))
    marks.draw_axes_and_scale(ax, view, size, "xz")
    labels.draw(ax)


def draw_mesh_at_touch(ax, scene, bodies):
    """Cells about the first touch, where they are small enough to be lost in the whole."""
    touch = scene["gap"]["touch"][0]
    lines = [face for surface in bodies[0].with_role("contact") for face in surface.faces]
    nearest = sorted(lines, key=lambda face: abs(face.mean(axis=0)[0] - touch))[:10]
    half = max(np.abs(np.concatenate(nearest)[:, 0] - touch).max(), 1e-9)
    for body in bodies:
        draw_cells(ax, body, 0.6, touch - 1.2 * half, touch + 1.2 * half)
        for surface in body.with_role("contact"):
            ax.add_collection(LineCollection(lines_of(surface, mirrors(scene)[:1]), colors=CONTACT, linewidths=2.5, zorder=5))
    marks.set_equal_limits(ax, (touch - 1.1 * half, -0.1 * half), (touch + 1.1 * half, 0.1 * half))
    ax.set_xlabel("r (mm)" if scene["model"]["is_axisymmetric"] else "x (mm)")
    ax.set_yticks([])
    ax.spines["left"].set_visible(False)
    ax.set_title(f"Mesh at the first touch; {scene['gap']['contact']['n_nodes']} contact nodes in all")
