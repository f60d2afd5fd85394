# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Charts of docs/performance.md: cost against size, and where the time of a whole process goes."""
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import NullFormatter

from benchmark_measure import PAPER, PHASES
from benchmark_ratios import costs, exponent

COLOURS = ("#4477aa", "#ee6677", "#228833", "#aa3377", "#bbaa22", "#66ccee", "#888888", "#222222")
MARKERS = "osD^v"


def cost_chart(result):
    """Seconds against contact nodes and against unknowns, with the exponents of the three finest meshes."""
    figure, panels = plt.subplots(1, 2, figsize=(11, 5), sharey=True, constrained_layout=True)
    paper = next((p for p in result["programs"] if p["core_cells"] == PAPER), None)
    for column, (panel, label) in enumerate(zip(panels, ("contact nodes", "unknowns"))):
        for (name, curve), colour, marker in zip(costs(result).items(), COLOURS, MARKERS):
            sizes, seconds = curve[column], curve[2]
            panel.loglog(sizes, seconds, color=colour, marker=marker,
                         label=f"{name}: {'nN'[column]}$^{{{exponent(sizes, seconds):.2f}}}$")
        if paper:
            panel.axvline(paper["dofs" if column else "contact_nodes"], color="0.8", zorder=0)
            panel.annotate("the paper's mesh", (paper["dofs" if column else "contact_nodes"], 0.01), rotation=90,
                           xycoords=("data", "axes fraction"), color="0.5", ha="right", va="bottom", size=9)
        panel.set_xticks([p["dofs" if column else "contact_nodes"] for p in result["programs"]],
                         [f"{p['dofs' if column else 'contact_nodes']}" for p in result["programs"]])
        panel.xaxis.set_minor_formatter(NullFormatter())
        panel.minorticks_off()
        panel.set_xlabel(label)
        panel.grid(alpha=0.3)
        panel.legend(loc="upper left", fontsize=9)
    panels[0].set_ylabel("seconds")
    return figure


def share_chart(result):
    """Parts of the whole process on every mesh, in per cent: means over the runs."""
    figure, panel = plt.subplots(figsize=(9, 0.8 + 0.55 * len(result["programs"])), constrained_layout=True)
    names = ("start_up", *PHASES)
    longest = 100
    for row, program in enumerate(result["programs"]):
        parts = np.mean([[100 * run[name] / run["process"] for name in names] for run in program["samples"]], axis=0)
        left = 0
        for part, colour, name in zip(parts, COLOURS, names):
            panel.barh(row, part, left=left, color=colour, label=name.replace("_", "-") if row == 0 else None)
            if part > 4:
                panel.text(left + part / 2, row, f"{part:.0f}", ha="center", va="center", color="white", size=9)
            left += part
        longest = max(longest, left)
    panel.set_yticks(range(len(result["programs"])),
                     [f"{p['contact_nodes']} contact nodes, {p['median']['process']:.2g} s" for p in result["programs"]])
    panel.invert_yaxis()
    panel.set_xlim(0, longest)  # the start-up is that of another process
    panel.set_xlabel("per cent of the wall time of the whole process")
    panel.spines[["top", "right"]].set_visible(False)
    panel.legend(ncols=8, loc="lower center", bbox_to_anchor=(0.5, 1), fontsize=8, frameon=False, columnspacing=1,
                 handlelength=1)
    return figure


CHARTS = {"cost": cost_chart, "shares": share_chart}
