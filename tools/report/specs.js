// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
"use strict";
// From tables of the runs to charts.

const data = JSON.parse(byId("data").textContent);
const charts = [];
const several = data.runs.length > 1;
let player = null;  // of the maps, if there are maps

function addChart(parent, spec) {
  const chart = new Chart(parent, spec, step => step && player && player.toNearest(step));
  charts.push(chart);
  return chart;
}

/** Quantities that are zero or have no value throughout are in no chart; a line below the charts names them. */
class LeftOut {
  static of = new Map();  // of each place of charts, in the order in which they came

  static note(parent, words) {
    if (!LeftOut.of.has(parent)) LeftOut.of.set(parent, []);
    LeftOut.of.get(parent).push(words);
  }

  static say() {
    for (const [parent, names] of LeftOut.of) {
      const line = htmlElement(parent, "p", {class: "hint left-out"});
      line.textContent = `Zero throughout, and so not drawn: ${names.join("; ")}.`;
    }
    LeftOut.of.clear();
  }
}

/** A title within a sentence; names such as Q_x stay as they are. */
function inSentence(title) {
  return /^[A-Z][a-z]/.test(title) ? title[0].toLowerCase() + title.slice(1) : title;
}

function isZero(values, least = 0) {
  return values.every(value => value === null || value === undefined || Math.abs(value) <= least);
}

/** The series of quantities that are more than zero in any run. */
function withContent(parent, title, series, least) {
  const names = [...new Set(series.map(one => one.name))].filter(name =>
    series.filter(one => one.name === name).every(one => isZero(one.y, least)));
  const kept = series.filter(one => !names.includes(one.name));
  if (!kept.length) LeftOut.note(parent, inSentence(title));
  else for (const name of names) LeftOut.note(parent, `${name} (${inSentence(title)})`);
  return kept;
}

/** A curve for each run and column; colours distinguish the quantities of one run, or the runs, and dashes then the
 *  quantities. `tableOf` gives the table of a run. */
function curves(runs, tableOf, columns, x) {
  const overlaid = runs.length > 1;
  return runs.flatMap((run, r) => {
    const table = tableOf(run), gaps = x.column === "step" ? new Set(run.jumps.map(([, last]) => last + 1)) : null;
    const known = columns.map((column, k) => [...column, k]).filter(([column]) => table && table[column]);
    return known.map(([column, name, ...rest]) => {
      const k = rest.pop(), own = rest[0] || `c${k % 4 + 1}`;
      return {name, run: overlaid ? run.name : "", colour: `var(--${overlaid ? `r${r + 1}` : own})`,
              dash: DASHES[k % 4], steps: table[x.steps || "step"], x: table[x.column], y: table[column], gaps};
    });
  });
}

function addCurves(parent, title, series, x, unit, {log = false, name = "", least = 0, range, fit, ...more} = {}) {
  if (!series.some(one => one.x.length)) return null;
  const kept = withContent(parent, title, series, least);
  if (!kept.length) return null;
  return addChart(parent, {title, shared: true, series: kept, x, y: {unit, log, name, least, range, fit}, ...more});
}

/** Curves over the steps, of all runs; `tableOf` gives the table of a run. */
function overSteps(parent, title, tableOf, unit, columns, more = {}) {
  const separators = several ? [] : data.runs[0].blocks.map(block => block[1] - 0.5);
  const x = {name: "step", unit: "", whole: true};
  addCurves(parent, title, curves(data.runs, tableOf, columns, {column: "step"}), x, unit, {separators, ...more});
}

/** Paths of y over x, one a run; the cycles of a single one have their colours. */
function addPaths(parent, title, x, y, series, more = {}) {
  const {blocks} = data.runs[0], single = series.length === 1 && !series[0].run;
  const cycles = single && blocks.length > 1 ? blocks : undefined;
  if (!series.length) return;
  const rests = ["x", "y"].filter(axis => series.every(one => isZero(one[axis], (axis === "x" ? x : y).least)));
  if (rests.length === 2 || rests[0] === "y" && !more.equal) LeftOut.note(parent, inSentence(title));
  else addChart(parent, {title, x, y, series, cycles, ...more});
}

function largest(values) {
  return Math.max(...rangeOf(values).map(Math.abs));
}

/** Largest number of a column in any run. */
function largestOf(column) {
  return Math.max(0, ...data.runs.map(({history}) => history[column] ? largest(history[column]) : 0));
}

/** Rounding leaves forces of 1e-9 N where there are none; such curves would only hide the scale of the others. */
function axisColumns(stem, letter) {
  const matters = axis => largestOf(stem + axis) > 1e-6 * largestOf(stem + "z");
  return ["x", "y", "z"].filter(axis => axis === "z" || matters(axis)).map(axis => [stem + axis, `${letter}_${axis}`]);
}
