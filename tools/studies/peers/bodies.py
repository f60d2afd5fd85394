# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Meshes and load steps of the scenes that peers solve: the program's own meshes, built here once more."""
import dataclasses

import numpy as np

SIZE = 10.0  # mm: radius and height of the cylinder, edges of the block
YOUNG, POISSON = 210000.0, 0.3
ROUNDING = 1e-9 * SIZE


@dataclasses.dataclass
class Scene:
    """A body of bricks, clamped at its top, pressed on the plane z = 0 with isotropic friction."""
    title: str
    file: str      # of ours, relative to prm/
    settings: dict  # of ours, beside the file
    shape: str
    friction: float
    legs: tuple    # (ux, uy, uz at the end, steps)

    def mesh(self):
        return cylinder() if self.shape == "cylinder" else block()

    def steps(self):
        """Places of the top, mm."""
        places, here = [], np.zeros(3)
        for *end, n in self.legs:
            places += [here + (np.array(end) - here) * (k + 1) / n for k in range(n)]
            here = np.array(end)
        return np.array(places)

    def all_settings(self):
        legs = " ; ".join(f"{x} {y} {z} : {n}" for x, y, z, n in self.legs)
        return {**self.settings, "Load program/Legs": legs, "Load program/Cycles": 1, "Output/Contact fields": 0,
                "Output/Volume fields": 0}


BLOCK = {"Geometry/Shape": "box", "Geometry/Sizes": "10, 10, 10", "Mesh/Model": "full", "Mesh/Cells": "10, 10, 6",
         "Mesh/Degree": 1, "Mesh/Quadrature points": 3, "Friction/Coefficients": "0.3, 0.3",
         "Friction/Slip potential": "associated", "Output/Probes": ""}
SCENES = {
    "case A": Scene("case A, down and up", "paper/case_a_q1.prm", {}, "cylinder", 0.2,
                    ((0, 0, -0.1, 5), (0, 0, -0.01, 9))),
    "sheared block": Scene("block, pressed and sheared", "paper/scene.prm", BLOCK, "block", 0.3,
                           ((0, 0, -0.02, 4), (0.02, 0.006, -0.02, 10))),
    "fretting loop": Scene("block, pressed and moved to and fro", "paper/scene.prm", BLOCK, "block", 0.3,
                           ((0, 0, -0.02, 4), (0.01, 0, -0.02, 4), (-0.01, 0, -0.02, 8), (0.01, 0, -0.02, 8))),
}


class Grid:
    """Points of a plane mesh, each once."""

    def __init__(self):
        self.points, self.cells, self._index = [], [], {}

    def point(self, x, y):
        key = (round(x, 8) + 0.0, round(y, 8) + 0.0)
        if key not in self._index:
            self._index[key] = len(self.points)
            self.points.append((x, y))
        return self._index[key]

    def patch(self, place, columns, lines):
        for i in range(columns):
            for j in range(lines):
                self.cells.append([self.point(*place(i + k, j + m)) for m in (0, 1) for k in (0, 1)])


def extruded(grid, heights):
    """Nodes and bricks, x fastest."""
    plane, cells = np.array(grid.points), np.array(grid.cells)
    nodes = np.vstack([np.column_stack([plane, np.full(len(plane), z)]) for z in heights])
    bricks = np.vstack([np.hstack([cells + (layer + side) * len(plane) for side in (0, 1)])
                        for layer in range(len(heights) - 1)])
    return nodes, bricks


def cylinder(core=8, rings=8, layers=4, ratio=0.5):
    """The paper's o-grid: a square core, and rings from it to the rim on each of its four sides."""
    half = ratio * SIZE / np.sqrt(2)
    along, outwards = np.linspace(-1, 1, core + 1), np.linspace(0, 1, rings + 1)
    grid = Grid()
    grid.patch(lambda i, j: (half * along[i], half * along[j]), core, core)
    for cosine, sine in ((1, 0), (0, 1), (-1, 0), (0, -1)):
        def place(i, j, c=cosine, s=sine):
            angle = np.pi / 4 * along[j]
            x = half + outwards[i] * (SIZE * np.cos(angle) - half)
            y = half * along[j] + outwards[i] * (SIZE * np.sin(angle) - half * along[j])
            return c * x - s * y, s * x + c * y
        grid.patch(place, rings, core)
    return extruded(grid, np.linspace(0, SIZE, layers + 1))


def block(columns=10, layers=6):
    side = np.linspace(-SIZE / 2, SIZE / 2, columns + 1)
    grid = Grid()
    grid.patch(lambda i, j: (side[i], side[j]), columns, columns)
    return extruded(grid, np.linspace(0, SIZE, layers + 1))


def at_height(nodes, z):
    return np.nonzero(np.abs(nodes[:, 2] - z) < ROUNDING)[0]
