#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What each Mesh/Resolution and Mesh/Accuracy reaches and costs: tools/studies/resolutions.py [--program FILE] [CASE...]

One cycle of the paper's cases (a, b, c) on each mesh, and the differences of the four quantities to those on a mesh that
is finer than all of them and of another kind, as a table in Markdown. Seconds are those of the whole process, without field files."""
import argparse
import csv
import json
import pathlib
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
QUANTITIES = ("largest_slip_mm", "peak_force_N", "dissipation_Nmm", "stick_area_mm2")
# No levels of the ladder: what all of these have in common counts as an error. Cells of the section's base are 0.7 mm wide
# at the most, and thinner at its rim than those of all levels.
FINEST = ["Mesh/Core cells=14", "Mesh/Rings=8", "Mesh/Layers=14", "Mesh/Degree=3", "Mesh/Core ratio=0.8",
          "Mesh/Rim grading=0.6", "Mesh/Layer grading=0.5"]
FINEST_SECTION = ["Mesh/Core cells=110", "Mesh/Rings=44", "Mesh/Layers=60", "Mesh/Degree=4", "Mesh/Core ratio=0.75",
                  "Mesh/Rim grading=0.85", "Mesh/Layer grading=0.75"]
CHOICES = ["Resolution=paper", "Resolution=coarse", "Resolution=medium", "Resolution=fine",
           "Accuracy=1 %"]


def run(program, case, settings):
    """Quantities, estimated errors (or None), contact nodes and seconds of the process."""
    with tempfile.TemporaryDirectory() as folder:
        words = [f"--set={setting}" for setting in
                 ("Load program/Cycles=1", "Output/Volume fields=0", "Output/Contact fields=0", *settings)]
        start = time.monotonic()
        subprocess.run([program, ROOT / f"prm/paper/case_{case}.prm", "--quiet", "--output", folder, *words], check=True,
                       stdout=subprocess.DEVNULL)
        seconds = time.monotonic() - start
        folder = pathlib.Path(folder)
        summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
        with open(folder / "history.csv", encoding="ascii") as file:
            rows = [{name: float(row[name]) for name in ("uz", "max_slip", "force_x", "force_y", "force_z", "stick_area",
                                                         "total_dissipation")} for row in csv.DictReader(file)]
    peak = min(rows, key=lambda row: row["uz"])
    force = sum(peak[f"force_{axis}"]**2 for axis in "xyz")**0.5
    values = (max(row["max_slip"] for row in rows), force, rows[-1]["total_dissipation"], peak["stick_area"])
    accuracy = summary.get("accuracy")
    estimates = [accuracy[name]["estimated_error_percent"] for name in QUANTITIES] if accuracy else None
    return values, estimates, summary["model"], seconds


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("cases", nargs="*", metavar="CASE", default=["a", "b", "c"])
    parser.add_argument("--program", default=ROOT / "build/orthocone", type=pathlib.Path)
    parser.add_argument("--accuracy", action="append", default=[], help="one more, such as '0.1 %%'")
    options = parser.parse_args()
    choices = CHOICES + [f"Accuracy={accuracy}" for accuracy in options.accuracy]
    print("| case | Mesh/... | contact nodes | seconds | largest slip | total force | dissipated energy | stick area |")
    print("|---|---|---|---|---|---|---|---|")
    for case in options.cases:
        kind = run(options.program, case, ["Mesh/Resolution=coarse"])[2]["kind"]
        truth, _, model, seconds = run(options.program, case, FINEST_SECTION if kind == "axisymmetric" else FINEST)
        print(f"| {case.upper()} | reference | {model['contact_nodes']} | {seconds:.2f} | "
              f"{truth[0]:.6f} mm | {truth[1]:.1f} N | {truth[2]:.3f} N mm | {truth[3]:.2f} mm² |", flush=True)
        for choice in choices:
            values, estimates, model, seconds = run(options.program, case, [f"Mesh/{choice}"])
            errors = [f"{100 * (value / true - 1):+.2f} %" for value, true in zip(values, truth)]
            if estimates:
                errors = [f"{error} ({estimate:.2g} %)" for error, estimate in zip(errors, estimates)]
            print(f"| {case.upper()} | {choice.replace('=', ' = ')} | {model['contact_nodes']} | {seconds:.2f} | "
                  f"{' | '.join(errors)} |", flush=True)


if __name__ == "__main__":
    sys.exit(main())
