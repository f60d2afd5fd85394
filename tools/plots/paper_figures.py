# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Figures 5 to 12 of the paper from our own runs; with --docs what docs/paper.md shows. Started by tools/figures."""
import argparse
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402

import docs_page  # noqa: E402
import paper_maps  # noqa: E402
import paper_paths  # noqa: E402
import paper_tables  # noqa: E402
from paper_questions import positive_load  # noqa: E402
from paper_runs import ROOT, ProgramError, Runs  # noqa: E402

PAGE = ROOT / "docs/paper.md"
IMAGES = ROOT / "docs/images"
FIGURES = {
    "fig05": paper_maps.figure_5, "fig06": paper_maps.figure_6, "fig07": paper_maps.figure_7,
    "fig08": paper_maps.figure_8, "fig09": paper_paths.figure_9, "fig10": paper_paths.figure_10,
    "fig11": lambda runs: paper_paths.figure_11(runs, positive_load(runs)), "fig12": paper_paths.figure_12,
    "cases": paper_maps.overview,
}
# The same runs give the same files: no date, and names within an SVG that do not change.
matplotlib.rcParams["svg.hashsalt"] = "orthocone"


def draw_figures(runs, folder, images=None):
    """Every figure as PNG and SVG in `folder`, and smaller as PNG in the folder `images`."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, draw in FIGURES.items():
        figure = draw(runs)
        figure.savefig(folder / f"{name}.png", dpi=200)
        figure.savefig(folder / f"{name}.svg", dpi=docs_page.fitting_dpi(figure, 1.2e6), metadata={"Date": None})
        if images:
            docs_page.save_small(figure, images / f"{name}.png")
        plt.close(figure)
        print(f"figures: {folder / name}.png, .svg", flush=True)


def write_tables(runs, page):
    """Puts the tables between their markers in the page."""
    docs_page.write_tables({name: make(runs) for name, make in paper_tables.TABLES.items()}, page, "figures")


def main():
    parser = argparse.ArgumentParser(prog="tools/figures", description=__doc__)
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "output/figures",
                        help="folder of figures and runs")
    parser.add_argument("--docs", action="store_true", help="also refresh docs/images and the tables of docs/paper.md")
    options = parser.parse_args()
    runs = Runs(ROOT / "build/orthocone", options.output / "runs")
    try:
        draw_figures(runs, options.output, IMAGES if options.docs else None)
        if options.docs:
            write_tables(runs, PAGE)
    except ProgramError as error:
        sys.exit(f"figures: {error}")


if __name__ == "__main__":
    main()
