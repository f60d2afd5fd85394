# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""How far tractions at the nodes can be trusted: Cattaneo's shear traction, by element, mesh and model.

A sphere on a plane, a line contact of two bodies, and a sphere on a half-space are pressed and sheared once. Each node's
traction is compared with the closed form of its place, in rings between the middle, the border of the stick zone and the rim.
Meshes of all degrees have their nodes at about the same places."""
import math

import matplotlib.pyplot as plt
import numpy as np
import style
from points import StudyError, program_point
from run_folder import RunFolder

PAGE = "accuracy.md"
DEGREES = (2, 3)
LINE_DEGREES = (1, 2, 3)  # of two bodies
MU = 0.3
SPHERE = {"file": "cattaneo_mindlin", "step": 10, "a": 0.5, "c": 0.36840, "p0": 3 * 466.6 / (2 * math.pi * 0.5**2),
          "steps": {"Load program/Legs": "Fx 83.99 : 6"}}
LINE = {"file": "cattaneo_line", "step": 6, "a": 0.5, "c": 0.3, "p0": 288.46, "steps": {"Load program/Legs": "Fx 86.998 : 4"}}
MOST_CELLS = 200  # along a box
RATIOS = (0.4999, 0.49, 0.4, 0.3, 0)


def sphere_mesh(degree, fineness=1):
    """24 intervals between nodes across the core, 14 from core to rim and 24 over the height, times the fineness."""
    core = 2 * max(1, round(12 * fineness / degree))
    rings, layers = (max(2, round(n * fineness / degree)) for n in (14, 24))
    return {"Mesh/Degree": degree, "Mesh/Core cells": core, "Mesh/Rings": rings, "Mesh/Layers": layers,
            "Mesh/Rim grading": f"{1.8**(degree / 2 / fineness):.4f}", "Mesh/Layer grading": f"{0.45**(degree / 2 / fineness):.4f}"}


def line_mesh(degree, fineness=1):
    """384 intervals between nodes along the contact, and 78 over the height of each body, times the fineness."""
    cells = f"{round(384 * fineness / degree)}, 1, {round(78 * fineness / degree)}"
    grading = {"Edge grading": f"{1.05**(degree / 3 / fineness):.5f}", "Layer grading": f"{0.7**(degree / 3 / fineness):.5f}"}
    return {f"{of}/{name}": value for of in ("Mesh", "Lower mesh")
            for name, value in {"Degree": degree, "Cells": cells, **grading}.items()}


def point(family, scene, degree, fineness, poisson, mesh, settings=()):
    return program_point({"family": family, "degree": degree, "fineness": fineness, "poisson": poisson},
                         f"verification/{scene['file']}.prm",
                         {**scene["steps"], **mesh, **dict(settings), "Output/Contact fields": scene["step"], "Output/Volume fields": 0})


def line_point(degree, fineness=1, poisson=0.3):
    both = {f"{of}/Poisson ratio": poisson for of in ("Material", "Lower material")}
    # The width and the load of the contact depend on E / (1 - nu^2) alone.
    young = 210000 * (1 - poisson**2) / (1 - 0.3**2)
    both |= {f"{of}/Young modulus": f"{young:.9g}" for of in ("Material", "Lower material")}
    return point("line", LINE, degree, fineness, poisson, line_mesh(degree, fineness), both)


def points(is_quick):
    if is_quick:
        return [line_point(2, 0.25), line_point(3, 0.25)]
    found = [line_point(degree, fineness) for degree in LINE_DEGREES for fineness in (0.25, 0.5, 1)
             if 384 * fineness / degree <= MOST_CELLS]
    found += [line_point(degree, 0.5, poisson) for degree in LINE_DEGREES for poisson in RATIOS if poisson != 0.3]
    return found + [point("sphere", SPHERE, degree, 1, 0.4999, sphere_mesh(degree)) for degree in DEGREES]


def exact(scene, distance):
    """Cattaneo's traction (MPa) at distances (mm) from the middle, within the contact."""
    a, c = scene["a"], scene["c"]
    root = np.sqrt(np.maximum(1 - (distance / a)**2, 0))
    return MU * scene["p0"] * (root - c / a * np.sqrt(np.maximum(1 - (distance / c)**2, 0)))


def measures(result, of):
    if result.code != 0:
        raise StudyError(f"exit code {result.code}: {of.command}\n{result.errors}")
    scene = SPHERE if of.columns["family"] == "sphere" else LINE
    run = RunFolder(result.folder)
    contact = run.contact(scene["step"])
    x, y = contact.points[:, :2].T.astype(float)
    distance = np.hypot(x, y) if scene is SPHERE else np.abs(x)
    traction = np.abs(contact["friction_traction"][:, 0].astype(float))
    truth = exact(scene, distance)

    def scatter(low, high):
        """Root mean square of the relative error between these parts of c; in the middle of a line the traction is 0.36 of
        its peak, so that no quotient is of small numbers."""
        inside = (distance >= low * scene["c"]) & (distance < high * scene["c"])
        return float(np.sqrt(np.mean((traction[inside] / truth[inside] - 1)**2)))

    peak = MU * scene["p0"] * math.sqrt(1 - (scene["c"] / scene["a"])**2)
    slides = (distance > 1.05 * scene["c"]) & (distance < 0.95 * scene["a"])
    line = np.abs(y) < 1e-6 if scene is SPHERE else y == y.min()
    return {"nodes_over_a": int(np.sum(line & (distance < scene["a"]))),
            "inner": scatter(0, 0.6), "stuck": scatter(0, 0.9), "peak": float(traction.max() / peak - 1),
            "sliding": float(np.sqrt(np.mean((traction[slides] / truth[slides] - 1)**2)))}


def measured(context):
    return context.measure(points(context.is_quick), measures, jobs=context.jobs, threads=1)


def chosen(rows, family, degree, **columns):
    return [row for row in rows if row["family"] == family and int(row["degree"]) == degree and
            all(float(row[name]) == value for name, value in columns.items())]


def figures(rows):
    figure, (meshes, ratios) = plt.subplots(1, 2, figsize=(style.WIDTH, 3.6))
    for degree in LINE_DEGREES:
        colour = style.COLOURS[degree - 1]
        of_meshes = sorted(chosen(rows, "line", degree, poisson=0.3), key=lambda row: float(row["fineness"]))
        for name, line in (("stuck", "-"), ("sliding", "--")):
            meshes.plot([int(row["nodes_over_a"]) for row in of_meshes], [100 * float(row[name]) for row in of_meshes],
                        line, marker="o", color=colour, markerfacecolor=colour if line == "-" else "white",
                        label=f"degree {degree}, {'sticking' if name == 'stuck' else 'sliding'}")
        of_ratios = sorted(chosen(rows, "line", degree, fineness=0.5), key=lambda row: float(row["poisson"]))
        if len(of_ratios) > 1:
            ratios.plot([float(row["poisson"]) for row in of_ratios], [100 * float(row["stuck"]) for row in of_ratios], "-o",
                        color=colour)
    meshes.set(xscale="log", yscale="log", xlabel="nodes across the contact", ylabel="error of the shear traction (%)")
    ratios.set(yscale="log", xlabel="Poisson's ratio")
    for axes, ticks in ((meshes, (0.1, 0.2, 0.5, 1, 2, 5)), (ratios, (0.1, 1, 10, 100))):
        axes.minorticks_off()
        style.plain_ticks(axes.yaxis, ticks)
    style.plain_ticks(meshes.xaxis, sorted({int(row["nodes_over_a"]) for row in chosen(rows, "line", 2, poisson=0.3)}))
    meshes.set_title("meshes, ν = 0.3", fontsize=8.5)
    ratios.set_title("where it sticks, 45 nodes across", fontsize=8.5)
    style.legend_below(figure, *meshes.get_legend_handles_labels(), 4)
    style.headline(figure, HEADLINE)
    return {"tractions": figure}


HEADLINE = "From 45 nodes on, tractions of a line contact are within 1 % where it sticks"


def percent(value, sign=""):
    return f"{100 * float(value):{sign}.2g} %"


def tables(rows):
    text = "| contact | degree | nodes across | ν | r < 0.6 c | r < 0.9 c | where it slides | peak |\n|---|--:|--:|--:|--:|--:|--:|--:|\n"
    for row in rows:
        name = "sphere" if row["family"] == "sphere" else "line of two bodies"
        text += (f"| {name} | {row['degree']} | {row['nodes_over_a']} | {float(row['poisson']):g} | {percent(row['inner'])} | "
                 f"{percent(row['stuck'])} | {percent(row['sliding'])} | {percent(row['peak'], '+')} |\n")
    return {"tractions": text}
