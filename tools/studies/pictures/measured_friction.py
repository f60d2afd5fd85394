# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What measured friction does: slip of a cylinder under three laws, a strip that walks, and how many slips one push has; with
--docs the pictures and the table of docs/measured_friction.md. Started by tools/study friction."""
import matplotlib.pyplot as plt
import numpy as np

import disc_map
import docs_page
import rosette_file
import several_slips
from panels import BLUE, GREY, RED
from paper_runs import Runs
from paths import ROOT
from rosette_law import RosetteLaw, unit

LAWS = {"four_lobes": "four lobes", "ratchet": "ratchet", "chiral": "chiral"}
LEGS = ((0, 5, "pressed"), (5, 11, "sheared to +x"), (11, 23, "sheared to −x"))  # steps before and at the end of a leg
N_ARROWS = 13  # across a map
PRESSING, SHEARING = np.arange(0, 11, 1), np.arange(0, 6.5, 0.5)  # levels, µm


class FrictionRuns(Runs):
    """Runs of prm/rosette."""

    def scene(self, name):
        return self.run(name, f"../rosette/{name}", "Output/Probes=")

    def walker(self, weight):
        return self.run(f"walker-{weight}", "../rosette/walker", "Output/Probes=left: -4 0 ; middle: 0 0 ; right: 4 0",
                        f"Load program/Preload=weight {weight} : 1")


# --- the cylinder ---

def forces_and_slip(ax, name):
    table, = rosette_file.read(ROOT / f"prm/rosette/{name}.txt")
    law, angles = RosetteLaw(table), np.linspace(0, 2 * np.pi, 361)
    ax.axhline(0, color=GREY, linewidth=0.5)
    ax.axvline(0, color=GREY, linewidth=0.5)
    ax.plot(*law.force(angles).T, color=BLUE)
    ax.plot(*table.forces.T, "o", color=BLUE, markersize=2)
    for angle in np.linspace(0, 2 * np.pi, 16, endpoint=False):
        force, slip = law.force(angle), -0.12 * unit(np.array(angle))
        ax.annotate("", force + slip, force, arrowprops={"arrowstyle": "-|>", "color": RED, "linewidth": 0.8, "mutation_scale": 6,
                                                         "shrinkA": 0, "shrinkB": 0})
    ax.set(aspect="equal", xlim=(-0.45, 0.45), ylim=(-0.45, 0.45), xticks=(-0.4, 0, 0.4), yticks=(-0.4, 0, 0.4), ylabel=LAWS[name])
    ax.tick_params(labelsize=7)


def slip_since(run, before, after):
    """The surface at the end of a leg, and its slip (nodes, 2) in the leg, µm."""
    surface = disc_map.Surface(run, after)
    slip = 1e3 * surface["slip"][:, :2]
    return surface, slip - (1e3 * disc_map.Surface(run, before)["slip"][:, :2] if before else 0)


def slip_map(ax, run, leg, levels):
    surface, slip = slip_since(run, *leg)
    size = np.hypot(*slip.T)
    shown = ax.tricontourf(surface.triangulation(), surface.with_centres(size), levels=levels, cmap="viridis", extend="max")
    ax.tricontour(surface.triangulation(), surface.with_centres(size), levels=[0.02], colors="white", linewidths=0.9)
    for x in np.linspace(-9, 9, N_ARROWS):
        for y in np.linspace(-9, 9, N_ARROWS):
            node = np.argmin(np.hypot(*(surface.points - (x, y)).T))
            if np.hypot(x, y) < 9.6 and size[node] > 0.15:
                way = 1.1 * slip[node] / size[node]
                ax.annotate("", surface.points[node] + way, surface.points[node] - 0.2 * way,
                            arrowprops={"arrowstyle": "-|>", "color": "white", "linewidth": 0.6, "mutation_scale": 4, "shrinkA": 0,
                                        "shrinkB": 0})
    disc_map.frame(ax)
    return shown


def gallery(runs):
    """A row for each law: forces and slip, and the slip of three legs."""
    figure, axes = plt.subplots(3, 4, figsize=(docs_page.WIDTH, 5.6))
    for row, name in zip(axes, LAWS):
        forces_and_slip(row[0], name)
        run = runs.scene(name)
        shown = [slip_map(ax, run, leg[:2], levels) for ax, leg, levels in zip(row[1:], LEGS, (PRESSING, SHEARING, SHEARING))]
    for ax, (_, _, title) in zip(axes[0, 1:], LEGS):
        ax.set_title(title)
    axes[0, 0].set_title("law")
    for column, ticks in enumerate((range(0, 11, 2), range(0, 7, 2), range(0, 7, 2))):
        figure.colorbar(shown[column], ax=axes[:, column + 1], location="bottom", label="slip of the leg (µm)", shrink=0.9, aspect=14,
                        pad=0.02, ticks=ticks)
    docs_page.headline(figure, "Lobes, scales and handedness of a surface show in the slip")
    return figure


def turn_from_radius(run):
    """Mean angle (degrees) of the slip of the pressed body from the radius, to the left, with the size of the slip as weight."""
    surface, slip = slip_since(run, *LEGS[0][:2])
    radius = surface.points
    left, out = radius[:, 0] * slip[:, 1] - radius[:, 1] * slip[:, 0], (radius * slip).sum(axis=1)
    return np.degrees(np.arctan2(left.sum(), out.sum()))


def gallery_row(runs, name):
    """Stuck area and turn of the slip when pressed, largest slips and forces of the legs."""
    run = runs.scene(name)
    step = np.array([last for _, last, _ in LEGS]) - 1
    history = {column: run.history[column][step] for column in ("force_x", "force_z", "stick_area")}
    stuck = 100 * history["stick_area"] / (np.pi * 100)
    slips = [np.hypot(*slip_since(run, *leg[:2])[1].T).max() for leg in LEGS]
    force = 100 * np.abs(history["force_x"] / history["force_z"])
    return (f"| `{name}` | {stuck[0]:.0f} | {abs(round(turn_from_radius(run), 1)):g} | {slips[0]:.1f} | {slips[1]:.1f}, {slips[2]:.1f} | "
            f"{force[1]:.1f}, {force[2]:.1f} |\n")


def table(runs):
    head = ("| law | stuck when pressed, % of the area | turn of the slip from the radius, degrees | largest slip when pressed, µm | "
            "when sheared to +x and to −x, µm | force along x there, % of the normal force |\n|---|---|---|---|---|---|\n")
    return head + "".join(gallery_row(runs, name) for name in LAWS)


# --- the strip that walks ---

def way(run, place):
    """Slip along x of a probe, µm, and the cycles that have passed."""
    values = 1e3 * run.probe(place)["slip_x"]
    return np.arange(len(values)) / 8, values


def drift(weight):
    """Micrometres a cycle of a strip that does not bend (prm/rosette/walker.prm)."""
    return 1e3 * 4 * (1 - 0.3**2) / 210000 * (400 - 0.125 * weight * 8)


def walk(runs):
    figure, (ax, right) = plt.subplots(1, 2, figsize=(docs_page.WIDTH, 2.8), width_ratios=(1.5, 1))
    run = runs.walker(1)
    for place, colour in (("left", BLUE), ("middle", GREY), ("right", RED)):
        ax.plot(*way(run, place), color=colour, label=f"{place} of the strip")
    ax.set(xlabel="cycles", ylabel="slip along x (µm)", xticks=range(5))
    ax.legend(loc="upper left")
    weights = (0.5, 1, 2, 4)
    found = [walked(runs.walker(weight)) for weight in weights]
    right.plot(weights, found, "o", color=BLUE, label="orthocone")
    w = np.linspace(0, 4.4, 12)
    right.plot(w, drift(w), color=RED, label="without bending")
    right.set(xlabel="pressure on the top (MPa)", ylabel="walk of a cycle (µm)", xlim=(0, 4.5))
    right.legend()
    docs_page.headline(figure, "A strip that is squeezed and stretched on a ratchet walks")
    return figure


def walked(run):
    """In the last cycle, µm."""
    values = way(run, "middle")[1]
    return values[-1] - values[-9]


def main():
    docs_page.main("friction", __doc__, FrictionRuns,
                   {"friction_gallery": gallery, "friction_walk": walk, "friction_several_slips": lambda _: several_slips.picture()},
                   {"laws": table})
