# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What a counterbody costs: a rigid plane, an elastic half-space and a second body like the first, in turns.

Case B on meshes that grow. The bodies and meshes are alike, so that what a second one costs is what the first costs."""
import json
import statistics

import matplotlib.pyplot as plt
import style
from points import StudyError, program_point

PAGE = "performance.md"
KINDS = ("rigid", "half-space", "body")
SIZES, QUICK = (6, 8, 12), (4,)  # core cells
RUNS = 3
BODY = ("mesh", "assembly", "factorization", "condensation")


def measures(result, point):
    if result.code != 0:
        raise StudyError(f"exit code {result.code}: {point.command}\n{result.errors}")
    summary = json.loads((result.folder / "summary.json").read_text(encoding="utf-8"))
    return {"nodes": summary["model"]["contact_nodes"], "steps": summary["steps"]["solved"],
            **{name: f"{summary['seconds'][name]:.4f}" for name in (*BODY, "contact", "checks")}}


def settings(kind, cells):
    mesh = {"Core cells": cells, "Rings": cells, "Layers": cells // 2, "Degree": 2}
    entries = {"Obstacle/Kind": kind, "Output/Contact fields": 0, "Load program/Cycles": 1,
               **{f"Mesh/{entry}": value for entry, value in mesh.items()}}
    if kind == "body":
        entries |= {f"Lower mesh/{entry}": value for entry, value in mesh.items()}
    return entries


def measured(context):
    points = [program_point({"run": run, "cells": cells, "kind": kind}, "paper/case_b.prm", settings(kind, cells),
                            "--threads", "1")
              for run in range(1 if context.is_quick else RUNS) for cells in (QUICK if context.is_quick else SIZES)
              for kind in KINDS]
    return context.measure(points, measures, threads=1)


def ratios_of(rows):
    """{cells: {name: ratio}}: medians over the runs, each with its own plane."""
    found = {}
    for cells in sorted({int(row["cells"]) for row in rows}):
        runs = {}
        for row in rows:
            if int(row["cells"]) == cells:
                runs.setdefault(row["run"], {})[row["kind"]] = row
        found[cells] = {name: statistics.median(of(run) for run in runs.values()) for name, of in RATIOS.items()}
        found[cells]["nodes"] = int(next(iter(runs.values()))["rigid"]["nodes"])
    return found


def body(row):
    return sum(float(row[name]) for name in BODY)


def added(run, kind):
    """What a counterbody adds to set-up, relative to what one body takes to be meshed, factorized and condensed."""
    return (body(run[kind]) - body(run["rigid"])) / body(run["rigid"])


def each_step(run, kind, phase):
    return float(run[kind][phase]) / float(run["rigid"][phase])


RATIOS = {
    "set-up added by a half-space / a body's": lambda run: added(run, "half-space"),
    "set-up added by a second body / a body's": lambda run: added(run, "body"),
    "contact on a half-space / on a plane": lambda run: each_step(run, "half-space", "contact"),
    "contact on a second body / on a plane": lambda run: each_step(run, "body", "contact"),
    "checks on a second body / on a plane": lambda run: each_step(run, "body", "checks"),
}


def figures(rows):
    found = ratios_of(rows)
    figure, axes = plt.subplots(figsize=(8.5, 3.4))
    nodes = [ratios["nodes"] for ratios in found.values()]
    for number, name in enumerate(RATIOS):
        axes.plot(nodes, [ratios[name] for ratios in found.values()], "o-", color=style.COLOURS[number % len(style.COLOURS)],
                  label=name)
    axes.axhline(1, color="0.6", linewidth=1)
    axes.set(xlabel="contact nodes of the model", ylabel="ratio", ylim=(0, None))
    axes.legend(fontsize=8, loc="upper left", bbox_to_anchor=(1.02, 1))
    return {"counterbodies": figure}


def tables(rows):
    found = ratios_of(rows)
    text = "| ratio | " + " | ".join(f"{ratios['nodes']} nodes" for ratios in found.values()) + " |\n"
    text += "|---|" + "--:|" * len(found) + "\n"
    for name in RATIOS:
        text += f"| {name} | " + " | ".join(f"{ratios[name]:.2f}" for ratios in found.values()) + " |\n"
    return {"counterbodies": text}
