# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Locking of nearly incompressible bodies: force and slip over Poisson's ratio, by degree and volumetric quadrature.

Cases A (axisymmetric) and B (a quarter) of the paper, one cycle. The meshes of degree 1, 2 and 3 have their nodes at
about the same places. The reference is a finer mesh of degree 4 (A) or 3 (B), projected, and only pressed, in one step:
loading is proportional. Of case A, also the condition of the compliance of the contact nodes."""
import matplotlib.pyplot as plt
import numpy as np
import run_folder
import style
from points import RUN_FOLDER, program_point, tool_point

PAGE = "stability.md"
RATIOS = (0.4999, 0.499, 0.49, 0.45, 0.4, 0.3, 0.15, 0, -0.25, -0.5)
QUICK_RATIOS = (0.4999, 0.3)
CASES = {"a": "A, axisymmetric", "b": "B, quarter"}
DEGREES = (1, 2, 3)
QUADRATURES = ("full", "projected")
QUANTITIES = {"peak_force_N": "total force, %", "largest_slip_mm": "largest slip, µm"}


def mesh(degree):
    """12 intervals / degree across the core and over the height, 6 / degree from core to rim; they shrink from each one
    to the next by the same factor per node."""
    grading = 0.4**(degree / 3)
    return {"Mesh/Degree": degree, "Mesh/Core cells": 12 // degree, "Mesh/Rings": 6 // degree,
            "Mesh/Layers": 12 // degree, "Mesh/Core ratio": 0.6, "Mesh/Rim grading": f"{grading:.2f}",
            "Mesh/Layer grading": f"{grading:.2f}"}


FINEST = {
    "a": {"Mesh/Degree": 4, "Mesh/Core cells": 28, "Mesh/Rings": 8, "Mesh/Layers": 16, "Mesh/Core ratio": 0.6,
          "Mesh/Rim grading": 0.4, "Mesh/Layer grading": 0.4},
    "b": {"Mesh/Resolution": "fine"},
}
QUICK_FINEST = {case: mesh(3) for case in FINEST}


def columns_of(code, **values):
    names = (*QUANTITIES, "iterations", "equilibrium", "contact_nodes", "unknowns", "condition")
    return {"code": code, **{name: values.get(name, "") for name in names}}


def extracted(result, _):
    if result.code != 0:
        return columns_of(result.code)
    run = run_folder.RunFolder(result.folder)
    peak = run.history["uz"].argmin()
    model = run.summary["model"]
    return columns_of(0, peak_force_N=run.history["force_z"][peak], largest_slip_mm=run.history["max_slip"][peak],
                      iterations=int(run.history["iterations"].sum()), equilibrium=run.checks["equilibrium"].max(),
                      contact_nodes=model["contact_nodes"], unknowns=model["free_dofs"])


def condition(result, _):
    """Ratio of the eigenvalues of W at their ends, without the directions that symmetry holds: nothing is coupled to
    them."""
    if result.code != 0:
        return columns_of(result.code)
    compliance = np.fromfile(result.folder)
    compliance = compliance.reshape(2 * [int(round(compliance.size**0.5))])
    is_free = (compliance != 0).sum(axis=1) > 1
    values = np.linalg.eigvalsh(compliance[np.ix_(is_free, is_free)])
    return columns_of(0, condition=values[-1] / values[0])


def condition_points():
    for ratio in QUICK_RATIOS:
        for degree in DEGREES:
            for quadrature in QUADRATURES:
                settings = {"Material/Poisson ratio": ratio, "Mesh/Volumetric quadrature": quadrature, **mesh(degree)}
                words = [word for entry, value in settings.items() for word in ("--set", f"{entry}={value}")]
                yield tool_point({"case": "a", "mesh": f"Q{degree}", "quadrature": quadrature, "poisson": ratio},
                                 "compliance", "prm/paper/case_a.prm", "--matrix", RUN_FOLDER, *words)


def point(case, label, quadrature, ratio, settings):
    columns = {"case": case, "mesh": label, "quadrature": quadrature, "poisson": ratio}
    return program_point(columns, f"paper/case_{case}.prm",
                         {"Load program/Cycles": 1, "Output/Contact fields": 0, "Output/Volume fields": 0,
                          "Material/Poisson ratio": ratio, "Mesh/Volumetric quadrature": quadrature, **settings})


def points(ratios, finest):
    for case in CASES:
        for ratio in ratios:
            for degree in DEGREES:
                for quadrature in QUADRATURES:
                    yield point(case, f"Q{degree}", quadrature, ratio, mesh(degree))
            for quadrature in QUADRATURES if case == "a" else ("projected",):
                yield point(case, "finest", quadrature, ratio,
                            {**finest[case], "Load program/Legs": "0 0 -0.1 : 1",
                             "Checks/Equilibrium": 1e-6})  # rounding: 5e-8 of graded cells at 0.4999


def measured(context):
    ratios, finest = (QUICK_RATIOS, QUICK_FINEST) if context.is_quick else (RATIOS, FINEST)
    return (context.measure(list(points(ratios, finest)), extracted, jobs=context.jobs, threads=1) +
            context.measure(list(condition_points()), condition, jobs=context.jobs, threads=1))


def of_curve(rows, case, label, quadrature):
    """{Poisson's ratio: row}."""
    return {float(row["poisson"]): row for row in rows
            if (row["case"], row["mesh"], row["quadrature"]) == (case, label, quadrature) and row["peak_force_N"]}


def errors(rows, case, label, quadrature, quantity):
    """Poisson's ratios and absolute errors: of the force in percent, of the slip, which comes near 0, in micrometres.
    For a ratio of 0 nothing slips, and every mesh is exact but for its polygonal base."""
    curve = of_curve(rows, case, label, quadrature)
    truth = of_curve(rows, case, "finest", "projected")
    ratios = sorted(ratio for ratio in curve if ratio in truth and ratio != 0)
    differences = [abs(float(curve[ratio][quantity]) - float(truth[ratio][quantity])) for ratio in ratios]
    if quantity == "largest_slip_mm":
        return ratios, [1000 * difference for difference in differences]
    return ratios, [100 * difference / float(truth[ratio][quantity])
                    for ratio, difference in zip(ratios, differences)]


def style_of(degree, quadrature):
    is_full = quadrature == "full"
    return {"color": style.COLOURS[degree - 1], "linestyle": "-" if is_full else "--", "marker": "o",
            "markerfacecolor": style.COLOURS[degree - 1] if is_full else "white", "label": f"degree {degree}, {quadrature}"}


def set_ratio_axis(axes):
    """Poisson's ratio as 1/2 - nu, logarithmic, incompressible to the right."""
    ticks = (-0.5, 0, 0.3, 0.45, 0.49, 0.499, 0.4999)
    axes.set_xscale("log")
    axes.set_xlim(1.4, 7e-5)
    axes.set_xticks([0.5 - ratio for ratio in ticks], [f"{ratio:g}" for ratio in ticks], rotation=90)
    axes.xaxis.set_minor_locator(plt.NullLocator())


def curve(rows, case, label, quadrature, quantity):
    """Poisson's ratios, and errors or contact iterations."""
    if quantity != "iterations":
        return errors(rows, case, label, quadrature, quantity)
    found = of_curve(rows, case, label, quadrature)
    return sorted(found), [int(found[ratio]["iterations"]) for ratio in sorted(found)]


def figures(rows):
    case, charts = "b", {"peak_force_N": ("error of the total force (%)", (0.01, 0.1, 1, 10, 100)),
                         "largest_slip_mm": ("error of the largest slip (µm)", (0.1, 1, 10)),
                         "iterations": ("contact iterations, 15 steps", (10, 20, 50, 100, 200))}
    figure, grid = plt.subplots(1, len(charts), figsize=(style.WIDTH, 3.6))
    for axes, (quantity, (title, ticks)) in zip(grid, charts.items()):
        for degree in DEGREES:
            for quadrature in QUADRATURES:
                ratios, values = curve(rows, case, f"Q{degree}", quadrature, quantity)
                axes.plot([0.5 - ratio for ratio in ratios], values, **style_of(degree, quadrature))
        set_ratio_axis(axes)
        axes.set(yscale="log")
        axes.set_title(title, fontsize=8.5)
        axes.minorticks_off()
        style.plain_ticks(axes.yaxis, ticks)
    grid[1].set_xlabel("Poisson's ratio")
    style.legend_below(figure, *grid[0].get_legend_handles_labels(), 3)
    style.headline(figure, "Case B: full elements of degree 1 lock, projected ones do not")
    return {"locking": figure}


def signed_error(row, truth, quantity):
    error = 100 * (float(row[quantity]) / float(truth[quantity]) - 1)
    return f"{error:+.0f} %" if abs(error) >= 10 else f"{error:+.2g} %"


def tables(rows):
    """Case B at both ends of what is usual, and of case A the condition of W."""
    text = "| ν | element | total force | largest slip | contact iterations | condition of W (A) |\n|--:|---|--:|--:|--:|--:|\n"
    conditions = {(row["mesh"], row["quadrature"], row["poisson"]): float(row["condition"]) for row in rows if row["condition"]}
    for ratio in sorted(QUICK_RATIOS):
        truth = of_curve(rows, "b", "finest", "projected")[ratio]
        for degree in DEGREES:
            for quadrature in QUADRATURES:
                row = of_curve(rows, "b", f"Q{degree}", quadrature)[ratio]
                cells = [f"{ratio:g}", f"Q{degree}, {quadrature}", *(signed_error(row, truth, name) for name in QUANTITIES),
                         row["iterations"], f"{conditions[row['mesh'], quadrature, row['poisson']]:.0f}"]
                text += f"| {' | '.join(cells)} |\n"
    return {"locking": text}
