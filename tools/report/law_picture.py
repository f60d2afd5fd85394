# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Drawings of the friction law: forces at the limit of friction, per unit normal force, and the slip against each. Two
ellipses, or the curve of a table."""
import math

import numpy as np
import svg
from drawing import HEIGHT, WIDTH, Frame
from rosette_curve import Curve

LEGEND = HEIGHT - 34
N_ARROWS = 24
ASSOCIATED = 2  # degrees off the normal of the curve, which rows of a table with few digits may leave
MOST_DOTS, MOST_WORDS = 120, 42


def turned(points, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return [(c * x - s * y, s * x + c * y) for x, y in points]


def ellipse(a, b, n=96):
    return [(a * math.cos(2 * math.pi * k / n), b * math.sin(2 * math.pi * k / n)) for k in range(n)]


def axis_lines(frame, reach, angle):
    """The axes of orthotropy, 1 and 2, if they are turned, else x and y."""
    names = ("x", "y") if angle % 360 == 0 else ("1", "2")
    out = ""
    x, y = frame.origin
    for direction, name in zip(turned([(1, 0), (0, 1)], angle), names):
        end = frame(x + reach * direction[0], y + reach * direction[1])
        start = frame(x - reach * direction[0], y - reach * direction[1])
        out += svg.arrow(start, end, "axis")
        out += svg.text((end[0] + 9 * direction[0], end[1] - 9 * direction[1] + 4), name, "label")
    return out


def slip_arrow(frame, force, way, length, angle):
    """From a force, `length` along the direction opposite to its slip."""
    size = math.hypot(*way)
    tip = (force[0] + length * way[0] / size, force[1] + length * way[1] / size)
    force, tip = turned([force, tip], angle)
    return svg.arrow(frame(*force), frame(*tip), "slip-arrow", head=5)


def key(k, css, words):
    """A line of the legend."""
    y = LEGEND + 15 * k
    return svg.line((40, y - 4), (62, y - 4), css) + svg.text((68, y), words, "small", "start")


def last_line(data, words):
    where = "; at the centre" if data.friction_varies and not data.measured.varies else ""
    where += "; for the factor 1" if data.has_factor else ""
    return svg.text((WIDTH / 2, HEIGHT - 4), f"{words}{where}; arrow at a force: opposite to its slip", "small")


# --- ellipses ---

def ellipses(data):
    largest_mu, largest_p = max(data.mu), max(data.p)
    same_scale = 0.1 <= largest_p / largest_mu <= 10
    factor = 1 if same_scale else largest_mu / largest_p
    p = (data.p[0] * factor, data.p[1] * factor)
    reach = max(largest_mu, max(p))
    frame = Frame(106 / reach, (WIDTH / 2, HEIGHT / 2 - 15))
    out = axis_lines(frame, 1.24 * reach, data.angle)
    out += svg.polyline(frame.all(turned(ellipse(*p), data.angle)), "slip-ellipse", closed=True)
    out += svg.polyline(frame.all(turned(ellipse(*data.mu), data.angle)), "friction-ellipse", closed=True)
    for x, y in ellipse(*data.mu, n=16):
        out += slip_arrow(frame, (x, y), (x / data.p[0]**2, y / data.p[1]**2), 0.16 * reach, data.angle)
    associated = math.isclose(data.mu[0] * data.p[1], data.mu[1] * data.p[0], rel_tol=1e-9)
    out += key(0, "friction-ellipse", f"friction ellipse \u03bc = ({data.mu[0]:g}, {data.mu[1]:g})")
    out += key(1, "slip-ellipse", f"slip ellipse p = ({data.p[0]:g}, {data.p[1]:g})"
               + ("" if same_scale else ", scaled: only its shape matters"))
    out += last_line(data, "associated" if associated else "non-associated")
    return svg.picture(WIDTH, HEIGHT, out, "Friction ellipse and slip ellipse, to the same scale" if same_scale
                       else "Friction ellipse and slip ellipse")


# --- a table ---

def measured(data, words, table):
    curve = Curve(table, 360)
    reach = 1.05 * curve.size.max()
    frame = Frame(106 / reach, (WIDTH / 2, HEIGHT / 2 - 15))
    out = axis_lines(frame, 1.24 * reach, data.angle)
    out += svg.polyline(frame.all(turned(curve.forces.tolist(), data.angle)), "friction-ellipse", closed=True)
    for angle in np.linspace(0, 2 * math.pi, N_ARROWS, endpoint=False):
        row = np.argmin(np.abs(curve.angles - angle))
        out += slip_arrow(frame, tuple(curve.forces[row].tolist()), (math.cos(angle), math.sin(angle)), 0.16 * reach, data.angle)
    if len(table) <= MOST_DOTS:
        for x, y in turned(table.forces.tolist(), data.angle):
            x, y = frame(x, y)
            out += svg.element("circle", cx=x, cy=y, r=2, css="row-of-table")
    out += key(0, "friction-ellipse", words if len(words) <= MOST_WORDS else words[:MOST_WORDS - 1] + "\u2026")
    out += svg.text((68, LEGEND + 15), f"\u03bc along {span(curve.along)}, across {span(curve.across)}", "small", "start")
    departure = np.degrees(np.abs(curve.departures())).max()
    out += last_line(data, "associated" if departure < ASSOCIATED else f"up to {departure:.0f}\u00b0 off the normal")
    return svg.picture(WIDTH, HEIGHT, out, f"Friction force at its limit, and the slip against it: {words}")


def span(values):
    low, high = (svg.signed(float(f"{value:.2g}") + 0.) for value in (values.min(), values.max()))
    return low if low == high else f"{low} to {high}"


def figures(data):
    """(caption, SVG) of the law; none without friction, or where it is not known."""
    if any(data.mu or ()):
        return [("Ellipses of friction and slip", ellipses(data))]
    caption = ("Measured friction" if data.law == "rosette" else "Friction") + ", per unit normal force"
    return [(caption, measured(data, words, table)) for words, table in data.measured.tables]
