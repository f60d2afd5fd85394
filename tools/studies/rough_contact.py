# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""A rough surface of a spectrum and a seed, pressed and sheared: area in contact over load beside Persson's curve and the line of
Bush, Gibson and Thomas, the distribution of pressure, and damping curves along both axes of orthotropic friction.

With nu = 0 and two half-spaces of one material, tractions of partial slip along an axis are mu times the difference of two normal
solutions (Jaeger 1998, Ciavarella 1998), so that loops of any rough surface follow from its approach delta(P). Motions are those
beyond the mean strain of the far field, which a layer as thick as the period stands for."""
import csv
import math
import re
import subprocess

import matplotlib.pyplot as plt
import numpy as np
import style
from paths import ROOT
from points import StudyError, program_point
from run_folder import RunFolder

PAGE = "topography.md"
SURFACE = ("--make", "--size", "1,1", "--hurst", "0.8", "--roll-off", "0.25", "--cut-off", "0.0625", "--rms-height", "0.5um")
GRIDS, LOADS = (128, 256, 512), (25, 50, 100, 200, 400, 800)
MODULUS, AREA = 210000 / 2, 1.0  # E* of two half-spaces with nu = 0, MPa; mm^2
SCENE = {"Geometry/Shape": "half-space", "Geometry/Sizes": "1, 1", "Geometry/Periodic": "yes", "Material/Poisson ratio": 0,
         "Obstacle/Kind": "half-space", "Obstacle/Young modulus": 210000, "Obstacle/Poisson ratio": 0,
         "Output/Volume fields": 0}
PRESSED, FRICTION, AXES = 200, (0.3, 0.15), ("x", "y")
SHARES = (0.1, 0.2, 0.35, 0.5, 0.65, 0.8, 0.9)  # of the force that slides
N_CLASSES, N_STEPS = 40, 200
PRESSES, SHEARS = 2 / (210000 * AREA), 4 / (210000 * AREA)  # mm/N: mean strain of both layers of 1 mm under P and under Q
COLUMNS = {"slope": "", "area": "", "top": "", "shares": "", "approach": "", "stroke": "", "energy": "", "stick": ""}


def surface_of(context, n):
    """The gap file of a surface of n x n points, and its root mean square slope."""
    path = context.folder / "rough_contact" / f"{n}.txt"
    path.parent.mkdir(parents=True, exist_ok=True)
    said = subprocess.run([ROOT / "tools/topography", *SURFACE, "--points", str(n), "--gap", path], check=True, text=True,
                          capture_output=True, cwd=ROOT).stdout
    inside = path.resolve()
    return (inside.relative_to(ROOT) if ROOT in inside.parents else inside), float(re.search(r"Sdq\s+(\S+)", said)[1])


def points(context):
    gaps = {n: surface_of(context, n) for n in GRIDS[:1 if context.is_quick else None]}
    for n, (gap, slope) in gaps.items():
        own = {**SCENE, "Obstacle/Gap file": gap, "Mesh/Cells": f"{n}, {n}", "Friction/Coefficients": "0, 0"}
        for load in LOADS:
            yield program_point({"what": "pressed", "patches": n, "load": load, **COLUMNS, "slope": slope},
                                "verification/ball_on_plate.prm",
                                {**own, "Obstacle/Gap": "0", "Load program/Preload": "", "Load program/Legs": f"Fz -{load} : 1"})
    gap = gaps[GRIDS[0]][0]
    sheared = {**SCENE, "Obstacle/Gap": "0", "Obstacle/Gap file": gap, "Mesh/Cells": f"{GRIDS[0]}, {GRIDS[0]}",
               "Friction/Coefficients": f"{FRICTION[0]}, {FRICTION[1]}", "Friction/Slip potential": "associated",
               "Output/Contact fields": 1 + 6 + 12 + 12}
    yield program_point({"what": "approach", "patches": GRIDS[0], "load": PRESSED, **COLUMNS}, "verification/ball_on_plate.prm",
                        {**sheared, "Load program/Preload": "", "Load program/Legs": f"Fz -{PRESSED} : {N_STEPS}"})
    for axis, mu in zip(AXES, FRICTION):
        for share in SHARES[:1 if context.is_quick else None]:
            force = share * mu * PRESSED
            yield program_point({"what": f"sheared {axis}", "patches": GRIDS[0], "load": f"{force:g}", **COLUMNS},
                                "verification/ball_on_plate.prm",
                                {**sheared, "Load program/Preload": f"Fz -{PRESSED} : 1", "Load program/Legs":
                                 f"F{axis} {force:g} : 6 ; F{axis} -{force:g} : 12 ; F{axis} {force:g} : 12"})


def distribution(run):
    file = run.contact(run.contact_steps()[-1])
    pressure, touches = file["pressure"], file["status"] > 0
    counts, _ = np.histogram(pressure[touches], bins=N_CLASSES, range=(0, pressure.max()))
    return {"top": f"{pressure.max():.6g}", "shares": " ".join(f"{count / touches.sum():.5g}" for count in counts)}


def figures_of_run(result, point):
    if result.code != 0:
        raise StudyError(f"exit code {result.code}: {point.command}\n{result.errors}")
    run, what = RunFolder(result.folder), point.columns["what"]
    with open(result.folder / "history.csv", encoding="utf-8") as file:
        history = list(csv.DictReader(file))
    last = history[-1]
    if what == "pressed":
        return {"area": f"{float(last['contact_area']) / AREA:.6g}", **distribution(run)}
    if what == "approach":
        return {"approach": " ".join(f"{-float(row['uz']):.9g}" for row in history),
                "area": " ".join(f"{float(row['contact_area']):.9g}" for row in history)}
    axis = what[-1]
    motions = [float(row[f"u{axis}"]) + SHEARS * float(row[f"force_{axis}"]) for row in history[-24:]]
    return {"stroke": f"{max(motions) - min(motions):.9g}", "energy": f"{sum(float(row['dissipation']) for row in history[-24:]):.9g}",
            "stick": f"{np.count_nonzero(run.contact(len(history))['status'] == 1) * AREA / run.summary['model']['cells']:.6g}"}


def measured(context):
    return context.measure(list(points(context)), figures_of_run)


class Loops:
    """What the approach delta(P) says of loops along an axis: U(Q) = mu (delta(P) - delta(P - Q / mu)) on the way up from rest, and
    loops after Masing."""

    def __init__(self, rows):
        approach = next(row for row in rows if row["what"] == "approach")
        self.delta = np.r_[0, [float(one) for one in approach["approach"].split()]]
        self.areas = np.r_[0, [float(one) for one in approach["area"].split()]]
        self.load = np.linspace(0, PRESSED, len(self.delta))

    def stick(self, force, mu):
        """The area in contact under P - Q / mu."""
        return np.interp(PRESSED - force / mu, self.load, self.areas)

    def motion(self, force, mu):
        return mu * (self.delta[-1] - np.interp(PRESSED - force / mu, self.load, self.delta)) - PRESSES * force

    def stroke(self, force, mu):
        return 2 * self.motion(force, mu)

    def energy(self, force, mu):
        ways = np.linspace(0, force, 401)
        middles = self.motion((ways[1:] + ways[:-1]) / 2, mu)
        return 4 * force * self.motion(force, mu) - 8 * middles.sum() * (ways[1] - ways[0])


def draw_areas(axis, rows):
    for k, n in enumerate(GRIDS):
        own = [row for row in rows if row["what"] == "pressed" and int(row["patches"]) == n]
        axis.loglog([float(row["load"]) / AREA / MODULUS / float(row["slope"]) for row in own], [float(row["area"]) for row in own],
                    "o", color=style.COLOURS[k], label=f"{n} × {n} patches", mfc="none" if k else None)
    load = np.geomspace(0.008, 0.6, 60)
    axis.loglog(load, [math.erf(math.sqrt(2) * one) for one in load], "-", color="0.3", label="Persson")
    axis.loglog(load[load < 0.15], math.sqrt(2 * math.pi) * load[load < 0.15], "--", color="0.5", label="Bush, Gibson, Thomas")
    axis.set(xlabel="F / (A₀ E* Sdq)", ylabel="area in contact / nominal area")
    axis.legend(fontsize=6, loc="upper left", borderpad=0.2)


def draw_distribution(axis, rows):
    row = [row for row in rows if row["what"] == "pressed" and float(row["load"]) == LOADS[3]][-1]
    shares, top = np.array([float(one) for one in row["shares"].split()]), float(row["top"])
    edges = np.linspace(0, top, N_CLASSES + 1)
    axis.stairs(float(row["area"]) * shares / (edges[1] - edges[0]) * 1000, edges / 1000, color=style.COLOURS[0],
                label=f"{row['patches']} × {row['patches']} patches")
    mean, width = float(row["load"]) / AREA, MODULUS * float(row["slope"]) / 2
    p = np.linspace(0, top, 200)
    bell = (np.exp(-(p - mean)**2 / (2 * width**2)) - np.exp(-(p + mean)**2 / (2 * width**2))) / (width * math.sqrt(2 * math.pi))
    axis.plot(p / 1000, 1000 * bell, "-", color="0.3", label="Persson")
    axis.set(xlabel=f"pressure (GPa), {row['load']} N", ylabel="nominal area by pressure (1/GPa)", ylim=(0, None))
    axis.legend(fontsize=7)


def draw_damping(axis, rows):
    theory = Loops(rows)
    for k, (name, mu) in enumerate(zip(AXES, FRICTION)):
        own = [row for row in rows if row["what"] == f"sheared {name}"]
        forces = np.linspace(0.05, 0.95, 60) * mu * PRESSED
        axis.loglog([500 * theory.stroke(one, mu) for one in forces], [1e3 * theory.energy(one, mu) for one in forces], "-", lw=1,
                    color="0.5", label="from δ(P)" if k == 0 else None)
        axis.loglog([500 * float(row["stroke"]) for row in own], [1e3 * float(row["energy"]) for row in own], "o",
                    color=style.COLOURS[k], label=f"along {name}, μ = {mu}")
    axis.set(xlabel="amplitude (µm)", ylabel="energy of a cycle (µJ)")
    axis.legend(fontsize=7)


def figures(rows):
    figure, axes = plt.subplots(1, 3, figsize=(style.WIDTH, 3.3))
    for axis, draw in zip(axes, (draw_areas, draw_distribution, draw_damping)):
        draw(axis, rows)
    style.headline(figure, "A rough surface: area over load, pressures, and damping")
    return {"rough_contact": figure}


def tables(rows):
    of = {(int(row["patches"]), int(row["load"])): row for row in rows if row["what"] == "pressed"}
    grids = [n for n in GRIDS if (n, LOADS[0]) in of]
    areas = ("| force (N) |" + "".join(f" area, {n}² (%) | κ |" for n in grids) + f" Persson, {grids[-1]}² (%) |\n"
             + "|--:" * (2 * len(grids) + 2) + "|\n")
    for load in LOADS:
        areas += f"| {load} |"
        for n in grids:
            row = of[n, load]
            ratio = load / AREA / MODULUS / float(row["slope"])
            areas += f" {100 * float(row['area']):.2f} | {float(row['area']) / ratio:.2f} |"
        areas += f" {100 * math.erf(math.sqrt(2) * ratio):.2f} |\n"
    loops = ("| axis | force / force that slides | area that sticks (mm²) | A(P − Q/μ) | secant stiffness (N/µm) | from δ(P) "
             "| energy of a cycle (µJ) | from δ(P) |\n" + "|--:" * 8 + "|\n")
    theory = Loops(rows)
    for name, mu in zip(AXES, FRICTION):
        for row in (row for row in rows if row["what"] == f"sheared {name}"):
            force, stroke = float(row["load"]), float(row["stroke"])
            loops += (f"| {name} | {force / (mu * PRESSED):.2f} | {float(row['stick']):.4f} | "
                      f"{theory.stick(force, mu):.4f} | {2e-3 * force / stroke:.3f} | "
                      f"{2e-3 * force / theory.stroke(force, mu):.3f} | {1e3 * float(row['energy']):.4g} | "
                      f"{1e3 * theory.energy(force, mu):.4g} |\n")
    return {"rough areas": areas, "rough loops": loops}
