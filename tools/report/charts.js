// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
"use strict";
// Charts as SVG: curves over the steps, the cycles or a line, and paths of one quantity over another.

const DASHES = ["none", "7 3", "2 3", "9 3 2 3"];
const MOST_DOTS = 64, MOST_BARS = 12, LEAST_WIDTH = 280, WIDEST_EQUAL = 480;
const drawn = [];  // every chart, also those that no step of the maps concerns

/**
 * spec: title; series [{name, run, colour, dash, steps, x, y, gaps (x where a curve begins anew)}], one step, x and y a
 * point; x {name, unit, least, whole (whole numbers)}; y {name, unit, log, least, range, fit (zero need not be seen)};
 * shared (curves over the same x, not paths). What is smaller than `least` is rounding. Optional: caption; separators
 * [x...]; level {value, name}; outline [[x, y]...]; equal (same scale in x and y); bands [[from, to]...]; cycles (the
 * blocks that colour the path); fixed (shows the whole run always); covers (a point stands for all steps since the point
 * before); head (words of a point for the read-out).
 */
class Chart {
  constructor(parent, spec, onStep) {
    this.whole = this.spec = spec;
    const figure = this.figure = htmlElement(parent, "figure");
    this.caption = htmlElement(figure, "figcaption", {}, spec.title);
    if (spec.caption) htmlElement(figure, "p", {class: "caption"}, spec.caption);
    drawKeys(htmlElement(figure, "div", {class: "keys"}), spec);
    this.svg = svgElement(figure, "svg", {class: spec.equal ? "chart equal" : "chart", role: "img", tabindex: 0});
    this.box = BOX;
    this.draw();
    drawn.push(this);
    this.reader = new ChartReader(this, onStep);
    addSaving(this.caption, () => chartPicture(this), () => chartRows(this), spec.title);
  }

  /** Only the steps first..last from now on. */
  restrict(first, last) {
    if (this.whole.fixed) return;
    const series = this.whole.series.map(one => {
      const keep = one.steps.map(step => first <= step && step <= last);
      const part = values => values.filter((_, i) => keep[i]);
      return {...one, steps: part(one.steps), x: part(one.x), y: part(one.y)};
    });
    this.replace({...this.whole, series});
  }

  replace(spec) {
    this.spec = spec;
    this.draw();
  }

  /** As wide as its place, or as told. */
  fit(told) {
    const place = told || this.figure.clientWidth;
    if (!place) return;
    const width = Math.max(LEAST_WIDTH, this.whole.equal ? Math.min(place, WIDEST_EQUAL) : place);
    if (width !== this.box.width) this.drawIn(boxOf(width));
  }

  drawIn(box) {
    this.box = box;
    this.draw();
    if (this.step !== undefined) this.mark(this.step);
  }

  draw() {
    const {width, height} = this.box;
    this.svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.svg.replaceChildren();
    this.scales = new Scales(this.spec, this.box);
    this.svg.setAttribute("aria-label", this.description());
    this.drawFrame();
    this.markGroup = svgElement(this.svg, "g", {class: "marks", "pointer-events": "none"});
    this.drawCurves();
    this.hover = svgElement(this.svg, "g", {class: "hovering", "pointer-events": "none"});
  }

  description() {
    const parts = this.spec.series.map(({name, run, y}) => {
      const [low, high] = rangeOf(y).map(value => numberText(value));
      return `${run ? `${run}, ` : ""}${name} from ${low} to ${high} ${this.spec.y.unit}`.trim();
    });
    return `${this.spec.title} over ${this.spec.x.name}: ${parts.join("; ")}`;
  }

  // --- frame ---

  drawFrame() {
    const {scales, svg, spec} = this, ticks = scales.ticks();
    const xDigits = tickDigits(ticks.x), yDigits = tickDigits(ticks.y);
    for (const [from, to] of spec.bands || []) this.drawBand(scales.px(from), scales.px(to));
    for (const tick of ticks.y) {
      const y = scales.py(tick / scales.yUnit.factor);
      svgElement(svg, "line", {class: "gridline", x1: this.box.left, x2: this.box.right, y1: y, y2: y});
      const text = spec.y.log ? tick.toExponential(0).replace("-", "−").replace("e+", "e") : numberText(tick, yDigits);
      svgElement(svg, "text", {class: "tick", x: this.box.left - 6, y: y + 4, "text-anchor": "end"}, text);
    }
    for (const tick of ticks.x) {
      const x = scales.px(tick / scales.xUnit.factor);
      if (!spec.x.whole) svgElement(svg, "line", {class: "gridline", x1: x, x2: x, y1: this.box.top, y2: this.box.bottom});
      const place = {class: "tick", x, y: this.box.bottom + 15, "text-anchor": "middle"};
      svgElement(svg, "text", place, numberText(tick, xDigits));
    }
    this.drawSeparators();
    svgElement(svg, "rect", {class: "frame", x: this.box.left, y: this.box.top, width: this.box.right - this.box.left,
                             height: this.box.bottom - this.box.top});
    this.drawAxisNames();
  }

  drawBand(from, to) {
    const left = Math.max(this.box.left, from), right = Math.min(this.box.right, to);
    if (right > left)
      svgElement(this.svg, "rect", {class: "band", x: left, y: this.box.top, width: right - left,
                                    height: this.box.bottom - this.box.top});
  }

  drawSeparators() {
    const separators = this.spec.separators || [];
    if (separators.length > 40) return;
    for (const x of separators.map(value => this.scales.px(value)))
      if (this.box.left < x && x < this.box.right)
        svgElement(this.svg, "line", {class: "cycle", x1: x, x2: x, y1: this.box.top, y2: this.box.bottom});
  }

  drawAxisNames() {
    const named = (name, unit) => unit ? `${name} (${unit})` : name;
    const {scales, spec} = this;
    svgElement(this.svg, "text", {x: (this.box.left + this.box.right) / 2, y: this.box.height - 6, "text-anchor": "middle"},
               named(spec.x.name, scales.xUnit.name));
    const names = new Set(spec.series.map(series => series.name));
    const name = spec.y.name || (names.size === 1 ? spec.series[0].name : "");
    const words = name ? named(name, scales.yUnit.name) : scales.yUnit.name;
    const y = (this.box.top + this.box.bottom) / 2;
    const place = {x: 11, y, "text-anchor": "middle", transform: `rotate(-90 11 ${y})`};
    if (words) svgElement(this.svg, "text", place, words);
  }

  // --- curves ---

  drawCurves() {
    this.drawOutline();
    this.drawLevel();
    const {series: all, cycles} = this.spec;
    // Of several runs the first lies on top: the page is its own.
    for (const series of all.some(one => one.run) ? [...all].reverse() : all) {
      const places = series.x.map((_, i) => this.scales.place(series, i));
      const whole = [{first: 0, last: places.length - 1, colour: series.colour}];
      const pieces = cycles ? cyclePieces(series.steps, cycles) : whole;
      for (const piece of pieces) this.drawPiece(series, places, piece);
    }
  }

  drawPiece(series, places, {first, last, colour}) {
    const mine = places.slice(first, last + 1);
    const joined = i => i && mine[i - 1] && !(series.gaps && series.gaps.has(series.x[first + i]));
    const moves = mine.map((place, i) => place && (joined(i) ? "L" : "M") + place.map(u => u.toFixed(2)));
    svgElement(this.svg, "path", {class: "curve", d: moves.join(""), style: `stroke: ${colour}`,
                                  "stroke-dasharray": series.dash, "data-name": series.name,
                                  "data-run": series.run || ""});
    if (places.length > MOST_DOTS || (series.run && !series.hollow)) return;
    const r = series.hollow ? 3 : places.length > 1 ? 2 : 4;
    mine.forEach((place, i) => {
      if (!place) return;
      const hollow = series.hollow && series.hollow[first + i];
      const style = hollow ? `fill: var(--card); stroke: ${colour}` : `fill: ${colour}`;
      svgElement(this.svg, "circle", {cx: place[0], cy: place[1], r, style, class: hollow ? "hollow" : "dot"});
    });
  }

  drawOutline() {
    if (!this.spec.outline) return;
    const {scales} = this;
    const points = this.spec.outline.map(([x, y]) => `${scales.px(x).toFixed(1)},${scales.py(y).toFixed(1)}`).join(" ");
    svgElement(this.svg, "polygon", {class: "level", points});
  }

  drawLevel() {
    if (!this.spec.level) return;
    const y = this.scales.py(this.spec.level.value);
    svgElement(this.svg, "line", {class: "level", x1: this.box.left, x2: this.box.right, y1: y, y2: y});
    const place = {class: "tick", x: this.box.right - 4, y: y - 4, "text-anchor": "end"};
    svgElement(this.svg, "text", place, this.spec.level.name);
  }

  /** The step of the maps: a line, or a ring on the path. */
  mark(step) {
    this.step = step;
    this.markGroup.replaceChildren();
    const [series] = this.spec.series;
    if (!series || !series.steps || (series.run && series.run !== data.runs[0].name)) return;
    const at = this.spec.covers ? series.steps.findIndex(last => last >= step) : series.steps.indexOf(step);
    const place = at < 0 ? null : this.scales.place(series, at);
    if (!place) return;
    const [x, y] = place;
    if (this.spec.shared)
      svgElement(this.markGroup, "line", {class: "mark", x1: x, x2: x, y1: this.box.top, y2: this.box.bottom});
    else
      svgElement(this.markGroup, "circle", {class: "mark", cx: x, cy: y, r: 5.5});
  }
}

function fitAll(told) {
  for (const chart of drawn) chart.fit(told);
}
