// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
"use strict";
// Loops of the whole body and of the probes.

function onePath(run, r, steps, name, x, y) {
  const look = several ? {run: run.name, colour: `var(--r${r + 1})`} : {run: "", colour: "var(--c1)"};
  return {name, ...look, dash: "none", steps, x, y};
}

// Motion and force of a component, and how the page calls them. Along and about the plane the force is that of the top on
// the body, as fretting loops are drawn, else that of the plane: see tools/report/loops.py.
const LOOPS = {
  x: {motion: "ux", force: "force_x", sign: -1, of: "u_x", name: "Q_x"},
  y: {motion: "uy", force: "force_y", sign: -1, of: "u_y", name: "Q_y"},
  rz: {motion: "rz", force: "moment_z", sign: -1, of: "r_z", name: "M_z"},
  z: {motion: "uz", force: "force_z", sign: 1, of: "u_z", name: "F_z"},
  rx: {motion: "rx", force: "moment_x", sign: 1, of: "r_x", name: "M_x"},
  ry: {motion: "ry", force: "moment_y", sign: 1, of: "r_y", name: "M_y"},
};
const FRETTING = ["x", "y", "rz"];
const motionUnit = component => component.startsWith("r") ? "degrees" : "mm";
const forceUnit = component => component.startsWith("r") ? "N mm" : "N";

/** A sum of forces leaves 1e-9 N where there is none; the moment of such a force has a lever of 1 mm. */
const leastForce = () => 1e-6 * largestOf("force_z");

/** Always in the same units: what was taken away from several loops has to be comparable. */
function lineWords(component, {stiffness, offset, of}) {
  const {of: motion, name} = LOOPS[component], unit = forceUnit(component);
  const slope = `${numberText(stiffness, 6)} ${unit}/${motionUnit(component).replace("degrees", "degree")}`;
  const rest = `${offset < 0 ? "−" : "+"} ${numberText(Math.abs(offset), 5)} ${unit}`;
  return `${name} = ${slope} · ${motion} ${rest} (${of})`;
}

/** Words of every run that moves in this way. */
function ofRuns(component, words) {
  const said = data.runs.map(run => [run.name, run.departures[component] && words(run.departures[component], component)]);
  return said.filter(([, text]) => text).map(([name, text]) => `${several ? `${name}: ` : ""}${text}`).join("; ");
}

/** Three energies of the same steps, and what each counts. */
function areaWords({area, loop, loop_work: work, loop_dissipation: dissipation}, component) {
  return loop && `${numberText(area, 4)} N mm in ${loop}, the work of ${LOOPS[component].name} alone; all components do `
    + `${numberText(work, 4)} N mm of work there, and friction dissipates ${numberText(dissipation, 4)} N mm`;
}

function addLoop(grid, component) {
  const {motion, force, sign, of, name} = LOOPS[component], isFretting = FRETTING.includes(component);
  const runs = data.runs.filter(({history}) => history[motion] && history[force]);
  const series = runs.map(run => onePath(run, data.runs.indexOf(run), run.history.step, name, run.history[motion],
                                         run.history[force].map(value => value === null ? null : sign * value)));
  const area = isFretting ? ofRuns(component, areaWords) : "";
  addPaths(grid, isFretting ? `Fretting loop: ${name} over ${of}` : `${name} over ${of} of the held face`,
           {name: of, unit: motionUnit(component)}, {name, unit: forceUnit(component), least: leastForce()}, series,
           {caption: area && `Area of the loop: ${area}.`});
}

/** The loop is so thin that it only shows once the straight line is taken away. */
function addDeparture(grid, component) {
  const runs = data.runs.filter(run => run.departures[component] && !isZero(run.history[LOOPS[component].force], leastForce()));
  if (!runs.length) return;
  const {motion, of, name} = LOOPS[component], rest = `${name} − line`;
  const series = runs.map(run => onePath(run, data.runs.indexOf(run), run.history.step, rest, run.history[motion],
                                         run.departures[component].values));
  const lines = ofRuns(component, departure => lineWords(component, departure));
  addPaths(grid, `${name} over ${of}, without the elastic part`, {name: of, unit: motionUnit(component)},
           {name: rest, unit: forceUnit(component),
            least: Math.max(...runs.map(run => run.departures[component].least))}, series,
           {caption: `Subtracted: ${lines}, the elastic part by least squares.`});
}

function drawBodyLoops() {
  for (const component of Object.keys(LOOPS)) {
    if (largestOf(LOOPS[component].motion) === 0) continue;
    const grid = byId(FRETTING.includes(component) ? "fretting-loops" : "body-loops");
    addLoop(grid, component);
    addDeparture(grid, component);
  }
}

/** The largest friction force per unit normal force in each direction; nothing where it varies or is not known. */
function limitOutline() {
  if (data.limits)
    return data.limits.map((size, k) => [Math.cos(2 * Math.PI * k / data.limits.length) * size,
                                         Math.sin(2 * Math.PI * k / data.limits.length) * size]);
  return data.mu ? ellipsePoints(data.mu, data.angle) : null;
}

function ellipsePoints([a, b], degrees) {
  const c = Math.cos(degrees * Math.PI / 180), s = Math.sin(degrees * Math.PI / 180);
  return Array.from({length: 120}, (_, k) => {
    const x = a * Math.cos(k * Math.PI / 60), y = b * Math.sin(k * Math.PI / 60);
    return [c * x - s * y, s * x + c * y];
  });
}

/** Loops, paths and histories of a probe, of all runs that have it. */
function drawProbeLoops(name) {
  const of = run => run.probes.find(probe => probe.name === name);
  const tables = data.runs.map(run => (of(run) || {table: {step: []}}).table);
  if (!tables.some(table => table.step.length)) return;
  const {place} = data.runs.map(of).find(probe => probe);
  const slip = {unit: "mm", least: 1e-9 * largestOf("max_slip")};
  const force = {unit: "N", least: 1e-9 * largestOf("force_z")};
  htmlElement(byId("probe-loops"), "h3", {}, `Probe ${name}${place ? ` at (${place[0]}, ${place[1]}) mm` : ""}`);
  const grid = htmlElement(byId("probe-loops"), "div", {class: "grid"});
  const norm = (x, y) => x.map((value, i) => Math.hypot(value, y[i]));
  const over = (x, y) => x.map((value, i) => y[i] > 0 ? value / y[i] : null);
  const path = (title, x, y, xOf, yOf, more) => addPaths(grid, title, x, y, data.runs.flatMap((run, r) => {
    const t = tables[r];
    return t.step.length ? [onePath(run, r, t.step, y.name, xOf(t), yOf(t))] : [];
  }), more);
  path("Tangential force against slip", {name: "slip", ...slip}, {name: "tangential force", ...force},
       t => norm(t.slip_x, t.slip_y), t => norm(t.force_x, t.force_y));
  path("Path of slip", {name: "slip_x", ...slip}, {name: "slip_y", ...slip}, t => t.slip_x, t => t.slip_y, {equal: true});
  path("Path of the friction force", {name: "force_x", ...force}, {name: "force_y", ...force}, t => t.force_x, t => t.force_y,
       {equal: true});
  const outline = limitOutline();
  path(data.limits ? "Path in the limit of friction (dashed)" : outline ? "Path in the friction ellipse (dashed)" : "Path of force_t / force_n", {name: "force_x / force_n", unit: ""},
       {name: "force_y / force_n", unit: ""}, t => over(t.force_x, t.force_n), t => over(t.force_y, t.force_n),
       outline ? {equal: true, outline} : {equal: true});
  const table = run => tables[data.runs.indexOf(run)];
  overSteps(grid, "Slip over the steps", table, "mm", [["slip_x", "slip_x"], ["slip_y", "slip_y"],
                                                       ["accumulated_slip", "accumulated"]], {least: slip.least});
  overSteps(grid, "Forces over the steps", table, "N",
            [["force_n", "force_n"], ["force_x", "force_x"], ["force_y", "force_y"]], {least: force.least});
}
