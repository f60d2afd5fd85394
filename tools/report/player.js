// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
"use strict";
// The map with its slider, field, colours and small pictures.

const MAP_SIZE = 660, MAP_MARGIN = 34, THUMB_SIZE = 150, MOST_LETTERS = 28;

class Player {
  constructor({maps, runs: [{history, blocks, probes}], radius, centre, outline}) {
    this.history = history;
    this.blocks = blocks;
    this.lines = new LineCharts(maps);
    this.distribution = new PressureDistribution(data.runs);
    this.mesh = new ContactMesh(maps, radius, centre);
    this.frames = maps.frames.map(packed => new MapFrame(packed));
    // An unrolled surface is its own outline.
    Object.assign(this, maps.axes ? {outline: [], probes: []} : {outline, probes});
    this.view = this.mesh.viewOfContact(this.frames);
    this.field = "status";
    this.timer = null;
    for (const [field, {name}] of Object.entries(FIELDS).filter(([key]) => key in this.frames[0]))
      htmlElement(byId("field"), "option", {value: field}, name);
    if (maps.space)
      this.space = new SpaceView(new Float32Array(bytes(maps.space).buffer), this.mesh.quads, () => this.drawMap());
    byId("space-panel").hidden = !maps.space;
    this.look();
    this.addThumbs(maps.small);
    addMapSaving(this);
    this.listen();
    this.show(this.startFrame());
    this.refresh();
  }

  /** Where most nodes differ in status: this shows more than the first step. */
  startFrame() {
    const mixture = ({status}) => {
      const slipping = status.filter(state => state === 2).length / status.length;
      return slipping * (1 - slipping);
    };
    const mixtures = this.frames.map(mixture);
    return mixtures.indexOf(Math.max(...mixtures));
  }

  // --- what does not change with the step ---

  get showsOpen() {
    return byId("whole").checked;
  }

  /** At the contact, or at the whole surface. */
  look() {
    const view = this.showsOpen ? this.mesh : this.view;
    this.raster = new Raster(this.mesh, MAP_SIZE, MAP_MARGIN, view);
    this.small = new Raster(this.mesh, THUMB_SIZE, 1, view);
    this.drawOverlay();
  }

  drawOverlay() {
    const overlay = byId("map-overlay"), middle = MAP_SIZE / 2;
    overlay.replaceChildren();
    const d = this.outline.map(polygon => `M${polygon.map(point => this.raster.place(point).join(" ")).join("L")}Z`).join("");
    svgElement(overlay, "path", {class: "disc", d});
    svgElement(overlay, "text", {class: "halo", x: MAP_SIZE - 16, y: middle + 6, "text-anchor": "middle"}, this.mesh.axes[0]);
    svgElement(overlay, "text", {class: "halo", x: middle, y: 24, "text-anchor": "middle"}, this.mesh.axes[1]);
    const inside = ([x, y]) => Math.min(x, y) > 10 && Math.max(x, y) < MAP_SIZE - 10;
    for (const {name, place} of this.probes)
      if (place && inside(this.raster.place(place))) this.drawProbe(overlay, name, this.raster.place(place));
    const bar = 2 * 10 ** Math.floor(Math.log10(this.raster.radius / 2)), length = bar * this.raster.scale;
    svgElement(overlay, "line", {class: "plate", x1: 14, x2: 14 + length, y1: MAP_SIZE - 12, y2: MAP_SIZE - 12});
    const {factor, name} = unitOf([bar], "mm");
    svgElement(overlay, "text", {class: "halo", x: 14, y: MAP_SIZE - 20}, `${numberText(bar * factor)} ${name}`);
  }

  /** The name stands on the side of the centre, where there is room for it. */
  drawProbe(overlay, name, [x, y]) {
    const isRight = x > MAP_SIZE / 2, side = isRight ? -1 : 1;
    svgElement(overlay, "circle", {class: "probe", cx: x, cy: y, r: 6});
    svgElement(overlay, "text", {class: "halo", x: x + 9 * side, y: y - 9, "text-anchor": isRight ? "end" : "start"},
               shortened(name, MOST_LETTERS));
  }

  // --- small maps of the whole run ---

  blockOf({step}) {
    return this.blocks.find(([, first, last]) => first <= step && step <= last);
  }

  /** The first and the last step, and ends of legs, where the load turns. */
  addThumbs(steps) {
    this.thumbs = steps.map(step => this.frames.findIndex(frame => frame.step === step)).map(index => {
      const button = htmlElement(byId("thumbs"), "button", {type: "button"});
      const canvas = htmlElement(button, "canvas", {width: THUMB_SIZE, height: THUMB_SIZE, "aria-hidden": "true"});
      button.append(`step ${this.frames[index].step}`);
      button.addEventListener("click", () => this.show(index));
      return {index, button, canvas};
    });
  }

  drawThumbs() {
    for (const {index, canvas} of this.thumbs)
      this.small.draw(canvas, this.frames[index], this.field, this.range(index), this.showsOpen);
  }

  listen() {
    const slider = byId("step");
    slider.max = this.frames.length - 1;
    slider.addEventListener("input", () => this.show(Number(slider.value)));
    byId("back").addEventListener("click", () => this.show(this.index - 1));
    byId("forward").addEventListener("click", () => this.show(this.index + 1));
    byId("play").addEventListener("click", () => this.playOrStop());
    byId("field").addEventListener("change", event => {
      this.field = event.target.value;
      this.refresh();
    });
    byId("own-scale").addEventListener("change", () => this.refresh());
    byId("whole").addEventListener("change", () => {
      this.look();
      this.refresh();
    });
    byId("map").addEventListener("pointermove", event => this.probe(event));
    byId("map").addEventListener("keydown", event => {
      const move = {ArrowRight: 1, ArrowLeft: -1}[event.key];
      if (!move) return;
      event.preventDefault();
      this.show(this.index + move);
    });
  }

  playOrStop() {
    const playing = this.timer === null;
    if (playing) this.timer = setInterval(() => this.show((this.index + 1) % this.frames.length), 400);
    else this.timer = clearInterval(this.timer) || null;
    byId("play").textContent = playing ? "Pause" : "Play";
    byId("play").setAttribute("aria-pressed", String(playing));
  }

  // --- the current frame ---

  toNearest(step) {
    const distances = this.frames.map(frame => Math.abs(frame.step - step));
    this.show(distances.indexOf(Math.min(...distances)));
  }

  show(index) {
    this.index = Math.max(0, Math.min(this.frames.length - 1, index));
    const frame = this.frames[this.index];
    byId("step").value = this.index;
    byId("step").setAttribute("aria-valuetext", `step ${frame.step}`);
    for (const chart of charts) chart.mark(frame.step);
    for (const thumb of this.thumbs)
      thumb.button.setAttribute("aria-current", String(thumb.index === this.index));
    this.describe(frame);
    this.drawMap();
    this.lines.show(frame.step);
    this.distribution.show(frame.step);
  }

  /** A new field or scale: the small maps change, too. */
  refresh() {
    this.drawThumbs();
    byId("own-scale-label").hidden = this.field === "status" || Boolean(FIELDS[this.field].range);
    this.drawMap();
  }

  get frame() {
    return this.frames[this.index];
  }

  range(index) {
    if (this.field === "status") return null;
    return colourRange(this.frames, this.field, byId("own-scale").checked ? this.frames[index] : null, this.showsOpen);
  }

  describe(frame) {
    const h = this.history, row = h.step.indexOf(frame.step);
    const block = this.blockOf(frame);
    this.counts = row < 0 ? null : [h.n_open[row], h.n_stick[row], h.n_slip[row]];
    const place = block ? `step ${frame.step}, ${block[0]}` : `step ${frame.step}`;
    const motion = row < 0 ? "" : `\ntop at (${["ux", "uy", "uz"].map(name => numberText(h[name][row])).join(", ")}) mm`
      + `\n${data.has_normal_z ? "normal force" : "force along z"} ${numberText(h.force_z[row])} N`;
    byId("step-text").textContent = `${place}${motion}`;
  }

  drawMap() {
    const frame = this.frames[this.index], range = this.range(this.index);
    this.raster.draw(byId("map"), frame, this.field, range, this.showsOpen);
    this.space?.draw(frame, this.field, range, this.showsOpen);
    const legend = byId("map-legend");
    legend.replaceChildren();
    if (this.field === "status") this.drawStates(legend);
    else this.drawColourBar(legend, range, frame);
    byId("map").setAttribute("aria-label", `Map of ${FIELDS[this.field].name}, step ${frame.step}`);
  }

  drawStates(legend) {
    STATES.forEach((state, k) => this.drawState(legend, state, this.counts ? `: ${this.counts[k]} nodes` : ""));
  }

  drawState(legend, {name, colour}, more) {
    const line = htmlElement(legend, "span", {class: "state"});
    htmlElement(line, "span", {class: "chip", style: `background: rgb(${colour.join(" ")})`});
    line.append(`${name}${more}`);
  }

  drawColourBar(legend, range, frame) {
    const stops = VIRIDIS.map(colour => `rgb(${colour.join(" ")})`).join(", "), {unit, lasts} = FIELDS[this.field];
    htmlElement(legend, "div", {class: "colour-bar", style: `background: linear-gradient(to right, ${stops})`});
    const ends = htmlElement(legend, "div", {class: "colour-ends"}), mine = frame.range(this.field, this.showsOpen);
    for (const value of range) htmlElement(ends, "span", {}, `${numberText(value, 4)} ${unit}`);
    const text = mine ? `In this step from ${numberText(mine[0], 4)} to ${numberText(mine[1], 4)} ${unit}`
                      : "In this step no node is in contact";
    htmlElement(legend, "p", {class: "hint"}, text.trim());
    if (!this.showsOpen && frame.bare(this.field).some(Boolean))
      this.drawState(legend, STATES[OPEN], lasts ? ", and so far untouched" : ": no value");
  }

  probe(event) {
    const box = byId("map").getBoundingClientRect(), scale = MAP_SIZE / box.width, {centre, radius} = this.raster;
    const right = ((event.clientX - box.left) * scale - MAP_SIZE / 2) / this.raster.scale;
    const up = (MAP_SIZE / 2 - (event.clientY - box.top) * scale) / this.raster.scale;
    if (Math.hypot(right, up) > 1.02 * radius) return;
    const node = this.mesh.nearest(centre[0] + right, centre[1] + up), frame = this.frames[this.index];
    const isOpen = this.field !== "status" && !this.showsOpen && frame.bare(this.field)[node];
    const value = this.field === "status" || isOpen ? STATES[frame.status[node]].name
      : `≈ ${numberText(frame.value(this.field, node), 3)} ${FIELDS[this.field].unit}`;
    const place = [this.mesh.x[node], this.mesh.y[node]].map(x => numberText(x, 4)).join(", ");
    byId("map-probe").textContent = `Node at (${place}) mm: ${value}`;
  }
}
