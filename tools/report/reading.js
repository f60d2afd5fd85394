// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
"use strict";
// Keys of a chart, and its values for pointer and arrow keys.

/** What distinguishes the curves: [{label, colour, dash}], or {bar, from, to} for the colours of the cycles. */
function keysOf(spec) {
  if (spec.cycles) return cycleKeys(spec.cycles);
  const distinct = (list, what) => [...new Map(list.map(one => [one[what], one])).values()];
  if (!spec.series.some(series => series.run)) {
    return spec.series.length < 2 ? []
      : spec.series.map(({name, colour, dash}) => ({label: name, colour, dash}));
  }
  const names = distinct(spec.series, "name"), runs = distinct(spec.series, "run");
  return [...runs.map(({run, colour}) => ({label: run, colour, dash: "none"})),
          ...(names.length > 1 ? names.map(({name, dash}) => ({label: name, colour: "var(--ink)", dash})) : [])];
}

function cycleKeys(blocks) {
  const cycles = blocks.map(block => block[3]).filter(cycle => cycle > 0);
  const n = Math.min(MOST_BARS, cycles.length);
  const bar = Array.from({length: n}, (_, k) => cycleColour(n > 1 ? k / (n - 1) : 0));
  const keys = n ? [{bar, from: `cycle ${cycles[0]}`, to: n > 1 ? String(cycles[cycles.length - 1]) : ""}] : [];
  return blocks[0][3] ? keys : [{label: "preload", colour: "var(--soft)", dash: "none"}, ...keys];
}

/** The sample of a key as SVG, `width` wide and 10 high. */
function drawSample(parent, key, x, y, width) {
  if (!key.bar) {
    svgElement(parent, "line", {x1: x, x2: x + width, y1: y + 5, y2: y + 5, style: `stroke: ${key.colour}`,
                                "stroke-dasharray": key.dash, "stroke-width": 2.4});
    return;
  }
  const size = width / key.bar.length;
  key.bar.forEach((colour, k) => svgElement(parent, "rect", {x: x + k * size, y, width: size + 0.2, height: 10,
                                                             style: `fill: ${colour}`}));
}

function drawKeys(parent, spec) {
  for (const key of keysOf(spec)) {
    const span = htmlElement(parent, "span", {class: key.bar ? "key bar-key" : "key"}), width = key.bar ? 72 : 26;
    if (key.bar) span.append(key.from);
    const box = {viewBox: `0 0 ${width} 10`, style: `width: ${width}px`, "aria-hidden": "true"};
    const sample = svgElement(span, "svg", box);
    drawSample(sample, key, 0, 0, width);
    span.append(key.bar ? ` ${key.to}` : key.label);
  }
}

/** The point under the pointer, or the one that arrow keys have come to. */
class ChartReader {
  constructor(chart, onStep) {
    this.chart = chart;
    this.index = -1;
    const svg = chart.svg, step = ([k, i]) => (chart.spec.series[k].steps || [])[i];
    svg.addEventListener("pointermove", event => this.showAt(this.nearest(event), event.clientX, event.clientY));
    svg.addEventListener("pointerleave", () => this.unshow());
    svg.addEventListener("blur", () => this.unshow());
    svg.addEventListener("click", event => onStep(step(this.nearest(event))));
    svg.addEventListener("keydown", event => {
      const jump = {ArrowRight: 1, ArrowLeft: -1, PageDown: 10, PageUp: -10, Home: -Infinity, End: Infinity}[event.key];
      if (event.key === "Enter" && this.index >= 0) onStep(step([0, this.index]));
      if (jump === undefined) return;
      event.preventDefault();
      this.walk(jump);
    });
  }

  walk(jump) {
    const {svg, spec, scales, box: room} = this.chart, [series] = spec.series;
    const index = Math.max(0, Math.min(series.x.length - 1, this.index + jump));
    const box = svg.getBoundingClientRect();
    this.showAt([0, index], box.left + scales.px(series.x[index]) * box.width / room.width, box.top + box.height / 3);
    this.index = index;
  }

  /** Number of the series and of its point; over a shared x the height of the pointer does not matter. */
  nearest(event) {
    const {svg, spec, scales} = this.chart, box = svg.getBoundingClientRect();
    const scale = this.chart.box.width / box.width;
    const x = (event.clientX - box.left) * scale, y = (event.clientY - box.top) * scale;
    let best = [0, 0], least = Infinity;
    spec.series.forEach((series, k) => series.x.forEach((value, i) => {
      const place = scales.place(series, i);
      if (!place) return;
      const distance = (place[0] - x) ** 2 + (spec.shared ? 0 : (place[1] - y) ** 2);
      if (distance < least) [best, least] = [[k, i], distance];
    }));
    return best;
  }

  showAt([k, i], clientX, clientY) {
    const {spec, scales, hover, box} = this.chart, chosen = spec.series[k];
    if (!chosen || !chosen.x.length) return;
    this.unshow();
    const x = scales.px(chosen.x[i]);
    if (spec.shared) svgElement(hover, "line", {class: "hover", x1: x, x2: x, y1: box.top, y2: box.bottom});
    const lines = [spec.head ? spec.head(chosen, i) : this.head(chosen, i)];
    if (!spec.shared) lines.push(this.line(spec.x.name, chosen.x[i], spec.x.unit));
    for (const series of spec.shared ? spec.series : [chosen]) {
      const at = series === chosen ? i : series.x.indexOf(chosen.x[i]);
      if (at < 0) continue;
      lines.push(this.line(series.run && spec.shared ? `${series.run}, ${series.name}` : series.name, series.y[at],
                           spec.y.unit));
      const place = scales.place(series, at), style = `fill: ${series.colour}`;
      if (place) svgElement(hover, "circle", {cx: place[0], cy: place[1], r: 4, style});
    }
    readout.show(lines.join("\n"), clientX, clientY);
  }

  head(series, i) {
    const step = series.steps[i];
    const block = (this.chart.spec.cycles || []).find(([, first, last]) => first <= step && step <= last);
    const run = series.run && !this.chart.spec.shared ? `${series.run}, ` : "";
    return `${run}step ${step}${block ? `, ${block[0]}` : ""}`;
  }

  line(name, value, unit) {
    return `${name}: ${numberText(value)} ${unit}`.trim();
  }

  unshow() {
    this.index = -1;
    this.chart.hover.replaceChildren();
    readout.hide();
  }
}
