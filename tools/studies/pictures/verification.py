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
from measure import along_x, on_surface
from panels import BLUE, DOTS, GREEN, GREY, LINE, RED, entries, label
from paper_runs import Runs

plt = docs_page.plt
Q = 83.99  # N
MU = (0.8, 0.4)  # of gross sliding


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
    x, pressure = along_x(runs.verified("hertz_half_space"), 4, "pressure")
    inside = x < 0.6
    ax.plot(r, ON_HALF_SPACE.pressure(r), **LINE)
    ax.plot(x[inside], pressure[inside], **{**DOTS, "color": GREEN, "label": "orthocone, softer half-space"})
    label(ax, "pressure (Hertz)", "r (mm)", "pressure (MPa)")


def mindlin_traction(runs, ax):
    x, traction = along_x(runs.verified("cattaneo_mindlin"), 10, "friction_traction")
    sphere = Sphere(466.6, poisson=0.4999)
    inside, r = x < 0.6, np.linspace(0, 0.5, 1000)
    ax.plot(r, sphere.traction(r, Q), **LINE)
    ax.plot(x[inside], np.abs(traction[inside, 0]), **DOTS)
    label(ax, "shear traction (Cattaneo)", "x (mm)", "traction along x (MPa)")


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
    label(ax, "loop (Mindlin)", "shift (µm)", "tangential force (N)")


def flat_punch(runs, ax):
    radius, pressure = on_surface(runs.verified("flat_punch"), 1, "pressure")
    inside, r = radius < 0.985, np.linspace(0, 0.985, 400)
    ax.plot(r, punch_pressure(r, 1000), **LINE)
    ax.plot(radius[inside], pressure[inside], **DOTS)
    label(ax, "flat punch", "r (mm)", "pressure (MPa)")


def tilted_punch(runs, ax):
    contact = runs.verified("tilted_punch").contact(1)
    x, y = contact.points[:, :2].T
    line, r = (np.abs(y) < 1e-9) & (np.abs(x) < 0.9), np.linspace(-0.9, 0.9, 400)
    radius = radius_of_punch(contact["pressure"][np.argmin(np.hypot(x, y))], 1000)
    ax.plot(r, punch_pressure(np.abs(r), 1000, radius) * (1 + punch_slope(1000, 1e-4, radius) * r),
            **LINE)
    ax.plot(x[line], contact["pressure"][line], **DOTS)
    label(ax, "inclined punch", "x (mm)", "pressure (MPa)")


def polar(runs, ax):
    for model, style in (("axisymmetric", {"color": GREEN, "label": "orthocone, axisymmetric"}), ("quarter", {**DOTS})):
        run = runs.verified("polar_friction", "Mesh/Degree=3", f"Mesh/Model={model}")
        radius, traction = on_surface(run, 5, "friction_traction")
        ax.plot(radius, np.hypot(*traction.T[:2]), **style)
    label(ax, "turned surface", "r (mm)", "friction traction (MPa)")


def torsion(runs, ax):
    angles = np.linspace(0, 0.5, 11)
    run = runs.verified("torsion", "Load program/Legs=uz -0.1 : 1 ; rz 0.5 : 10")
    moment = 105000 * math.pi / 2 * 1e4 / 10 * np.radians(angles)
    ax.plot(angles, moment / 1e6, **LINE)
    ax.plot(run.history["rz"], -run.history["moment_z"] / 1e6, **DOTS)
    label(ax, "moment of a shaft that sticks", "angle (degrees)", "moment (kN m)")


def first_slip(runs, ax):
    cells = (2, 4, 8)
    angles = []
    for n in cells:
        run = runs.verified("first_slip_in_torsion", f"Mesh/Core cells={n}", f"Mesh/Rings={n}", "Mesh/Model=full")
        angles.append(0.03 / (1 + on_surface(run, 2, "friction_criterion")[1].max()))
    ax.plot(cells, 100 * (1 - np.array(angles) / math.degrees(6e-4)), "o-", color=BLUE)
    ax.set(ylim=(0, None), xticks=cells)
    label(ax, "angle of the first slip", "core cells, and as many rings", "below closed form (%)")


def ratios(history):
    """Of the tangential forces to the normal force in the last step."""
    return [-history[f"force_{axis}"][-1] / history["force_z"][-1] for axis in "xy"]


def draw_direction(runs, ax, p, look):
    """The motion along 15, 45 and 75 degrees, and the forces that the slip rule gives."""
    for angle in np.radians((15, 45, 75)):
        legs = f"0 0 -0.01 : 1 ; {math.cos(angle):.6g} {math.sin(angle):.6g} -0.01 : 20"
        ax.plot(*ratios(runs.verified("gross_sliding", f"Friction/Slip potential={p[0]}, {p[1]}",
                                      f"Load program/Legs={legs}").history), linestyle="none", **look)
        along = np.array([p[0]**2 * math.cos(angle), p[1]**2 * math.sin(angle)])
        ax.plot(*along / np.hypot(along[0] / MU[0], along[1] / MU[1]), "+", color="black", markersize=9,
                label="closed form of the slip rule")


def gross_sliding(runs, ax):
    draw_direction(runs, ax, (0.8, 0.4), {"marker": "o", "color": RED, "label": "associated slip"})
    draw_direction(runs, ax, (1, 1), {"marker": "o", "color": GREEN, "markerfacecolor": "none", "markersize": 6,
                                      "label": "collinear slip"})
    ax.plot(*ratios(runs.verified("gross_sliding_by_force").history), "s", color=RED, markersize=10, markerfacecolor="none",
            label="associated slip, normal force given")
    ax.set_aspect("equal")
    angle = np.linspace(0, math.pi / 2, 100)
    ax.plot(MU[0] * np.cos(angle), MU[1] * np.sin(angle), color=GREY, linewidth=1, label="friction ellipse")
    label(ax, "gross sliding along 15°, 45° and 75°", "$F_x / F_z$", "$F_y / F_z$")


def pressed_by_force(runs, ax):
    history = runs.verified("pressed_by_force").history
    legs = " ; ".join(f"Fz {-f!r} ux {u!r} : 1" for f, u in zip(history["force_z"].tolist(), history["ux"].tolist()))
    by_force = runs.run("pressed-by-force", "../verification/pressed_by_force", "Output/Probes=",
                        f"Load program/Legs={legs}").history
    ax.plot(range(1, 10), -history["uz"] * 1e3, color=GREEN, label="orthocone, driven by the motion")
    ax.plot(range(1, 10), -by_force["uz"] * 1e3, **DOTS)
    label(ax, "press by motion and by force", "load step", "motion of the top (µm)")


def box(runs, ax):
    contact = runs.verified("box").contact(2)
    x, slip = contact.points[:, 0], contact["slip"][:, 0]
    line = np.array([-10, 10])
    ax.plot(line, 0.3 / 210 * line * 1e3, **LINE)
    ax.plot(x, slip * 1e3, **DOTS)
    label(ax, "box under 240 kN", "x (mm)", "slip along x (µm)")


def patch(runs, ax):
    radius, slip = on_surface(runs.verified("patch_test"), 1, "slip_magnitude")
    ax.plot([0, 10], [0, 30], **LINE)
    ax.plot(radius, slip * 1e3, **DOTS)
    label(ax, "patch test", "r (mm)", "slip (µm)")


# Headline and panels of each picture.
PICTURES = {"verification_spheres": ("Pressed and sheared spheres follow Hertz, Cattaneo and Mindlin",
                                     (hertz, mindlin_traction, mindlin_loop)),
            "verification_profiles": ("Pressures follow the closed form up to the edge", verification_profiles.PANELS),
            "verification_lines": ("Line contact follows Hertz and Cattaneo through a cycle", verification_profiles.LINES),
            "verification_places": ("Punches press most at their edge, and section and quarter agree",
                                    (flat_punch, tilted_punch, polar)),
            "verification_turns": ("Shafts stick and slip, and bodies slide, as the closed forms say",
                                   (torsion, first_slip, gross_sliding)),
            "verification_bodies": ("Motion and force lead to the same state, and even states are exact",
                                    (pressed_by_force, box, patch)),
            "verification_wear": ("Wear ends in the shapes that are known", verification_wear.PANELS)}
WIDE = ("verification_turns",)  # the last panel has a row of its own


def of_panels(runs, name):
    """Three panels, with the entries of all below."""
    message, panels = PICTURES[name]
    places = [["first", "second"], ["third", "third"]] if name in WIDE else [["first", "second", "third"]]
    figure, axes = plt.subplot_mosaic(places, figsize=(docs_page.WIDTH, 5.8 if name in WIDE else 3))
    for draw, ax in zip(panels, axes.values()):
        draw(runs, ax)
    docs_page.legend_below(figure, *entries(axes.values()), 3)
    docs_page.headline(figure, message)
    return figure


def main():
    pictures = {name: functools.partial(of_panels, name=name) for name in PICTURES}
    docs_page.main("verification", __doc__, VerificationRuns, {**pictures, "import": verification_import.picture})
