# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What the program promises of every input, wanted or not. Each function returns what does not hold, as sentences."""
import csv
import json
import math
import re

DONE, WRONG_INPUT, UNSOLVED, FILE_ERROR, INTERRUPTED = 0, 2, 3, 4, 130
LONGEST_LINE = 600
LIBRARY_TALK = re.compile(r"Line <|Boost|boost|assert|[Ee]xception|terminate|Stacktrace|std::|dealii|Aborted|"
                          "core dumped")
CONTROL = re.compile("[\x00-\x09\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]")
MU = (0.3, 0.15)
OF_LOOP = ("slip_ratio", "energy_ratio", "friction_largest", "friction_energy", "friction_geometric", "loop_stiffness")
OF_SURFACE = ("pressure", "traction_x", "traction_y", "slip_x", "slip_y", "traction_z", "slip_z")
WORDS = {"method", "status", "driven"}  # columns that are no numbers


def of_exit(code, wanted):
    return [] if code == wanted else [f"exit code {code}, not {wanted}"]


def of_error_output(code, text, says):
    """One or two lines that begin with the program's name, and where to look after a step that is not solved; nothing if all
    went well."""
    if code == DONE:
        return [f"error output of a run that is done: {text[:200]!r}"] if text and not says else []
    lines = text.strip("\n").split("\n")
    if code == UNSOLVED and lines[-1].startswith("In "):
        del lines[-1]
    faults = [] if 1 <= len(lines) <= 2 else [f"{len(lines)} lines of error output"]
    faults += [] if lines[0].startswith("orthocone: ") else [f"error output begins with {lines[0][:40]!r}"]
    faults += [f"a line of {len(line)} characters" for line in lines if len(line) > LONGEST_LINE]
    faults += ["control characters in the error output"] if CONTROL.search(text) else []
    faults += [f"words of a library: {talk[0]}" for talk in LIBRARY_TALK.finditer(text)]
    return faults + ([] if re.search(says, text) else [f"{text[:300]!r} does not say {says!r}"])


def of_files(code, before, after, run, may_leave=""):
    """What the user had is as it was; a refused input has made nothing; nothing is half written."""
    faults = [f"{name} is changed" for name, content in before.items()
              if after.get(name) != content and not inside(name, run)]
    new = [name for name in after if name not in before]
    faults += [f"{name} is left" for name in new if name.endswith(".part")]
    if code in (WRONG_INPUT, FILE_ERROR):
        unwanted = [name for name in new if not (may_leave and re.fullmatch(may_leave, name))]
        faults += [f"refused, but there is a new {name}" for name in unwanted[:1]]
    elif run:
        faults += [f"{name} is outside the run folder" for name in new if not inside(name, run)][:1]
    return faults


def inside(name, run):
    return bool(run) and (name == run or name.startswith(run + "/") or run.startswith(name + "/"))


def rows(folder, table="history.csv"):
    with open(folder / table, encoding="ascii") as file:
        return [{key: value if key in WORDS else float(value) for key, value in row.items()}
                for row in csv.DictReader(file)]


def of_run(folder, code):
    """The files of a run that is done, or that could not be solved."""
    if not (folder / "summary.json").exists():
        return ["summary.json is missing"]
    summary = json.loads((folder / "summary.json").read_text())
    if (summary["status"] == "complete") != (code == DONE):
        return [f"exit code {code}, but summary.json says {summary['status'][:60]!r}"]
    history = rows(folder) if (folder / "history.csv").exists() else []
    faults = [] if len(history) == summary["steps"]["solved"] else ["history.csv and summary.json count differently"]
    if code == DONE and not summary["cycles"]["periodic_since_cycle"] and len(history) != summary["steps"]["planned"]:
        faults.append(f"{len(history)} rows of {summary['steps']['planned']}")
    return faults + of_numbers(folder) + of_physics(history)


def of_numbers(folder):
    """All are finite; the figures of a loop that does not exist are nan, and what acts on the contact surface at points of a
    line inside of the body, and only they."""
    tables = [path.name for path in folder.glob("*.csv")]
    return [f"{table}: {key} is {value}" for table in tables for row in rows(folder, table)
            for key, value in row.items() if key not in WORDS and not math.isfinite(value)
            and not (table == "cycles.csv" and key in OF_LOOP and math.isnan(value))
            and not (table.startswith("line-") and key in OF_SURFACE and math.isnan(value) and row["status"] == "inside")
            or key in OF_LOOP and row["stroke"] == 0 and not math.isnan(value)][:1]


def of_physics(history):
    """What holds of any scene: pressed bodies resist, and nothing pulls or heats backwards."""
    faults = []
    for row in history:
        step = f"step {int(row['step'])}: "
        if row["uz"] < 0 and not (row["force_z"] > 0 and row["n_stick"] + row["n_slip"] > 0):
            faults.append(step + f"u_z = {row['uz']:g}, but force_z = {row['force_z']:g}")
        if row["force_z"] < 0 or row["min_pressure"] < 0 or row["elastic_energy"] < 0:
            faults.append(step + "a force pulls, or an energy is negative")
        if row["dissipation"] < -1e-9 * max(line["elastic_energy"] for line in history):
            faults.append(step + f"dissipation {row['dissipation']:g}")
    return faults[:1]


def of_cone(history, mu=MU):
    """The total force is within the friction cone, for it is convex."""
    return [f"step {int(row['step'])}: the force is outside the friction cone" for row in history
            if math.hypot(row["force_x"] / mu[0], row["force_y"] / mu[1]) > row["force_z"] * (1 + 1e-6)][:1]
