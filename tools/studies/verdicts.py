# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What came of a run, for the maps: how it ended, and whether methods that came to an end agree."""
import math

from points import StudyError
from run_folder import RunFolder

SOLVED, UNSOLVED = 0, 3  # exit codes
# Sums over the steps of the history; two solutions are the same if all of these agree.
SIGNATURE = ("force_z", "max_slip", "max_pressure", "dissipation", "elastic_energy")
SAME = 1e-6  # relative, on top of what the tolerance leaves


def tables(folder):
    """Summary and history of a run; {} where it ended before it wrote them."""
    try:
        run = RunFolder(folder)
        return run.summary, run.history if run.has_history else {}
    except FileNotFoundError:
        return {}, {}


def outcome(result, _point):
    """Figures of a row: verdict, iterations of the hardest step, residual, steps solved, signature."""
    if result.code not in (SOLVED, UNSOLVED):
        raise StudyError(f"ended with code {result.code}: {result.errors.strip()}")
    summary, history = tables(result.folder)
    if "contact_solver" not in summary:  # the body alone was too much
        return {"verdict": "no-model", "iterations": 0, "residual": math.nan, "steps": 0, "signature": "",
                "seconds": round(result.seconds, 3), "message": result.errors.partition("\n")[0][:200]}
    verdict = summary["contact_solver"]["verdict"]
    if result.code == UNSOLVED and verdict == "converged":
        # Solved, but an independent check stopped the run; or the body alone was too much.
        verdict = "no-model" if "is not solved: " in summary["status"] else "check"
    sums = [math.fsum(history.get(name, ())) for name in SIGNATURE]
    return {"verdict": verdict, "iterations": int(max(history.get("iterations", ()), default=0)),
            "residual": summary["contact_solver"]["largest_residual"], "steps": len(history.get("step", ())),
            "signature": " ".join(f"{value:.12g}" for value in sums), "seconds": round(result.seconds, 3),
            "message": " ".join(result.errors.split())[:300]}


def agree(one, other, tolerance):
    """Whether two signatures are the same solution."""
    pairs = dict(zip(SIGNATURE, zip(map(float, one.split()), map(float, other.split()))))
    bound = SAME + 1e3 * tolerance
    size = {name: max(abs(a), abs(b)) for name, (a, b) in pairs.items()}
    # Where all nodes stick, slip and dissipation are rounding: they are compared with what they could be.
    size["dissipation"] = max(size["dissipation"], size["elastic_energy"])
    size["max_slip"] = max(size["max_slip"], size["elastic_energy"] / max(size["force_z"], 1e-300))
    return all(abs(a - b) <= bound * size[name] for name, (a, b) in pairs.items())


def with_agreement(rows, most_iterations):
    """Marks the converged rows of a point that had to divide a step, which is another path (`divided`), and of the rest
    those that differ from what most methods found (`other`). `most_iterations(method)` of an undivided step."""
    for row in rows:
        if row["verdict"] == "converged" and int(row["iterations"]) > most_iterations(row["method"]):
            row["verdict"] = "divided"
    converged = [row for row in rows if row["verdict"] == "converged"]
    for row in converged:
        tolerance = float(row["tolerance"])
        row["n_agree"] = sum(agree(row["signature"], other["signature"], tolerance) for other in converged)
    most = max((row["n_agree"] for row in converged), default=0)
    is_split = 2 * most <= len(converged) and len(converged) > 1  # nobody knows which solution is the common one
    for row in converged:
        if is_split or row["n_agree"] < most:
            row["verdict"] = "other"
    return rows
