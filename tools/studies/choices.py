# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What `Mesh/Backend = auto` costs where both backends are good: random scenes with halved cells, on both."""
import itertools
import random

import scenes
from points import Point, StudyError, program_point
from run_folder import RunFolder

PAGE = "performance.md"
FILE = "paper/scene.prm"
BACKENDS = ("condensed", "multigrid")
N_SCENES, N_QUICK = 12, 1


def scene(seed):
    """A scene of the map `random` on cells that are halved, and that are not as far from even."""
    chance = random.Random(f"halved {seed}")
    degree = chance.choice((1, 2, 2, 3))
    return {**scenes.random_scene(seed), "Mesh/Degree": degree, "Mesh/Refinements": 2 if degree == 1 else 1,
            "Mesh/Core cells": chance.choice((2, 4)), "Mesh/Rings": chance.randint(1, 3), "Mesh/Layers": chance.randint(2, 4),
            "Mesh/Rim grading": f"{chance.uniform(0.5, 1):.4g}", "Mesh/Layer grading": f"{chance.uniform(0.5, 1):.4g}",
            "Material/Poisson ratio": chance.choice((0.2, 0.3, 0.3, 0.45)), "Load program/Cycles": chance.choice((1, 1, 3))}


def points_of(seed):
    settings = scene(seed)
    words = [word for entry, value in settings.items() for word in ("--set", f"{entry}={value}")]
    yield Point({"scene": seed, "backend": "auto"}, ["build/orthocone", f"prm/{FILE}", "--check", *words])
    for backend in BACKENDS:
        yield program_point({"scene": seed, "backend": backend}, FILE, {**settings, "Mesh/Backend": backend})


def measures(result, point):
    if result.code != 0:
        raise StudyError(f"exit code {result.code}: {point.command}\n{result.errors}")
    if point.columns["backend"] == "auto":
        line = next((line for line in result.output.splitlines() if line.startswith("backend")), "backend condensed")
        return {"chosen": line.split()[1], "unknowns": "", "steps": "", "seconds": ""}
    summary = RunFolder(result.folder).summary
    return {"chosen": "", "unknowns": summary["model"]["free_dofs"], "steps": summary["steps"]["solved"],
            "seconds": f"{result.cpu_seconds:.3f}"}


def measured(context):
    seeds = range(N_QUICK if context.is_quick else N_SCENES)
    return context.measure([point for seed in seeds for point in points_of(seed)], measures, threads=1)


def figures(_):
    return {}


def tables(rows):
    text = "| unknowns | degree | ν | steps | condensed (s) | multigrid (s) | `auto` takes | its time / the least |\n" + "|--:" * 6 + "|---|--:|\n"
    found = []
    for seed, group in itertools.groupby(rows, lambda row: row["scene"]):
        auto, *runs = group
        seconds = {row["backend"]: float(row["seconds"]) for row in runs}
        settings = scene(int(seed))
        found.append((int(runs[0]["unknowns"]), settings["Mesh/Degree"], settings["Material/Poisson ratio"], runs[0]["steps"],
                      *(f"{seconds[backend]:.2f}" for backend in BACKENDS), auto["chosen"],
                      f"{seconds[auto['chosen']] / min(seconds.values()):.2f}"))
    return {"choices": text + "".join("| " + " | ".join(str(value) for value in row) + " |\n" for row in sorted(found))}
