# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""A .vtu file as VTK's own reader sees it."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkProbeFilter
from vtkmodules.vtkFiltersSources import vtkLineSource
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

TRIANGLE, QUADRILATERAL, HEXAHEDRON, LAGRANGE_QUADRILATERAL = 5, 9, 12, 70  # VTK's numbers
LEXICOGRAPHIC = {TRIANGLE: [0, 1, 0, 2], QUADRILATERAL: [0, 1, 3, 2], HEXAHEDRON: [0, 1, 3, 2, 4, 5, 7, 6]}


def nearest(points, wanted):
    """Index of the nearest of `points` and the distance to it, for each place in `wanted`."""
    squares = np.array([np.sum((points - place)**2, axis=1) for place in wanted])
    return squares.argmin(axis=1), np.sqrt(squares.min(axis=1))


def gauss_lobatto(degree):
    """The nodes of an element of the program in [0, 1]."""
    inner = np.polynomial.legendre.Legendre.basis(degree).deriv().roots()
    return np.concatenate([[0.], (1 + np.sort(inner.real)) / 2, [1.]])


def shape_functions(nodes, dim):
    """Weights, values (places, nodes) and derivatives (directions, places, nodes) at Gauss's points of the polynomials
    of nodes in [0, 1], the first direction fastest."""
    places, weights = np.polynomial.legendre.leggauss(len(nodes) + 1)
    powers = np.arange(len(nodes))
    coefficients = np.linalg.inv(np.power.outer(np.asarray(nodes, dtype=float), powers))
    x = (1 + places) / 2
    lines = [np.power.outer(x, powers) @ coefficients,
             powers * np.power.outer(x, np.maximum(powers - 1, 0)) @ coefficients]

    def product(factors):
        result = np.ones((1, 1))
        for factor in factors:
            result = np.kron(factor, result)
        return result
    derivatives = [product(lines[direction == other] for other in range(dim)) for direction in range(dim)]
    return product([weights[:, None] / 2] * dim)[:, 0], product([lines[0]] * dim), np.array(derivatives)


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

    def n_places(self):
        """Number of places where there are points."""
        return len(np.unique(np.round(self.points, 5) + 0.0, axis=0))

    def keys(self, n_points):
        """Point and centre of its element, which has so many points: stress has other values in neighbouring
        elements."""
        centres = self.points.reshape(-1, n_points, 3).mean(axis=1)
        return np.hstack([self.points, np.repeat(centres, n_points, axis=0)])

    def cells(self):
        """Points of the cells, (cells, corners), the first direction fastest; a triangle is a quadrilateral."""
        def corners(i):
            points = self.grid.GetCell(i).GetPointIds()
            return [points.GetId(k) for k in LEXICOGRAPHIC[self.grid.GetCellType(i)]]
        return np.array([corners(i) for i in range(self.grid.GetNumberOfCells())])

    def degree(self):
        """Degree of the elements as the file has it."""
        return int(self.grid.GetFieldData().GetArray("degree").GetTuple1(0))

    def faces(self):
        """Points of the elements of a contact file, the first direction fastest, from the cells that follow."""
        n = self.degree()
        pieces = self.cells().reshape(-1, n, n, 2, 2)
        points = np.zeros((len(pieces), n + 1, n + 1), dtype=int)
        for j, i in np.ndindex(n, n):
            points[:, j:j + 2, i:i + 2] = pieces[:, j, i]
        return points.reshape(len(pieces), -1)

    def integral(self, values, elements=None, nodes=(0, 1)):
        """Integral of a field, as VTK interpolates it or as a polynomial of given nodes in given elements, and the
        smallest determinant of the maps."""
        elements = self.cells() if elements is None else elements
        dim = round(np.log(elements.shape[1]) / np.log(len(nodes)))
        weights, shapes, derivatives = shape_functions(nodes, dim)
        jacobians = np.einsum("dqk,ekc->eqdc", derivatives, self.points[elements][:, :, :dim])
        determinants = np.linalg.det(jacobians)
        return np.einsum("q,eq,eq->", weights, determinants, values[elements] @ shapes.T), determinants.min()

    def size(self):
        """Area or volume, positive where cells are not turned over, and the smallest determinant."""
        return self.integral(np.ones(len(self.points)))

    def samples(self, places):
        """The fields at these places, and the mask of those that VTK finds; the places of the samples are `place`."""
        source = vtkPolyData()
        points = vtkPoints()
        points.SetData(numpy_to_vtk(np.ascontiguousarray(places, dtype=float), deep=True))
        source.SetPoints(points)
        self.add("place", self.points)
        probe = vtkProbeFilter()
        probe.SetInputData(source)
        probe.SetSourceData(self.grid)
        probe.Update()
        found = probe.GetOutput().GetPointData()
        fields = {name: vtk_to_numpy(found.GetArray(name)) for name in (*self.fields, "place")}
        return fields, vtk_to_numpy(found.GetArray(probe.GetValidPointMaskArrayName())) == 1

    def add(self, name, values):
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        self.grid.GetPointData().AddArray(array)


def line(start, end, n=1001):
    """The samples of ParaView's Plot Over Line."""
    source = vtkLineSource()
    source.SetPoint1(*start)
    source.SetPoint2(*end)
    source.SetResolution(n - 1)
    source.SetOutputPointsPrecision(1)
    source.Update()
    return vtk_to_numpy(source.GetOutput().GetPoints().GetData())
