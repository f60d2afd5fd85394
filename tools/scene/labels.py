# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Labels beside a drawing, each with a line to what it names: a column on the left and one on the right."""
from parts import wrapped

LINE, PAUSE = 0.036, 0.018  # heights in parts of the axes
CORNER = 0.27  # of the height, on the left: axes and scale are there


class Labels:
    def __init__(self):
        self.all = []

    def add(self, anchor, words, colour):
        """`anchor` is a point of the drawing."""
        if words:
            self.all.append((tuple(anchor), wrapped(words), colour))

    def draw(self, ax):
        middle = sum(ax.get_xlim()) / 2
        by_x = sorted(self.all, key=lambda label: label[0][0])
        half = len(by_x) // 2 + 1
        left = [label for label in by_x if label[0][0] < middle]
        # Neither side has many more than the other.
        cut = min(max(len(left), len(by_x) - half), half)
        for labels, x, side in ((by_x[:cut], 0.005, "left"), (by_x[cut:], 0.995, "right")):
            self.column(ax, sorted(labels, key=lambda label: -label[0][1]), x, side)

    @staticmethod
    def column(ax, labels, x, side):
        low, high = ax.get_ylim()
        heights = [LINE * (words.count("\n") + 1) + PAUSE for _, words, _ in labels]
        wanted = [(anchor[1] - low) / (high - low) for anchor, _, _ in labels]
        for (anchor, words, colour), y in zip(labels, spread(wanted, heights, CORNER if side == "left" else 0.01)):
            ax.annotate(words, anchor, (x, y), xycoords="data", textcoords="axes fraction", color=colour, fontsize=8.5,
                        ha=side, va="center", zorder=20, annotation_clip=False,
                        bbox={"facecolor": "white", "edgecolor": "none", "pad": 1, "alpha": 0.75},
                        arrowprops={"arrowstyle": "-", "color": colour, "linewidth": 0.7, "shrinkA": 1, "shrinkB": 0,
                                    "relpos": (1 if side == "left" else 0, 0.5)})


def spread(wanted, heights, above):
    """Middles of rows, from the upper to the lower one, that do not overlap and end above a height: as near to the wanted ones
    as going down and up again finds."""
    places, below = [], 0.99
    for place, height in zip(wanted, heights):
        places.append(min(place, below - height / 2))
        below = places[-1] - height / 2
    for k in reversed(range(len(places))):
        places[k] = max(places[k], above + heights[k] / 2)
        above = places[k] + heights[k] / 2
    return places
