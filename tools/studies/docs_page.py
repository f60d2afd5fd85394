# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Pictures and tables of the pages in docs/, as the tools write them with --docs."""
import argparse
import io
import pathlib
import re
import sys

import matplotlib
import numpy as np
from PIL import Image

from paths import ROOT

matplotlib.use("Agg")
# The same runs give the same files: no date, and names within an SVG that do not change.
matplotlib.rcParams["svg.hashsalt"] = "orthocone"

import matplotlib.pyplot as plt  # noqa: E402


class ProgramError(Exception):
    """The program stopped with an error."""


def fitting_dpi(figure, pixels):
    """The resolution that makes so many pixels of the figure, but not more than 120 dots per inch."""
    return min(120, (pixels / np.prod(figure.get_size_inches()))**0.5)


def save_small(figure, path):
    """A picture for the page, with a palette."""
    buffer = io.BytesIO()
    figure.savefig(buffer, dpi=fitting_dpi(figure, 1e6))
    Image.open(buffer).convert("RGB").quantize(256, dither=Image.Dither.NONE).save(path, optimize=True)


def write_tables(tables, page, tool):
    """Puts the tables {name: text} between their markers in the page."""
    text = page.read_text(encoding="utf-8")
    for name, rows in tables.items():
        pattern = rf"(<!-- table {name}[^>]*-->\n).*?(<!-- end {name} -->)"
        text, found = re.subn(pattern, lambda match, rows=rows: match[1] + rows + match[2], text, flags=re.S)
        if found != 1:
            raise SystemExit(f"{tool}: {page.name}: the markers of the table '{name}' stand there {found} times, not "
                             "once")
    page.write_text(text, encoding="utf-8")
    print(f"{tool}: tables of {page}")


def draw(tool, pictures, runs, folder, images=None, has_svg=False):
    """Every picture {name: function of the runs} as PNG in `folder`, also as SVG, and smaller as PNG in the folder `images`."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, picture in pictures.items():
        figure = picture(runs)
        figure.savefig(folder / f"{name}.png", dpi=200 if has_svg else 150)
        if has_svg:
            figure.savefig(folder / f"{name}.svg", dpi=fitting_dpi(figure, 1.2e6), metadata={"Date": None})
        if images:
            save_small(figure, images / f"{name}.png")
        plt.close(figure)
        print(f"{tool}: {folder / name}.png{', .svg' if has_svg else ''}", flush=True)


def main(tool, about, runs_in, pictures, tables=None, has_svg=False):
    """A word of tools/study: its pictures, and with --docs those of its page with the tables {name: function of the runs}.
    `runs_in(program, folder)` makes what runs the program."""
    parser = argparse.ArgumentParser(prog=f"tools/study {tool}", description=about)
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / f"output/{tool}", help="folder of pictures and runs")
    parser.add_argument("--docs", action="store_true", help="also refresh the pictures and tables in docs/")
    options = parser.parse_args()
    runs = runs_in(ROOT / "build/orthocone", options.output / "runs")
    page = {"figures": "paper"}.get(tool, tool)
    try:
        draw(tool, pictures, runs, options.output, ROOT / "docs/images" if options.docs else None, has_svg)
        if options.docs and tables:
            write_tables({name: make(runs) for name, make in tables.items()}, ROOT / f"docs/{page}.md", tool)
    except ProgramError as error:
        sys.exit(f"{tool}: {error}")
