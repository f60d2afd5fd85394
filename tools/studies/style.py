# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""How all charts of the studies look, and how they are kept: as PNG to look at and SVG to print."""
import docs_page
import matplotlib

matplotlib.use("Agg")
matplotlib.rcParams.update({"font.size": 9, "axes.grid": True, "grid.alpha": 0.3, "axes.spines.top": False,
                            "axes.spines.right": False, "legend.frameon": False, "figure.constrained_layout.use": True,
                            "svg.hashsalt": "orthocone", "svg.fonttype": "none"})

import matplotlib.pyplot as plt  # noqa: E402

# Okabe and Ito's palette, whose colours the colour-blind can distinguish.
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000")
METHODS = ("newton", "gauss-seidel", "uzawa", "feng2006", "box3", "plain-newton")
METHOD_COLOURS = dict(zip(METHODS, COLOURS))


def save(figure, name, folders):
    """NAME.png and NAME.svg in each folder; without dates, so that the same figure gives the same bytes."""
    for folder in folders:
        folder.mkdir(parents=True, exist_ok=True)
        docs_page.save_small(figure, folder / f"{name}.png")
        figure.savefig(folder / f"{name}.svg", metadata={"Date": None})
    plt.close(figure)
