# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Several solutions of one load step: critical friction of a node and of meshes, and where solvers notice it."""
import csv
import io

import numpy as np
import style
from points import program_point, tool_point
from run_folder import RunFolder

PAGE = "stability.md"
CASES = {"a": ((0.2, 0.2), "A"), "b": ((0.3, 0.15), "B"), "c": ((0.3, 0.15), "C (non-associated)")}
METHODS = ("newton", "gauss-seidel", "uzawa")
RESOLUTIONS = ("paper", "coarse", "medium", "fine")
STATES = {"o": "open", "s": "slip", "k": "stick", "oks": "all three"}
COLUMNS = ("kind", "case", "resolution", "poisson_ratio", "friction", "critical_factor", "node_x", "node_y", "states",
           "largest_residual", "loads", "loads_with_several", "largest_difference", "solves",
           *(f"failed_{method}" for method in METHODS))


def columns(**known):
    return {name: known.get(name, "") for name in COLUMNS}


def one_node_points(quick):
    factors = (0.5, 2) if quick else np.round(np.geomspace(0.25, 8, 41), 4)
    return [tool_point(columns(kind="one node", friction=factor), "one_node", "--coupling", 0.4, "--friction", factor,
                       "--loads", 720) for factor in factors]


def mesh_points(quick):
    meshes = [(case, resolution, 0.3) for case in CASES for resolution in RESOLUTIONS]
    meshes += [(case, "coarse", ratio) for case in CASES for ratio in (0, 0.1, 0.2, 0.35, 0.4, 0.45, 0.49)]
    return [program_point(columns(kind="mesh", case=case, resolution=resolution, poisson_ratio=ratio),
                          f"paper/case_{case}.prm",
                          {"Mesh/Resolution": resolution, "Material/Poisson ratio": ratio,
                           "Load program/Legs": "0 0 -0.01 : 1", "Output/Contact fields": 0, "Output/Volume fields": 0})
            for case, resolution, ratio in (meshes[:2] if quick else meshes)]


def starts_points(quick):
    scales = {"a": (1, 2, 4, 6, 7, 8, 8.4, 9, 10, 12, 16, 24, 32), "b": (1, 2, 4, 5, 5.6, 6.5, 8, 11, 16),
              "c": (0.5, 1, 1.5, 2, 3, 4, 6, 9)}
    points = []
    for case, values in ({"a": (1, 9)} if quick else scales).items():
        for scale in values:
            coefficients = ", ".join(f"{scale * mu:g}" for mu in CASES[case][0])
            words = ["starts", f"prm/paper/case_{case}.prm", "--set", "Mesh/Resolution=coarse", "--set",
                     f"Friction/Coefficients={coefficients}", "--set", "Contact solver/Maximum iterations=2000"]
            known = {"case": case, "resolution": "coarse", "poisson_ratio": 0.3, "friction": scale}
            n_loads = 40 if case == "a" else 8
            points.append(tool_point(columns(kind="random loads", **known), *words, "--loads", n_loads, "--starts", 1))
            if scale in (1, 8, 9):
                points += [tool_point(columns(kind=f"step {step}", **known), *words, "--step", step, "--starts", 2)
                           for step in (1, 8)]
    return points


def extract(result, point):
    """The figures of a row; the columns that say where the point lies stay as they are."""
    if result.code != 0:
        return {"critical_factor": "failed"}
    if point.columns["kind"] == "mesh":
        critical = RunFolder(result.folder).summary["critical_friction"] or {"factor": "", "node_mm": None}
        node = critical["node_mm"] or ("", "")  # nothing is coupled
        return {"critical_factor": critical["factor"], "node_x": node[0], "node_y": node[1]}
    rows = list(csv.DictReader(io.StringIO(result.output)))
    if point.columns["kind"] == "one node":
        return {"states": " ".join(row["states"] for row in rows), "loads": len(rows),
                "loads_with_several": sum(len(row["states"]) > 1 for row in rows),
                "largest_residual": max(float(row["largest_residual"]) for row in rows)}
    several = {row["load"] for row in rows if row["solution"] not in ("", "0")}
    counts = {f"failed_{method}": sum(row["method"] == method and row["converged"] == "0" for row in rows)
              for method in METHODS}
    return {"loads": len({row["load"] for row in rows}), "loads_with_several": len(several),
            "largest_difference": max([float(row["force_distance"]) for row in rows if row["converged"] == "1"] + [0]),
            "largest_residual": max([float(row["residual"]) for row in rows if row["converged"] == "1"] + [0]),
            "solves": len(rows) // len(METHODS), **counts}


def measured(context):
    points = one_node_points(context.is_quick) + mesh_points(context.is_quick) + starts_points(context.is_quick)
    return context.measure(points, extract, jobs=context.jobs, threads=1)


def draw_one_node(axes, rows):
    """Which states solve the law, over the direction of the load and the friction."""
    numbers = {state: number for number, state in enumerate(STATES)}
    colours = [*style.COLOURS[5:6], style.COLOURS[4], style.COLOURS[2], style.COLOURS[1]]
    factors = np.array([float(row["friction"]) for row in rows])
    image = np.array([[numbers[state] for state in row["states"].split()] for row in rows])
    angles = (np.arange(image.shape[1]) + 0.5) * 360 / image.shape[1]
    axes.pcolormesh(angles, factors, image, cmap=style.matplotlib.colors.ListedColormap(colours), vmin=-0.5, vmax=3.5,
                    shading="nearest", rasterized=True)
    axes.axhline(1, color="black", linestyle="--", linewidth=1)
    for (angle, factor), name in zip(((55, 1.5), (95, 0.35), (115, 2), (80.5, 5)), STATES.values()):
        axes.text(angle, factor, name, ha="center", va="center", fontsize=9)
    axes.set(xlim=(40, 140), yscale="log", xlabel="direction of the load (degrees, from normal to tangential)",
             ylabel="friction / critical friction", title="one node: states that solve the law")
    axes.minorticks_off()
    style.plain_ticks(axes.yaxis, (0.25, 0.5, 1, 2, 4, 8))


def draw_meshes(axes, rows, x_of, **labels):
    for colour, (case, (_, name)) in zip(style.COLOURS, CASES.items()):
        chosen = sorted((x_of(row), float(row["critical_factor"])) for row in rows if row["case"] == case)
        if chosen:
            axes.plot(*zip(*chosen), "o-", color=colour, label=f"case {name}")
    axes.axhline(1, color="black", linestyle="--", linewidth=1, label="1: several solutions below")
    axes.set(**labels, ylim=(0, 11), yticks=(0, 2, 4, 6, 8, 10))


def draw_starts(axes, rows, critical, name):
    """Share of solves that fail and of loads with several solutions, over the friction relative to the estimate."""
    rows = sorted(rows, key=lambda row: float(row["friction"]))
    x = [float(row["friction"]) / critical for row in rows]
    for method in METHODS:
        axes.plot(x, [100 * int(row[f"failed_{method}"]) / int(row["solves"]) for row in rows], "o-",
                  color=style.METHOD_COLOURS[method], label=f"starts from which {method} fails")
    axes.plot(x, [100 * int(row["loads_with_several"]) / int(row["loads"]) for row in rows], "s--", color="black",
              label="loads with several solutions")
    axes.axvline(1, color="black", linestyle="--", linewidth=1)
    axes.axvline(1 / critical, color="black", linestyle=":", linewidth=1, label="friction of the case")
    axes.set(xscale="log", xlim=(0.1, 10), ylim=(-3, 103), title=f"case {name}")
    axes.minorticks_off()
    style.plain_ticks(axes.xaxis, (0.1, 0.2, 0.5, 1, 2, 5, 10))


def critical_friction(rows):
    figure, axes = style.plt.subplot_mosaic([["node", "node"], ["refinement", "poisson"]], figsize=(style.WIDTH, 5.2))
    draw_one_node(axes["node"], [row for row in rows if row["kind"] == "one node"])
    meshes = [row for row in rows if row["kind"] == "mesh" and row["critical_factor"] != "failed"]
    draw_meshes(axes["refinement"], [row for row in meshes if float(row["poisson_ratio"]) == 0.3],
                lambda row: RESOLUTIONS.index(row["resolution"]), xlabel="resolution of the mesh",
                ylabel="critical friction\n/ friction of the case", title="cases, over the mesh")
    axes["refinement"].set_xticks(range(len(RESOLUTIONS)), RESOLUTIONS)
    draw_meshes(axes["poisson"], [row for row in meshes if row["resolution"] == "coarse"],
                lambda row: float(row["poisson_ratio"]), xlabel="Poisson's ratio", title="cases, over Poisson's ratio")
    style.legend_below(figure, *axes["poisson"].get_legend_handles_labels(), 4)
    style.headline(figure, "Above the critical friction a node has three states; only case C comes near")
    return figure


def random_loads(rows):
    critical = {row["case"]: float(row["critical_factor"]) for row in rows
                if row["kind"] == "mesh" and row["resolution"] == "coarse" and float(row["poisson_ratio"]) == 0.3}
    figure, axes = style.plt.subplots(1, 3, figsize=(style.WIDTH, 3.4), sharey=True)
    for ax, (case, (_, name)) in zip(axes, CASES.items()):
        chosen = [row for row in rows if row["kind"] == "random loads" and row["case"] == case]
        if chosen and case in critical:
            draw_starts(ax, chosen, critical[case], name)
    axes[0].set_ylabel("share (%)")
    axes[1].set_xlabel("friction / critical friction")
    style.legend_below(figure, *axes[0].get_legend_handles_labels(), 2)
    style.headline(figure, "Random loads: solvers fail from about the critical friction on, newton least")
    return figure


def figures(rows):
    return {"uniqueness": critical_friction(rows), "uniqueness_loads": random_loads(rows)}
