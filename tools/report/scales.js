// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
"use strict";
// From values to places in a chart.

/** A chart of a width in pixels, with room for its frame: letters keep their size, whatever the width. */
function boxOf(width) {
  const height = Math.round(Math.max(216, Math.min(330, 64 + 0.42 * width)));
  return {left: 62, right: width - 20, top: 10, bottom: height - 40, width, height};
}

const BOX = boxOf(400);  // of saved pictures, and of what has no place yet

/** Ranges, units and places of a chart (see Chart for the spec). What is smaller than `least` is rounding. */
class Scales {
  constructor(spec, box) {
    [this.spec, this.box] = [spec, box];
    const x = spec.series.flatMap(series => series.x), y = spec.series.flatMap(series => series.y);
    const extra = spec.outline || [];
    this.xUnit = spec.x.whole ? {factor: 1, name: ""} : unitOf([...x, spec.x.least], spec.x.unit);
    this.yUnit = spec.y.log ? {factor: 1, name: spec.y.unit}
                            : unitOf(spec.y.range || [...y, spec.y.least], spec.y.unit);
    this.xRange = this.horizontal([...x, ...extra.map(point => point[0])]);
    this.yRange = spec.y.log ? this.decades(y)
                             : this.vertical(spec.y.range || [...y, ...extra.map(point => point[1])]);
    if (spec.equal) this.equalize();
  }

  horizontal(values) {
    const range = rangeOf(values);
    if (!this.spec.shared) return padded(range, 0.05, this.spec.x.least);
    return range[0] === range[1] ? padded(range, 0) : range;
  }

  vertical(values) {
    const [low, high] = rangeOf(values);
    if (!this.spec.shared || this.spec.y.fit) return padded([low, high], 0.05, this.spec.y.least);
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
    const size = Math.max((this.xRange[1] - this.xRange[0]) / (this.box.right - this.box.left),
                          (this.yRange[1] - this.yRange[0]) / (this.box.bottom - this.box.top));
    const widen = ([low, high], pixels) => [(low + high - size * pixels) / 2, (low + high + size * pixels) / 2];
    this.xRange = widen(this.xRange, this.box.right - this.box.left);
    this.yRange = widen(this.yRange, this.box.bottom - this.box.top);
    this.yUnit = this.xUnit = unitOf([...this.xRange, ...this.yRange], this.spec.y.unit);
  }

  px(value) {
    return this.box.left + (value - this.xRange[0]) / (this.xRange[1] - this.xRange[0]) * (this.box.right - this.box.left);
  }

  py(value) {
    const [low, high] = this.yRange;
    const share = this.spec.y.log ? Math.log10(Math.max(value, low) / low) / Math.log10(high / low)
                                  : (value - low) / (high - low);
    return this.box.bottom - share * (this.box.bottom - this.box.top);
  }

  /** The place of a point of a series; null where it has no value. */
  place(series, i) {
    const x = series.x[i], y = series.y[i];
    return x === null || y === null || y === undefined ? null : [this.px(x), this.py(y)];
  }

  ticks() {
    const scaled = (range, {factor}) => range.map(value => value * factor);
    const whole = this.spec.x.whole ? tick => Number.isInteger(tick) : () => true;
    const across = Math.max(5, Math.round((this.box.right - this.box.left) / 60));
    return {x: linearTicks(...scaled(this.xRange, this.xUnit), across).filter(whole),
            y: this.spec.y.log ? decadeTicks(...this.yRange) : linearTicks(...scaled(this.yRange, this.yUnit), 5)};
  }
}
