// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
"use strict";
// Loops of the whole body and of the probes.

function onePath(run, r, steps, name, x, y) {
  const look = several ? {run: run.name, colour: `var(--r${r + 1})`} : {run: "", colour: "var(--c1)"};
  return {name, ...look, dash: "none", steps, x, y};
}

/** Always in N/mm: what was taken away from several loops has to be comparable. */
function lineWords(axis, {stiffness, offset, of}) {
  const rest = `${offset < 0 ? "−" : "+"} ${numberText(Math.abs(offset), 5)} N`;
  return `F_${axis} = ${numberText(stiffness, 6)} N/mm · u_${axis} ${rest} (${of})`;
}

function departureCaption(axis, runs) {
  const lines = runs.map(({name, departures}) =>
    `${several ? `${name}: ` : ""}${lineWords(axis, departures[axis])}`);
  return `Subtracted: ${lines.join("; ")}, the elastic part by least squares.`;
}

/** The loop is so thin that it only shows once the straight line is taken away. */
function addDeparture(axis) {
  const runs = data.runs.filter(run => run.departures[axis]);
  if (!runs.length) return;
  const name = `F_${axis} − line`;
  const series = runs.map(run => onePath(run, data.runs.indexOf(run), run.history.step, name, run.history[`u${axis}`],
                                         run.departures[axis].values));
  addPaths(byId("body-loops"), `F_${axis} over u_${axis}, without the elastic part`, {name: `u_${axis}`, unit: "mm"},
           {name, unit: "N", least: Math.max(...runs.map(run => run.departures[axis].least))}, series,
           {caption: departureCaption(axis, runs)});
}

function drawBodyLoops() {
  for (const axis of ["x", "y", "z"]) {
    if (largestOf(`u${axis}`) === 0) continue;
    const name = `F_${axis}`;
    const series = data.runs.map((run, r) => onePath(run, r, run.history.step, name, run.history[`u${axis}`],
                                                     run.history[`force_${axis}`])).filter(one => one.x);
    addPaths(byId("body-loops"), `F_${axis} over u_${axis} of the top`, {name: `u_${axis}`, unit: "mm"},
             {name, unit: "N"}, series);
    addDeparture(axis);
  }
  for (const axis of ["x", "y", "z"]) {
    if (largestOf(`r${axis}`) === 0) continue;
    const name = `M_${axis}`;
    const series = data.runs.map((run, r) => onePath(run, r, run.history.step, name, run.history[`r${axis}`],
                                                     run.history[`moment_${axis}`])).filter(one => one.x);
    addPaths(byId("body-loops"), `M_${axis} over r_${axis} of the top`, {name: `r_${axis}`, unit: "degrees"},
             {name, unit: "N mm"}, series);
  }
}

function ellipsePoints([a, b], degrees) {
  const c = Math.cos(degrees * Math.PI / 180), s = Math.sin(degrees * Math.PI / 180);
  return Array.from({length: 120}, (_, k) => {
    const x = a * Math.cos(k * Math.PI / 60), y = b * Math.sin(k * Math.PI / 60);
    return [c * x - s * y, s * x + c * y];
  });
}

/** Loops, paths and histories of a probe of the first run. */
function drawProbeLoops({name, place, table: t}) {
  if (!t.step.length) return;
  const {history} = data.runs[0];
  const slip = {unit: "mm", least: 1e-9 * largest(history.max_slip)};
  const force = {unit: "N", least: 1e-9 * largest(history.force_z)};
  htmlElement(byId("probe-loops"), "h3", {}, `Probe ${name}${place ? ` at (${place[0]}, ${place[1]}) mm` : ""}`);
  const grid = htmlElement(byId("probe-loops"), "div", {class: "grid"});
  const norm = (x, y) => x.map((value, i) => Math.hypot(value, y[i]));
  const over = (x, y) => x.map((value, i) => y[i] > 0 ? value / y[i] : null);
  const path = (title, x, y, xs, ys, more) => addPaths(grid, title, x, y, [
    {name: y.name, run: "", colour: "var(--c1)", dash: "none", steps: t.step, x: xs, y: ys}], more);
  path("Tangential force against slip", {name: "slip", ...slip}, {name: "tangential force", ...force},
       norm(t.slip_x, t.slip_y), norm(t.force_x, t.force_y));
  path("Path of slip", {name: "slip_x", ...slip}, {name: "slip_y", ...slip}, t.slip_x, t.slip_y, {equal: true});
  path("Path of the friction force", {name: "force_x", ...force}, {name: "force_y", ...force}, t.force_x, t.force_y,
       {equal: true});
  path("Path in the friction ellipse (dashed)", {name: "force_x / force_n", unit: ""},
       {name: "force_y / force_n", unit: ""}, over(t.force_x, t.force_n), over(t.force_y, t.force_n),
       {equal: true, outline: ellipsePoints(data.mu, data.angle)});
  overStepsOfFirst(grid, "Slip over the steps", t, "mm", [["slip_x", "slip_x"], ["slip_y", "slip_y"],
                                                          ["accumulated_slip", "accumulated"]], {least: slip.least});
  overStepsOfFirst(grid, "Forces over the steps", t, "N",
                   [["force_n", "force_n"], ["force_x", "force_x"], ["force_y", "force_y"]], {least: force.least});
}
