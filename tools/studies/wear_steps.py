# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Steps that wear too deep: what a node loses in a step against what pressure flattens it by, and the volume that is missing.

Steps are explicit. The sphere of prm/verification/worn_sphere.prm with ten times its coefficient, on which a step wears 3.6 times as deep as
pressure flattens a node. More steps for the same way wear less in each. Archard's law says what volume is worn."""
import re

import matplotlib.pyplot as plt
import numpy as np
import style
from points import StudyError, program_point
from run_folder import RunFolder

PAGE = "stability.md"
COEFFICIENT, FORCE, CYCLES = 0.01, 20, 4
WAY = 4  # of a cycle, mm
FACTORS, QUICK = (1, 2, 3, 4, 5, 6, 8), (1, 4)
BOUND, LEAST = 0.9, 1e-4
RADIUS = 100  # mm


def legs(factor):
    return f"ux 1 : {20 * factor} ; ux -1 : {40 * factor} ; ux 0 : {20 * factor}"


def ratio_of(run):
    """Of the warning; nothing where there is none."""
    found = re.search(r"wears a node ([\d.]+) times as deep", "\n".join(run.summary["warnings"]))
    return float(found[1]) if found else ""


def as_text(values):
    return " ".join(f"{value:.5g}" for value in values)


def measures(result, point):
    if result.code != 0:
        raise StudyError(f"exit code {result.code}: {point.command}\n{result.errors}")
    run = RunFolder(result.folder)
    contact = run.contact(run.contact_steps()[-1])
    on = np.flatnonzero((np.abs(contact.points[:, 1]) < 1e-6) & (np.abs(contact.points[:, 0]) < 8))
    x, one = np.unique(np.round(contact.points[on, 0], 6), return_index=True)
    return {"ratio": ratio_of(run), "worn_volume": run.history["worn_volume"][-1],
            "cpu_seconds": f"{result.cpu_seconds:.3f}", "x": as_text(x),
            **{name: as_text(contact[name][on[one]]) for name in ("wear_depth", "pressure")}}


def measured(context):
    cycles = 1 if context.is_quick else CYCLES
    points = []
    for factor in QUICK if context.is_quick else FACTORS:
        settings = {"Wear/Coefficient": COEFFICIENT, "Wear/Deep steps": "explicit", "Load program/Cycles": cycles,
                    "Load program/Legs": legs(factor), "Output/Contact fields": 8 + 80 * factor * cycles}
        points.append(program_point({"steps": 80 * factor, "cycles": cycles}, "verification/worn_sphere.prm", settings))
    return context.measure(points, measures, jobs=context.jobs, threads=1)


def wanted(row):
    """Volume by Archard's law, mm^3."""
    return COEFFICIENT * FORCE * WAY * int(row["cycles"])


def missing(row):
    """Part of that volume, %."""
    return 100 * (1 - float(row["worn_volume"]) / wanted(row))


def curves(axes, rows, name, factor=1):
    """Along the line through the centre: the fewest steps, and the fewest that are within the bound."""
    ends = (rows[0], next((row for row in rows if not row["ratio"]), rows[-1]))
    for row, colour, mark in zip(ends, (style.COLOURS[1], style.COLOURS[0]), ("o-", "s-")):
        x, values = (np.array(row[column].split(), dtype=float) for column in ("x", name))
        axes.plot(x, factor * values, mark, markersize=3, color=colour, label=f"{row['steps']} load steps of a cycle")
    axes.set_xlabel("x (mm)")


def losses(axes, rows):
    shown = [(int(row["steps"]), max(missing(row), LEAST), row["ratio"]) for row in rows]
    axes.plot(*zip(*(one[:2] for one in shown)), "o-", color=style.COLOURS[0])
    for steps, share, ratio in shown:
        if ratio:
            axes.annotate(f"{ratio} times", (steps, share), xytext=(6, 3), textcoords="offset points", fontsize=8)
    axes.set(yscale="log", xlabel="load steps of a cycle", ylabel="worn volume\nthat is missing (%)")
    axes.text(1, 0.95, "at the points: depth that a step wears,\ncompared with the flattening by pressure", ha="right", va="top",
              fontsize=8, transform=axes.transAxes)
    axes.minorticks_off()
    axes.set_yticks([LEAST, 0.001, 0.01, 0.1, 1, 10], ["none", "0.001", "0.01", "0.1", "1", "10"])


def figures(rows):
    figure, axes = plt.subplot_mosaic([["losses", "losses"], ["pressure", "depth"]], figsize=(style.WIDTH, 4.8))
    losses(axes["losses"], rows)
    curves(axes["pressure"], rows, "pressure")
    axes["pressure"].set_ylabel("pressure, last step (MPa)")
    curves(axes["depth"], rows, "wear_depth", 1e3)
    deep = np.sqrt(wanted(rows[0]) / (np.pi * RADIUS))  # of the cap of the sphere: V = pi R h^2
    r = np.linspace(-1, 1, 200) * np.sqrt(2 * RADIUS * deep)
    axes["depth"].plot(r, 1e3 * (deep - r**2 / (2 * RADIUS)), color="0.3", linewidth=1, label="cap of the sphere (Archard's law)")
    axes["depth"].set_ylabel("worn depth (µm)")
    style.legend_below(figure, *axes["depth"].get_legend_handles_labels(), 3)
    style.headline(figure, "Steps that wear deeper than pressure flattens lose worn volume")
    return {"wear_steps": figure}


def tables(rows):
    text = ("| load steps of a cycle | depth of a step / flattening | worn volume that is missing |\n|--:|--:|--:|\n")
    for row in rows:
        text += f"| {row['steps']} | {row['ratio'] or f'below {BOUND}'} | {abs(missing(row)):.3f} % |\n"
    return {"wear steps": text}
