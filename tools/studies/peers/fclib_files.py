# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""FCLIB's own library, as the judge of files: it writes problems that are read here, and reads those written here."""
import ctypes
import ctypes.util

import numpy as np

_INT, _DOUBLE = ctypes.POINTER(ctypes.c_int), ctypes.POINTER(ctypes.c_double)


class _Matrix(ctypes.Structure):
    _fields_ = [("nzmax", ctypes.c_int), ("m", ctypes.c_int), ("n", ctypes.c_int), ("p", _INT), ("i", _INT),
                ("x", _DOUBLE), ("nz", ctypes.c_int), ("info", ctypes.c_void_p)]


class _Local(ctypes.Structure):
    _fields_ = [("W", ctypes.POINTER(_Matrix)), ("V", ctypes.POINTER(_Matrix)), ("R", ctypes.POINTER(_Matrix)),
                ("mu", _DOUBLE), ("q", _DOUBLE), ("s", _DOUBLE), ("spacedim", ctypes.c_int), ("info", ctypes.c_void_p)]


class _Global(ctypes.Structure):
    _fields_ = [("M", ctypes.POINTER(_Matrix)), ("H", ctypes.POINTER(_Matrix)), ("G", ctypes.POINTER(_Matrix)),
                ("mu", _DOUBLE), ("f", _DOUBLE), ("b", _DOUBLE), ("w", _DOUBLE), ("spacedim", ctypes.c_int),
                ("info", ctypes.c_void_p)]


class _Solution(ctypes.Structure):
    _fields_ = [("v", _DOUBLE), ("u", _DOUBLE), ("r", _DOUBLE), ("l", _DOUBLE)]


def library():
    """None where it is not installed."""
    name = ctypes.util.find_library("fclib")
    if name is None:
        return None
    fclib = ctypes.CDLL(name)
    fclib.fclib_read_local.restype = ctypes.POINTER(_Local)
    fclib.fclib_read_solution.restype = ctypes.POINTER(_Solution)
    fclib.fclib_merit_local.restype = ctypes.c_double
    return fclib


_KEPT = []  # a structure of ctypes keeps no array alive


def _pointer(values, kind=ctypes.c_double):
    _KEPT.append(np.ascontiguousarray(values, dtype=kind))
    return _KEPT[-1].ctypes.data_as(ctypes.POINTER(kind))


def _matrix(values, kind, room=0):
    """kind: columns, rows or triplets. room: for entries that are not there."""
    values = np.asarray(values, dtype=float)
    rows, columns = np.nonzero(values if kind != "columns" else values.T)
    lines, others = rows, columns
    x = (values if kind != "columns" else values.T)[rows, columns]
    m, n = values.shape
    n_max = len(x) + room
    x, others = np.append(x, np.zeros(room)), np.append(others, np.full(room, -1))
    if kind == "triplets":
        return _Matrix(n_max, m, n, _pointer(lines, ctypes.c_int), _pointer(others, ctypes.c_int), _pointer(x), len(lines))
    begins = np.searchsorted(lines, np.arange((n if kind == "columns" else m) + 1))
    return _Matrix(n_max, m, n, _pointer(begins, ctypes.c_int), _pointer(others, ctypes.c_int), _pointer(x),
                   -1 if kind == "columns" else -2)


def write(path, W, q, mu, kind="columns", V=None, R=None, s=None, spacedim=3, room=0):
    """A local problem, by FCLIB."""
    matrices = [None if values is None else _matrix(values, kind, room) for values in (W, V, R)]
    local = _Local(*[None if matrix is None else ctypes.pointer(matrix) for matrix in matrices], _pointer(mu),
                   _pointer(np.ravel(q)), None if s is None else _pointer(s), spacedim, None)
    written = library().fclib_write_local(ctypes.byref(local), str(path).encode())
    _KEPT.clear()
    if written != 1:
        raise OSError(f"FCLIB does not write {path}")


def write_global(path, M, H, f, w, mu, kind="columns", G=None, b=None):
    """A global problem M v = H r + G l + f, u = H^T v + w, G^T v + b = 0, by FCLIB."""
    matrices = [None if values is None else ctypes.pointer(_matrix(values, kind)) for values in (M, H, G)]
    problem = _Global(*matrices, *[None if values is None else _pointer(values) for values in (mu, f, b, w)], 3, None)
    written = library().fclib_write_global(ctypes.byref(problem), str(path).encode())
    _KEPT.clear()
    if written != 1:
        raise OSError(f"FCLIB does not write {path}")


def write_solution(path, u, r, multipliers=None):
    """Beside the problem in the file, by FCLIB."""
    solution = _Solution(None, _pointer(u), _pointer(r), None if multipliers is None else _pointer(multipliers))
    written = library().fclib_write_solution(ctypes.byref(solution), str(path).encode())
    _KEPT.clear()
    if written != 1:
        raise OSError(f"FCLIB does not write {path}")


class Read:
    """A problem and, if it has one, its solution as FCLIB reads them: W, q, mu, u, r, and its measure of error."""

    def __init__(self, path, has_solution=True):
        fclib = library()
        local = fclib.fclib_read_local(str(path).encode())
        matrix = local.contents.W.contents
        n = matrix.n
        assert matrix.nz == -1
        values, rows = np.ctypeslib.as_array(matrix.x, (n * n,)), np.ctypeslib.as_array(matrix.i, (n * n,))
        self.W = np.zeros((n, n))
        self.W[rows, np.repeat(np.arange(n), np.diff(np.ctypeslib.as_array(matrix.p, (n + 1,))))] = values
        self.q = np.ctypeslib.as_array(local.contents.q, (n,)).copy()
        self.mu = np.ctypeslib.as_array(local.contents.mu, (n // 3,)).copy()
        if not has_solution:  # FCLIB ends the program that asks for it
            return
        solution = fclib.fclib_read_solution(str(path).encode())
        self.u = np.ctypeslib.as_array(solution.contents.u, (n,)).copy()
        self.r = np.ctypeslib.as_array(solution.contents.r, (n,)).copy()
        self.error = fclib.fclib_merit_local(local, 0, solution)
