# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Writes the worn depth of a run as a gap file, from which another run starts (Obstacle/Gap file)."""
import argparse
import pathlib
import sys

import numpy as np
from matplotlib.tri import LinearTriInterpolator, Triangulation
from run_folder import BadFile, RunFolder, one_line


def arguments():
    parser = argparse.ArgumentParser(
        prog="tools/wear_profile", description=__doc__,
        epilog="The grid has --points numbers along each axis and holds the whole contact surface. Beside the surface "
               "stands the depth of the nearest node.")
    parser.add_argument("run", type=pathlib.Path, help="run folder with contact files")
    parser.add_argument("output", type=pathlib.Path, help="gap file to write")
    parser.add_argument("--step", type=int, help="load step (the last one with a contact file)")
    parser.add_argument("--points", type=int, help="along each axis (as near as worn nodes are, 101 to about 1001)")
    return parser.parse_args()


def equal_parts(places):
    """Into how many equal parts the places of nodes along an axis divide it; 1 where they are unevenly spaced."""
    places = np.unique(np.round(places, 6))  # the files hold single precision
    parts = len(places) - 1
    even = np.linspace(places[0], places[-1], len(places))
    return parts if np.abs(places - even).max() < 1e-5 * np.ptp(places) else 1


def enough_points(contact):
    """Grid lines that are as near to each other as the worn nodes. Evenly spaced nodes lie on such lines."""
    worn = np.unique(np.round(contact.points[contact["wear_depth"] > 0, :2], 9), axis=0)
    if len(worn) < 2:
        return 2
    nearest = min(np.sort(np.hypot(*(worn - node).T))[1] for node in worn)
    n = int(np.clip(np.ptp(contact.points[:, :2], axis=0).max() / nearest, 100, 1000))
    parts = int(np.lcm(*(equal_parts(places) for places in contact.points[:, :2].T)))
    return (-(-n // parts) * parts if parts <= 500 else n) + 1


def profile(contact, n):
    """Places along both axes (mm), and depths (mm), a row for each y."""
    x, y = contact.points[:, :2].T.astype(float)  # the files hold single precision
    depth = contact["wear_depth"]
    grid = [np.linspace(values.min(), values.max(), n) for values in (x, y)]
    places = np.meshgrid(*grid)
    found = LinearTriInterpolator(Triangulation(x, y, contact.triangles()), depth)(*places)
    for i, j in zip(*np.nonzero(np.ma.getmaskarray(found))):
        found[i, j] = depth[np.argmin(np.hypot(x - places[0][i, j], y - places[1][i, j]))]
    return *grid, np.asarray(found)


def main():
    given = arguments()
    run = RunFolder(given.run)
    steps = run.contact_steps()
    if not steps or (given.step is not None and given.step not in steps):
        sys.exit(f"wear_profile: {given.run} has no contact file{'' if given.step is None else f' of step {given.step}'}")
    if given.points is not None and given.points < 2:
        sys.exit(f"wear_profile: --points {given.points}: allowed is a whole number from 2 on")
    contact = run.contact(steps[-1] if given.step is None else given.step)
    x, y, depth = profile(contact, given.points or enough_points(contact))
    # A grid that ends a rounding error before the surface does not hold it.
    head = [number for values in (x, y) for number in (values[0] * (1 + 1e-12), (values[1] - values[0]) * (1 + 1e-12),
                                                       len(values))]
    with open(given.output, "w", encoding="ascii") as file:
        print(f"# worn depth of {given.run.name}, mm", file=file)
        print(*head, file=file)
        np.savetxt(file, depth, fmt="%.9e")


if __name__ == "__main__":
    try:
        main()
    except (OSError, BadFile, KeyError) as problem:
        words = f"no field {problem} in the contact file" if isinstance(problem, KeyError) else problem
        print(f"wear_profile: {one_line(words)}", file=sys.stderr)
        sys.exit(4)
