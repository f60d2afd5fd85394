# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Error against processor time on the printed examples of CONTACT: Spence's compression, equal spheres, stress below Hertz.

CONTACT is a program of boundary elements for half-spaces. What it prints stands beside; its times are not measured here."""
import matplotlib.pyplot as plt
import style
from points import StudyError, program_point
from rows import ROWS
from run_folder import RunFolder

PAGE = "verification.md"
# Scene, row of the book, label, what CONTACT prints (None: no digit of it errs), and the settings of meshes, coarse first.
SECTION = [{"Mesh/Degree": 3, "Mesh/Core cells": n, "Mesh/Rings": 2 * n // 5, "Mesh/Layers": n, "Mesh/Layer grading": 0.8**(40 / n),
            "Mesh/Rim grading": 1.25**(40 / n)} for n in (10, 20, 40, 80)]
EXAMPLES = {
    "spence": ("spence.c", "Spence: c/a, 35 load steps", None, [{"Mesh/Core cells": n} for n in (24, 48, 96)]),
    "equal": ("equal.shift", "equal spheres: shift at 7/8 of sliding", 0.008155, [{"Mesh/Core cells": n} for n in (4, 6, 8, 12)]),
    "hertz": ("hertz.shear", "Hertz: largest shear below the surface", None, SECTION)}
STUCK = {"Friction/Coefficients": "100, 100", "Load program/Legs": "Fx 3.21839 : 1"}


def row_of(example):
    return next(row for row in ROWS if row.id == EXAMPLES[example][0])


def points_of(example, meshes):
    row = row_of(example)
    settings = dict(setting.split("=", 1) for setting in row.scene.settings if not setting.startswith("Mesh/"))
    if example == "spence":
        settings = {"Output/Contact fields": 35}
    runs = [{}, STUCK] if example == "equal" else [{}]
    return [program_point({"example": example, "cells": mesh["Mesh/Core cells"], "stuck": int(more is STUCK)},
                          f"verification/{row.scene.file}.prm", {**settings, **mesh, **more}) for mesh in meshes for more in runs]


def measures(result, point):
    if result.code != 0:
        raise StudyError(f"exit code {result.code}: {point.command}\n{result.errors}")
    run, example = RunFolder(result.folder), point.columns["example"]
    if example == "equal":
        ours = float(run.history["ux"][-1])
    elif example == "spence":
        import sheared
        ours = sheared.spence_stick(35)(lambda scene: run, None)
    else:
        ours = row_of(example).measured(lambda scene: run, None)
    return {"ours": ours, "cpu_seconds": f"{result.cpu_seconds:.2f}"}


def measured(context):
    points = []
    for example, (_, _, _, meshes) in EXAMPLES.items():
        points += points_of(example, meshes[:2] if context.is_quick else meshes)
    return context.measure(points, measures, threads=1)


def differences(rows):
    """{example: [(processor seconds, relative error)]}."""
    import sheared
    found = {}
    for example in EXAMPLES:
        exact = row_of(example).reference
        own = [row for row in rows if row["example"] == example]
        free, stuck = ([row for row in own if int(row["stuck"]) == is_stuck] for is_stuck in (0, 1))
        for number, row in enumerate(free):
            ours = float(row["ours"])
            if example == "equal":
                ours += sheared.SOFT_SPHERE.stuck_shift(sheared.PULL) - float(stuck[number]["ours"])
            found.setdefault(example, []).append((float(row["cpu_seconds"]), abs(ours / exact - 1)))
    return found


def figures(rows):
    figure, axes = plt.subplots(figsize=(style.WIDTH, 3.6))
    for colour, (example, errors) in zip(style.COLOURS, differences(rows).items()):
        _, label, printed, _ = EXAMPLES[example]
        axes.plot(*zip(*[(seconds, 100 * error) for seconds, error in errors]), "o-", color=colour, label=label)
        if printed:
            axes.axhline(100 * abs(printed / row_of(example).reference - 1), color=colour, linewidth=1, linestyle="--",
                         label="the same, printed by CONTACT")
    axes.set(xscale="log", yscale="log", xlabel="processor time (s)", ylabel="difference from theory (%)", ylim=(0.03, 5))
    axes.minorticks_off()
    style.plain_ticks(axes.xaxis, (0.5, 1, 2, 5, 10))
    style.plain_ticks(axes.yaxis, (0.05, 0.1, 0.2, 0.5, 1, 2, 5))
    style.legend_below(figure, *axes.get_legend_handles_labels(), 2)
    style.headline(figure, "A few seconds are enough for a difference of about 1 %")
    return {"contact_examples": figure}
