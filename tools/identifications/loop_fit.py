# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Least squares of a scene's loops to measured ones, by Gauss and Newton with finite differences.

An iteration runs each loop once for every parameter that the program knows. The compliance of the rig costs no run
(loop_curves.py)."""
import dataclasses
import re

import numpy as np
from loop_curves import first_ways
from loop_runs import FailedRun
from measured_loops import ON_AXIS
from statistics_of_fit import Information

UNITS = {"mu_x": "", "mu_y": "", "mu": "", "slip_ratio": "", "rig_compliance": "mm/N", "young_modulus": "MPa"}
DIFFERENCE = 0.05  # of a parameter, for derivatives: nodes that begin to slip or to touch make smaller ones rough
MOST_ITERATIONS, LARGEST_STEP = 15, 0.6
SMALL_STEP, SMALL_CHANGE = 0.05, 5e-4  # of the standard errors, of a parameter: smaller steps end the fit
LAST_STEP, LAST_CHANGE = 0.5, 5e-3  # and these, if they do not lower the residual
SAME_SLOPES = 0.06  # change of a parameter up to which its derivatives are kept
SMALL_GAIN = 0.05  # of the variance: a sum of squares that changes by less is at its least
START_ABOVE = 1.15  # friction starts above the largest force over the normal force, which it cannot be below
NOTHING = 1e-7  # of the force amplitude
NOISE_OF_STEPS = 0.02  # while the fit is still far off, its residual is no noise


class WrongScene(ValueError):
    """The scene cannot be fitted; the words are one line."""


class NoFit(RuntimeError):
    """The fit did not converge; the words are one line."""


def two_numbers(text):
    """(a, b) of "a, b"; None for expressions."""
    try:
        first, second = (float(word) for word in text.split(","))
    except ValueError:
        return None
    return first, second


def in_friction_axes(loop, entries):
    """(2,): the unit vector of a loop's motion along the axes of friction; those of the body where their angle varies."""
    try:
        angle = np.radians(float(entries["Friction"].get("Orthotropy angle", "0")))
    except ValueError:
        angle = 0
    along = loop.direction @ [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
    return np.where(np.abs(along) < ON_AXIS, 0, along)


def start_values(names, loops, normal_force, entries):
    """{name: value} from the largest forces, and from the scene where no loop tells anything."""
    friction = entries["Friction"]
    coefficients = two_numbers(friction["Coefficients"])
    if {"mu", "mu_x", "mu_y", "slip_ratio"} & set(names):
        if coefficients is None or friction.get("Law", "ellipses") != "ellipses":
            raise WrongScene(f"Friction/Coefficients = {friction['Coefficients']} with Law = {friction.get('Law')}: allowed are "
                             "two numbers and Law = ellipses, or --fit rig_compliance")
        if not normal_force > 0:
            raise WrongScene("the preload does not press the bodies: allowed is a Preload with a normal force")
    found = {}
    for axis, name in enumerate(("mu_x", "mu_y")):
        ratios = [np.percentile(np.abs(loop.along()), 97) / normal_force for loop in loops
                  if abs(in_friction_axes(loop, entries)[axis]) > 0.5]
        found[name] = START_ABOVE * max(ratios) if ratios and name in names else (coefficients or (1, 1))[axis]
    found["mu"] = START_ABOVE * max(np.percentile(np.abs(loop.along()), 97) / normal_force for loop in loops)
    potential = {"associated": coefficients, "collinear": (1, 1)}.get(friction["Slip potential"]) or \
        two_numbers(friction["Slip potential"]) or (1, 1)
    found["slip_ratio"], found["rig_compliance"] = potential[0] / potential[1], 0.
    if "young_modulus" in names:
        found["young_modulus"] = float(re.match(r"[\d.eE+-]+", entries["Material"]["Young modulus"])[0])
    return found


def settings_of(names, values):
    """--set of the program for the parameters that are fitted."""
    found = []
    if "mu" in names:
        found.append(f"Friction/Coefficients={values['mu']:.12g}, {values['mu']:.12g}")
    elif "mu_x" in names or "mu_y" in names:
        found.append(f"Friction/Coefficients={values['mu_x']:.12g}, {values['mu_y']:.12g}")
    if "slip_ratio" in names:
        found.append(f"Friction/Slip potential={values['slip_ratio']:.12g}, 1")
    if "young_modulus" in names:
        found.append(f"Material/Young modulus={values['young_modulus']:.12g}")
    return found


class LoopFit:
    """The fit of `names` to loops. After solve(): values {name: number}, curves of each loop, and information."""

    def __init__(self, model, loops, names, normal_force, entries):
        self.model, self.loops, self.names, self.normal_force = model, loops, list(names), normal_force
        self.values = start_values(names, loops, normal_force, entries)
        self.along_axes = [in_friction_axes(loop, entries) for loop in loops]
        self.blind = set()  # (parameter, number of the loop)
        self.compliance_scale = min(loop.amplitude / loop.scale for loop in loops)
        self.ways = [first_ways(loop.direction, loop.amplitude) for loop in loops]

    def scale(self, name):
        """The size of a parameter: its value, or for the compliance that of the loop."""
        return self.compliance_scale if name == "rig_compliance" else self.values[name]

    def settings(self, values):
        return settings_of(self.names, values)

    def residual(self, curves, compliance):
        """(n,): model minus measurement over the force amplitude of the loop, for all components of all rows. Their mean over a
        loop is taken off, because neither the zero of the load cell nor where the loop began is known."""
        found = [(one.force(loop, compliance) @ loop.axes.T - loop.force) / loop.scale for loop, one in zip(self.loops, curves)]
        return np.concatenate([(one - one.mean(axis=0)).ravel() for one in found])

    def sequences(self):
        """[rows] of residuals that were measured one after the other: those of each component of each loop."""
        found, start = [], 0
        for loop in self.loops:
            rows = np.arange(start, start + loop.force.size).reshape(loop.force.shape)
            found += list(rows.T)
            start += loop.force.size
        return found

    def run(self, values, ways):
        return self.model.curves([(loop.direction, way, self.settings(values)) for loop, way in zip(self.loops, ways)])

    def jacobian(self, residual):
        """(n, p): by the scaled parameters, at the present values."""
        pairs = [(name, i) for name in self.names if name != "rig_compliance" for i in range(len(self.loops))
                 if (name, i) not in self.blind]
        moved = [{**self.values, name: self.values[name] * (1 + DIFFERENCE)} for name, _ in pairs]
        found = dict(zip(pairs, self.model.curves([(self.loops[i].direction, self.ways[i], self.settings(values))
                                                   for (_, i), values in zip(pairs, moved)])))
        columns, compliance = {}, self.values["rig_compliance"]
        for name in self.names:
            curves = [found.get((name, i), one) for i, one in enumerate(self.curves)]
            columns[name] = (self.residual(curves, compliance) - residual) / DIFFERENCE
        small = 1e-3
        columns["rig_compliance"] = (self.residual(self.curves, compliance + small * self.compliance_scale) - residual) / small
        self.note_blind(pairs, columns)
        return np.stack([columns[name] for name in self.names], axis=1)

    def note_blind(self, pairs, columns):
        """Loops along one axis of friction that do not feel the other axis or the slip rule need no further runs for them."""
        ends = np.cumsum([0, *(loop.force.size for loop in self.loops)])
        for name, i in pairs:
            is_across = {"mu_x": self.along_axes[i][0] == 0, "mu_y": self.along_axes[i][1] == 0,
                         "slip_ratio": not np.all(self.along_axes[i])}.get(name, False)
            if is_across and np.abs(columns[name][ends[i]:ends[i + 1]]).max() < NOTHING:
                self.blind.add((name, i))

    def bounded(self, compliance, curves):
        return max(compliance, 0.9 * max(one.least_compliance() for one in curves))

    def scan_compliance(self):
        """A start for the compliance: the best of many with the first run."""
        tried = self.compliance_scale * np.linspace(0, 1.5, 76)
        sums = [np.sum(self.residual(self.curves, compliance)**2) for compliance in tried]
        self.values["rig_compliance"] = float(tried[np.argmin(sums)])

    def trial(self, step):
        """Values a step on, with their runs: (values, ways, curves, residual)."""
        values = {**self.values, **{name: self.values[name] + change * self.scale(name) for name, change in zip(self.names, step)}}
        values["rig_compliance"] = self.bounded(values["rig_compliance"], self.curves)
        ways = [one.steps(loop.amplitude, values["rig_compliance"]) for loop, one in zip(self.loops, self.curves)]
        curves = self.run(values, ways)
        values["rig_compliance"] = self.bounded(values["rig_compliance"], curves)
        return values, ways, curves, self.residual(curves, values["rig_compliance"])

    def improve(self, step, residual):
        """The residual after the first of ever shorter steps that does not raise it; None if there is none."""
        step = step * min(1, LARGEST_STEP / max(np.abs(step).max(initial=0), 1e-300))
        for factor in (1, 0.5, 0.2, 0.05):
            try:
                values, ways, curves, found = self.trial(factor * step)
            except FailedRun as problem:
                if problem.code == 2:
                    raise
                continue
            if found @ found < (1 + 1e-3) * (residual @ residual):
                self.values, self.ways, self.curves = values, ways, curves
                return found
        return None

    def solve(self):
        """Fits. Raises NoFit and FailedRun."""
        self.curves = self.run(self.values, self.ways)
        if "rig_compliance" in self.names:
            self.scan_compliance()
        residual = self.improve(np.zeros(len(self.names)), np.full(1, np.inf))
        if residual is None:
            raise NoFit("the model could not be run along the loops")
        change = np.inf  # of the parameters since their derivatives were made
        for self.iterations in range(1, MOST_ITERATIONS + 1):
            if is_fresh := change > SAME_SLOPES:
                jacobian, change = self.jacobian(residual), 0
            self.information = Information(residual, jacobian, len(self.sequences()))
            found, step = self.improved(residual, is_fresh)
            if found is None:
                return
            change = np.inf if found is residual else change + step
            residual = found
        raise NoFit(f"the fit did not converge in {MOST_ITERATIONS} iterations; --fit with fewer parameters may help")

    def improved(self, residual, is_fresh):
        """The residual after a step, and the step; None where the fit is done, and the same residual where it takes new derivatives."""
        information = self.information
        step = information.step(min(information.noise, NOISE_OF_STEPS))
        gain, change = np.linalg.norm(information.jacobian @ step) / information.noise, np.abs(step).max(initial=0)
        if gain < SMALL_STEP or change < SMALL_CHANGE:
            return None, change
        found = self.improve(step, residual)
        if found is None and not is_fresh:
            return residual, change
        if found is None and gain > LAST_STEP and change > LAST_CHANGE:
            raise NoFit("no step lowers the residual any more, though its slope is not 0: the model may not fit these loops")
        if found is not None and abs(residual @ residual - found @ found) < SMALL_GAIN * information.noise**2:
            self.information = dataclasses.replace(information, residual=found)
            return None, change
        return found, change
