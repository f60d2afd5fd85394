#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What both accuracies reach and cost: tools/studies/both_accuracies.py [--program FILE] [--percent P] [CASE...]

One cycle of the paper's cases (a, b, c) with Mesh/Accuracy = Load program/Accuracy = P %, and the true errors beside the
estimated ones of mesh and steps together, as a table in Markdown. The truth has a mesh that is finer than all of the search
and of another kind, and 32 parts a step of unloading, extrapolated from 16 and 32. Seconds are those of the whole process."""
import argparse
import pathlib
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
from one_cycle import FINEST, FINEST_SECTION, QUANTITIES, ROOT, STICK_AREAS, run  # noqa: E402

UNITS = ("mm", "N", "N mm", "mm²", "N mm")


def truth_of(program, case):
    """Quantities without an error of the steps, to first order, and the summary of the last run."""
    mesh = FINEST_SECTION if case == "a" else FINEST
    coarse, fine = (run(program, case, [*mesh, f"Load program/Legs=0 0 -0.1 : 5 ; 0 0 0 : 10 * {parts}"])
                    for parts in (16, 32))
    truth = [2 * b - a for a, b in zip(coarse[0], fine[0])]
    return [*truth[:3], STICK_AREAS.get(case, truth[3]), *truth[4:]], fine[1]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("cases", nargs="*", metavar="CASE", default=["a", "b", "c"])
    parser.add_argument("--program", default=ROOT / "build/orthocone", type=pathlib.Path)
    parser.add_argument("--percent", default="1")
    options = parser.parse_args()
    print("| case | accuracies | contact nodes | parts | seconds | largest slip | total force | dissipated energy | "
          "stick area | area of the loop |")
    print("|---|---|---|---|---|---|---|---|---|---|")
    for case in options.cases:
        truth, summary = truth_of(options.program, case)
        texts = [f"{value:.6g} {unit}" for value, unit in zip(truth, UNITS)]
        print(f"| {case.upper()} | reference | {summary['model']['contact_nodes']} | 5, 320 | | {' | '.join(texts)} |",
              flush=True)
        for mesh, steps in ((f"{options.percent} %", "0"), (f"{options.percent} %", f"{options.percent} %")):
            values, summary, seconds = run(options.program, case, [f"Mesh/Accuracy={mesh}",
                                                                    f"Load program/Accuracy={steps}"])
            errors = [f"{100 * (value / true - 1):+.2f} %" for value, true in zip(values, truth)]
            both = summary["estimated_errors_percent"]
            errors = [f"{error} ({sum(both[name][of] or 0 for of in ('mesh', 'steps')):.2g} %)"
                      for error, name in zip(errors, QUANTITIES)]
            legs = [leg.rpartition(":")[2].split("*") for leg in summary["scene"]["legs"].split(";")]
            parts = ", ".join(str(int(leg[0]) * int(leg[1] if len(leg) > 1 else 1)) for leg in legs)
            print(f"| {case.upper()} | mesh {mesh}, steps {steps} | "
                  f"{summary['model']['contact_nodes']} | {parts} | {seconds:.1f} | {' | '.join(errors)} |", flush=True)


if __name__ == "__main__":
    sys.exit(main())
