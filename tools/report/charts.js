// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
"use strict";
// Charts as SVG: curves over the steps, and paths of one quantity over another.

const SVG = "http://www.w3.org/2000/svg";
const BOX = {left: 62, right: 392, top: 10, bottom: 192, width: 400, height: 232};
const DASHES = ["none", "7 3", "2 3", "9 3 2 3"];
const MOST_DOTS = 64;

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

/** What is under the pointer or chosen by arrow keys, in words. */
const readout = {
  show(text, x, y) {
    const box = document.getElementById("readout");
    box.textContent = text;
    box.hidden = false;
    box.style.left = `${Math.max(4, Math.min(x + 14, innerWidth - box.offsetWidth - 8))}px`;
    box.style.top = `${y + 18 + box.offsetHeight > innerHeight ? y - box.offsetHeight - 12 : y + 14}px`;
  },
  hide() { document.getElementById("readout").hidden = true; },
};

/**
 * spec: title; steps (one a point); x {name, unit, values, least} (the steps if missing); y {name, unit, log, least};
 * series [{name, values, colour}]; optional: blocks (cycles, marked by lines), level {value, name},
 * outline [[x, y]...], equal (same scale in x and y). What is smaller than `least` is rounding.
 */
class Chart {
  constructor(parent, spec, onStep) {
    this.whole = this.spec = spec;
    this.overSteps = !spec.x;
    this.index = -1;
    const figure = htmlElement(parent, "figure");
    htmlElement(figure, "figcaption", {}, spec.title);
    this.drawKeys(figure);
    const viewBox = `0 0 ${BOX.width} ${BOX.height}`;
    this.svg = svgElement(figure, "svg", {class: "chart", viewBox, role: "img", tabindex: 0});
    this.draw();
    this.listen(onStep);
  }

  /** Only the steps first..last from now on. */
  restrict(first, last) {
    const keep = this.whole.steps.map(step => first <= step && step <= last);
    const part = values => values.filter((_, i) => keep[i]);
    const {x, steps, series} = this.whole;
    this.spec = {...this.whole, steps: part(steps), x: x && {...x, values: part(x.values)},
                 series: series.map(one => ({...one, values: part(one.values)}))};
    this.draw();
  }

  draw() {
    this.svg.replaceChildren();
    this.x = this.spec.x || {name: "step", unit: "", values: this.spec.steps};
    this.findScales();
    this.svg.setAttribute("aria-label", this.description());
    this.drawFrame();
    this.markGroup = svgElement(this.svg, "g", {"pointer-events": "none"});
    this.drawCurves();
    this.hover = svgElement(this.svg, "g", {"pointer-events": "none"});
  }

  description() {
    const parts = this.spec.series.map(({name, values}) => {
      const [low, high] = rangeOf(values);
      return `${name} from ${numberText(low)} to ${numberText(high)} ${this.spec.y.unit}`;
    });
    return `${this.spec.title} over ${this.x.name}: ${parts.join("; ")}`;
  }

  // --- scales ---

  findScales() {
    const y = this.spec.series.flatMap(series => series.values);
    const extra = this.spec.outline || [];
    this.xUnit = this.overSteps ? {factor: 1, name: ""} : unitOf([...this.x.values, this.x.least], this.x.unit);
    this.yUnit = this.spec.y.log ? {factor: 1, name: this.spec.y.unit}
                                 : unitOf([...y, this.spec.y.least], this.spec.y.unit);
    this.xRange = rangeOf([...this.x.values, ...extra.map(point => point[0])]);
    if (!this.overSteps) this.xRange = padded(this.xRange, 0.05, this.x.least);
    else if (this.xRange[0] === this.xRange[1]) this.xRange = padded(this.xRange, 0);
    this.yRange = this.spec.y.log ? this.decades(y) : this.linearRange([...y, ...extra.map(point => point[1])]);
    if (this.spec.equal) this.equalize();
  }

  linearRange(values) {
    const [low, high] = rangeOf(values);
    if (!this.overSteps) return padded([low, high], 0.05, this.spec.y.least);
    const span = Math.max(high, 0) - Math.min(low, 0), least = this.spec.y.least || 0;
    const room = span > least ? 0.05 * span : least || 1;
    return [low < 0 ? low - room : 0, high > 0 || low === 0 ? high + room : 0];
  }

  /** Whole powers of ten; zeros are drawn at the lower end. */
  decades(values) {
    const positive = values.filter(value => value > 0);
    if (this.spec.level) positive.push(this.spec.level.value);
    const [low, high] = positive.length ? rangeOf(positive) : [1e-16, 1];
    return [10 ** Math.floor(Math.log10(low) - 0.01), 10 ** Math.ceil(Math.log10(high) + 0.01)];
  }

  equalize() {
    const size = Math.max((this.xRange[1] - this.xRange[0]) / (BOX.right - BOX.left),
                          (this.yRange[1] - this.yRange[0]) / (BOX.bottom - BOX.top));
    const widen = ([low, high], pixels) => [(low + high - size * pixels) / 2, (low + high + size * pixels) / 2];
    this.xRange = widen(this.xRange, BOX.right - BOX.left);
    this.yRange = widen(this.yRange, BOX.bottom - BOX.top);
    this.yUnit = this.xUnit = unitOf([...this.xRange, ...this.yRange], this.spec.y.unit);
  }

  px(value) {
    return BOX.left + (value - this.xRange[0]) / (this.xRange[1] - this.xRange[0]) * (BOX.right - BOX.left);
  }

  py(value) {
    const [low, high] = this.yRange;
    const share = this.spec.y.log ? Math.log10(Math.max(value, low) / low) / Math.log10(high / low)
                                  : (value - low) / (high - low);
    return BOX.bottom - share * (BOX.bottom - BOX.top);
  }

  // --- drawing ---

  drawKeys(figure) {
    const keys = htmlElement(figure, "div", {class: "keys"});
    if (this.spec.series.length < 2) return;
    this.spec.series.forEach((series, k) => {
      const key = htmlElement(keys, "span");
      const sample = svgElement(key, "svg", {viewBox: "0 0 26 10", "aria-hidden": "true"});
      svgElement(sample, "line", {x1: 0, x2: 26, y1: 5, y2: 5, ...this.look(k), "stroke-width": 2.4});
      key.append(series.name);
    });
  }

  colour(k) {
    return `var(--${this.spec.series[k].colour || `c${k % 4 + 1}`})`;
  }

  look(k) {
    return {style: `stroke: ${this.colour(k)}`, "stroke-dasharray": DASHES[k % 4]};
  }

  drawFrame() {
    const whole = this.overSteps ? tick => Number.isInteger(tick) : () => true;
    const scaled = (range, {factor}) => range.map(value => value * factor);
    const yTicks = this.spec.y.log ? decadeTicks(...this.yRange) : linearTicks(...scaled(this.yRange, this.yUnit), 5);
    const xTicks = linearTicks(...scaled(this.xRange, this.xUnit), 6).filter(whole);
    for (const tick of yTicks) {
      const y = this.py(tick / this.yUnit.factor);
      svgElement(this.svg, "line", {class: "gridline", x1: BOX.left, x2: BOX.right, y1: y, y2: y});
      const text = this.spec.y.log ? tick.toExponential(0).replace("-", "−").replace("e+", "e") : numberText(tick, 4);
      svgElement(this.svg, "text", {class: "tick", x: BOX.left - 6, y: y + 4, "text-anchor": "end"}, text);
    }
    for (const tick of xTicks) {
      const x = this.px(tick / this.xUnit.factor);
      if (!this.overSteps) svgElement(this.svg, "line", {class: "gridline", x1: x, x2: x, y1: BOX.top, y2: BOX.bottom});
      const place = {class: "tick", x, y: BOX.bottom + 15, "text-anchor": "middle"};
      svgElement(this.svg, "text", place, numberText(tick, 4));
    }
    this.drawCycles();
    svgElement(this.svg, "rect", {class: "frame", x: BOX.left, y: BOX.top, width: BOX.right - BOX.left,
                                  height: BOX.bottom - BOX.top});
    this.drawAxisNames();
  }

  drawCycles() {
    const blocks = this.overSteps && this.spec.blocks || [];
    if (blocks.length > 40) return;
    for (const [, first] of blocks) {
      const x = this.px(first - 0.5);
      if (x <= BOX.left || x >= BOX.right) continue;
      svgElement(this.svg, "line", {class: "cycle", x1: x, x2: x, y1: BOX.top, y2: BOX.bottom});
    }
  }

  drawAxisNames() {
    const named = (name, unit) => unit ? `${name} (${unit})` : name;
    svgElement(this.svg, "text", {x: (BOX.left + BOX.right) / 2, y: BOX.height - 6, "text-anchor": "middle"},
               named(this.x.name, this.xUnit.name));
    const name = this.spec.y.name || (this.spec.series.length === 1 ? this.spec.series[0].name : "");
    const words = name ? named(name, this.yUnit.name) : this.yUnit.name;
    const y = (BOX.top + BOX.bottom) / 2;
    svgElement(this.svg, "text", {x: 11, y, "text-anchor": "middle", transform: `rotate(-90 11 ${y})`}, words);
  }

  drawCurves() {
    if (this.spec.outline) {
      const points = this.spec.outline.map(([x, y]) => `${this.px(x).toFixed(1)},${this.py(y).toFixed(1)}`).join(" ");
      svgElement(this.svg, "polygon", {class: "level", points});
    }
    if (this.spec.level) {
      const y = this.py(this.spec.level.value);
      svgElement(this.svg, "line", {class: "level", x1: BOX.left, x2: BOX.right, y1: y, y2: y});
      const place = {class: "tick", x: BOX.right - 4, y: y - 4, "text-anchor": "end"};
      svgElement(this.svg, "text", place, this.spec.level.name);
    }
    this.spec.series.forEach((series, k) => {
      const places = series.values.map((value, i) => value === null || this.x.values[i] === null ? null
                                                     : [this.px(this.x.values[i]), this.py(value)]);
      const moves = places.map((place, i) => place && (i && places[i - 1] ? "L" : "M") + place.map(u => u.toFixed(2)));
      svgElement(this.svg, "path", {class: "curve", d: moves.join(""), ...this.look(k), "data-name": series.name});
      if (places.length > MOST_DOTS) return;
      const r = places.length > 1 ? 2 : 4, style = `fill: ${this.colour(k)}`;
      for (const [cx, cy] of places.filter(place => place)) svgElement(this.svg, "circle", {cx, cy, r, style});
    });
  }

  /** The step of the maps: a line, or a ring on the path. */
  mark(step) {
    this.markGroup.replaceChildren();
    const at = this.spec.steps.indexOf(step);
    if (at < 0 || this.x.values[at] === null) return;
    const x = this.px(this.x.values[at]);
    const y = this.py(this.spec.series[0].values[at]);
    if (this.overSteps)
      svgElement(this.markGroup, "line", {class: "mark", x1: x, x2: x, y1: BOX.top, y2: BOX.bottom});
    else
      svgElement(this.markGroup, "circle", {class: "mark", cx: x, cy: y, r: 5.5});
  }

  // --- reading values ---

  listen(onStep) {
    this.svg.addEventListener("pointermove", event => this.showAt(this.nearest(event), event.clientX, event.clientY));
    this.svg.addEventListener("pointerleave", () => this.unshow());
    this.svg.addEventListener("blur", () => this.unshow());
    this.svg.addEventListener("click", event => onStep(this.spec.steps[this.nearest(event)]));
    this.svg.addEventListener("keydown", event => {
      const jump = {ArrowRight: 1, ArrowLeft: -1, PageDown: 10, PageUp: -10, Home: -Infinity, End: Infinity}[event.key];
      if (event.key === "Enter" && this.index >= 0) onStep(this.spec.steps[this.index]);
      if (jump === undefined) return;
      event.preventDefault();
      const index = Math.max(0, Math.min(this.spec.steps.length - 1, this.index + jump));
      const box = this.svg.getBoundingClientRect();
      this.showAt(index, box.left + this.px(this.x.values[index]) * box.width / BOX.width, box.top + box.height / 3);
    });
  }

  nearest(event) {
    const box = this.svg.getBoundingClientRect();
    const scale = BOX.width / box.width;
    const x = (event.clientX - box.left) * scale, y = (event.clientY - box.top) * scale;
    let best = 0, least = Infinity;
    this.x.values.forEach((value, i) => {
      if (value === null) return;
      const dx = this.px(value) - x, dy = this.overSteps ? 0 : this.py(this.spec.series[0].values[i]) - y;
      if (dx * dx + dy * dy < least) [best, least] = [i, dx * dx + dy * dy];
    });
    return best;
  }

  showAt(index, clientX, clientY) {
    this.index = index;
    this.hover.replaceChildren();
    const x = this.px(this.x.values[index]);
    if (this.overSteps) svgElement(this.hover, "line", {class: "hover", x1: x, x2: x, y1: BOX.top, y2: BOX.bottom});
    this.spec.series.forEach(({values}, k) => {
      const style = `fill: ${this.colour(k)}`;
      if (values[index] !== null) svgElement(this.hover, "circle", {cx: x, cy: this.py(values[index]), r: 4, style});
    });
    const line = (name, value, unit) => `${name}: ${numberText(value)} ${unit}`.trim();
    const lines = this.spec.series.map(({name, values}) => line(name, values[index], this.spec.y.unit));
    if (!this.overSteps) lines.unshift(line(this.x.name, this.x.values[index], this.x.unit));
    readout.show([`step ${this.spec.steps[index]}`, ...lines].join("\n"), clientX, clientY);
  }

  unshow() {
    this.index = -1;
    this.hover.replaceChildren();
    readout.hide();
  }
}
