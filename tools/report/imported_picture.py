# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Drawing of an imported body from the side: its cells, the contact surface, what it rests on, and how it is driven."""
import numpy as np
import svg
from drawing import HEIGHT, WIDTH, Frame, counterface, ground, load_words, two_parts
from imported_body import border_of
from surface_picture import list_below

MOST_FACES = 3000
LENGTH = 38  # of an arrow


def path_of(frame, lines, css, closed=False):
    path = "".join("M" + "L".join(f"{svg.number(a)} {svg.number(b)}" for a, b in frame.all(line))
                   + ("Z" if closed else "") for line in lines)
    return svg.element("path", d=path, css=css)


def lines_of(body, points):
    return [line for side in body.seen(points) for line in side]


def cells(body, frame):
    """Areas, lines of the mesh where they can be distinguished, and the rim."""
    if len(body.faces) > MOST_FACES:
        return path_of(frame, lines_of(body, body.rim()), "rim")
    faces = lines_of(body, body.faces)
    return (path_of(frame, faces, "side", closed=True) + path_of(frame, faces, "mesh", closed=True)
            + path_of(frame, lines_of(body, body.rim()), "rim"))


def drive(data, body, frame):
    """Arrows at the held surface, along the largest motion and the largest force, and what the legs state."""
    largest, out = data.program.extremes(), ""
    if not len(body.held):
        return out
    middle, outward = body.held_middle()
    x, y = frame(*middle)
    for kind in "uF":
        direction = np.array([largest.get(f"{kind}{axis}", 0) for axis in "xz"])
        if not direction.any():
            continue
        right, up = direction / np.hypot(*direction)
        ends = [(x + 5 * s * right, y - 5 * s * up) for s in (1, 1 + LENGTH / 5)]
        if direction @ outward < 0:  # pressed from outside
            ends = [(x - s * right, y + s * up) for s in (LENGTH + 5, 5)]
        out += svg.arrow(*ends, "load", head=11)
    for k, words in enumerate(load_words(largest).values()):
        out += svg.text((4, 14 + 14 * k), words, "label", "start")
    return out


def plane_below(data, body, frame):
    low, high = body.box()
    touching = body.seen(np.unique(body.contact))[..., 0]
    # Elsewhere the body may be where the plane is not.
    beyond = 30 / frame.scale if low[1] > -1e-6 * (high[1] - low[1]) else 0
    return ground(data, frame(touching.min() - beyond, 0), frame(touching.max() + beyond, 0))


def imported_view(data, body, below):
    """`below` is a second body of lower_picture.py, or None."""
    low, high = body.box()
    size = f"{high[0] - low[0]:.4g} mm x {high[1] - low[1]:.4g} mm"
    if below:
        low, high = np.minimum(low, below.low), np.maximum(high, below.high)
    frame = Frame(min(235 / (high[0] - low[0]), 195 / (high[1] - low[1])), (WIDTH / 2, HEIGHT / 2 + 2), (low + high) / 2)
    out = below.drawing(frame) if below else plane_below(data, body, frame)
    out += cells(body, frame)
    out += path_of(frame, lines_of(body, body.contact), "touching", closed=True)
    out += path_of(frame, lines_of(body, border_of(body.held)), "plate", closed=True)
    out += drive(data, body, frame)
    out += two_parts(WIDTH / 2, HEIGHT - 34, size, counterface(data))
    out += svg.text((WIDTH / 2, HEIGHT - 4), "blue: contact surface; dark: held surface; arrows: the largest", "small")
    listed, height = list_below(data, HEIGHT - 4)
    return svg.picture(WIDTH, height + 4, out + listed, "The body from the side, with mesh, contact surface, counterface and motion of the held face")
