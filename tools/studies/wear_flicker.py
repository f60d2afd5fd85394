# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Jumps of a fixed length over cycles that wear: where contact flickers, and what is worn then.

The fretting sphere of tools/studies/wear_jumps.py for 20 000 cycles. Jumps have as many cycles from the first to the last,
where those of the program get shorter as the rate changes. The reference computes every cycle."""
import csv

import matplotlib.pyplot as plt
import numpy as np
import style
from points import StudyError, program_point, tool_point
from run_folder import RunFolder
from wear_jumps import SMALL

PAGE = "stability.md"
SCENE = "verification/fretting_wear.prm"
CYCLES, REFERENCE, ADAPTED = 20000, "0", "adapted"
LENGTHS, QUICK = (10, 25, 50, 100, 200, 400, 800, 1200, 1600, 2000, 2400, 3200, 4800), (10, 40)
STEADY, FLICKERING = "800", "3200"  # those whose profiles are shown
NAMES = ("computed", "worn_volume", "depth_of_jump", "change", "flattening", "profile")


def measures(result, point):
    if result.code != 0:
        raise StudyError(f"exit code {result.code}: {point.command}\n{result.errors}")
    if point.columns["jump"] != ADAPTED:
        row = next(csv.DictReader(result.output.splitlines()))
        return {name: row[name] for name in NAMES}
    cycles = RunFolder(result.folder).cycles
    return {**dict.fromkeys(NAMES, ""), "computed": int(np.sum(cycles["n_cycles"] == 1)), "worn_volume": cycles["worn_volume"][-1]}


def measured(context):
    settings = {**SMALL, "Load program/Cycles": 100 if context.is_quick else CYCLES}
    words = [word for entry, value in settings.items() for word in ("--set", f"{entry}={value}")]
    points = [tool_point({"jump": length}, "fixed_jumps", f"prm/{SCENE}", *words, "--cycles", length)
              for length in (REFERENCE, *(QUICK if context.is_quick else LENGTHS))]
    points.append(program_point({"jump": ADAPTED}, SCENE, {**settings, "Wear/Largest depth of a jump": "1e-3"}))
    return context.measure(points, measures, jobs=context.jobs, threads=1)


def errors_of(rows):
    """{jump: error of the worn volume, %} of all but the reference."""
    volume = float(rows[0]["worn_volume"])
    return {row["jump"]: 100 * (float(row["worn_volume"]) / volume - 1) for row in rows[1:]}


def draw_errors(axes, rows):
    errors = errors_of(rows)
    adapted = errors.pop(ADAPTED)
    lengths, values = np.array([int(name) for name in errors]), np.array(list(errors.values()))
    axes.plot(lengths, np.abs(values), "-", color=style.COLOURS[0], linewidth=1)
    for chosen, mark, name in ((values > 0, "o", "too much is worn"), (values < 0, "v", "too little is worn")):
        axes.plot(lengths[chosen], np.abs(values[chosen]), mark, color=style.COLOURS[0], label=name)
    axes.axhline(abs(adapted), color=style.COLOURS[2], linestyle="--", label="adapted jumps, any depth allowed")
    axes.set(xscale="log", yscale="log", xlabel="cycles of a jump", ylabel="worn volume: error (%)", yticks=(1, 2, 5, 10, 20))
    axes.yaxis.set_major_formatter("{x:g}")
    axes.yaxis.set_minor_formatter("")
    axes.legend(fontsize=7)


def draw_flicker(axes, rows):
    shown = rows[1:-1]
    lengths = [int(row["jump"]) for row in shown]
    for number, (name, mark, label) in enumerate((("change", "o-", "change of the rate from jump to jump"),
                                                  ("flattening", "s--", "depth of a jump / flattening"))):
        axes.plot(lengths, [float(row[name]) for row in shown], mark, color=style.COLOURS[number], label=label)
    axes.set(xscale="log", xlabel="cycles of a jump", ylabel="share, mean of all jumps")
    axes.legend(fontsize=7)


def draw_profiles(axes, rows):
    jumps = [row["jump"] for row in rows]
    for name, mark, colour, label in ((REFERENCE, ".", "black", "every cycle computed"),
                                      (STEADY, "o", style.COLOURS[0], f"jumps of {STEADY} cycles"),
                                      (FLICKERING, "x", style.COLOURS[1], f"jumps of {FLICKERING} cycles")):
        if name in jumps:
            places = [place.split(":") for place in rows[jumps.index(name)]["profile"].split()]
            radius, depth = np.array(places, dtype=float).T
            axes.plot(radius, depth, mark, color=colour, markersize=5, fillstyle="none", label=label)
    axes.set(xlim=(0.3, 0.75), xlabel="r (mm)", ylabel="worn depth (nm)")
    axes.legend(fontsize=7)


def figures(rows):
    figure, (left, middle, right) = plt.subplots(1, 3, figsize=(11, 3.3))
    draw_errors(left, rows)
    draw_flicker(middle, rows)
    draw_profiles(right, rows)
    return {"wear_flicker": figure}


def tables(rows):
    errors = errors_of(rows)
    text = ("| cycles of a jump | computed cycles | largest depth of a jump (nm) | depth / flattening | change of the rate | "
            "error of the worn volume |\n|--:|--:|--:|--:|--:|--:|\n")
    for row in rows[1:-1]:
        text += (f"| {row['jump']} | {row['computed']} | {1e6 * float(row['depth_of_jump']):.3g} | "
                 f"{float(row['flattening']):.2f} | {100 * float(row['change']):.0f} % | {errors[row['jump']]:+.1f} % |\n")
    return {"wear flicker": text + f"| adapted | {rows[-1]['computed']} | | | | {errors[ADAPTED]:+.1f} % |\n"}
