# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Grids as text: rows of heights, and the program's own gap files (Obstacle/Gap file), which are written here, too."""
import re

import numpy as np
from file_format import Format
from run_folder import one_line
from surface import MOST_POINTS, Surface, WrongSurface, check_size

MISSING = {"", "nan", "na", "---", "***", "bad"}
MOST_LETTERS = 2_000_000  # of a line
MOST_BYTES = 100_000_000  # of a gap file that the program reads


def separated(line):
    """The words of a line between tabs, semicolons or commas, where nothing is a missing point, or else between blanks. Beside
    tabs and semicolons a comma is a decimal comma, as in tables of spreadsheets."""
    if ";" in line or "\t" in line:
        return re.split("[;\t]", re.sub(r"\s*[;\t]\s*$", "", line).replace(",", "."))
    return line.rstrip(", ").split(",") if "," in line else line.split()


def rows_of(text):
    """[(line, numbers (n,))] of all lines that have more than a comment."""
    rows, count = [], 0
    for i, line in enumerate(text.splitlines(), 1):
        line = line.partition("#")[0].strip(" \r")
        if not line.strip():
            continue
        if len(line) > MOST_LETTERS or count > MOST_POINTS:
            raise WrongSurface(f"line {i}: is too much; allowed are {MOST_POINTS} points, and {MOST_LETTERS} letters in a line")
        words = [word.strip().lower() for word in separated(line)]
        try:
            rows.append((i, np.array([float("nan" if word in MISSING else word) for word in words])))
        except ValueError as error:
            raise WrongSurface(f"line {i}: '{one_line(line, 40)}': allowed are numbers, nan for missing points, and words behind #") from error
        count += len(words)
    return rows


def matrix(rows):
    if not rows:
        raise WrongSurface("has no line but comments; allowed are rows of heights")
    n = len(rows[0][1])
    for i, row in rows:
        if len(row) != n:
            raise WrongSurface(f"line {i}: has {len(row)} numbers; allowed are as many as in the first row, {n}")
    check_size(n, len(rows))
    return np.array([row for _, row in rows])


def is_gap_head(rows):
    """Whether the first row is 'x0 dx nx y0 dy ny', and the others are such a grid."""
    if len(rows) < 3 or len(rows[0][1]) != 6:
        return False
    _, dx, nx, _, dy, ny = rows[0][1]
    return dx > 0 and dy > 0 and ny == len(rows) - 1 and all(len(row) == nx for _, row in rows[1:])


def read(content, told):
    """A gap file is a surface of the heights -gap at its place; other rows need told['pixel']."""
    rows = rows_of(content.decode("utf-8", "replace").removeprefix("\ufeff"))
    if is_gap_head(rows):
        if told:
            raise WrongSurface(f"is a gap file, which says by itself what --{next(iter(told))} would; leave the option out")
        x0, dx, _, y0, dy, _ = rows[0][1]
        surface = Surface.centred(-matrix(rows[1:]), dx, dy)
        surface.x0, surface.y0 = x0, y0
        return surface
    heights = matrix(rows)
    if "pixel" not in told:
        raise WrongSurface("has rows of numbers and no spacing; allowed with --pixel D, such as --pixel 0.5um")
    return Surface.centred(heights * told.get("unit", 1.), *told["pixel"])


def gaps_of(surface, datum):
    """(ny, nx), mm: how far the heights lie below the datum, which is 'highest' (the highest point has the gap 0), 'mean', or
    'zero', from which heights are counted. A periodic surface gets its first row and column again at its ends, so that the
    grid has its whole size."""
    level = {"highest": surface.heights.max(), "mean": surface.heights.mean(), "zero": 0.}[datum]
    return level - (np.pad(surface.heights, (0, 1), mode="wrap") if surface.periodic else surface.heights)


def gap_text(surface, datum, name):
    """The text of a gap file, which the program reads. Raises WrongSurface for missing points and for more than it reads."""
    if surface.n_missing:
        raise WrongSurface(f"{name}: has missing points ({surface.n_missing}); allowed are none in a gap file: --fill fills them")
    gaps = gaps_of(surface, datum)
    head = f"# gaps of {one_line(name)}, mm, below its level '{datum}'\n"
    head += f"{surface.x0:.12g} {surface.dx:.12g} {gaps.shape[1]} {surface.y0:.12g} {surface.dy:.12g} {gaps.shape[0]}\n"
    row = " ".join(["%.9g"] * gaps.shape[1]) + "\n"
    text = head + "".join(row % tuple(numbers) for numbers in gaps.tolist())
    if len(text) > MOST_BYTES:
        raise WrongSurface(f"{name}: has {gaps.size} points, a gap file of {len(text)} bytes; allowed are {MOST_BYTES}: --points N thins it out")
    return text


FORMAT = Format("rows of numbers, or a gap file", (".txt", ".csv", ".asc", ".dat"), read, ("pixel", "unit"))
