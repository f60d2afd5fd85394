# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Drawings of the model: contact surface from above, friction law, cylinder from the side."""
import checked
import law_picture
import numpy as np
import surface_picture
import svg
from drawing import HEIGHT, WIDTH, Frame, area_of, counterface, ground, hatched, inside, load_words, shortened, two_parts
from half_space_picture import half_space_view
from imported_picture import imported_view
from law_picture import axis_lines
from lower_picture import Block, lower_of
from outline import clipped

MOST_DRAWN_CELLS = 5000


# --- the contact surface from above ---

def mesh_edges(mesh, node_of_point):
    """Every edge of the cells once, as points."""
    inner = mesh.degree - 1
    ends = ((0, 1), (1, 2), (3, 2), (0, 3))
    seen, edges = set(), []
    for cell in mesh.cells:
        for k, (first, last) in enumerate(ends):
            key = frozenset((node_of_point[cell[first]], node_of_point[cell[last]]))
            if key not in seen:
                seen.add(key)
                between = cell[4 + k * inner:4 + (k + 1) * inner]
                edges.append(mesh.points[[cell[first], *between, cell[last]], :2])
    return edges


def modelled_part(data, frame):
    """Shade over the half or quarter that was computed, a line where it is a section."""
    model = data.summary.get("model", {})
    kind = model.get("kind")
    if kind == "axisymmetric":
        return svg.line(frame(0, 0), frame(data.radius, 0), "section")
    if kind not in ("half", "quarter"):
        return ""
    # Older summaries do not name the plane: a half has that along which the top does not move.
    planes = model.get("symmetry_planes", ["x = 0" if "uy" in data.program.extremes() else "y = 0"])
    part = data.outline
    for axis, plane in enumerate(("x = 0", "y = 0")):
        if kind == "quarter" or plane in planes:
            part = [clipped(polygon, axis) for polygon in part]
    return area_of(frame, part, "modelled")


def mesh_lines(data, frame):
    """Lines of the cells, and what is said of them."""
    mesh = data.maps.mesh
    if not mesh:
        return "", "no contact fields, so no mesh"
    note = (f"{data.summary['model']['cells']} patches" if data.sheet and "model" in data.summary
            else f"{len(mesh.cells)} cells of degree {mesh.degree}")
    if len(mesh.cells) > MOST_DRAWN_CELLS:
        return "", note + ", too many to be drawn"
    path = "".join("M" + "L".join(f"{svg.number(a)} {svg.number(b)}" for a, b in frame.all(edge))
                   for edge in mesh_edges(mesh, data.maps.node_of_point))
    return svg.element("path", d=path, css="mesh"), note


def probes(data, frame):
    out = ""
    for name, place in data.probe_places.items():
        x, y = frame(*place)
        out += svg.element("circle", cx=x, cy=y, r=4, css="probe")
        # On the side of the centre there is room for it.
        side, anchor = (-7, "end") if x > WIDTH / 2 else (7, "start")
        out += inside((x + side, y - 6), shortened(name), "label halo", anchor)
    return out


def size_of(data):
    """Of the contact surface, in words."""
    if not data.outline:
        return "nor outline"
    if data.shape == "cylinder":
        return f"radius {data.radius:g} mm"
    points = np.concatenate(data.outline)
    if data.sheet:
        return f"{data.sheet[0]:g} mm x {data.sheet[1]:g} mm"
    x, y = points.max(axis=0) - points.min(axis=0)
    return f"{x:.4g} mm x {y:.4g} mm"


def surface(data):
    frame = Frame(128 / data.radius, origin=data.centre)
    mesh, note = mesh_lines(data, frame)
    out = area_of(frame, data.outline, "disc") + modelled_part(data, frame) + mesh
    out += axis_lines(frame, 1.14 * data.radius, data.angle) + probes(data, frame)
    out += svg.text((WIDTH / 2, HEIGHT - 4), f"{note}; {size_of(data)}", "small")
    return svg.picture(WIDTH, HEIGHT, out, "Contact surface from above, with mesh, axes and probes")


# --- the cylinder from the side ---

def layer_heights(n, grading):
    """Heights of the layer planes / total height; a layer is `grading` times its neighbour towards mid-height."""
    thickness = np.array([grading**abs(k - (n - 1) / 2) for k in range(n)])
    return np.concatenate([[0], np.cumsum(thickness) / thickness.sum()])


def load_arrows(data, left, right, y):
    """The largest motion or load of the top in each component, as the legs state it."""
    largest = data.program.extremes()
    words = load_words(largest)
    middle, out = (left + right) / 2, ""
    normal = [name for name in ("uz", "Fz") if name in words]
    if normal:
        ends = ((middle, y - 44), (middle, y - 11))
        out += svg.arrow(*(ends if largest[normal[0]] < 0 else ends[::-1]), "load", head=11)
        out += inside((middle + 9, y - 28), ", ".join(words.pop(name) for name in normal), "label", "start")
    sideways = list(words.values())
    if sideways:
        forward = largest[next(iter(words))] > 0
        start, end = (left - 6, left - 44) if not forward else (left - 44, left - 6)
        out += svg.arrow((start, y + 2), (end, y + 2), "load", head=11)
        for k, words in enumerate(sideways):
            out += svg.text((4, y - 10 - 14 * (len(sideways) - 1 - k)), words, "label", "start")
    return out


def layer_lines(data, frame, width):
    """Lines between the layers of cells, and the number of layers."""
    mesh = data.parameters.get("Mesh", {})
    layers = mesh["Cells"].split(",")[2].strip() if data.box else mesh.get("Layers", "1")
    heights = data.height * layer_heights(*checked.layers(layers, mesh.get("Layer grading", 1)))[1:-1]
    return "".join(svg.line(frame(-width / 2, z), frame(width / 2, z), "mesh") for z in heights), layers


def side_view(data, below):
    """`below` is a second body of lower_picture.py, or None."""
    width = data.box[0] if data.box else 2 * data.size("Radius")
    least, largest = np.array([-width / 2, 0]), np.array([width / 2, data.height])
    if below:
        least, largest = np.minimum(least, below.low), np.maximum(largest, below.high)
    scale = min(np.array([205, 190]) / (largest - least))
    frame = Frame(scale, (WIDTH / 2 - 12, HEIGHT / 2 + 15), (least + largest) / 2)
    (left, base), (right, top) = frame(-width / 2, 0), frame(width / 2, data.height)
    middle, bottom = (left + right) / 2, frame(0, least[1])[1]
    lines, layers = layer_lines(data, frame, width)
    out = svg.element("rect", x=left, y=top, width=right - left, height=base - top, css="disc") + lines
    guided, is_free = (data.parameters.get("Geometry", {}).get("Top face") == kind for kind in ("guided", "free"))
    if not is_free:
        out += hatched((left - 3, top), (right + 3, top), "plate", down=False)
    if below:
        out += below.drawing(frame) + below.height_beside(frame, max(right, frame(below.high[0], 0)[0]) + 8)
    else:
        out += ground(data, (left - 40, base), (right + 40, base))
    out += load_arrows(data, left, right, top - 8)
    out += surface_picture.marks(data, surface_picture.Sides((left, base), (right, top)))
    if isinstance(below, Block):
        out += surface_picture.marks(data, surface_picture.Sides(frame(*below.low), frame(*below.high), -1), is_lower=True)
    out += svg.text((middle, (base + top) / 2 + 4), f"{layers} layers", "label halo")
    out += inside((right + 8, 0.62 * base + 0.38 * top + 4), f"H = {data.height:.5g} mm", "label", "start")
    out += two_parts(WIDTH / 2, bottom + 24, f"{'l_x' if data.box else '2R'} = {width:g} mm", counterface(data))
    top_face = ("free" if is_free else "guided: free sideways" if guided else "clamped: a rigid plate")
    out += svg.text((WIDTH / 2, HEIGHT - 4), f"top face {top_face}; arrows: the largest", "small")
    listed, height = surface_picture.list_below(data, HEIGHT - 4)
    return svg.picture(WIDTH, height + 4, out + listed, "The body from the side, with layers, counterface and motion of the held face")


def views_from_the_side(data):
    below = lower_of(data)
    if data.has_lower and below is None:
        data.notes.append("The lower body is not drawn: its mesh file is not where the run has found it.")
    if data.sheet:
        return [("Half-space, from the side", half_space_view(data, load_arrows))]
    if data.shape != "file":
        return [(f"{'Box' if data.box else 'Cylinder'}, from the side", side_view(data, below))]
    if data.body is None:
        data.notes.append("The body is not drawn: its mesh file is not where the run has found it.")
        return []
    return [("The body from the side", imported_view(data, data.body, below))]


def figures(data):
    """(caption, SVG) of each drawing."""
    return [("Contact surface, from above", surface(data)), *law_picture.figures(data),
            *views_from_the_side(data)]
