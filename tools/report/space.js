// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
"use strict";
// A contact surface that is not flat, in space: the mouse or the arrow keys turn it.

const SPACE_SIZE = 540, SPACE_MARGIN = 20, TURN_OF_PIXEL = 0.01, TURN_OF_KEY = 0.15, TRIAD = 38, DARKEST = 0.55;

/** Turned about z by the azimuth, and then seen from an elevation above the plane (x, y), in radians. */
class SpaceView {
  constructor(places, quads, redraw) {
    [this.places, this.quads, this.redraw] = [places, quads, redraw];
    const ranges = [0, 1, 2].map(d => rangeOf(Array.from({length: places.length / 3}, (_, node) => places[3 * node + d])));
    this.middle = ranges.map(([low, high]) => (low + high) / 2);
    this.radius = Math.hypot(...ranges.map(([low, high]) => (high - low) / 2));
    [this.azimuth, this.elevation] = [-2.2, 0.45];
    this.listen(byId("space"));
    this.look();
  }

  listen(canvas) {
    canvas.addEventListener("pointerdown", event => canvas.setPointerCapture(event.pointerId));
    canvas.addEventListener("pointermove", event => {
      if (event.buttons) this.turn(-event.movementX * TURN_OF_PIXEL, event.movementY * TURN_OF_PIXEL);
    });
    canvas.addEventListener("keydown", event => {
      const turn = {ArrowRight: [-1, 0], ArrowLeft: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[event.key];
      if (!turn) return;
      event.preventDefault();
      this.turn(...turn.map(one => one * TURN_OF_KEY));
    });
  }

  turn(azimuth, elevation) {
    this.azimuth += azimuth;
    this.elevation = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, this.elevation + elevation));
    this.look();
    this.redraw();
  }

  /** Right, up and towards the eye, of a vector. */
  seen([x, y, z]) {
    const [sin, cos] = [Math.sin(this.azimuth), Math.cos(this.azimuth)], out = x * cos + y * sin;
    const [high, flat] = [Math.sin(this.elevation), Math.cos(this.elevation)];
    return [y * cos - x * sin, z * flat - out * high, out * flat + z * high];
  }

  /** Faces that are farther away are drawn before nearer ones, which hide them. The light is where the eye is. */
  look() {
    const n = this.places.length / 3, [x, y, depth] = [new Float32Array(n), new Float32Array(n), new Float32Array(n)];
    for (let node = 0; node < n; ++node)
      [x[node], y[node], depth[node]] = this.seen([0, 1, 2].map(d => this.places[3 * node + d] - this.middle[d]));
    const ofFace = face => [0, 1, 2, 3].reduce((sum, k) => sum + depth[this.quads[4 * face + k]], 0);
    const faces = Array.from({length: this.quads.length / 4}, (_, face) => face);
    const depths = faces.map(ofFace);
    faces.sort((a, b) => depths[a] - depths[b]);
    const quads = this.quads.slice();
    faces.forEach((face, place) => quads.set(this.quads.subarray(4 * face, 4 * face + 4), 4 * place));
    const shadeOf = quad => {
      const [u, v] = [[2, 0], [3, 1]].map(([b, a]) => [x, y, depth].map(values => values[quad[b]] - values[quad[a]]));
      const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
      return DARKEST + (1 - DARKEST) * Math.abs(normal[2]) / (Math.hypot(...normal) || 1);
    };
    this.raster = new Raster({x, y, quads}, SPACE_SIZE, SPACE_MARGIN, {centre: [0, 0], radius: this.radius}, shadeOf);
    this.drawTriad();
  }

  drawTriad() {
    const overlay = byId("space-overlay"), [left, low] = [1.3 * TRIAD, SPACE_SIZE - 1.3 * TRIAD];
    overlay.replaceChildren();
    ["x", "y", "z"].forEach((name, d) => {
      const [right, up] = this.seen([0, 1, 2].map(axis => (axis === d ? TRIAD : 0)));
      svgElement(overlay, "line", {class: "plate", x1: left, y1: low, x2: left + right, y2: low - up});
      svgElement(overlay, "text", {class: "halo", x: left + 1.25 * right, y: low - 1.25 * up + 6, "text-anchor": "middle"}, name);
    });
  }

  draw(frame, field, range, showsOpen) {
    this.raster.draw(byId("space"), frame, field, range, showsOpen);
    byId("space").setAttribute("aria-label", `Surface in space, ${FIELDS[field].name}, step ${frame.step}`);
  }
}
