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
    handles = [style.matplotlib.patches.Patch(color=colour, label=name)
               for colour, name in zip(colours, STATES.values())]
    axes.legend(handles=handles, loc="upper left", frameon=True, fontsize=8)
    axes.set(xlim=(40, 140), yscale="log", xlabel="direction of the load q, degrees from $q_n$ to $q_t$",
             ylabel="$\\mu\\,|w_{nt}|/w_{nn}$", title="One node: states that solve the law")
    plain_numbers(axes.yaxis, (0.25, 0.5, 1, 2, 4, 8))


def plain_numbers(axis, ticks):
    axis.set_major_locator(style.matplotlib.ticker.FixedLocator(ticks))
    axis.set_major_formatter(style.matplotlib.ticker.FormatStrFormatter("%g"))
    axis.set_minor_locator(style.matplotlib.ticker.NullLocator())


def draw_meshes(axes, rows, x_of, **labels):
    for colour, (case, (_, name)) in zip(style.COLOURS, CASES.items()):
        chosen = sorted((x_of(row), float(row["critical_factor"])) for row in rows if row["case"] == case)
        if chosen:
            axes.plot(*zip(*chosen), "o-", color=colour, label=name)
    axes.axhline(1, color="black", linestyle="--", linewidth=1)
    axes.set(**labels, ylim=(0, 12), ylabel="critical factor")
    axes.legend(ncols=3, loc="upper center", fontsize=8)


def draw_starts(axes, rows, critical, name):
    """Share of solves that fail and of loads with several solutions, over the friction relative to the estimate."""
    rows = sorted(rows, key=lambda row: float(row["friction"]))
    x = [float(row["friction"]) / critical for row in rows]
    for method in METHODS:
        axes.plot(x, [100 * int(row[f"failed_{method}"]) / int(row["solves"]) for row in rows], "o-", markersize=4,
                  color=style.METHOD_COLOURS[method], label=f"{method} fails")
    axes.plot(x, [100 * int(row["loads_with_several"]) / int(row["loads"]) for row in rows], "s--", color="black",
              markersize=5, label="loads with several solutions")
    axes.axvline(1, color="black", linestyle="--", linewidth=1)
    axes.axvline(1 / critical, color="black", linestyle=":", linewidth=1)
    axes.text(1 / critical, 97, " as given ", fontsize=8, va="top", ha="left" if critical > 2 else "right")
    axes.set(xscale="log", ylim=(-3, 100), xlabel="friction / critical friction", ylabel="percent",
             title=f"Case {name}: random loads")
    plain_numbers(axes.xaxis, (0.125, 0.25, 0.5, 1, 2, 4, 8))


def figures(rows):
    figure, axes = style.plt.subplots(2, 3, figsize=(11.5, 7))
    draw_one_node(axes[0, 0], [row for row in rows if row["kind"] == "one node"])
    meshes = [row for row in rows if row["kind"] == "mesh" and row["critical_factor"] != "failed"]
    usual = [row for row in meshes if float(row["poisson_ratio"]) == 0.3]
    draw_meshes(axes[0, 1], usual, lambda row: RESOLUTIONS.index(row["resolution"]), xlabel="Mesh/Resolution",
                title="Meshes: refinement")
    axes[0, 1].set_xticks(range(len(RESOLUTIONS)), RESOLUTIONS)
    draw_meshes(axes[0, 2], [row for row in meshes if row["resolution"] == "coarse"],
                lambda row: float(row["poisson_ratio"]), xlabel="Poisson ratio", title="Meshes: Poisson ratio")
    critical = {row["case"]: float(row["critical_factor"]) for row in usual if row["resolution"] == "coarse"}
    for ax, (case, (_, name)) in zip(axes[1], CASES.items()):
        chosen = [row for row in rows if row["kind"] == "random loads" and row["case"] == case]
        if chosen and case in critical:
            draw_starts(ax, chosen, critical[case], name)
    axes[1, 0].legend(loc="center left", fontsize=7.5)
    return {"uniqueness": figure}
