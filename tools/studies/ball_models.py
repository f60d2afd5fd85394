# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Error against time of four models of a ball on a plate: section, solid, adaptive multigrid, and half-spaces on a grid.

Pressed without friction by Hertz, and sheared on a plate of the same material by Cattaneo, with orthotropic friction."""
import math
import sys

import matplotlib.pyplot as plt
import style
from paths import ROOT
from points import StudyError, program_point
from run_folder import RunFolder

sys.path.insert(0, str(ROOT / "tools/book"))
from measure import gyration, left_by_slip, normal  # noqa: E402

PAGE = "accuracy.md"
PRESS, SHEAR = "pressed: contact radius", "sheared: radius that sticks"
EXACT = {PRESS: 0.5, SHEAR: 0.5 * (1 - 17.5 / (0.3 * 175)) ** (1 / 3)}
FILES = {PRESS: "hertz", SHEAR: "orthotropic_sphere"}
LEGS = {PRESS: "Fz -384.615 : 1", SHEAR: "Fx 17.5 : 4"}
MODELS = ("section", "solid", "solid, adaptive multigrid", "half-space")
SOLIDS = ((6, 3, 5), (8, 4, 7), (12, 6, 10), (16, 8, 13), (20, 10, 16))  # core cells, rings, layers
GRIDS = (16, 32, 64, 128, 256)
LEAST = 1e-3  # percent; smaller errors are drawn there


def solid(core, rings, layers):
    """Meshes of which each is as the others between its nodes: gradings are those of 12 core cells, to their share."""
    return {"Mesh/Core cells": core, "Mesh/Core ratio": 0.1, "Mesh/Rings": rings, "Mesh/Layers": layers,
            "Mesh/Rim grading": f"{1.9 ** (6 / rings):.4f}", "Mesh/Layer grading": f"{0.42 ** (10 / layers):.4f}"}


def meshes(scene):
    """(model, size, settings) of each point."""
    if scene == PRESS:
        yield from (("section", core, {**solid(core, core // 2, core), "Mesh/Model": "axisymmetric"})
                    for core in (8, 16, 32, 64))
    for sizes in SOLIDS:
        yield "solid", sizes[0], {**solid(*sizes), "Mesh/Model": "quarter" if scene == PRESS else "auto"}
    if scene == PRESS:  # on a rigid plate
        for rounds in (1, 2, 3, 4):
            yield "solid, adaptive multigrid", rounds, {**solid(*SOLIDS[0]), "Mesh/Model": "quarter", "Mesh/Adaptive": rounds,
                                                        "Mesh/Backend": "multigrid"}
    for n in GRIDS:
        yield "half-space", n, {"Geometry/Shape": "half-space", "Geometry/Sizes": "1.2, 1.2", "Mesh/Cells": f"{n}, {n}"}


def figures_of_run(result, point):
    if result.code != 0:
        raise StudyError(f"exit code {result.code}: {point.command}\n{result.errors}")
    run, scene = RunFolder(result.folder), point.columns["scene"]
    step = run.contact_steps()[-1]
    weight = normal if scene == PRESS else left_by_slip(0.3, 0)
    radius = math.sqrt(2.5) * float(math.hypot(*gyration(run, step, weight)))
    return {"contact_nodes": run.summary["model"]["contact_nodes"], "cpu_seconds": f"{result.cpu_seconds:.3f}",
            "gigabytes": f"{result.gigabytes:.3f}", "radius": f"{radius:.9g}",
            "error_percent": f"{100 * (radius / EXACT[scene] - 1):.4g}"}


def measured(context):
    points = []
    for scene, file in FILES.items():
        for model, size, settings in meshes(scene):
            if context.is_quick and size not in (6, 8, 16):
                continue
            last = 1 if scene == PRESS else 5
            points.append(program_point({"scene": scene, "model": model, "size": size}, f"verification/{file}.prm",
                                        {"Load program/Legs": LEGS[scene], "Output/Volume fields": 0,
                                         "Output/Contact fields": last, **settings}))
    return context.measure(points, figures_of_run, threads=1)


def figures(rows):
    figure, grid = plt.subplots(1, 2, figsize=(style.WIDTH, 3.4), sharey=True)
    for axes, scene in zip(grid, FILES):
        axes.set_title(scene)
        for colour, model in zip(style.COLOURS, MODELS):
            line = [row for row in rows if row["scene"] == scene and row["model"] == model]
            if line:
                axes.loglog([float(row["cpu_seconds"]) for row in line],
                            [max(abs(float(row["error_percent"])), LEAST) for row in line], "o-", color=colour, label=model)
        axes.set_xlabel("processor time of the run (s)")
        style.plain_ticks(axes.xaxis, (0.3, 1, 3, 10, 30, 100))
        style.plain_ticks(axes.yaxis)
    grid[0].set_ylabel("error (%)")
    style.legend_below(figure, *grid[0].get_legend_handles_labels(), 4)
    style.headline(figure, "A ball on a plate needs no volume: half-spaces are the fastest")
    return {"ball_models": figure}


def tables(rows):
    text = "| scene | model | contact nodes | seconds | GB | error |\n|---|---|--:|--:|--:|--:|\n"
    for row in rows:
        text += (f"| {row['scene']} | {row['model']} | {row['contact_nodes']} | {float(row['cpu_seconds']):.2f} | "
                 f"{float(row['gigabytes']):.2f} | {float(row['error_percent']):+.3f} % |\n")
    return {"ball models": text}
