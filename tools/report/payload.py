# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Everything that the scripts of the page draw: tables, thinned where they are long, and the maps."""
import body_lines
import checked
import cycle_table
import loops
import numpy as np
import worn
from load_program import choose_steps

MOST_CELLS = 60_000  # numbers of one kind of table in the page
CHECKS = ("equilibrium", "penetration", "complementarity", "friction_cone", "slip_rule", "energy_defect")
PROBE = ("slip_x", "slip_y", "accumulated_slip", "force_n", "force_x", "force_y", "pressure")


def numbers(values):
    """Seven digits, and null for what is no number: JSON knows no infinity."""
    return [float(f"{value:.7g}") if np.isfinite(value) else None for value in np.asarray(values, dtype=float)]


def table(columns, names, steps):
    """Columns `names` at those of the steps that the table has."""
    at = {int(step): row for row, step in enumerate(columns.get("step", ()))}
    rows = [at[step] for step in steps if step in at]
    return {"step": [step for step in steps if step in at],
            **{name: numbers(columns[name][rows]) for name in names if name in columns and rows}}


def chosen_steps(data, n_columns, what):
    steps = data.steps.tolist()
    chosen = choose_steps(steps, max(100, MOST_CELLS // max(1, n_columns)), data.blocks)
    if len(chosen) < len(steps):
        data.notes.append(f"{what} show {len(chosen)} of {len(steps)} steps.")
    return chosen


def probes(data):
    names = data.read("probe-*.csv", data.run.probe_names)
    steps = chosen_steps(data, len(PROBE) * len(names), "Charts of the probes") if names else []
    return [{"name": name, "place": data.probe_places.get(name),
             "table": table(data.read(f"probe-{name}.csv", lambda name=name: checked.columns(data.run.probe(name))), PROBE,
                            steps)}
            for name in names]


def loop_part(data, steps):
    """The loops without their elastic part; computed with all digits, for the part is small against the whole."""
    found = data.read("history.csv", lambda: loops.departures(data))
    for one in found.values():
        one.pop("rows", None)
        one["values"] = table({"step": data.steps, "values": one["values"]}, ("values",), steps).get("values", [])
    return found


def cycle_part(data):
    columns = data.read("cycles.csv", lambda: cycle_table.chosen_columns(data))
    return {name: [int(value) for value in values] if name in ("cycle", "n_cycles", "last_step", "jumped")
            else numbers(values) for name, values in columns.items()}


def friction_of(data):
    """The limit of friction that charts draw, which is the same everywhere: the ellipse, or forces all around."""
    return {"mu": None if data.friction_varies or data.has_factor else data.mu, "angle": data.angle,
            "limits": None if data.measured.limits is None else numbers(data.measured.limits)}


def comparable_part(data, name, frames=()):
    """What the charts show of every run; `frames` are the steps of the maps of the first one. Forces on the held face are
    those of the plane with the other sign."""
    names = [name for name, values in data.history.items()
             if isinstance(values, np.ndarray) and name not in ("step", "cycle", "phase") and not name.startswith("held_")]
    steps = sorted({*chosen_steps(data, len(names), "Charts"), *data.maps.steps})
    blocks = [block for block in data.blocks if block.part_of(steps)]
    ledger = [name for name in data.energy if name not in ("step", "scale")]
    return {"name": name, "history": table(data.history, names, steps), "energy": table(data.energy, ledger, steps),
            "departures": loop_part(data, steps), "cycles": cycle_part(data),
            "jumps": data.read("cycles.csv", lambda: cycle_table.jumps(data)), "area": data.area,
            "blocks": [[block.name, block.first, block.last, block.cycle] for block in blocks],
            "checks": table(data.checks, CHECKS, steps) if data.checks else None,
            "timing": table(data.timing, ("seconds",), steps), "probes": probes(data),
            "lines": body_lines.lines(data, numbers), "along": data.maps.line_payload(frames),
            "wear": (data.read("history.csv", lambda: worn.profiles(data, numbers))
                     if data.wears and data.n_solved else None),
            **friction_of(data)}


def run_names(runs):
    """Names of the folders, with as many folders before them as it takes to distinguish them."""
    parts = [data.path.resolve().parts for data in runs]
    for depth in range(1, max(map(len, parts)) + 1):
        names = ["/".join(part[-depth:]) for part in parts]
        if len(set(names)) == len(names):
            break
    return names


def payload_of(runs):
    """What the charts show of all runs, and the maps of the first one."""
    data, frames = runs[0], runs[0].maps.steps
    thresholds = {name: data.number("Load program", f"{name.capitalize()} when periodic", 0)
                  for name in ("stop", "jump")}
    return {"runs": [comparable_part(run, name, frames) for run, name in zip(runs, run_names(runs))],
            "maps": data.maps.payload(), "plane": data.is_plane, "has_normal_z": data.has_normal_z, "periodic": thresholds,
            "radius": data.radius, "centre": numbers(data.centre),
            "outline": [[numbers(point) for point in polygon] for polygon in data.outline],
            **friction_of(data),
            "tolerance": data.number("Contact solver", "Tolerance", 0)}
