# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What a run folder has of one cycle: stress histories in the bodies, in the modelled part, and what the contact surface does."""
import dataclasses
import functools

import numpy as np
from below import Below
from criteria import ruiz
from edges import edge_stress
from fields import Field
from interpolation import Triangles, interpolated
from run_folder import BadFile, Vtu, lattice_of
from stresses import ORDER, of_nine

QUADRILATERAL, HEXAHEDRON, LAGRANGE = 9, 12, 70  # VTK's numbers
_SMALL = 1e-6  # of the extent of a body: points that are one
SETTLED = 0.01  # largest difference of the states at both ends of a cycle that counts as settled


class NotInRun(ValueError):
    """A run folder lacks what is asked for; the words are one line and name the entry that has to be set."""


def steps_of_cycle(run):
    """The number of the last complete cycle that was computed and not jumped, its steps, and the difference of the states at both
    of its ends."""
    history, cycles = run.history, run.cycles
    for cycle, last, change in reversed(list(zip(*(cycles.get(name, ()) for name in ("cycle", "last_step", "change"))))):
        numbers = history["step"][(history["cycle"] == cycle) & (history["step"] <= last)]
        if len(numbers):
            return int(cycle), numbers.astype(int).tolist(), float(change)
    raise NotInRun("has no complete cycle: set Load program/Cycles, and let the run end")


def check_steps(run, kind, steps):
    """That all steps have a file of this kind."""
    there = set(run.contact_steps(kind))
    if len(list(run.path.glob(f"{kind}-*.pvtu"))):
        raise NotInRun("has volume files of several processes: allowed is a run of one process")
    lacks = [step for step in steps if step not in there]
    if lacks:
        entry = "Contact fields" if kind == "contact" else "Volume fields"
        raise NotInRun(f"has {kind} files of {len(steps) - len(lacks)} of the {len(steps)} steps {steps[0]} to {steps[-1]}: set "
                       f"Output/{entry} = 1 and run again, or name steps that have files with --steps")


def section_of(inward):
    return "Material" if inward > 0 else "Lower material"


@dataclasses.dataclass
class Body:
    """points: (n, 3), mm. stress: (n, steps, 6), MPa. cells: [(VTK's number, (m, points of a cell))]. inward: +1 above the
    contact surface, -1 below. material: the entries of its section. is_section: it lies in the plane y = 0."""
    name: str
    inward: int
    material: dict
    points: np.ndarray
    stress: np.ndarray
    cells: list

    @property
    def section(self):
        """The name of the section of its material."""
        return section_of(self.inward)

    @property
    def is_section(self):
        return all(kind in (QUADRILATERAL, LAGRANGE) for kind, _ in self.cells)

    @functools.cached_property
    def on_surface(self):
        """Numbers of the points in the plane z = 0."""
        return np.flatnonzero(np.abs(self.points[:, 2]) <= _SMALL * np.ptp(self.points, axis=0).max())

    @functools.cached_property
    def triangles(self):
        """Of a section, in its plane (x, z)."""
        found = []
        for kind, cells in self.cells:
            if kind == LAGRANGE:
                degree = int(round(np.sqrt(cells.shape[1]))) - 1
                grid = lattice_of(degree)
                corners = [grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]]
                cells = np.concatenate([cells[:, list(quad)] for quad in zip(*(corner.ravel() for corner in corners))])
            found += [cells[:, [0, 1, 2]], cells[:, [0, 2, 3]]]
        return Triangles(self.points[:, [0, 2]], np.concatenate(found))


def one_of_each(points, regions):
    """Points of one place and region are one: the first of each, and for each point the number of its one."""
    places = np.round(points / (_SMALL * np.ptp(points, axis=0).max())).astype(np.int64)
    _, first, number = np.unique(np.column_stack([places, regions]), axis=0, return_index=True, return_inverse=True)
    return first, number.reshape(-1)


def means(values, number, n):
    """(points, k) -> (n, k): means over the points of each number."""
    count = np.bincount(number, minlength=n)
    return np.stack([np.bincount(number, column, n) for column in values.T], axis=1) / count[:, None]


def with_mirror_image(stress, points, planes):
    """On planes of symmetry the mean with the mirror image: shear that is odd there vanishes. stress: (n, 6)."""
    small = _SMALL * np.ptp(points, axis=0).max()
    for axis, odd in (("x", [3, 4]), ("y", [3, 5])):
        if f"{axis} = 0" in planes:
            stress[np.ix_(np.abs(points[:, "xy".index(axis)]) <= small, odd)] = 0
    return stress


def body_of(run, kind, steps, near):
    """A Body of the files of a kind, `volume` or `lower`, with the cells that lie where near((n, 3)) is true."""
    check_steps(run, kind, steps)
    stress, numbering, planes = [], None, run.summary.get("model", {}).get("symmetry_planes", [])
    for step in steps:
        path = run.path / f"{kind}-{step:04d}.vtu"
        file = Vtu(path)
        if file.fields.get("stress", np.empty(0)).shape != (len(file.points), 9):
            raise BadFile(f"{path}: has no field 'stress'")
        if numbering is None:
            numbering = one_of_each(file.points, np.broadcast_to(file.fields.get("region", 0), len(file.points)))
            points, blocks = file.points.astype(float)[numbering[0]], [(kind_, numbering[1][cells]) for kind_, cells in file.blocks]
            kept = near(points)
        elif len(file.points) != len(numbering[1]):
            raise BadFile(f"{path}: has another mesh than the steps before")
        stress.append(with_mirror_image(means(of_nine(file.fields["stress"]), numbering[1], len(points)), points, planes)[kept])
    inner = [(kind_, cells[kept[cells].all(axis=1)]) for kind_, cells in blocks]
    used = np.unique(np.concatenate([cells.ravel() for _, cells in inner] or [np.empty(0, int)]))
    if not len(used):
        raise NotInRun(f"has no cell of the {'body' if kind == 'volume' else 'lower body'} within the distance --within")
    new = np.full(len(points), -1)
    new[used] = np.arange(len(used))
    inward = 1 if kind == "volume" else -1
    history = np.stack(stress, axis=1)[np.searchsorted(np.flatnonzero(kept), used)]
    return Body("body" if inward > 0 else "lower body", inward, run.parameters.get(section_of(inward), {}), points[used], history,
                [(kind_, new[cells]) for kind_, cells in inner if len(cells)])


class Surface:
    """What the contact surface does in the cycle. pressure (MPa), pressed: (n, steps); traction, slip: (n, steps, 2), MPa and mm."""

    def __init__(self, run, steps):
        check_steps(run, "contact", steps)
        self.is_strip = run.summary.get("model", {}).get("kind") == "plane strain"
        files = [run.contact(step) for step in steps]
        self.points, self.triangles = files[0].points.astype(float), files[0].triangles()
        try:
            self.pressure = np.stack([np.maximum(file["pressure"], 0) for file in files], axis=1).astype(float)
            self.traction, self.slip = (np.stack([file[name][:, :2] for file in files], axis=1).astype(float)
                                        for name in ("friction_traction", "slip"))
        except (KeyError, ValueError, IndexError) as error:
            raise BadFile(f"{run.path}: contact files lack a field, or differ in their meshes ({error})") from error
        self.pressed = self.pressure > 0
        self.touched = self.points[self.pressed.any(axis=1)]
        if not len(self.touched):
            raise NotInRun("has no contact in this cycle")
        extent = np.ptp(self.points, axis=0).max()
        self.is_plane = bool(np.abs(self.points[:, 2]).max() <= _SMALL * extent)

    @functools.cached_property
    def middle(self):
        return (self.touched.min(axis=0) + self.touched.max(axis=0)) / 2

    @functools.cached_property
    def radius(self):
        """Half of the extent of the contact along x, mm."""
        return max(float(np.ptp(self.touched[:, 0])), _SMALL) / 2

    def near(self, factor):
        """A function of points: whether they lie within `factor` radii of the box around the nodes that are touched."""
        low, high = self.touched.min(axis=0), self.touched.max(axis=0)

        def is_near(points):
            beside = np.maximum(np.maximum(low - points, points - high), 0)
            return np.linalg.norm(beside, axis=1) <= factor * self.radius
        return is_near

    def below(self, points, inward):
        """A Below of points in the body (inward = 1) or the lower body (-1)."""
        return Below.plane(points, inward) if self.is_plane else Below.curved(points, self.points, self.triangles, self.is_strip)

    def edges(self, body):
        """Points (m, 3) and stress (m, steps, 6) at the edges of the contact of a section with a plane contact surface and one
        isotropic material; none where too few nodes slip."""
        poisson = body.material.get("Poisson ratio")
        is_isotropic = body.material.get("Law", "isotropic") == "isotropic" and not body.material.get("Regions")
        if not (body.is_section and self.is_plane and is_isotropic and poisson is not None):
            return np.empty((0, 3)), np.empty((0, self.pressed.shape[1], 6))
        side = np.flatnonzero(self.points[:, 1] == self.points[:, 1].min()) if self.is_strip else np.flatnonzero(
            (np.abs(self.points[:, 1]) < _SMALL) & (self.points[:, 0] >= 0))
        side = side[np.argsort(self.points[side, 0])]
        slip = np.linalg.norm(self.slip - self.slip[:, :1], axis=2)
        return edge_stress(body, float(poisson), self.points[side, 0], self.pressure[side], slip[side])

    def ruiz(self, body):
        """{name: Field} at the points of a body: 0 off the contact surface, which has to be plane."""
        values = np.zeros((2, len(body.points)))
        places = body.points[body.on_surface]
        rows, weights, inside = Triangles(self.points[:, :2], self.triangles).weights(places[:, :2])
        rows, weights, at = rows[inside], weights[inside], body.on_surface[inside]
        pressed = interpolated(self.pressed.astype(float), rows, weights) > 0.5
        traction, slip = (interpolated(field, rows, weights) for field in (self.traction, self.slip))
        if len(at):
            values[:, at] = ruiz(body.stress[at], traction, slip, pressed)
        return {"ruiz_energy": Field(values[0]), "ruiz_tension": Field(values[1])}


def line_history(run, name, steps):
    """Distances (mm), points (n, 3) and stress (n, steps, 6) of a line of output."""
    lacks = [step for step in steps if step not in run.line_steps(name)]
    if lacks:
        raise NotInRun(f"has no file of line {name} of step {lacks[0]}: set Output/Line fields = 1 and run again")
    tables = [run.line(name, step) for step in steps]
    try:
        stress = np.stack([np.stack([table[f"stress_{pair}"] for pair in ORDER], axis=1) for table in tables], axis=1)
        points = np.stack([tables[0][axis] for axis in "xyz"], axis=1)
    except (KeyError, ValueError) as error:
        raise BadFile(f"{run.path}: files of line {name} lack a column or a row ({error})") from error
    return tables[0]["s"], points, stress
