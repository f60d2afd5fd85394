# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What all parts of the picture of a scene share: colours, polygons of bodies and their edges, words."""
import textwrap

import numpy as np

BODY, LOWER, GROUND = "#c9dcec", "#e3d9c6", "#dcdcdc"
CONTACT, HELD, SUPPORT, LOAD, CUT = "#0072b2", "#222222", "#007a5a", "#c04a00", "#f3ead0"
MESH = "#5b6770"
MOST_LETTERS = 33  # of a line of a label


def wrapped(words, most=MOST_LETTERS):
    return "\n".join(textwrap.wrap(words, most, break_long_words=True))


def normal_of(points):
    """Of a polygon (n, 3), by Newell's sum; its length is twice the area."""
    return np.cross(points, np.roll(points, -1, axis=0)).sum(axis=0)


class Surface:
    """Faces of a body with a name and roles: contact, held, support, load, symmetry, axis."""

    def __init__(self, entry, lift):
        self.name, self.roles = entry["name"], entry["roles"]
        self.faces = [np.array(face) + [0, 0, lift] for face in entry["faces"]]

    def points(self):
        return np.concatenate(self.faces)

    def has(self, role):
        return role in self.roles

    def middle(self):
        points = self.points()
        return (points.min(axis=0) + points.max(axis=0)) / 2


class Body:
    """A body of the description, drawn `lift` mm above its place."""

    def __init__(self, entry, lift, is_lower):
        self.entry, self.lift, self.is_lower = entry, lift, is_lower
        self.surfaces = [Surface(surface, lift) for surface in entry["surfaces"]]
        self.cells = [np.array(cell) + [0, 0, lift] for cell in entry["cells"]]
        self.has_mesh = entry["has_own_mesh"]
        self.is_half_space = entry["is_half_space"]
        self.colour = LOWER if is_lower else BODY

    def points(self):
        return np.concatenate([surface.points() for surface in self.surfaces])

    def with_role(self, role):
        return [surface for surface in self.surfaces if surface.has(role)]

    def named(self, names):
        return [surface for surface in self.surfaces if surface.name in names]

    def words_of(self, surface):
        """What a label says of a surface, or "" where there is nothing to say."""
        whose = "lower " if self.is_lower else ""
        words = []
        if surface.has("contact"):
            words.append("contact surface")
        if surface.has("held"):
            if self.is_half_space:
                return "far field: moves as a rigid body"
            if self.entry["top_face"] == "guided":
                words.append("held along z, free sideways")
            else:
                words.append("held face, does not move" if self.is_lower else "held face, a rigid plate")
        for support in self.entry["supports"]:
            if support["surface"] == surface.name and surface.has("support"):
                axes = " ".join(axis for axis, held in zip("xyz", support["directions"]) if held)
                words.append(f"support, held along {axes}")
        if surface.has("symmetry") and not self.is_lower:
            words.append("plane of symmetry")
        if not words:
            return ""
        return f"{whose}{surface.name}: {'; '.join(words)}" if surface.name else f"{whose}{'; '.join(words)}"


def edges_of(faces):
    """Every edge (points as tuples, in either order) with the numbers of the faces that have it."""
    found = {}
    for number, face in enumerate(faces):
        places = [tuple(point) for point in np.round(face, 9)]
        for first, last in zip(places, [*places[1:], places[0]]):
            found.setdefault((min(first, last), max(first, last)), []).append(number)
    return found


def mirrors(scene):
    """Factors of (x, y) by which the copies of the model follow from it, itself first."""
    along_x, along_y = scene["model"]["mirrored"]
    if scene["model"]["is_axisymmetric"]:
        along_x = True
    return [np.array([a, b, 1]) for b in ((1, -1) if along_y else (1,)) for a in ((1, -1) if along_x else (1,))]


def round_length(length):
    """The largest of 1, 2, 5, 10, ... that is no longer."""
    power = 10 ** np.floor(np.log10(length))
    return next(step * power for step in (5, 2, 1) if step * power <= length * (1 + 1e-9))
