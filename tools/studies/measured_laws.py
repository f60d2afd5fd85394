# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Where tables of friction fail: 300 random laws on three bodies, pressed, led around a circle and released."""
import itertools
import math

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.lines import Line2D

import scenes
import style
import verdicts
from maps import DEFAULT, KINDS, SOLVED, most_iterations, shade
from paths import ROOT
from points import program_point
from rosette_law import NotWellPosed, RosetteLaw, Table
from scenes import number

PAGE = "stability.md"
N_LAWS = 300
N_CHECKED = 30  # laws that sweeps solve, too
ROWS = (180, 720)  # the second where kappa is so small that the first ones do not keep it
WAVES = 4
LEAST_KAPPA, MOST_KAPPA = 0.005, 1  # of the mean friction
LEAST_FRICTION, MOST_FRICTION = 0.05, 1.5
FINE = 2 * math.pi * np.arange(2880) / 2880
PEAK = 0.02  # mm
BODIES = {"cylinder": {}, "column": {"Geometry/Height": 30, "Mesh/Layers": 5},
          "ball": {"Obstacle/Gap": "(x^2+y^2)/8000"}}
MESH = {"Mesh/Model": "full", "Mesh/Core cells": 4, "Mesh/Rings": 2, "Mesh/Layers": 3, "Mesh/Degree": 1}


class Waves:
    """Coefficients mean (1 + size along), mean size across, where along and across are sums of four waves."""

    def __init__(self, chance):
        shape = (2, 2, WAVES)
        self.terms = chance.normal(size=shape) / (1 + np.arange(WAVES))
        self.mean = math.exp(chance.uniform(math.log(LEAST_FRICTION), math.log(MOST_FRICTION)))
        self.fine = self.sums(FINE)

    def sums(self, angles):
        """along, across, and their first derivatives."""
        k = 1 + np.arange(WAVES)
        cos, sin = np.cos(np.outer(angles, k)), np.sin(np.outer(angles, k))
        values = [cos @ c + sin @ s for c, s in self.terms]
        slopes = [cos @ (k * s) - sin @ (k * c) for c, s in self.terms]
        return *values, *slopes

    def coefficients(self, size, angles):
        along, across, *_ = self.sums(angles)
        return self.mean * (1 + size * along), self.mean * size * across

    def conditions(self, size):
        """The least of mu_along and of kappa over the mean, and of d b/da, over all angles."""
        along, across, along_slope, across_slope = self.fine
        a, c, a_slope, c_slope = 1 + size * along, size * across, size * along_slope, size * across_slope
        return a.min(), (a + c_slope).min(), (1 + (a * c_slope - a_slope * c) / (a * a + c * c)).min()

    def departure(self, size):
        """The largest |mu_across - d mu_along/da| over the mean: 0 where slip is associated."""
        _, across, along_slope, _ = self.fine
        return size * np.abs(across - along_slope).max()


def random_law(seed):
    """A law with the least kappa that it draws: (waves, size)."""
    chance = np.random.default_rng(seed)
    wanted = math.exp(chance.uniform(math.log(LEAST_KAPPA), math.log(MOST_KAPPA)))
    while True:
        waves = Waves(chance)
        low, high = 0., 10.
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (middle, high) if waves.conditions(middle)[1] > wanted else (low, middle)
        along, _, turn = waves.conditions(low)
        if along > 0.02 and turn > 0.01:
            return waves, low


def table_of(waves, size):
    for n in ROWS:
        angles = 2 * math.pi * np.arange(n) / n
        table = Table(angles, *waves.coefficients(size, angles))
        try:
            RosetteLaw(table)
        except NotWellPosed:
            continue
        break
    return table


def write_table(path, table):
    path.parent.mkdir(parents=True, exist_ok=True)
    np.savetxt(path, np.column_stack([np.degrees(table.angles), table.along, table.across]), fmt="%.17g",
               header="angle mu_along mu_across")


def legs():
    circle = [f"{number(PEAK * math.cos(a))} {number(PEAK * math.sin(a))} {-PEAK} : 1"
              for a in 2 * math.pi * np.arange(13) / 12]
    return f"0 0 {-PEAK} : 3 ; " + " ; ".join(circle) + " ; 0 0 0 : 3"


def all_points(context):
    n = 1 if context.is_quick else N_LAWS
    for seed in range(n):
        waves, size = random_law(seed)
        path = context.folder / "measured_laws" / f"{seed}.txt"
        write_table(path, table_of(waves, size))
        known = {"law": seed, "mean": number(waves.mean), "kappa": number(waves.conditions(size)[1]),
                 "departure": number(waves.departure(size)), "tolerance": 1e-10}
        for body, settings in BODIES.items():
            for method in (DEFAULT, "gauss-seidel") if seed < N_CHECKED else (DEFAULT,):
                yield program_point({**known, "body": body, "method": method}, "paper/scene.prm", {
                    **scenes.PROGRAM, **MESH, **settings, "Load program/Legs": legs(), "Friction/Law": "rosette",
                    "Friction/Rosette": path.resolve() if ROOT not in path.resolve().parents
                    else path.resolve().relative_to(ROOT),
                    "Contact solver/Method": method})


def measured(context):
    rows = context.measure(list(all_points(context)), verdicts.outcome, jobs=context.jobs, threads=1)
    rows = [dict(row) for row in rows]
    return [row for _, group in itertools.groupby(rows, lambda row: (row["law"], row["body"]))
            for row in verdicts.with_agreement(list(group), most_iterations)]


def of_ellipses(mu_ratio=2):
    """kappa and departure of two ellipses, from associated slip to p_x/p_y far from it: one line in the plane."""
    found = []
    for ratio in np.exp(np.linspace(0, math.log(40), 60)):
        mu, p = np.array([1, 1 / mu_ratio]), np.array([1, ratio / mu_ratio])
        e = np.stack([np.cos(FINE), np.sin(FINE)])
        force = p[:, None]**2 * e
        force /= np.hypot(*(force / mu[:, None]))
        along, across = (force * e).sum(axis=0), -force[0] * e[1] + force[1] * e[0]
        slope = [(np.roll(f, -1) - np.roll(f, 1)) / (2 * FINE[1]) for f in (along, across)]
        mean = math.sqrt(mu.prod())
        found.append(((along + slope[1]).min() / mean, np.abs(across - slope[0]).max() / mean))
    return np.array(found)


def figures(rows):
    figure, panels = plt.subplots(1, 3, figsize=(style.WIDTH, 3.2), sharex=True, sharey=True)
    own = [row for row in rows if row["method"] == DEFAULT]
    for axes, body in zip(panels, BODIES):
        here = [row for row in own if row["body"] == body]
        for row in here:
            is_solved = row["verdict"] in SOLVED
            colour = shade(int(row["iterations"])) if row["verdict"] == "converged" else KINDS[row["verdict"]][0]
            axes.plot(float(row["kappa"]), float(row["departure"]), "o" if is_solved else "X", color=colour,
                      markersize=4 if is_solved else 7, markeredgecolor="0.3", markeredgewidth=0.3, zorder=2 if is_solved else 3)
        axes.plot(*of_ellipses().T, color="0.3", linewidth=1, zorder=1)
        axes.set(xscale="log", yscale="log", ylim=(4e-3, 400), xlabel=r"$\kappa_{\min}\,/\,\mu$ of the mean",
                 title=f"{body}: solves {sum(row['verdict'] in SOLVED for row in here)} of {len(here)}")
    panels[0].set_ylabel(r"$\max|\mu_{across}-\mu'_{along}|\,/\,\mu$")
    handles = [Line2D([], [], marker="o", linestyle="", color=shade(n), label=f"{n} iterations") for n in (5, 50, 500)]
    handles += [Line2D([], [], marker="X", linestyle="", color=KINDS[kind][0], label=KINDS[kind][2])
                for kind in KINDS if any(row["verdict"] == kind and kind not in SOLVED for row in own)]
    handles.append(Line2D([], [], color="0.3", linewidth=1, label="two ellipses, $\\mu_x = 2\\mu_y$"))
    style.legend_below(figure, handles, [handle.get_label() for handle in handles], min(len(handles), 4))
    n_solved = sum(row["verdict"] in SOLVED for row in own)
    style.headline(figure, f"newton solves {n_solved} of {len(own)} scenes with random tables of friction")
    return {"measured_laws": figure}


def tables(rows):
    text = "| method | " + " | ".join(BODIES) + " | hardest step, median | worst |\n" + "|---" * (len(BODIES) + 3) + "|\n"
    for method in dict.fromkeys(row["method"] for row in rows):
        own = [row for row in rows if row["method"] == method]
        solved = [[row for row in own if row["body"] == body] for body in BODIES]
        iterations = [int(row["iterations"]) for row in own if row["verdict"] in SOLVED]
        text += (f"| `{method}` | " + " | ".join(f"{sum(row['verdict'] in SOLVED for row in here)} of {len(here)}" for here in solved) +
                 f" | {np.median(iterations):.0f} iterations | {max(iterations)} |\n")
    return {"measured laws": text}
