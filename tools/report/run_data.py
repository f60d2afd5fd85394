# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What the page shows of a run: tables thinned where they are long, the energy ledger, the state of the run."""
import re

import numpy as np
from load_program import LoadProgram, choose_steps
from maps import Maps
from run_folder import RunFolder

MOST_CELLS = 60_000  # numbers of one kind of table in the page
NEEDED = ("step", "residual", "stick_area", "max_slip", "max_pressure", "total_dissipation", "n_open", "n_stick",
          "n_slip")
CHECKS = ("equilibrium", "penetration", "complementarity", "friction_cone", "slip_rule", "energy_defect")


class BadFile(Exception):
    """A file of the run cannot be understood."""


def numbers(values):
    """Seven digits, and null for what is no number: JSON knows no infinity."""
    return [float(f"{value:.7g}") if np.isfinite(value) else None for value in np.asarray(values, dtype=float)]


class RunData:
    def __init__(self, path):
        self.path = path
        self.notes = []
        self.run = self.read("history.csv", lambda: RunFolder(path))
        self.history = self.run.history
        self.read("history.csv", self.check_history)
        self.n_solved = len(self.history.get("step", ()))
        self.parameters = self.read("parameters.prm", self.run.parameters)
        self.program = self.read("parameters.prm", lambda: LoadProgram(self.parameters["Load program"]))
        self.summary = self.read("summary.json", self.run.summary, optional=True) or {}
        self.timing = self.read("timing.csv", self.run.timing, optional=True) or {}
        self.checks = self.read("checks.csv", self.run.checks)
        self.blocks = [block for block in self.program.blocks() if block.first <= self.n_solved]
        self.mu = self.pair("Coefficients")
        self.p = self.pair("Slip potential")
        self.angle = self.number("Friction", "Orthotropy angle", 0)
        self.radius = self.number("Geometry", "Radius")
        self.height = self.number("Geometry", "Height")
        self.probe_places = self.places_of_probes()
        self.energy = self.read("history.csv", self.energy_ledger)
        self.maps = Maps(self)

    def read(self, name, reader, optional=False):
        try:
            return reader()
        except FileNotFoundError:
            if optional:
                return None
            raise
        except OSError:
            raise
        except (Exception, SystemExit) as error:  # meshio exits on some files and raises what it likes on others
            cause = ("meshio does not read it" if isinstance(error, SystemExit) else "a line is incomplete"
                     if isinstance(error, TypeError) and name.endswith(".csv") else error)
            raise BadFile(f"{self.path / name}: cannot be understood ({cause})") from error

    def check_history(self):
        for name in NEEDED if self.history else ():
            if name not in self.history:
                raise ValueError(f"no column {name}")
            if not isinstance(self.history[name], np.ndarray):
                raise ValueError(f"column {name} does not hold numbers only")

    def number(self, section, entry, default=None):
        return self.read("parameters.prm", lambda: float(self.parameters[section].get(entry, default)))

    def pair(self, entry):
        def two():
            x, y = self.parameters["Friction"][entry].split(",")
            return float(x), float(y)
        return self.read("parameters.prm", two)

    def places_of_probes(self):
        text = self.parameters.get("Output", {}).get("Probes", "")
        places = re.findall(r"([\w-]+)\s*:\s*(\S+)\s+([^\s;]+)", text)
        return self.read("parameters.prm", lambda: {name: (float(x), float(y)) for name, x, y in places})

    # --- the state of the run ---

    @property
    def n_planned(self):
        return self.summary.get("steps", {}).get("planned", self.program.n_steps)

    def status(self):
        """Kind (good, bad) and text."""
        if not self.summary:
            return "bad", (f"Interrupted, or still running: summary.json is missing. {self.n_solved} of "
                           f"{self.n_planned} steps are in history.csv.")
        if self.summary.get("status") == "complete":
            return "good", "Complete"
        return "bad", f"Not complete, {self.n_solved} of {self.n_planned} steps: {self.summary.get('status', '')}"

    # --- tables of the page ---

    def table(self, columns, names, steps):
        """Columns `names` at those of the steps that the table has."""
        at = {int(step): row for row, step in enumerate(columns.get("step", ()))}
        rows = [at[step] for step in steps if step in at]
        return {"step": [step for step in steps if step in at],
                **{name: numbers(columns[name][rows]) for name in names if name in columns and rows}}

    def chosen_steps(self, n_columns, what):
        steps = [int(step) for step in self.history.get("step", ())]
        chosen = choose_steps(steps, max(100, MOST_CELLS // max(1, n_columns)), self.blocks)
        if len(chosen) < len(steps):
            self.notes.append(f"{what} show {len(chosen)} of {len(steps)} steps.")
        return chosen

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
        step_defect = work - np.diff(elastic, prepend=0) - dissipation
        scale = max(np.max(elastic), np.sum(dissipation), np.finfo(float).tiny)
        return {"step": h["step"], "step_work": work, "step_dissipation": dissipation, "step_defect": step_defect,
                "work": np.cumsum(work), "elastic": elastic, "dissipation": np.cumsum(dissipation),
                "balance": np.cumsum(step_defect), "relative_defect": np.abs(step_defect) / scale, "scale": scale}

    def probes(self):
        names = self.read("probe-*.csv", self.run.probe_names)
        columns = ("slip_x", "slip_y", "accumulated_slip", "force_n", "force_x", "force_y", "pressure")
        steps = self.chosen_steps(len(columns) * len(names), "Charts of the probes") if names else []
        return [{"name": name, "place": self.probe_places.get(name),
                 "table": self.table(self.read(f"probe-{name}.csv", lambda name=name: self.run.probe(name)), columns,
                                     steps)}
                for name in names]

    def payload(self):
        """Everything that the scripts of the page draw."""
        names = [name for name in self.history if name not in ("step", "method")]
        frames = self.maps.steps()
        steps = sorted({*self.chosen_steps(len(names), "Charts"), *frames})
        blocks = [block for block in self.blocks if block.part_of(steps)]
        ledger = [name for name in self.energy if name not in ("step", "scale")]
        return {"history": self.table(self.history, names, steps),
                "energy": self.table(self.energy, ledger, steps),
                "checks": self.table(self.checks, CHECKS, steps) if self.checks else None,
                "timing": self.table(self.timing, ("seconds",), steps),
                "probes": self.probes(), "maps": self.maps.payload(frames),
                "area": np.pi * self.radius**2, "radius": self.radius, "mu": self.mu, "angle": self.angle,
                "tolerance": self.number("Contact solver", "Tolerance", 0),
                "blocks": [[block.name, block.first, block.last] for block in blocks]}
