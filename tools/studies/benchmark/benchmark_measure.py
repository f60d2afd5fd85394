# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What tools/study benchmark times: kernels of the libraries, and whole runs of the program."""
import json
import os
import pathlib
import statistics
import subprocess
import tempfile
import time

from paths import ROOT
from run_folder import RunFolder

CASE = ROOT / "prm/paper/case_b.prm"  # a quarter of quadratic elements, 3 cycles, 45 steps, all fields written
PAPER = 8  # core cells of the paper's mesh; a mesh of n core cells has n / 2 layers
LARGEST_OF_ALL_KERNELS = 16  # on finer meshes only the kernel that ratios need
LARGEST_OF_ORDERINGS = 8
PHASES = ("mesh", "assembly", "factorization", "condensation", "contact", "checks", "output")

COUNTERS = ("contact_nodes", "dofs", "solver_iterations", "gigaflops", "factor_gigabytes")


class BenchmarkError(Exception):
    """Something could not be run."""


def started(command, **options):
    try:
        return subprocess.Popen([str(word) for word in command], text=True, stderr=subprocess.PIPE, **options)
    except OSError as error:
        raise BenchmarkError(f"{command[0]} could not be started: {error.strerror}") from error


def timed_process(command):
    """Wall seconds and largest memory (GB) of a process, from its start to its end."""
    begin = time.perf_counter()
    process = started(command, stdout=subprocess.DEVNULL)
    errors = process.stderr.read()
    _, status, usage = os.wait4(process.pid, 0)
    seconds = time.perf_counter() - begin
    process.stderr.close()
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        raise BenchmarkError(f"{command[0]} ended with code {process.returncode}: {errors.strip()}")
    return seconds, usage.ru_maxrss / 1e6


def sample(program, cells, folder):
    """Seconds of one start of the program and of one whole run, with its phases."""
    start_up, _ = timed_process([program, "--version"])
    out = pathlib.Path(folder) / f"cells-{cells}"
    command = [program, CASE, "--quiet", "--output", out, f"--set=Mesh/Core cells={cells}",
               f"--set=Mesh/Layers={max(1, cells // 2)}"]
    process, gigabytes = timed_process(command)
    summary = RunFolder(out).summary
    seconds = {phase: summary["seconds"][phase] for phase in PHASES}
    return {"start_up": start_up, "process": process, "gigabytes": gigabytes, **seconds}, summary


def program_runs(program, sizes, n_runs):
    """Runs of case B on every mesh. The meshes take turns, so that a busy minute hits all alike."""
    records = {}
    with tempfile.TemporaryDirectory() as folder:
        for run in range(n_runs):
            for cells in sizes:
                print(f"benchmark: run {run + 1} of {n_runs}, {cells} core cells", flush=True)
                figures, summary = sample(program, cells, folder)
                record = records.setdefault(cells, {"core_cells": cells, "dofs": summary["model"]["dofs"],
                                                    "contact_nodes": summary["model"]["contact_nodes"],
                                                    "steps": summary["steps"]["solved"], "samples": []})
                record["samples"].append(figures)
    for record in records.values():
        record["median"] = {name: statistics.median(figures[name] for figures in record["samples"])
                            for name in record["samples"][0]}
    return list(records.values())


def kernel_filter(sizes):
    """Regular expression of the kernels to be run: of one node, of these sizes."""
    def some(limit):
        return "|".join(str(cells) for cells in sizes if cells <= limit) or "none"
    of_one_node = "^(projection|trial_force|one_node)"
    words = "residual|sweep|newton|contact|assembly|factorization|condensation|assembled_product|matrix_free_product"
    of_all = f"^({words}).*/({some(LARGEST_OF_ALL_KERNELS)})/"
    solve = f"^one_solve/({some(max(sizes))})/"
    orderings = f"^ordering.*/({some(LARGEST_OF_ORDERINGS)})/"
    return "|".join((of_one_node, of_all, solve, orderings))


def kernel_times(kernels, sizes, n_runs, least_seconds):
    """Median seconds of every kernel."""
    command = [kernels, f"--benchmark_filter={kernel_filter(sizes)}", "--benchmark_format=json",
               f"--benchmark_min_time={least_seconds}", f"--benchmark_repetitions={n_runs}",
               "--benchmark_enable_random_interleaving=true"]  # a busy minute of the machine hits all alike
    process = started(command, stdout=subprocess.PIPE)
    output, errors = process.communicate()
    if process.returncode:
        raise BenchmarkError(f"{kernels} ended with code {process.returncode}: {errors.strip()}")
    samples = {}
    for entry in json.loads(output)["benchmarks"]:
        if entry.get("error_occurred"):
            raise BenchmarkError(f"kernel {entry['name']}: {entry['error_message']}")
        if entry["run_type"] == "iteration":
            samples.setdefault(entry["name"], []).append(entry)
    in_order = sorted(samples.items(), key=lambda item: place(item[1][0]))
    return [kernel_record(name, entries) for name, entries in in_order]


def place(entry):
    """Order of the kernels: those of one node first, then as they stand in the sources, by size."""
    return ("contact_nodes" in entry, entry["family_index"], entry["per_family_instance_index"])


def kernel_record(name, entries):
    unit = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1}[entries[0]["time_unit"]]
    parts = [part for part in name.split("/") if part != "real_time"]
    cells = int(parts.pop()) if parts[-1].isdigit() else None
    return {"kernel": "/".join(parts), "core_cells": cells,
            "seconds": statistics.median(entry["real_time"] for entry in entries) * unit,
            **{counter: entries[0][counter] for counter in COUNTERS if counter in entries[0]}}


def processor():
    with open("/proc/cpuinfo", encoding="ascii", errors="replace") as file:
        for line in file:
            if line.startswith("model name"):
                return line.split(":", 1)[1].strip()
    return "unknown"


def measure(options):
    """Everything that one call of tools/study benchmark measures."""
    load = os.getloadavg()[0]
    n_cores = len(os.sched_getaffinity(0))
    threads = os.environ.get("OPENBLAS_NUM_THREADS", "as many as cores")
    os.environ.setdefault("OPENBLAS_NUM_THREADS", str(n_cores))  # the program would choose by the load, once a run
    programs = program_runs(options.program, options.sizes, options.runs)
    print("benchmark: kernels", flush=True)
    kernels = kernel_times(options.kernels, options.sizes, options.runs, options.least_seconds)
    versions = subprocess.run([str(options.program), "--version"], capture_output=True, text=True, check=True).stdout
    return {"versions": dict(line.split(" ", 1) for line in versions.splitlines()), "processor": processor(),
            "cores": n_cores, "load_average_before": load,
            "blas_threads": threads, "runs": options.runs, "programs": programs, "kernels": kernels}
