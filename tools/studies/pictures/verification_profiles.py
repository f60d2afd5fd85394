# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Pressures under other profiles than spheres, and tractions of line contact; of tools/study verification."""
import numpy as np

from answers import Cylinder
from measure import on_line, on_surface
from panels import BLUE, DOTS, GREEN, LINE, label
from spheres import CONE_RADIUS, E_STAR, QUARTIC_RADIUS, of_cone, of_quartic
from strips import ALONG, EDGE, PAIR, THICKNESS


def axisymmetric(name, profile, a, title):
    def panel(runs, ax):
        radius, pressure = on_surface(runs.verified(name), 1, "pressure")
        inside, r = (radius < 1.2 * a) & (radius > 0.02 * a), np.linspace(0.02 * a, a, 600)
        ax.plot(r, profile(r, a), **LINE)
        ax.plot(radius[inside], pressure[inside], **DOTS)
        label(ax, title, "r (mm)", "pressure (MPa)")
    return panel


def rounded_punch(runs, ax):
    run = runs.verified("rounded_punch")
    for step, a, colour, name in ((1, 1.1, BLUE, "orthocone"), (2, 1.25, GREEN, "orthocone, larger force")):
        x, pressure = on_line(run, step, "pressure")
        inside, places = (x >= 0) & (x < 1.4), np.linspace(0, a * (1 - 1e-6), 300)
        ax.plot(places, [EDGE.pressure(place, a) for place in places], **LINE)
        ax.plot(x[inside], pressure[inside], **{**DOTS, "color": colour, "label": name})
    label(ax, "rounded punch", "x (mm)", "pressure (MPa)")


def tractions(name, component, cylinder, force, title, *settings):
    """At the largest force, where it is back at 0, and after the reversal."""
    def panel(runs, ax):
        run = runs.verified(name, *settings)
        places, shear = np.linspace(-cylinder.half_width, cylinder.half_width, 600), force / THICKNESS
        for step, now, colour, when in ((6, shear, BLUE, "at Q"), (10, 0, GREEN, "back at 0"), (14, -shear, "0.4", "at -Q")):
            x, traction = on_line(run, step, "friction_traction")
            inside = np.abs(x) < 1.1 * cylinder.half_width
            ax.plot(places, cylinder.unloaded_traction(places, shear, now), **LINE)
            ax.plot(x[inside], -traction[inside, component],
                    **{**DOTS, "markersize": 2.5, "color": colour, "label": f"orthocone, {when}"})
        label(ax, title, "x (mm)", "traction (MPa)")
    return panel


def line_pressure(runs, ax):
    x, pressure = on_line(runs.verified("line_contact"), 1, "pressure")
    cylinder = Cylinder(906.2287 / THICKNESS, E_STAR)
    inside, places = np.abs(x) < 0.6, np.linspace(-cylinder.half_width, cylinder.half_width, 400)
    ax.plot(places, cylinder.circle(places, cylinder.half_width) / cylinder.mu, **LINE)
    ax.plot(x[inside], pressure[inside], **DOTS)
    label(ax, "pressure (Hertz)", "x (mm)", "pressure (MPa)")


PANELS = (axisymmetric("cone", of_cone, CONE_RADIUS, "cone"),
          axisymmetric("quartic", of_quartic, QUARTIC_RADIUS, "gap 10$^{-4}$ r$^4$"), rounded_punch)
LINES = (line_pressure, tractions("cattaneo_line", 0, PAIR, ALONG, "traction across (Cattaneo)"),
         tractions("orthotropic_line_contact", 1, Cylinder(906.2287 / THICKNESS, E_STAR), 173.9959, "traction along the line",
                   "Mesh/Cells=160, 1, 26", "Mesh/Edge grading=1.05"))
