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
    axes.plot(lengths, values, "o-", color=style.COLOURS[0], label="jumps of a fixed length")
    axes.axhline(adapted, color=style.COLOURS[2], linestyle="--", label="adapted jumps")
    axes.axhline(0, color="0.3", linewidth=0.8)
    axes.set(title="error of the worn volume (%)")
    axes.legend(loc="lower left")


def draw_flicker(axes, rows):
    shown = rows[1:-1]
    lengths = [int(row["jump"]) for row in shown]
    for number, (name, mark, label) in enumerate((("change", "o-", "change of the rate"),
                                                  ("flattening", "s--", "depth / flattening"))):
        axes.plot(lengths, [float(row[name]) for row in shown], mark, color=style.COLOURS[1 + 2 * number], label=label)
    axes.set(title="share, mean of all jumps", ylim=(0, None))
    axes.legend(loc="upper left")


def worn_nodes(rows):
    """{jump: depths, nm} of the nodes that wear in the reference, by their distance from the centre."""
    of = {row["jump"]: np.array([place.split(":") for place in row["profile"].split()], dtype=float)
          for row in rows if row["profile"]}
    radius, depth = of[REFERENCE].T
    chosen = np.flatnonzero(depth > 0.01 * depth.max())
    chosen = chosen[np.lexsort((-depth[chosen], radius[chosen].round(3)))]
    return radius[chosen], {jump: places[chosen, 1] for jump, places in of.items()}


def draw_nodes(axes, rows):
    radius, depths = worn_nodes(rows)
    for number, (jump, colour, label) in enumerate(((REFERENCE, "0.2", "every cycle computed"),
                                                    (STEADY, style.COLOURS[5], f"jumps of {STEADY} cycles"),
                                                    (FLICKERING, style.COLOURS[1], f"jumps of {FLICKERING} cycles"))):
        if jump in depths:
            axes.bar(np.arange(len(radius)) + 0.27 * (number - 1), depths[jump], 0.27, color=colour, label=label)
    axes.set_xticks(np.arange(len(radius)), [f"{r:.2f}" for r in radius])
    axes.grid(False, axis="x")
    axes.set(xlabel="contact nodes that wear, by their distance from the centre (mm)", title="worn depth (nm)")


def figures(rows):
    figure, axes = plt.subplot_mosaic([["errors", "flicker"], ["nodes", "nodes"]], figsize=(style.WIDTH, 5))
    draw_errors(axes["errors"], rows)
    draw_flicker(axes["flicker"], rows)
    draw_nodes(axes["nodes"], rows)
    for ax in (axes["errors"], axes["flicker"]):
        ax.set(xscale="log", xlabel="cycles of a jump")
        ax.minorticks_off()
        style.plain_ticks(ax.xaxis, (10, 100, 1000))
    style.legend_below(figure, *axes["nodes"].get_legend_handles_labels(), 3)
    style.headline(figure, "Jumps that wear too deep leave out some nodes in turn, and wear too little")
    return {"wear_flicker": figure}


def tables(rows):
    errors = errors_of(rows)
    text = ("| cycles of a jump | computed cycles | largest depth of a jump (nm) | depth / flattening | change of the rate | "
            "error of the worn volume |\n|--:|--:|--:|--:|--:|--:|\n")
    for row in rows[1:-1]:
        text += (f"| {row['jump']} | {row['computed']} | {1e6 * float(row['depth_of_jump']):.3g} | "
                 f"{float(row['flattening']):.2f} | {100 * float(row['change']):.0f} % | {errors[row['jump']]:+.1f} % |\n")
    return {"wear flicker": text + f"| adapted | {rows[-1]['computed']} | | | | {errors[ADAPTED]:+.1f} % |\n"}
