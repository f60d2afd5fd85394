# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Scenes for multigrid, and what it means that two runs of one have the same states."""
import math
import pathlib

TOLERANCE = 1e-10  # of the contact solver, as by default
ISOTROPIC = ["Mesh/Core cells=2", "Mesh/Rings=1", "Mesh/Core ratio=0.6", "Mesh/Layers=2"]
BOX = ["Geometry/Shape=box", "Mesh/Cells=2, 4, 2"]
# Multigrid does not know the depth of a deep step as an unknown.
EXPLICIT = "Wear/Deep steps=explicit"
SOFT_BOX = ["Mesh/Cells=2, 2, 2", "Mesh/Refinements=1", "Wear/Law=archard", EXPLICIT]
FRETTING = ["Load program/Preload=Fz -5e5 : 2", "Load program/Legs=ux 0.01 : 2 ; ux -0.01 : 3", "Load program/Cycles=1"]
RUBBING = ["Load program/Preload=0 0 -0.05 : 2", "Load program/Legs=0.02 0 -0.05 : 2 ; -0.02 0 -0.05 : 4", "Load program/Cycles=8"]
ONE_CYCLE = ["Load program/Legs=0 0 -0.1 : 2 ; 0 0 0.0 : 4", "Load program/Cycles=1"]
GAPS = pathlib.Path(__file__).resolve().parent / "gaps.txt"

# Name: file, settings besides the mesh.
SCENES = {
    "case B": ("paper/case_b.prm", [*ISOTROPIC, *ONE_CYCLE, "Mesh/Refinements=1"]),
    "case C, degree 3": ("paper/case_c.prm", [*ISOTROPIC, *ONE_CYCLE, "Mesh/Degree=3", "Mesh/Refinements=1"]),
    "case C, degree 1": ("paper/case_c.prm", [*ISOTROPIC, *ONE_CYCLE, "Mesh/Degree=1", "Mesh/Refinements=2"]),
    "no refinement": ("paper/case_b.prm", [*ISOTROPIC, *ONE_CYCLE]),
    "one level": ("paper/case_b.prm", [*ISOTROPIC, *ONE_CYCLE, "Mesh/Degree=1"]),
    "turned axes, full model": ("paper/case_c.prm", [*ISOTROPIC, *ONE_CYCLE, "Friction/Orthotropy angle=30",
                                                     "Mesh/Refinements=1"]),
    # Released to -0.05 mm, this scene has two equilibria (residuals 9e-13 and 3e-12, forces that differ by 2e-4), and the
    # last bits of the products decide which of them is found.
    "slip axes that differ 100-fold": ("paper/case_b.prm", [*ISOTROPIC, "Load program/Legs=0 0 -0.1 : 2 ; 0 0 -0.075 : 1",
                                                            "Load program/Cycles=1", "Mesh/Refinements=1",
                                                            "Friction/Slip potential=0.01, 1"]),
    "slip axes that differ 100-fold the other way": ("paper/case_b.prm", [*ISOTROPIC, *ONE_CYCLE, "Mesh/Refinements=1",
                                                                          "Friction/Slip potential=1, 0.01"]),
    "cells of three sizes": ("paper/case_c.prm", [*ISOTROPIC, *ONE_CYCLE, "Mesh/Refinements=1",
                                                  "Mesh/Refined cells=1-3 16 28; 35-36 41-42 60",
                                                  "Mesh/Volumetric quadrature=projected"]),
    "cells of two sizes, full model, degree 1": ("paper/case_b.prm", [*ISOTROPIC, *ONE_CYCLE, "Mesh/Model=full",
                                                                      "Mesh/Degree=1", "Mesh/Refined cells=0-3 7 12"]),
    "box of cells of two sizes on a wave, pushed by a force and worn": (
        "paper/case_c.prm", [*BOX, *FRETTING, "Obstacle/Gap=0.002*(1-cos(x/3))", "Mesh/Refined cells=0-1 5",
                             "Mesh/Quadrature points=4", "Wear/Law=archard", "Wear/Coefficient=1e-5"]),
    "graded by a word": ("paper/case_b.prm", ["Mesh/Resolution=coarse", "Mesh/Volumetric quadrature=projected",
                                              "Load program/Legs=0 0 -0.1 : 1 ; 0 0 -0.05 : 1",
                                              "Load program/Cycles=1"]),
    "no coarser mesh, nodes aggregated": ("paper/case_b.prm", ["Geometry/Shape=box", "Mesh/Cells=39, 39, 3", "Mesh/Degree=1",
                                                               "Load program/Legs=0 0 -0.1 : 1 ; 0 0 -0.05 : 1",
                                                               "Load program/Cycles=1"]),
    "tall body": ("paper/case_c.prm", [*ISOTROPIC, "Mesh/Layers=8", "Geometry/Height=60", "Material/Poisson ratio=0",
                                       "Mesh/Refinements=1", "Load program/Cycles=1",
                                       "Load program/Legs=uz -0.05 : 2 ; ux 0.02 : 2 ; uy 0.02 : 2"]),
    "pin on its sphere, cells of two sizes": (
        "import/pin.prm", ["Geometry/Curved surfaces=cap: sphere about 0 0 10", "Mesh/Refined cells=0-40",
                           "Load program/Legs=0 0 -0.02 : 2 ; 0 0 -0.01 : 1", "Load program/Cycles=1"]),
    "guided": ("paper/case_b.prm", [*ISOTROPIC, *ONE_CYCLE, "Geometry/Top face=guided", "Mesh/Refinements=1"]),
    "box between supports": ("paper/case_c.prm", [*BOX, *FRETTING, "Mesh/Refinements=1", "Mesh/Refined cells=0-1 5",
                                                  "Geometry/Supports=x+: x z ; y-: y"]),
    "polar friction": ("verification/polar_friction.prm", [*ISOTROPIC, *ONE_CYCLE, "Mesh/Model=quarter",
                                                           "Mesh/Refinements=1"]),
    "fretting under a force": ("paper/case_b.prm", [*ISOTROPIC, *FRETTING, "Mesh/Refinements=1",
                                                    "Mesh/Volumetric quadrature=projected"]),
    "sheared box on a wave": ("paper/case_c.prm", [*BOX, *FRETTING, "Mesh/Refinements=1",
                                                   "Obstacle/Gap=0.002*(1-cos(x/3))"]),
    "twisted": ("paper/case_b.prm", [*ISOTROPIC, "Load program/Legs=uz -0.05 : 2 ; rz 0.1 : 2 ; Mz 0 : 2",
                                     "Load program/Cycles=1", "Mesh/Refinements=1", "Mesh/Model=full"]),
    "friction and gap that vary, parts of steps, until it is periodic": (
        "paper/case_b.prm", [*ISOTROPIC, "Mesh/Refinements=1", "Friction/Coefficients=0.3*(1+x/40), 0.15-0.002*y",
                             "Friction/Slip potential=0.1, 0.2*(1+y/60)", f"Obstacle/Gap file={GAPS}",
                             "Load program/Legs=0 0 -0.1 : 2 ; 0 0 -0.04 : 1 * 2", "Load program/Cycles=20",
                             "Load program/Stop when periodic=1e-3"]),
    "tilted by motion and moment, with a jump when it is periodic": (
        "paper/case_c.prm", [*ISOTROPIC, "Mesh/Refinements=1", "Load program/Preload=uz -0.1 : 1",
                             "Load program/Legs=rx 0.02 My 4e4 : 1 ; rx 0 My -4e4 : 1 * 2", "Load program/Cycles=50",
                             "Load program/Jump when periodic=1e-3"]),
    "box drawn along x and pushed along y": (
        "verification/worn_punch.prm", [*SOFT_BOX, "Load program/Legs=Fz -1000 Fy 100 : 1 ; ux 400 : 4"]),
    "box worn deeper than pressure flattens it": (
        "verification/worn_punch.prm", [*SOFT_BOX, "Load program/Legs=Fz -1000 : 1 ; ux 400 : 4"]),
    "box worn deeper on one side, free to tilt": (
        "verification/worn_punch.prm", [*SOFT_BOX, "Load program/Legs=Fz -1000 Mx 0 My 0 : 1 ; ux 400 : 4",
                                        "Wear/Coefficient=1e-3"]),
    "sphere that wears deeper than pressure flattens it": (
        "verification/worn_sphere.prm", ["Wear/Law=archard", EXPLICIT, "Mesh/Core cells=4", "Mesh/Rings=1",
                                         "Mesh/Layers=2", "Mesh/Refinements=1", "Load program/Cycles=1",
                                         "Load program/Legs=ux 1 : 2 ; ux -1 : 4 ; ux 0 : 2"]),
    "worn, with jumps": ("paper/case_b.prm", [*ISOTROPIC, *RUBBING, "Mesh/Degree=1", "Mesh/Refinements=1", "Wear/Law=archard",
                                              "Wear/Coefficient=1e-5", "Wear/Largest depth of a jump=1e-4"]),
}
COUNTS = {"step", "iterations", "residual", "n_open", "n_stick", "n_slip"}


def numbers(rows):
    """Columns that are numbers."""
    columns = {}
    for name in rows[0]:
        if name not in COUNTS:
            try:
                columns[name] = [float(row[name]) for row in rows]
            except ValueError:
                pass
    return columns


def differences(first, second):
    """Of motions, forces, moments, slips, energies and wear: the largest difference / (the tolerance x the column's scale).
    Energies sum what nodes err by, and accumulated slip what cycles do. What is worn has its own scale. Pressures are of
    single nodes, whose forces may differ by more, and areas jump with the status of a node."""
    lever = 10  # mm: of the outermost nodes
    slip = max(abs(u) for key in ("ux", "uy", "uz") for u in first[key]) + 1e-9
    force = max(abs(f) for key in ("force_x", "force_y", "force_z") for f in first[key])
    scales = {**{f"force_{axis}": force for axis in "xyz"}, **{f"moment_{axis}": force * lever for axis in "xyz"},
              **{f"u{axis}": slip for axis in "xyz"}, **{f"r{axis}": math.degrees(slip / lever) for axis in "xyz"},
              "max_slip": slip, "max_accumulated_slip": slip * (1 + first["cycle"][-1]),
              **{key: force * slip for key in ("elastic_energy", "dissipation", "total_dissipation")},
              **{key: max(first[key]) + 1e-30 for key in ("worn_volume", "max_wear_depth")}}
    return {column: max(abs(a - b) for a, b in zip(first[column], second[column])) / (TOLERANCE * scale)
            for column, scale in scales.items()}
