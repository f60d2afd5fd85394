# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""One cycle of a case of the paper, and what users look at in it."""
import subprocess
import tempfile
import time

import numpy as np

from points import ROOT
from run_folder import RunFolder

# No levels of the ladder: what all of these have in common counts as an error. Cells of the section's base are 0.7 mm wide
# at the most, and thinner at its rim than those of all levels.
FINEST = ["Mesh/Core cells=14", "Mesh/Rings=8", "Mesh/Layers=14", "Mesh/Degree=3", "Mesh/Core ratio=0.8",
          "Mesh/Rim grading=0.6", "Mesh/Layer grading=0.5"]
FINEST_SECTION = ["Mesh/Core cells=110", "Mesh/Rings=44", "Mesh/Layers=60", "Mesh/Degree=4", "Mesh/Core ratio=0.75",
                  "Mesh/Rim grading=0.85", "Mesh/Layer grading=0.75"]
# Stick areas at the peak (mm2), which graded meshes miss by a per cent: of even cells of degree 3 with four and more rounds of
# refinement (tools/study adaptive), which agree to 0.02 %.
STICK_AREAS = {"b": 51.56, "c": 36.22}
QUANTITIES = ("largest_slip_mm", "peak_force_N", "dissipation_Nmm", "stick_area_mm2", "loop_area_Nmm")


def run(program, case, settings):
    """The quantities, in the order of QUANTITIES, the summary, and the seconds of the process."""
    with tempfile.TemporaryDirectory() as folder:
        words = [f"--set={setting}" for setting in
                 ("Load program/Cycles=1", "Output/Volume fields=0", "Output/Contact fields=0", *settings)]
        start = time.monotonic()
        subprocess.run([program, ROOT / f"prm/paper/case_{case}.prm", "--quiet", "--output", folder, *words], check=True,
                       stdout=subprocess.DEVNULL)
        seconds = time.monotonic() - start
        done = RunFolder(folder)
        history, cycles, summary = done.history, done.cycles, done.summary
    peak = np.argmin(history["uz"])
    force = np.linalg.norm([history[f"force_{axis}"][peak] for axis in "xyz"])
    values = (history["max_slip"].max(), force, history["total_dissipation"][-1], history["stick_area"][peak],
              cycles["work"][0])
    return [float(value) for value in values], summary, seconds
