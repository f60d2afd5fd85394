# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The tables of docs/paper.md, in Markdown."""
import run_folder
from disc_map import Surface
from paper_printed import CASES, CYCLE, P_FORCE_X, P_FORCE_Y, P_SLIP, PEAK, PRINTED
from paper_questions import QUESTIONS, refinement_slips
from paper_runs import MESHES, place, slip_length


COLUMNS = ("bricks", "fitted", "q2", "refined")


def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n"


def comparison(runs):
    """Printed numbers beside ours on the paper's mesh and on finer ones, after the first peak."""
    rows = []
    for case in CASES:
        columns = [printed_values(PRINTED[case]), *(peak_values(runs.case(case, mesh)) for mesh in COLUMNS)]
        rows += [[case.upper(), quantity, *(column[quantity] for column in columns)] for quantity in columns[0]]
    rows += probe_rows(runs, "P") + probe_rows(runs, "R")
    return table(["case", "quantity", "printed", *(MESHES[mesh].title for mesh in COLUMNS)], rows)


def printed_values(printed):
    return values(printed.largest_slip, (printed.smallest_force, printed.largest_force), "–")


def peak_values(run):
    surface = Surface(run, PEAK)
    force, (a, b) = surface.nodal_force, surface.extent(run_folder.STICK)
    return values(run.history["max_slip"][PEAK - 1], (force.min(), force.max()), f"{a:.2f} × {b:.2f}")


def values(slip, forces, stick_zone):
    return {"largest slip (mm)": f"{slip:.5f}", "smallest nodal force (N)": f"{forces[0]:.0f}",
            "largest nodal force (N)": f"{forces[1]:.0f}", "stick zone, half-axes (mm)": stick_zone}


def probe_rows(runs, name):
    """One cycle of case B at a probe."""
    cycles = [(runs.case("b", mesh), runs.case("b", mesh).probe(name)) for mesh in COLUMNS]
    slips = [slip_length(probe)[PEAK - 1] for _, probe in cycles]
    rows = [[f"contact node {name}", "–", *(place(run, name) for run, _ in cycles)],
            [f"slip at {name}, peak (mm)", f"≈ {P_SLIP}", *(f"{slip:.5f}" for slip in slips)]]
    for column, printed in (("force_x", P_FORCE_X), ("force_y", P_FORCE_Y)):
        ranges = [(probe[column][:CYCLE].min(), probe[column][:CYCLE].max()) for _, probe in cycles]
        rows.append([f"r_{column[-1]} at {name} (N)", "≈ {} to {}".format(*printed),
                     *("{:.0f} to {:.0f}".format(*ends) for ends in ranges)])
    return [["B", *row] for row in rows]


def settled(runs):
    rows = [row for question in QUESTIONS for row in question(runs)]
    return table(["question", "run", "measured"], rows)


def refinement(runs):
    rows = [[title, *(f"{slip:.5f}" for slip in slips)] for title, slips in refinement_slips(runs).items()]
    return table(["mesh", "A: largest slip (mm)", "B", "C"], rows)


TABLES = {"comparison": comparison, "settled": settled, "refinement": refinement}
