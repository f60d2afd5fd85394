// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
"use strict";
// Fields on the contact surface, drawn pixel by pixel.

// Colour-blind readers distinguish blue and orange, too.
const STATES = [{name: "open", colour: [200, 200, 200]}, {name: "stick", colour: [0, 114, 178]},
                {name: "slip", colour: [240, 165, 30]}];
const FIELDS = {
  status: {name: "status: open, stick, slip"},
  slip_magnitude: {name: "slip magnitude", unit: "mm"},
  pressure: {name: "pressure", unit: "MPa"},
  friction_criterion: {name: "friction criterion (0 slips, −1 no friction force)", unit: "", range: [-1, 0]},
  // What lasts stays where the surface has opened again.
  accumulated_slip: {name: "accumulated slip", unit: "mm", lasts: true},
  dissipated_energy: {name: "dissipated energy per area", unit: "N/mm", lasts: true},
  wear_depth: {name: "wear depth", unit: "mm", lasts: true},
  friction_factor: {name: "factor of friction", unit: ""},
};
// Viridis in nine colours; between them it is as good as straight.
const VIRIDIS = ["440154", "472d7b", "3b528b", "2c728e", "21918c", "28ae80", "5ec962", "addc30", "fde725"]
  .map(hex => [0, 2, 4].map(k => parseInt(hex.slice(k, k + 2), 16)));

function viridis(share) {
  const place = Math.max(0, Math.min(1, share)) * (VIRIDIS.length - 1);
  const k = Math.min(Math.floor(place), VIRIDIS.length - 2);
  return VIRIDIS[k].map((value, c) => Math.round(value + (place - k) * (VIRIDIS[k + 1][c] - value)));
}

function bytes(base64) {
  return Uint8Array.from(atob(base64), character => character.charCodeAt(0));
}

const OPEN = 0, BEYOND_CONTACT = 1.3, MOST_OF_SURFACE = 0.75;

/** Nodes and quadrilaterals as the page brings them. */
class ContactMesh {
  constructor(maps, radius, centre) {
    this.x = new Float32Array(bytes(maps.x).buffer);
    this.y = new Float32Array(bytes(maps.y).buffer);
    const Index = maps.index_bytes === 2 ? Uint16Array : Uint32Array;
    this.quads = new Index(bytes(maps.quads).buffer);
    [this.radius, this.centre] = [maps.radius ?? radius, maps.centre ?? centre];  // an unrolled surface has its own
    this.axes = maps.axes ?? ["x", "y"];
  }

  /** Centre and radius of what touches in any frame, with some room; of the whole surface where that is most of it. */
  viewOfContact(frames) {
    const touched = Array.from(this.x.keys()).filter(node => frames.some(frame => frame.status[node] !== OPEN));
    const [left, right] = rangeOf(touched.map(node => this.x[node])), [low, high] = rangeOf(touched.map(node => this.y[node]));
    const centre = [(left + right) / 2, (low + high) / 2];
    const radius = BEYOND_CONTACT * Math.max(0, ...touched.map(node => Math.hypot(this.x[node] - centre[0],
                                                                                  this.y[node] - centre[1])));
    return touched.length > 1 && radius < MOST_OF_SURFACE * this.radius ? {centre, radius} : this;
  }

  nearest(x, y) {
    let best = 0, least = Infinity;
    for (let node = 0; node < this.x.length; ++node) {
      const distance = (this.x[node] - x) ** 2 + (this.y[node] - y) ** 2;
      if (distance < least) [best, least] = [node, distance];
    }
    return best;
  }
}

/** A frame with its bytes unpacked. */
class MapFrame {
  constructor(packed) {
    this.step = packed.step;
    this.status = bytes(packed.status);
    this.known = {};
    for (const field of Object.keys(FIELDS).slice(1).filter(name => name in packed))
      this[field] = {low: packed[field].low, high: packed[field].high, levels: bytes(packed[field].levels)};
  }

  value(field, node) {
    if (field === "status") return this.status[node];
    const {low, high, levels} = this[field];
    return low + (high - low) * levels[node] / 255;
  }

  /** Nodes at which a field has nothing to say (1): they are open, and it is one of the contact, or never was there. */
  bare(field) {
    const mine = this[field], {lasts} = FIELDS[field], key = `bare ${field}`;
    this.known[key] ||= this.status.map((status, node) => status === OPEN && !(lasts && mine.levels[node] > 0));
    return this.known[key];
  }

  /** Smallest and largest value of the nodes on show; nothing where all are bare. */
  range(field, showsOpen) {
    const {low, high} = this[field];
    if (showsOpen) return [low, high];
    const key = `range ${field}`, bare = this.bare(field);
    this.known[key] ||= Array.from(this.status.keys()).filter(node => !bare[node])
      .reduce(([least, most], node) => [Math.min(least, this.value(field, node)), Math.max(most, this.value(field, node))],
              [Infinity, -Infinity]);
    return this.known[key][0] <= this.known[key][1] ? this.known[key] : null;
  }
}

/** For every pixel of a square picture four nodes and their weights: then a frame costs one look a pixel. A
 *  quadrilateral is four triangles around its centre, so that a symmetric state gives a symmetric picture. `shadeOf`
 *  says how bright a quadrilateral is, from 0 to 1. */
class Raster {
  constructor(mesh, size, margin, {centre, radius}, shadeOf = () => 1) {
    [this.size, this.centre, this.radius, this.shadeOf] = [size, centre, radius, shadeOf];
    this.shades = new Float32Array(size * size);
    this.scale = (size / 2 - margin) / radius;
    this.nodes = new Int32Array(4 * size * size).fill(-1);
    this.weights = new Float32Array(4 * size * size);
    for (let q = 0; q < mesh.quads.length; q += 4) this.fillQuad(mesh, mesh.quads.subarray(q, q + 4));
  }

  /** Where a point of the surface (mm) is in the picture. */
  place([x, y]) {
    const [left, low] = this.centre;
    return [this.size / 2 + this.scale * (x - left), this.size / 2 - this.scale * (y - low)];
  }

  fillQuad(mesh, quad) {
    const corners = Array.from(quad, node => this.place([mesh.x[node], mesh.y[node]]));
    const centre = [0, 1].map(d => corners.reduce((sum, corner) => sum + corner[d] / 4, 0));
    this.shade = this.shadeOf(quad);
    for (let k = 0; k < 4; ++k) this.fillTriangle(quad, k, corners[k], corners[(k + 1) % 4], centre);
  }

  /** The triangle of corners k and k + 1 and the centre, whose value is the mean of the four corners. */
  fillTriangle(quad, k, [ax, ay], [bx, by], [cx, cy]) {
    const area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
    if (area === 0) return;  // cells on the axis of a revolved model are triangles
    const tolerance = -1e-6, last = this.size - 1;  // pixels on a common edge belong to both
    const from = (...places) => Math.max(0, Math.floor(Math.min(...places)));
    const to = (...places) => Math.min(last, Math.max(...places));
    for (let row = from(ay, by, cy); row <= to(ay, by, cy); ++row)
      for (let column = from(ax, bx, cx); column <= to(ax, bx, cx); ++column) {
        const x = column + 0.5, y = row + 0.5;
        const wb = ((x - ax) * (cy - ay) - (cx - ax) * (y - ay)) / area;
        const wc = ((bx - ax) * (y - ay) - (x - ax) * (by - ay)) / area;
        if (wb < tolerance || wc < tolerance || wb + wc > 1 - tolerance) continue;
        const at = 4 * (row * this.size + column);
        this.shades[at / 4] = this.shade;
        this.nodes.set(quad, at);
        this.weights.fill(wc / 4, at, at + 4);
        this.weights[at + k] += 1 - wb - wc;
        this.weights[at + (k + 1) % 4] += wb;
      }
  }

  /** The status is the one with most weight among the four nodes, everything else is interpolated. */
  draw(canvas, frame, field, range, showsOpen) {
    const context = canvas.getContext("2d");
    const image = context.createImageData(this.size, this.size);
    const colourOf = field === "status" ? this.statusColours(frame) : this.valueColours(frame, field, range, showsOpen);
    for (let pixel = 0; pixel < this.size * this.size; ++pixel) {
      if (this.nodes[4 * pixel] < 0) continue;
      const colour = colourOf(4 * pixel);
      for (let c = 0; c < 3; ++c) image.data[4 * pixel + c] = this.shades[pixel] * colour[c];
      image.data[4 * pixel + 3] = 255;
    }
    context.putImageData(image, 0, 0);
  }

  statusColours(frame) {
    const {nodes, weights} = this, share = new Float32Array(STATES.length);
    return at => {
      share.fill(0);
      for (let k = at; k < at + 4; ++k) share[frame.status[nodes[k]]] += weights[k];
      return STATES[share.indexOf(Math.max(...share))].colour;
    };
  }

  /** Grey where most of the weight is of bare nodes, so that they do not bury the contact. */
  valueColours(frame, field, range, showsOpen) {
    const {nodes, weights} = this, {low, high, levels} = frame[field];
    const bare = showsOpen ? new Uint8Array(levels.length) : frame.bare(field);
    const colours = Array.from({length: 256}, (_, k) => viridis(k / 255));
    const span = range[1] - range[0] || 1, offset = 255 * (low - range[0]) / span, slope = (high - low) / span;
    return at => {
      let level = 0, known = 0;
      for (let k = at; k < at + 4; ++k)
        if (!bare[nodes[k]]) [level, known] = [level + weights[k] * levels[nodes[k]], known + weights[k]];
      if (known < 0.5) return STATES[OPEN].colour;
      return colours[Math.max(0, Math.min(255, Math.round(offset + slope * level / known)))];
    };
  }
}

/** The range of colours: fixed, that of one frame, or that of all frames. */
function colourRange(frames, field, only, showsOpen) {
  if (FIELDS[field].range) return FIELDS[field].range;
  const ranges = (only ? [only] : frames).map(frame => frame.range(field, showsOpen)).filter(Boolean);
  return ranges.length ? [Math.min(...ranges.map(([low]) => low)), Math.max(...ranges.map(([, high]) => high))] : [0, 0];
}
