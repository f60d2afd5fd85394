# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The contact surface from above with its mesh, and the gap along a line through the first touch, drawn larger."""
import numpy as np
from matplotlib.collections import PolyCollection

import marks
from parts import BODY, CONTACT, GROUND, LOWER, MESH, mirrors

FLAT = 1e-12  # mm: no gap
ROUNDING = 1e-3  # in triangles: a line along a curved border stays inside


class Surface:
    """The contact surface of a body from above, with the height of its nodes over z = 0, or their depth below it."""

    def __init__(self, entry, copies):
        places = np.array(entry["nodes"], dtype=float)
        self.n_side = entry["degree"] + 1
        self.faces = [np.array(face) for face in entry["faces"]]
        self.places = np.concatenate([places * copy for copy in copies])
        self.n, self.copies = len(places), len(copies)

    def quads(self):
        """Corners of the parts of the faces between nodes, (m, 4): of the model and then of its copies."""
        k = self.n_side
        corner = np.array([[j * k + i, j * k + i + 1, (j + 1) * k + i + 1, (j + 1) * k + i] for j in range(k - 1)
                           for i in range(k - 1)])
        own = np.concatenate([face[corner] for face in self.faces])
        return np.concatenate([own + copy * self.n for copy in range(self.copies)])

    def is_line(self):
        return len(self.faces[0]) == self.n_side

    def heights(self, x, y):
        """At places on the surface; NaN elsewhere."""
        if self.is_line():
            order = np.argsort(self.places[:, 0])
            return np.interp(x, *self.places[order][:, [0, 2]].T, left=np.nan, right=np.nan)
        quads = self.quads()
        triangles = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
        first, second, third = (self.places[triangles[:, k]] for k in range(3))
        return np.array([height_at(place, first, second, third) for place in zip(x, y)])


def cross(a, b):
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]


def height_at(place, first, second, third):
    """In the triangle, of many (m, 3), in which the place lies; NaN where it lies in none."""
    area = cross(second - first, third - first)
    with np.errstate(divide="ignore", invalid="ignore"):
        to_second = cross(place - first[:, :2], third - first) / area
        to_third = cross(second - first, place - first[:, :2]) / area
    outside = np.maximum(np.maximum(-to_second, -to_third), to_second + to_third - 1)
    outside = np.where(np.isfinite(outside), outside, np.inf)
    k = int(np.argmin(outside))
    if outside[k] > ROUNDING:
        return np.nan
    return float(first[k, 2] + to_second[k] * (second - first)[k, 2] + to_third[k] * (third - first)[k, 2])


class Profile:
    """The surfaces along a line through the first touch: heights of the body, of the counterface, and the nodes there."""

    def __init__(self, scene, line):
        gap, copies = scene["gap"], mirrors(scene)
        self.name, self.at = line["axis"], np.array(line["at"], dtype=float)
        axis = "xy".index(self.name)
        places = np.tile(np.array(gap["touch"], dtype=float), (len(self.at), 1))
        places[:, axis] = self.at
        upper, own = Surface(gap["contact"], copies), np.array([1, 1, 1])
        in_model = np.where(np.min(copies, axis=0)[:2] < 0, np.abs(places), places)
        self.upper = Surface(gap["contact"], [own]).heights(*in_model.T)
        self.lower = -np.array(line["gaps"], dtype=float)
        if gap["lower"]:
            self.lower = self.lower - Surface(gap["lower"], [own]).heights(*in_model.T)
        extent = np.ptp(upper.places[:, :2])
        on_line = np.abs(upper.places[:, 1 - axis] - gap["touch"][1 - axis]) < 1e-6 * extent
        self.nodes = upper.places[on_line][:, [axis, 2]]

    def gaps(self):
        return self.upper - self.lower

    def is_flat(self):
        return not np.nanmax(np.abs(self.gaps())) > FLAT


def profiles(scene):
    """The line with the gap that is worth a picture; one of both where they are alike. None without a gap."""
    found = [Profile(scene, line) for line in scene["gap"]["lines"]]
    found = [one for one in found if not one.is_flat()]
    if len(found) == 2 and np.allclose(found[0].gaps(), found[1].gaps(), rtol=1e-6, atol=FLAT, equal_nan=True):
        found[0].name = "x and y"
        found.pop()
    return found


def unit_of_gap(largest):
    return ("mm", 1.0) if largest >= 0.1 else ("µm", 1e3)


def draw_gap(ax, scene, bodies, found):
    """The section of both surfaces; of two lines the second one is dashed."""
    one = found[0]
    unit, factor = unit_of_gap(max(np.nanmax(np.abs(line.gaps())) for line in found))
    upper, lower = factor * one.upper, factor * one.lower
    high = np.nanmax(np.concatenate([upper, lower]))
    low = np.nanmin(np.concatenate([upper, lower]))
    margin = 0.25 * max(high - low, 1e-12)
    ax.fill_between(one.at, upper, high + margin, color=BODY, linewidth=0)
    ax.fill_between(one.at, lower, low - margin, color=LOWER if len(bodies) > 1 else GROUND, linewidth=0)
    ax.plot(one.at, upper, color=CONTACT, linewidth=1.6)
    ax.plot(one.at, lower, color="0.25", linewidth=1.6)
    for line in found[1:]:
        ax.plot(line.at, factor * line.upper, color=CONTACT, linewidth=1, linestyle="--")
        ax.plot(line.at, factor * line.lower, color="0.25", linewidth=1, linestyle="--", label=f"along {line.name}")
        ax.legend(frameon=False, fontsize=8, loc="upper center")
    if bodies[0].has_mesh:
        ax.plot(one.nodes[:, 0], factor * one.nodes[:, 1], color=CONTACT, marker="|", markersize=7, linestyle="none")
    ax.margins(x=0)
    ax.set_ylim(low - margin, high + margin)
    box = ax.get_window_extent()
    scale = (box.height / (high - low + 2 * margin) * factor) / (box.width / np.ptp(one.at))
    marks = "; strokes: contact nodes" if bodies[0].has_mesh else ""
    ax.set_xlabel(("r" if scene["model"]["is_axisymmetric"] else one.name[0]) + " (mm)" + marks)
    ax.set_ylabel(f"z ({unit})")
    ax.set_title(f"Gap along {one.name}: heights {rounded(scale)}")


def rounded(scale):
    """A factor in words, with two digits."""
    if scale < 1.5:
        return f"{scale:.2g} times as large as widths"
    return f"drawn {float(f'{scale:.2g}'):.15g} times larger"


# --- from above ---

def draw_from_above(ax, scene, bodies):
    surface = Surface(scene["gap"]["contact"], mirrors(scene))
    quads = surface.quads()
    n_own = len(quads) // surface.copies
    shapes = surface.places[quads][..., :2]
    ax.add_collection(PolyCollection(shapes[n_own:], facecolors="#eef2f5", edgecolors="0.8", linewidths=0.3))
    ax.add_collection(PolyCollection(shapes[:n_own], facecolors="#bcd9ee", edgecolors=MESH if bodies[0].has_mesh else "#bcd9ee",
                                     linewidths=0.35))
    low, high = surface.places[:, :2].min(axis=0), surface.places[:, :2].max(axis=0)
    reach = 0.56 * max(high - low)
    middle = (low + high) / 2
    angle = np.radians(scene["friction"]["angle"])
    if scene["friction"]["mu"] and scene["friction"]["forces_against_slip"]:
        for k, name in enumerate(("1", "2")):
            along = np.array([np.cos(angle + k * np.pi / 2), np.sin(angle + k * np.pi / 2)])
            ax.plot(*np.stack([middle - reach * along, middle + reach * along]).T, color="0.25", linewidth=0.8,
                    linestyle="-" if k == 0 else "--")
            ax.text(*(middle + 1.07 * reach * along), name, ha="center", va="center", fontsize=8.5)
    if not scene["obstacle"]["is_plane"]:
        ax.plot(*scene["gap"]["touch"], marker="x", color="#c04a00", markersize=7, markeredgewidth=1.6)
    marks.set_equal_limits(ax, middle - 1.16 * reach, middle + 1.16 * reach)
    ax.set_xlabel("x (mm)")
    ax.set_ylabel("y (mm)")
    count = f": {scene['gap']['contact']['n_nodes']} nodes" if bodies[0].has_mesh else ""
    touch = "; x first touch" if not scene["obstacle"]["is_plane"] else ""
    ax.set_title(f"Contact surface from above{count}{touch}")
