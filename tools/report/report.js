// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
"use strict";
// Which charts the page has; light and dark.

/** Where the top turns or a moment holds it. A sum of forces leaves moments that are rounding. */
function drawRotations(grid, table) {
  const axes = ["x", "y", "z"], least = 1e-6 * largestOf("force_z");  // at a lever of 1 mm
  const turning = axes.filter(axis => largestOf(`r${axis}`) > 0);
  const carrying = axes.filter(axis => largestOf(`moment_${axis}`) > least);
  if (turning.length)
    overSteps(grid, "Rotation of the held face", table, "degrees", turning.map(axis => [`r${axis}`, `r_${axis}`]));
  if (carrying.length)
    overSteps(grid, "Moment of the counterface", table, "N mm", carrying.map(axis => [`moment_${axis}`, `M_${axis}`]));
}

function drawHistories() {
  const grid = byId("history-charts"), table = run => run.history;
  overSteps(grid, "Motion of the held face", table, "mm", axisColumns("u", "u"));
  overSteps(grid, "Force of the counterface", table, "N", axisColumns("force_", "F"));
  drawRotations(grid, table);
  overSteps(grid, "Largest slip", table, "mm", [["max_slip", "slip"], ["max_accumulated_slip", "accumulated slip"]]);
  overSteps(grid, "Pressure", table, "MPa", [["max_pressure", "largest"], ["min_pressure", "smallest"]]);
  const shares = ({history: h, area}) => {
    const of = column => (column || []).map(size => size === null ? null : 100 * size / area);
    return {step: h.step, touches: of(h.contact_area), sticks: of(h.stick_area)};
  };
  overSteps(grid, "Shares of the contact surface", shares, "%", [["touches", "contact area"], ["sticks", "stick area"]]);
  overSteps(grid, "Nodes by status", table, "", [["n_stick", "stick"], ["n_slip", "slip"], ["n_open", "open", "soft"]],
            {name: "nodes"});
  overSteps(grid, "Dissipation", table, "N mm",
            [["total_dissipation", "since the start"], ["dissipation", "in the step"]]);
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

function drawEnergy() {
  const grid = byId("energy-charts"), table = run => run.energy;
  overSteps(grid, "Energies since the start", table, "N mm",
            [["work", "work of all components"], ["elastic", "elastic energy"], ["dissipation", "dissipated by friction"]]);
  overSteps(grid, "Rest: work − elastic energy − dissipated", table, "N mm",
            [["balance", "since the start"], ["step_defect", "in the step"]]);
  overSteps(grid, "Rest of a step / largest energy", table, "", [["relative_defect", "rest"]], {log: true});
}

function drawSolver() {
  const grid = byId("solver-charts"), history = run => run.history, checks = run => run.checks;
  overSteps(grid, "Iterations", history, "", [["iterations", "iterations"]], {name: "iterations of the step"});
  overSteps(grid, "Residual", history, "", [["residual", "residual"]],
            {log: true, level: data.tolerance > 0 ? {value: data.tolerance, name: "tolerance"} : undefined});
  byId("no-checks").hidden = data.runs.some(checks);
  overSteps(grid, "Checks of equilibrium and contact", checks, "",
            [["equilibrium", "equilibrium"], ["penetration", "penetration"], ["complementarity", "complementarity"]],
            {log: true});
  overSteps(grid, "Checks of friction and energy", checks, "",
            [["friction_cone", "friction cone"], ["slip_rule", "slip rule"], ["energy_defect", "energy"]], {log: true});
}

function drawAll() {
  const h = data.runs[0].history, probes = [...new Set(data.runs.flatMap(run => run.probes.map(({name}) => name)))];
  if (!h.step.length) {
    for (const id of ["histories", "loops", "cycles", "energy", "solver"])
      htmlElement(byId(id), "p", {}, "No step was finished, so there is nothing to show.");
    for (const id of ["history-table", "no-checks", "no-cycles", "jumped-hint"]) byId(id).hidden = true;
    return;
  }
  drawHistories();
  fillHistoryTable(h);
  drawBodyLoops();
  probes.forEach(drawProbeLoops);
  if (!probes.length) htmlElement(byId("probe-loops"), "p", {class: "hint"}, "This run has no probes.");
  drawBodyLines();
  drawWear();
  drawCycles();
  drawEnergy();
  drawSolver();
  overSteps(byId("time-charts"), "Contact solution of a step", run => run.timing, "s", [["seconds", "seconds"]]);
}

/** One cycle of many: the whole run would be a block of ink. */
function listenToWindow() {
  const {blocks, history} = data.runs[0];
  byId("window-choice").hidden = blocks.length < 2 || !history.step.length;
  blocks.forEach(([name, first, last], k) => {
    htmlElement(byId("window"), "option", {value: k}, `${name} (steps ${first}–${last})`);
  });
  byId("window").addEventListener("change", event => {
    const [, first, last] = blocks[event.target.value] || ["all", 1, Infinity];
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
  addEventListener("beforeprint", () => { apply("light"); fitAll(BOX.width); });
  addEventListener("afterprint", () => { apply(current()); fitAll(); });
  byId("theme").addEventListener("click", () => {
    chosen = current() === "dark" ? "light" : "dark";
    apply(chosen);
  });
  apply(current());
}

/** A menu for saving closes when something else is chosen. */
function listenToMenus() {
  addEventListener("pointerdown", ({target}) => {
    for (const menu of document.querySelectorAll(".save[open]")) if (!menu.contains(target)) menu.open = false;
  });
}

listenToTheme();
listenToMenus();
drawAll();
listenToWindow();
if (data.maps) player = new Player(data);
LeftOut.say();
byId("map-panel").hidden = byId("mark-hint").hidden = !player;
byId("no-maps").hidden = Boolean(player);
byId("line-panel").hidden = !player;
if (data.plane) {  // nothing changes along y: profiles over x say it all
  byId("maps").classList.add("plane");
  byId("maps-title").textContent = "Profiles over x";
}
byId("separator-hint").hidden = several || data.runs[0].blocks.length < 2;  // their cycles may differ
byId("gap-hint").hidden = data.runs.every(run => !run.jumps.length);
fitAll();
addEventListener("resize", () => fitAll());
