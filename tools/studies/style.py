# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""How all charts of the studies look, and how they are kept."""
import docs_page

matplotlib, plt = docs_page.matplotlib, docs_page.plt
WIDTH, headline, legend_below = docs_page.WIDTH, docs_page.headline, docs_page.legend_below

# Okabe and Ito's palette, whose colours the colour-blind can distinguish.
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000")
METHODS = ("newton", "gauss-seidel", "uzawa", "feng2006", "box3", "plain-newton")
METHOD_COLOURS = dict(zip(METHODS, COLOURS))


def plain_ticks(axis, ticks=None):
    """Numbers as one says them, also on a logarithmic axis."""
    if ticks is not None:
        axis.set_ticks(ticks)
    axis.set_major_formatter("{x:g}")
    axis.set_minor_formatter("")


def save(figure, name, folders):
    """NAME.png in each folder."""
    for folder in folders:
        folder.mkdir(parents=True, exist_ok=True)
        docs_page.save_small(figure, folder / f"{name}.png")
    plt.close(figure)
