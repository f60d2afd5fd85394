# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Friction and slip: the force on the body for slip in every direction, and arrows against the slip."""
import numpy as np

import marks

FORCE, SLIP = "#0072b2", "#c04a00"
N_ARROWS = 16


def turned(points, degrees):
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return points @ np.array([[c, s], [-s, c]])


def ellipse(a, b):
    t = np.linspace(0, 2 * np.pi, 181)
    return np.column_stack([a * np.cos(t), b * np.sin(t)])


def draw_slip_ellipse(ax, friction, largest):
    """To the scale of the friction ellipse where that is near; only its shape matters."""
    p = np.array(friction["p"], dtype=float)
    is_same_scale = 0.1 <= p.max() / largest <= 10
    p *= 1 if is_same_scale else largest / p.max()
    label = f"slip ellipse p = {friction['p'][0]:.4g}, {friction['p'][1]:.4g}"
    ax.plot(*turned(ellipse(*p), friction["angle"]).T, color=SLIP, linewidth=1.2, linestyle="--",
            label=label + ("" if is_same_scale else ", scaled: its shape matters")
            + (" (associated)" if friction["is_associated"] else ""))
    return p.max()


def draw(ax, scene):
    friction = scene["friction"]
    forces = np.array(friction["forces_against_slip"], dtype=float)
    angles = 2 * np.pi * np.arange(len(forces)) / len(forces)
    against = -np.column_stack([np.cos(angles), np.sin(angles)])
    largest = np.hypot(*forces.T).max()
    if friction["mu"]:
        ax.plot(*turned(ellipse(*friction["mu"]), friction["angle"]).T, color=FORCE, linewidth=1.8,
                label=f"friction ellipse μ = {friction['mu'][0]:.4g}, {friction['mu'][1]:.4g}")
        reach = max(largest, draw_slip_ellipse(ax, friction, largest))
    else:
        ax.plot(*np.concatenate([forces, forces[:1]]).T, color=FORCE, linewidth=1.8, label="friction force / pressing force")
        reach = largest
    chosen = spread_along(forces)
    ax.quiver(*forces[chosen].T, *(0.22 * reach * against[chosen]).T, angles="xy", scale_units="xy", scale=1, color="0.25",
              units="inches", width=0.018, zorder=3)
    ax.axhline(0, color="0.8", linewidth=0.7, zorder=0)
    ax.axvline(0, color="0.8", linewidth=0.7, zorder=0)
    marks.set_equal_limits(ax, (-1.35 * reach, -1.9 * reach), (1.35 * reach, 1.35 * reach))
    ax.legend(frameon=False, fontsize=8, loc="lower center", borderaxespad=0)
    is_turned = "normals" in scene["gap"]["contact"]
    where = " at the first touch" if friction["varies"] and not is_turned else ""
    ax.set_title(f"Friction{where}; arrows: against the slip")
    ax.set_xlabel("friction force / pressing force, along " + ("the first axis" if is_turned else "x"))
    ax.set_ylabel("along the second axis" if is_turned else "along y")


def spread_along(forces):
    """Numbers of forces that are about evenly spread along their curve."""
    steps = np.hypot(*(np.roll(forces, -1, axis=0) - forces).T)
    length = np.cumsum(steps)
    return np.unique(np.searchsorted(length, np.linspace(0, length[-1], N_ARROWS, endpoint=False)) % len(forces))
