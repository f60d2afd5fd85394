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


def shape_functions(cell, place):
    """VTK's shape functions of a cell, (nodes), and their derivatives, (directions, nodes)."""
    dim, n_nodes = cell.GetCellDimension(), cell.GetNumberOfPoints()
    values, derivatives = [0.0] * n_nodes, [0.0] * (dim * n_nodes)
    cell.InterpolateFunctions(place, values)
    cell.InterpolateDerivs(place, derivatives)
    # VTK has them direction by direction for its linear cells, node by node for its Lagrange cells.
    by_direction = np.reshape(derivatives, (dim, -1)) if cell.IsLinear() else np.reshape(derivatives, (-1, dim)).T
    return np.array(values), by_direction


class Grid:
    """A .vtu file: points (n, 3), fields (n, components), cells and their points."""

    def __init__(self, path):
        errors = []
        reader = vtkXMLUnstructuredGridReader()
        reader.AddObserver("ErrorEvent", lambda *_: errors.append(True))
        reader.AddObserver("WarningEvent", lambda *_: errors.append(True))
        reader.SetFileName(str(path))
        reader.Update()
        grid = reader.GetOutput()
        if errors:
            raise ValueError(f"VTK has something to say against {path}")
        self.points = vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
        data = grid.GetPointData()
        arrays = {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i)) for i in range(data.GetNumberOfArrays())}
        self.components = {name: 1 if array.ndim == 1 else array.shape[1] for name, array in arrays.items()}
        self.fields = {name: array.astype(float) for name, array in arrays.items()}
        self.grid = grid
        self.types = {grid.GetCellType(i) for i in range(grid.GetNumberOfCells())}

    def __getitem__(self, name):
        return self.fields[name]

    def distinct(self):
        """Index of one of the coinciding points (each cell has its own)."""
        return np.unique(np.round(self.points, 5) + 0.0, axis=0, return_index=True)[1]

    def keys(self):
        """Point and centre of its cell: tells the values apart that stress has in neighbouring cells."""
        centres = np.zeros_like(self.points)
        for _cell, nodes in self.cells():
            centres[nodes] = self.points[nodes].mean(axis=0)
        return np.hstack([self.points, centres])

    def cells(self):
        """VTK's cells (each valid until the next one is asked for) and the numbers of their points."""
        for i in range(self.grid.GetNumberOfCells()):
            cell = self.grid.GetCell(i)
            yield cell, [cell.GetPointId(k) for k in range(cell.GetNumberOfPoints())]

    def integral(self, values):
        """Integral of a field as VTK interpolates it, and the smallest determinant of the cells' maps."""
        places, weights = np.polynomial.legendre.leggauss(4)
        total, least = 0, math.inf
        for cell, nodes in self.cells():
            dim = cell.GetCellDimension()
            for at in np.ndindex(*(4,) * dim):
                place = [(1 + places[k]) / 2 for k in at] + [0] * (3 - dim)
                shapes, derivatives = shape_functions(cell, place)
                determinant = np.linalg.det((derivatives @ self.points[nodes])[:, :dim])
                total += shapes @ values[nodes] * determinant * np.prod(weights[list(at)]) / 2**dim
                least = min(least, determinant)
        return total, least

    def size(self):
        """Area or volume, positive where cells are not turned over, and the smallest determinant."""
        return self.integral(np.ones(len(self.points)))
