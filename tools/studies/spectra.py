# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Box 3 against the spectrum of the compliance; slip far from associated against the symmetric part of D C W D."""
import csv

import matplotlib.pyplot as plt
import numpy as np

import scenes
from points import StudyError, tool_point
from style import COLOURS, METHOD_COLOURS

PAGE = "stability.md"
MESHES = {"A Q1": ("A", 1), "A Q2": ("A", 2), "A Q3": ("A", 3), "B Q1": ("B", 1), "B Q2": ("B", 2), "C Q2": ("C", 2)}
STICKING = ("A Q1", "A Q2", "A Q3")  # with ν = 0 nothing pushes sideways
SHARES = (0.3, 0.6, 0.8, 0.9, 0.97, 1.03, 1.1, 1.3, 2, 4)  # of the limit 2 / lambda
RATIOS = scenes.logarithmic(1 / 64, 64, 13)
METHODS = ("newton", "gauss-seidel", "uzawa", "feng2006")
MOST_ITERATIONS = 20000
LOADING = {"Load program/Legs": f"0 0 {scenes.PEAK} : 1 ; 0 0 0 : 6"}


def words_of(settings):
    words = ["prm/paper/scene.prm"]
    for entry, value in settings.items():
        words += ["--set", f"{entry}={value}"]
    return words


def first_row(result, _point):
    if result.code:
        raise StudyError(result.errors.strip())
    return next(csv.DictReader(result.output.splitlines()))


def spectrum_point(chart, place, settings):
    return tool_point({"chart": chart, "place": place, "method": "", "share": ""}, "spectrum", *words_of(settings))


def trace_point(chart, place, method, share, step, settings):
    limits = {"Contact solver/Maximum iterations": MOST_ITERATIONS, **settings}
    return tool_point({"chart": chart, "place": place, "method": method, "share": share}, "trace", *words_of(limits),
                      "--step", step, "--method", method)


SPECTRUM = ("contact_nodes", "condition", "box3_lambda", "symmetric_least", "symmetric_largest")
TRACE = ("iterations", "residual", "verdict")


def extract(result, point):
    if "spectrum" in point.words:
        return {**first_row(result, point), **dict.fromkeys(TRACE, "")}
    if result.code:
        raise StudyError(result.errors.strip())
    last = list(csv.DictReader(result.output.splitlines()))[-1]
    return {**dict.fromkeys(SPECTRUM, ""), **{name: last[name] for name in TRACE}}


def box3_scene(name, sticks):
    case, degree = MESHES[name]
    return scenes.scene(case, settings={**LOADING, "Mesh/Degree": degree, **({"Material/Poisson ratio": 0} if sticks else {})})


def slip_scene(ratio):
    mu = (0.3, 0.15)
    return scenes.scene(settings={**LOADING, **scenes.friction(mu, (mu[0] * ratio**0.5, mu[1] / ratio**0.5))})


def measured(context):
    cases = [(name, sticks) for sticks in (True, False) for name in (STICKING if sticks else MESHES)]
    cases = cases[:1] if context.is_quick else cases
    spectra = [spectrum_point(f"box3 {'stick' if sticks else 'slip'}", name, box3_scene(name, sticks))
               for name, sticks in cases]
    limits = {case: 2 / float(row["box3_lambda"])
              for case, row in zip(cases, context.measure(spectra, extract, jobs=context.jobs, threads=1))}
    points = [trace_point(f"box3 {'stick' if sticks else 'slip'}", name, "box3", share, 1,
                          {**box3_scene(name, sticks), "Contact solver/Rho factor": scenes.number(share * limits[name, sticks])})
              for name, sticks in cases for share in SHARES]
    for ratio in RATIOS[::6] if context.is_quick else RATIOS:
        settings = slip_scene(ratio)
        points.append(spectrum_point("slip rule", scenes.number(ratio), settings))
        points += [trace_point("slip rule", scenes.number(ratio), method, "", 2, settings) for method in METHODS]
    return context.measure(spectra + points, extract, jobs=context.jobs, threads=1)


MARKERS = {"converged": ("o", COLOURS[0]), "slow": ("^", COLOURS[4])}  # else a cross


def draw_box3(axes, rows, title):
    names = list(dict.fromkeys(row["place"] for row in rows))
    for row in rows:
        if row["method"]:
            marker, colour = MARKERS.get(row["verdict"], ("x", COLOURS[1]))
            axes.plot(float(row["share"]), names.index(row["place"]), marker, color=colour)
            if row["verdict"] == "converged" and not 0.7 < float(row["share"]) < 1.2:
                axes.annotate(row["iterations"], (float(row["share"]), names.index(row["place"])), fontsize=5.5,
                              xytext=(0, 5), textcoords="offset points", ha="center")
    limits = {row["place"]: 2 / float(row["box3_lambda"]) for row in rows if not row["method"]}
    axes.set_yticks(range(len(names)), [f"{name}, limit {limits[name]:.2g}" for name in names], fontsize=7)
    axes.axvline(1, color="grey", lw=0.8)
    axes.set_xscale("log")
    axes.set_xticks([0.3, 0.6, 1, 2, 4], ["0.3", "0.6", "1", "2", "4"])
    axes.set_ylim(-0.6, len(names) - 0.3)
    axes.set_xlabel("rho factor / (2/λ_max(ρ C W))")
    axes.set_title(title, fontsize=9)


def draw_slip_rule(axes, rows):
    spectra = {row["place"]: float(row["symmetric_least"]) / float(row["symmetric_largest"])
               for row in rows if not row["method"]}
    for method in METHODS:
        own = [row for row in rows if row["method"] == method]
        ratios = np.array([float(row["place"]) for row in own])
        iterations = np.array([max(1, int(row["iterations"])) for row in own])
        good = np.array([row["verdict"] == "converged" for row in own])
        axes.loglog(ratios, iterations, "-", color=METHOD_COLOURS[method], lw=1, label=method)
        axes.loglog(ratios[good], iterations[good], "o", color=METHOD_COLOURS[method], ms=4)
        axes.loglog(ratios[~good], iterations[~good], "x", color=METHOD_COLOURS[method])
    axes.set_xlabel("(p_x/p_y) / (μ_x/μ_y)")
    axes.set_ylabel("iterations, first step up (x: not converged)")
    axes.legend(fontsize=7)
    other = axes.twinx()
    other.semilogx([float(place) for place in spectra], list(spectra.values()), "--", color="grey", lw=1)
    other.set_ylabel("least / largest eigenvalue of sym(D C W D)  (dashed)", fontsize=8)
    other.spines["right"].set_visible(True)
    other.grid(False)


def figures(rows):
    figure, (stick, slip, rule) = plt.subplots(1, 3, figsize=(13, 3.8), width_ratios=(1, 1, 1.4))
    draw_box3(stick, [row for row in rows if row["chart"] == "box3 stick"], "box3, ν = 0: all nodes stick")
    draw_box3(slip, [row for row in rows if row["chart"] == "box3 slip"], "box3, the paper's friction (triangle: slow)")
    draw_slip_rule(rule, [row for row in rows if row["chart"] == "slip rule"])
    return {"spectra": figure}
