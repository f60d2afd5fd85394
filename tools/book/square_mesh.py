# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Makes prm/verification/pressed_square.msh: a quarter of a block whose top has a square with a name of its own.

Usage: square_mesh.py > prm/verification/pressed_square.msh"""
import itertools

HALF, CELLS, RATIO, REACH = 0.5, 3, 1.45, 8.0  # half a side (mm), its cells, their growth outside, and how far they go
GROUPS = {1: "square", 2: "base", 3: "x0", 4: "y0", 5: "block", 6: "top"}


def places():
    """Of the corners along x and y from the middle; those along z are as far from the top."""
    size = HALF / CELLS
    along = [size * i for i in range(CELLS + 1)]
    while along[-1] < REACH:
        size *= RATIO
        along.append(along[-1] + size)
    return [round(place, 6) for place in along]


def text():
    """Of a file in Gmsh's format 2.2."""
    x = places()
    n = len(x)
    z = [round(x[-1] - place, 6) for place in reversed(x)]

    def corner(i, j, k):
        return 1 + i + n * (j + n * k)

    def square(corner_at, i, j):
        return [corner_at(i, j), corner_at(i + 1, j), corner_at(i + 1, j + 1), corner_at(i, j + 1)]

    faces, cells = [], []
    for i, j in itertools.product(range(n - 1), repeat=2):
        faces += [(2, square(lambda a, b: corner(a, b, 0), i, j)),
                  (1 if max(i, j) < CELLS else 6, square(lambda a, b: corner(a, b, n - 1), i, j)),
                  (3, square(lambda a, b: corner(0, a, b), i, j)), (4, square(lambda a, b: corner(a, 0, b), i, j))]
        cells += [square(lambda a, b: corner(a, b, k), i, j) + square(lambda a, b: corner(a, b, k + 1), i, j)  # noqa: B023
                  for k in range(n - 1)]
    nodes = [f"{number} {x[i]:g} {x[j]:g} {z[k]:g}"
             for number, (k, j, i) in enumerate(itertools.product(range(n), repeat=3), 1)]
    elements = [f"{group} {group} {' '.join(map(str, face))}" for group, face in faces]
    lines = [f"{number} 3 2 {element}" for number, element in enumerate(elements, 1)]
    lines += [f"{number} 5 2 5 5 {' '.join(map(str, cell))}" for number, cell in enumerate(cells, len(lines) + 1)]
    groups = [f'{3 if number == 5 else 2} {number} "{name}"' for number, name in GROUPS.items()]
    return "\n".join(["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(groups)), *groups, "$EndPhysicalNames",
                      "$Nodes", str(len(nodes)), *nodes, "$EndNodes", "$Elements", str(len(lines)), *lines, "$EndElements", ""])


if __name__ == "__main__":
    print(text(), end="")
