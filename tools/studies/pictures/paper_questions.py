# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What the paper leaves open or contradicts, and the runs that settle it. Every question has a function that returns
its rows of the table: question, command, measured."""
import numpy as np

from disc_map import Surface
from paper_paths import friction_on_half
from paper_printed import CASES, CYCLE, FORCE_AXIS_END, PEAK, PRINTED
from paper_runs import MESHES, SOLID, command

LIKEWISE = ", B and C likewise"
ONE_STEP = "Load program/Legs=0 0 -0.1 : 1"
POSITIVE_LOAD = "Load program/Legs=0 0 -0.1 : 5 ; 0 0 -0.02 : 10"
PLATE_FORCE = 210000 * 0.1 / 10 * np.pi * 10**2  # E u/H times the area: no friction, no clamping
# Question 6: title and settings; the quarter model has the same answers as the whole cylinder and costs less.
REFINEMENT = [("bricks, 4 layers: the paper's mesh", (*SOLID, "Mesh/Degree=1")),
              ("bricks, twice as fine", (*SOLID, "Mesh/Degree=1", "Mesh/Core cells=16", "Mesh/Layers=8")),
              ("bricks, four times as fine", (*SOLID, "Mesh/Degree=1", "Mesh/Core cells=32", "Mesh/Layers=16")),
              ("quadratic, 4 layers", (*SOLID, "Mesh/Degree=2")),
              ("quadratic, twice as fine", (*SOLID, "Mesh/Degree=2", "Mesh/Core cells=16", "Mesh/Layers=8")),
              ("cubic, graded, 6 layers: refined", MESHES["refined"].settings)]


def positive_load(runs):
    """Case B on the paper's bricks, never unloaded to less than u_z = -0.02 mm."""
    return runs.run("b-positive_load", "case_b_q1", POSITIVE_LOAD)


def peak_slip(run, step=PEAK):
    return run.history["max_slip"][step - 1]


def three(values, form="{:.5f}"):
    return " / ".join(form.format(value) for value in values)


def coefficient_of_case_b(runs):
    slip = peak_slip(runs.run("b-printed_coefficient", "case_b_printed"))
    return [("1. μ_y of case B", command("case_b_printed"),
             f"μ_y = 0.25, as printed: largest slip {slip:.5f} mm, {slip / PRINTED['b'].largest_slip:.2f} of the "
             "printed one"),
            ("", command("case_b_q1"),
             f"μ_y = 0.15: {peak_slip(runs.case('b', 'bricks')):.5f} mm; printed {PRINTED['b'].largest_slip:.5f} mm")]


def upper_face(runs):
    quarter = ("Mesh/Model=quarter", "Geometry/Top face=guided")
    guided = [peak_slip(runs.run(f"{case}-guided", f"case_{case}_q1", *quarter)) for case in CASES]
    clamped = [peak_slip(runs.case(case, "bricks")) for case in CASES]
    printed = [PRINTED[case].largest_slip for case in CASES]
    return [("2. Upper face", command("case_a_q1", *quarter) + LIKEWISE,
             f"free sideways: largest slip {three(guided)} mm (A / B / C)"),
            ("", command("case_a_q1") + LIKEWISE,
             f"clamped: {three(clamped)} mm; printed {three(printed)} mm")]


def one_step_or_five(runs):
    one, five = runs.run("b-one_step", "case_b_q1", ONE_STEP, "Load program/Cycles=1"), runs.case("b", "bricks")
    differences = []
    for field in ("slip", "nodal_force"):
        short, long = Surface(one, 1)[field], Surface(five, PEAK)[field]
        differences.append(np.abs(short - long).max() / np.abs(long).max())
    return [("3. Peak at step 5", command("case_b_q1", ONE_STEP, "Load program/Cycles=1"),
             "one step instead of five: slips differ by {:.1g}, nodal forces by {:.1g} of the largest".format(
                 *differences))]


def force_axis(runs):
    forces = [runs.case(case, "bricks").history["force_z"][PEAK - 1] / 1000 for case in CASES]
    along_x, along_y = ([friction_on_half(runs.case(case, "bricks"), PEAK, axis) / 1000 for case in CASES]
                        for axis in (0, 1))
    return [("4. Force axis of fig. 12", command("case_a_q1") + LIKEWISE,
             f"total force {three(forces, '{:.0f}')} kN, E A u/H = {PLATE_FORCE / 1000:.0f} kN; the axis ends at "
             f"{FORCE_AXIS_END / 1000:.0f} kN. Of that size is the friction on half of the base, "
             f"along x {three(along_x, '{:.1f}')} kN, along y {three(along_y, '{:.1f}')} kN")]


def four_minima(runs):
    rows = [("5. Minima of R_n", "third"), ("", "fitted")]
    return [(title, command("case_a_q1", *MESHES[mesh].settings), smallest_forces(Surface(runs.case("a", mesh), PEAK)))
            for title, mesh in rows]


def smallest_forces(surface):
    force, pressure = surface.nodal_force, surface["pressure"]
    minima = force < 1.01 * force.min()
    corners = surface.corner_nodes()
    inside = surface.radius() < 0.9 * surface.radius().max()
    return (f"smallest nodal force {force.min():.0f} N; within 1 % of it {minima.sum()} nodes, where "
            f"{surface.cells_at_node()[minima].min()} cells meet; at the core's corners, where 3 cells meet (r = "
            f"{surface.radius()[corners].mean():.2f} mm), {force[corners].mean():.0f} N and "
            f"{pressure[corners].mean():.0f} MPa; pressure within 0.9 R {pressure[inside].min():.0f} to "
            f"{pressure[inside].max():.0f} MPa")


def refinement_slips(runs):
    """{title: largest slips of A, B, C} for the meshes of REFINEMENT."""
    slips = {}
    for number, (title, settings) in enumerate(REFINEMENT):
        peaks = [runs.run(f"{case}-refinement-{number}", f"case_{case}", *settings, ONE_STEP, "Load program/Cycles=1")
                 for case in CASES]
        slips[title] = [peak_slip(run, step=1) for run in peaks]
    return slips


def convergence(runs):
    slips = list(refinement_slips(runs).values())
    lower = 100 * (1 - np.array(slips[-1]) / np.array(slips[0]))
    return [("6. Mesh convergence", command("case_a", *REFINEMENT[-1][1], ONE_STEP) + LIKEWISE,
             f"largest slip {three(slips[-1])} mm, {three(lower, '{:.0f}')} % lower than on the paper's mesh (the "
             "table of refinements follows)")]


def largest_cycle_difference(run):
    """Largest difference between the slips at the same steps of the first two cycles, relative to the largest slip."""
    first, second = (np.array([run.contact(step)["slip"] for step in range(start, start + CYCLE)])
                     for start in (1, CYCLE + 1))
    return np.abs(first - second).max() / np.abs(first).max()


def history(runs):
    full, positive = runs.case("b", "bricks"), positive_load(runs)
    rest = max(np.abs(full.contact(step)["nodal_force"]).max() for step in (CYCLE, 2 * CYCLE, 3 * CYCLE))
    peaks = positive.history["max_slip"][PEAK - 1::CYCLE]
    stuck = positive.history["n_stick"][PEAK - 1::CYCLE]
    return [("7. Cycles", command("case_b_q1"),
             f"unloaded to u_z = 0: largest nodal force {rest:.1g} N; slips of the first two cycles differ by "
             f"{largest_cycle_difference(full):.1g}"),
            ("", command("case_b_q1", POSITIVE_LOAD),
             f"unloaded to u_z = -0.02 mm: largest slip at the three peaks {three(peaks)} mm, sticking nodes "
             f"{three(stuck, '{:.0f}')}")]


QUESTIONS = (coefficient_of_case_b, upper_face, one_step_or_five, force_axis, four_minima, convergence, history)
