# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Compares the histories of two runs of one scene: same_results.py RUN_FOLDER RUN_FOLDER

Other versions of a library round otherwise, so that numbers may differ by a millionth of the largest one of their column."""
import csv
import pathlib
import sys

import numpy as np

MOST = 1e-6
NOT_COMPARED = ("seconds", "iterations", "residual", "imbalance")  # times, and what rounding alone leaves


def columns(folder):
    with open(pathlib.Path(folder, "history.csv"), encoding="ascii") as file:
        rows = list(csv.DictReader(file))
    return {name: [row[name] for row in rows] for name in rows[0]}


def difference(first, second):
    """Of two columns, relative to the largest number; of words, 1 if they differ."""
    try:
        a, b = np.array(first, float), np.array(second, float)
    except ValueError:
        return float(first != second)
    if a.shape != b.shape or (np.isnan(a) != np.isnan(b)).any():
        return np.inf
    return np.nan_to_num(abs(a - b)).max() / (np.nan_to_num(abs(b)).max() or 1)


def main():
    first, second = columns(sys.argv[1]), columns(sys.argv[2])
    if list(first) != list(second):
        sys.exit(f"{sys.argv[1]}: other columns than {sys.argv[2]}")
    found = {name: difference(first[name], second[name]) for name in first if not any(word in name for word in NOT_COMPARED)}
    worst = max(found, key=found.get)
    print(f"{pathlib.Path(sys.argv[1]).name}: {len(found)} columns, largest difference {found[worst]:.1e} of {worst}")
    sys.exit(int(found[worst] > MOST))


if __name__ == "__main__":
    main()
