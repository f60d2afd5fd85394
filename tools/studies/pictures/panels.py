# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What the pictures of tools/study verification have in common."""
from disc_map import LINES

BLUE, RED, GREEN, GREY = LINES
DOTS = {"marker": "o", "markersize": 3, "linestyle": "none", "color": BLUE, "label": "orthocone"}
LINE = {"color": RED, "linewidth": 1.2, "label": "closed form"}


def label(ax, title, x, y):
    ax.set(title=title, xlabel=x, ylabel=y)


def entries(axes):
    """Handles and labels of all axes, each label once."""
    found = {}
    for ax in axes:
        for handle, name in zip(*ax.get_legend_handles_labels()):
            found.setdefault(name, handle)
    return list(found.values()), list(found)
