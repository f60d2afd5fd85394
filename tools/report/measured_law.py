# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Laws of friction that are tables (Friction/Law = rosette, superellipse): the tables of a run, and the limit of friction that
is the same everywhere."""
import pathlib

import checked
import numpy as np
import rosette_file
from rosette_law import RosetteError, RosetteLaw, mean_table
from run_folder import BadFile
from superellipse import superellipse_table

N_LIMITS = 720
MOST_TABLES = 4
GONE = "The friction law is not drawn: its table is not where the run has found it."
VARIES = "The friction law is not drawn: its semi-axes vary over the surface."


class MeasuredLaw:
    """`tables` of a run, as (words, Table), the first few of those that vary over the surface. Those that cannot be known leave a
    note."""

    def __init__(self, data):
        self.entries, self.notes = data.parameters.get("Friction", {}), data.notes
        self.varies = False  # of which table holds, not of its axes
        self.tables = {"rosette": self.of_file, "superellipse": lambda: self.of_formula(data)}.get(data.law, list)()
        is_one = len(self.tables) == 1 and not data.friction_varies and not data.has_factor
        self.limits = self.limits_of(self.tables[0][1], data.angle) if is_one else None

    def of_file(self):
        path = pathlib.Path(self.entries.get("Rosette", ""))
        try:
            tables = rosette_file.read(path)
            return self.chosen(tables, path.name)
        except (OSError, BadFile, RosetteError):
            self.notes.append(GONE)
            return []

    def chosen(self, tables, name):
        """The one that holds everywhere, or the first few of several."""
        try:
            weight = float(self.entries.get("Rosette weight", 0))
        except ValueError:
            self.varies = True
            self.notes.append(f"Friction: Rosette weight = {self.entries['Rosette weight']} says which of its tables holds at a place.")
            return [(f"table {k} of {len(tables)} in {name}", table) for k, table in enumerate(tables[:MOST_TABLES])]
        before, part = int(weight), round(weight - int(weight), 2)
        if not 0 <= weight <= len(tables) - 1:
            raise RosetteError(f"has no table {weight:g}")
        if part:
            return [(f"mean of two tables of {name}", mean_table(tables[before], tables[before + 1], part))]
        return [(f"{len(tables[before])} rows of {name}", tables[before])]

    def of_formula(self, data):
        try:
            mu = self.pair("Coefficients")
            words = self.entries.get("Slip potential", "associated")
            p = {"associated": mu, "collinear": (1., 1.)}.get(words) or self.pair("Slip potential")
        except ValueError:
            self.notes.append(VARIES)
            return []
        if not min(mu) > 0:  # frictionless
            return []
        exponent, of_slip = (checked.number(self.entries.get(name, usual), name=name)
                             for name, usual in (("Exponent", 4), ("Slip exponent", 0)))
        of_slip = 2 if words == "collinear" else of_slip or exponent
        return [(f"superellipse, exponents {exponent:g}, {of_slip:g}", superellipse_table(mu, p, exponent, of_slip))]

    def pair(self, entry):
        """Two numbers; ValueError of expressions."""
        first, second = (checked.number(text, name=entry) for text in self.entries[entry].split(","))
        return first, second

    @staticmethod
    def limits_of(table, angle):
        """R(b), the largest force per unit normal force in directions all around."""
        directions = np.linspace(0, 2 * np.pi, N_LIMITS, endpoint=False) - np.radians(angle)
        try:
            return RosetteLaw(table, anyway=True).limit(directions)
        except RosetteError:
            return None
