# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Figures 5 to 12 of the paper from our own runs; with --docs what docs/paper.md shows. Started by tools/study figures."""
import docs_page
import paper_maps
import paper_paths
import paper_tables
from paper_questions import positive_load
from paper_runs import Runs

FIGURES = {
    "fig05": paper_maps.figure_5, "fig06": paper_maps.figure_6, "fig07": paper_maps.figure_7,
    "fig08": paper_maps.figure_8, "fig09": paper_paths.figure_9, "fig10": paper_paths.figure_10,
    "fig11": lambda runs: paper_paths.figure_11(runs, positive_load(runs)), "fig12": paper_paths.figure_12,
    "cases": paper_maps.overview,
}


def main():
    docs_page.main("figures", __doc__, Runs, FIGURES, paper_tables.TABLES)
