# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""A picture of each scene of prm/tutorial; with --docs those of docs/tutorial.md. Started by tools/study tutorial."""
import math

import matplotlib.pyplot as plt
import numpy as np

import docs_page
from answers import Sphere
from disc_map import Surface, axes_cross, filled, levels_of, status_legend, status_map
from docs_page import WIDTH
from imported_body import ImportedBody
from measure import along_x, on_surface
from panels import BLUE, DOTS, LINE, RED, label
from paper_runs import Runs
from verification_import import draw_field, draw_mesh

SCENES = ("1_case_b", "2_own_material", "3_fretting", "4_sphere", "5_part", "6_wear")
LAST_CYCLE = 100000
FORCE = 384.615  # N, of scene 4
SETTLED = "Load program/Cycles=20"  # of scene 3, whose thin loop is closed then
SLIDING = "Load program/Legs=ux 0.03 : 8 ; ux -0.03 : 16 ; ux 0 : 8"  # scene 3 once more


class TutorialRuns(Runs):
    """Runs of prm/tutorial."""

    def scene(self, file, *settings):
        name = "-".join([file, *(setting.split("=")[1] for setting in settings)]).replace(" ", "").replace(";", "_")
        return self.run(name.replace(":", "x"), f"../tutorial/{file}", "Output/Probes=", *settings)


def row(count, height):
    return plt.subplots(1, count, figsize=(WIDTH, height))


def slip_in_colours(figure, ax, surface):
    slip = 1e3 * surface["slip_magnitude"]
    filled(figure, ax, surface, slip, levels_of(0, slip.max()), "slip (µm)")


def status_in_colours(ax, surface):
    status_map(ax, surface)
    axes_cross(ax)


def press(runs):
    """Scene 1: slip, pressure and status at full load."""
    figure, axes = row(3, 3.3)
    surface = Surface(runs.scene("1_case_b"), 5)
    slip_in_colours(figure, axes[0], surface)
    pressure = surface["pressure"]
    levels = levels_of(pressure.min(), np.quantile(pressure, 0.85))  # the rim is singular
    filled(figure, axes[1], surface, pressure, levels, "pressure (MPa)", "cividis", "black")
    status_in_colours(axes[2], surface)
    status_legend(figure, statuses=np.unique(surface["status"]))
    docs_page.headline(figure, "At full load the middle sticks, and the rest slips outwards")
    return figure


def own_material(runs):
    """Scene 2: the same with its axes of friction."""
    figure, axes = row(2, 4)
    surface = Surface(runs.scene("2_own_material"), 5)
    slip_in_colours(figure, axes[0], surface)
    status_in_colours(axes[1], surface)
    handles = []
    for angle, style, name in ((30, "-", "first axis of friction"), (120, "--", "second axis of friction")):
        along = 10 * np.array([math.cos(math.radians(angle)), math.sin(math.radians(angle))])
        handles += [ax.plot(*np.stack([-along, along]).T, color=colour, linewidth=1.2, linestyle=style, label=name)[0]
                    for ax, colour in zip(axes, ("white", "black"))][1:]
    status_legend(figure, *handles, statuses=np.unique(surface["status"]))
    docs_page.headline(figure, "Slip and stick zone turn with the axes of friction")
    return figure


def last_cycle(history):
    """Motion (µm) and tangential force (kN) of the last cycle, from the step at which it begins."""
    begin = np.argmax(history["cycle"] == history["cycle"].max()) - 1
    return history["ux"][begin:] * 1e3, -history["force_x"][begin:] / 1e3


def fretting(runs):
    """Scene 3: both loops, and the thin one without the elastic part of its force."""
    figure, axes = row(2, 3)
    for legs, colour, name in ((SETTLED, BLUE, "partial slip, 10 µm"), (SLIDING, RED, "sliding, 30 µm")):
        motion, force = last_cycle(runs.scene("3_fretting", legs).history)
        axes[0].plot(motion, force, color=colour, label=name)
        if legs == SETTLED:
            line = np.polyval(np.polyfit(motion, force, 1), motion)
            axes[1].plot(motion, (force - line) * 1e3, color=colour)
    axes[0].axhline(30, color="0.4", linewidth=0.8, linestyle=":", label="0.30 times 100 kN")
    label(axes[0], "loops", "motion of the top (µm)", "tangential force (kN)")
    label(axes[1], "partial slip, less its elastic line", "motion of the top (µm)", "force less the line (N)")
    docs_page.legend_below(figure, *axes[0].get_legend_handles_labels(), 3)
    docs_page.headline(figure, "Sliding opens the loop, partial slip hardly does")
    return figure


def sphere(runs):
    """Scene 4: pressure and contact radius over Hertz."""
    figure, axes = row(2, 2.9)
    run = runs.scene("4_sphere")
    radius, pressure = on_surface(run, 4, "pressure")
    r = np.linspace(0, 0.5, 400)
    axes[0].plot(r, Sphere(FORCE).pressure(r), **LINE)
    axes[0].plot(radius[radius < 0.7], pressure[radius < 0.7], **DOTS)
    label(axes[0], "pressure at 384.615 N", "distance from the axis (mm)", "pressure (MPa)")
    forces = np.linspace(1, FORCE, 200)
    axes[1].plot(forces, [Sphere(force).largest_pressure for force in forces], **LINE)
    axes[1].plot(run.history["force_z"], run.history["max_pressure"], **DOTS)
    axes[1].set_ylim(0, None)
    label(axes[1], "largest pressure", "force (N)", "pressure (MPa)")
    docs_page.legend_below(figure, *axes[0].get_legend_handles_labels(), 2)
    docs_page.headline(figure, "Pressure under the sphere is that of Hertz")
    return figure


def part(runs):
    """Scene 5: the mesh from below, pressure and slip at full load."""
    figure = plt.figure(figsize=(WIDTH, 2.9))
    run = runs.scene("5_part")
    mesh = figure.add_subplot(1, 3, 1, projection="3d")
    draw_mesh(mesh, ImportedBody.of(run.parameters["Geometry"]), (-22, -60))
    mesh.set_title("mesh from below")
    surface = Surface(run, 10)
    for place, field, factor, name, unit, colours in ((2, "pressure", 1e-3, "pressure", "GPa", "cividis"),
                                                      (3, "slip_magnitude", 1e3, "slip", "µm", "viridis")):
        ax = figure.add_subplot(1, 3, place)
        bar = figure.colorbar(draw_field(ax, surface, factor * surface[field], colours), ax=ax, location="bottom",
                              label=f"{name} ({unit})", shrink=0.9, aspect=18)
        bar.set_ticks(bar.get_ticks()[::2])
        ax.set(title=name, xlim=(-0.6, 0.6), ylim=(-0.6, 0.6), xticks=(-0.5, 0, 0.5), yticks=(-0.5, 0, 0.5))
    docs_page.headline(figure, "The pin touches on a small circle, which few cells span")
    return figure


def wear(runs):
    """Scene 6: force and worn depth over cycles, worn depth and pressure at the end."""
    figure, axes = plt.subplots(2, 2, figsize=(WIDTH, 4.8))
    run = runs.scene("6_wear")
    cycles = run.cycles
    computed = cycles["n_cycles"] == 1  # a jump repeats the force before it
    axes[0, 0].plot(cycles["cycle"][computed], cycles["force_z"][computed], color=BLUE)
    label(axes[0, 0], "normal force", "cycle", "force (N)")
    axes[0, 1].plot(cycles["cycle"], cycles["max_wear_depth"] * 1e3, color=RED)
    label(axes[0, 1], "largest worn depth", "cycle", "depth (µm)")
    for ax in axes[0]:
        ax.set(xscale="log")
    last = 16 + 8 * LAST_CYCLE
    for ax, field, factor, colour in ((axes[1, 0], "pressure", 1, BLUE), (axes[1, 1], "wear_depth", 1e3, RED)):
        x, values = along_x(run, last, field)
        ax.plot(x, factor * values, color=colour, marker="o", markersize=3)
        ax.set_xlim(0, 0.8)
    label(axes[1, 0], "pressure after 10$^5$ cycles", "x (mm)", "pressure (MPa)")
    label(axes[1, 1], "worn depth after 10$^5$ cycles", "x (mm)", "depth (µm)")
    docs_page.headline(figure, "The ring that slips wears until the stuck middle carries all")
    return figure


PICTURES = {f"tutorial_{name}": picture
            for name, picture in zip(SCENES, (press, own_material, fretting, sphere, part, wear))}


def main():
    docs_page.main("tutorial", __doc__, TutorialRuns, PICTURES)
