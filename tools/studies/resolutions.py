#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What each Mesh/Resolution and Mesh/Accuracy reaches and costs: tools/studies/resolutions.py [--program FILE] [CASE...]

One cycle of the paper's cases (a, b, c) on each mesh, and the differences of the four quantities to those on a mesh that
is finer than all of them and of another kind (stick areas of solids: to those of adaptive meshes), as a table in Markdown. Seconds are those of the whole process, without field files."""
import argparse
import pathlib
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
from one_cycle import FINEST, FINEST_SECTION, QUANTITIES, ROOT, STICK_AREAS, run  # noqa: E402

N_DRAWN = 4  # all but the area of the loop, which is next to the dissipated energy
CHOICES = ["Resolution=paper", "Resolution=coarse", "Resolution=medium", "Resolution=fine",
           "Accuracy=1 %"]


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
        kind = run(options.program, case, ["Mesh/Resolution=coarse"])[1]["model"]["kind"]
        truth, summary, seconds = run(options.program, case, FINEST_SECTION if kind == "axisymmetric" else FINEST)
        truth = (*truth[:3], STICK_AREAS.get(case, truth[3]), *truth[4:])
        print(f"| {case.upper()} | reference | {summary['model']['contact_nodes']} | {seconds:.2f} | "
              f"{truth[0]:.6f} mm | {truth[1]:.1f} N | {truth[2]:.3f} N mm | {truth[3]:.2f} mm² |", flush=True)
        for choice in choices:
            values, summary, seconds = run(options.program, case, [f"Mesh/{choice}"])
            errors = [f"{100 * (value / true - 1):+.2f} %" for value, true in zip(values, truth)][:N_DRAWN]
            if accuracy := summary.get("accuracy"):
                errors = [f"{error} ({accuracy[name]['estimated_error_percent']:.2g} %)"
                          for error, name in zip(errors, QUANTITIES)]
            print(f"| {case.upper()} | {choice.replace('=', ' = ')} | {summary['model']['contact_nodes']} | {seconds:.2f} | "
                  f"{' | '.join(errors)} |", flush=True)


if __name__ == "__main__":
    sys.exit(main())
