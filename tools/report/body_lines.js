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

/** Step of a line that is nearest to the given one: each run has steps of its own. */
function nearestStep({steps}, step) {
  return steps.reduce((best, one, k) => Math.abs(one - step) < Math.abs(steps[best] - step) ? k : best, 0);
}

/** One scale for all steps and runs, so that what grows is seen to grow. `lines` has [number of the run, line]. */
function lineSpec(lines, step, [what, unit, columns]) {
  const range = rangeOf(lines.flatMap(([, {frames}]) =>
    frames.flatMap(frame => columns.flatMap(([column]) => rangeOf(frame[column])))));
  const series = lines.flatMap(([r, line]) => columns.map(([column, words], k) => {
    const frame = line.frames[nearestStep(line, step)];
    return {name: words, run: several ? data.runs[r].name : "", colour: `var(--${several ? `r${r + 1}` : `c${k % 4 + 1}`})`,
            dash: DASHES[(k + (several ? 0 : Math.floor(k / 4))) % 4], x: frame.s, y: frame[column]};
  }));
  return {title: `${what} along ${lines[0][1].name}, step ${step}`, shared: true, fixed: true, series,
          x: {name: "s", unit: "mm"}, y: {unit, name: "", range}, head: (one, i) => `s = ${numberText(one.x[i], 4)} mm`};
}

function drawBodyLine(lines) {
  const parent = byId("body-lines"), [[, line]] = lines;
  htmlElement(parent, "h3", {}, `Line ${line.name} from ${line.ends} mm`);
  const choice = htmlElement(parent, "p", {class: "choice"}), id = `step-of-line-${line.name}`;
  htmlElement(choice, "label", {for: id}, "Step");
  const select = htmlElement(choice, "select", {id});
  line.steps.forEach((step, k) => htmlElement(select, "option", {value: k}, `${step}`));
  select.value = line.steps.length - 1;
  const grid = htmlElement(parent, "div", {class: "grid"}), frames = lines.flatMap(([, one]) => one.frames);
  const all = LINE_CHARTS.map(([what, unit, columns]) => [what, unit, columnsThatMatter(frames, columns)]);
  for (const [what, , columns] of all) if (!columns.length) LeftOut.note(grid, inSentence(what));
  const kinds = all.filter(([, , columns]) => columns.length);
  const specs = () => kinds.map(kind => lineSpec(lines, line.steps[select.value], kind));
  // Not among `charts`: a click on a place is no choice of a step.
  const charts = specs().map(spec => new Chart(grid, spec, () => {}));
  select.addEventListener("change", () => specs().forEach((spec, k) => {
    charts[k].caption.firstChild.textContent = spec.title;
    charts[k].replace(spec);
  }));
}

/** Lines of the same name lie over each other. */
function drawBodyLines() {
  const all = data.runs.flatMap((run, r) => run.lines.map(line => [r, line]));
  for (const name of new Set(all.map(([, line]) => line.name)))
    drawBodyLine(all.filter(([, line]) => line.name === name));
}
