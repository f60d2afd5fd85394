# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What a counterbody costs: a rigid plane, an elastic half-space and a second body a third as stiff, in turns.

Case B on meshes that grow. The bodies have equal meshes, so that what the second one costs is what the first costs. On each
of the three the base slips: on a second body that is like the first it would not."""
import statistics

import matplotlib.pyplot as plt
import style
from points import StudyError, program_point
from run_folder import RunFolder

PAGE = "performance.md"
KINDS = ("rigid", "half-space", "body")
SIZES, QUICK = (6, 8, 12), (4,)  # core cells
RUNS, QUICK_RUNS = 3, 2
BODY = ("mesh", "assembly", "factorization", "condensation")
SOFTER = {"Lower material/Young modulus": 70000}  # that of case B is 210000


def measures(result, point):
    if result.code != 0:
        raise StudyError(f"exit code {result.code}: {point.command}\n{result.errors}")
    run = RunFolder(result.folder)
    summary, history = run.summary, run.history
    pressed = sum(history[name].sum() for name in ("n_stick", "n_slip"))
    return {"nodes": summary["model"]["contact_nodes"], "steps": summary["steps"]["solved"],
            "iterations": int(history["iterations"].sum()), "slipping": f"{history['n_slip'].sum() / pressed:.4f}",
            **{name: f"{summary['seconds'][name]:.4f}" for name in (*BODY, "contact", "checks")}}


def run_point(run, cells, kind):
    """The probe's name sets the repetitions apart, which are otherwise the same command."""
    mesh = {"Core cells": cells, "Rings": cells, "Layers": cells // 2, "Degree": 2}
    entries = {"Obstacle/Kind": kind, "Output/Contact fields": 0, "Load program/Cycles": 1, "Output/Probes": f"run-{run}: 0 0",
               **{f"Mesh/{entry}": value for entry, value in mesh.items()}}
    if kind == "body":
        entries |= {**SOFTER, **{f"Lower mesh/{entry}": value for entry, value in mesh.items()}}
    return program_point({"run": run, "cells": cells, "kind": kind}, "paper/case_b.prm", entries, "--threads", "1")


def measured(context):
    runs, sizes = (QUICK_RUNS, QUICK) if context.is_quick else (RUNS, SIZES)
    return context.measure([run_point(run, cells, kind) for run in range(1, runs + 1) for cells in sizes for kind in KINDS],
                           measures, threads=1)


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


def each_step(run, kind, column):
    """All runs have the same steps, and the same number of contact nodes."""
    return float(run[kind][column]) / float(run["rigid"][column])


RATIOS = {
    "set-up added by a half-space / a body's": lambda run: added(run, "half-space"),
    "set-up added by a second body / a body's": lambda run: added(run, "body"),
    "contact on a half-space / on a plane": lambda run: each_step(run, "half-space", "contact"),
    "contact on a second body / on a plane": lambda run: each_step(run, "body", "contact"),
    "iterations on a half-space / on a plane": lambda run: each_step(run, "half-space", "iterations"),
    "iterations on a second body / on a plane": lambda run: each_step(run, "body", "iterations"),
    "checks on a second body / on a plane": lambda run: each_step(run, "body", "checks"),
    "nodes that slip, on a plane / all": lambda run: float(run["rigid"]["slipping"]),
    "nodes that slip, on a half-space / all": lambda run: float(run["half-space"]["slipping"]),
    "nodes that slip, on a second body / all": lambda run: float(run["body"]["slipping"]),
}


CHARTS = {  # title: {name of a ratio: label, colour}
    "set-up added, relative to a body's": {
        "set-up added by a half-space / a body's": ("half-space", style.COLOURS[0]),
        "set-up added by a second body / a body's": ("second body", style.COLOURS[1])},
    "time in the steps, relative to a plane": {
        "contact on a half-space / on a plane": ("half-space", style.COLOURS[0]),
        "contact on a second body / on a plane": ("second body", style.COLOURS[1]),
        "checks on a second body / on a plane": ("second body, checks alone", style.COLOURS[2])}}


def figures(rows):
    found = ratios_of(rows)
    figure, grid = plt.subplots(1, len(CHARTS), figsize=(style.WIDTH, 3.2))
    nodes = [ratios["nodes"] for ratios in found.values()]
    for axes, (title, lines) in zip(grid, CHARTS.items()):
        for name, (label, colour) in lines.items():
            axes.plot(nodes, [ratios[name] for ratios in found.values()], "o-", color=colour, label=label)
        axes.axhline(1, color="0.6", linewidth=1)
        axes.set(title=title, xlabel="contact nodes", ylim=(0, None))
    style.legend_below(figure, *grid[1].get_legend_handles_labels(), 3)
    style.headline(figure, "The set-up of a half-space costs an eighth to a quarter of a second body's")
    return {"counterbodies": figure}


def tables(rows):
    found = ratios_of(rows)
    text = "| ratio | " + " | ".join(f"{ratios['nodes']} nodes" for ratios in found.values()) + " |\n"
    text += "|---|" + "--:|" * len(found) + "\n"
    for name in RATIOS:
        text += f"| {name} | " + " | ".join(f"{ratios[name]:.2f}" for ratios in found.values()) + " |\n"
    return {"counterbodies": text}
