# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Supports and loads of the drawings from the side: strokes and arrows on the faces of cylinders and boxes, and words."""
import re

import svg
from drawing import LETTER, WIDTH

LOAD = re.compile(r"\s*(?P<name>[\w-]+)\s*:\s*(?P<kind>\w+)(?:\s+on(?P<lower>\s+lower)?\s*(?P<surfaces>.*?))?"
                  r"(?:\s+along\s+(?P<along>.*?))?\s*$")
UNITS = {"pressure": "MPa", "traction": "MPa", "motion": "mm", "force": "N", "temperature": "K"}
ARROW, N_ARROWS = 24, 3


class Load:
    """A load of the entry Loads, with the largest value that the program gives to it."""

    def __init__(self, found, text, value):
        self.kind, self.is_on_lower = found["kind"], bool(found["lower"])
        self.surfaces, self.along = (found["surfaces"] or "").split(), found["along"]
        self.value = value
        self.words = f"{text}, {svg.signed(value)} {UNITS.get(self.kind, '')}".rstrip()


def loads_of(data):
    largest = data.program.largest_loads()
    found = [(LOAD.match(text), " ".join(text.split())) for text in data.parameters["Load program"].get("Loads", "").split(";")]
    return [Load(match, text, largest.get(match["name"], 0)) for match, text in found if match]


def supports_of(data, section="Geometry"):
    """{surface: directions} of an entry Supports."""
    entries = [text.split(":") for text in data.parameters.get(section, {}).get("Supports", "").split(";") if ":" in text]
    return {" ".join(name.split()): " ".join(axes.split()) for name, axes in entries}


def words_of(data):
    """A line for each support and load."""
    lines = [f"{whose}support {name}: {axes}" for whose, section in (("", "Geometry"), ("lower ", "Lower geometry"))
             if not whose or data.has_lower for name, axes in supports_of(data, section).items()]
    return lines + [f"load {load.words}" for load in loads_of(data)]


def list_below(data, y):
    """The lines as text from the height y on, and the height behind them."""
    out = ""
    for words in words_of(data):
        most = int(WIDTH / LETTER)
        y += 15
        out += svg.text((WIDTH / 2, y), words if len(words) <= most else words[:most - 1] + "\u2026", "small")
    return out, y


class Sides:
    """The faces of a cylinder or a box between two corners in the picture; `up` is -1 where its top is below."""

    def __init__(self, corner, other, up=1):
        (self.left, self.right), (self.high, self.low) = sorted((corner[0], other[0])), sorted((corner[1], other[1]))
        self.up = up

    def ends(self, surface):
        """Both ends of the face, and its normal (to the right, up); several for the side of a cylinder."""
        left, right = (((x, self.high), (x, self.low), (out, 0)) for x, out in ((self.left, -1), (self.right, 1)))
        top = ((self.left, self.high if self.up > 0 else self.low), (self.right, self.high if self.up > 0 else self.low),
               (0, self.up))
        return {"x-": [left], "x+": [right], "side": [left, right], "top": [top]}.get(surface, [])


def support(sides, surface):
    out = ""
    for (x, y), (x1, y1), (right, up) in sides.ends(surface):
        out += svg.line((x, y), (x1, y1), "plate")
        for k in range(1, 9):
            at = (x + (x1 - x) * k / 8, y + (y1 - y) * k / 8)
            out += svg.line(at, (at[0] + 7 * right + (5 if up else 0), at[1] - 7 * up + (0 if up else 5)), "hatch")
    return out


def direction(load, normal):
    """Of the arrows of a load, to the right and up; nothing for one that goes into the picture."""
    sign = -1 if load.value < 0 else 1
    if load.kind == "pressure":
        return -sign * normal[0], -sign * normal[1]
    axis = {"x": (1, 0), "-x": (-1, 0), "z": (0, 1), "-z": (0, -1)}.get(load.along)
    return axis and (sign * axis[0], sign * axis[1])


def arrows(sides, load):
    out = ""
    for surface in load.surfaces:
        for (x, y), (x1, y1), normal in sides.ends(surface):
            along = direction(load, normal)
            for k in range(1, N_ARROWS + 1) if along else ():
                share = k / (N_ARROWS + 1)
                at = (x + (x1 - x) * share + 4 * normal[0], y + (y1 - y) * share - 4 * normal[1])
                tip = (at[0] + ARROW * along[0], at[1] - ARROW * along[1])
                if along[0] * normal[0] + along[1] * normal[1] < 0:  # it ends at the face
                    at, tip = (at[0] - ARROW * along[0], at[1] + ARROW * along[1]), at
                out += svg.arrow(at, tip, "load", head=9)
    return out


def marks(data, sides, is_lower=False):
    """Supports and loads of one body."""
    section = "Lower geometry" if is_lower else "Geometry"
    out = "".join(support(sides, surface) for surface in supports_of(data, section))
    return out + "".join(arrows(sides, load) for load in loads_of(data) if load.is_on_lower == is_lower)
