# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Parts of prm/parts: their meshes, pressure and slip amplitude along the contact; with --docs the pictures and the table of
docs/parts.md. Started by tools/study parts."""
import dataclasses
from typing import Callable

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection

import docs_page
from imported_body import border_faces, read
from panels import BLUE, GREY, RED
from paper_runs import Runs

UPPER, LOWER = "#c9dcec", "#e6dccb"
TO_DEGREES = 180 / np.pi


@dataclasses.dataclass(frozen=True)
class Part:
    """`coordinate` is a function of the places (n, 3) of contact nodes, and nan off the line that is drawn."""
    title: str
    along: str  # the coordinate along the contact, with its unit
    states: tuple  # (label, how many steps before the end of the run)
    coordinate: Callable
    window: tuple  # limits of x and of z that are drawn
    arrows: tuple  # (start, end, name)
    labels: tuple  # (text, place that it names, where it begins)
    limits: tuple | None = None  # of the coordinate
    closed_form: Callable | None = None  # makes (label, coordinate, pressure in MPa)


def one_side(places, coordinate):
    """Of the two sides of a section in plane strain."""
    return np.where(places[:, 1] < 0, coordinate, np.nan)


def flank(places):
    """Distance from the middle of the right flank of the dovetail, towards its foot."""
    along = (places[:, 0] - places[:, 2]) / 2**0.5 - 8.057
    return one_side(places, np.where(places[:, 0] > 0, along, np.nan))


def angle_about(height):
    """From the lowest point, degrees."""
    return lambda places: one_side(places, np.arctan2(places[:, 0], height - places[:, 2]) * TO_DEGREES)


def along_bore(places):
    return np.where((places[:, 0] > 0) & (np.abs(places[:, 1]) < 1e-6), places[:, 2], np.nan)


def along_y(places):
    return np.where(np.abs(places[:, 0]) < 1e-6, places[:, 1], np.nan)


def lame():
    return "Lamé", np.array([-180, 180]), np.array([65.3644, 65.3644])


def hertz():
    """Of the force at the end of the run."""
    force, radius = 5000, 10 * 10.1 / 0.1
    stiffness = 1 / ((1 - 0.3**2) / 210000 + (1 - 0.34**2) / 100000)
    a = (3 * force * radius / (4 * stiffness)) ** (1 / 3)
    x = np.linspace(-a, a, 101)
    return "Hertz, 5000 N", x, 3 * force / (2 * np.pi * a**2) * np.sqrt(np.maximum(0, 1 - (x / a)**2))


PARTS = {
    "dovetail": Part(
        "Dovetail: the ends of the flanks are pressed most", "along a flank, to the foot (mm)",
        (("800 N/mm", 0), ("200 N/mm", 8)), flank, (-17, 17, -19, 15),
        (((0, 6.4), (0, 11), "Fz"),),
        (("blade root", (-2, 3), (-15, 10)), ("disc", (-13, -1), (-16, 4)), ("flank", (6.9, -4.9), (12, 4)),
         ("fillet", (4.3, -2), (6.5, 10)))),
    "shaft_in_hub": Part(
        "Shaft in a hub: Lamé's pressure, and slip all around", "angle around the shaft (degrees)",
        (("ry 0.1°", 0), ("ry −0.1°", 16)), angle_about(15), (-21, 21, -8, 38), (),
        (("core, turned by ry", (1.5, 17.6), (2, 36)), ("shaft", (-5, 20), (-19, 32)), ("hub", (-10, 7), (-19, -5)),
         ("key", (15, 15), (17.5, 22)), ("key", (0, 0), (4, -6))), (-180, 180), lame),
    "bent_shaft": Part(
        "Bent shaft: it slips where it leaves the wheel", "z, on the line x = 10 mm (mm)",
        (("4 kN", 0), ("−4 kN", 9)), along_bore, (-40, 42, -12, 66),
        (((24.8, 7), (34, 7), "Fx"),),
        (("wheel", (-15, 20), (-36, 36)), ("shaft", (-6, 45), (-36, 52)), ("web: held face, Fx", (22, 5), (0, -8)),
         ("bearing", (8, 60), (20, 55)), ("seat", (10, 22), (20, 38)))),
    "pin_in_lug": Part(
        "Pin in a lug: the arc of contact grows with the pull", "angle from the lowest point (degrees)",
        (("4000 N/mm", 0), ("400 N/mm", 12)), angle_about(18), (-38, 38, -4, 74),
        (((0, 61), (0, 70), "Fz"),),
        (("lug", (-12, 50), (-34, 56)), ("pin", (-6, 22), (-35, 32)), ("bolt", (3.3, 20), (24, 40)),
         ("eye", (8.5, 12.5), (26, 6))), (-90, 90)),
    "ball_in_socket": Part(
        "Ball in a socket: more pressure than Hertz' parabolas give", "y, where x = 0 (mm)",
        (("5000 N", 0), ("1000 N", 12)), along_y, (-19, 19, -21, 18),
        (((0, 15), (0, 10.4), "Fz"),),
        (("ball on a stud", (-5, 4), (-18, 14)), ("socket", (5, -8.6), (11, -2)), ("end: held face", (6, 10), (6, 14)),),
        (-5, 5), hertz),
}


class PartRuns(Runs):
    """Runs of prm/parts."""

    def part(self, name):
        return self.run(name, f"../parts/{name}", "Output/Probes=")


def section_cells(geometry):
    """Corners (n, 4, 2) of the cells of a mesh in the plane y = 0, and of their mirror image."""
    mesh = read(geometry["Mesh file"])
    hexahedra = [block.data for block in mesh.cells if block.type == "hexahedron"]
    faces = border_faces(np.concatenate(hexahedra)) if hexahedra else np.concatenate(
        [block.data for block in mesh.cells if block.type == "quad"])
    faces = faces[np.all(np.abs(mesh.points[faces][..., 1]) < 1e-9, axis=1)]
    corners = mesh.points[faces][..., [0, 2]]
    return np.concatenate([corners, corners * [-1, 1]]) if "x0" in geometry["Symmetry surfaces"] else corners


def draw_section(ax, part, run):
    for section, colour in (("Lower geometry", LOWER), ("Geometry", UPPER)):
        ax.add_collection(PolyCollection(section_cells(run.parameters[section]), facecolor=colour, edgecolor="0.35",
                                         linewidth=0.25))
    for start, end, name in part.arrows:
        ax.annotate("", end, start, arrowprops={"arrowstyle": "-|>", "color": RED, "linewidth": 1.6, "shrinkA": 0,
                                                "shrinkB": 0})
        ax.annotate(name, np.add(start, end) / 2, (4, 4) if start[0] == end[0] else (-5, 7),
                    textcoords="offset points", color=RED, va="center")
    for text, place, where in part.labels:
        ax.annotate(text, place, where, fontsize=8, va="center",
                    arrowprops={"arrowstyle": "-", "color": "0.25", "linewidth": 0.6, "shrinkA": 0, "shrinkB": 0,
                                "relpos": (0.5, 0.5)})
    ax.set(aspect="equal", xlabel="x (mm)", ylabel="z (mm)", xlim=part.window[:2], ylim=part.window[2:])
    ax.grid(False)


class Contact:
    """States of a run, the slip amplitudes of its last cycle (µm), and the nodes on the line that is drawn."""

    def __init__(self, run, part):
        last = int(run.history["step"][-1])
        self.states = {label: run.contact(last - before) for label, before in part.states}
        before = int(np.count_nonzero(run.history["cycle"] < run.history["cycle"][-1]))  # steps of earlier cycles
        end = run.contact(last)
        way = end["accumulated_slip"] - run.contact(before)["accumulated_slip"]
        self.amplitudes = 1e3 * way / 4  # a node goes four times its amplitude in a cycle
        along = part.coordinate(end.points)
        self.nodes = np.argsort(along)[:np.count_nonzero(np.isfinite(along))]
        self.along = along[self.nodes]


def draw_contact(axes, part, run):
    contact = Contact(run, part)
    pressure, slip = axes
    for colour, (label, state) in zip((BLUE, RED), contact.states.items()):
        pressure.plot(contact.along, state["pressure"][contact.nodes], color=colour, label=label)
    slip.plot(contact.along, contact.amplitudes[contact.nodes], color="0.2")
    if part.closed_form:
        label, along, values = part.closed_form()
        pressure.plot(along, values, ":", color=GREY, label=label, linewidth=1.6)
    for ax, quantity, room in ((pressure, "pressure (MPa)", 1.4), (slip, "slip amplitude (µm)", 1.1)):
        ax.set(ylabel=quantity, ylim=(0, room * ax.dataLim.y1))
    slip.set(xlabel=part.along, xlim=part.limits)
    pressure.legend(fontsize=7, loc="upper center", ncols=3, handlelength=1.4, columnspacing=1)


def picture_of(name):
    def picture(runs):
        part, run = PARTS[name], runs.part(name)
        figure = plt.figure(figsize=(docs_page.WIDTH, 3.7))
        grid = figure.add_gridspec(2, 2, width_ratios=(1.05, 1))
        draw_section(figure.add_subplot(grid[:, 0]), part, run)
        upper = figure.add_subplot(grid[0, 1])
        draw_contact((upper, figure.add_subplot(grid[1, 1], sharex=upper)), part, run)
        upper.tick_params(labelbottom=False)
        energy = run.cycles["dissipation"][-1]
        per = "/mm" if run.parameters["Geometry"]["Kind"] == "plane strain" else ""
        docs_page.headline(figure, f"{part.title}; {energy:.2g} N mm{per} a cycle")
        return figure
    return picture


def row(runs, name):
    """Largest pressure in the last cycle, largest slip amplitude, energy of the last cycle."""
    run = runs.part(name)
    contact = Contact(run, PARTS[name])
    history, cycles = run.history, run.cycles
    of_cycle = history["cycle"] == history["cycle"].max()
    return (f"| `{name}` | {history['max_pressure'][of_cycle].max():.4g} | {contact.amplitudes.max():.3g} | "
            f"{cycles['dissipation'][-1]:.3g} |\n")


def table(runs):
    head = ("| part | largest pressure, MPa | largest slip amplitude, µm | energy of a cycle, N mm |\n"
            "|---|---|---|---|\n")
    return head + "".join(row(runs, name) for name in PARTS)


def main():
    docs_page.main("parts", __doc__, PartRuns, {f"part_{name}": picture_of(name) for name in PARTS}, {"parts": table})
