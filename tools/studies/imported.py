# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Meshes by Gmsh against the built-in cylinder: what three sizes of cells differ by, at the peak of case B.

The sides of the imported cylinders are facets between the nodes of the file, so that their bases are too small."""
import math

import matplotlib.pyplot as plt
import style
from points import StudyError, program_point
from run_folder import RunFolder

PAGE = "verification.md"
SIZES = {"cylinder_coarse": 5, "cylinder": 2.5, "cylinder_fine": 1.25}  # mm, of the cells that gmsh was asked for
QUICK = ("cylinder_coarse", "cylinder")
AREA = 100 * math.pi  # mm^2
PEAK = {"Load program/Legs": "0 0 -0.1 : 5", "Load program/Cycles": 1, "Output/Volume fields": 0, "Output/Contact fields": 0}


def measures(result, point):
    if result.code != 0:
        raise StudyError(f"exit code {result.code}: {point.command}\n{result.errors}")
    run = RunFolder(result.folder)
    return {"nodes": run.summary["model"]["contact_nodes"], "area": run.summary["scene"]["area_mm2"],
            **{name: run.history[name][-1] for name in ("force_z", "max_slip", "total_dissipation")}}


def measured(context):
    points = [program_point({"mesh": mesh, "size": SIZES[mesh]}, "import/cylinder.prm",
                            {"Geometry/Mesh file": f"prm/import/{mesh}.msh", **PEAK})
              for mesh in (QUICK if context.is_quick else SIZES)]
    points.append(program_point({"mesh": "built-in", "size": ""}, "paper/case_b.prm",
                                {"Mesh/Resolution": "coarse" if context.is_quick else "fine", **PEAK}))
    return context.measure(points, measures, jobs=context.jobs, threads=1)


def differences(rows):
    """[(name, size, contact nodes, {quantity: %})] of the imported meshes; areas against the circle's."""
    *imported, built_in = rows
    names = ("force_z", "max_slip", "total_dissipation")
    return [(row["mesh"], float(row["size"]), int(row["nodes"]),
             {"area": 100 * (float(row["area"]) / AREA - 1),
              **{name: 100 * (float(row[name]) / float(built_in[name]) - 1) for name in names}}) for row in imported]


def figures(rows):
    figure, axes = plt.subplots(figsize=(style.WIDTH, 3.6))
    found = differences(rows)
    sizes = [size for _, size, _, _ in found]
    for number, (name, label) in enumerate(LABELS.items()):
        axes.plot(sizes, [abs(values[name]) for *_, values in found], "o-", color=style.COLOURS[number], label=label)
    axes.plot(sizes, [2 * (size / sizes[0])**2 for size in sizes], color="0.6", linewidth=1, label="size squared")
    axes.set(xscale="log", yscale="log", xlabel="size of Gmsh's cells (mm)", ylabel="difference (%)")
    axes.minorticks_off()
    style.plain_ticks(axes.xaxis, sizes)
    style.plain_ticks(axes.yaxis, (0.1, 0.2, 0.5, 1, 2, 5, 10))
    style.legend_below(figure, *axes.get_legend_handles_labels(), 5)
    style.headline(figure, "Area and force converge with the square of the cell size, slip more slowly")
    return {"imported": figure}


LABELS = {"area": "area of the base", "force_z": "force", "max_slip": "largest slip", "total_dissipation": "dissipated energy"}


def tables(rows):
    text = "| mesh | cells (mm) | contact nodes | " + " | ".join(LABELS.values()) + " |\n|---|--:|--:|" + "--:|" * len(LABELS) + "\n"
    for mesh, size, nodes, values in differences(rows):
        text += f"| `{mesh}.msh` | {size:g} | {nodes} | " + " | ".join(f"{values[name]:+.2f} %" for name in LABELS) + " |\n"
    return {"imported": text}
