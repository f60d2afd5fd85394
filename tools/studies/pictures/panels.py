# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What the pictures of tools/study verification have in common."""
import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402

from disc_map import LINES  # noqa: E402

BLUE, RED, GREEN, GREY = LINES
DOTS = {"marker": "o", "markersize": 3.5, "linestyle": "none", "color": BLUE, "label": "orthocone"}
LINE = {"color": RED, "linewidth": 1.2, "label": "closed form"}


def three_panels():
    figure, axes = plt.subplots(1, 3, figsize=(13.5, 4.2), layout="constrained")
    for ax in axes:
        ax.grid(color="0.9", linewidth=0.6)
        ax.set_axisbelow(True)
    return figure, axes


def label(ax, title, x, y):
    ax.set(title=title, xlabel=x, ylabel=y)
    ax.legend(fontsize=8)
