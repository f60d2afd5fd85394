# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""sweep.html: one page with a picture of each quantity over the first variable, and the table."""
import io
import itertools
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
matplotlib.rcParams["text.parse_math"] = False  # names and words of the user are no formulas
import matplotlib.pyplot as plt  # noqa: E402
from sweep_runs import UNITS, write_whole  # noqa: E402

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent / "report"))
from markup import element, escape, table  # noqa: E402

DRAWN = {"max_slip": "largest slip", "max_pressure": "largest pressure", "max_force_z": "largest normal force",
         "total_dissipation": "dissipated energy", "critical_friction": "critical friction / given",
         "iterations": "iterations of the contact solver"}
MOST_IN_LEGEND = 12
STYLE = """body { font: 15px/1.45 system-ui, sans-serif; margin: 2em auto; max-width: 76em; padding: 0 1em; color: #222; background: #fff; }
table { border-collapse: collapse; font-size: 13px; } th, td { padding: 2px 8px; text-align: right; border-bottom: 1px solid #ddd; }
td { white-space: nowrap; max-width: 24em; overflow: hidden; text-overflow: ellipsis; }
.scroll { overflow-x: auto; } svg { max-width: 100%; height: auto; } code { background: #f3f3f3; }"""


def numbers(values):
    """The values as numbers, or their places where one is a word; and the words, or None."""
    try:
        return [float(value) for value in values], None
    except ValueError:
        return list(range(len(values))), values


def lines_of(grid, rows, quantity):
    """(label, places on the first axis, values) of each combination of the other variables; failed runs leave a hole."""
    (name, values), others = grid[0], grid[1:]
    place = dict(zip(values, numbers(values)[0]))
    for combination in itertools.product(*(values for _, values in others)):
        fixed = dict(zip((other for other, _ in others), combination))
        chosen = [row for row in rows if row["exit"] == 0 and all(row[key] == value for key, value in fixed.items())
                  and isinstance(row[quantity], (int, float))]
        label = ", ".join(f"{key.rpartition('/')[2]} = {value}" for key, value in fixed.items())
        yield label, [place[row[name]] for row in chosen], [row[quantity] for row in chosen]


def draw(axes, grid, rows, quantity):
    lines = list(lines_of(grid, rows, quantity))
    colours = plt.get_cmap("viridis")
    for i, (label, x, y) in enumerate(lines):
        axes.plot(x, y, marker="o", markersize=3, linewidth=1.2, color=colours(0.9 * i / max(1, len(lines) - 1)), label=label)
    positions, words = numbers(grid[0][1])
    if words:
        axes.set_xticks(positions, words)
    unit = UNITS[quantity]
    axes.set_title(DRAWN[quantity] + (f" [{unit}]" if unit else ""), fontsize=10)
    axes.set_xlabel(grid[0][0].rpartition("/")[2], fontsize=9)
    axes.tick_params(labelsize=8)
    axes.ticklabel_format(axis="y", useOffset=False)
    axes.grid(alpha=0.3)
    axes.margins(y=0.12)


def figure(grid, rows):
    """Pictures of all quantities that some run has."""
    quantities = [name for name in DRAWN if any(row["exit"] == 0 and row[name] is not None for row in rows)]
    if not quantities:
        return None
    n_rows = (len(quantities) + 2) // 3
    shape, axes = plt.subplots(n_rows, 3, figsize=(12, 3.4 * n_rows), squeeze=False, layout="constrained")
    for place, quantity in itertools.zip_longest(axes.flat, quantities):
        if quantity:
            draw(place, grid, rows, quantity)
        else:
            place.set_axis_off()
    if 1 < len(axes[0][0].get_lines()) <= MOST_IN_LEGEND:
        axes[0][0].legend(fontsize=7)
    return shape


def svg_of(shape):
    if shape is None:
        return "<p>No run is complete.</p>"
    text = io.StringIO()
    shape.savefig(text, format="svg")
    plt.close(shape)
    return text.getvalue()[text.getvalue().index("<svg"):]


def cell(value):
    return f"{value:.6g}" if isinstance(value, float) else "\u2013" if value is None else value


def table_of(rows):
    head = [name + (f" [{UNITS[name]}]" if UNITS.get(name) else "") for name in rows[0]]
    return table(head, [[cell(value) for value in row.values()] for row in rows])


def beginning(values):
    return ", ".join(values[:3]) + (", \u2026" if len(values) > 3 else "")


def write_page(path, file, settings, grid, rows):
    n_failed = sum(row["exit"] != 0 for row in rows)
    varied = "; ".join(f"{name} = {beginning(values)} ({len(values)})" for name, values in grid)
    fixed = "".join(element("li", element("code", escape(setting))) for setting in settings)
    failed = f"{n_failed} of {len(rows)} runs are not complete: they have no point, and their rows in sweep.csv say why." if n_failed else ""
    title = f"Parameter study of {file}"
    page = (f"<!DOCTYPE html><html lang=en><meta charset=utf-8><meta name=viewport content='width=device-width'>"
            f"<title>{escape(title)}</title><style>{STYLE}</style>"
            + element("h1", escape(title)) + element("p", escape(f"{len(rows)} runs. Varied: {varied}. {failed}"))
            + element("ul", fixed) + svg_of(figure(grid, rows)) + element("h2", "Runs") + table_of(rows) + "</html>\n")
    write_whole(path, page)
