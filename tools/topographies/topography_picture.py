# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The picture of a surface: its heights as a map, its spectrum, and how many of its points have which height."""
import matplotlib
import numpy as np

matplotlib.use("Agg")
matplotlib.rcParams.update({"font.size": 9, "axes.grid": True, "grid.color": "0.9", "axes.axisbelow": True, "legend.fontsize": 8,
                            "legend.frameon": False, "axes.spines.top": False, "axes.spines.right": False,
                            "svg.hashsalt": "topography"})

import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.ticker import LogLocator, MaxNLocator, NullFormatter  # noqa: E402

BLUE, RED = "#0072b2", "#d55e00"
MOST_DRAWN = 1000  # points along an axis; more would only make an .svg large
UM = 1e3  # in a mm


def height_map(figure, ax, surface):
    """Missing points are grey."""
    step = -(-max(surface.heights.shape) // MOST_DRAWN)
    x, y = surface.places
    half = surface.dx / 2, surface.dy / 2
    middle = np.nanmean(surface.heights)
    colours = matplotlib.colormaps["viridis"].with_extremes(bad="0.8")
    shown = ax.imshow(UM * (surface.heights[::step, ::step] - middle), origin="lower", cmap=colours, interpolation="nearest",
                      extent=(x[0] - half[0], x[-1] + half[0], y[0] - half[1], y[-1] + half[1]))
    figure.colorbar(shown, cax=ax.inset_axes([1.03, 0, 0.04, 1]), label="height above the mean (µm)")
    ax.set(xlabel="x (mm)", ylabel="y (mm)")
    ax.grid(False)


def spectrum_chart(ax, rings):
    """Over the wavenumber, and on top over the wavelength; densities that are rounding alone are left out."""
    shown = rings.density > 1e-12 * rings.density.max(initial=0)
    ax.set(xlabel="wavenumber q (1/mm)", ylabel="spectrum C(q) (mm⁴)")
    if not shown.any():
        ax.text(0.5, 0.5, "flat", transform=ax.transAxes, ha="center")
        return
    ax.loglog(rings.q[shown], rings.density[shown], color=BLUE, marker=".", markersize=3, linewidth=1)
    top = ax.secondary_xaxis("top", functions=2 * (lambda number: 2 * np.pi / np.maximum(number, 1e-9),))
    top.set_xlabel("wavelength (mm)")
    top.xaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    top.xaxis.set_major_formatter("{x:g}")
    top.xaxis.set_minor_formatter(NullFormatter())


def distribution(ax, surface, values):
    """Beside normal heights of the same mean square."""
    heights = UM * surface.heights[~np.isnan(surface.heights)]
    heights = heights - heights.mean()
    ax.set(xlabel="height above the mean (µm)", ylabel="share of points per µm")
    if not np.ptp(heights) > 0:
        return
    ax.hist(heights, bins=60, density=True, color=BLUE, alpha=0.6)
    at, deviation = np.linspace(heights.min(), heights.max(), 201), UM * values["Sq"]
    ax.plot(at, np.exp(-(at / deviation)**2 / 2) / (deviation * np.sqrt(2 * np.pi)), color=RED, linewidth=1, label="normal heights of the same Sq")
    ax.legend(loc="lower right", bbox_to_anchor=(1, 0.98))
    ax.xaxis.set_major_locator(MaxNLocator(5))


def draw(name, surface, rings, values):
    """A figure of a Surface with its Spectrum and its roughness numbers."""
    figure = plt.figure(figsize=(9, 4.8), layout="constrained")
    grid = figure.add_gridspec(2, 2, width_ratios=(1.3, 1))
    height_map(figure, figure.add_subplot(grid[:, 0]), surface)
    spectrum_chart(figure.add_subplot(grid[0, 1]), rings)
    distribution(figure.add_subplot(grid[1, 1]), surface, values)
    title = f"{name}: " + ", ".join(f"{key} {UM * values[key]:.3g} µm" for key in ("Sa", "Sq", "Sz")) + f", Sdq {values['Sdq']:.3g}"
    figure.suptitle(title, x=0.01, ha="left", fontweight="bold", fontsize=10, parse_math=False)
    return figure
