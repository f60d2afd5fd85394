# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""A picture of each scene of prm/tutorial; with --docs those of docs/tutorial.md. Started by tools/study tutorial."""
import math

import matplotlib.pyplot as plt
import numpy as np

import docs_page
from answers import Sphere
from disc_map import Surface, contours, status_legend, status_map
from imported_body import ImportedBody
from measure import on_surface
from panels import BLUE, DOTS, GREEN, LINE, RED, label
from paper_runs import Runs
from verification_import import draw_field, draw_mesh

SCENES = ("1_case_b", "2_own_material", "3_fretting", "4_sphere", "5_part", "6_wear")
LAST_CYCLE = 100000
FORCE = 384.615  # N, of scene 4
SLIDING = "Load program/Legs=ux 0.03 : 8 ; ux -0.03 : 16 ; ux 0 : 8"  # scene 3 once more


class TutorialRuns(Runs):
    """Runs of prm/tutorial."""

    def scene(self, file, *settings):
        name = "-".join([file, *(setting.split("=")[1] for setting in settings)]).replace(" ", "").replace(";", "_")
        return self.run(name.replace(":", "x"), f"../tutorial/{file}", "Output/Probes=", *settings)


def row(count, height=4.0):
    return plt.subplots(1, count, figsize=(4.4 * count, height), layout="constrained")


def filled(figure, ax, surface, field, title, colours="viridis", share=0.99):
    """The largest values, which a singular rim has, take the last colour."""
    values = surface[field]
    most, least = np.quantile(values, share), values.min()
    shown = contours(ax, surface, values, np.linspace(least if least > 1e-6 * most else 0, most, 13), colours)
    figure.colorbar(shown, ax=ax, shrink=0.8, format="%.4g")
    ax.set_title(title)


def press(runs):
    """Scene 1: slip, pressure and status at full load."""
    figure, axes = row(3)
    surface = Surface(runs.scene("1_case_b"), 5)
    filled(figure, axes[0], surface, "slip_magnitude", "slip (mm), step 5")
    filled(figure, axes[1], surface, "pressure", "pressure (MPa), step 5", "plasma", share=0.85)
    status_map(axes[2], surface)
    axes[2].set_title("status, step 5")
    status_legend(figure)
    return figure


def own_material(runs):
    """Scene 2: the same with its axes of friction."""
    figure, axes = row(2)
    surface = Surface(runs.scene("2_own_material"), 5)
    filled(figure, axes[0], surface, "slip_magnitude", "slip (mm), step 5")
    status_map(axes[1], surface)
    axes[1].set_title("status, step 5")
    for angle, style in ((30, "-"), (120, "--")):
        along = 10 * np.array([math.cos(math.radians(angle)), math.sin(math.radians(angle))])
        for ax in axes:
            ax.plot(*np.stack([-along, along]).T, color="0.1", linewidth=1, linestyle=style)
    status_legend(figure)
    return figure


def fretting(runs):
    """Scene 3: both loops, and the thin one without the elastic part of its force."""
    figure, axes = row(2)
    for legs, colour, name in (((), BLUE, "0.010 mm"), ((SLIDING,), RED, "0.030 mm")):
        history = runs.scene("3_fretting", *legs).history
        motion, force = history["ux"][4:] * 1e3, -history["force_x"][4:] / 1e3
        axes[0].plot(motion, force, color=colour, marker=".", markersize=3, label=name)
        if not legs:
            last = history["cycle"][4:] == 2
            last[np.argmax(last) - 1] = True  # where it begins
            line = np.polyval(np.polyfit(motion[last], force[last], 1), motion)
            axes[1].plot(motion[last], (force - line)[last] * 1e3, color=colour, marker=".", label=name)
    axes[0].axhline(30, color="0.4", linewidth=0.8, linestyle=":", label="0.30 times 100 kN")
    label(axes[0], "Force over motion of the top", "ux in µm", "tangential force in kN")
    label(axes[1], "Second cycle, less a straight line", "ux in µm", "force less line in N")
    return figure


def sphere(runs):
    """Scene 4: pressure and contact radius over Hertz."""
    figure, axes = row(2)
    run = runs.scene("4_sphere")
    radius, pressure = on_surface(run, 4, "pressure")
    r = np.linspace(0, 0.5, 400)
    axes[0].plot(r, Sphere(FORCE).pressure(r), **LINE)
    axes[0].plot(radius[radius < 0.7], pressure[radius < 0.7], **DOTS)
    label(axes[0], "Pressure at 384.615 N", "r in mm", "pressure in MPa")
    forces = np.linspace(1, FORCE, 200)
    axes[1].plot(forces, [Sphere(force).largest_pressure for force in forces], **LINE)
    axes[1].plot(run.history["force_z"], run.history["max_pressure"], **DOTS)
    label(axes[1], "Largest pressure over force", "force in N", "pressure in MPa")
    return figure


def part(runs):
    """Scene 5: the mesh from below, pressure at full load, slip after the force has fallen."""
    figure = plt.figure(figsize=(12.5, 3.8), layout="constrained")
    run = runs.scene("5_part")
    mesh = figure.add_subplot(1, 3, 1, projection="3d")
    draw_mesh(mesh, ImportedBody.of(run.parameters["Geometry"]), (-22, -60))
    mesh.set_title("mesh from below")
    for place, step, field, title, colours in ((2, 10, "pressure", "pressure (MPa)", "plasma"),
                                               (3, 10, "slip_magnitude", "slip (mm)", "viridis")):
        ax = figure.add_subplot(1, 3, place)
        figure.colorbar(draw_field(ax, Surface(run, step), field, colours), ax=ax, label=title, shrink=0.9)
        ax.set(title=f"step {step}", xlim=(-1.6, 1.6), ylim=(-1.6, 1.6))
    return figure


def wear(runs):
    """Scene 6: force over cycles, worn depth and pressure at the end."""
    figure, axes = row(3)
    run = runs.scene("6_wear")
    cycles = run.cycles
    axes[0].plot(cycles["cycle"], cycles["force_z"], color=BLUE, linewidth=1.4)
    axes[0].set(xscale="log", ylim=(0, None), title="Normal force at constant depth", xlabel="cycle", ylabel="force in N")
    axes[1].plot(cycles["cycle"], cycles["max_wear_depth"] * 1e3, color=RED, linewidth=1.4)
    axes[1].set(xscale="log", title="Largest worn depth", xlabel="cycle", ylabel="depth in µm")
    last = 16 + 8 * LAST_CYCLE
    radius, depth = on_surface(run, last, "wear_depth")
    axes[2].plot(radius, depth * 1e3, ".", color=RED, label="worn depth in µm")
    radius, pressure = on_surface(run, last, "pressure")
    axes[2].plot(radius, pressure / 1e3, ".", color=GREEN, label="pressure in GPa")
    axes[2].set_xlim(0, 0.8)
    label(axes[2], "The surface after 10$^5$ cycles", "distance from the axis in mm", "depth in µm, pressure in GPa")
    return figure


PICTURES = {f"tutorial_{name}": picture
            for name, picture in zip(SCENES, (press, own_material, fretting, sphere, part, wear))}


def main():
    docs_page.main("tutorial", __doc__, TutorialRuns, PICTURES)
