# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Where methods fail: every method over friction, body, mesh, load steps, tolerance, rho and unloading."""
import itertools
import math
import re

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Patch, Rectangle

import scenes
import style
import verdicts
from points import program_point
from style import METHODS

PAGE = "stability.md"
DEFAULT = "newton"
DEFAULT_ITERATIONS = 5000
MOST_ITERATIONS = 2000  # of methods other than the default, which has the program's
RANDOM_METHODS = (DEFAULT, "gauss-seidel", "uzawa")

# Verdict: (colour, hatching, in words). Converged cells are shaded by their iterations instead.
KINDS = {"slow": ("#e69f00", "//", "too slow"), "cycling": ("#cc79a7", "..", "goes in cycles"),
         "diverged": ("#000000", "", "diverges"), "rounding": ("#999999", "", "stopped by rounding"),
         "other": ("#d55e00", "xx", "another solution"), "divided": ("#f0e442", "", "solved in divided steps"),
         "check": ("#882255", "", "stopped by a check"), "no-model": ("#ffffff", "", "scene is refused")}
SOLVED = ("converged", "divided")
SHADES = plt.get_cmap("GnBu")
MOST_SHADED = 2000


def most_iterations(method):
    return DEFAULT_ITERATIONS if method == DEFAULT else MOST_ITERATIONS


def point_of(name, x, y, method, settings):
    solver = {"Contact solver/Method": method}
    if method != DEFAULT:
        solver["Contact solver/Maximum iterations"] = MOST_ITERATIONS
    tolerance = settings.get("Contact solver/Tolerance", 1e-10)
    return program_point({"map": name, "x": x, "y": y, "method": method, "tolerance": tolerance},
                         "paper/scene.prm", {**settings, **solver})


def all_points(is_quick):
    for name, of_map in list(scenes.MAPS.items())[:1 if is_quick else None]:
        for x, y, settings in of_map.make(2) if is_quick else of_map.make():
            for method in METHODS:
                if method not in of_map.left_out:
                    yield point_of(name, x, y, method, settings)
    for x, y, settings in scenes.random_scenes(2) if is_quick else scenes.random_scenes():
        for method in RANDOM_METHODS:
            yield point_of("random", x, y, method, settings)


def measured(context):
    rows = context.measure(list(all_points(context.is_quick)), verdicts.outcome, jobs=context.jobs, threads=1)
    rows = [dict(row) for row in rows]
    return [row for _, group in itertools.groupby(rows, lambda row: (row["map"], row["x"], row["y"]))
            for row in verdicts.with_agreement(list(group), most_iterations)]


def shade(iterations):
    return SHADES(0.15 + 0.75 * math.log1p(iterations) / math.log1p(MOST_SHADED))


def draw_map(axes, rows, columns, lines):
    for row in rows:
        if row["verdict"] == "converged":
            look = {"facecolor": shade(int(row["iterations"]))}
        else:
            colour, hatching, _ = KINDS[row["verdict"]]
            look = {"facecolor": colour, "hatch": hatching, "edgecolor": "0.25", "linewidth": 0}
        axes.add_patch(Rectangle((columns.index(row["x"]) - 0.5, lines.index(row["y"]) - 0.5), 1, 1, **look))
    axes.set(xlim=(-0.5, len(columns) - 0.5), ylim=(-0.5, len(lines) - 0.5))
    axes.grid(False)


def short(value):
    try:
        return f"{float(value):.4g}" if 0.499 < float(value) < 0.5 else f"{float(value):.3g}"  # a Poisson's ratio
    except ValueError:
        return value


def in_words(value):
    """-1e-06 as a formula, C Q2 as a case and a degree; anything else as it is."""
    found = re.fullmatch(r"(-?)(?:1e(.\d+)|0\.(0+)1)", value)
    if not found:
        return value.replace(" Q", ", degree ")
    return f"${found[1]}10^{{{int(found[2]) if found[2] else -1 - len(found[3])}}}$"


def is_even_in_logarithms(values):
    """Whether the values are those of scenes.logarithmic."""
    try:
        numbers = np.array([float(value) for value in values])
    except ValueError:
        return False
    if len(numbers) < 3 or numbers.min() <= 0:
        return False
    ratios = numbers[1:] / numbers[:-1]
    return np.allclose(ratios, ratios[0], rtol=0.02)


def label_axis(axis, values):
    """Round numbers where the scale is a logarithmic one, else the values themselves."""
    if not is_even_in_logarithms(values) or "e" in "".join(values):
        axis.set_ticks(range(len(values)), [in_words(short(value)) for value in values])
        return
    first, last = float(values[0]), float(values[-1])
    per_decade = (1,) if max(last / first, first / last) > 1e3 else (1, 2, 5)
    ticks = [digit * 10.0**power for power in range(-4, 3) for digit in per_decade]
    ticks = [tick for tick in ticks if 0.99 * min(first, last) < tick < 1.01 * max(first, last)]
    axis.set_ticks([(len(values) - 1) * math.log(tick / first) / math.log(last / first) for tick in ticks],
                   [f"{tick:g}" for tick in ticks])


def draw_panel(axes, name, rows):
    """Of one method (or backend) the map with its axes."""
    columns, lines = (list(dict.fromkeys(row[axis] for row in rows)) for axis in "xy")
    draw_map(axes, rows, columns, lines)
    label_axis(axes.xaxis, columns)
    label_axis(axes.yaxis, lines)
    if len("".join(label.get_text() for label in axes.get_xticklabels())) > 25:
        axes.tick_params(axis="x", rotation=45)
    axes.set(xlabel=scenes.MAPS[name].x, ylabel=scenes.MAPS[name].y)


def panels():
    return plt.subplots(2, 2, figsize=(style.WIDTH, 5.4))


def map_figure(name, rows):
    figure, grid = panels()
    for axes, method in zip(grid.flat, scenes.MAPS[name].shown):
        own = [row for row in rows if row["method"] == method]
        draw_panel(axes, name, own)
        axes.set_title(f"{method}: solves {sum(row['verdict'] in SOLVED for row in own)} of {len(own)}")
        axes.label_outer()
    add_legend(figure, {row["verdict"] for row in rows if row["method"] in scenes.MAPS[name].shown})
    style.headline(figure, scenes.MAPS[name].message)
    return figure


def add_legend(figure, found):
    handles = [Patch(color=shade(n), label=f"{n} iterations") for n in (5, 50, 500)]
    handles += [Patch(facecolor=colour, hatch=hatching, edgecolor="0.25", linewidth=0.5, label=words)
                for kind, (colour, hatching, words) in KINDS.items() if kind in found]
    style.legend_below(figure, handles, [handle.get_label() for handle in handles], min(len(handles), 4))


def figures(rows):
    found = {row["map"] for row in rows}
    return {f"map_{name}": map_figure(name, [row for row in rows if row["map"] == name])
            for name in scenes.MAPS if name in found}


def count_table(rows):
    names = list(dict.fromkeys(row["map"] for row in rows))
    text = "| method | " + " | ".join(names) + " | all |\n" + "|---" * (len(names) + 2) + "|\n"
    for method in METHODS:
        cells = []
        for name in (*names, None):
            own = [row for row in rows if row["method"] == method and name in (row["map"], None)]
            n = sum(row["verdict"] in SOLVED for row in own)
            cells.append(f"{n} of {len(own)}" if own else "–")
        text += f"| `{method}` | " + " | ".join(cells) + " |\n"
    return text


def failure_table(rows):
    """Every point that the default method did not solve, and what it said."""
    failed = [row for row in rows if row["method"] == DEFAULT and row["verdict"] not in SOLVED]
    text = "| map | x | y | verdict | steps solved | other methods |\n|---|---|---|---|---|---|\n"
    for row in failed:
        others = ", ".join(f"{other['method']} {other['verdict']}" for other in rows if other is not row and
                           (other["map"], other["x"], other["y"]) == (row["map"], row["x"], row["y"]))
        text += f"| {row['map']} | {short(row['x'])} | {short(row['y'])} | {row['verdict']} | {row['steps']} | {others} |\n"
    return text if failed else "None.\n"


def tables(rows):
    return {"counts": count_table(rows), "failures": failure_table(rows)}
