# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Error against time of meshes: degree, uniform or graded, axisymmetric or solid, cases A, B and C.

One proportional step to the peak, then three steps up to a fifth of it. Errors are relative to a run that is finer than
all others; its own error is estimated by its difference to the next coarser run of its family."""
import json

import numpy as np
import style
from contact_surface import RevolvedSurface, SolidSurface, quarter_rule, relative_l2
from points import StudyError, program_point, ran
from run_folder import RunFolder

PAGE = "accuracy.md"
PROGRAM = {"Load program/Legs": "0 0 -0.1 : 1; 0 0 -0.02 : 3", "Load program/Cycles": 1, "Output/Volume fields": 0,
           "Output/Contact fields": 1}
PEAK, LAST = 1, 4  # steps; in the last one most of the base slips back
QUANTITIES = {"largest_slip": "largest slip at the peak", "force": "total force at the peak",
              "dissipation": "dissipated energy", "stick_area": "stick area at the peak"}
FIELDS = {"slip_peak": "slip at the peak", "pressure_peak": "pressure at the peak",
          "slip_last": "slip, almost unloaded", "pressure_last": "pressure, almost unloaded"}
STEPS_OF_FIELDS = {"slip_peak": PEAK, "pressure_peak": PEAK, "slip_last": LAST, "pressure_last": LAST}
POINTS, WEIGHTS = quarter_rule()

# Cells along a side of the core block, rings, layers; of uniform meshes all three are n.
UNIFORM = {"axisymmetric": {1: (8, 16, 32, 64), 2: (4, 8, 16, 32), 3: (4, 8, 16), 4: (2, 4, 8, 16)},
           "quarter": {1: (4, 8, 12, 16, 24), 2: (2, 4, 8, 12), 3: (2, 4, 6, 8)}}
# Core cells, rings, factor from ring to ring. The rings of all degrees have about as many nodes and end as thin.
GRADED = {"axisymmetric": {1: ((8, 8, 0.74), (16, 12, 0.74), (32, 16, 0.74), (64, 20, 0.74)),
                           2: ((6, 4, 0.5), (10, 6, 0.5), (18, 8, 0.5), (32, 10, 0.5)),
                           3: ((4, 3, 0.4), (8, 5, 0.4), (16, 7, 0.4), (28, 9, 0.4)),
                           4: ((4, 3, 0.4), (6, 4, 0.4), (10, 5, 0.4), (20, 7, 0.4), (40, 9, 0.4))},
          "quarter": {1: ((4, 4, 0.6), (8, 6, 0.6), (12, 8, 0.6), (16, 10, 0.7)),
                      2: ((4, 3, 0.5), (6, 4, 0.5), (8, 5, 0.5), (12, 7, 0.5)),
                      3: ((2, 2, 0.4), (4, 3, 0.4), (6, 4, 0.4), (8, 5, 0.4), (10, 6, 0.4))}}
REFERENCES = {"axisymmetric": ((56, 10, 0.4), (80, 11, 0.4)), "quarter": ((12, 6, 0.4), (14, 7, 0.4))}


def layers(rings, factor):
    """As many layers as the program's own ladder of meshes takes (source/simulation/mesh_ladder.cc): the lowest is as
    thick as the outermost ring, which takes up to two fifths of the radius; the height equals the radius."""
    thinnest = factor**(rings - 1) / sum(factor**i for i in range(rings)) * 0.4
    for grading in np.arange(100, 30, -1) / 100:
        if 0.5 * grading**(rings - 1) / sum(grading**i for i in range(rings)) <= thinnest:
            break
    return 2 * rings, float(grading)
