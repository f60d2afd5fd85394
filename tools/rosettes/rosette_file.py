# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Text files with measured friction (Friction/Rosette), read as the program reads them, and written."""
import math
import re

import numpy as np
from rosette_law import MOST_ROWS, RosetteError, Table
from run_folder import text_of

MOST_BYTES = 10_000_000
ALLOWED = "allowed is a line 'angle mu_along mu_across' of three numbers (degrees, 1, 1), or 'table', where another one begins"
HEADING = "table"
NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")


def row_of(line):
    """The three numbers of a line; None of another one."""
    words = re.sub(r"[,;\t]", " ", line).split()
    numbers = [float(word) for word in words if NUMBER.fullmatch(word)]
    return numbers if len(numbers) == len(words) == 3 and all(map(math.isfinite, numbers)) else None


def table_of(rows):
    if len(rows) > MOST_ROWS:
        raise RosetteError(f"has {len(rows)} rows: allowed are {MOST_ROWS}, ten for each degree")
    angles, along, across = np.reshape(rows, (-1, 3)).T
    table = Table(np.radians(angles), along, across)
    table.check_rows()
    return table


def read(path):
    """The tables of a file. Raises RosetteError for wrong lines, BadFile and OSError where there is no such text."""
    parts = [(0, [])]  # the line 'table' where one begins, and its rows
    for number, line in enumerate(text_of(path, MOST_BYTES).splitlines(), 1):
        line = line.partition("#")[0].strip()
        if line.startswith(HEADING):
            parts.append((number, []))
        elif line:
            row = row_of(line)
            if row is None:
                raise RosetteError(f"line {number}: '{line[:60]}': {ALLOWED}")
            parts[-1][1].append(row)
    if len(parts) > 1 and not parts[0][1]:
        del parts[0]
    tables = []
    for beginning, rows in parts:
        try:
            tables.append(table_of(rows))
        except RosetteError as problem:
            raise RosetteError(f"line {beginning}: the table that begins here {problem}" if beginning else problem) from None
    return tables


def text_for(tables, *comments):
    """A file with the tables, whose head says where they come from."""
    lines = [*(f"# {comment}" for comment in comments), "# angle  mu_along  mu_across"]
    for table in tables:
        lines += [HEADING] if len(tables) > 1 else []
        lines += [f"{angle:<10.7g} {along:.7g}  {across:.7g}"
                  for angle, along, across in zip(np.degrees(table.angles), table.along, table.across)]
    return "\n".join(lines) + "\n"
