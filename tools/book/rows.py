# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The one list of known answers: tools/verification prints them, ctest -R run_book checks them, the tables of
docs/verification.md are made of them."""
import grids
import inside
import loaded
import sheared
import spheres
import strips
import whole

# Name of each table of the page, and its rows.
CHAPTERS = {"pressed": (*spheres.ROWS, *inside.ROWS), "sheared": (*sheared.MINDLIN, *sheared.EXAMPLE, *sheared.ORTHOTROPIC),
            "twisted": sheared.TORSION, "spence": sheared.SELF, "grids": grids.GRIDS, "strips": strips.ROWS, "uniform": whole.UNIFORM,
            "sliding": whole.MOVING, "squeezed": whole.SQUEEZED, "worn": whole.WEARING,
            "fatigue": loaded.FATIGUE, "loaded": loaded.SURFACES}
ROWS = tuple(row for rows in CHAPTERS.values() for row in rows)
