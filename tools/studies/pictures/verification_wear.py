# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Worn surfaces over what is known of them; of tools/study verification."""
import math

import numpy as np
from measure import along_x
from panels import BLUE, DOTS, LINE, label

RADIUS = 100  # of the spheres, mm
STIFFNESS = 210000 / (1 - 0.4999**2)  # MPa
N_STEPS = 8  # of a cycle of fretting_wear.prm, which has 16 before


def worn_cap(runs, ax):
    run = runs.verified("worn_sphere", "Output/Contact fields=1048")
    x, depth = along_x(run, 1048, "wear_depth")
    # The cap whose volume Archard's law gives: V = pi R h^2.
    h = math.sqrt(run.history["worn_volume"][-1] / (math.pi * RADIUS))
    r = np.linspace(0, math.sqrt(2 * RADIUS * h), 200)
    ax.plot(r, (h - r**2 / (2 * RADIUS)) * 1e3, **LINE)
    ax.plot(x, depth * 1e3, **DOTS)
    ax.set_xlim(0, 6)
    label(ax, "worn by a sphere", "x (mm)", "worn depth (µm)")


def limit_pressure(r, approach, c):
    """Popov 2014: of a sphere on the circle of radius c that has not worn, at a given approach, MPa."""
    root = np.sqrt(c**2 - r**2)
    return STIFFNESS / math.pi * (2 * root / RADIUS + (approach - c**2 / RADIUS) / root)


def fretted(runs):
    last = 16 + 100000 * N_STEPS
    return runs.verified("fretting_wear", f"Output/Contact fields={last}"), last


def fretted_pressure(runs, ax):
    run, last = fretted(runs)
    history = run.history
    force, first = history["force_z"], np.argmax(history["cycle"] == 1) + 3
    # What the body gives way besides the contact is proportional to the force.
    approach = (3 * force[first] * RADIUS / (4 * STIFFNESS))**(2 / 3) / RADIUS
    approach = 0.0027 + (approach - 0.0027) * force[-1] / force[first]
    x, pressure = along_x(run, last, "pressure")
    start = math.sqrt(history["stick_area"][first] / math.pi)
    r = np.linspace(0, 0.99 * start, 300)
    ax.plot(r, limit_pressure(r, approach, start), **LINE)
    ax.plot(x, pressure, **DOTS)
    ax.axvline(start, color="0.4", linewidth=1, linestyle="--", label="border of the stick zone")
    ax.set(xlim=(0, 0.7), ylim=(-40, 1800))
    label(ax, "fretted, 10$^5$ cycles", "x (mm)", "pressure (MPa)")


def fretted_force(runs, ax):
    history = fretted(runs)[0].history
    shown = (history["cycle"] > 0) & (history["cycle"] <= 20000)
    ax.plot(history["cycle"][shown] / 1e3, history["force_z"][shown], color=BLUE)
    label(ax, "force that wear leaves", "thousand cycles", "normal force (N)")


PANELS = (worn_cap, fretted_pressure, fretted_force)
