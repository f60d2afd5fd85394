# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Box 3 against the spectrum of the compliance; slip far from associated against the symmetric part of D C W D."""
import csv

import matplotlib.pyplot as plt
import numpy as np

import scenes
import style
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


ENDS = {"converged": ("o", COLOURS[0], "converges"), "slow": ("^", COLOURS[4], "has not converged after 20 000 iterations"),
        "": ("x", COLOURS[1], "cycles or diverges")}


def draw_box3(axes, rows, title):
    names = list(dict.fromkeys(row["place"] for row in rows))
    for row in rows:
        if row["method"]:
            marker, colour, _ = ENDS.get(row["verdict"], ENDS[""])
            axes.plot(float(row["share"]), names.index(row["place"]), marker, color=colour, markersize=5)
    limits = {row["place"]: 2 / float(row["box3_lambda"]) for row in rows if not row["method"]}
    axes.set_yticks(range(len(names)), [f"case {name[0]}, degree {name[-1]} (limit {limits[name]:.2f})" for name in names])
    axes.axvline(1, color="grey", lw=0.8)
    axes.set(xscale="log", xlim=(0.25, 4.8), ylim=(-0.6, len(names) - 0.4), title=title)
    axes.minorticks_off()
    style.plain_ticks(axes.xaxis, (0.3, 0.6, 1, 2, 4))


def box3(rows):
    figure, (stick, slip) = plt.subplots(2, 1, figsize=(style.WIDTH, 4.2), sharex=True, height_ratios=(1, 2))
    draw_box3(stick, [row for row in rows if row["chart"] == "box3 stick"], "ν = 0: all nodes stick")
    draw_box3(slip, [row for row in rows if row["chart"] == "box3 slip"], "the paper's cases: some nodes slip")
    slip.set_xlabel("rho factor, relative to the limit")
    handles = [plt.Line2D([], [], marker=marker, color=colour, ls="") for marker, colour, _ in ENDS.values()]
    style.legend_below(figure, handles, [name for _, _, name in ENDS.values()], 3)
    style.headline(figure, "Box 3 for all nodes at once converges only if ρ is small")
    return figure


def draw_iterations(axes, rows):
    for method in METHODS:
        own = [row for row in rows if row["method"] == method]
        ratios = np.array([float(row["place"]) for row in own])
        iterations = np.array([max(1, int(row["iterations"])) for row in own])
        good = np.array([row["verdict"] == "converged" for row in own])
        axes.plot(ratios, iterations, "-", color=METHOD_COLOURS[method])
        axes.plot(ratios[good], iterations[good], "o", color=METHOD_COLOURS[method], label=method)
        axes.plot(ratios[~good], iterations[~good], "x", color=METHOD_COLOURS[method], markersize=6)
    axes.plot([], [], "x", color="0.3", label="not converged")
    axes.set(xscale="log", yscale="log", ylabel="iterations of the\nfirst step up")
    style.plain_ticks(axes.yaxis, (10, 100, 1000, 10000))


def slip_rules(rows):
    figure, (counts, eigenvalues) = plt.subplots(2, 1, figsize=(style.WIDTH, 4.6), sharex=True, height_ratios=(1.6, 1))
    draw_iterations(counts, rows)
    spectra = {float(row["place"]): 1e3 * float(row["symmetric_least"]) / float(row["symmetric_largest"])
               for row in rows if not row["method"]}
    eigenvalues.plot(spectra.keys(), spectra.values(), "o-", color="0.3")
    eigenvalues.set(ylabel="least / largest\neigenvalue, ‰", xlabel="ratio of the slip ellipse / ratio of the friction ellipse")
    for axes in (counts, eigenvalues):
        axes.minorticks_off()
        style.plain_ticks(axes.xaxis, (0.02, 0.1, 0.5, 1, 2, 10, 50))
        axes.axvline(1, color="grey", lw=0.8)
    style.legend_below(figure, *counts.get_legend_handles_labels(), 5)
    style.headline(figure, "Only newton and gauss-seidel converge for every slip rule")
    return figure


def figures(rows):
    return {"spectra": box3(rows), "slip_rules": slip_rules([row for row in rows if row["chart"] == "slip rule"])}
