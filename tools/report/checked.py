# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What the page asks of the files of a run, before it draws anything: a run folder may be damaged, or somebody else's."""
import math

import numpy as np

WORDS = ("method", "driven", "status")  # columns that are no numbers
LARGEST_STEP = 2**53
MOST_LAYERS = 10_000
SECTIONS = ("Geometry", "Mesh", "Friction", "Contact solver", "Load program")
NUMBER, WORD, NUMBERS = "a number", "a word", "numbers"
ANSWERS = ("force_z", "force_xy", "normal_force", "tangential_force", "contact_area", "stick_area", "pressure",
           "slip_of_contact", "mu_eff", "last_cycle_energy", "dissipation", "energy_per_area", "wear_depth")
# Where the summary has what the page shows, and of what kind it is. Older runs have less of it.
SUMMARY = {
    "status": WORD, "model": {"kind": WORD, "reason": WORD, "symmetry_planes": "words", "cells": NUMBER, "degree": NUMBER,
                              "dofs": NUMBER, "contact_nodes": NUMBER},
    "scene": {"area_mm2": NUMBER}, "steps": {"planned": NUMBER, "solved": NUMBER}, "cycles": {"jumped_steps": NUMBER},
    "contact_solver": {"method": WORD, "tolerance": NUMBER, "iterations": NUMBER},
    "answers": {name: {"value": NUMBER, "unit": WORD, "step": NUMBER} for name in ANSWERS},
    "peaks": {name: {"value": NUMBER, "step": NUMBER} for name in ("slip_mm", "pressure_MPa", "force_z_N")},
    "friction": {"mu": NUMBERS, "p": NUMBERS, "angle_degrees": NUMBER}, "warnings": "words"}
NEEDED = {"model": ("kind", "reason", "cells", "degree", "dofs", "contact_nodes"), "peaks": (),
          "contact_solver": ("method", "tolerance", "iterations"), "friction": ("angle_degrees",),
          **{name: ("value", "step") for name in ("slip_mm", "pressure_MPa", "force_z_N")}}


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool) and abs(value) < 1e300


def is_of(kind, value):
    """JSON has no infinity: null stands for what is no number."""
    if kind == NUMBER:
        return value is None or is_number(value)
    if kind == NUMBERS:
        return isinstance(value, list) and len(value) == 2 and all(map(is_number, value))
    if kind == "words":
        return isinstance(value, list) and all(isinstance(word, str) for word in value)
    return isinstance(value, str)


def check_object(found, wanted, place=""):
    for name, kind in wanted.items():
        if name not in found:
            continue
        value, where = found[name], f"{place}{name}"
        if isinstance(kind, dict):
            if not isinstance(value, dict):
                raise ValueError(f"{where} is no object")
            missing = [needed for needed in NEEDED.get(name, ()) if value.get(needed) is None]
            if missing:
                raise ValueError(f"{where} has no {missing[0]}")
            check_object(value, kind, f"{where}.")
        elif not is_of(kind, value):
            raise ValueError(f"{where} is not {kind}")


def summary(found):
    check_object(found, SUMMARY)
    for name, kind in (("seconds", NUMBER), ("versions", WORD), ("units", WORD)):
        values = found.get(name, {})
        if not isinstance(values, dict) or not all(value is not None and is_of(kind, value) for value in values.values()):
            raise ValueError(f"{name} has something that is not {kind}")
    return found


def columns(table, needed=(), whole=("step",), ascending="step"):
    """A table whose columns are numbers, the needed ones among them and finite; steps are whole, and what
    ascends (None: nothing) does so."""
    if not table:
        return table
    for name in (*needed, *([ascending] if ascending else ())):
        if name not in table:
            raise ValueError(f"no column {name}")
    for name, values in table.items():
        if name not in WORDS and not isinstance(values, np.ndarray):
            raise ValueError(f"column {name} does not hold numbers only")
    for name in needed:
        if not np.isfinite(table[name]).all():
            raise ValueError(f"column {name} has something that is not a finite number")
    for name in whole:
        values = table[name]
        if not np.all((values == np.floor(values)) & (values >= 0) & (values <= LARGEST_STEP)):
            raise ValueError(f"column {name} has something that is not a whole number from 0 on")
    if ascending and np.any(np.diff(table[ascending], prepend=0) <= 0):
        raise ValueError(f"column {ascending} does not ascend from 1 on")
    return table


def parameters(found):
    missing = [name for name in SECTIONS if name not in found]
    if missing:
        raise ValueError(f"no section {missing[0]}")
    return found


def number(text, least=-math.inf, name="a number"):
    """A finite number above `least`."""
    value = float(text)
    if not math.isfinite(value) or not value > least:
        raise ValueError(f"{name} = {value:g}")
    return value


def layers(count, grading):
    """Number and grading of layers, from their texts."""
    n = int(count)
    if not 1 <= n <= MOST_LAYERS:
        raise ValueError(f"Layers = {n}")
    return n, min(max(number(grading, 0, "Layer grading"), 1e-2), 1e2)  # drawn, not computed


def fields(file, names, optional):
    """A file of contact fields that has these, and what is there of the others, in finite numbers."""
    for name in names:
        if name not in file.data:
            raise ValueError(f"no field {name}")
    for name in (*names, *(name for name in optional if name in file.data)):
        if not np.isfinite(file[name]).all():
            raise ValueError(f"field {name} has something that is no number")
    return file
