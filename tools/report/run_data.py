# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What the page knows of a run: its tables and parameters, the energy ledger, the state of the run."""
import functools
import re

import checked
import numpy as np
import outline
from cycle_table import jumped_energy
from following import is_running
from imported_body import ImportedBody
from load_program import LoadProgram, SignalProgram
from maps import Maps
from measured_law import MeasuredLaw
from run_folder import BadFile, RunFolder

NEEDED = ("step", "residual", "stick_area", "max_slip", "max_pressure", "total_dissipation", "n_open", "n_stick",
          "n_slip", "ux", "uy", "uz", "force_x", "force_y", "force_z", "elastic_energy", "dissipation")
OF_CYCLES = ("cycle", "n_cycles", "last_step")
CHECKS = ("equilibrium", "penetration", "complementarity", "friction_cone", "slip_rule", "energy_defect")


class RunData:
    def __init__(self, path):
        self.path = path
        self.notes = []
        self.is_running = is_running(path)  # before its tables are read: the end would be missed else
        self.run = RunFolder(path)
        self.history = self.read("history.csv", lambda: checked.columns(self.run.history, NEEDED))
        self.steps = np.asarray(self.history.get("step", ()), dtype=int)
        self.n_solved = len(self.steps)
        self.parameters = self.read("parameters.prm", lambda: checked.parameters(self.run.parameters))
        self.program = self.read("parameters.prm", self.load_program)
        self.summary = self.read("summary.json", lambda: checked.summary(self.run.summary), optional=True) or {}
        self.timing = self.read("timing.csv", lambda: checked.columns(self.run.timing), optional=True) or {}
        self.checks = self.read("checks.csv", lambda: checked.columns(self.run.checks))
        self.cycles = self.read("cycles.csv", lambda: checked.columns(self.run.cycles, OF_CYCLES, OF_CYCLES, "last_step"))
        self.blocks = self.program.blocks(self.steps)
        # Of friction that varies the page shows that of the centre, which the summary has.
        self.friction_varies = any(re.search("[xyz]", text) for text in self.friction_texts())
        centre = {"mu": (0, 0), "p": (1, 1), "angle_degrees": 0, **self.summary.get("friction", {})}
        self.law = self.parameters.get("Friction", {}).get("Law", "ellipses")
        # A law that is no ellipse has neither: what draws an ellipse is left out then.
        self.mu = self.p = None
        if self.law == "ellipses":
            self.mu = tuple(centre["mu"]) if self.friction_varies else self.pair("Coefficients")
            self.p = tuple(centre["p"]) if self.friction_varies else self.pair("Slip potential")
        self.angle = (centre["angle_degrees"] if self.friction_varies
                      else self.number("Friction", "Orthotropy angle", 0))
        obstacle = self.parameters.get("Obstacle", {})
        self.counterface = obstacle.get("Kind", "rigid")
        self.has_lower = self.counterface == "body"
        self.has_gap = obstacle.get("Gap", "0") != "0" or bool(obstacle.get("Gap file"))
        self.has_normal_z = not obstacle.get("Distance") and obstacle.get("Normal", "plane") == "plane"
        self.shape = self.parameters["Geometry"].get("Shape", "cylinder")
        self.is_plane = self.parameters["Geometry"].get("Kind", "solid") == "plane strain"
        self.box = self.read("parameters.prm", self.sizes)
        self.sheet = self.read("parameters.prm", self.sheet_sizes)
        self.height = self.box[2] if self.box else self.size("Height")
        self.probe_places = self.places_of_probes()
        self.energy = self.read("history.csv", self.energy_ledger)

    def load_program(self):
        entries = self.parameters["Load program"]
        return SignalProgram(self.history) if entries.get("Program file") else LoadProgram(entries)

    @functools.cached_property
    def maps(self):
        return Maps(self)

    def read(self, name, reader, optional=False):
        try:
            return reader()
        except FileNotFoundError:
            if optional:
                return None
            raise
        except (OSError, BadFile):
            raise
        except Exception as error:
            cause = f"no {error}" if isinstance(error, KeyError) else error
            raise BadFile(f"{self.path / name}: cannot be understood ({cause})") from error

    def number(self, section, entry, default=None):
        return self.read("parameters.prm", lambda: checked.number(self.parameters[section].get(entry, default), name=entry))

    def size(self, entry):
        """A length of the body, mm."""
        return self.read("parameters.prm", lambda: checked.number(self.parameters["Geometry"][entry], 0, entry))

    @functools.cached_property
    def body(self):
        """The body of a mesh file; None of another one, or where the file is gone."""
        return ImportedBody.of(self.parameters["Geometry"]) if self.shape == "file" else None

    @functools.cached_property
    def lower_body(self):
        """The same of the body below."""
        return ImportedBody.of(self.parameters["Lower geometry"])

    @functools.cached_property
    def outline(self):
        """The border of the contact surface, as polygons. Without contact fields it is that of the parameters, or of the
        mesh file; nothing if that is gone."""
        if self.maps.mesh:
            return outline.outline(self.maps.places, self.maps.quads)
        if self.shape == "file":
            if self.body is None:
                return []
            corners = self.body.contact_from_above().reshape(-1, 2)
            one, node = outline.distinct(corners)
            return outline.outline(corners[one], node.reshape(-1, 4))
        if self.box or self.sheet:
            return [np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) * (self.box or self.sheet)[:2] / 2]
        angles = np.linspace(0, 2 * np.pi, 96, endpoint=False)
        return [self.size("Radius") * np.stack([np.cos(angles), np.sin(angles)], axis=1)]

    @functools.cached_property
    def centre(self):
        """Of the contact surface, from which pictures of it are drawn, mm."""
        centre = outline.extent(self.outline)[0] if self.outline else np.zeros(2)
        return np.where(np.abs(centre) < 1e-6 * self.radius, 0, centre)  # rounding of the files

    @functools.cached_property
    def radius(self):
        """The largest distance of the contact surface from its centre, mm."""
        return float(f"{outline.extent(self.outline)[1]:.6g}") if self.outline else 1.

    @property
    def area(self):
        known = self.summary.get("scene", {}).get("area_mm2")
        return known or sum(map(outline.area, self.outline)) or 1.

    def sizes(self):
        """l_x, l_y, l_z of a box, in mm; None for another shape."""
        return self.lengths("Sizes", 3) if self.shape == "box" else None

    def sheet_sizes(self):
        """l_x, l_y of the grid on a half-space, in mm; None for another shape."""
        return self.lengths("Sizes", 2) if self.shape == "half-space" else None

    def lengths(self, entry, n):
        found = tuple(checked.number(size, 0, entry) for size in self.parameters["Geometry"][entry].split(","))
        if len(found) != n:
            raise ValueError(f"{entry}: {n} lengths are wanted")
        return found

    def friction_texts(self):
        words = ("associated", "collinear")
        return [text for name, text in self.parameters.get("Friction", {}).items()
                if name not in ("Law", "Rosette", "Factor") and text not in words]

    @property
    def has_factor(self):
        """Whether a factor of its own scales the friction of every node."""
        return self.parameters.get("Friction", {}).get("Factor", "1") != "1"

    @functools.cached_property
    def measured(self):
        """The tables of a law that is no ellipse."""
        return MeasuredLaw(self)

    def pair(self, entry):
        def two():
            text = self.parameters["Friction"][entry]
            if text == "associated":
                return self.mu
            if text == "collinear":
                return 1.0, 1.0
            x, y = (checked.number(number, name=entry) for number in text.split(","))
            if min(x, y) < 0 or (min(x, y) == 0 and (max(x, y) > 0 or entry != "Coefficients")):
                raise ValueError(f"{entry} = {text}")
            return x, y
        return self.read("parameters.prm", two)

    def places_of_probes(self):
        text = self.parameters.get("Output", {}).get("Probes", "")
        places = re.findall(r"([\w-]+)\s*:\s*(\S+)\s+([^\s;]+)", text)
        return self.read("parameters.prm", lambda: {name: (checked.number(x), checked.number(y)) for name, x, y in places})

    # --- the state of the run ---

    @property
    def n_planned(self):
        return self.summary.get("steps", {}).get("planned", self.program.n_steps)

    def status(self):
        """Kind (good, warned, bad, running) and text."""
        steps = f"{self.n_solved} of {self.n_planned} steps"
        if self.is_running:
            return "running", f"Still running: {steps} are solved"
        if not self.summary:
            return "bad", f"Interrupted: summary.json is missing. {steps} are in history.csv."
        if self.summary.get("status") != "complete":
            return "bad", f"Not complete, {steps}: {self.summary.get('status', '')}"
        n = len(self.summary.get("warnings", ()))
        return ("warned", f"Complete, with {n} warning{'s' if n > 1 else ''}") if n else ("good", "Complete")

    # --- energies ---

    @property
    def wears(self):
        return self.parameters.get("Wear", {}).get("Law", "none") != "none"

    @functools.cached_property
    def starts_unknown(self):
        """Steps behind a jump that wears: the energy that was stored at its end is not written."""
        return np.diff(self.steps, prepend=0) > 1 if self.wears else np.zeros(self.n_solved, dtype=bool)

    def energy_ledger(self):
        """Work of the top, by the trapezoidal rule unless the program recorded it, against what became of it."""
        if not self.n_solved:
            return {}
        h = self.history
        force = np.stack([h[f"force_{axis}"] for axis in "xyz"], axis=1)
        top = np.stack([h[f"u{axis}"] for axis in "xyz"], axis=1)
        before = np.zeros((1, 3))
        mean_force = (force + np.concatenate([before, force[:-1]])) / 2
        # The force of the plane on the body balances that of the top, hence the sign.
        work = -(mean_force * np.diff(top, axis=0, prepend=before)).sum(axis=1)
        if len(self.checks.get("work", ())) == self.n_solved:
            work = self.checks["work"]
        elastic, dissipation = h["elastic_energy"], h["dissipation"]
        step_defect = np.where(self.starts_unknown, np.nan, work - np.diff(elastic, prepend=0) - dissipation)
        scale = max(np.max(elastic), np.sum(dissipation), np.finfo(float).tiny)
        whole_work = np.cumsum(work) + jumped_energy(self, "work")
        whole_dissipation = np.cumsum(dissipation) + jumped_energy(self, "dissipation")
        return {"step": h["step"], "step_work": work, "step_dissipation": dissipation, "step_defect": step_defect,
                "work": whole_work, "elastic": elastic, "dissipation": whole_dissipation,
                "balance": whole_work - elastic - whole_dissipation,
                "relative_defect": np.abs(step_defect) / scale, "scale": scale}
