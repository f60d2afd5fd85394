# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Drawing of the second elastic body from the side: as the mirror image about z = 0 of the body that its sections give, or
in its place beside a surface with normals of its own."""
import numpy as np
import svg
from drawing import hatched, inside
from imported_body import border_of
from imported_picture import cells, lines_of, path_of


class Below:
    """What is drawn between the corners `low` and `high`, in x and z (mm)."""

    def __init__(self, low, high):
        self.low, self.high = np.array(low), np.array(high)

    def drawing(self, frame):
        x, y = frame(*((self.low + self.high) / 2))
        return self.shape(frame) + svg.text((x, y + 4), "lower body", "label halo")

    def height_beside(self, frame, x):
        """In words, to the right of x (pixels)."""
        y = frame(0, 0.62 * self.low[1] + 0.38 * self.high[1])[1]  # between arrows of loads
        return inside((x, y + 4), f"H = {self.high[1] - self.low[1]:.5g} mm", "label", "start")


class Block(Below):
    """A cylinder or a box."""

    def __init__(self, width, height):
        super().__init__((-width / 2, -height), (width / 2, 0))

    def shape(self, frame):
        (left, bottom), (right, top) = frame(*self.low), frame(*self.high)
        return (svg.element("rect", x=left, y=top, width=right - left, height=bottom - top, css="disc")
                + hatched((left, bottom), (right, bottom), "plate"))


class FromFile(Below):
    """The body of a mesh file, which may be in its place."""

    def __init__(self, body, is_in_place):
        self.body, self.is_in_place = body, is_in_place
        (left, low), (right, high) = body.box()
        super().__init__(*(((left, low), (right, high)) if is_in_place else ((left, -high), (right, -low))))

    def shape(self, frame):
        turned = frame if self.is_in_place else frame.upside_down()
        return (cells(self.body, turned)
                + path_of(turned, lines_of(self.body, self.body.contact), "touching", closed=True)
                + path_of(turned, lines_of(self.body, border_of(self.body.held)), "plate", closed=True))


def lower_of(data):
    """The second body of the scene; None where there is none, or where its mesh file is gone."""
    if not data.has_lower:
        return None
    entries = data.parameters["Lower geometry"]
    if entries["Shape"] == "file":
        is_in_place = data.parameters["Obstacle"].get("Normal") == "surface"
        return FromFile(data.lower_body, is_in_place) if data.lower_body else None
    if entries["Shape"] == "box":
        sizes = [float(size) for size in entries["Sizes"].split(",")]
        return Block(sizes[0], sizes[2])
    return Block(2 * float(entries["Radius"]), float(entries["Height"]))
