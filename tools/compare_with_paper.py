#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Figures 5 and 6 of the paper against our own runs: prints the table of the README and draws its picture.

Usage: tools/compare_with_paper.py [PICTURE.png]     after ./run has built the program"""
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

ROOT = pathlib.Path(__file__).resolve().parent.parent
CASES = ("a", "b", "c")
PEAK, UNLOADING = 5, 8  # steps
# Fig. 5: largest slip (mm); fig. 6: smallest and largest nodal force (N).
PRINTED = {"a": (0.0137658, 580.8, 3185.8), "b": (0.0204396, 584.8, 3321.6), "c": (0.0226411, 588.8, 3191.8)}
# The paper prints neither the size of the core block nor the thickness of the rings. These two numbers are fitted to
# the two forces of its case A; the four of cases B and C are then a check.
FITTED_MESH = ["Mesh/Core ratio=0.286", "Mesh/Rim grading=0.9118"]
ONE_CYCLE = ["Load program/Cycles=1", "Output/Volume fields=0"]


class ContactFile:
    """Fields of a contact-NNNN.vtu file at its points."""

    def __init__(self, path):
        reader = vtk.vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(path))
        reader.Update()
        grid = reader.GetOutput()
        self.points = vtk_to_numpy(grid.GetPoints().GetData())
        self.data = grid.GetPointData()
        self.cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(grid.GetNumberOfCells(), -1)

    def __getitem__(self, name):
        return vtk_to_numpy(self.data.GetArray(name))

    def triangles(self):
        """The corners of the cells, cut along a diagonal, or with their mid-side nodes and centre (degree 2)."""
        if self.cells.shape[1] == 4:
            quads = self.cells
        else:  # VTK's order: 4 corners, 4 mid-sides, centre
            c = self.cells.T
            quads = np.concatenate([np.stack(q, axis=1) for q in ((c[0], c[4], c[8], c[7]), (c[4], c[1], c[5], c[8]),
                                                                 (c[8], c[5], c[2], c[6]), (c[7], c[8], c[6], c[3]))])
        return np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


def run(name, folder, *settings):
    """Runs a file of prm/paper; returns the run folder."""
    out = pathlib.Path(folder) / (name + "-" + str(len(settings)))
    subprocess.run([ROOT / "build/orthocone", ROOT / f"prm/paper/{name}.prm", "--quiet", "--output", out,
                    *[f"--set={setting}" for setting in (*ONE_CYCLE, *settings)]], check=True)
    return out


def peak_values(folder):
    contact = ContactFile(folder / f"contact-{PEAK:04d}.vtu")
    normal_force = contact["nodal_force"][:, 2]
    return contact["slip_magnitude"].max(), normal_force.min(), normal_force.max()


def print_table(folder):
    print("| case | quantity | paper | bricks | bricks, fitted | Q2 |\n|---|---|---|---|---|---|")
    names = ("largest slip (mm)", "smallest nodal force (N)", "largest nodal force (N)")
    for case in CASES:
        ours = [peak_values(run(f"case_{case}_q1", folder)), peak_values(run(f"case_{case}_q1", folder, *FITTED_MESH)),
                peak_values(run(f"case_{case}", folder))]
        for i, name in enumerate(names):
            numbers = [f"{values[i]:.5f}" if i == 0 else f"{values[i]:.0f}" for values in (PRINTED[case], *ours)]
            print(f"| {case.upper()} | {name} | {' | '.join(numbers)} |")
    slip = peak_values(run("case_b_printed", folder))[0]
    print(f"\nCase B with the printed mu_y = 0.25: largest slip {slip:.5f} mm, {slip / PRINTED['b'][0]:.2f} of the "
          "printed one.")


def draw(folder, picture):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    from matplotlib.colors import ListedColormap
    figure, axes = plt.subplots(3, 3, figsize=(10.5, 9.6), layout="constrained")
    statuses = ListedColormap(["white", "#35608d", "#e8a33d"])
    for row, case in enumerate(CASES):
        out = run(f"case_{case}", folder)
        peak, later = (ContactFile(out / f"contact-{step:04d}.vtu") for step in (PEAK, UNLOADING))
        x, y = peak.points[:, 0], peak.points[:, 1]
        triangles = peak.triangles()
        slip = peak["slip_magnitude"] * 1000
        shown = axes[row, 0].tricontourf(x, y, triangles, slip, levels=12, cmap="viridis")
        axes[row, 0].tricontour(x, y, triangles, slip, levels=12, colors="white", linewidths=0.4)
        figure.colorbar(shown, ax=axes[row, 0], label="slip, µm")
        pressure = peak["pressure"]  # singular at the rim: the scale ends below the few largest values
        shown = axes[row, 1].tripcolor(x, y, triangles, pressure, shading="gouraud", cmap="magma",
                                       vmax=np.percentile(pressure, 85))
        figure.colorbar(shown, ax=axes[row, 1], label="pressure, MPa", extend="max")
        shown = axes[row, 2].tripcolor(x, y, triangles, later["status"][triangles].max(axis=1), cmap=statuses, vmin=-0.5,
                                       vmax=2.5)
        figure.colorbar(shown, ax=axes[row, 2], ticks=[0, 1, 2]).set_ticklabels(["open", "stick", "slip"])
        axes[row, 0].set_ylabel(f"case {case.upper()}", fontsize=13)
    for column, title in enumerate(("slip at the peak", "contact pressure at the peak", "status in unloading, step 8")):
        axes[0, column].set_title(title)
    for ax in axes.flat:
        ax.set_aspect("equal")
        ax.set_xticks([])
        ax.set_yticks([])
        ax.set_frame_on(False)
    figure.savefig(picture, dpi=110)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as scratch:
        print_table(scratch)
        if len(sys.argv) > 1:
            draw(scratch, sys.argv[1])
