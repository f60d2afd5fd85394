// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
"use strict";
// What is worn: profiles, and worn volume and depth over the cycles.

/** Profiles of one run in the colours of its time, or the last profiles of several in the colours of the runs. */
function profileSeries(along) {
  const lineOf = run => run.wear && run.wear.lines.find(line => line.along === along);
  if (several) {
    return data.runs.flatMap((run, r) => {
      const line = lineOf(run), last = line && line.depths.length - 1;
      return line ? [{name: "worn depth", run: run.name, colour: `var(--r${r + 1})`, dash: "none", x: line.place,
                      y: line.depths[last], state: run.wear.names[last]}] : [];
    });
  }
  const [{wear: {names}}] = data.runs, {place, depths} = lineOf(data.runs[0]);
  const colour = k => cycleColour(names.length > 1 ? k / (names.length - 1) : 0);
  return depths.map((depth, k) => ({name: names[k], run: "", colour: colour(k), dash: "none", x: place, y: depth}));
}

function drawProfile(along, across) {
  const other = along === "x" ? "y" : "x", series = profileSeries(along);
  const states = series.map(({run, state}) => `${run}: ${state}`).join("; ");
  // Not among `charts`: a click on a place is no choice of a step.
  new Chart(byId("wear-profiles"), {
    title: `Worn depth along ${along} (${other} = ${numberText(across, 4)} mm)`, caption: several ? states : "",
    shared: true, fixed: true, series, x: {name: along, unit: "mm"}, y: {unit: "mm", name: "worn depth"},
    head: (one, i) => `${along} = ${numberText(one.x[i], 4)} mm`,
  }, () => {});
}

function drawWear() {
  const worn = data.runs.filter(run => run.wear);
  if (!worn.length) return;
  const lines = new Map(worn.flatMap(run => run.wear.lines.map(({along, across}) => [along, across])).reverse());
  for (const along of "xy") if (lines.has(along)) drawProfile(along, lines.get(along));
  byId("no-profiles").hidden = lines.size > 0;
  byId("profiles-hint").hidden = several;
  const place = {parent: byId("wear-charts")};
  if (!data.runs.some(({cycles}) => cycles.worn_volume)) {
    overSteps(place.parent, "Worn volume over the steps", run => run.history, "mm³", [["worn_volume", "worn volume"]]);
    return;
  }
  overCycles("Worn volume", "mm³", [["worn_volume", "worn volume"]], place);
  overCycles("Largest worn depth", "mm", [["max_wear_depth", "largest depth"]], place);
  overCycles("Error of the worn volume by jumps, estimated", "mm³", [["wear_error", "error"]], place);
}
