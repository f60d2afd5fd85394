# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Makes prm/verification/incline.msh and groove.msh: prisms along y whose lower sides are a slope, or two flanks.

Usage: prism_mesh.py incline|groove > prm/verification/NAME.msh"""
import itertools
import sys

HALF_WIDTH, LENGTH, TOP = 5.0, 8.0, 6.0  # mm
SLOPE = 0.1
FLANK, FLAT = 0.75, 1.0  # rise of the flanks of a groove with sides of 3 : 4 : 5, and half of the flat between them, mm
GROUPS = {1: "left", 2: "right", 3: "slope", 4: "top", 5: "prism"}
# Places across, height of the lower side there, and the surface right of each.
SHAPES = {"incline": [(x, SLOPE * x, 3) for x in (-5, -2.5, 0, 2.5, 5)],
          "groove": [(x, FLANK * max(abs(x), FLAT), 1 if x < -FLAT else 2 if x >= FLAT else 0) for x in (-5, -3, -1, 1, 3, 5)]}


def text(name):
    """Of a file in Gmsh's format 2.2: two cells along y and over the height."""
    profile = SHAPES[name]
    n, m, layers = len(profile), 3, 3
    nodes = [(x, LENGTH * j / 2 - LENGTH / 2, low + (TOP - low) * k / 2)
             for k in range(layers) for j in range(m) for x, low, _ in profile]

    def corner(i, j, k):
        return 1 + i + n * (j + m * k)

    def square(i, j, k):
        return [corner(i, j, k), corner(i + 1, j, k), corner(i + 1, j + 1, k), corner(i, j + 1, k)]

    elements = []
    for i, j in itertools.product(range(n - 1), range(m - 1)):
        if profile[i][2]:
            elements.append((3, profile[i][2], square(i, j, 0)))
        elements.append((3, 4, square(i, j, layers - 1)))
    elements += [(5, 5, square(i, j, k) + square(i, j, k + 1))
                 for i, j, k in itertools.product(range(n - 1), range(m - 1), range(layers - 1))]
    used = sorted({group for _, group, _ in elements})
    groups = [f'{3 if group == 5 else 2} {group} "{GROUPS[group]}"' for group in used]
    lines = [f"{number} {kind} 2 {group} {group} {' '.join(map(str, corners))}"
             for number, (kind, group, corners) in enumerate(elements, 1)]
    places = [f"{number} {x:g} {y:g} {z:.12g}" for number, (x, y, z) in enumerate(nodes, 1)]
    return "\n".join(["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(groups)), *groups, "$EndPhysicalNames",
                      "$Nodes", str(len(places)), *places, "$EndNodes", "$Elements", str(len(lines)), *lines, "$EndElements", ""])


if __name__ == "__main__":
    print(text(sys.argv[1]), end="")
