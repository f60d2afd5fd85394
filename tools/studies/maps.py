# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Where methods fail: every method over friction, body, mesh, load steps, tolerance, rho and unloading."""
import itertools
import math

import matplotlib.pyplot as plt
import numpy as np

import scenes
import verdicts
from points import program_point
from style import METHODS

PAGE = "stability.md"
DEFAULT = "newton"
DEFAULT_ITERATIONS = 5000
MOST_ITERATIONS = 2000  # of methods other than the default, which has the program's
RANDOM_METHODS = (DEFAULT, "gauss-seidel", "uzawa")

# Verdict: (colour, letter in the cell). Converged cells are shaded by their iterations instead.
KINDS = {"slow": ("#e69f00", "s"), "cycling": ("#cc79a7", "c"), "diverged": ("#000000", "d"), "rounding": ("#999999", "r"),
         "other": ("#d55e00", "o"), "divided": ("#9ecae1", "h"), "check": ("#ff0000", "x"), "no-model": ("#ffffff", "-")}
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
    for name, (make, _, _, left_out) in list(scenes.MAPS.items())[:2 if is_quick else None]:
        for x, y, settings in make(2) if is_quick else make():
            for method in METHODS:
                if method not in left_out:
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
    image = np.ones((len(lines), len(columns), 4))
    for row in rows:
        place = lines.index(row["y"]), columns.index(row["x"])
        if row["verdict"] == "converged":
            image[place] = shade(int(row["iterations"]))
        else:
            colour, letter = KINDS[row["verdict"]]
            image[place] = plt.matplotlib.colors.to_rgba(colour)
            axes.text(place[1], place[0], letter, ha="center", va="center", fontsize=6,
                      color="white" if letter in "d" else "black")
    axes.imshow(image, origin="lower", aspect="auto")
    axes.grid(False)


def short(value):
    try:
        return f"{float(value):.4g}" if 0.499 < float(value) < 0.5 else f"{float(value):.3g}"  # a Poisson's ratio
    except ValueError:
        return value


def label_axis(axis, values, most=10):
    every = math.ceil(len(values) / most)
    axis.set_ticks(range(0, len(values), every), [short(value) for value in values[::every]], fontsize=7)


def map_figure(name, rows):
    _, x_label, y_label, left_out = scenes.MAPS[name]
    methods = [method for method in METHODS if method not in left_out]
    columns = list(dict.fromkeys(row["x"] for row in rows))
    lines = list(dict.fromkeys(row["y"] for row in rows))
    n_columns = 3 if len(methods) > 4 else 2
    n_lines = math.ceil(len(methods) / n_columns)
    figure = plt.figure(figsize=(3.4 * n_columns, 2.9 * n_lines + 0.4))
    maps, legend = figure.subfigures(2, 1, height_ratios=(2.9 * n_lines, 0.4))
    grid = maps.subplots(n_lines, n_columns, squeeze=False, sharex=True, sharey=True)
    for axes, method in zip(grid.flat, methods):
        own = [row for row in rows if row["method"] == method]
        draw_map(axes, own, columns, lines)
        n = sum(row["verdict"] in SOLVED for row in own)
        axes.set_title(f"{method}: {n} of {len(own)}", fontsize=9)
        label_axis(axes.xaxis, columns)
        label_axis(axes.yaxis, lines)
        axes.tick_params(axis="x", rotation=45)
    for axes in grid[-1]:
        axes.set_xlabel(x_label)
    for axes in grid[:, 0]:
        axes.set_ylabel(y_label)
    add_legend(legend, {row["verdict"] for row in rows})
    return figure


def add_legend(figure, found):
    patch = plt.matplotlib.patches.Patch
    handles = [patch(color=shade(n), label=f"{n} iterations") for n in (5, 50, 500)]
    handles += [patch(facecolor=colour, edgecolor="grey", label=f"{letter}: {kind}")
                for kind, (colour, letter) in KINDS.items() if kind in found]
    figure.legend(handles=handles, loc="center", ncols=len(handles), fontsize=7)


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
