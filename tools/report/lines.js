// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
"use strict";
// Pressure, friction traction and slip along an axis of the contact surface, in the step of the maps.

/** Values of a run along both axes. */
class RunAlong {
  constructor({along, name, mu, angle, limits}, quantities) {
    Object.assign(this, {name, mu, angle, limits, quantities, places: along.places, steps: along.steps});
    this.frames = along.frames.map(frame => frame.map(line => new Float32Array(bytes(line).buffer)));
    this.windows = {};
  }

  /** The frame nearest to a step. */
  frameOf(step) {
    const distances = this.steps.map(one => Math.abs(one - step));
    return distances.indexOf(Math.min(...distances));
  }

  /** All values of a quantity along an axis in a frame. */
  all(axis, frame, name) {
    const n = this.places[axis].length, k = this.quantities.indexOf(name);
    return this.frames[frame][axis].subarray(k * n, (k + 1) * n);
  }

  /** First and last of the places on show: those that carry pressure in any step, and a third of their way beside them. A
   *  small contact would be a stroke in a wide body. */
  shown(axis) {
    const places = this.places[axis];
    if (!this.windows[axis]) {
      const presses = i => this.frames.some((_, frame) => this.all(axis, frame, "pressure")[i] > 0);
      const touched = places.filter((_, i) => presses(i));
      const low = touched[0], high = touched[touched.length - 1], beside = (high - low) / 3;
      const near = places.flatMap((place, i) => place >= low - beside && place <= high + beside ? [i] : []);
      this.windows[axis] = near.length > 4 ? [near[0], near[near.length - 1] + 1] : [0, places.length];
    }
    return this.windows[axis];
  }

  /** What is on show. Where the surface is open, it has no slip. */
  curves(axis, frame) {
    const of = name => Array.from(this.all(axis, frame, name).subarray(...this.shown(axis)));
    const pressure = of("pressure"), x = of("traction_x"), y = of("traction_y"), touches = of("touches");
    const inContact = values => values.map((value, i) => touches[i] < 0.5 ? null : value);
    return {place: this.places[axis].slice(...this.shown(axis)), pressure, traction_x: x, traction_y: y,
            traction: x.map((value, i) => Math.hypot(value, y[i])),
            limit: pressure.map((p, i) => frictionLimit(this, p, x[i], y[i])),
            slip_x: inContact(of("slip_x")), slip_y: inContact(of("slip_y"))};
  }
}

const ALONG = [["Pressure", "MPa", [["pressure", "pressure"]]],
               ["Friction traction", "MPa", [["traction_x", "q_x"], ["traction_y", "q_y"], ["traction", "size |q|"],
                                             ["limit", "limit: μ p along q", "soft"]]],
               ["Slip", "mm", [["slip_x", "slip_x"], ["slip_y", "slip_y"]]]];

class LineCharts {
  constructor(maps) {
    this.runs = data.runs.map((run, r) => run.along && Object.assign(new RunAlong(run, maps.line_quantities), {r}, maps.axes && {mu: null, limits: null}))
      .filter(Boolean);
    this.ranges = {};
    this.axes = maps.axes ?? ["x", "y"];  // of an unrolled surface: arc and axis
    this.charts = [];
    this.none = htmlElement(byId("line-panel"), "p", {class: "hint"});
    [...byId("line").options].forEach((option, axis) => {
      const across = (maps.centre ?? data.centre)[1 - axis];
      if (maps.axes) option.textContent = `along ${maps.axes[axis]}, through the middle`;
      else if (across !== 0) option.textContent = `along ${"xy"[axis]} (${"yx"[axis]} = ${numberText(across, 4)} mm)`;
    });
    byId("line").addEventListener("change", () => this.show(this.step));
  }

  get axis() {
    return Number(byId("line").value);
  }

  /** One scale for all steps, so that what grows is seen to grow. */
  range(names) {
    const key = `${this.axis} ${names}`;
    if (!this.ranges[key]) {
      const all = this.runs.flatMap(run => run.frames.map((_, frame) => run.curves(this.axis, frame)));
      this.ranges[key] = rangeOf(all.flatMap(curves => names.flatMap(name => rangeOf(curves[name]))));
    }
    return this.ranges[key];
  }

  show(step) {
    this.step = step;
    const along = this.axes[this.axis];
    const curves = this.runs.map(run => run.curves(this.axis, run.frameOf(step)));
    const specs = ALONG.map(([what, unit, columns]) => this.spec(`${what} along ${along}, step ${step}`, unit, columns,
                                                                 curves, along));
    if (!this.charts.length)  // Not among `charts`: a click on a place is no choice of a step.
      this.charts = specs.map(spec => new Chart(byId("line-charts"), spec, () => {}));
    specs.forEach((spec, k) => {
      this.charts[k].caption.firstChild.textContent = spec.title;
      this.charts[k].replace(spec);
      this.charts[k].figure.hidden = isZero(spec.y.range);
    });
    const none = ALONG.filter((_, k) => isZero(specs[k].y.range)).map(([what]) => inSentence(what));
    this.none.hidden = !none.length;
    this.none.textContent = `Zero throughout along ${along}, and so not drawn: ${none.join("; ")}.`;
  }

  spec(title, unit, columns, curves, along) {
    const series = this.runs.flatMap((run, k) => columns.map(([column, name, colour], c) => (
      {name: name.replace(/_[xy]$/, end => `_${this.axes["_x_y".indexOf(end) / 2]}`), run: several ? run.name : "", colour: `var(--${several ? `r${run.r + 1}` : colour || `c${c + 1}`})`,
       dash: DASHES[c], x: curves[k].place, y: curves[k][column]})));
    return {title, shared: true, fixed: true, series, x: {name: along, unit: "mm"},
            y: {unit, name: "", range: this.range(columns.map(([column]) => column))},
            head: (one, i) => `${along} = ${numberText(one.x[i], 4)} mm`};
  }
}

/** The largest friction traction in the direction of (x, y) under a pressure: on the friction ellipse, or on the curve of a
 *  table. */
function frictionLimit({mu, angle: degrees, limits}, pressure, x, y) {
  const size = Math.hypot(x, y);
  if (!(mu || limits) || !(size > 1e-9 * pressure))
    return null;
  if (limits)
    return pressure * limitAlong(limits, Math.atan2(y, x));
  const angle = degrees * Math.PI / 180, [a, b] = mu;
  const first = Math.cos(angle) * x + Math.sin(angle) * y, second = Math.cos(angle) * y - Math.sin(angle) * x;
  return pressure * size / Math.hypot(first / a, second / b);
}

/** Between limits at even angles all around. */
function limitAlong(limits, angle) {
  const n = limits.length, place = (angle / (2 * Math.PI) + 1) * n, before = Math.floor(place), part = place - before;
  return (1 - part) * limits[before % n] + part * limits[(before + 1) % n];
}
