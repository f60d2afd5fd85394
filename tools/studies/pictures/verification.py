# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Pictures of prm/verification over the closed forms; with --docs those of docs/verification.md, whose tables
tools/verification makes. Started by tools/study verification."""
import functools
import math

import numpy as np

import docs_page
import verification_import
import verification_wear
import verification_profiles
from answers import Sphere, punch_pressure, punch_slope, radius_of_punch
from measure import on_surface
from panels import DOTS, GREEN, GREY, LINE, RED, label, three_panels
from paper_runs import Runs

Q = 83.99  # N


class VerificationRuns(Runs):
    """Runs of prm/verification."""

    def verified(self, file, *settings):
        name = "-".join([file, *(setting.split("=")[1] for setting in settings)]).replace(" ", "").replace(",", "_")
        return self.run(name, f"../verification/{file}", "Output/Probes=", *settings)


ON_HALF_SPACE = Sphere(97.675, counterface=(70000, 0.33))


def hertz(runs, ax):
    sphere, (radius, pressure) = Sphere(384.615), on_surface(runs.verified("hertz"), 4, "pressure")
    inside, r = radius < 0.6, np.linspace(0, 0.5, 400)
    ax.plot(r, sphere.pressure(r), **LINE)
    ax.plot(radius[inside], pressure[inside], **DOTS)
    radius, pressure = on_surface(runs.verified("hertz_half_space"), 4, "pressure")
    inside = radius < 0.6
    ax.plot(r, ON_HALF_SPACE.pressure(r), **{**LINE, "label": ""})
    ax.plot(radius[inside], pressure[inside], **{**DOTS, "color": GREEN, "label": "on a softer half-space"})
    label(ax, "Hertz: pressure under a sphere", "r in mm", "pressure in MPa")


def mindlin_traction(runs, ax):
    contact = runs.verified("cattaneo_mindlin").contact(10)
    radius, sphere = np.hypot(*contact.points[:, :2].T), Sphere(466.6, poisson=0.4999)
    inside, r = radius < 0.6, np.linspace(0, 0.5, 1000)
    ax.plot(r, sphere.traction(r, Q), **LINE)
    ax.plot(radius[inside], np.abs(contact["friction_traction"][inside, 0]), **DOTS)
    label(ax, "Cattaneo, Mindlin: shear traction at Q = 0.6 $\\mu$P", "r in mm", "|traction along x| in MPa")


def own_shear(runs, sphere):
    """Shift of the body far from the contact, mm: that of the stuck body less that of a stuck patch."""
    stuck = runs.verified("cattaneo_mindlin", "Friction/Coefficients=100,100", "Load program/Legs=Fx 83.99 : 1")
    return stuck.history["ux"][-1] - (2 - sphere.poisson) * Q / (8 * sphere.shear_modulus * sphere.contact_radius)


def mindlin_loop(runs, ax):
    history, sphere = runs.verified("cattaneo_mindlin").history, Sphere(466.6, poisson=0.4999)
    own, shear = own_shear(runs, sphere) / Q, np.linspace(-Q, Q, 300)
    ax.plot(sphere.shift(np.linspace(0, Q, 100)) * 1e3, np.linspace(0, Q, 100), **LINE)
    ax.plot(sphere.unloading_shift(Q, shear) * 1e3, shear, color=RED, linewidth=1.2)
    ax.plot(-sphere.unloading_shift(Q, shear) * 1e3, -shear, color=RED, linewidth=1.2)
    force = -history["force_x"]
    ax.plot((history["ux"] - own * force)[3:] * 1e3, force[3:], **DOTS)
    label(ax, "Mindlin: loop, without the body's own shear", "shift in µm", "tangential force in N")


def flat_punch(runs, ax):
    radius, pressure = on_surface(runs.verified("flat_punch"), 1, "pressure")
    inside, r = radius < 0.985, np.linspace(0, 0.985, 400)
    ax.plot(r, punch_pressure(r, 1000), **LINE)
    ax.plot(radius[inside], pressure[inside], **DOTS)
    label(ax, "Flat punch", "r in mm", "pressure in MPa")


def tilted_punch(runs, ax):
    contact = runs.verified("tilted_punch").contact(1)
    x, y = contact.points[:, :2].T
    line, r = (np.abs(y) < 1e-9) & (np.abs(x) < 0.9), np.linspace(-0.9, 0.9, 400)
    radius = radius_of_punch(contact["pressure"][np.argmin(np.hypot(x, y))], 1000)
    ax.plot(r, punch_pressure(np.abs(r), 1000, radius) * (1 + punch_slope(1000, 1e-4, radius) * r),
            **{**LINE, "label": f"closed form, a = {radius:.3f} mm"})
    ax.plot(x[line], contact["pressure"][line], **DOTS)
    label(ax, "Inclined punch, along the inclination", "x in mm", "pressure in MPa")


def polar(runs, ax):
    for model, style in (("axisymmetric", {"color": RED, "label": "section"}), ("quarter", {**DOTS, "label": "quarter"})):
        run = runs.verified("polar_friction", "Mesh/Degree=3", f"Mesh/Model={model}")
        radius, traction = on_surface(run, 5, "friction_traction")
        ax.plot(radius, np.hypot(*traction.T[:2]), **style)
    label(ax, "Axes of friction along radius and hoop", "r in mm", "friction traction in MPa")


def torsion(runs, ax):
    angles = np.linspace(0, 0.5, 11)
    run = runs.verified("torsion", "Load program/Legs=uz -0.1 : 1 ; rz 0.5 : 10")
    moment = 105000 * math.pi / 2 * 1e4 / 10 * np.radians(angles)
    ax.plot(angles, moment / 1e6, **LINE)
    ax.plot(run.history["rz"], -run.history["moment_z"] / 1e6, **DOTS)
    label(ax, "Torsion of a shaft that sticks", "angle in degrees", "moment in kN m")


def first_slip(runs, ax):
    cells = (2, 4, 8)
    angles = []
    for n in cells:
        run = runs.verified("first_slip_in_torsion", f"Mesh/Core cells={n}", f"Mesh/Rings={n}", "Mesh/Model=full")
        angles.append(0.03 / (1 + on_surface(run, 2, "friction_criterion")[1].max()))
    ax.axhline(math.degrees(6e-4), **LINE)
    ax.plot(cells, angles, **{**DOTS, "linestyle": "--"})
    ax.set_xticks(cells)
    label(ax, "First slip of the twisted shaft, at its rim", "core cells = rings", "angle in degrees")


def gross_sliding(runs, ax):
    direction, mu = np.radians(np.linspace(0, 90, 200)), (0.8, 0.4)
    for p, colour, name in (((0.8, 0.4), RED, "associated"), ((1, 1), GREEN, "collinear")):
        along = -np.array([p[0]**2 * np.cos(direction), p[1]**2 * np.sin(direction)])
        along /= np.hypot(along[0] / mu[0], along[1] / mu[1])
        ax.plot([], [], "o", color=colour, markerfacecolor="none" if name == "collinear" else colour, label=name)
        for angle in (15, 45, 75):
            legs = f"0 0 -0.01 : 1 ; {math.cos(math.radians(angle)):.6g} {math.sin(math.radians(angle)):.6g} -0.01 : 20"
            history = runs.verified("gross_sliding", f"Friction/Slip potential={p[0]}, {p[1]}",
                                    f"Load program/Legs={legs}").history
            ax.plot(-history["force_x"][-1] / history["force_z"][-1], -history["force_y"][-1] / history["force_z"][-1],
                    "o", color=colour, markersize=5, markerfacecolor="none" if name == "collinear" else colour)
            ax.plot(*(np.interp(math.radians(angle), direction, -part) for part in along), "+", color="0.2", markersize=9)
    history = runs.verified("gross_sliding_by_force").history
    ax.plot(-history["force_x"][-1] / history["force_z"][-1], -history["force_y"][-1] / history["force_z"][-1], "s",
            color=RED, markersize=10, markerfacecolor="none", label="associated, F_z given")
    ax.set_aspect("equal")
    angle = np.linspace(0, math.pi / 2, 100)
    ax.plot(mu[0] * np.cos(angle), mu[1] * np.sin(angle), color=GREY, linewidth=1, label="friction ellipse")
    ax.plot([], [], "+", color="0.2", markersize=9, label="closed form")
    label(ax, "Gross sliding along 15°, 45°, 75°", "force_x / force_z", "force_y / force_z")


def pressed_by_force(runs, ax):
    history = runs.verified("pressed_by_force").history
    legs = " ; ".join(f"Fz {-f!r} ux {u!r} : 1" for f, u in zip(history["force_z"].tolist(), history["ux"].tolist()))
    by_force = runs.run("pressed-by-force", "../verification/pressed_by_force", "Output/Probes=",
                        f"Load program/Legs={legs}").history
    ax.plot(range(1, 10), -history["uz"] * 1e3, color=RED, label="driven by the motion")
    ax.plot(range(1, 10), -by_force["uz"] * 1e3, **{**DOTS, "label": "driven by its force"})
    label(ax, "The same press by motion and by force", "load step", "-uz in µm")


def box(runs, ax):
    contact = runs.verified("box").contact(2)
    x, slip = contact.points[:, 0], contact["slip"][:, 0]
    line = np.array([-10, 10])
    ax.plot(line, 0.3 / 210 * line * 1e3, **LINE)
    ax.plot(x, slip * 1e3, **DOTS)
    label(ax, "Box under 240 kN: lateral strain at its base", "x in mm", "slip along x in µm")


def patch(runs, ax):
    radius, slip = on_surface(runs.verified("patch_test"), 1, "slip_magnitude")
    ax.plot([0, 10], [0, 30], **LINE)
    ax.plot(radius, slip * 1e3, **DOTS)
    label(ax, "Patch test: lateral strain at the base", "r in mm", "slip in µm")


PICTURES = {"verification_spheres": (hertz, mindlin_traction, mindlin_loop),
            "verification_profiles": verification_profiles.PANELS,
            "verification_lines": verification_profiles.LINES,
            "verification_places": (flat_punch, tilted_punch, polar),
            "verification_turns": (torsion, first_slip, gross_sliding),
            "verification_bodies": (pressed_by_force, box, patch),
            "verification_wear": verification_wear.PANELS}


def of_panels(runs, panels):
    figure, axes = three_panels()
    for draw, ax in zip(panels, axes):
        draw(runs, ax)
    return figure


def main():
    pictures = {name: functools.partial(of_panels, panels=panels) for name, panels in PICTURES.items()}
    docs_page.main("verification", __doc__, VerificationRuns, {**pictures, "import": verification_import.picture})
