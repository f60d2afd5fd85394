# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What the drawings of the model have in common."""
import numpy as np
import svg
from load_program import UNITS

WIDTH, HEIGHT = 360, 330
LETTER = 6.8  # width of a letter of a label, about
MOST_LETTERS = 24
LAWS = {"rosette": "measured friction", "superellipse": "superelliptic friction"}


class Frame:
    """Millimetres to the picture: y points up, and `origin` is where the middle of the picture is. With `up` = -1 it
    shows mirror images about y = 0."""

    def __init__(self, scale, middle=(WIDTH / 2, HEIGHT / 2), origin=(0, 0), up=1):
        self.scale, self.middle, self.origin, self.up = scale, middle, origin, up

    def __call__(self, x, y):
        return (self.middle[0] + self.scale * (x - self.origin[0]),
                self.middle[1] - self.scale * (self.up * y - self.origin[1]))

    def upside_down(self):
        return Frame(self.scale, self.middle, self.origin, -self.up)

    def all(self, points):
        return [self(x, y) for x, y in points]


def area_of(frame, polygons, css):
    """Between polygons, one of which may be a hole in another."""
    path = "".join("M" + "L".join(f"{svg.number(a)} {svg.number(b)}" for a, b in frame.all(polygon)) + "Z"
                   for polygon in polygons if len(polygon))
    return svg.element("path", d=path, css=css, fill_rule="evenodd")


def hatched(start, end, css, down=True):
    """A line with strokes on the side of the rigid body."""
    step, depth = 9, 8 if down else -8
    strokes = "".join(svg.line((x, start[1]), (x - 7, start[1] + depth), "hatch")
                      for x in np.arange(start[0] + 7, end[0] + 1, step))
    return svg.line(start, end, css) + strokes


def shortened(name):
    return name if len(name) <= MOST_LETTERS else name[:MOST_LETTERS - 1] + "\u2026"


def fits(words):
    return LETTER * len(words) <= WIDTH


def inside(place, words, css, anchor="middle"):
    """A text that is moved sideways as far as it would be cut off at the border of the picture."""
    width, (x, y) = LETTER * len(words), place
    left = x - {"start": 0, "middle": width / 2, "end": width}[anchor]
    return svg.text((x - max(0, left + width - WIDTH) + max(0, -left), y), words, css, anchor)


def two_parts(x, y, first, second):
    """Two parts of a label: in one line, or in two where one would be too long."""
    if fits(f"{first}; {second}"):
        return inside((x, y), f"{first}; {second}", "label")
    return inside((x, y), first, "label") + inside((x, y + 14), second, "label")


def load_words(largest):
    return {name: f"{name[0]}_{name[1]} = {svg.signed(value)} {UNITS[name]}" for name, value in largest.items()}


def ground(data, start, end):
    """The plane, or the half-space, that the body rests on."""
    if data.counterface != "half-space":
        return hatched(start, end, "plate")
    return (svg.element("rect", x=start[0], y=start[1], width=end[0] - start[0], height=11, css="side")
            + svg.line(start, end, "rim"))


def counterface(data):
    """What the body rests on, in words."""
    kind = {"half-space": "elastic half-space", "body": "elastic body"}.get(data.counterface, "rigid")
    friction = LAWS.get(data.law, data.law) if data.mu is None else "\u03bc varies" if data.friction_varies else f"\u03bc = ({data.mu[0]:g}, {data.mu[1]:g})"
    return f"{kind + ', with a gap' if data.has_gap else kind + ' plane' if kind == 'rigid' else kind}, {friction}"
