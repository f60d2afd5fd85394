# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Maps of fields on the contact surface: contours of nodal values, and the status node by node."""
import matplotlib.pyplot as plt
import matplotlib.tri as mtri
import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.patches import Patch
from matplotlib.ticker import MaxNLocator

import docs_page
import run_folder

# Every kind of colour vision distinguishes them, and so does print in grey.
STATUS_COLOURS = {run_folder.OPEN: "#ffffff", run_folder.STICK: "#2f5d8c", run_folder.SLIP: "#f0b04a"}
STATUS_NAMES = {run_folder.OPEN: "open", run_folder.STICK: "stick", run_folder.SLIP: "slip"}
LINES = ("#0072b2", "#d55e00", "#009e73", "#555555")


class Surface:
    """The contact surface at one step: nodes, and quadrilaterals between them."""

    def __init__(self, run, step):
        contact = run.contact(step)
        self.points = contact.points[:, :2]
        self._data = contact.data
        self.quadrilaterals = contact.quadrilaterals()
        self.corners = contact.cells[:, :4]

    def __getitem__(self, name):
        return self._data[name]

    @property
    def nodal_force(self):
        """R_n, the normal component of the plane's force on the body (N)."""
        return self["nodal_force"][:, 2]

    def triangulation(self):
        """Four triangles a quadrilateral, about its centre: what is symmetric stays so. See with_centres()."""
        centres = len(self.points) + np.arange(len(self.quadrilaterals))
        sides = [np.stack([self.quadrilaterals[:, i], self.quadrilaterals[:, (i + 1) % 4], centres], axis=1)
                 for i in range(4)]
        return mtri.Triangulation(*self.with_centres(self.points).T, np.concatenate(sides))

    def with_centres(self, values):
        """Nodal values, and after them those at the centres of the quadrilaterals (bilinear interpolation)."""
        return np.concatenate([values, values[self.quadrilaterals].mean(axis=1)])

    def radius(self):
        return np.hypot(*self.points.T)

    def cells_at_node(self):
        """How many cells have this node as a corner."""
        return np.bincount(self.corners.ravel(), minlength=len(self.points))

    def corner_nodes(self):
        """The corners of the o-grid's core: nodes inside the disc where three cells meet, not four."""
        return (self.cells_at_node() == 3) & (self.radius() < 0.95 * self.radius().max())

    def extent(self, status):
        """Largest |x| and |y| of the nodes with this status."""
        nodes = self.points[self["status"] == status]
        return np.abs(nodes).max(axis=0) if len(nodes) else np.zeros(2)


def frame(ax, radius=10):
    """A map without ticks, with the rim as a circle."""
    ax.add_patch(plt.Circle((0, 0), radius, fill=False, color="0.3", linewidth=0.6))
    ax.set_aspect("equal")
    ax.set_xlim(-1.04 * radius, 1.04 * radius)
    ax.set_ylim(-1.04 * radius, 1.04 * radius)
    ax.set_xticks([])
    ax.set_yticks([])
    ax.set_frame_on(False)


def axes_cross(ax, radius=10):
    """The directions x and y at the lower left, and a bar of half the radius (mm) at the lower right."""
    start, length = (-radius, -radius), 0.25 * radius
    for end, text in (((length, 0), "x"), ((0, length), "y")):
        ax.annotate("", xytext=start, xy=np.add(start, end), arrowprops={"arrowstyle": "->", "linewidth": 0.7})
        ax.text(*np.add(start, np.multiply(end, 1.3)), text, fontsize=8, ha="center", va="center")
    ax.plot([0.5 * radius, radius], [-radius, -radius], color="black", linewidth=1.2, solid_capstyle="butt")
    ax.text(0.75 * radius, -0.97 * radius, f"{0.5 * radius:g} mm", fontsize=8, ha="center", va="bottom")


def scale_bar(ax, length, radius=10):
    """A bar of this length (mm) below a map that is too small for a bar within it."""
    ax.plot([-0.5 * length, 0.5 * length], [-1.2 * radius] * 2, color="black", linewidth=1.2, solid_capstyle="butt", clip_on=False)
    ax.text(0, -1.27 * radius, f"{length:g} mm", fontsize=8, ha="center", va="top")


def contours(ax, surface, values, levels, cmap, colour="black"):
    """Filled contours with lines; what lies outside the levels has the colours at the ends of the map."""
    triangulation, values = surface.triangulation(), surface.with_centres(values)
    extend = {(True, True): "both", (True, False): "min", (False, True): "max", (False, False): "neither"}
    shown = ax.tricontourf(triangulation, values, levels=levels, cmap=cmap, zorder=1,
                           extend=extend[bool(values.min() < levels[0]), bool(values.max() > levels[-1])])
    ax.tricontour(triangulation, values, levels=levels, colors=colour, linewidths=0.4, zorder=1.1)
    frame(ax)
    return shown


def status_map(ax, surface):
    """The status of each node on its share of the surface: a quarter of every quadrilateral that it belongs to."""
    corners = surface.points[surface.quadrilaterals]  # quadrilateral, corner, x or y
    centre = corners.mean(axis=1)
    shares, statuses = [], []
    for i in range(4):
        own, following, previous = corners[:, i], corners[:, (i + 1) % 4], corners[:, i - 1]
        shares.append(np.stack([own, (own + following) / 2, centre, (own + previous) / 2], axis=1))
        statuses.append(surface["status"][surface.quadrilaterals[:, i]])
    colours = [STATUS_COLOURS[int(status)] for status in np.concatenate(statuses)]
    # Without antialiasing no seams show between neighbours.
    ax.add_collection(PolyCollection(np.concatenate(shares), facecolors=colours, linewidths=0, antialiaseds=False))
    frame(ax)


def status_legend(figure, *more, statuses=tuple(STATUS_NAMES)):
    """A line below the axes that explains the colours of the statuses, and `more` handles."""
    handles = [Patch(facecolor=STATUS_COLOURS[status], edgecolor="0.3", label=STATUS_NAMES[status]) for status in statuses]
    handles += more
    docs_page.legend_below(figure, handles, [handle.get_label() for handle in handles], 4)


def levels_of(low, high, count=12):
    """Round levels from one below `low` to one above `high`."""
    return MaxNLocator(count, steps=(1, 2, 5, 10)).tick_values(low, high)


def scale(figure, shown, ax, label, levels, place="bottom"):
    """A scale with round numbers."""
    bar = figure.colorbar(shown, ax=ax, label=label, location=place, shrink=0.9, aspect=18)
    bar.set_ticks([tick for tick in levels_of(levels[0], levels[-1], 4) if levels[0] <= tick <= levels[-1]])


def filled(figure, ax, surface, values, levels, label, colours="viridis", line="white"):
    """Contours with their scale below."""
    shown = contours(ax, surface, values, levels, colours, line)
    scale(figure, shown, ax, label, levels)
    axes_cross(ax)
