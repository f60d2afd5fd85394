// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
"use strict";
// Stress, displacement and what acts on the surface along lines of the body, in a step that is chosen.

const LINE_CHARTS = [
  ["Stress", "MPa", ["xx", "yy", "zz", "xy", "xz", "yz"].map(axes => [`stress_${axes}`, `σ_${axes}`])],
  ["Displacement", "mm", ["x", "y", "z"].map(axis => [`u_${axis}`, `u_${axis}`])],
  ["Pressure and friction traction", "MPa", [["pressure", "pressure"], ["traction_x", "q_x"], ["traction_y", "q_y"]]],
];

/** Columns of a chart that are more than rounding in some step; none where the line has not even two such points. */
function columnsThatMatter(frames, columns) {
  if (frames[0][columns[0][0]].filter(value => value !== null).length < 2) return [];
  const sizes = columns.map(([column]) => largest(frames.flatMap(frame => rangeOf(frame[column]))));
  return columns.filter((_, k) => sizes[k] > 1e-6 * Math.max(...sizes));
}

/** One scale for all steps, so that what grows is seen to grow. */
function lineSpec({frames, name}, index, step, [what, unit, columns]) {
  const range = rangeOf(frames.flatMap(frame => columns.flatMap(([column]) => rangeOf(frame[column]))));
  const series = columns.map(([column, words], k) => (
    {name: words, run: "", colour: `var(--c${k % 4 + 1})`, dash: DASHES[(k + Math.floor(k / 4)) % 4],
     x: frames[index].s, y: frames[index][column]}));
  return {title: `${what} along ${name}, step ${step}`, shared: true, fixed: true, series,
          x: {name: "s", unit: "mm"}, y: {unit, name: "", range}, head: (one, i) => `s = ${numberText(one.x[i], 4)} mm`};
}

function drawBodyLine(line) {
  const parent = byId("body-lines");
  htmlElement(parent, "h3", {}, `Line ${line.name} from ${line.ends} mm`);
  const choice = htmlElement(parent, "p", {class: "choice"}), id = `step-of-line-${line.name}`;
  htmlElement(choice, "label", {for: id}, "Step");
  const select = htmlElement(choice, "select", {id});
  line.steps.forEach((step, k) => htmlElement(select, "option", {value: k}, `${step}`));
  select.value = line.steps.length - 1;
  const grid = htmlElement(parent, "div", {class: "grid"});
  const kinds = LINE_CHARTS.map(([what, unit, columns]) => [what, unit, columnsThatMatter(line.frames, columns)])
    .filter(([, , columns]) => columns.length);
  const specs = () => kinds.map(kind => lineSpec(line, Number(select.value), line.steps[select.value], kind));
  // Not among `charts`: a click on a place is no choice of a step.
  const drawn = specs().map(spec => new Chart(grid, spec, () => {}));
  select.addEventListener("change", () => specs().forEach((spec, k) => {
    drawn[k].caption.firstChild.textContent = spec.title;
    drawn[k].replace(spec);
  }));
}

function drawBodyLines() {
  data.lines.forEach(drawBodyLine);
}
