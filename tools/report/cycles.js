// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
"use strict";
// Charts over the cycles: how a response settles. Cycles that were jumped are shaded, and their points are rings.

const CYCLE_AXIS = {name: "cycle", unit: "", whole: true};

/** Over one decade a linear axis shows the values, over many only a logarithmic one does. */
function spansDecades(columns) {
  const values = data.runs.flatMap(({cycles}) => columns.flatMap(column => cycles[column] || []));
  const [low, high] = rangeOf(values.filter(value => value > 0));
  return values.length > 0 && low > 0 && high > 50 * low;
}

/** Of the first run, and only if it is alone: shades of several would cover each other. */
function jumpedBands() {
  const {cycles} = data.runs[0];
  if (several || !cycles.cycle) return [];
  return cycles.cycle.flatMap((cycle, row) => cycles.jumped[row]
    ? [[cycle - cycles.n_cycles[row] + 0.5, cycle + 0.5]] : []);
}

/** Of a single cycle there are no curves: its figures are rows of a table, with a column for each run. */
function figuresOfCycle(title, unit, columns) {
  const [table] = byId("only-cycle").children, place = table.tBodies[0] || htmlElement(table, "tbody");
  byId("only-cycle").hidden = false;
  if (several && !table.tHead) {
    const head = htmlElement(htmlElement(table, "thead"), "tr");
    for (const name of ["", ...data.runs.map(run => run.name)]) htmlElement(head, "th", {scope: "col"}, name);
  }
  for (const [column, name] of columns) {
    const values = data.runs.map(({cycles}) => (cycles[column] || [null])[0]);
    if (values.every(value => value === null)) continue;
    const row = htmlElement(place, "tr"), {factor, name: used} = unitOf(values, unit);
    htmlElement(row, "th", {scope: "row"}, inSentence(title) === inSentence(name) ? title : `${title}: ${name}`);
    for (const value of values)
      htmlElement(row, "td", {}, value === null ? "–" : `${numberText(value * factor, 5)} ${used}`.trim());
  }
}

function overCycles(title, unit, columns, {parent = byId("cycle-charts"), ...more} = {}) {
  if (data.runs.every(({cycles}) => (cycles.cycle || []).length < 2)) {
    figuresOfCycle(title, unit, columns);
    return;
  }
  const series = curves(data.runs, run => run.cycles, columns, {column: "cycle", steps: "last_step"});
  const jumpedOf = new Map(data.runs.map(({cycles}) => [cycles.cycle, cycles]));
  for (const one of series) one.hollow = jumpedOf.get(one.x).jumped;
  const head = (one, i) => {
    const {jumped, n_cycles} = jumpedOf.get(one.x), first = one.x[i] - n_cycles[i] + 1;
    if (!jumped[i]) return `cycle ${one.x[i]}`;
    return n_cycles[i] > 1 ? `cycles ${first}–${one.x[i]}, jumped` : `cycle ${first}, jumped`;
  };
  const zeros = more.log && series.some(one => one.y.includes(0));
  addCurves(parent, title, series, CYCLE_AXIS, unit,
            {fixed: true, covers: true, head, bands: jumpedBands(),
             caption: zeros ? "A zero is drawn at the lower end." : "", ...more});
}

/** The threshold below which cycles count as periodic, if the run has one. */
function periodicLevel() {
  const value = Math.max(data.periodic.stop, data.periodic.jump);
  const name = data.periodic.stop >= data.periodic.jump ? "Stop when periodic" : "Jump when periodic";
  return value > 0 ? {value, name} : undefined;
}

function drawCycles() {
  const any = data.runs.some(({cycles}) => cycles.cycle);
  byId("no-cycles").hidden = any;
  byId("jumped-hint").hidden = !data.runs.some(({cycles}) => (cycles.jumped || []).some(Boolean));
  if (!any) return;
  overCycles("Change of the state in a cycle", "", [["change", "change"]], {log: true, level: periodicLevel()});
  overCycles("Energy of a cycle", "N mm", [["dissipation", "dissipated by friction"], ["work", "work of all components"]],
             {log: spansDecades(["dissipation", "work"])});
  overCycles("Slip since the start", "mm", [["max_slip", "largest slip"],
                                            ["max_accumulated_slip", "largest accumulated slip"]], {fit: true});
  overCycles("Slip accumulated in a cycle", "mm", [["accumulated_slip", "accumulated slip"]],
             {log: spansDecades(["accumulated_slip"])});
  overCycles("Dissipation since the start", "N mm", [["total_dissipation", "dissipation"]], {fit: true});
  overCycles("Normal force of a cycle", "N", [["peak_force_z", "largest"], ["force_z", "at the end"]],
             {fit: true});
  drawLoopFigures();
}

/** What fretting tests read off loops; runs without tangential motion have none. */
function drawLoopFigures() {
  if (!data.runs.some(({cycles}) => (cycles.energy_ratio || []).some(value => value !== null))) return;
  overCycles("Slip ratio and energy ratio of the loop", "", [["slip_ratio", "slip ratio \u03b4\u2080/\u03b4*"],
                                                            ["energy_ratio", "energy ratio E_d/(4 Q* \u03b4*)"]]);
  overCycles("Coefficient of friction of the loop", "", [["friction_largest", "largest force"],
                                                        ["friction_energy", "energy"],
                                                        ["friction_geometric", "middle of the stroke"]]);
  overCycles("Tangential stiffness of the loop", "N/mm", [["loop_stiffness", "behind reversals"]], {fit: true});
  drawDamping();
  overCycles("Largest energy per area of a cycle", "N/mm", [["worst_energy", "at the worst node"]]);
}

/** The cycles of a run that have a loop, by their amplitudes \u03b4* (half of the stroke, mm). */
function loopsByAmplitude({cycles}) {
  const rows = (cycles.stroke || []).flatMap((stroke, row) => stroke > 0 && !cycles.jumped[row]
    ? [{amplitude: stroke / 2, energy: cycles.dissipation[row], secant: 2 * cycles.tangential_force[row] / stroke,
        slope: cycles.loop_stiffness[row], cycle: cycles.cycle[row]}] : []);
  return rows.sort((a, b) => a.amplitude - b.amplitude);
}

/** Damping curves: energy and stiffness of loops over their amplitude, of a run whose cycles grow, or of runs that differ in
 *  amplitude, whose last cycles make one curve. */
function drawDamping() {
  const least = 1.02;  // amplitudes that differ by less are the same
  const grows = loops => loops.length > 2 && loops[loops.length - 1].amplitude > least * loops[0].amplitude;
  const own = data.runs.map(loopsByAmplitude);
  const lasts = own.flatMap(loops => loops.length ? [loops.reduce((a, b) => a.cycle > b.cycle ? a : b)] : [])
    .sort((a, b) => a.amplitude - b.amplitude);
  const curvesOf = own.some(grows) ? own.map((loops, r) => ({loops, r, run: several ? data.runs[r].name : ""})).filter(({loops}) => grows(loops))
    : grows(lasts) ? [{loops: lasts, r: 0, run: ""}] : [];
  if (!curvesOf.length) return;
  const draw = (title, unit, columns, more) => addCurves(byId("cycle-charts"), title, curvesOf.flatMap(({loops, r, run}) =>
    columns.map(([column, name], k) => ({name, run, colour: `var(--${run ? `r${r + 1}` : `c${k + 1}`})`, dash: DASHES[k],
      x: loops.map(loop => loop.amplitude), y: loops.map(loop => loop[column])}))),
    {name: "amplitude \u03b4*", unit: "mm"}, unit,
    {fixed: true, head: (one, i) => `\u03b4* = ${numberText(one.x[i], 4)} mm`, ...more});
  const energies = curvesOf.flatMap(({loops}) => loops.map(loop => loop.energy)).filter(energy => energy > 0);
  draw("Damping: energy of a cycle over its amplitude", "N mm", [["energy", "dissipated by friction"]],
       {log: energies.length > 0 && Math.max(...energies) > 50 * Math.min(...energies)});
  draw("Tangential stiffness over the amplitude", "N/mm", [["secant", "secant Q*/\u03b4*"], ["slope", "behind reversals"]],
       {fit: true});
}
