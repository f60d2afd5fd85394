# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Drawing of a half-space from the side: the part above the grid of patches, without an end above and beside it."""
import svg
from drawing import HEIGHT, WIDTH, counterface, ground, two_parts

HALF_WIDTH, DEPTH = 82, 88  # pixels; what lies beyond is as far as one likes


def half_space_view(data, load_arrows):
    l_x, l_y = data.sheet
    middle, base = WIDTH / 2 - 12, HEIGHT / 2 + 60
    left, right, top = middle - HALF_WIDTH, middle + HALF_WIDTH, base - DEPTH
    out = svg.element("rect", x=left, y=top, width=right - left, height=base - top, css="side")
    out += svg.line((left, base), (right, base), "rim")
    out += ground(data, (left - 40, base), (right + 40, base))
    out += load_arrows(data, left, right, top - 8)
    periodic = data.parameters["Geometry"].get("Periodic", "no") == "yes"
    out += svg.text((middle, (base + top) / 2 + 4), "periodic half-space" if periodic else "half-space", "label halo")
    out += two_parts(WIDTH / 2, base + 24, f"l_x = {l_x:g} mm, l_y = {l_y:g} mm", counterface(data))
    out += svg.text((WIDTH / 2, HEIGHT - 4), "held in the far field; arrows: the largest", "small")
    return svg.picture(WIDTH, HEIGHT, out, "The half-space from the side, with counterface and motion of the far field")
