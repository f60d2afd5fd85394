// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
"use strict";
// Charts and maps as files: SVG, PNG and CSV, made in the browser.

// What a picture needs of the style sheet: it stands alone.
const STYLES = ["fill", "stroke", "stroke-width", "stroke-dasharray", "stroke-linejoin", "paint-order", "font-size",
                "font-weight"];
const FONT = "system-ui, 'Segoe UI', 'DejaVu Sans', sans-serif";
const PNG_SCALE = 3;

/** The name of the run and of the chart, of characters that every file system takes. */
function fileName(title, kind) {
  const words = `${data.runs[0].name} ${title}`.replaceAll("−", "-").replace(/[^A-Za-z0-9._-]+/g, "-");
  return `${words.replace(/^[-.]+|-+$/g, "").slice(0, 100)}.${kind}`;
}

function download(name, blob) {
  const link = htmlElement(document.body, "a", {href: URL.createObjectURL(blob), download: name, hidden: ""});
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

/** A menu with a button for each kind of file. `picture` makes an SVG element, `rows` a table of texts and numbers. */
function addSaving(parent, picture, rows, title) {
  const menu = htmlElement(parent, "details", {class: "save"});
  htmlElement(menu, "summary", {"aria-label": `Save: ${title}`}, "Save");
  const buttons = htmlElement(menu, "span");
  const name = () => typeof title === "function" ? title() : title;
  const add = (kind, action) => {
    htmlElement(buttons, "button", {type: "button"}, kind).addEventListener("click", () => {
      menu.open = false;
      action(fileName(name(), kind.toLowerCase()));
    });
  };
  add("SVG", file => download(file, new Blob([svgText(picture())], {type: "image/svg+xml"})));
  add("PNG", file => savePng(file, picture()));
  add("CSV", file => download(file, new Blob([csvText(rows())], {type: "text/csv"})));
}

// --- tables ---

function csvText(rows) {
  const cell = value => value === null || value === undefined ? ""
    : /[",\n]/.test(value) ? `"${String(value).replaceAll('"', '""')}"` : String(value);
  return rows.map(row => `${row.map(cell).join(",")}\n`).join("");
}

function withUnit(name, unit) {
  return unit ? `${name} (${unit})` : name;
}

/** Curves over the same x: a column each; paths: a row a point. */
function chartRows({spec}) {
  const {series, x, y} = spec;
  if (!spec.shared) {
    const head = [...(series.some(one => one.run) ? ["run"] : []), "step", withUnit(x.name, x.unit),
                  withUnit(series[0].name, y.unit)];
    return [head, ...series.flatMap(one => one.x.map((_, i) => [...(one.run ? [one.run] : []), one.steps[i], one.x[i],
                                                                one.y[i]]))];
  }
  const places = [...new Set(series.flatMap(one => one.x))].sort((a, b) => a - b);
  const columns = series.map(one => new Map(one.x.map((place, i) => [place, one.y[i]])));
  const names = series.map(({name, run}) => withUnit(run ? `${name}, ${run}` : name, y.unit));
  return [[withUnit(x.name, x.unit), ...names], ...places.map(place => [place, ...columns.map(map => map.get(place))])];
}

// --- pictures ---

function svgText(picture) {
  return `<?xml version="1.0" encoding="UTF-8"?>\n${new XMLSerializer().serializeToString(picture)}\n`;
}

/** A colour that every reader of SVG knows. */
function plainColour(colour) {
  const parts = /^color\(srgb ([\d.e-]+) ([\d.e-]+) ([\d.e-]+)/.exec(colour);
  return parts ? `rgb(${parts.slice(1).map(part => Math.round(255 * part)).join(", ")})` : colour;
}

/** A copy that needs no style sheet. */
function standalone(element) {
  const copy = element.cloneNode(false), style = getComputedStyle(element);
  for (const name of ["class", "style", "tabindex", "role"]) copy.removeAttribute(name);
  for (const name of STYLES) {
    const value = plainColour(style.getPropertyValue(name));
    if (element.nodeName === "g" || !value || value === "normal") continue;
    copy.setAttribute(name, value);
  }
  for (const child of element.childNodes)
    copy.append(child.nodeType === 1 ? standalone(child) : child.cloneNode());
  return copy;
}

/** Pictures are light, as paper is, whatever the page looks like. */
function inLight(action) {
  const root = document.documentElement, theme = root.dataset.theme;
  root.dataset.theme = "light";
  try { return action(); } finally { root.dataset.theme = theme; }
}

function wordsWidth(words, size) {
  const context = document.createElement("canvas").getContext("2d");
  context.font = `${size}px ${FONT}`;
  return context.measureText(words).width;
}

/** Lines of words that are at most `width` wide. */
function wrapped(words, size, width) {
  const lines = [""];
  for (const word of words.split(" ")) {
    const longer = `${lines[lines.length - 1]} ${word}`.trim();
    if (wordsWidth(longer, size) <= width) lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  return lines.filter(line => line);
}

/** Title, caption and keys above a chart; returns the height they take. */
function drawHead(picture, {title, caption}, keys) {
  let y = 4;
  const write = (words, size, style) => {
    for (const line of wrapped(words, size, BOX.width - 16))
      svgElement(picture, "text", {x: 8, y: y += size + 3, style: `font-size: ${size}px; ${style}`}, line);
  };
  write(title, 14, "font-weight: 600");
  if (caption) write(caption, 11, "fill: var(--soft)");
  let x = 8;
  y += keys.length ? 6 : 0;
  for (const key of keys) {
    const sample = key.bar ? 72 : 26, before = key.bar ? `${key.from} ` : "", after = key.bar ? key.to : key.label;
    const lead = wordsWidth(before, 12), width = lead + sample + 4 + wordsWidth(after, 12) + 14;
    if (x > 8 && x + width > BOX.width) [x, y] = [8, y + 16];
    if (before) svgElement(picture, "text", {x, y: y + 10}, before);
    drawSample(picture, key, x + lead, y + 1, sample);
    svgElement(picture, "text", {x: x + lead + sample + 4, y: y + 10}, after);
    x += width;
  }
  return y + (keys.length ? 18 : 6);
}

/** A white page with the head, then what `body` draws at its height; `body` returns its own height. */
function pictureOf(spec, keys, body) {
  return inLight(() => {
    const draft = svgElement(document.body, "svg", {xmlns: SVG, "font-family": FONT, class: "draft"});
    const paper = svgElement(draft, "rect", {width: BOX.width, fill: "#ffffff"});
    const head = drawHead(draft, spec, keys), height = head + body(draft, head);
    paper.setAttribute("height", height);
    const picture = standalone(draft);
    draft.remove();
    for (const [name, value] of Object.entries({width: BOX.width, height, viewBox: `0 0 ${BOX.width} ${height}`}))
      picture.setAttribute(name, value);
    return picture;
  });
}

function chartPicture(chart) {
  return pictureOf(chart.spec, keysOf(chart.spec), (draft, top) => {
    const place = svgElement(draft, "g", {class: "chart", transform: `translate(0 ${top})`}), {box} = chart;
    chart.drawIn(BOX);
    for (const child of chart.svg.children)
      if (!["marks", "hovering"].includes(child.getAttribute("class"))) place.append(child.cloneNode(true));
    chart.drawIn(box);
    return BOX.height;
  });
}

function savePng(name, picture) {
  const image = new Image();
  image.addEventListener("load", () => {
    const canvas = document.createElement("canvas");
    canvas.width = PNG_SCALE * picture.getAttribute("width");
    canvas.height = PNG_SCALE * picture.getAttribute("height");
    canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
    canvas.toBlob(blob => download(name, blob), "image/png");
  });
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svgText(picture))}`;
}
