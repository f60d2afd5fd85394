# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Charts of docs/performance.md: cost against size, and where the time of a whole process goes."""
import matplotlib.pyplot as plt
import numpy as np

import style
from benchmark_measure import PAPER, PHASES
from benchmark_ratios import costs, exponent

# Neighbours in the bars differ also in lightness.
COLOURS = ("#0072b2", "#f0e442", "#009e73", "#d55e00", "#000000", "#56b4e9", "#999999", "#e69f00")
DARK = COLOURS[:1] + COLOURS[2:5]


def cost_chart(result):
    """Seconds against contact nodes, with the exponents of the three finest meshes."""
    figure, panel = plt.subplots(figsize=(style.WIDTH, 3.8))
    for (name, (nodes, _, seconds)), colour, marker in zip(costs(result).items(), style.COLOURS, "osD^v"):
        panel.loglog(nodes, seconds, color=colour, marker=marker, label=f"{name}: $n^{{{exponent(nodes, seconds):.1f}}}$")
    paper = next((p for p in result["programs"] if p["core_cells"] == PAPER), None)
    if paper:
        panel.axvline(paper["contact_nodes"], color="0.6", linewidth=1, zorder=0)
        panel.annotate("the paper's mesh", (paper["contact_nodes"], 1), xycoords=("data", "axes fraction"), xytext=(4, -4),
                       textcoords="offset points", va="top", size=8)
    sizes = [p["contact_nodes"] for p in result["programs"]]
    style.plain_ticks(panel.xaxis, [tick for tick in (10, 20, 50, 100, 200, 500, 1000, 2000, 5000)
                                    if 0.8 * min(sizes) < tick < 1.2 * max(sizes)])
    panel.yaxis.set_major_formatter("{x:g}")
    panel.set(xlabel="contact nodes n", ylabel="time (s)")
    panel.legend(loc="center left", bbox_to_anchor=(1, 0.5))
    style.headline(figure, "All parts grow about as the square of the contact nodes, output more slowly")
    return figure


def share_chart(result):
    """Parts of the whole process on every mesh, in per cent: means over the runs. The start-up is that of another process, so
    that the parts do not quite make 100."""
    figure, panel = plt.subplots(figsize=(style.WIDTH, 1.2 + 0.42 * len(result["programs"])))
    names = ("start_up", *PHASES)
    for row, program in enumerate(result["programs"]):
        parts = np.mean([[100 * run[name] / run["process"] for name in names] for run in program["samples"]], axis=0)
        left = 0
        for part, colour, name in zip(parts, COLOURS, names):
            panel.barh(row, part, left=left, color=colour, label=name.replace("_", "-") if row == 0 else None)
            if part > 4:
                panel.text(left + part / 2, row, f"{part:.0f}", ha="center", va="center", size=8,
                           color="white" if colour in DARK else "black")
            left += part
    panel.set_yticks(range(len(result["programs"])),
                     [f"{p['contact_nodes']} contact nodes, {p['median']['process']:.2g} s" for p in result["programs"]])
    panel.invert_yaxis()
    panel.grid(axis="y", visible=False)
    panel.set_xlabel("share of the wall time of the whole process (%)")
    style.legend_below(figure, *panel.get_legend_handles_labels(), 4)
    style.headline(figure, "Small runs start and write, large ones factorize and check")
    return figure


CHARTS = {"cost": cost_chart, "shares": share_chart}
