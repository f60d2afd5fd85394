# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Where loads act: arrows in space from the drive of a description, with what their labels say."""
import numpy as np

MOST_ARROWS = 7  # of a load on a surface
AXES = np.eye(3)


class Arrow:
    """From `start` to `end`; `is_double` where the load goes to both signs. `anchor` is where its label points to."""

    def __init__(self, start, end, is_double):
        self.start, self.end, self.is_double = start, end, is_double


class DrawnLoad:
    def __init__(self, words, anchor, arrows=(), arc=None, is_dot=False):
        self.words, self.anchor, self.arrows = words, anchor, list(arrows)
        self.arc = arc  # points of a turn, the last one with the head
        self.is_dot = is_dot  # an arrow that points at the reader


def far_places(points, n):
    """At most n of the points (m, 3), each as far as possible from those before it; the first is nearest to the middle."""
    chosen = [int(np.argmin(np.linalg.norm(points - (points.min(axis=0) + points.max(axis=0)) / 2, axis=1)))]
    distance = np.linalg.norm(points - points[chosen[0]], axis=1)
    while len(chosen) < min(n, len(points)):
        chosen.append(int(np.argmax(distance)))
        distance = np.minimum(distance, np.linalg.norm(points - points[chosen[-1]], axis=1))
    return chosen


def sign_of(one):
    return -1 if -one["least"] > one["largest"] else 1


def is_double(one):
    return one["least"] < 0 < one["largest"]


def turn(centre, axis, radius, sign):
    """Points of three quarters of a circle about an axis (0 to 2) through the centre."""
    angles = np.radians(np.linspace(-60, 210, 50)) * sign
    first, second = AXES[(axis + 1) % 3], AXES[(axis + 2) % 3]
    return centre + radius * (np.cos(angles)[:, None] * first + np.sin(angles)[:, None] * second)


def of_held_face(one, centre, half, normal, length):
    """A component of the held face, whose half widths along x, y, z are `half` and which looks along `normal`."""
    axis, sign = one["number"] % 3, sign_of(one)
    words = f"{one['name']} = {one['text']}"
    if one["least"] == one["largest"] == 0:
        return DrawnLoad(f"{words}: free along {'xyz'[axis]}", centre)
    if one["number"] >= 3:
        points = turn(centre + 0.3 * length * normal, axis, max(0.5 * half.max(), 0.5 * length), sign)
        return DrawnLoad(words, points[len(points) // 4], arc=points)
    if abs(normal[axis]) > 0.3:  # outside of the face: towards it or away from it
        out = np.sign(normal[axis]) * AXES[axis]
        near, far = centre + 0.08 * length * out, centre + 1.1 * length * out
        ends = (near, far) if sign * out[axis] > 0 else (far, near)
        return DrawnLoad(words, (near + 2 * far) / 3, [Arrow(*ends, is_double(one))])
    start = centre + sign * (half[axis] + 0.1 * length) * AXES[axis]
    end = start + sign * length * AXES[axis]
    return DrawnLoad(words, (start + end) / 2, [Arrow(start, end, is_double(one))])


def of_surfaces(one, surfaces, inside, length):
    """A load on surfaces of a body; `inside` is a point in it, from which normals look away."""
    words = one["words"] + ", " + one["text"]
    faces = [face for surface in surfaces for face in surface.faces]
    middles = np.array([face.mean(axis=0) for face in faces])
    arrows = []
    for k in far_places(middles, MOST_ARROWS):
        normal = outward(faces[k], inside)
        along = np.array(one["direction"]) if one["is_along"] else -normal
        along = along * sign_of(one)
        offset = 0.06 * length * normal
        # Where it points into the body the arrow ends at the surface.
        start = middles[k] + offset - (0.8 * length * along if along @ normal < -0.1 else 0)
        arrows.append(Arrow(start, start + 0.8 * length * along * (0.94 if along @ normal < -0.1 else 1), is_double(one)))
    return DrawnLoad(words, (arrows[0].start + arrows[0].end) / 2, arrows)


def outward(face, inside):
    """Of a polygon, or of a line of a section in the plane y = 0."""
    if len(face) > 3:
        normal = np.cross(face, np.roll(face, -1, axis=0)).sum(axis=0)
    else:
        along = face[-1] - face[0]
        normal = np.array([along[2], 0, -along[0]])
        normal = normal if normal @ (face.mean(axis=0) - inside) >= 0 else -normal
    return normal / np.linalg.norm(normal)


def of_face(one, body, inside, length):
    """A component of the held face of a body, or of the top of one that nothing holds."""
    held = body.with_role("held")
    centre = np.array(body.entry["held_centre"]) + [0, 0, body.lift]
    if not held:
        return of_held_face(one, centre, np.zeros(3), AXES[2], length)
    half = np.abs(held[0].points() - centre).max(axis=0)
    normal = sum(outward(face, inside) for face in held[0].faces)
    return of_held_face(one, centre, half, normal / max(np.linalg.norm(normal), 1e-9), length)


def drawn_loads(scene, bodies, length):
    """Of everything that drives the scene. `length` (mm) is that of a long arrow."""
    found = []
    for one in scene["drive"]:
        body = bodies[1 if one.get("is_on_lower") and len(bodies) > 1 else 0]
        points = body.points()
        middle = (points.min(axis=0) + points.max(axis=0)) / 2
        if one["number"] < 6:
            found.append(of_face(one, body, middle, length))
        elif one["surfaces"]:
            found.append(of_surfaces(one, body.named(one["surfaces"]), middle, length))
        else:
            found.append(DrawnLoad(f"{one['words']}, {one['text']}" + (": of the whole body" if one["kind"] != "interference" else ""), middle))
    return found
