# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""A .vtu file as VTK's own reader sees it."""
import math

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader


def nearest(points, wanted):
    """Index of the nearest of `points` and the distance to it, for each place in `wanted`."""
    squares = np.array([np.sum((points - place)**2, axis=1) for place in wanted])
    return squares.argmin(axis=1), np.sqrt(squares.min(axis=1))


def shape_derivatives(cell, place):
    """Derivatives of VTK's shape functions of a cell: (directions, nodes)."""
    dim = cell.GetCellDimension()
    derivatives = [0.0] * (dim * cell.GetNumberOfPoints())
    cell.InterpolateDerivs(place, derivatives)
    # VTK has them direction by direction for its linear cells, node by node for its Lagrange cells.
    return np.reshape(derivatives, (dim, -1)) if cell.IsLinear() else np.reshape(derivatives, (-1, dim)).T


class Grid:
    """A .vtu file: points (n, 3), fields (n, components), cells and their points."""

    def __init__(self, path):
        errors = []
        reader = vtkXMLUnstructuredGridReader()
        reader.AddObserver("ErrorEvent", lambda *_: errors.append(path.name))
        reader.AddObserver("WarningEvent", lambda *_: errors.append(path.name))
        reader.SetFileName(str(path))
        reader.Update()
        grid = reader.GetOutput()
        self.errors = errors
        self.points = vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
        data = grid.GetPointData()
        arrays = {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i)) for i in range(data.GetNumberOfArrays())}
        self.components = {name: 1 if array.ndim == 1 else array.shape[1] for name, array in arrays.items()}
        self.fields = {name: array.astype(float) for name, array in arrays.items()}
        self.cells = [grid.GetCell(i).NewInstance() for i in range(grid.GetNumberOfCells())]
        for i, cell in enumerate(self.cells):
            cell.DeepCopy(grid.GetCell(i))
        self.types = {cell.GetCellType() for cell in self.cells}
        self.nodes = [[cell.GetPointId(k) for k in range(cell.GetNumberOfPoints())] for cell in self.cells]

    def __getitem__(self, name):
        return self.fields[name]

    def distinct(self):
        """Index of one of the coinciding points (each cell has its own)."""
        return np.unique(np.round(self.points, 5) + 0.0, axis=0, return_index=True)[1]

    def keys(self):
        """Point and centre of its cell: tells the values apart that stress has in neighbouring cells."""
        centres = np.zeros_like(self.points)
        for nodes in self.nodes:
            centres[nodes] = self.points[nodes].mean(axis=0)
        return np.hstack([self.points, centres])

    def jacobians(self):
        """Signed size of every cell as VTK interpolates it, and the smallest determinant at the Gauss points."""
        places, weights = np.polynomial.legendre.leggauss(4)
        sizes, least = [], math.inf
        for cell, nodes in zip(self.cells, self.nodes):
            dim = cell.GetCellDimension()
            size = 0
            for at in np.ndindex(*(4,) * dim):
                place = [(1 + places[k]) / 2 for k in at] + [0] * (3 - dim)
                jacobian = shape_derivatives(cell, place) @ self.points[nodes]
                determinant = np.linalg.det(jacobian[:, :dim])
                size += determinant * np.prod(weights[list(at)]) / 2**dim
                least = min(least, determinant)
            sizes.append(size)
        return np.array(sizes), least
