# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The scenes of the maps of failure by the default method on both backends: factorized, and on the whole body."""
import itertools

import maps
import scenes
import style
import verdicts
from points import program_point

PAGE = "stability.md"
BACKENDS = ("condensed", "multigrid")
SOLVED = maps.SOLVED
SHOWN = {"friction": "friction and slip rule", "body": "body", "mesh": "case, degree, grading", "unloading": "end of unloading"}


def point_of(name, x, y, backend, settings):
    tolerance = settings.get("Contact solver/Tolerance", 1e-10)
    return program_point({"map": name, "x": x, "y": y, "method": backend, "tolerance": tolerance},
                         "paper/scene.prm", {**settings, "Mesh/Backend": backend})


def all_points(is_quick):
    found = [(name, *point) for name, of_map in list(scenes.MAPS.items())[:1 if is_quick else None]
             for point in (of_map.make(2) if is_quick else of_map.make())]
    found += [("random", *point) for point in scenes.random_scenes(2 if is_quick else 200)]
    return [point_of(name, x, y, backend, settings) for name, x, y, settings in found for backend in BACKENDS]


def measured(context):
    rows = context.measure(all_points(context.is_quick), verdicts.outcome, jobs=context.jobs, threads=1)
    rows = [dict(row) for row in rows]
    return [row for _, group in itertools.groupby(rows, lambda row: (row["map"], row["x"], row["y"]))
            for row in verdicts.with_agreement(list(group), lambda _: maps.DEFAULT_ITERATIONS)]


def figures(rows):
    """Iterations and verdicts on the whole body, of the maps that are not the same everywhere."""
    there = {row["map"] for row in rows}
    figure, grid = maps.panels()
    for axes, name in zip(grid.flat, [name for name in SHOWN if name in there]):
        own = [row for row in rows if (row["map"], row["method"]) == (name, "multigrid")]
        maps.draw_panel(axes, name, own)
        axes.set_title(f"{SHOWN[name]}: {sum(row['verdict'] in SOLVED for row in own)} of {len(own)}")
    maps.add_legend(figure, {row["verdict"] for row in rows if row["method"] == "multigrid" and row["map"] in SHOWN})
    style.headline(figure, "Multigrid solves nearly every scene of the maps")
    return {"map_backends": figure}


def pairs(rows):
    """Of every point the rows of both backends."""
    return [tuple(group) for _, group in itertools.groupby(rows, lambda row: (row["map"], row["x"], row["y"]))]


def count_table(rows):
    names = list(dict.fromkeys(row["map"] for row in rows))
    text = "| | " + " | ".join(names) + " | all |\n" + "|---" * (len(names) + 2) + "|\n"
    kinds = {**{f"`{backend}` solves": lambda pair, i=i: pair[i]["verdict"] in (*SOLVED, "other") for i, backend in enumerate(BACKENDS)},
             "both, the same state": lambda pair: all(row["verdict"] == "converged" for row in pair),
             "neither solves": lambda pair: not any(row["verdict"] in (*SOLVED, "other") for row in pair)}
    for kind, holds in kinds.items():
        cells = []
        for name in (*names, None):
            own = [pair for pair in pairs(rows) if name in (pair[0]["map"], None)]
            cells.append(f"{sum(holds(pair) for pair in own)} of {len(own)}")
        text += f"| {kind} | " + " | ".join(cells) + " |\n"
    return text


def difference_table(rows):
    """Every point where the backends did not come to the same end."""
    text = "| map | x | y | condensed | multigrid | steps of multigrid |\n|---|---|---|---|---|---|\n"
    differ = [pair for pair in pairs(rows) if any(row["verdict"] != "converged" for row in pair)]
    for condensed, multigrid in differ:
        text += (f"| {multigrid['map']} | {maps.short(multigrid['x'])} | {maps.short(multigrid['y'])} | "
                 f"{condensed['verdict']} | {multigrid['verdict']} | {multigrid['steps']} |\n")
    return text if differ else "None.\n"


def tables(rows):
    return {"backend counts": count_table(rows), "backend differences": difference_table(rows)}
