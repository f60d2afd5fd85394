# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What reduced models buy: the same meshes as full, half and quarter bodies, case A also as an axisymmetric section.

Time and memory, medians of three runs, and the largest relative difference of what they answer."""
import statistics

import matplotlib.pyplot as plt
import style
from points import StudyError, program_point
from run_folder import RunFolder

PAGE = "accuracy.md"
PROGRAM = {"Load program/Legs": "0 0 -0.1 : 1; 0 0 -0.02 : 3", "Load program/Cycles": 1, "Output/Volume fields": 0,
           "Output/Contact fields": 0}
MODELS = {"a": ("full", "half", "quarter", "axisymmetric"), "c": ("full", "half", "quarter")}
MESHES = {"paper's, degree 1": {"Mesh/Degree": 1}, "paper's, degree 2": {"Mesh/Degree": 2},
          "graded, degree 3": {"Mesh/Degree": 3, "Mesh/Core cells": 4, "Mesh/Rings": 3, "Mesh/Core ratio": 0.6,
                               "Mesh/Rim grading": 0.4, "Mesh/Layers": 6, "Mesh/Layer grading": 0.36}}
ANSWERS = ("max_slip", "force_z", "total_dissipation", "elastic_energy", "stick_area")
RUNS = 3


def run_point(case, mesh, model, run):
    """The probe's name sets the repetitions apart, which are otherwise the same command."""
    settings = {**PROGRAM, "Mesh/Model": model, **MESHES[mesh], "Output/Probes": f"run-{run}: 0 0"}
    return program_point({"case": case, "mesh": mesh, "model": model, "run": run}, f"paper/case_{case}.prm", settings)


def figures_of_run(result, point):
    if result.code != 0:
        raise StudyError(f"exit code {result.code}: {point.command}\n{result.errors}")
    run = RunFolder(result.folder)
    model, history = run.summary["model"], run.history
    answers = {f"{name}_{int(step)}": f"{value:.15g}" for name in ANSWERS
               for step, value in zip(history["step"], history[name])}
    return {"contact_nodes": model["contact_nodes"], "unknowns": model["free_dofs"], "seconds": f"{result.seconds:.3f}",
            "cpu_seconds": f"{result.cpu_seconds:.3f}", "gigabytes": f"{result.gigabytes:.3f}", **answers}


def measured(context):
    meshes = list(MESHES)[:1] if context.is_quick else MESHES
    runs = 1 if context.is_quick else RUNS
    return context.measure([run_point(case, mesh, model, run) for case, models in MODELS.items() for mesh in meshes
                            for model in models for run in range(1, runs + 1)], figures_of_run, threads=1)


def medians(rows):
    """{(case, mesh): {model: row with the median seconds and gigabytes}}."""
    groups = {}
    for row in rows:
        groups.setdefault((row["case"], row["mesh"]), {}).setdefault(row["model"], []).append(row)
    return {key: {model: {**runs[0], "seconds": statistics.median(float(run["cpu_seconds"]) for run in runs),
                          "gigabytes": statistics.median(float(run["gigabytes"]) for run in runs)}
                  for model, runs in models.items()} for key, models in groups.items()}


def difference(row, full, answers):
    """The largest in all steps, relative to the largest of its kind."""
    worst = 0
    for answer in answers:
        names = [name for name in row if name.startswith(answer + "_")]
        scale = max(abs(float(full[name])) for name in names)
        worst = max([worst, *(abs(float(row[name]) - float(full[name])) / scale for name in names)])
    return worst


def figures(rows):
    groups = medians(rows)
    figure, grid = plt.subplots(2, len(MODELS), figsize=(style.WIDTH, 5), sharey="row", sharex="col")
    for column, (case, models) in zip(grid.T, MODELS.items()):
        column[0].set_title(f"case {case.upper()}")
        for axes, name, ticks in zip(column, ("seconds", "gigabytes"), ((0.2, 0.5, 1, 2, 5, 10), (0.1, 0.2, 0.5, 1))):
            for colour, mesh in zip(style.COLOURS, MESHES):
                if (case, mesh) in groups:
                    values = [groups[case, mesh][model][name] for model in models]
                    axes.plot(models, values, "o-", color=colour, label=f"mesh: {mesh}")
            axes.set(xlim=(-0.3, len(models) - 0.7), yscale="log")
            axes.minorticks_off()
            style.plain_ticks(axes.yaxis, ticks)
    for axes, label in zip(grid[:, 0], ("time of the run (s)", "memory (GB)")):
        axes.set_ylabel(label)
    style.legend_below(figure, *grid[0, 0].get_legend_handles_labels(), 3)
    style.headline(figure, "Reduced models take a fraction of the time and memory")
    return {"reduced_models": figure}


def tables(rows):
    text = ("| case | mesh | model | contact nodes | unknowns | seconds | times as fast | GB | difference | of stick area |\n"
            "|---|---|---|---|---|---|---|---|---|---|\n")
    for (case, mesh), models in medians(rows).items():
        full = models["full"]
        for model, row in models.items():
            differences = [format(difference(row, full, answers), ".0e") if model != "full" else ""
                           for answers in (ANSWERS[:-1], ANSWERS[-1:])]
            text += (f"| {case.upper()} | {mesh} | {model} | {row['contact_nodes']} | {row['unknowns']} | "
                     f"{row['seconds']:.2f} | {full['seconds'] / row['seconds']:.1f} | {row['gigabytes']:.2f} | "
                     f"{' | '.join(differences)} |\n")
    return {"reduced models": text}
