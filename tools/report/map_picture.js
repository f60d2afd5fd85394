// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
"use strict";
// The map that is on show, as a file.

function addMapSaving(player) {
  const title = () => `map ${player.field} step ${player.frame.step}`;
  addSaving(byId("map-save"), () => mapPicture(player), () => mapRows(player), title);
}

/** As it is on show: open nodes have no value of the contact, if they are hidden. */
function mapRows({mesh, frame, field, showsOpen}) {
  const {unit} = FIELDS[field], bare = field === "status" || showsOpen ? [] : frame.bare(field);
  const rounded = value => Number(value.toPrecision(6));
  return [[...mesh.axes.map(axis => `${axis} (mm)`), withUnit(field, unit)],
          ...Array.from(mesh.x, (x, node) => [rounded(x), rounded(mesh.y[node]),
                                              bare[node] ? null : rounded(frame.value(field, node))])];
}

function mapPicture(player) {
  const {field, frame} = player, {name, unit} = FIELDS[field];
  const spec = {title: withUnit(name, unit), caption: byId("step-text").textContent.replaceAll("\n", "; ")};
  const states = STATES.map(one => ({label: one.name, colour: `rgb(${one.colour.join(", ")})`, dash: "none"}));
  return pictureOf(spec, field === "status" ? states : [], (draft, top) => {
    if (field !== "status") top += drawMapBar(draft, top, player.range(player.index), unit);
    const size = BOX.width;
    const place = {y: top, width: size, height: size};
    svgElement(draft, "image", {...place, href: byId("map").toDataURL()});
    const overlay = svgElement(draft, "svg", {...place, viewBox: `0 0 ${MAP_SIZE} ${MAP_SIZE}`, class: "map-overlay"});
    for (const child of byId("map-overlay").children) overlay.append(child.cloneNode(true));
    return size + (field === "status" ? 0 : BAR_HEIGHT);
  });
}

const BAR_HEIGHT = 34, BAR_STEPS = 64;

function drawMapBar(draft, top, range, unit) {
  const left = 8, width = BOX.width - 16;
  for (let k = 0; k < BAR_STEPS; ++k)
    svgElement(draft, "rect", {x: left + k * width / BAR_STEPS, y: top, width: width / BAR_STEPS + 0.3, height: 12,
                               style: `fill: rgb(${viridis((k + 0.5) / BAR_STEPS).join(", ")})`});
  range.forEach((value, end) => {
    const place = {x: end ? left + width : left, y: top + 26, "text-anchor": end ? "end" : "start"};
    svgElement(draft, "text", place, `${numberText(value, 4)} ${unit}`.trim());
  });
  return BAR_HEIGHT;
}
