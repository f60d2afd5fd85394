# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""A body of hexahedra with named surfaces and volumes, and the file of Gmsh (format 2.2, ASCII) that it becomes."""
import re

import numpy as np
from imported_body import border_faces


# Of a hexahedron in the order of Abaqus, VTK and meshio: ends of its edges, and the places of these edges and faces in the
# order of Gmsh.
EDGES = ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7))
IN_GMSH = (0, 3, 8, 1, 9, 2, 10, 11, 4, 7, 5, 6, 16, 14, 12, 13, 15, 17, 18)
FACES = ((0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 2, 6, 7), (0, 1, 2, 3), (4, 5, 6, 7))
# Gmsh's types of hexahedra and quadrilaterals by the number of middles of a cell.
TYPES = {0: (5, 3), 12: (17, 16), 19: (12, 10)}


class Fault(Exception):
    """What is wrong with a file, as a sentence without its name."""


def counted(counter):
    """'3 C3D4, 12 C3D20' of numbers of things."""
    words = [f"{n} {kind}" for kind, n in sorted(counter.items())]
    return ", ".join(words[:4]) + (f" and {len(words) - 4} kinds more" if len(words) > 4 else "")


def rows_in(faces, border):
    """Rows of `border` that have the nodes of the faces, each once."""
    index = {tuple(row): i for i, row in enumerate(np.sort(border, axis=1).tolist())}
    found = (index.get(tuple(sorted(face))) for face in np.asarray(faces, int).reshape(-1, 4).tolist())
    return sorted({i for i in found if i is not None})


def faces_with(border, nodes):
    """Faces all of whose nodes are among these."""
    return border[np.isin(border, np.asarray(nodes, int)).all(axis=1)]


def plain(name):
    """A name that a parameter file can name."""
    return re.sub(r"[#\\,;:\"\x00-\x1f\x7f]", "_", name).strip() or "unnamed"


class Body:
    def __init__(self, points, cells, notes):
        """`cells` have 8 nodes at their corners, and of second order 12 or 19 more in the middles of edges, faces and cell."""
        cells, self.middles = cells[:, :8], cells[:, 8:]
        if not len(cells):
            raise Fault("has no hexahedra: allowed are meshes of hexahedra of 8, 20 or 27 nodes")
        if not np.isfinite(points[np.unique(np.hstack([cells, self.middles]))]).all():
            raise Fault("has coordinates that are no finite numbers")
        _, first = np.unique(np.sort(cells, axis=1), axis=0, return_index=True)
        self.notes = notes  # for the user, a sentence each
        if len(first) < len(cells):
            notes.append(f"{len(cells) - len(first)} cells were there twice")
        self.is_first = np.isin(np.arange(len(cells)), first)
        self.points, self.cells = points, cells
        self.border = border_faces(cells[self.is_first])
        self.surfaces = {}  # name: rows of border
        self.volumes, self.volume_of = [], np.zeros(len(cells), int)

    def has_surface(self, name):
        return plain(name) in self.surfaces

    def add_surface(self, name, faces, part=False):
        """`part`: those of the faces that are on the outside are meant."""
        rows = rows_in(faces, self.border)
        if not rows:
            self.notes.append(f"surface {name} has no faces on the outside of the cells, and is left out")
            return
        if len(rows) < len(faces) and not part:
            self.notes.append(f"surface {name} has {len(faces)} faces: the {len(rows)} on the outside are taken")
        self.surfaces[plain(name)] = sorted(set(self.surfaces.get(plain(name), [])) | set(rows))

    def add_volume(self, name, cells):
        """A cell belongs to the first volume that has it."""
        free = [cell for cell in cells if self.volume_of[cell] == 0]
        if free:
            if plain(name) not in self.volumes:
                self.volumes.append(plain(name))
            self.volume_of[free] = self.volumes.index(plain(name)) + 1

    def box(self):
        used = self.points[np.unique(self.cells)]
        return used.min(axis=0), used.max(axis=0)

    def faces_with_middles(self, number):
        """The nodes of the outer faces, by their numbers in the file, in the order of Gmsh."""
        if not self.middles.shape[1]:
            return number[self.border]
        middle = {}  # by the corners around it
        for corners, nodes in zip(self.cells[self.is_first].tolist(), self.middles[self.is_first].tolist()):
            for around, node in zip(EDGES + FACES, nodes):
                middle[frozenset(corners[i] for i in around)] = node
        faces = []
        for face in self.border.tolist():
            edges = [middle[frozenset(pair)] for pair in zip(face, face[1:] + face[:1])]
            own = [middle[frozenset(face)]] if self.middles.shape[1] > len(EDGES) else []
            faces.append(number[face + edges + own])
        return faces

    def text(self):
        """Nodes that no cell has are left out."""
        order = [i for i in IN_GMSH if i < self.middles.shape[1]]
        cells = np.hstack([self.cells, self.middles[:, order]])[self.is_first]
        used, number = np.unique(cells), np.zeros(len(self.points), int)
        number[used] = np.arange(1, len(used) + 1)
        of_cell, of_face = TYPES[self.middles.shape[1]]
        border = self.faces_with_middles(number)
        n = len(self.surfaces)  # groups of volumes come behind those of surfaces
        names = [f'2 {i} "{name}"' for i, name in enumerate(self.surfaces, 1)]
        names += [f'3 {n + i} "{name}"' for i, name in enumerate(self.volumes, 1)]
        elements = [(of_face, group, border[row])
                    for group, rows in enumerate(self.surfaces.values(), 1) for row in rows]
        elements += [(of_cell, n + volume if volume else 0, nodes)
                     for volume, nodes in zip(self.volume_of[self.is_first], number[cells])]
        lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat"]
        if names:
            lines += ["$PhysicalNames", len(names), *names, "$EndPhysicalNames"]
        lines += ["$Nodes", len(used)]
        lines += (f"{i} {x!r} {y!r} {z!r}" for i, (x, y, z) in enumerate(self.points[used].tolist(), 1))
        lines += ["$EndNodes", "$Elements", len(elements)]
        lines += (f"{i} {kind} 2 {group} {group} " + " ".join(map(str, nodes))
                  for i, (kind, group, nodes) in enumerate(elements, 1))
        return "\n".join(map(str, [*lines, "$EndElements"])) + "\n"
