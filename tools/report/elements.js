// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
"use strict";
// Elements of the page, colours of the cycles, and the box that shows values.

const SVG = "http://www.w3.org/2000/svg";
const byId = id => document.getElementById(id);

function svgElement(parent, name, attributes, text) {
  const element = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  if (text !== undefined) element.textContent = text;
  parent.append(element);
  return element;
}

function htmlElement(parent, name, attributes = {}, text = "") {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.textContent = text;
  parent.append(element);
  return element;
}

function shortened(words, most) {
  return words.length > most ? `${words.slice(0, most - 1)}…` : words;
}

/** What is under the pointer or chosen by arrow keys, in words. */
const readout = {
  show(text, x, y) {
    const box = byId("readout");
    box.textContent = text;
    box.hidden = false;
    box.style.left = `${Math.max(4, Math.min(x + 14, innerWidth - box.offsetWidth - 8))}px`;
    box.style.top = `${y + 18 + box.offsetHeight > innerHeight ? y - box.offsetHeight - 12 : y + 14}px`;
  },
  hide() { byId("readout").hidden = true; },
};

/** From the first cycle (0) to the last (1). */
function cycleColour(share) {
  const [from, to, part] = share < 0.5 ? ["first", "middle", 2 * share] : ["middle", "last", 2 * share - 1];
  return `color-mix(in srgb, var(--cycle-${to}) ${(100 * part).toFixed(1)}%, var(--cycle-${from}))`;
}

/** A function of the number of a cycle; 0 is the preload. */
function cycleColours(blocks) {
  const cycles = blocks.map(block => block[3]).filter(cycle => cycle > 0);
  // By rank: after a jump the number of a cycle says little about how many loops there are to distinguish.
  const shares = new Map(cycles.map((cycle, rank) => [cycle, rank / Math.max(1, cycles.length - 1)]));
  return cycle => cycle ? cycleColour(shares.get(cycle)) : "var(--soft)";
}

/** Parts of a path, a cycle each: the first and the last point, and the colour. A part begins where the one before
 *  ends. */
function cyclePieces(steps, blocks) {
  const colourOf = cycleColours(blocks), pieces = [];
  let block = 0;
  steps.forEach((step, i) => {
    const before = block;
    while (block < blocks.length - 1 && step > blocks[block][2]) ++block;
    if (!pieces.length || block !== before)
      pieces.push({first: Math.max(0, i - 1), last: i, colour: colourOf(blocks[block][3]), name: blocks[block][0]});
    pieces[pieces.length - 1].last = i;
  });
  return pieces;
}
