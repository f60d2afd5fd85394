# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Makes prm/verification/ball_above.msh and ball_below.msh: quarters of blocks whose inner ends are caps of spheres.

Usage: ball_mesh.py above|below > prm/verification/ball_NAME.msh

The caps touch in the origin. Cells are even up to 0.6 mm (0.75 mm below) and grow from there."""
import itertools
import math
import sys

WIDTH, HEIGHT, GROWTH = 4.0, 8.0, 1.7  # mm, and from cell to cell
GROUPS = {1: "cap", 2: "around", 3: "held", 4: "x0", 5: "y0", 6: "ball"}
# Radius of the sphere, side of the square that touches and number of its cells, side of the body by that of the scene.
BALLS = {"above": (10.0, 0.6, 7, 1), "below": (15.0, 0.75, 6, -1)}


def line(first, cells, end):
    """Places of `cells` even cells up to `first`, and of growing ones up to `end`."""
    sizes = [first / cells * GROWTH**(i + 1) for i in itertools.takewhile(
        lambda n: first + sum(first / cells * GROWTH**(k + 1) for k in range(n)) < end, itertools.count())]
    scale = (end - first) / sum(sizes)
    return [first * i / cells for i in range(cells + 1)] + [first + scale * sum(sizes[:i + 1]) for i in range(len(sizes))]


def text(name):
    """Of a file in Gmsh's format 2.2."""
    radius, side, cells, up = BALLS[name]
    across, over = line(side, cells, WIDTH), line(side / cells, 1, HEIGHT)
    n, m = len(across), len(over)
    nodes = []
    for h, y, x in itertools.product(over, across, across):
        cap = radius - math.sqrt(radius**2 - x**2 - y**2)
        nodes.append((x, y, up * (cap + h * (1 - cap / HEIGHT))))

    def corner(i, j, k):
        return 1 + i + n * (j + n * k)

    elements = []
    for i, j, k in itertools.product(range(n - 1), range(n - 1), range(m - 1)):
        low = [corner(i, j, k), corner(i + 1, j, k), corner(i + 1, j + 1, k), corner(i, j + 1, k)]
        high = [corner(i, j, k + 1), corner(i + 1, j, k + 1), corner(i + 1, j + 1, k + 1), corner(i, j + 1, k + 1)]
        elements.append((5, 6, low + high if up > 0 else high + low))
        if k == 0:
            elements.append((3, 1 if max(i, j) < cells else 2, low))
        if k == m - 2:
            elements.append((3, 3, high))
        if i == 0:
            elements.append((3, 4, [low[0], low[3], high[3], high[0]]))
        if j == 0:
            elements.append((3, 5, [low[0], low[1], high[1], high[0]]))
    names = [f'{3 if group == 6 else 2} {group} "{word}"' for group, word in GROUPS.items()]
    lines = [f"{number} {kind} 2 {group} {group} {' '.join(map(str, corners))}"
             for number, (kind, group, corners) in enumerate(elements, 1)]
    places = [f"{number} {x:.10g} {y:.10g} {z:.16g}" for number, (x, y, z) in enumerate(nodes, 1)]
    return "\n".join(["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(names)), *names, "$EndPhysicalNames",
                      "$Nodes", str(len(places)), *places, "$EndNodes", "$Elements", str(len(lines)), *lines, "$EndElements", ""])


if __name__ == "__main__":
    print(text(sys.argv[1]), end="")
