# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Fields on the contact surface for the page: one mesh, and a byte for each value of each frame."""
import base64
import contextlib
import functools
import io

import checked
import numpy as np
from distribution import distribution, node_areas
from lines import QUANTITIES, Line, fields_of
from load_program import choose_steps, nearest, spread_steps
from outline import distinct
from unrolled import Chart, unrolled

MOST_FRAMES = 60
MOST_SMALL_MAPS = 15
FLAT = 0.02  # height of a surface by its length, up to which it is not drawn in space
MOST_VALUES = 375_000  # nodes times frames: six bytes each keep the page below some 3 MB
FIELDS = ("slip_magnitude", "pressure", "friction_criterion", "accumulated_slip", "dissipated_energy")
NEEDED = (*FIELDS, "friction_traction", "slip", "status")
WORN = "wear_depth"  # of runs whose surface wears
FACTOR = "friction_factor"  # of friction with memory


def packed(array):
    return base64.b64encode(np.ascontiguousarray(array).tobytes()).decode()


class Maps:
    """The frames of the slider; none for a run that wrote no contact fields. `kind` is the beginning of the names of the
    files: a surface with files of its own has maps of its own."""

    def __init__(self, data, kind="contact"):
        self.data, self.kind = data, kind
        self.all_steps = data.run.contact_steps(kind)
        self.mesh = self.file(self.all_steps[0]) if self.all_steps else None
        self.names = FIELDS
        if self.mesh:
            last = self.file(self.all_steps[-1])
            if last is not None and WORN in last.data and last[WORN].max() > 0:
                self.names = (*FIELDS, WORN)
            if last is not None and FACTOR in last.data:
                self.names = (*self.names, FACTOR)
            self.nodes, self.node_of_point = distinct(self.mesh.points)
            chart = self.chart(self.node_of_point[self.mesh.quadrilaterals()])
            self.places, self.quads, self.axes, self.directions = chart.places, chart.quads, chart.axes, chart.directions
            self.nodes = self.nodes[chart.points]
            self.in_space = self.mesh.points[self.nodes]

    def chart(self, quads):
        places = self.mesh.points[self.nodes]
        return unrolled(places, quads) or Chart(places[:, :2], np.arange(len(places)), quads)

    def file(self, step):
        def contact():
            with contextlib.redirect_stderr(io.StringIO()):  # meshio prints before it gives up
                return checked.fields(self.data.run.contact(step, self.kind), NEEDED, (WORN, FACTOR))
        return self.data.read(self.name(step), contact)

    def name(self, step):
        return f"{self.kind}-{step:04d}.vtu"

    @functools.cached_property
    def steps(self):
        """Those of the frames."""
        if not self.mesh:
            return []
        limit = max(2, min(MOST_FRAMES, MOST_VALUES // len(self.nodes)))
        chosen = choose_steps(self.all_steps, limit, self.data.blocks)
        if len(chosen) < len(self.all_steps):
            self.data.notes.append(f"The maps show {len(chosen)} of the {len(self.all_steps)} steps that have contact "
                                   "fields.")
        return chosen

    @functools.cached_property
    def lines(self):
        return [Line(self.places, self.quads, axis, self.centre[1 - axis]) for axis in (0, 1)]

    @property
    def centre(self):
        """Of the map; that of an unrolled surface is its own."""
        return (self.places.min(axis=0) + self.places.max(axis=0)) / 2 if self.axes else self.data.centre

    def line_payload(self, steps):
        """Tractions and slip along both axes in those of the steps that have a file, or are nearest to one."""
        if not self.mesh or not steps:
            return None
        steps = sorted({nearest(self.all_steps, step) for step in steps})
        frames = [self.data.read(self.name(step), lambda step=step: fields_of(self.file(step), self.nodes,
                                                                                     self.directions)) for step in steps]
        return {"places": [line.payload for line in self.lines], "steps": steps,
                "frames": [[line.values(fields) for line in self.lines] for fields in frames],
                "distribution": distribution(frames, node_areas(self.places, self.quads))}

    def frame(self, step):
        return self.data.read(self.name(step), lambda: self.fields(step, self.file(step)))

    def fields(self, step, file):
        frame = {"step": step, "status": packed(file["status"][self.nodes].astype(np.uint8))}
        for name in self.names:
            values = file[name][self.nodes].astype(float)
            low, high = float(values.min()), float(values.max())
            levels = np.round((values - low) / (high - low or 1) * 255).astype(np.uint8)
            frame[name] = {"low": low, "high": high, "levels": packed(levels)}
        return frame

    def is_flat(self):
        """Whether a view from above shows the surface as it is."""
        extents = np.ptp(self.in_space, axis=0)
        return extents[2] <= FLAT * extents.max()

    def payload(self):
        if not self.steps:
            return None
        index = np.uint16 if len(self.nodes) < 2**16 else np.uint32
        places = self.places
        own = {"axes": self.axes, "centre": [float(f"{place:.9g}") for place in self.centre],
               "radius": float(f"{np.hypot(*(places - self.centre).T).max():.9g}")} if self.axes else {}
        if not self.is_flat():
            own["space"] = packed(self.in_space.astype(np.float32))
        return {**own, "x": packed(places[:, 0].astype(np.float32)), "y": packed(places[:, 1].astype(np.float32)),
                "quads": packed(self.quads.astype(index)), "index_bytes": index().nbytes,
                "small": spread_steps(self.steps, MOST_SMALL_MAPS, self.data.blocks),
                "line_quantities": QUANTITIES, "frames": [self.frame(step) for step in self.steps]}
