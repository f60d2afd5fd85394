# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Whether Siconos finds the forces of our files, where slip is associated and forces are unique."""
import math
import statistics

import race

SAME = 1e-8  # relative difference, in the 2-norm
SOLVERS = ("nsn-ac", "nsn-ac-new")  # the ones that go on to rounding


def is_compared(row):
    """Whether there are forces to compare with: a singular W allows many, as those of FCLIB's files may be, and files of steps
    that we do not solve have none."""
    return row["verdict"] == "solved" and row["family"] not in ("rigid", "fclib") and math.isfinite(float(row["difference"]))


def median_difference(rows):
    """Median over the rows that are compared; None if there are none."""
    found = [float(row["difference"]) for row in rows if is_compared(row)]
    return statistics.median(found) if found else None


def differences(rows):
    """{problem: difference of Siconos' nearest answer} of the associated problems."""
    found = {}
    for row in rows:
        if is_compared(row) and row["law"] != "non-associated" and row["solver"] in race.PEERS:
            found[row["problem"]] = min(float(row["difference"]), found.get(row["problem"], math.inf))
    return found


def nearly(rows):
    """Problems whose forces no answer of Siconos has, as it stops at the bound of the error."""
    return {problem for problem, difference in differences(rows).items() if difference > SAME}


def agreement(rows):
    """A sentence for the page; nothing without Siconos."""
    found = differences(rows)
    if not found:
        return ""
    worst = max(found, key=found.get)
    n_same = sum(difference <= SAME for difference in found.values())
    return (f"On {n_same} of {len(found)} associated problems Siconos finds the forces of the file to {SAME:g}. The nearest answer\n"
            f"is farthest off on `{worst}`, by {found[worst]:.1e}.\n")
