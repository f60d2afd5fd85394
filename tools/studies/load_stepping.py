# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Errors of slip history, hysteresis loop and dissipation against the number of load steps, beside those of the mesh.

The paper's cycle on a small mesh with few to many steps of unloading (loading is proportional, exact in any number),
and a program that presses once and then moves the top sideways on a path that turns. Cases B and C also with a
two-step formula for the slip, which the program does not have (experiments/trace.cc)."""
import csv
import io
import math

import numpy as np
import run_folder
import style
from points import StudyError, program_point, tool_point

plt = style.plt
PAGE = "accuracy.md"
SMALL = {"Mesh/Core cells": 4, "Mesh/Rings": 3, "Mesh/Layers": 4, "Mesh/Degree": 2}
ONE_CYCLE = {"Load program/Cycles": 1, "Output/Contact fields": 0, "Output/Volume fields": 0}
CYCLE_STEPS, CYCLE_REFERENCE = (5, 10, 20, 40, 80, 160), 1280
TURN_STEPS, TURN_REFERENCE = (1, 2, 4, 8), 32
QUANTITIES = {"slip": "slip history", "work": "loop (work of the top)", "dissipation": "dissipation"}
DRAWN = ("slip", "dissipation")  # the table has the loop, too


def cycle(steps):
    return {**ONE_CYCLE, "Load program/Legs": f"0 0 -0.1 : 5 ; 0 0 0 : {steps}"}


def turn(steps):
    """Along x, along y, and round a circle in 16 chords, with so many steps for each; four times as many along the
    straight legs."""
    radius = 0.05
    legs = [f"{radius} 0 -0.1 : {4 * steps}", f"{radius} {radius} -0.1 : {4 * steps}"]
    for chord in range(1, 17):
        angle = 2 * math.pi * chord / 16
        legs.append(f"{radius * math.cos(angle):.9f} {radius * (1 + math.sin(angle)):.9f} -0.1 : {steps}")
    return {**ONE_CYCLE, "Load program/Preload": "0 0 -0.1 : 1", "Load program/Legs": " ; ".join(legs)}


TWO_STEP = "two-step formula"  # its slips are those of the node nearest to the probe
PROGRAMS = {"cycle": (cycle, CYCLE_STEPS, CYCLE_REFERENCE), "turn": (turn, TURN_STEPS, TURN_REFERENCE)}


def columns(case, program, mesh, scheme, steps):
    return {"case": case.upper(), "load": program, "mesh": mesh, "scheme": scheme, "steps": steps}


def small_point(case, program, steps):
    return program_point(columns(case, program, "small", "backward Euler", steps), f"paper/case_{case}.prm",
                         {**SMALL, **PROGRAMS[program][0](steps)})


def two_step_point(case, program, steps):
    settings = {**SMALL, **PROGRAMS[program][0](steps)}
    words = [word for entry, value in settings.items() for word in ("--set", f"{entry}={value}")]
    return tool_point(columns(case, program, "small", TWO_STEP, steps), "slip_integration",
                      f"prm/paper/case_{case}.prm", *words, "--scheme", "bdf2")


def mesh_point(case, resolution):
    return program_point(columns(case, "cycle", resolution, "backward Euler", 10), f"paper/case_{case}.prm",
                         {"Mesh/Resolution": resolution, **cycle(10)})


def common(values, point):
    """Of the values after each step, those that every number of steps has."""
    steps = point.columns["steps"]
    if point.columns["load"] == "cycle":
        return [*values[:5], *values[4 + steps // 5::steps // 5]]
    return [values[0], *values[steps::steps]]


def as_text(vectors):
    return " ".join(f"{x:.9g},{y:.9g}" for x, y in vectors)


def extract(result, point):
    if result.code != 0:
        raise StudyError(f"{point.command}\n{result.errors.strip()}")
    if point.words[1] == "slip_integration":
        rows = [{name: float(value) for name, value in row.items()}
                for row in csv.DictReader(io.StringIO(result.output))]
        return {"slips": as_text(common([(row["slip_x"], row["slip_y"]) for row in rows], point)), "work": "",
                "dissipation": rows[-1]["dissipation"], "driven": rows[-1]["driven"], "max_slip": "",
                "seconds": f"{result.seconds:.2f}"}
    run = run_folder.RunFolder(result.folder)
    history, probe = run.history, run.probe("P")
    force, top = (np.vstack([np.zeros(3), np.stack([history[name + axis] for axis in "xyz"], 1)])
                  for name in ("force_", "u"))
    work = -np.sum(0.5 * (force[1:] + force[:-1]) * np.diff(top, axis=0))
    return {"slips": as_text(common(list(zip(probe["slip_x"], probe["slip_y"])), point)), "work": f"{work:.9g}",
            "dissipation": f"{history['total_dissipation'][-1]:.9g}", "driven": "",
            "max_slip": f"{history['max_slip'].max():.9g}", "seconds": f"{result.seconds:.2f}"}


def all_points(is_quick):
    if is_quick:
        return [small_point("b", "cycle", steps) for steps in (5, 10, 40)]
    points = [small_point(case, "cycle", steps) for case in "abc" for steps in (*CYCLE_STEPS, CYCLE_REFERENCE)]
    points += [small_point(case, "turn", steps) for case in "bc" for steps in (*TURN_STEPS, TURN_REFERENCE)]
    points += [mesh_point(case, resolution) for case in "abc" for resolution in ("paper", "fine")]
    points += [two_step_point(case, "cycle", steps) for case in "bc" for steps in (*CYCLE_STEPS[1:5], CYCLE_REFERENCE)]
    points += [two_step_point(case, "turn", steps) for case in "bc" for steps in (*TURN_STEPS, TURN_REFERENCE)]
    return points


def measured(context):
    return context.measure(all_points(context.is_quick), extract, jobs=context.jobs, threads=1)


def slips_of(row):
    return np.array([[float(x) for x in pair.split(",")] for pair in row["slips"].split()])


def errors(row, truth):
    """Relative errors of the quantities that both rows have, as fractions."""
    slips, true_slips = slips_of(row), slips_of(truth)
    largest = np.linalg.norm(true_slips, axis=1).max()
    found = {"slip": np.linalg.norm(slips - true_slips, axis=1).max() / largest}
    for name in ("work", "dissipation"):
        if row[name] and truth[name]:
            found[name] = abs(float(row[name]) / float(truth[name]) - 1)
    return found


def extrapolated(coarse, fine):
    """What runs of n and 2n steps extrapolate to, if errors are of first order."""
    row = {name: f"{2 * float(fine[name]) - float(coarse[name]):.9g}" for name in ("work", "dissipation")}
    return {"slips": as_text(2 * slips_of(fine) - slips_of(coarse)), **row}


class Family:
    """Rows of one case and program, in the order of their steps; the last one is the truth."""

    def __init__(self, rows, case, load, scheme="backward Euler"):
        wanted = (case, load, "small", scheme)
        mine = [row for row in rows if tuple(row[name] for name in ("case", "load", "mesh", "scheme")) == wanted]
        *self.rows, self.truth = sorted(mine, key=lambda row: int(row["steps"])) or [None]
        self.steps = [int(row["steps"]) for row in self.rows]
        self.errors = [errors(row, self.truth) for row in self.rows]

    def error(self, quantity):
        return np.array([error[quantity] for error in self.errors])

    def order(self, quantity, first=-3):
        """Of the error, from the numbers of steps from the one before the last but one on."""
        values = self.error(quantity)
        if len(values) < -first:
            return math.nan
        return math.log(values[first] / values[-1]) / math.log(self.steps[-1] / self.steps[first])


def mesh_errors(rows, case):
    pair = {row["mesh"]: row for row in rows if row["case"] == case and row["mesh"] != "small"}
    if len(pair) < 2:
        return None
    found = errors(pair["paper"], pair["fine"])
    found["max_slip"] = abs(float(pair["paper"]["max_slip"]) / float(pair["fine"]["max_slip"]) - 1)
    return found


CASE_COLOURS = dict(zip("ABC", style.COLOURS))


def draw_quantity(ax, rows, quantity, load):
    for case in "ABC":
        family = Family(rows, case, load)
        if not family.rows:
            continue
        scale = 24 if load == "turn" else 1  # steps of the whole program
        ax.plot([scale * steps for steps in family.steps], 100 * family.error(quantity), "o-", color=CASE_COLOURS[case],
                label=f"case {case}")
        two_step = Family(rows, case, load, TWO_STEP)
        if two_step.rows:
            ax.plot([scale * steps for steps in two_step.steps], 100 * two_step.error(quantity), "^:", mfc="white",
                    color=CASE_COLOURS[case], label=f"case {case}, two-step formula")
        mesh = mesh_errors(rows, case) if load == "cycle" else None
        if mesh:
            ax.axhline(100 * mesh[quantity], color=CASE_COLOURS[case], ls="--", lw=1, label=f"case {case}, error of the mesh")


def figures(rows):
    figure, axes = plt.subplots(2, len(DRAWN), figsize=(style.WIDTH, 5.6), sharey="row")
    for line, load in zip(axes, PROGRAMS):
        for ax, quantity in zip(line, DRAWN):
            ax.set(xscale="log", yscale="log")
            draw_quantity(ax, rows, quantity, load)
            ax.set_title(f"{QUANTITIES[quantity]}, {'the cycle' if load == 'cycle' else 'a path that turns'}")
            ax.set_xlabel("steps of unloading" if load == "cycle" else "steps of the path (18 legs)")
            ax.minorticks_off()
            style.plain_ticks(ax.xaxis, PROGRAMS[load][1] if load == "cycle" else [24 * steps for steps in PROGRAMS[load][1]])
            style.plain_ticks(ax.yaxis, (0.001, 0.01, 0.1, 1, 10) if load == "cycle" else (0.01, 0.1, 1, 10))
        line[0].set_ylabel("error (%)")
    for ax in axes[0]:
        ax.axvline(10, color="0.5", lw=0.8, label="steps of the paper")
    handles = dict(zip(*reversed(axes[0, 0].get_legend_handles_labels())))
    names = sorted(handles, key=lambda name: ("mesh" in name, "formula" in name, "steps" in name, name))  # a column for each kind
    style.legend_below(figure, [handles[name] for name in names], names, 3)
    style.headline(figure, "Ten steps of unloading suffice for the dissipation, twenty for slip at a point")
    return {"load_stepping": figure}


def percent(value):
    return f"{100 * value:.2g} %"


def tables(rows):
    lines = ["| case | steps | slip history | loop | dissipation | orders | two-step formula: slip, dissipation |",
             "|---|---|---|---|---|---|---|"]
    for load, shown in (("cycle", (5, 10, 40, 160)), ("turn", (1, 2, 8))):
        for case in "ABC":
            family = Family(rows, case, load)
            two_step = Family(rows, case, load, TWO_STEP)
            for number, steps in enumerate(family.steps):
                if steps not in shown:
                    continue
                error = family.errors[number]
                orders = " / ".join(f"{family.order(name):.2f}" for name in QUANTITIES)
                other = dict(zip(two_step.steps, two_step.errors)).get(steps)
                also = f"{percent(other['slip'])}, {percent(other['dissipation'])}" if other else "–"
                place = f"{steps} up" if load == "cycle" else f"{24 * steps} on the path"
                lines.append(f"| {case} | {place} | " + " | ".join(percent(error[name]) for name in QUANTITIES) +
                             f" | {orders} | {also} |")
    for case in "ABC":
        family = Family(rows, case, "cycle")
        pair = [row for row in family.rows if row["steps"] in ("10", "20")]
        if len(pair) == 2:
            error = errors(extrapolated(*pair), family.truth)
            lines.append(f"| {case} | 10 and 20 up, extrapolated | " +
                         " | ".join(percent(error[name]) for name in QUANTITIES) + " | – | – |")
    for case in "ABC":
        if mesh := mesh_errors(rows, case):
            lines.append(f"| {case} | the paper's mesh | " + " | ".join(percent(mesh[name]) for name in QUANTITIES) +
                         " | – | – |")
    return {"load_stepping": "\n".join(lines) + "\n"}
