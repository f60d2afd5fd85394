// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
"use strict";
// What is worn: profiles, and worn volume and depth over the cycles.

function drawProfile({along, across, place, depths}, names) {
  const other = along === "x" ? "y" : "x";
  const colour = k => cycleColour(names.length > 1 ? k / (names.length - 1) : 0);
  const series = depths.map((depth, k) => ({name: names[k], run: "", colour: colour(k), dash: "none", x: place,
                                            y: depth}));
  // Not among `charts`: a click on a place is no choice of a step.
  new Chart(byId("wear-profiles"), {
    title: `Worn depth along ${along} (${other} = ${numberText(across, 4)} mm)`, shared: true, fixed: true, series,
    x: {name: along, unit: "mm"}, y: {unit: "mm", name: "worn depth"},
    head: (one, i) => `${along} = ${numberText(one.x[i], 4)} mm`,
  }, () => {});
}

function drawWear() {
  if (!data.wear) return;
  for (const line of data.wear.lines) drawProfile(line, data.wear.names);
  byId("no-profiles").hidden = data.wear.lines.length > 0;
  const place = {parent: byId("wear-charts")};
  if (!data.runs.some(({cycles}) => cycles.worn_volume)) {
    overSteps(place.parent, "Worn volume over the steps", run => run.history, "mm³", [["worn_volume", "worn volume"]]);
    return;
  }
  overCycles("Worn volume", "mm³", [["worn_volume", "worn volume"]], place);
  overCycles("Largest worn depth", "mm", [["max_wear_depth", "largest depth"]], place);
  if (data.runs.some(({cycles}) => (cycles.wear_error || []).some(Boolean)))
    overCycles("Error of the worn volume by jumps, estimated", "mm³", [["wear_error", "error"]], place);
}
