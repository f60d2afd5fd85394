# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Figures 5 to 12 of the paper from our own runs; with --docs what docs/paper.md shows. Started by tools/figures."""
import argparse
import io
import pathlib
import re
import sys

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from PIL import Image  # noqa: E402

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
        figure.savefig(folder / f"{name}.svg", dpi=fitting_dpi(figure, 1.2e6), metadata={"Date": None})
        if images:
            save_small(figure, images / f"{name}.png")
        plt.close(figure)
        print(f"figures: {folder / name}.png, .svg", flush=True)


def fitting_dpi(figure, pixels):
    """The resolution that makes so many pixels of the figure, but not more than 120 dots per inch."""
    return min(120, (pixels / np.prod(figure.get_size_inches()))**0.5)


def save_small(figure, path):
    """A picture for the page, with a palette."""
    buffer = io.BytesIO()
    figure.savefig(buffer, dpi=fitting_dpi(figure, 1e6))
    Image.open(buffer).convert("RGB").quantize(256, dither=Image.Dither.NONE).save(path, optimize=True)


def write_tables(runs, page):
    """Puts the tables between their markers in the page."""
    text = page.read_text(encoding="utf-8")
    for name, make in paper_tables.TABLES.items():
        pattern = rf"(<!-- table {name}[^>]*-->\n).*?(<!-- end {name} -->)"
        text, found = re.subn(pattern, lambda match, rows=make(runs): match[1] + rows + match[2], text, flags=re.S)
        if found != 1:
            raise SystemExit(f"figures: {page.name}: the markers of the table '{name}' stand there {found} times, not "
                             "once")
    page.write_text(text, encoding="utf-8")
    print(f"figures: tables of {page}")


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
