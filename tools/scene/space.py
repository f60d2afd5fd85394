# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The bodies of a solid scene in space: what is computed with its mesh, the rest as an outline, surfaces, supports, loads."""
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import to_rgb

import marks
from labels import Labels
from loads import drawn_loads
from parts import CONTACT, CUT, GROUND, HELD, MESH, SUPPORT, edges_of, mirrors, normal_of

ELEVATION = 24  # degrees
LIGHT = np.array([-0.35, -0.5, 0.8]) / np.linalg.norm([-0.35, -0.5, 0.8])
FOLD = 0.85  # cosine of the angle between faces at whose edge a body has a line


class View:
    """A parallel projection: from a direction in which the cut faces of a half or a quarter are seen, x to the right."""

    def __init__(self, cut_at_x):
        azimuth, elevation = np.radians([-115 if cut_at_x else -62, ELEVATION])
        self.towards = np.array([np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth), np.sin(elevation)])
        self.right = np.array([-np.sin(azimuth), np.cos(azimuth), 0])
        self.up = np.cross(self.towards, self.right)

    def __call__(self, points):
        return np.asarray(points) @ np.stack([self.right, self.up], axis=1)

    def depth(self, points):
        return np.mean(np.asarray(points) @ self.towards)


class Painter:
    """Areas that hide each other by their distance from the reader."""

    def __init__(self, view):
        self.view, self.areas = view, []

    def add(self, points, colour, edge=None, hatched=False):
        normal = normal_of(points)
        size = np.linalg.norm(normal)
        if size == 0 or normal @ self.view.towards <= 1e-9 * size:
            return
        light = 0.78 + 0.22 * max(0.0, normal @ LIGHT / size)
        shade = tuple(light * part for part in to_rgb(colour))
        self.areas.append((self.view.depth(points), self.view(points), shade, edge or shade, hatched))

    def draw(self, ax, zorder):
        self.areas.sort(key=lambda area: area[0])
        ax.add_collection(PolyCollection([area[1] for area in self.areas], facecolors=[area[2] for area in self.areas],
                                         edgecolors=[area[3] for area in self.areas], linewidths=0.35, zorder=zorder))
        hatched = [area[1] for area in self.areas if area[4]]
        if hatched:
            ax.add_collection(PolyCollection(hatched, facecolors="none", edgecolors=SUPPORT, linewidths=0, hatch="////",
                                             zorder=3))


def colour_of(body, surface):
    if surface.has("contact"):
        return "#8fbfe0"
    if surface.has("held"):
        return "#9aa3ab"
    return CUT if surface.has("symmetry") else body.colour


def paint(painter, body):
    for surface in body.surfaces:
        for face in surface.faces:
            painter.add(face, colour_of(body, surface), MESH if body.has_mesh else None, surface.has("support"))


def outline(view, body):
    """Edges (pairs of points) between surfaces and at folds: those that are seen, and the others."""
    faces = [face for surface in body.surfaces for face in surface.faces]
    owner = [k for k, surface in enumerate(body.surfaces) for _ in surface.faces]
    normals = np.array([normal_of(face) for face in faces])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    seen, hidden = [], []
    for edge, of in edges_of(faces).items():
        if len({owner[k] for k in of}) < 2 and (len(of) < 2 or normals[of[0]] @ normals[of[1]] > FOLD):
            continue
        (seen if any(normals[k] @ view.towards > 1e-9 for k in of) else hidden).append(np.array(edge))
    return seen, hidden


def draw_outlines(ax, view, body, copies):
    seen, hidden = outline(view, body)
    ax.add_collection(LineCollection(view(seen), colors="0.2", linewidths=0.9, zorder=4))
    if len(copies) == 1:
        return
    # Of the part that symmetry adds, without what lies in the planes of symmetry.
    cut = [surface.points() for surface in body.with_role("symmetry")]
    in_cut = {tuple(point) for points in cut for point in np.round(points, 9)}
    edges = np.array([edge for edge in seen + hidden if not all(tuple(point) in in_cut for point in edge)])
    for copy in copies[1:]:
        ax.add_collection(LineCollection(view(edges * copy), colors="0.55", linewidths=0.7, linestyles=(0, (4, 3)), zorder=1))


def rim(faces):
    """The edges at which a surface ends."""
    return np.array([edge for edge, of in edges_of(faces).items() if len(of) == 1])


def draw_rims(ax, view, body):
    """Of the contact surface and the held face; what the body hides is thin and dashed."""
    seen = {tuple(map(tuple, edge)) for edge in np.round(outline(view, body)[0], 9)}
    for role, colour in (("contact", CONTACT), ("held", HELD)):
        for surface in body.with_role(role):
            edges = rim(surface.faces)
            is_seen = np.array([tuple(map(tuple, np.round(edge, 9))) in seen for edge in edges])
            ax.add_collection(LineCollection(view(edges[is_seen]), colors=colour, linewidths=2.2, zorder=5))
            ax.add_collection(LineCollection(view(edges[~is_seen]), colors=colour, linewidths=0.7, linestyles="--", zorder=5))


def draw_slab(ax, view, low, high, depth):
    """A block below z = 0 under the whole contact surface: the obstacle."""
    (a, b), (c, d) = low, high
    top = np.array([[a, b, 0], [c, b, 0], [c, d, 0], [a, d, 0]], dtype=float)
    painter = Painter(view)
    painter.add(top, GROUND)
    for k in range(4):
        first, last = top[k], top[(k + 1) % 4]
        painter.add(np.array([first, first - [0, 0, depth], last - [0, 0, depth], last]), GROUND)
    painter.draw(ax, 0.5)


def draw_ground(ax, view, scene, body, copies):
    """The obstacle, and on it the place of the contact surface. Returns its border."""
    places = np.concatenate([surface.points() * copy for surface in body.with_role("contact") for copy in copies])[:, :2]
    low, high = places.min(axis=0), places.max(axis=0)
    margin = 0.1 * (high - low).max()
    is_elastic = scene["obstacle"]["kind"] != "rigid"
    depth = (0.3 if is_elastic else 0.05) * (high - low).max()
    draw_slab(ax, view, low - margin, high + margin, depth)
    for number, copy in enumerate(copies):
        footprint = [(face * copy)[:, :2] for surface in body.with_role("contact") for face in surface.faces]
        flat = [view(np.column_stack([face, np.zeros(len(face))])) for face in footprint]
        ax.add_collection(PolyCollection(flat, facecolors=CONTACT, edgecolors="none", alpha=0.45 if number == 0 else 0.13,
                                         zorder=0.8))
    return np.array([[x, y, z] for x in (low[0] - margin, high[0] + margin) for y in (low[1] - margin, high[1] + margin)
                     for z in (0, -depth)])


def label_surfaces(labels, view, bodies):
    for body in bodies:
        for surface in body.surfaces:
            colour = {"contact": CONTACT, "held": HELD, "support": SUPPORT}.get((surface.roles or [""])[0], "0.35")
            middle = surface.middle()
            nearest = min(surface.faces, key=lambda face: np.linalg.norm(face.mean(axis=0) - middle))
            place = nearest.mean(axis=0)
            if surface.has("contact"):  # it is seen at its rim
                place = max(rim(surface.faces).mean(axis=1), key=lambda point: point @ (view.towards - 2 * view.up))
            labels.add(view(place), body.words_of(surface), colour)


def label_ground(labels, view, scene, corners):
    if scene["obstacle"]["kind"] != "body":
        words = scene["obstacle"]["text"].partition(";")[0] if scene["obstacle"]["kind"] != "rigid" else "rigid counterface"
        labels.add(view(max(corners, key=lambda point: point @ (view.right - 0.1 * view.up))), words, "0.35")


def draw(ax, scene, bodies):
    """All of it, on axes without marks, whose limits it sets."""
    copies = mirrors(scene)
    view = View(scene["model"]["mirrored"][0])
    painter, labels = Painter(view), Labels()
    corners = np.zeros((0, 3))
    normals = marks.normals_of(scene)
    if len(bodies) == 1 and normals is None:
        corners = draw_ground(ax, view, scene, bodies[0], copies)
    for body in bodies:
        paint(painter, body)
        draw_outlines(ax, view, body, copies)
        draw_rims(ax, view, body)
    painter.draw(ax, 2)
    points = np.concatenate([*(body.points() * copy for body in bodies for copy in copies), corners])
    size = np.ptp(points, axis=0).max()
    shapes = [view(points)]
    for load in drawn_loads(scene, bodies, 0.24 * size):
        shapes += marks.draw_load(ax, view, load, labels)
    label_surfaces(labels, view, bodies)
    if normals is None:
        label_ground(labels, view, scene, corners)
    else:
        shapes.append(marks.draw_normals(ax, view, normals, 0.08 * size, labels))
    marks.set_limits(ax, np.concatenate(shapes))
    marks.draw_axes_and_scale(ax, view, size, "xyz")
    labels.draw(ax)
