# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The picture of a fretting map: regimes as colours, the borders between them, and dissipated energy as contour lines."""
import matplotlib

matplotlib.use("Agg")
matplotlib.rcParams["text.parse_math"] = False  # names and words of the user are no formulas
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from map_points import REGIMES  # noqa: E402
from matplotlib.collections import LineCollection  # noqa: E402
from matplotlib.colors import ListedColormap  # noqa: E402
from matplotlib.patches import Patch  # noqa: E402
from sweep_page import numbers  # noqa: E402

COLOURS = ("#a6cee3", "#fee391", "#f4a582")
N_LEVELS, SMALLEST = 7, 1e-3  # of the energy, and the least one relative to the largest
UNKNOWN = "#dddddd"


def table_of(rows, axes, values, column):
    """(len(y), len(x)) of a column over the grid."""
    found = {(row[axes[0].name], row[axes[1].name]): row[column] for row in rows}
    return np.array([[found[x, y] for x in values[0]] for y in values[1]])


def edges_of(places):
    """(n + 1,): the borders of the intervals around n places, halfway between them."""
    middles = [(a + b) / 2 for a, b in zip(places, places[1:])]
    return np.array([2 * places[0] - middles[0], *middles, 2 * places[-1] - middles[-1]])


def borders_of(code, x, y):
    """The edges between points with different regimes, as pairs of places. code: (len(y) - 1, len(x) - 1), nan where unknown."""
    found = [((x[j + 1], y[i]), (x[j + 1], y[i + 1])) for i, j in np.argwhere(np.abs(np.diff(code, axis=1)) > 0)]
    return found + [((x[j], y[i + 1]), (x[j + 1], y[i + 1])) for i, j in np.argwhere(np.abs(np.diff(code, axis=0)) > 0)]


def draw_regimes(plot, x, y, rows, axes, values):
    words = table_of(rows, axes, values, "regime")
    code = np.full(words.shape, np.nan)
    for i, regime in enumerate(REGIMES):
        code[words == regime] = i
    plot.set_facecolor(UNKNOWN)
    x, y = edges_of(x), edges_of(y)
    plot.pcolormesh(x, y, np.ma.masked_invalid(code), cmap=ListedColormap(COLOURS), vmin=-0.5, vmax=2.5)
    plot.add_collection(LineCollection(borders_of(code, x, y), colors="black", linewidths=1.8, capstyle="round"))
    there = [Patch(facecolor=COLOURS[i], edgecolor="black", label=regime) for i, regime in enumerate(REGIMES) if (words == regime).any()]
    return there + [Patch(facecolor=UNKNOWN, edgecolor="black", label="not solved")] * bool((words == "").any())


def draw_energy(plot, x, y, rows, axes, values):
    """Contour lines at even ratios, because the energy grows with the third power of the amplitude. Returns whether there are any."""
    energy = np.ma.masked_invalid(table_of(rows, axes, values, "dissipation").astype(float))
    positive = energy.compressed()[energy.compressed() > 0]
    if len(positive) < 3 or positive.max() <= positive.min():
        return False
    first = max(positive.min(), SMALLEST * positive.max())
    levels = [float(f"{level:.1g}") for level in np.geomspace(first, positive.max(), N_LEVELS)]
    lines = plot.contour(x, y, energy, levels=sorted(set(levels)), colors="#333333", linewidths=0.8, linestyles="dashed")
    plot.clabel(lines, fmt="%g", fontsize=7)
    return True


def draw(path, title, rows, axes, values):
    """values: the words of both axes, in their order."""
    figure, plot = plt.subplots(figsize=(7.2, 5.0), layout="constrained")
    (x, x_words), (y, y_words) = (numbers(words) for words in values)
    there = draw_regimes(plot, x, y, rows, axes, values)
    lines = [plt.Line2D([], [], color="#333333", linewidth=0.8, linestyle="dashed", label="energy of a cycle (N mm)")] \
        if draw_energy(plot, x, y, rows, axes, values) else []
    for words, set_ticks in ((x_words, plot.set_xticks), (y_words, plot.set_yticks)):
        if words:
            set_ticks(range(len(words)), words)
    plot.set_xlabel(axes[0].label)
    plot.set_ylabel(axes[1].label)
    plot.set_title(title, fontsize=10)
    plot.legend(handles=there + lines, loc="upper center", bbox_to_anchor=(0.5, -0.12), ncols=len(there) + len(lines), fontsize=8,
                frameon=False)
    figure.savefig(path, dpi=110, metadata={"Date": None} if path.suffix == ".svg" else None)
    plt.close(figure)
