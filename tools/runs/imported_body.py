# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The body of a Gmsh file, as it is seen from the side: along y, x to the right."""
import contextlib
import io
import re

import meshio
import numpy as np
from run_folder import check_ordinary

FACES = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))  # of a hexahedron, outwards
CORNERS = {"hexahedron": 8, "quad": 4}  # nodes of first order; those of second order follow them
ROUNDING = 1e-6  # of the extent of the body
PLACE = re.compile(r"([xyz])(?: +(min|max)| *= *(\S+))")


def read(path):
    """None for a file that is gone, or that meshio does not read."""
    try:
        check_ordinary(path)
        with contextlib.redirect_stderr(io.StringIO()), contextlib.redirect_stdout(io.StringIO()):
            return meshio.read(path, file_format="gmsh")
    except (Exception, SystemExit):  # meshio exits on some files and raises what it likes on others
        return None


def extruded(mesh):
    """The layer of hexahedra, 1 mm thick along y, of a mesh of quadrangles in the plane y = 0; other meshes as they are."""
    if any(block.type.startswith("hexahedron") for block in mesh.cells):
        return mesh
    tags, n = mesh.cell_data["gmsh:physical"], len(mesh.points)
    blocks, of_blocks = [], []
    for block, tag in zip(mesh.cells, tags):
        if block.type.startswith("quad"):
            blocks.append(("hexahedron", np.hstack([block.data[:, :4], block.data[:, :4] + n])))
        elif block.type.startswith("line"):
            ends = block.data[:, :2]
            blocks.append(("quad", np.hstack([ends, ends[:, ::-1] + n])))
        else:
            continue
        of_blocks.append(tag)
    return meshio.Mesh(np.concatenate([mesh.points, mesh.points + [0, 1, 0]]), blocks, cell_data={"gmsh:physical": of_blocks},
                       field_data=mesh.field_data)


def border_faces(cells):
    """Faces of only one of the hexahedra."""
    faces = np.concatenate([cells[:, list(face)] for face in FACES])
    _, first, count = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
    return faces[first[count == 1]]


def border_of(faces):
    """Edges of only one of the faces."""
    edges = np.sort(np.stack([faces, np.roll(faces, -1, axis=1)], axis=2).reshape(-1, 2), axis=1)
    edges, count = np.unique(edges, axis=0, return_counts=True)
    return edges[count == 1]


class ImportedBody:
    def __init__(self, mesh, geometry):
        self.mesh = extruded(mesh)
        self.points = self.mesh.points
        self.border = border_faces(np.concatenate([cells for cells, _ in self.blocks("hexahedron")]))
        self.contact = np.concatenate([self.surface(name.strip()) for name in geometry["Contact surface"].split(",")])
        self.held = self.surface(geometry["Held surface"])
        symmetric = [self.points[self.surface(name.strip()).ravel()]
                     for name in geometry.get("Symmetry surfaces", "").split(",") if name.strip()]
        small = ROUNDING * np.ptp(self.points, axis=0).max()
        self.mirrored = [any(np.all(np.abs(points[:, axis]) < small) for points in symmetric) for axis in (0, 1)]
        self.faces = self.faces_seen()

    @classmethod
    def of(cls, geometry):
        """The body of a section Geometry; None if its file describes none."""
        mesh = read(geometry["Mesh file"])
        try:
            return cls(mesh, geometry) if mesh else None
        except Exception:  # a damaged mesh can lead anywhere
            return None

    def blocks(self, kind):
        tags = self.mesh.cell_data.get("gmsh:physical", [None] * len(self.mesh.cells))
        return [(block.data[:, :CORNERS[kind]], tag) for block, tag in zip(self.mesh.cells, tags)
                if re.fullmatch(kind + r"\d*", block.type)]

    def surface(self, name):
        """Quadrilaterals of a physical surface, by name or number, or of a place such as z min or x = 0; none without a
        name."""
        if not name:
            return np.empty((0, 4), dtype=int)
        if name not in self.mesh.field_data and (place := PLACE.fullmatch(name)):
            return self.faces_at("xyz".index(place[1]), place[2] or float(place[3]))
        number = self.mesh.field_data[name][0] if name in self.mesh.field_data else int(name)
        return np.concatenate([faces[tags == number] for faces, tags in self.blocks("quad")])

    def faces_at(self, axis, place):
        """Faces in a plane normal to an axis: at the least ("min") or largest ("max") coordinate, or at a number (mm)."""
        places = self.points[self.border]
        if place in ("min", "max"):
            place = getattr(places[..., axis], place)()
        small = ROUNDING * np.ptp(places.reshape(-1, 3), axis=0).max()
        found = self.border[np.all(np.abs(places[..., axis] - place) <= small, axis=1)]
        if not len(found):
            raise ValueError("no faces")
        return found

    def faces_seen(self):
        """Faces that look at the reader. Of a half, whose missing part is nearer to the reader, those which its mirror
        image shows there."""
        corners = self.points[self.border]
        normals = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
        towards = normals[:, 1] * (1 if self.mirrored[1] else -1)
        return self.border[towards > ROUNDING * np.hypot(*normals[:, [0, 2]].T)]

    def rim(self):
        """Edges at which what is seen ends, other than at its own mirror image."""
        edges = border_of(self.faces)
        seam = self.mirrored[0] & np.all(np.abs(self.points[edges][..., 0]) < ROUNDING * np.ptp(self.points), axis=1)
        return edges[~seam]

    def sides(self):
        """Factors of x: the part of the file, and its mirror image."""
        return (1, -1) if self.mirrored[0] else (1,)

    def seen(self, points):
        """x and z of what is modelled and of its mirror image, (sides, ..., 2)."""
        places = self.points[points][..., [0, 2]]
        return np.stack([places * [side, 1] for side in self.sides()])

    def box(self):
        """Least and largest x and z."""
        places = self.seen(np.unique(self.faces)).reshape(-1, 2)
        return places.min(axis=0), places.max(axis=0)

    def contact_from_above(self):
        """Corners of the faces in contact and of their mirror images, (n, 4, 2)."""
        corners = self.points[self.contact][..., :2]
        for axis in np.flatnonzero(self.mirrored):
            corners = np.concatenate([corners, corners * np.where(np.arange(2) == axis, -1, 1)])
        return corners

    def held_middle(self):
        """Of the held surface, and the direction in which it looks."""
        places = self.seen(np.unique(self.held)).reshape(-1, 2)
        corners = self.points[self.held]
        normals = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
        along = np.sum(normals, axis=0)[[0, 2]] * [0 if self.mirrored[0] else 1, 1]
        middle = (places.min(axis=0) + places.max(axis=0)) / 2
        low, high = self.box()
        return middle, along * (1 if along @ (middle - (low + high) / 2) >= 0 else -1)
