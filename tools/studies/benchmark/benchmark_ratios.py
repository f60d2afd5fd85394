# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What the times of one call of tools/study benchmark say: ratios, fitted exponents and tables."""
import math
import statistics

import numpy as np

from benchmark_measure import PAPER, PHASES

# What each ratio divides: figures of one run, and medians of kernels on the same mesh (k), in seconds.
RATIOS = {
    "contact of all steps / elastic solve": lambda run, k: run["contact"] / elastic(run, k),
    "condensation and contact / elastic solve":
        lambda run, k: (run["condensation"] + run["contact"]) / elastic(run, k),
    "checks of all steps / elastic solve": lambda run, k: run["checks"] / elastic(run, k),
    "output of all steps / elastic solve": lambda run, k: run["output"] / elastic(run, k),
    "whole process / (start-up + elastic solve)":
        lambda run, k: run["process"] / (run["start_up"] + elastic(run, k)),
    "start-up / whole process": lambda run, k: run["start_up"] / run["process"],
}
KERNEL_RATIOS = {
    "condensation / factorization": lambda k: k["condensation"] / k["factorization"],
    "(factorization + condensation) / factorization":
        lambda k: (k["factorization"] + k["condensation"]) / k["factorization"],
    "(factorization + condensation) / factorization in free order":
        lambda k: (k["factorization"] + k["condensation"]) / k["factorization_free"],
}
# What is drawn against size: seconds of the program's medians.
COSTS = {
    "elastic solve": lambda run, k: elastic(run, k),
    "condensation": lambda run, k: run["condensation"],
    "contact, a step": lambda run, k: run["contact"] / run["steps"],
    "checks, a step": lambda run, k: run["checks"] / run["steps"],
    "output, a step": lambda run, k: run["output"] / run["steps"],
}


def elastic(run, kernels):
    """What a linear elastic solve costs: assembly, factorization and one solution."""
    return run["assembly"] + run["factorization"] + kernels["one_solve"]


def kernels_of(result, cells):
    return {entry["kernel"]: entry["seconds"] for entry in result["kernels"] if entry["core_cells"] == cells}


def ratios(result):
    """{name: {core cells: ratio}}; of runs the median over the runs, each with its own times."""
    table = {}
    for program in result["programs"]:
        cells = program["core_cells"]
        kernels = kernels_of(result, cells)
        for name, of in RATIOS.items():
            values = [of(figures, kernels) for figures in program["samples"]]
            table.setdefault(name, {})[cells] = statistics.median(values)
        for name, of in KERNEL_RATIOS.items():
            if "factorization" in kernels:
                table.setdefault(name, {})[cells] = of(kernels)
    return table


def costs(result):
    """{name: (contact nodes, dofs, seconds)} as arrays over the meshes."""
    curves = {}
    for name, of in COSTS.items():
        points = [(program["contact_nodes"], program["dofs"],
                   of({**program["median"], "steps": program["steps"]}, kernels_of(result, program["core_cells"])))
                  for program in result["programs"]]
        curves[name] = np.array(sorted(points)).T
    return curves


def exponent(sizes, seconds):
    """Slope of the line through the logarithms of the three finest meshes."""
    if len(sizes) < 2:
        return math.nan
    return np.polyfit(np.log(sizes[-3:]), np.log(seconds[-3:]), 1)[0]


def number(value):
    return f"{value:.3g}" if value < 100 else f"{value:.0f}"


def time_text(seconds):
    for unit, factor in (("s", 1), ("ms", 1e-3), ("µs", 1e-6)):
        if seconds >= factor:
            return f"{number(seconds / factor)} {unit}"
    return f"{number(seconds / 1e-9)} ns"


def markdown(header, rows):
    lines = [header, ["---"] * len(header), *rows]
    return "".join("| " + " | ".join(str(cell) for cell in line) + " |\n" for line in lines)


def mesh_title(program):
    cells = program["core_cells"]
    return f"{program['contact_nodes']} nodes" + (" (the paper's mesh)" if cells == PAPER else "")


def ratio_table(result):
    programs = result["programs"]
    header = ["ratio", *(mesh_title(program) for program in programs)]
    return markdown(header, [[name, *(number(values[p["core_cells"]]) if p["core_cells"] in values else "–"
                                      for p in programs)] for name, values in ratios(result).items()])


def phase_table(result):
    programs = result["programs"]
    header = ["", *(mesh_title(program) for program in programs)]
    rows = [["unknowns", *(program["dofs"] for program in programs)]]
    for name in ("start_up", *PHASES, "process"):
        rows.append([name.replace("_", "-").replace("process", "whole process"),
                     *(time_text(program["median"][name]) for program in programs)])
    rows.append(["memory", *(f"{number(program['median']['gigabytes'])} GB" for program in programs)])
    curves = costs(result)
    header.append("exponent (nodes)")
    header.append("exponent (unknowns)")
    for row in rows:
        row.extend(["", ""])
    for name, (nodes, dofs, seconds) in curves.items():
        rows.append([f"*{name}*", *(time_text(value) for value in seconds), f"{exponent(nodes, seconds):.2f}",
                     f"{exponent(dofs, seconds):.2f}"])
    return markdown(header, rows)


def kernel_table(result):
    sizes = [program["core_cells"] for program in result["programs"]]
    titles = {program["core_cells"]: mesh_title(program) for program in result["programs"]}
    found = {(entry["kernel"], entry["core_cells"]): entry["seconds"] for entry in result["kernels"]}
    rows = []
    for kernel in dict.fromkeys(name for name, _ in found if not name.startswith("ordering")):
        if (kernel, None) in found:
            rows.append([kernel.replace("/", ", "), time_text(found[kernel, None]), *[""] * (len(sizes) - 1)])
        else:
            rows.append([kernel, *(time_text(found[kernel, cells]) if (kernel, cells) in found else "–"
                                   for cells in sizes)])
    return markdown(["kernel", *(titles[cells] for cells in sizes)], rows)


def ordering_table(result):
    rows = [[entry["kernel"].split("/")[1].replace("_", " "), int(entry["dofs"]), number(entry["gigaflops"]),
             f"{number(1000 * entry['factor_gigabytes'])} MB", time_text(entry["seconds"])]
            for entry in result["kernels"] if entry["kernel"].startswith("ordering")]
    return markdown(["ordering", "unknowns", "Gflop", "factor", "order, analysis and factorization"], rows)


def conditions(result):
    """With what it was measured, as a paragraph."""
    blas = result["versions"]["BLAS"].split()
    return (f"Medians of {result['runs']} runs on {result['cores']} cores ({result['processor']}), "
            f"{' '.join(blas[:2])} with threads: {result['blas_threads']}; load average of the machine before the start "
            f"{result['load_average_before']:.1f}; orthocone {result['versions']['orthocone']}.\n")


TABLES = {"conditions": conditions, "ratios": ratio_table, "phases": phase_table, "kernels": kernel_table, "orderings": ordering_table}
