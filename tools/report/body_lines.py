# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Fields along the lines of Output/Lines."""
import re

import checked
from load_program import evenly, spread_steps

IN_BODY = ("u_x", "u_y", "u_z", *(f"stress_{axes}" for axes in ("xx", "yy", "zz", "xy", "xz", "yz")))
ON_SURFACE = ("pressure", "traction_x", "traction_y")
MOST_STEPS, MOST_POINTS = 24, 400


def ends_of(text):
    """{name: the ends of the line in words} of the entry."""
    return {name: ends.strip() for name, ends in re.findall(r"([\w-]+)\s*:\s*([^:;]+?)\s*,[^;]*", text)}


def lines_in(data):
    """Names and ends of the lines that have files; others of the user may have such names."""
    given = ends_of(data.parameters.get("Output", {}).get("Lines", ""))
    return {name: ends for name, ends in given.items() if data.run.line_steps(name)}


def table_of(data, name, step):
    def read():
        table = checked.columns(data.run.line(name, step), ("s", *IN_BODY), (), None)
        if not table:
            raise ValueError("it has no points")
        if missing := [column for column in ON_SURFACE if column not in table]:
            raise ValueError(f"no column {missing[0]}")
        return table
    return data.read(f"line-{name}-{step:04d}.csv", read)


def lines(data, numbers):
    """[{name, ends, s (mm), steps, frames: {column: (values of a step), ...}}]; null is off the contact surface."""
    all_lines = []
    for name, ends in lines_in(data).items():
        steps = spread_steps(data.run.line_steps(name), MOST_STEPS, data.blocks)
        frames = []
        for step in steps:
            table = table_of(data, name, step)
            rows = evenly(len(table["s"]), MOST_POINTS)
            frames.append({column: numbers(table[column][rows]) for column in ("s", *IN_BODY, *ON_SURFACE)})
        all_lines.append({"name": name, "ends": ends, "steps": steps, "frames": frames})
    return all_lines
