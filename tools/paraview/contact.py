# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""A run folder in ParaView's window: deformed body, slip, pressure, friction criterion, and wear if there is any.

ORTHOCONE_RUN=RUN_FOLDER paraview --script=contact.py
or, in the Python Shell of an open one: Run Script... contact.py, then open_run("RUN_FOLDER")

The views look at the contact, and what is open is grey. ORTHOCONE_OPEN=1, or open_run("RUN_FOLDER", shows_open=True), shows
the whole surface with the values of open nodes.

One file: ParaView's window does not say to a script where it lies, so that it could not find others. pictures.py, for
pvbatch, imports it."""
import csv
import functools
import os
import pathlib
import sys
import xml.etree.ElementTree

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPUnstructuredGridReader, vtkXMLUnstructuredGridReader

# Pressure and stress are singular at edges: their colours cover these parts of the area and of the volume.
PRESSURE_WITHIN, STRESS_WITHIN = 0.95, 0.99
MOST_BYTES = 1_000_000_000  # of a file of a run
NOTHING = 1e-9  # mm, MPa: less is the round-off of an unloaded body
DARK, WHITE, PLANE = [0.13, 0.13, 0.16], [1, 1, 1], [0.87, 0.88, 0.9]
OPEN, SLIPPING = [0.6, 0.6, 0.62], [0.93, 0.42, 0.05]
STICKING = [-1, 0.03, 0.19, 0.42, -0.5, 0.26, 0.57, 0.78, 0, 0.85, 0.92, 0.97]  # criterion, red, green, blue; ...
COLUMNS = ("ux", "uy", "uz", "max_slip", "max_pressure", "stick_area", "elastic_energy", "max_wear_depth")  # of the history
CORNERS = np.array([[-1, 1, 1, -1] * 2, [-1, -1, 1, 1] * 2, [-1] * 4 + [1] * 4])  # of VTK's cells, x, y, z
UNLIT = {"Ambient": 1, "Diffuse": 0, "InterpolateScalarsBeforeMapping": 1}  # exactly the colours of the legend
LEGEND = {"ComponentTitle": "", "HorizontalTitle": 1, "TitleJustification": "Left", "TitleColor": DARK,
          "LabelColor": DARK, "TitleFontSize": 16, "LabelFontSize": 16, "AutomaticLabelFormat": 0,
          "LabelFormat": "%.4g", "RangeLabelFormat": "%.3g", "WindowLocation": "Any Location", "Position": [0.84, 0.14],
          "ScalarBarLength": 0.66, "ScalarBarThickness": 18}
BEYOND_CONTACT, MOST_OF_SURFACE = 1.3, 0.75  # of the radius of what touches, of that of the surface
OFFSET = "Translation" if simple.GetParaViewVersion() >= (5, 13) else "Position"  # the property has two names


class RunError(Exception):
    """What the user has to know, and the exit code if it is not 4."""


def require_ordinary(path):
    """Of a folder of somebody else: a pipe would be waited for, and a device has no end."""
    if path.exists() and (not path.is_file() or path.stat().st_size > MOST_BYTES):
        raise RunError(f"{path}: is no ordinary file of at most {MOST_BYTES} bytes")


class Grid:
    """Fields of a .vtu file at its points, and how far these reach around `centre`, by default their own."""
    def __init__(self, path, centre=None):
        require_ordinary(pathlib.Path(path))
        is_list = str(path).endswith(".pvtu")  # of the pieces of several processes
        reader, errors = (vtkXMLPUnstructuredGridReader if is_list else vtkXMLUnstructuredGridReader)(), []
        reader.AddObserver("ErrorEvent", lambda *_: errors.append(True))
        reader.SetFileName(str(path))
        reader.GlobalWarningDisplayOff()
        reader.Update()
        reader.GlobalWarningDisplayOn()
        self.path, self.data = path, reader.GetOutput()
        if errors or self.data.GetNumberOfPoints() == 0:
            raise RunError(f"{path}: cannot be read")
        self.points = vtk_to_numpy(self.data.GetPoints().GetData()).astype(float)
        self.centre = (self.points.min(axis=0) + self.points.max(axis=0))[:2] / 2 if centre is None else centre
        self.radius = np.hypot(*(self.points[:, :2] - self.centre).T).max()
        # Across the contact surface, or across the section of an axisymmetric body; None in a solid.
        self.flat_axis = next((axis for axis in (2, 1) if not self.points[:, axis].any()), None)
        starts = vtk_to_numpy(self.data.GetCells().GetOffsetsArray())
        sizes = np.diff(starts)[:, None]
        # A triangle among quadrilaterals is one whose last point is its first.
        places = starts[:-1, None] + np.arange(sizes.max()) % sizes
        self.cells = vtk_to_numpy(self.data.GetCells().GetConnectivityArray())[places]

    def __getitem__(self, name):
        field = self.data.GetPointData().GetArray(name)
        if field is None:
            raise RunError(f"{self.path}: no field '{name}'")
        return vtk_to_numpy(field).astype(float)

    def bound(self, name, part):
        """The value below which the field stays in a part of the area or volume. Points count with the sizes of their
        cells: graded meshes have most of them where the fields are singular."""
        corners = self.points[self.cells[:, :8 if self.flat_axis is None else 4]]
        edges = CORNERS[:, :corners.shape[1]] @ corners
        if self.flat_axis is not None:
            edges[:, 2] = np.eye(3)[self.flat_axis]
        if self.flat_axis == 1:  # a section: each cell is a ring
            edges[:, 2] *= corners[:, :, :1].mean(axis=1)
        weights = np.zeros(len(self.points))
        np.add.at(weights, self.cells, np.abs(np.linalg.det(edges))[:, None])
        values = self[name]
        weights[values < NOTHING] = 0  # a small contact in a large surface
        order = np.argsort(values)
        sums = np.cumsum(weights[order])
        return values[order][min(np.searchsorted(sums, part * sums[-1]), len(order) - 1)]


class Focus:
    """Where the views of the contact surface look, and whether what is open is grey: centre and radius of what touches in the
    steps of the largest values, with some room; the whole surface where that is most of it."""

    def __init__(self, run, grid, shows_open):
        self.centre, self.radius, self.shows_open, self.is_near = grid.centre, grid.radius, shows_open, False
        if shows_open:
            return
        touched = []
        for step in {run.peak(run.contact, column) for column in ("max_pressure", "elastic_energy", "max_slip")}:
            one = Grid(run.contact[step])
            touched.append(one.points[one["status"] > 0.5, :2])
        points = np.concatenate(touched)
        if len(points) < 2:
            return
        centre = (points.min(axis=0) + points.max(axis=0)) / 2
        radius = BEYOND_CONTACT * np.hypot(*(points - centre).T).max()
        if 0 < radius < MOST_OF_SURFACE * grid.radius:
            self.centre, self.radius, self.is_near = centre, radius, True


class Run:
    """A run folder: the steps that have files of fields, and the rows of the history."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder).expanduser().resolve()
        self.contact, self.volume, self.lower = self.files("contact"), self.files("volume"), self.files("lower")
        if not self.contact:
            raise RunError(f"{folder}: " + ("no contact.pvd: not a run folder, or the run had Output/Contact fields = 0"
                                            if self.folder.is_dir() else "no such folder"))
        require_ordinary(self.folder / "history.csv")
        try:
            with open(self.folder / "history.csv", encoding="ascii") as file:
                rows = {int(row["step"]): row for row in csv.DictReader(file)}
            self.n_steps = max(rows)
            self.rows = {step: {name: float({"max_wear_depth": 0, **rows[step]}[name]) for name in COLUMNS}  # older runs lack it
                         for step in (*self.contact, *self.volume)}
        except (OSError, KeyError, ValueError, TypeError) as error:
            raise RunError(f"{folder}: history.csv cannot be read, or a step is not in it ({error})") from error

    def files(self, kind):
        """Step -> file of a .pvd file; nothing where there is none."""
        path = self.folder / f"{kind}.pvd"
        require_ordinary(path)
        try:
            records = xml.etree.ElementTree.parse(path).getroot().findall(".//DataSet") if path.exists() else []
            return {int(float(record.attrib["timestep"])): self.folder / record.attrib["file"] for record in records}
        except (OSError, ValueError, KeyError, xml.etree.ElementTree.ParseError) as error:
            raise RunError(f"{path}: cannot be read ({error})") from error

    def peak(self, files, column):
        """Of the steps that have files, the one of the largest entry of a column."""
        return max(files, key=lambda step: self.rows[step][column])

    def titles(self, text, column=None, unit="", files=None):
        """The title of a view at each step; the first line ends with the entry of a column. Where there is no file of
        the step, ParaView shows the next one, and the title says so."""
        is_axial = not any(row[name] for row in self.rows.values() for name in ("ux", "uy"))
        titles = []
        for step in self.contact:
            row, files = self.rows[step], files or self.contact
            shown = min((other for other in files if other >= step), default=max(files))
            value = f" {row[column] if row[column] > NOTHING else 0:.4g} {unit}" if column else ""
            moved = f"uz = {row['uz']:g} mm" if is_axial else f"u = ({row['ux']:g}, {row['uy']:g}, {row['uz']:g}) mm"
            titles.append((float(step), f"{text}{value}{'' if shown == step else f', of step {shown}'}\n"
                                        f"{self.folder.name}, step {step} of {self.n_steps}, {moved}"))
        return titles


def scale(name, unit, upper, largest):
    """Upper end of the colours, never zero. It is printed: what lies above has the colour of the end."""
    upper = upper if upper > NOTHING else 1.0
    print(f"{name}: colours 0 to {upper:.6g} {unit}, values to {largest:.6g} {unit}")
    return upper


def new_view(reader, titles, focus, height, direction=(0, 0, 1), up=(0, 1, 0)):
    """An empty white view, by default from above, with a title that follows the steps."""
    view = simple.CreateView("RenderView")
    simple.SetProperties(view, UseColorPaletteForBackground=0, Background=WHITE, OrientationAxesLabelColor=DARK,
                         CameraParallelProjection=1, CameraParallelScale=height / 2, CameraFocalPoint=focus,
                         InteractionMode="2D" if up == (0, 1, 0) else "3D", CameraViewUp=up,
                         CameraPosition=[x + 10 * height * d for x, d in zip(focus, direction)])
    table = repr(titles).replace("{", r"\x7b").replace("}", r"\x7d")  # ParaView has a use of its own for braces
    title = simple.PythonAnnotation(Input=reader, Expression=f"dict({table}).get(t_value, '')")
    simple.Show(title, view, WindowLocation="Upper Left Corner", Justification="Left", FontSize=17, Color=DARK)
    return view


def show_plain(source, view, colour, offset, **properties):
    """In one colour, without light, moved by `offset`."""
    simple.Show(source, view, "GeometryRepresentation", ColorArrayName=[None, ""], AmbientColor=colour, Ambient=1,
                DiffuseColor=colour, Diffuse=0, **{OFFSET: offset}, **properties)


def show_field(source, view, name, unit, preset, upper, **properties):
    """Coloured by a field from 0 to `upper`, with a legend. Other runs in the same window have scales of their own."""
    display = simple.Show(source, view, "GeometryRepresentation", **properties)
    simple.ColorBy(display, ("POINTS", name), separate=True)
    colours = simple.GetColorTransferFunction(name, display, AutomaticRescaleRangeMode="Never")
    colours.ApplyPreset(preset, True)
    colours.RescaleTransferFunction(0, upper)
    legend = simple.GetScalarBar(colours, view)
    simple.SetProperties(legend, Title=unit, **LEGEND)
    display.SetScalarBarVisibility(view, True)
    return colours, legend


def surface_of(source, grid):
    """Triangles. Those in the Lagrange cells of a section follow the fields, fewer in each where cells are many."""
    level = 1 if len(grid.cells) > 3000 else 2 if len(grid.cells) > 200 else 3
    return simple.ExtractSurface(Input=source, NonlinearSubdivisionLevel=level)


def seen(surface, focus):
    """The disc on which the views look, so that there is room for title and legend beside it."""
    if not focus.is_near:
        return surface
    disc = simple.Clip(Input=surface, ClipType="Sphere", Invert=1)
    disc.ClipType.Center, disc.ClipType.Radius = [*focus.centre, 0], focus.radius
    return disc


def hide_open(view, surface, focus):
    """Grey over what is open: its values would bury the contact."""
    if not focus.shows_open:
        zone = simple.Clip(Input=surface, ClipType="Scalar", Scalars=["POINTS", "opens"], Value=0.5, Invert=0)
        show_plain(zone, view, OPEN, [0, 0, 0.02 * focus.radius])


def draw_values(name, unit, preset, column, within, run, view, surface, focus, lasts=False):
    """On the scale of the step in which the column of the history is largest; returns its upper end. What lasts stays where
    the surface has opened again."""
    grid = Grid(run.contact[run.peak(run.contact, column)])
    upper = scale(name.split("_")[0], unit, grid.bound(name, within), grid[name].max())
    show_field(surface, view, name, unit, preset, upper, **UNLIT)
    if not lasts:
        hide_open(view, surface, focus)
    return upper


def draw_slip(run, view, surface, focus):
    upper = draw_values("slip_magnitude", "mm", "Viridis (matplotlib)", "max_slip", 1, run, view, surface, focus)
    (x, y), radius = focus.centre, focus.radius
    lines = simple.Contour(Input=surface, ContourBy=["POINTS", "slip_magnitude"],
                           Isosurfaces=[upper * k / 10 for k in range(1, 10)])
    if not focus.shows_open:  # towards open nodes slip falls to zero at once, and lines would pile up
        lines = simple.Clip(Input=lines, ClipType="Scalar", Scalars=["POINTS", "opens"], Value=0.02, Invert=1)
    show_plain(lines, view, WHITE, [0, 0, 0.01 * radius], LineWidth=2)
    # Arrows stand on a grid of their own, symmetric whatever the mesh; at its places off the disc the slip is zero.
    s = 0.93 * radius
    corners = {name: [x + i * s, y + j * s, 0] for name, i, j in (("Origin", -1, -1), ("Point1", 1, -1), ("Point2", -1, 1))}
    places = simple.Plane(XResolution=14, YResolution=14, **corners)
    slip = simple.ResampleWithDataset(SourceDataArrays=surface, DestinationMesh=places)
    arrows = simple.Glyph(Input=slip, GlyphType="Arrow", GlyphMode="All Points", OrientationArray=["POINTS", "slip"],
                          ScaleArray=["POINTS", "slip"], ScaleFactor=0.16 * radius / upper)
    show_plain(arrows, view, DARK, [0, 0, 0.2 * radius])


def draw_friction(_run, view, surface, focus):
    """Zones that slip or are open have colours of their own, the ends of the legend."""
    colours, legend = show_field(surface, view, "friction_criterion", "", "Viridis (matplotlib)", 1, **UNLIT)
    colours.RGBPoints = [-1.08, *OPEN, -1.002, *OPEN, *STICKING, 0.002, *SLIPPING, 0.08, *SLIPPING]
    colours.ColorSpace, colours.NumberOfTableValues = "Lab", 1024
    colours.Annotations = ["-1.04", "open", "0.04", "slip"]
    simple.SetProperties(legend, UseCustomLabels=1, CustomLabels=[-1, -0.8, -0.6, -0.4, -0.2, 0], AddRangeLabels=0)
    for height, (name, colour) in enumerate((("slips", SLIPPING), ("opens", OPEN)), start=1):
        zone = simple.Clip(Input=surface, ClipType="Scalar", Scalars=["POINTS", name], Value=0.5, Invert=0)
        show_plain(zone, view, colour, [0, 0, 0.01 * height * focus.radius])
    outline = simple.Contour(Input=surface, ContourBy=["POINTS", "sticks"], Isosurfaces=[0.5])
    show_plain(outline, view, DARK, [0, 0, 0.03 * focus.radius], LineWidth=2.5)


CONTACT_VIEWS = [("slip", draw_slip, "Slip, largest", "max_slip", "mm"),
                 ("pressure", functools.partial(draw_values, "pressure", "MPa", "Plasma (matplotlib)", "max_pressure",
                                                PRESSURE_WITHIN), "Pressure, largest", "max_pressure", "MPa"),
                 ("friction", draw_friction, "Friction criterion, stick area", "stick_area", "mm²"),
                 ("wear", functools.partial(draw_values, "wear_depth", "mm", "Viridis (matplotlib)", "max_wear_depth", 1,
                                            lasts=True), "Worn depth, largest", "max_wear_depth", "mm")]


def magnification(moved, height):
    """1, 2, 5, 10, ... so that the largest displacement is drawn about as a fifth of the height."""
    steps = [digit * 10**power for power in range(9) for digit in (1, 2, 5)]
    return max([step for step in steps if step * moved <= 0.25 * height and moved > NOTHING], default=1)


def whole(body, grid):
    """With its mirror images: what is beyond a symmetry plane is not modelled."""
    for axis, name in enumerate("XY"):
        if axis != grid.flat_axis and grid.points[:, axis].min() > -NOTHING:
            body = simple.Reflect(Input=body, Plane=name, Center=0, FlipAllInputArrays=1)
    return body


def body_view(run, reader, centre):
    """Displacements enlarged, of the whole body whatever part of it is modelled; of an axisymmetric one the section
    through its axis."""
    if not run.volume:
        print(text := "Deformed body: no volume.pvd (Output/Volume fields = 0); a run with 1 writes it")
        return new_view(reader, run.titles(text), [0, 0, 0], 1)
    grid = Grid(run.volume[run.peak(run.volume, "elastic_energy")], centre)
    of_lower = Grid(run.lower[run.peak(run.volume, "elastic_energy")], centre) if run.lower else grid
    bounds, largest = zip(*((one.bound("von_mises_stress", STRESS_WITHIN), one["von_mises_stress"].max())
                            for one in (grid, of_lower)))
    upper = scale("body", "MPa", max(bounds), max(largest))
    radius, high = max(grid.radius, of_lower.radius), grid.points[:, 2].max()
    low = min(grid.points[:, 2].min(), of_lower.points[:, 2].min(), 0)
    height, (x, y) = high - low, centre
    factor = magnification(np.linalg.norm(grid["displacement"], axis=1).max(), height)
    view = new_view(reader, run.titles(f"Von Mises stress, displacement x {factor:g}", files=run.volume),
                    [x + 0.3 * radius, y + 0.15 * radius, low + 0.45 * height], 1.15 * height + 1.3 * radius,
                    [0.45, -0.8, 0.35], [0, 0, 1])
    show_body(run, view, "volume", grid, factor, upper)
    if run.lower:
        return show_body(run, view, "lower", of_lower, factor, upper)
    # A body that reaches below the plane has only its contact surface on it.
    plane = reader if low < 0 else simple.Disk(OuterRadius=1.15 * radius, InnerRadius=0, CircumferentialResolution=128)
    show_plain(plane, view, PLANE, [0 if low < 0 else x, 0 if low < 0 else y, -0.005 * height])
    return view


def show_body(run, view, kind, grid, factor, upper):
    """One of the two bodies, coloured by its stress, with its edges where they were; returns the view."""
    volume = simple.PVDReader(FileName=str(run.folder / f"{kind}.pvd"))
    body = simple.WarpByVector(Input=surface_of(volume, grid), Vectors=["POINTS", "displacement"], ScaleFactor=factor)
    show_field(whole(body, grid), view, "von_mises_stress", "MPa", "Plasma (matplotlib)", upper,
               **{**UNLIT, "Ambient": 0.55, "Diffuse": 0.5})
    merged = simple.CleantoGrid(Input=whole(volume, grid))  # no seam between mirror images
    show_plain(simple.FeatureEdges(Input=simple.ExtractSurface(Input=merged)), view, DARK, [0, 0, 0], LineWidth=1.5)
    return view


def open_run(folder, shows_open=False):
    """Makes the views. Returns the run, the views by name and their layout."""
    run = Run(folder)
    reader = simple.PVDReader(FileName=str(run.folder / "contact.pvd"))
    grid = Grid(next(iter(run.contact.values())))
    focus = Focus(run, grid, shows_open)
    zones, radius, (x, y) = reader, focus.radius, focus.centre
    for status, name in enumerate(("opens", "sticks", "slips")):
        zones = simple.Calculator(Input=zones, ResultArrayName=name, Function=f"status == {status}")
    surface, views = seen(surface_of(zones, grid), focus), {"body": body_view(run, reader, grid.centre)}
    is_worn = any(row["max_wear_depth"] for row in run.rows.values())
    for name, draw, *title in CONTACT_VIEWS[:4 if is_worn else 3]:
        views[name] = new_view(reader, run.titles(*title), [x + radius / 4, y, 0], 2.5 * radius)
        draw(run, views[name], surface, focus)
    for other in list(views.values())[2:]:
        simple.AddCameraLink(views["slip"], other, "slip and " + other.SMProxy.GetGlobalIDAsString())
    layout = simple.CreateLayout(run.folder.name)
    left = layout.SplitHorizontal(0, 0.5)
    top_left, top_right = layout.SplitVertical(left, 0.5), layout.SplitVertical(left + 1, 1 / 3 if is_worn else 0.5)
    for view, place in zip(views.values(), (top_left, top_right, top_left + 1, top_right + 1)):
        layout.AssignView(place, view)
    if is_worn:  # below the last one, which stays in the upper half of its place
        layout.AssignView(layout.SplitVertical(top_right + 1, 0.5) + 1, views["wear"])
    simple.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
    simple.GetAnimationScene().AnimationTime = run.peak(run.contact, "elastic_energy")
    return run, views, layout


def guarded(script, action, *arguments):
    """Reports what went wrong, in one line that begins with the name of the script; the exit code."""
    try:
        action(*arguments)
        return 0
    except (RunError, OSError) as error:
        words = (error.args if isinstance(error, RunError) else (f"{error.filename}: {error.strerror}",)) + (4,)
        print(f"{script}: {words[0]}", file=sys.stderr)
        return words[1]


if __name__ == "__main__" and "ORTHOCONE_RUN" in os.environ:
    guarded("contact.py", open_run, os.environ["ORTHOCONE_RUN"], os.environ.get("ORTHOCONE_OPEN", "0") not in ("", "0"))
