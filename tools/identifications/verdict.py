# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What a fit tells, as numbers for identified.json, lines of a table, and sentences."""
import numpy as np
from loop_fit import UNITS
from statistics_of_fit import ERROR_OF_MODEL, INVOLVED, neighbours

DEPENDENT = 0.3  # correlation of neighbouring residuals from which on they are no noise
CLOSE = 0.98  # correlation of two parameters from which on they are hardly told apart


def parameters(fit, n_bootstrap):
    """{name: {estimate, interval, unit, identified, ...}} of the loops."""
    known, half = fit.information.identified(), fit.information.intervals()
    drawn = fit.information.bootstrap(fit.sequences(), n_bootstrap) if n_bootstrap else None
    found = {}
    for i, name in enumerate(fit.names):
        value, size = fit.values[name], fit.scale(name)
        one = {"estimate": value if known[i] else None, "interval": None, "unit": UNITS[name], "identified": bool(known[i])}
        if known[i]:
            one["interval"] = [value - half[i] * size, value + half[i] * size]
        if known[i] and n_bootstrap:
            one["bootstrap"] = [value + change * size for change in drawn[:, i]]
        found[name] = one
    return found


def wear_parameter(slope, half):
    return {"estimate": slope, "interval": [slope - half, slope + half], "unit": "mm^3/(N mm)", "identified": True}


def stiffness(compliance):
    """The stiffness of the rig, N/mm, of its compliance; None where it is not known or not above 0."""
    if not compliance["identified"] or compliance["estimate"] <= 0:
        return None
    low, high = compliance["interval"]
    return {"estimate": 1 / compliance["estimate"], "interval": [1 / high, 1 / low if low > 0 else None], "unit": "N/mm"}


def table(found):
    """Lines: parameter, estimate, interval, unit."""
    rows = [("parameter", "estimate", "95 % interval", "unit")]
    shown = {**found}
    if "rig_compliance" in found and (rig := stiffness(found["rig_compliance"])):
        shown["rig_stiffness"] = {**rig, "identified": True}
    for name, one in shown.items():
        if not one["identified"]:
            rows.append((name, "not told", "", ""))
            continue
        low, high = one["interval"]
        rows.append((name, f"{one['estimate']:.5g}", f"{low:.5g} to " + ("infinity" if high is None else f"{high:.5g}"), one["unit"]))
        if "bootstrap" in one:
            rows.append(("  by bootstrap", "", "{:.5g} to {:.5g}".format(*one["bootstrap"]), one["unit"]))
    widths = [max(len(row[i]) for row in rows) for i in range(4)]
    return ["  ".join(f"{word:{width}}" for word, width in zip(row, widths)).rstrip() for row in rows]


def loop_facts(fit):
    """One dictionary for each loop: what it is, and how far the model is from it."""
    residual, found, start = fit.information.residual, [], 0
    for loop, curves in zip(fit.loops, fit.curves):
        own = residual[start:start + loop.force.size]
        start += loop.force.size
        found.append({"name": loop.name, "direction_degrees": float(np.degrees(np.arctan2(loop.direction[1], loop.direction[0]))),
                      "amplitude_mm": loop.amplitude, "force_amplitude_N": float(loop.scale), "rows": len(loop.way),
                      "rms_N": float(np.sqrt(np.mean(own**2)) * loop.scale), "slides": curves.slides(), "gap_N": curves.gap(loop, fit.values["rig_compliance"])})
    return found


def untold_directions(fit):
    """[({parameter: component}, rms change of force for a change by half)] of directions that are not told."""
    found = []
    for direction in fit.information.untold():
        direction = direction * np.sign(direction[np.argmax(np.abs(direction))])
        change = np.sqrt(np.mean((fit.information.jacobian @ direction)**2)) / 2
        found.append(({name: float(part) for name, part in zip(fit.names, direction) if abs(part) > INVOLVED}, float(change)))
    return found


def reason(direction, fit, facts):
    """Why the loops do not tell a direction of parameters, as far as physics says it."""
    names = set(direction)
    if names == {"rig_compliance", "young_modulus"}:
        return "a soft rig and a soft body lean the sides of a loop alike"
    if names == {"slip_ratio"}:
        return "along an axis of friction slip follows the force whatever the slip rule; a loop at an angle that slides would tell"
    for axis, name in enumerate(("mu_x", "mu_y")):
        own = [fact["slides"] for fact, along in zip(facts, fit.along_axes) if abs(along[axis]) > INVOLVED]
        if names == {name} and not own:
            return f"no loop moves along {'xy'[axis]} of the axes of friction"
        if names == {name} and not any(own):
            return f"no loop with a motion along {'xy'[axis]} slides as a whole"
    if names & {"mu", "mu_x", "mu_y"} and not any(fact["slides"] for fact in facts):
        largest = max(np.abs(loop.along()).max() for loop in fit.loops) / fit.normal_force
        return f"no loop slides as a whole: the force stays below {largest:.3g} of the normal force, so that friction may be anything above"
    return ""


def untold_sentences(fit, facts):
    lines = []
    for direction, change in untold_directions(fit):
        names = list(direction)
        why = reason(direction, fit, facts)
        parts = ", ".join(f"{name} {part:+.2f}" for name, part in direction.items())
        what = names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]} apart"
        where = "" if len(names) == 1 else f" in the direction ({parts})"
        lines.append(f"The loops do not tell {what}: a change by half of the size{where} changes the forces by "
                     f"{100 * change:.2g} % of their amplitude, and the noise is {100 * fit.information.noise:.2g} %"
                     + (f"; {why}." if why else "."))
    return lines


def sentences(fit, facts):
    """What a reader of the table has to know."""
    lines = untold_sentences(fit, facts)
    correlation, known = fit.information.correlation(), fit.information.identified()
    for i, first in enumerate(fit.names):
        for j, second in enumerate(fit.names[:i]):
            if known[i] and known[j] and abs(correlation[i, j]) > CLOSE:
                lines.append(f"{second} and {first} are hardly told apart: their estimates have a correlation of {correlation[i, j]:.3f}.")
    partial = [fact["name"] for fact in facts if not fact["slides"]]
    if len(partial) == len(facts) and any(known[i] and name.startswith("mu") for i, name in enumerate(fit.names)):
        lines.append("No loop slides as a whole, so that friction comes from partial slip alone, which tells it weakly.")
    elif 0 < len(partial) < len(facts):
        lines.append(f"Slip is partial in {', '.join(partial)}; the other loops slide as a whole.")
    lines += [f"The loop of the model for {fact['name']} is open by {fact['gap_N']:.3g} N after a cycle: it is not settled yet."
              for fact in facts if fact["gap_N"] > max(fit.information.noise, ERROR_OF_MODEL) * fact["force_amplitude_N"]]
    if "rig_compliance" in fit.names and "young_modulus" not in fit.names:
        lines.append("The compliance of the rig is what the elastic constants of the scene leave over: an error of theirs is part of it.")
    between = neighbours(fit.information.residual, fit.sequences())
    if between > DEPENDENT:
        lines.append(f"Neighbouring residuals have a correlation of {between:.2f}, so that they are more than noise: the model lacks "
                     "something, and the intervals are too narrow; --bootstrap takes part of this into account.")
    return lines
