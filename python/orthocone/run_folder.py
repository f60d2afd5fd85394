# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Reads the run folder of orthocone. Figures and reports take all that they know of a run from here.

Columns and fields have the names and units in docs/results.md: mm, N, MPa, N mm."""
import functools
import pathlib
import re

import numpy as np

from .outside import object_of, rows_of, text_of, understood
from .vtu import Vtu

OPEN, STICK, SLIP = 0, 1, 2  # the field `status`


def read_csv(path):
    """Columns of a CSV file: numbers as arrays, words (method, status) as lists."""
    names, rows = rows_of(path)
    columns = dict(zip(names, map(list, zip(*rows)))) if rows else {}
    for name, values in columns.items():
        try:
            columns[name] = np.array(values, dtype=float)
        except ValueError:
            pass
    return columns


class ContactFile:
    """Fields of a contact-NNNN.vtu file at its points, which are the contact nodes of the whole body. In older run
    folders, each element has points of its own.

    points: (n, 3), mm. data: {field: (n,) or (n, 3)}, mm, N, MPa or N/mm as in docs/results.md; file["slip"] is one of
    them. degree: the degree of the elements. cells: (m, (degree + 1)^2), the points of each element in VTK's order of
    Lagrange cells. path: the file, for pyvista.read() and other readers. Raises ValueError if it is not such a file."""

    def __init__(self, path):
        self.path = pathlib.Path(path)
        mesh = Vtu(path)
        self.points = mesh.points
        self.data = mesh.fields
        with understood(path, "a file of contact fields"):
            self._read_cells([points for _, points in mesh.blocks], mesh.field_data)

    def _read_cells(self, blocks, field_data):
        if "degree" in field_data:
            self.degree = int(field_data["degree"][0])
            # A triangle (at the axis of an axisymmetric model) is a quadrilateral whose last point is its first.
            self._quadrilaterals = np.concatenate([block[:, [0, 1, 2, 3 % block.shape[1]]] for block in blocks])
            self.cells = self._elements()  # corners first, then VTK's order of Lagrange cells
        else:
            self.cells = blocks[0]  # in that order already
            self.degree = int(round(np.sqrt(self.cells.shape[1]))) - 1
            self._quadrilaterals = self._cut()

    def __getitem__(self, name):
        return self.data[name]

    def lattice(self):
        """(degree + 1, degree + 1): the place of the point (i, j) of a cell among its points."""
        return lattice_of(self.degree)

    def quadrilaterals(self):
        """(m, 4): the points of the quadrilaterals into which the cells are cut between all their points."""
        return self._quadrilaterals

    def triangles(self):
        """(m, 3): the points of the triangles into which the cells are cut between all their points."""
        quads = self.quadrilaterals()
        return np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])

    def _cut(self):
        """The quadrilaterals of Lagrange cells."""
        n = self.degree + 1
        grid = self.lattice()
        quads = [(grid[i, j], grid[i + 1, j], grid[i + 1, j + 1], grid[i, j + 1])
                 for i in range(n - 1) for j in range(n - 1)]
        return np.concatenate([self.cells[:, quad] for quad in quads])

    def _elements(self):
        """The points of each element, whose quadrilaterals follow each other in the file, the first index fastest."""
        n = self.degree
        pieces = self._quadrilaterals.reshape(-1, n, n, 4).swapaxes(1, 2)
        points = np.empty((len(pieces), n + 1, n + 1), dtype=int)
        points[:, :n, :n] = pieces[:, :, :, 0]
        points[:, n, :n] = pieces[:, -1, :, 1]
        points[:, n, n] = pieces[:, -1, -1, 2]
        points[:, :n, n] = pieces[:, :, -1, 3]
        cells = np.empty((len(pieces), (n + 1)**2), dtype=int)
        cells[:, self.lattice()] = points
        return cells


def lattice_of(degree):
    """Place in VTK's numbering of a Lagrange quadrilateral of the point (i, j) of its lattice."""
    n, inner = degree, degree - 1
    place = np.empty((n + 1, n + 1), dtype=int)
    place[0, 0], place[n, 0], place[n, n], place[0, n] = range(4)
    for k in range(inner):
        place[k + 1, 0] = 4 + k
        place[n, k + 1] = 4 + inner + k
        place[k + 1, n] = 4 + 2 * inner + k
        place[0, k + 1] = 4 + 3 * inner + k
        for m in range(inner):
            place[k + 1, m + 1] = 4 + 4 * inner + k + inner * m
    return place


class Run:
    """The files of one run, read when they are asked for.

    path: the run folder. pandas: whether tables are DataFrames of pandas; None takes pandas if it is there.

    Without pandas, tables are {column: (rows,) array, or list of words}, with the same columns. They are empty before their
    first row: len(table) is 0. docs/results.md has the units of their columns: mm, N, MPa, N mm or s. Raises
    FileNotFoundError for files that the run has not written, and where there is no such folder; ValueError, in one line, for
    damaged files, files that are no text, pipes, devices and tables of more than 1 GB."""

    def __init__(self, path, *, pandas=None):
        self.path, self.pandas = pathlib.Path(path), pandas
        if not self.path.is_dir():
            raise FileNotFoundError(f"{path}: no such folder")

    def __repr__(self):
        return f"Run({str(self.path)!r})"

    def _table(self, name, may_lack=False):
        file = self.path / f"{name}.csv"
        columns = {} if may_lack and not file.exists() else read_csv(file)
        if self.pandas or self.pandas is None:
            try:
                from pandas import DataFrame
                return DataFrame(columns)
            except (ImportError, ValueError, AttributeError):  # it is not there, or was made for another NumPy
                if self.pandas:
                    raise
        return columns

    @functools.cached_property
    def history(self):
        """The table of all steps, one row a step."""
        return self._table("history")

    @property
    def has_history(self):
        """Whether there is a table of steps. A model that does not fit into the machine leaves only a summary."""
        return (self.path / "history.csv").exists()

    def probe_names(self):
        """Names of the probes whose tables are in the folder, sorted."""
        return sorted(file.stem[len("probe-"):] for file in self.path.glob("probe-*.csv"))

    def probe(self, name):
        """The table of a probe, one row a step."""
        return self._table(f"probe-{name}")

    def line_names(self):
        """Names of the lines whose files are in the folder, sorted."""
        names = (re.fullmatch("line-(.+)-(?:[0-9]{4}|[1-9][0-9]{4,8})", file.stem) for file in self.path.glob("line-*.csv"))
        return sorted({name[1] for name in names if name})

    def line_steps(self, name):
        """Numbers of the steps that have a file of this line."""
        return self._steps_of(f"line-{name}", "csv")

    def line(self, name, step):
        """The table of a line after a step, one row a point: displacement and stress, and pressure, friction traction
        and slip, which are nan at points off the contact surface."""
        return self._table(f"line-{name}-{step:04d}")

    @functools.cached_property
    def timing(self):
        """The table of wall times, s, one row a step."""
        return self._table("timing")

    @functools.cached_property
    def checks(self):
        """The table of independent checks, one row a step; empty if the run wrote none."""
        return self._table("checks", may_lack=True)

    @functools.cached_property
    def cycles(self):
        """The table of cycles, one row a cycle, or one row for several that were jumped; empty before the first cycle has
        ended."""
        return self._table("cycles", may_lack=True)

    @functools.cached_property
    def summary(self):
        """The content of summary.json."""
        return object_of(self.path / "summary.json")

    @functools.cached_property
    def parameters(self):
        """{section: {entry: text}} of the complete parameter file. Bytes that are not UTF-8, which names of files may
        contain, are decoded as by os.fsdecode()."""
        sections, current = {}, {}
        for line in text_of(self.path / "parameters.prm", errors="surrogateescape").split("\n"):
            if match := re.match(r"\s*subsection (.+)", line):
                current = sections.setdefault(match[1].strip(), {})
            elif match := re.match(r"\s*set (.+?)\s*=\s*(.*)", line):
                current[match[1]] = match[2].strip()
        return sections

    def problems(self):
        """{step: file} of the contact problems that the run has written. The last one may belong to a step that was
        not solved, of which the history has no row."""
        return {step: self.path / f"problem-{step:04d}.hdf5" for step in self._steps_of("problem", "hdf5")}

    def contact_steps(self, kind="contact"):
        """Numbers of the steps that have a contact file. `kind` is the beginning of the names of the files."""
        return self._steps_of(kind, "vtu")

    def _steps_of(self, kind, ending):
        """Of files with names as a run writes them."""
        names = (file.stem[len(kind) + 1:] for file in self.path.glob(f"{kind}-*.{ending}"))
        return sorted(int(name) for name in names if re.fullmatch("[0-9]{4}|[1-9][0-9]{4,8}", name))

    def contact(self, step=None, kind="contact"):
        """The fields of a step, a ContactFile; None is the last step that has such a file."""
        if step is None:
            step = max(self.contact_steps(kind), default=0)
        file = self.path / f"{kind}-{step:04d}.vtu"
        if self.path.is_dir() and not file.exists():
            steps = self.contact_steps(kind)
            entry = "Contact fields" if kind == "contact" else "Volume fields"
            which = f"it has {len(steps)}, of steps {steps[0]} to {steps[-1]}" if steps else f"it has none (Output/{entry})"
            raise FileNotFoundError(f"{self.path}: there is no {kind} file of step {step}; {which}")
        return ContactFile(file)
