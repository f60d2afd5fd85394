# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The picture of a table of measured friction: the forces with the slip against them, the coefficients over the angle, and
the conditions with the places where they fail."""
import matplotlib
import numpy as np
from rosette_law import unit

matplotlib.use("Agg")
matplotlib.rcParams.update({"font.size": 9, "axes.grid": True, "grid.color": "0.9", "axes.axisbelow": True, "legend.fontsize": 8,
                            "legend.frameon": False, "axes.spines.top": False, "axes.spines.right": False, "svg.hashsalt": "rosette"})

import matplotlib.pyplot as plt  # noqa: E402

BLUE, RED, GREEN, PINK, GREY, FAIL = "#0072b2", "#d55e00", "#009e73", "#cc79a7", "0.45", "#b3123f"
N_ARROWS, MOST_NAMED = 24, 4
NORMAL = 3  # degrees off the normal of the curve that a picture does not show
NAMES = {"along": "mu_along ≤ 0", "kappa": "kappa ≤ 0", "turning": "d b/da ≤ 0"}


def closed(values):
    return np.concatenate([values, values[:1]])


def slip_arrows(ax, curve, length):
    """At forces all around the direction that slip is against; its colour says whether it is the normal of the curve."""
    departures = np.abs(np.degrees(curve.departures()))
    drawn = np.linspace(0, len(curve.angles), N_ARROWS, endpoint=False).astype(int)
    for k in drawn:
        start, way = curve.forces[k], length * unit(curve.angles[k])
        colour = RED if departures[k] > NORMAL else GREEN
        ax.annotate("", start + way, start, arrowprops={"arrowstyle": "-|>", "color": colour, "linewidth": 0.9,
                                                        "mutation_scale": 7, "shrinkA": 0, "shrinkB": 0})
    for colour, words, shown in ((GREEN, "slip is against this normal", departures <= NORMAL),
                                 (RED, "slip is against this, not the normal", departures > NORMAL)):
        if shown[drawn].any():
            ax.plot([], [], color=colour, marker=">", markersize=4, label=words)


def force_diagram(ax, curve, nearest=None, ellipses=None):
    reach = 1.32 * max(curve.size.max(), *(np.linalg.norm(other, axis=1).max() for other in (curve.table.forces,)))
    ax.axhline(0, color=GREY, linewidth=0.6)
    ax.axvline(0, color=GREY, linewidth=0.6)
    if ellipses is not None:
        ax.plot(*closed(ellipses.forces(curve.angles)).T, color=PINK, linestyle="--", linewidth=1, label="best ellipses")
    if nearest is not None:
        ax.plot(*closed(nearest.forces).T, color=GREY, linestyle=":", linewidth=1.4, label="nearest well posed")
    ax.plot(*closed(curve.forces).T, color=BLUE, linewidth=1.5, label="force" if curve.is_joined else "force, joined by lines")
    slip_arrows(ax, curve, 0.13 * reach)
    rows = curve.table.forces
    ax.plot(*rows.T, "o", color=BLUE, markersize=3 if len(rows) <= 72 else 1.5, label="rows")
    bad = np.isin(curve.angles, np.concatenate([angles_within(curve, one) for one in curve.failing().values()]))
    if bad.any():
        ax.plot(*curve.forces[bad].T, ".", color=FAIL, markersize=4, label="a condition fails")
    ax.set(aspect="equal", xlim=(-reach, reach), ylim=(-reach, reach), xlabel="force along x / normal force", ylabel="along y")


def angles_within(curve, places):
    inside = [curve.angles[(curve.angles - first) % (2 * np.pi) <= (last - first) % (2 * np.pi) if last - first < 6.28
                           else np.ones(len(curve.angles), dtype=bool)] for first, last in places]
    return np.concatenate(inside) if inside else np.empty(0)


def over_angle(ax, label):
    ax.axhline(0, color=GREY, linewidth=0.6)
    ax.set(xlim=(0, 360), xticks=range(0, 361, 45), ylabel=label)


def coefficients(ax, curve, nearest=None, ellipses=None):
    over_angle(ax, "coefficient")
    table = curve.table
    for name, values, rows, colour in (("mu_along", curve.along, table.along, BLUE), ("mu_across", curve.across, table.across, RED)):
        ax.plot(np.degrees(curve.angles), values, color=colour, label=name)
        ax.plot(np.degrees(table.angles), rows, "o", color=colour, markersize=2.5)
    if ellipses is not None:
        forces, e = ellipses.forces(curve.angles), unit(curve.angles)
        ax.plot(np.degrees(curve.angles), (forces * e).sum(axis=1), color=PINK, linestyle="--", linewidth=1, label="best ellipses")
        ax.plot(np.degrees(curve.angles), forces[:, 1] * e[:, 0] - forces[:, 0] * e[:, 1], color=PINK, linestyle="--", linewidth=1)
    if nearest is not None:
        ax.plot(np.degrees(nearest.angles), nearest.along, color=GREY, linestyle=":", linewidth=1.4, label="nearest")
        ax.plot(np.degrees(nearest.angles), nearest.across, color=GREY, linestyle=":", linewidth=1.4)
    ax.legend(loc="lower center", bbox_to_anchor=(0.5, 1), ncols=4)


def conditions(ax, curve):
    """Both in units of what they are for isotropic friction; failing places in words."""
    over_angle(ax, "kappa/mean, d b/da")
    degrees = np.degrees(curve.angles)
    ax.plot(degrees, curve.kappa / curve.mean, color=GREEN, label="kappa, of the mean size of the force")
    ax.plot(degrees, curve.turning, color="#8f4a82", label="turn of the force, d b/da")
    words = []
    for name, places in curve.failing().items():
        for first, last in places:
            for one, other in ([(first, last)] if last >= first else [(first, 2 * np.pi), (0, last)]):
                ax.axvspan(np.degrees(one) - 1, np.degrees(other) + 1, color=FAIL, alpha=0.18, linewidth=0)
        words += [f"{NAMES[name]}: {place_words(place)}" for place in places]
    if len(words) > MOST_NAMED:
        words = [*words[:MOST_NAMED - 1], f"and at {len(words) - MOST_NAMED + 1} more places"]
    if words:
        low, high = ax.get_ylim()
        ax.set_ylim(low, high + 0.14 * (1 + len(words)) * (high - low))
        ax.text(0.01, 0.98, "\n".join(words), color=FAIL, transform=ax.transAxes, va="top", fontsize=8)
    ax.set(xlabel="angle of the direction against which it slips (degrees)")
    ax.legend(loc="lower center", bbox_to_anchor=(0.5, 1), ncols=2)


def place_words(place):
    first, last = np.degrees(place)
    return f"at {first:.4g}°" if last - first < 0.3 and last >= first else f"{first:.4g}° to {last:.4g}°"


def draw(curve, title, nearest=None, ellipses=None):
    """A figure of a Curve, with the nearest table and the best ellipses if they are given."""
    figure = plt.figure(figsize=(9, 5.2), layout="constrained")
    grid = figure.add_gridspec(2, 2, width_ratios=(1, 1.15))
    left = figure.add_subplot(grid[:, 0])
    force_diagram(left, curve, nearest, ellipses)
    coefficients(figure.add_subplot(grid[0, 1]), curve, nearest, ellipses)
    conditions(figure.add_subplot(grid[1, 1]), curve)
    handles, labels = left.get_legend_handles_labels()
    rows = -(-len(handles) // 4)
    figure.get_layout_engine().set(rect=(0, 0.05 * rows, 1, 1 - 0.05 * rows))
    figure.legend(handles, labels, loc="lower center", ncols=min(len(handles), 4), borderaxespad=0.2)
    figure.suptitle(title, x=0.01, ha="left", fontweight="bold", fontsize=10)
    return figure
