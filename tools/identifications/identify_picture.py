# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The picture of a fit: measured loops as points, those of the model as lines, residuals below."""
import matplotlib
import numpy as np

matplotlib.use("Agg")
matplotlib.rcParams.update({"font.size": 9, "axes.grid": True, "grid.color": "0.9", "axes.axisbelow": True, "legend.fontsize": 8,
                            "legend.frameon": False, "axes.spines.top": False, "axes.spines.right": False, "svg.hashsalt": "identify",
                            "text.parse_math": False})

import matplotlib.pyplot as plt  # noqa: E402

COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000")
MOST_IN_LEGEND = 10


def model_line(curves, loop, compliance):
    """Displacement of the rig, mm, and force along the motion, N, around the loop of the model, with the mean of the measured one."""
    way = 2 * loop.amplitude * np.linspace(0, 1, 201)
    down, up = (curves.change(name, compliance, way) @ loop.direction for name in ("down", "up"))
    offset = np.mean(loop.along() - curves.force(loop, compliance) @ loop.direction)
    return np.concatenate([loop.amplitude - way, way - loop.amplitude]), offset + np.concatenate([down, down[-1] + up])


def draw(title, fit):
    """A figure of a fit after solve()."""
    figure, (above, below) = plt.subplots(2, 1, figsize=(6.5, 5.6), sharex=True, layout="constrained",
                                          gridspec_kw={"height_ratios": (2.4, 1)})
    start, compliance = 0, fit.values["rig_compliance"]
    for i, (loop, curves) in enumerate(zip(fit.loops, fit.curves)):
        colour = COLOURS[i % len(COLOURS)]
        residual = -fit.information.residual[start:start + loop.force.size].reshape(loop.force.shape)
        start += loop.force.size
        above.plot(1e3 * loop.place, loop.along(), ".", color=colour, markersize=2.5, alpha=0.6)
        place, force = model_line(curves, loop, compliance)
        above.plot(1e3 * place, force, color=colour, linewidth=1.2, label=loop.name)
        for column in residual.T:
            below.plot(1e3 * loop.place, 100 * column, ".", color=colour, markersize=2.5)
    above.set(ylabel="force along the motion (N)")
    if len(fit.loops) <= MOST_IN_LEGEND:
        above.legend(loc="lower right")
    below.set(xlabel="displacement of the actuator from the middle of its stroke (µm)", ylabel="measured − model\n(% of amplitude)")
    figure.suptitle(title, x=0.01, ha="left", fontweight="bold", fontsize=10)
    return figure
