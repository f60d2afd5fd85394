// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
"use strict";
// Pressure, friction traction and slip along an axis of the contact surface, in the step of the maps.

class LineCharts {
  constructor(maps) {
    this.places = maps.line_places;
    this.names = maps.line_quantities;
    this.lines = maps.frames.map(frame => frame.lines.map(line => new Float32Array(bytes(line).buffer)));
    this.ranges = {};
    this.windows = {};
    this.charts = [];
    [...byId("line").options].forEach((option, axis) => {
      const across = data.centre[1 - axis];
      if (across !== 0) option.textContent = `along ${"xy"[axis]} (${"yx"[axis]} = ${numberText(across, 4)} mm)`;
    });
    byId("line").addEventListener("change", () => this.show(this.frame, this.step));
  }

  get axis() {
    return Number(byId("line").value);
  }

  /** All values of a quantity along the axis in a frame. */
  all(frame, name) {
    const n = this.places[this.axis].length, k = this.names.indexOf(name);
    return this.lines[frame][this.axis].subarray(k * n, (k + 1) * n);
  }

  /** First and last of the places on show: those that carry pressure in any step, and a third of their way beside them. A
   *  small contact would be a stroke in a wide body. */
  get shown() {
    const places = this.places[this.axis];
    if (!this.windows[this.axis]) {
      const presses = i => this.lines.some((_, frame) => this.all(frame, "pressure")[i] > 0);
      const touched = places.filter((_, i) => presses(i));
      const low = touched[0], high = touched[touched.length - 1], beside = (high - low) / 3;
      const near = places.flatMap((place, i) => place >= low - beside && place <= high + beside ? [i] : []);
      this.windows[this.axis] = near.length > 4 ? [near[0], near[near.length - 1] + 1] : [0, places.length];
    }
    return this.windows[this.axis];
  }

  /** Those on show. */
  values(frame, name) {
    return Array.from(this.all(frame, name).subarray(...this.shown));
  }

  curves(frame) {
    const of = name => this.values(frame, name);
    const pressure = of("pressure"), x = of("traction_x"), y = of("traction_y");
    return {pressure, traction_x: x, traction_y: y, traction: x.map((value, i) => Math.hypot(value, y[i])),
            limit: pressure.map((p, i) => frictionLimit(p, x[i], y[i])), slip_x: of("slip_x"), slip_y: of("slip_y")};
  }

  /** One scale for all steps, so that what grows is seen to grow. */
  range(names) {
    const key = `${this.axis} ${names}`;
    if (!this.ranges[key]) {
      const all = this.lines.map((_, frame) => this.curves(frame));
      this.ranges[key] = rangeOf(all.flatMap(curves => names.flatMap(name => rangeOf(curves[name]))));
    }
    return this.ranges[key];
  }

  show(frame, step) {
    [this.frame, this.step] = [frame, step];
    const curves = this.curves(frame), along = "xy"[this.axis];
    const specs = [["Pressure", "MPa", [["pressure", "pressure"]]],
                   ["Friction traction", "MPa", [["traction_x", "q_x"], ["traction_y", "q_y"], ["traction", "size |q|"],
                                                 ["limit", "limit: μ p along q", "soft"]]],
                   ["Slip", "mm", [["slip_x", "slip_x"], ["slip_y", "slip_y"]]]]
      .map(([what, unit, columns]) => this.spec(`${what} along ${along}, step ${step}`, unit, columns, curves, along));
    if (!this.charts.length) {
      // Not among `charts`: a click on a place is no choice of a step.
      this.charts = specs.map(spec => new Chart(byId("line-charts"), spec, () => {}));
      return;
    }
    specs.forEach((spec, k) => {
      this.charts[k].caption.firstChild.textContent = spec.title;
      this.charts[k].replace(spec);
    });
  }

  spec(title, unit, columns, curves, along) {
    const series = columns.map(([column, name, colour], k) => (
      {name, run: "", colour: `var(--${colour || `c${k + 1}`})`, dash: DASHES[k],
       x: this.places[this.axis].slice(...this.shown), y: curves[column]}));
    return {title, shared: true, fixed: true, series, x: {name: along, unit: "mm"},
            y: {unit, name: "", range: this.range(columns.map(([column]) => column))},
            head: (one, i) => `${along} = ${numberText(one.x[i], 4)} mm`};
  }
}

/** The largest friction traction in the direction of (x, y) under a pressure: on the friction ellipse. */
function frictionLimit(pressure, x, y) {
  if (!data.mu)
    return null;
  const angle = data.angle * Math.PI / 180, [a, b] = data.mu;
  const first = Math.cos(angle) * x + Math.sin(angle) * y, second = Math.cos(angle) * y - Math.sin(angle) * x;
  const size = Math.hypot(x, y), norm = Math.hypot(first / a, second / b);
  return size > 1e-9 * pressure ? pressure * size / norm : null;
}
