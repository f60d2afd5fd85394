# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""One, two and four processes: time, memory and messages of a V-cycle, from 11 000 to 618 000 unknowns."""
import os
import re
import statistics

import matplotlib.pyplot as plt

import style
from points import Point, RUN_FOLDER, StudyError
from run_folder import RunFolder

PAGE = "scale.md"
CASES = ("a", "b", "c")
REFINEMENTS = (2, 3, 4)
PROCESSES = (1, 2, 4)
CUBES = {"Mesh/Model": "quarter", "Mesh/Backend": "multigrid", "Mesh/Core cells": 2, "Mesh/Rings": 1, "Mesh/Core ratio": 0.6,
         "Mesh/Layers": 2, "Load program/Legs": "0 0 -0.1 : 1 ; 0 0 0 : 4", "Load program/Cycles": 1,
         "Output/Contact fields": 0, "Output/Volume fields": 0, "Output/Probes": ""}
# Counts the messages of each process, and prints them when it ends.
MONITORED = ["--mca", "pml_monitoring_enable", "2", "--mca", "pml_monitoring_enable_output", "1"]
FOR_ROOT = ("OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM")


def point(case, refinements, processes):
    words = ["mpirun", "--oversubscribe", *MONITORED, "-n", str(processes), "build/orthocone", f"prm/paper/case_{case}.prm",
             "--quiet", "--output", RUN_FOLDER]
    for entry, value in {**CUBES, "Mesh/Refinements": refinements}.items():
        words += ["--set", f"{entry}={value}"]
    return Point({"case": case, "refinements": refinements, "processes": processes}, words)


def sent(output, kind):
    """Messages and bytes that each process sent to others. E: from one to another, as the solver asks for; A2A: in
    sums over all."""
    messages, sizes = {}, {}
    lines = {"E": r"^E\t(\d+)\t(?!\1\t)\d+\t(\d+) bytes\t(\d+) msgs", "A2A": r"^A2A\t(\d+)\t(\d+) bytes\t(\d+) msgs"}
    for process, size, number in re.findall(lines[kind], output, re.MULTILINE):
        messages[process] = messages.get(process, 0) + int(number)
        sizes[process] = sizes.get(process, 0) + int(size)
    return max(messages.values(), default=0), max(sizes.values(), default=0)


def extract(result, _point):
    if result.code:
        raise StudyError(result.errors.strip())
    summary = RunFolder(result.folder).summary
    messages, size = sent(result.output, "E")
    sums, _ = sent(result.output, "A2A")
    return {"dofs": summary["model"]["dofs"], "contact_nodes": summary["model"]["contact_nodes"],
            "v_cycles": summary["contact_solver"]["v_cycles"], "set_up_seconds": round(
                sum(summary["seconds"][phase] for phase in ("mesh", "assembly", "factorization")), 3),
            "contact_seconds": round(summary["seconds"]["contact"], 3), "gigabytes": result.gigabytes, "messages": messages,
            "bytes": size, "messages_of_sums": sums}


def measured(context):
    for name in FOR_ROOT:
        os.environ.setdefault(name, "1")
    sizes, cases = (REFINEMENTS[:1], CASES[:1]) if context.is_quick else (REFINEMENTS, CASES)
    return context.measure([point(case, size, n) for size in sizes for case in cases for n in PROCESSES], extract, threads=1)


def of(rows, refinements, processes, figure):
    """Median of the cases."""
    return statistics.median(figure(row) for row in rows
                             if (int(row["refinements"]), int(row["processes"])) == (refinements, processes))


def number(row, name):
    return float(row[name])


def per_cycle(name):
    return lambda row: number(row, name) / number(row, "v_cycles")


def ratio_to_one(rows, refinements, processes):
    """How many times faster a V-cycle is than on one process, median of the cases."""
    times = {(row["case"], int(row["processes"])): per_cycle("contact_seconds")(row) for row in rows
             if int(row["refinements"]) == refinements}
    cases = {case for case, _ in times}
    return statistics.median(times[case, 1] / times[case, processes] for case in cases)


def figures(rows):
    sizes = sorted({int(row["refinements"]) for row in rows})
    figure, (time, memory) = plt.subplots(1, 2, figsize=(style.WIDTH, 3.3))
    for n, colour in zip(PROCESSES, style.COLOURS):
        dofs = [of(rows, size, n, lambda row: number(row, "dofs")) for size in sizes]
        looks = {"color": colour, "label": f"{n} process{'es' if n > 1 else ''}" + (" on two cores" if n > 2 else "")}
        time.plot(dofs, [1e6 * of(rows, size, n, per_cycle("contact_seconds")) / dof for size, dof in zip(sizes, dofs)], "o-",
                  **looks)
        memory.plot(dofs, [of(rows, size, n, lambda row: number(row, "gigabytes")) for size in sizes], "o-", **looks)
    time.set_title("time per unknown and V-cycle (µs)")
    memory.set_title("memory of the largest process (GB)")
    for axes in (time, memory):
        axes.set(xlabel="degrees of freedom", xscale="log")
        axes.set_ylim(0)
        axes.minorticks_off()
        axes.set_xticks((1e4, 3e4, 1e5, 3e5), ("10 000", "30 000", "100 000", "300 000"))
    style.legend_below(figure, *time.get_legend_handles_labels(), 3)
    style.headline(figure, "Two processes take half to three quarters of the time, and less memory each")
    return {"scale": figure}


def tables(rows):
    text = ("| degrees of freedom | contact nodes | processes | V-cycle, ms | faster than one | set-up, s | largest process, GB "
            "| messages a V-cycle | kB a V-cycle | sums a V-cycle |\n" + "|--:" * 10 + "|\n")
    for size in sorted({int(row["refinements"]) for row in rows}):
        for n in PROCESSES:
            def cell(figure):
                return of(rows, size, n, figure)
            text += (f"| {cell(lambda row: number(row, 'dofs')):,.0f} | {cell(lambda row: number(row, 'contact_nodes')):.0f} | {n} "
                     f"| {1e3 * cell(per_cycle('contact_seconds')):.3g} | {ratio_to_one(rows, size, n):.2f} "
                     f"| {cell(lambda row: number(row, 'set_up_seconds')):.2g} | {cell(lambda row: number(row, 'gigabytes')):.2g} "
                     f"| {cell(per_cycle('messages')):.0f} | {1e-3 * cell(per_cycle('bytes')):.0f} "
                     f"| {cell(per_cycle('messages_of_sums')):.0f} |\n").replace(",", " ")
    return {"scale": text}
