// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
"use strict";
// Numbers as text, units, and ticks of axes.

/** Six digits without trailing zeros; powers of ten for what is very large or small. */
function numberText(value, digits = 6) {
  if (value === null || value === undefined) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  const plain = size >= 1e-4 && size < 1e7;
  const text = plain ? String(Number(value.toPrecision(digits))) : value.toExponential(Math.min(digits - 1, 3));
  return text.replace("e+", "e").replaceAll("-", "−");
}

const UNITS = {
  "mm": {"-3": "µm", "-6": "nm"}, "N": {"3": "kN", "6": "MN"}, "MPa": {"3": "GPa"},
  "s": {"-3": "ms", "-6": "µs"},
};

/** A power of 1000 that leaves handy numbers on an axis, and the unit that goes with it. */
function unitOf(values, unit) {
  const largest = values.reduce((most, value) => Math.max(most, Math.abs(value || 0)), 0);
  const power = largest === 0 ? 0 : 3 * Math.floor(Math.log10(largest) / 3 + 1e-9);
  if (power === 0 || (largest >= 0.1 && largest < 1e4)) return {factor: 1, name: unit};
  const name = (UNITS[unit] || {})[power];
  const exponent = String(power).replace("-", "⁻").replace(/\d/g, digit => "⁰¹²³⁴⁵⁶⁷⁸⁹"[digit]);
  return {factor: 10 ** -power, name: name || `10${exponent}${unit ? " " + unit : ""}`};
}

/** Round numbers between low and high, about n of them. */
function linearTicks(low, high, n) {
  const rough = (high - low) / n;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map(m => m * power).find(size => size >= rough * 0.999);
  const ticks = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) ticks.push(k * step);
  return ticks;
}

/** As many digits as it takes to distinguish neighbours, four at least. */
function tickDigits(ticks) {
  if (ticks.length < 2) return 4;
  const most = Math.max(...ticks.map(Math.abs)), step = ticks[1] - ticks[0];
  return Math.max(4, Math.min(8, Math.ceil(Math.log10(most / step) + 1e-9) + 1));
}

/** Powers of ten between low and high, at most about six. */
function decadeTicks(low, high) {
  const first = Math.ceil(Math.log10(low) - 1e-9), last = Math.floor(Math.log10(high) + 1e-9);
  const stride = Math.max(1, Math.ceil((last - first) / 5));
  const ticks = [];
  for (let power = first; power <= last; power += stride) ticks.push(10 ** power);
  return ticks;
}

/** [low, high] of the numbers among the values; [0, 0] without any. */
function rangeOf(values) {
  let low = Infinity, high = -Infinity;
  for (const value of values) {
    if (value === null || value === undefined) continue;
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return low <= high ? [low, high] : [0, 0];
}

/** Room around a range, so that curves do not run along the frame. What is smaller than `least` is rounding, and is
 *  not blown up to the size of the chart. */
function padded([low, high], share, least = 0) {
  const room = high - low > least ? share * (high - low) : least || Math.abs(high) || 1;
  return [low - room, high + room];
}
