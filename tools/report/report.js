// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
"use strict";
// Which charts the page has; light and dark.

const data = JSON.parse(document.getElementById("data").textContent);
const byId = id => document.getElementById(id);
const charts = [];
let player = null;  // of the maps, if there are maps

function addChart(parent, spec) {
  charts.push(new Chart(parent, spec, step => player && player.toNearest(step)));
}

function overSteps(parent, title, table, unit, series, more = {}) {
  const known = series.filter(([column]) => table[column])
    .map(([column, name, colour]) => ({name, colour, values: table[column]}));
  if (!known.length) return;
  const {log = false, name = "", least = 0, ...rest} = more;
  const y = {unit, log, name, least};
  addChart(parent, {title, steps: table.step, y, series: known, blocks: data.blocks, ...rest});
}

function largest(values) {
  return Math.max(...rangeOf(values).map(Math.abs));
}

/** Rounding leaves forces of 1e-9 N where there are none; such curves would only hide the scale of the others. */
function matters(table, column, against) {
  return largest(table[column]) > 1e-6 * largest(table[against]);
}

function axisSeries(table, stem, names) {
  return names.filter(axis => axis === "z" || matters(table, stem + axis, stem + "z"))
    .map(axis => [stem + axis, `${stem === "u" ? "u" : "F"}_${axis}`]);
}

function drawHistories(h) {
  const grid = byId("history-charts");
  overSteps(grid, "Motion of the top", h, "mm", axisSeries(h, "u", ["x", "y", "z"]));
  overSteps(grid, "Force of the plane", h, "N", axisSeries(h, "force_", ["x", "y", "z"]));
  overSteps(grid, "Largest slip", h, "mm", [["max_slip", "slip"], ["max_accumulated_slip", "accumulated slip"]]);
  overSteps(grid, "Pressure", h, "MPa", [["max_pressure", "largest"], ["min_pressure", "smallest"]]);
  const share = {...h, share: h.stick_area.map(area => area === null ? null : 100 * area / data.area)};
  overSteps(grid, "Share of the contact surface that sticks", share, "%", [["share", "stick area"]]);
  overSteps(grid, "Nodes by status", h, "", [["n_stick", "stick"], ["n_slip", "slip"], ["n_open", "open", "soft"]],
            {name: "nodes"});
  overSteps(grid, "Dissipation", h, "N mm", [["total_dissipation", "since the start"], ["dissipation", "in the step"]]);
}

function fillHistoryTable(h) {
  byId("history-table").addEventListener("toggle", event => {
    const place = event.target.querySelector(".scroll");
    if (place.firstChild) return;
    const table = htmlElement(place, "table"), names = Object.keys(h);
    const head = htmlElement(htmlElement(table, "thead"), "tr"), body = htmlElement(table, "tbody");
    for (const name of names) htmlElement(head, "th", {scope: "col"}, name);
    h.step.forEach((_, row) => {
      const line = htmlElement(body, "tr");
      for (const name of names) htmlElement(line, "td", {}, numberText(h[name][row]));
    });
  });
}

function addPath(parent, title, steps, x, y, more = {}) {
  addChart(parent, {title, steps, x, y, series: [{name: y.name, values: y.values}], ...more});
}

/** The loop under a normal load is so thin that it only shows once the straight line is taken away. */
function addDeparture({step, uz, force_z}) {
  const square = uz.reduce((sum, u) => sum + u * u, 0);
  const [low, high] = rangeOf(uz);
  if (step.length < 3 || high - low < 0.5 * largest(uz)) return;
  const stiffness = uz.reduce((sum, u, i) => sum + u * force_z[i], 0) / square;
  addPath(byId("body-loops"), `F_z − k u_z, k = ${numberText(stiffness / 1000, 5)} kN/mm`, step,
          {name: "u_z", unit: "mm", values: uz},
          {name: "F_z − k u_z", unit: "N", values: force_z.map((force, i) => force - stiffness * uz[i])});
}

function drawBodyLoops(h) {
  for (const axis of ["x", "y", "z"]) {
    if (largest(h["u" + axis]) === 0) continue;
    addPath(byId("body-loops"), `Force against motion of the top, along ${axis}`, h.step,
            {name: `u_${axis}`, unit: "mm", values: h["u" + axis]},
            {name: `F_${axis}`, unit: "N", values: h["force_" + axis]});
  }
  addDeparture(h);
}

function ellipsePoints([a, b], degrees) {
  const c = Math.cos(degrees * Math.PI / 180), s = Math.sin(degrees * Math.PI / 180);
  return Array.from({length: 97}, (_, k) => {
    const x = a * Math.cos(k * Math.PI / 48), y = b * Math.sin(k * Math.PI / 48);
    return [c * x - s * y, s * x + c * y];
  });
}

function drawProbeLoops({name, place, table: t}) {
  if (!t.step.length) return;
  const slip = {unit: "mm", least: 1e-6 * largest(data.history.max_slip)};
  const force = {unit: "N", least: 1e-9 * largest(data.history.force_z)};
  htmlElement(byId("probe-loops"), "h3", {}, `Probe ${name}${place ? ` at (${place[0]}, ${place[1]}) mm` : ""}`);
  const grid = htmlElement(byId("probe-loops"), "div", {class: "grid"});
  const norm = (x, y) => x.map((value, i) => Math.hypot(value, y[i]));
  const over = (x, y) => x.map((value, i) => y[i] > 0 ? value / y[i] : null);
  addPath(grid, "Tangential force against slip", t.step, {name: "slip", ...slip, values: norm(t.slip_x, t.slip_y)},
          {name: "tangential force", ...force, values: norm(t.force_x, t.force_y)});
  addPath(grid, "Path of slip", t.step, {name: "slip_x", ...slip, values: t.slip_x},
          {name: "slip_y", ...slip, values: t.slip_y}, {equal: true});
  addPath(grid, "Path of the friction force", t.step, {name: "force_x", ...force, values: t.force_x},
          {name: "force_y", ...force, values: t.force_y}, {equal: true});
  addPath(grid, "Path in the friction ellipse (dashed)", t.step,
          {name: "force_x / force_n", unit: "", values: over(t.force_x, t.force_n)},
          {name: "force_y / force_n", unit: "", values: over(t.force_y, t.force_n)},
          {equal: true, outline: ellipsePoints(data.mu, data.angle)});
  overSteps(grid, "Slip over the steps", t, "mm",
            [["slip_x", "slip_x"], ["slip_y", "slip_y"], ["accumulated_slip", "accumulated"]], {least: slip.least});
  overSteps(grid, "Forces over the steps", t, "N",
            [["force_n", "force_n"], ["force_x", "force_x"], ["force_y", "force_y"]], {least: force.least});
}

function drawEnergy(e) {
  const grid = byId("energy-charts");
  overSteps(grid, "Energies since the start", e, "N mm", [["work", "work of the top"], ["elastic", "elastic energy"],
                                                          ["dissipation", "dissipation"]]);
  overSteps(grid, "Balance: work − elastic energy − dissipation", e, "N mm", [["balance", "since the start"],
                                                                              ["step_defect", "in the step"]]);
  overSteps(grid, "Defect of a step / largest energy", e, "", [["relative_defect", "defect"]], {log: true});
}

function drawSolver(h) {
  const grid = byId("solver-charts");
  overSteps(grid, "Iterations", h, "", [["iterations", "iterations"]], {name: "iterations of the step"});
  overSteps(grid, "Residual", h, "", [["residual", "residual"]],
            {log: true, level: data.tolerance > 0 ? {value: data.tolerance, name: "tolerance"} : undefined});
  byId("no-checks").hidden = data.checks !== null;
  if (!data.checks) return;
  overSteps(grid, "Checks of equilibrium and contact", data.checks, "",
            [["equilibrium", "equilibrium"], ["penetration", "penetration"], ["complementarity", "complementarity"]],
            {log: true});
  overSteps(grid, "Checks of friction and energy", data.checks, "",
            [["friction_cone", "friction cone"], ["slip_rule", "slip rule"], ["energy_defect", "energy"]], {log: true});
}

function drawAll() {
  const h = data.history;
  if (!h.step.length) {
    for (const id of ["histories", "loops", "energy", "solver"])
      htmlElement(byId(id), "p", {}, "No step was finished, so there is nothing to show.");
    byId("history-table").hidden = byId("no-checks").hidden = true;
    return;
  }
  drawHistories(h);
  fillHistoryTable(h);
  drawBodyLoops(h);
  data.probes.forEach(drawProbeLoops);
  if (!data.probes.length) htmlElement(byId("probe-loops"), "p", {class: "hint"}, "This run has no probes.");
  drawEnergy(data.energy);
  drawSolver(h);
  overSteps(byId("time-charts"), "Contact solution of a step", data.timing, "s", [["seconds", "seconds"]]);
}

/** One cycle of many: the whole run would be a block of ink. */
function listenToWindow() {
  byId("window-choice").hidden = data.blocks.length < 2 || !data.history.step.length;
  data.blocks.forEach(([name, first, last], k) => {
    htmlElement(byId("window"), "option", {value: k}, `${name} (steps ${first}–${last})`);
  });
  byId("window").addEventListener("change", event => {
    const [, first, last] = data.blocks[event.target.value] || ["all", 1, Infinity];
    for (const chart of charts) chart.restrict(first, last);
    if (player) player.show(player.index);
  });
}

/** The system's choice, until the button is used; paper is white. */
function listenToTheme() {
  const dark = matchMedia("(prefers-color-scheme: dark)");
  let chosen = null;
  const apply = theme => {
    document.documentElement.dataset.theme = theme;
    byId("theme").textContent = theme === "dark" ? "Light" : "Dark";
    byId("theme").setAttribute("aria-pressed", String(theme === "dark"));
  };
  const current = () => chosen || (dark.matches ? "dark" : "light");
  dark.addEventListener("change", () => apply(current()));
  addEventListener("beforeprint", () => apply("light"));
  addEventListener("afterprint", () => apply(current()));
  byId("theme").addEventListener("click", () => {
    chosen = current() === "dark" ? "light" : "dark";
    apply(chosen);
  });
  apply(current());
}

listenToTheme();
drawAll();
listenToWindow();
if (data.maps) player = new Player(data);
byId("map-panel").hidden = byId("mark-hint").hidden = !player;
byId("no-maps").hidden = Boolean(player);
