# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The one list of known answers: tools/verification prints them, ctest -R run_book checks them, the tables of
docs/verification.md are made of them.

Rows to come with loads on surfaces and supports: the fretting rig with bulk stress (Nowell and Hills), the block of Raous on
a rigid floor (code_aster SSNV128), a punch with fillets under pressure (NAFEMS R0094, CGS-2)."""
import inside
import sheared
import spheres
import strips
import whole

# Name of each table of the page, and its rows.
CHAPTERS = {"pressed": (*spheres.ROWS, *inside.ROWS), "sheared": (*sheared.MINDLIN, *sheared.EXAMPLE, *sheared.ORTHOTROPIC),
            "twisted": sheared.TORSION, "spence": sheared.SELF, "strips": strips.ROWS, "uniform": whole.UNIFORM,
            "sliding": whole.MOVING, "squeezed": whole.SQUEEZED, "worn": whole.WEARING}
ROWS = tuple(row for rows in CHAPTERS.values() for row in rows)
