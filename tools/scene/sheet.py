# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The sheet with the picture of a scene: the bodies, the contact surface, the gap, friction."""
import pathlib
import textwrap

import matplotlib.pyplot as plt
import numpy as np

import contact
import friction
import marks
import section
import space
from parts import Body

WIDTH, HIGH, LOW, HEAD, FOOT = 12.0, 5.6, 3.7, 0.7, 0.4  # inches
MOST_LETTERS = 165  # of a line of the head


def bodies_of(scene, lift):
    return [Body(entry, lift if k == 0 else 0, k == 1) for k, entry in enumerate(scene["bodies"])]


def lift_of(scene):
    """The bodies are drawn apart, so that the contact surface is seen between them."""
    if marks.normals_of(scene) is not None:
        return 0  # there is no direction in which to draw them apart
    points = np.concatenate([body.points() for body in bodies_of(scene, 0)])
    return 0.07 * np.ptp(points, axis=0).max()


def notes(scene, bodies):
    """What the picture leaves out, or has changed."""
    found = ["The bodies are drawn apart."] if marks.normals_of(scene) is None else []
    if any(body.is_half_space for body in bodies):
        found.append("The body is a half-space: a part above its contact surface is drawn, and it has no end.")
    elif not all(body.has_mesh for body in bodies):
        found.append("The mesh of the run is not drawn: it has too many faces, or the run chooses it.")
    if len(scene["model"]["mirrored"]) and (any(scene["model"]["mirrored"]) or scene["model"]["is_axisymmetric"]):
        found.append("Dashed: what symmetry adds to the modelled part.")
    if scene["model"]["thickness"]:
        found.append(f"Forces are those of the thickness of {scene['model']['thickness']:g} mm along y.")
    return " ".join(found)


def head_of(scene):
    material = " ".join(scene["materials"].splitlines()[0].split())
    counterface = [f"counterface: {scene['obstacle']['text']}"] if scene["obstacle"]["text"] else []
    body = scene["bodies"][0]
    words = pathlib.PurePath(body["text"]).name if body["is_from_file"] else body["text"]
    lines = [f"Model: {scene['model']['text']}", "; ".join([words, material, *counterface])]
    return "\n".join(textwrap.shorten(line, MOST_LETTERS, placeholder=" ...") for line in lines)


def panels_of(scene, lift):
    """Functions that draw the panels below the bodies, on axes."""
    apart, together = bodies_of(scene, lift), bodies_of(scene, 0)
    is_section = scene["model"]["is_axisymmetric"] or scene["model"]["is_plane_strain"]
    found = []
    if marks.normals_of(scene) is not None:
        pass  # neither a view from above nor one along x shows such a surface
    elif not is_section:
        found.append(lambda ax: contact.draw_from_above(ax, scene, apart))
    elif all(body.has_mesh for body in together):
        found.append(lambda ax: section.draw_mesh_at_touch(ax, scene, together))
    if lines := contact.profiles(scene):
        found.append(lambda ax: contact.draw_gap(ax, scene, apart, lines))
    if scene["friction"]["forces_against_slip"]:
        found.append(lambda ax: friction.draw(ax, scene))
    return found


def draw(scene, title):
    """The figure, with up to three panels below that of the bodies."""
    lift = lift_of(scene)
    panels = panels_of(scene, lift)
    height = HIGH + LOW + HEAD + FOOT
    figure = plt.figure(figsize=(WIDTH, height))
    figure.text(0.02, 1 - 0.12 / height, title or "The scene before the run", fontsize=13, va="top", fontweight="bold")
    figure.text(0.02, 1 - 0.42 / height, head_of(scene), fontsize=8.5, va="top", color="0.25", linespacing=1.3)
    figure.text(0.02, 0.1 / height, notes(scene, bodies_of(scene, lift)), fontsize=8.5, color="0.25")
    above = figure.add_axes((0.02, (FOOT + LOW) / height, 0.96, HIGH / height - 0.02))
    is_section = scene["model"]["is_axisymmetric"] or scene["model"]["is_plane_strain"]
    (section if is_section else space).draw(above, scene, bodies_of(scene, lift))
    part = 0.98 / max(len(panels), 2)
    for k, panel in enumerate(panels):
        panel(figure.add_axes((0.06 + part * k, (FOOT + 0.55) / height, part - 0.085, (LOW - 1.0) / height)))
    return figure
