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
# Pictures are as wide as a page, so that their letters have the size that stands here.
WIDTH = 6.5  # inches
matplotlib.rcParams.update({
    "font.size": 9, "axes.titlesize": 9, "axes.labelsize": 9, "xtick.labelsize": 8, "ytick.labelsize": 8, "legend.fontsize": 8,
    "legend.frameon": False, "lines.linewidth": 1.3, "lines.markersize": 4, "axes.grid": True, "grid.color": "0.9",
    "grid.linewidth": 0.6, "axes.axisbelow": True, "axes.spines.top": False, "axes.spines.right": False,
    "figure.constrained_layout.use": True, "figure.constrained_layout.h_pad": 0.06})

import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.ticker import AutoLocator, MaxNLocator  # noqa: E402


class ProgramError(Exception):
    """The program stopped with an error."""


def headline(figure, message):
    """What the picture shows, in one sentence above it."""
    figure.suptitle(message, x=0.01, ha="left", fontsize=10, fontweight="bold")


def legend_below(figure, handles, labels, ncols):
    """Entries below all axes, in rows of `ncols`."""
    share = (0.1 + 0.155 * -(-len(handles) // ncols)) / figure.get_figheight()
    figure.get_layout_engine().set(rect=(0, share, 1, 1 - share))
    figure.legend(handles, labels, loc="lower center", ncols=ncols, borderaxespad=0.2, labelspacing=0.25, columnspacing=1.4)


def round_ticks(figure):
    """At multiples of 1, 2 and 5; matplotlib's own rule also takes 2.5."""
    for axes in figure.axes:
        for axis in (axes.xaxis, axes.yaxis):
            if isinstance(axis.get_major_locator(), AutoLocator):
                axis.set_major_locator(MaxNLocator("auto", steps=(1, 2, 5, 10), min_n_ticks=3))


def save_small(figure, path):
    """A picture for the page, with a palette: a million pixels, but not more than 200 dots per inch."""
    round_ticks(figure)
    buffer = io.BytesIO()
    figure.savefig(buffer, dpi=min(200, (1e6 / np.prod(figure.get_size_inches()))**0.5))
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


def draw(tool, pictures, runs, folder, images=None):
    """Every picture {name: function of the runs} as PNG in `folder`, and smaller in the folder `images`."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, picture in pictures.items():
        figure = picture(runs)
        round_ticks(figure)
        figure.savefig(folder / f"{name}.png", dpi=200)
        if images:
            save_small(figure, images / f"{name}.png")
        plt.close(figure)
        print(f"{tool}: {folder / name}.png", flush=True)


def main(tool, about, runs_in, pictures, tables=None):
    """A word of tools/study: its pictures, and with --docs those of its page with the tables {name: function of the runs}.
    `runs_in(program, folder)` makes what runs the program."""
    parser = argparse.ArgumentParser(prog=f"tools/study {tool}", description=about)
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / f"output/{tool}", help="folder of pictures and runs")
    parser.add_argument("--docs", action="store_true", help="also refresh the pictures and tables in docs/")
    options = parser.parse_args()
    runs = runs_in(ROOT / "build/orthocone", options.output / "runs")
    page = {"figures": "paper", "friction": "measured_friction"}.get(tool, tool)
    try:
        draw(tool, pictures, runs, options.output, ROOT / "docs/images" if options.docs else None)
        if options.docs and tables:
            write_tables({name: make(runs) for name, make in tables.items()}, ROOT / f"docs/{page}.md", tool)
    except ProgramError as error:
        sys.exit(f"{tool}: {error}")
