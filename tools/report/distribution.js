// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
"use strict";
// Which part of the area in contact carries which pressure, in the step of the maps.

class PressureDistribution {
  constructor(runs) {
    this.runs = runs.map((run, r) => run.along && {r, name: run.name, steps: run.along.steps, ...run.along.distribution})
      .filter(run => run && run.top > 0);
    byId("distribution-panel").hidden = !this.runs.length;
    this.chart = null;
  }

  /** The share of each class over the middle of its pressures. */
  classes({top, shares}, frame) {
    return {x: shares[frame].map((_, k) => (k + 0.5) * top / shares[frame].length), y: shares[frame]};
  }

  show(step) {
    if (!this.runs.length) return;
    const largest = Math.max(...this.runs.flatMap(run => run.shares.flat()));
    const series = this.runs.map(run => {
      const distances = run.steps.map(one => Math.abs(one - step)), frame = distances.indexOf(Math.min(...distances));
      return {name: "share", run: several ? run.name : "", colour: `var(--${several ? `r${run.r + 1}` : "c1"})`, dash: DASHES[0],
              ...this.classes(run, frame)};
    });
    const spec = {title: `Area in contact over its pressure, step ${step}`, shared: true, fixed: true, series,
                  x: {name: "pressure", unit: "MPa"}, y: {unit: "%", name: "", range: [0, largest]},
                  head: (one, i) => `p = ${numberText(one.x[i], 4)} MPa`};
    if (!this.chart) this.chart = new Chart(byId("distribution"), spec, () => {});
    this.chart.caption.firstChild.textContent = spec.title;
    this.chart.replace(spec);
  }
}
