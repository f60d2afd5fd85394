# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Puts the page together: text and tables as HTML, the drawings, and the data for the scripts."""
import json
import pathlib
import re

import body_lines
import loops
import model_picture
import numpy as np
import worn
from markup import element, escape, table
from payload import payload_of, run_names
from run_folder import text_of

HERE = pathlib.Path(__file__).resolve().parent
SCRIPTS = ("numbers.js", "elements.js", "scales.js", "charts.js", "reading.js", "save.js", "maps.js", "lines.js",
           "player.js", "map_picture.js",
           "specs.js", "loops.js", "cycles.js", "wear.js", "body_lines.js", "report.js")
MOST_LEDGER_ROWS = 12


def fallback(value, form="{}"):
    return "\u2013" if value is None else form.format(value)


# --- header ---

def peak(data, key, column):
    """Value and step, from the summary or, without one, from the history."""
    if not data.n_solved:
        return None, None
    peaks = data.summary.get("peaks", {})
    if key in peaks:
        return peaks[key]["value"], peaks[key]["step"]
    at = int(np.argmax(data.history[column]))
    return data.history[column][at], int(data.history["step"][at])


def tile(name, value, form, step=None):
    small = element("small", f"at step {step}") if step else ""
    return element("div", element("dt", escape(name)) + element("dd", escape(fallback(value, form)) + small), "tile")


def tiles(data):
    """The figures that a reader looks for first."""
    force, force_step = peak(data, "force_z_N", "force_z")
    dissipation = data.history["total_dissipation"][-1] if data.n_solved else None
    residual = np.max(data.history["residual"]) if data.n_solved else None
    slip, slip_step = peak(data, "slip_mm", "max_slip")
    pressure, pressure_step = peak(data, "pressure_MPa", "max_pressure")
    return "".join((tile("largest slip", slip, "{:.5g} mm", slip_step),
                    tile("largest pressure", pressure, "{:.5g} MPa", pressure_step),
                    tile("largest normal force", None if force is None else force / 1000, "{:.5g} kN", force_step),
                    tile("dissipated energy", dissipation, "{:.5g} N mm"),
                    tile("largest residual", residual, "{:.1e}"),
                    tile("time of the run", data.summary.get("seconds", {}).get("total"), "{:.3g} s")))


def facts(data):
    """Model, mesh, solver and versions; what only the summary knows is missing without it."""
    summary, given = data.summary, data.parameters
    jumped = summary.get("cycles", {}).get("jumped_steps", 0)
    steps = f"{data.n_solved} of {data.n_planned}" + (f", {jumped} jumped" if jumped else "")
    rows = [("model", given["Mesh"].get("Model")), ("load steps", steps),
            ("contact solver", given["Contact solver"].get("Method"))]
    if "model" in summary and "contact_solver" in summary:
        model, solver = summary["model"], summary["contact_solver"]
        rows = [("model", f"{model['kind']} ({model['reason']})"),
                ("mesh", f"{model['cells']} cells of degree {model['degree']}, {model['dofs']} degrees of freedom"),
                ("contact nodes", f"{model['contact_nodes']} in the model"), rows[1],
                ("contact solver", f"{solver['method']}, tolerance {solver['tolerance']:g}, {solver['iterations']} "
                 "iterations"),
                ("versions", ", ".join(f"{name} {version}" for name, version in summary.get("versions", {}).items()))]
    return table((), [(name, fallback(value)) for name, value in rows], "facts")


def status(data):
    kind, words = data.status()
    lines = "<br>".join(escape(line) for line in words.splitlines())
    return element("p", element("strong", "\u2713 " if kind == "good" else "\u26a0 ") + lines, f"status {kind}",
                   ' id="run-status"')


def listed(lines, css):
    return element("ul", "".join(element("li", escape(line)) for line in lines), css)


def warnings(data):
    """What the program warned of, and what the page leaves out."""
    recorded = data.summary.get("warnings")
    if recorded:
        out = listed(recorded, "warnings")
    elif recorded is None:
        out = element("p", "This run recorded no list of warnings.")
    else:
        out = element("p", "The program gave no warnings.")
    return out + (element("h3", "About this page") + listed(data.notes, "notes") if data.notes else "")


# --- sections ---

def model(data):
    figures = "".join(element("figure", picture + element("figcaption", escape(caption)))
                      for caption, picture in model_picture.figures(data))
    kind = data.summary.get("model", {}).get("kind")
    shade = {"half": "Shaded: the half that was computed.", "quarter": "Shaded: the quarter that was computed.",
             "axisymmetric": "Heavy line: the section (r, z) that was computed; the disc is its revolution, and nodes "
                             "are counted as rings.",
             "plane strain": "Plane strain: the section (x, z) was computed. The contact surface is drawn as the strip that it "
                             "stands for, and nodes are counted as lines."}
    words = shade.get(kind, "The whole body was computed." if kind else "") + " Totals are those of the whole body."
    return element("div", figures, "figures") + element("p", escape(words), "hint")


def entry_table(section, entries, units):
    rows = ""
    for entry, value in entries.items():
        unit = units.get(f"{section}/{entry}", "")
        if not re.search(r"\d", value) or value.endswith(unit):  # a word, nothing, or a unit that is there
            unit = ""
        cell = escape(value) + (" " + element("span", escape(unit), "unit") if unit else "")
        rows += element("tr", element("th", escape(entry), more=' scope="row"') + element("td", cell))
    return element("table", element("tbody", rows), "entries")


def parameters(data):
    units = data.summary.get("units", {})
    groups = "".join(element("div", element("h3", escape(section)) + entry_table(section, entries, units), "group")
                     for section, entries in data.parameters.items() if data.has_lower or not section.startswith("Lower "))
    given = next((data.path / name for name in ("input.prm", "input.json") if (data.path / name).is_file()), None)
    details = ""
    if given:
        words = escape(text_of(given, errors="replace"))
        details = element("details", element("summary", f"The file as given ({given.name})") + element("pre", words))
    return element("div", groups, "groups") + details


def ledger(data):
    """Energies of the preload and of each cycle."""
    energy = data.energy
    if not energy:
        return ""
    blocks, note = data.blocks, ""
    if len(blocks) > MOST_LEDGER_ROWS:
        half = MOST_LEDGER_ROWS // 2
        note = element("p", f"The first and the last {half} of {len(blocks)} rows.", "hint")
        blocks = blocks[:half] + blocks[-half:]
    rows = []
    for block in blocks:
        end = min(block.last, int(data.steps[-1]))
        first, last = np.searchsorted(data.steps, (block.first, block.last + 1))
        elastic = energy["elastic"]
        change = elastic[last - 1] - (elastic[first - 1] if first else 0)
        part = slice(first, last)
        defect = energy["step_defect"][part].sum()
        defect = 0 if abs(defect) < 1e-12 * energy["scale"] else defect  # rounding
        dissipation = energy["step_dissipation"][part].sum()
        absolute = (energy["step_work"][part].sum(), change, dissipation, defect)
        relative = (abs(defect) / energy["scale"], abs(defect) / dissipation if dissipation > 0 else None)
        rows.append((f"{block.name} (steps {block.first}\u2013{end})", *(f"{value:.5g}" for value in absolute),
                     *(fallback(value, "{:.3%}") for value in relative)))
    head = ("N mm", "work of the top", "change of elastic energy", "dissipation", "defect",
            "defect / largest energy", "defect / dissipation")
    source = ("recorded by the program" if len(data.checks.get("work", ())) == data.n_solved
              else "trapezoidal rule for force and motion of the top")
    if np.any(np.diff(data.steps, prepend=0) > 1):
        source += "; cycles that were jumped are not among the rows"
    hint = (f"Work: {source}. Defect = work \u2212 change of elastic energy \u2212 dissipation; it falls with smaller "
            "steps, but for the work that leaves with worn material. Largest energy: stored or dissipated.")
    return table(head, rows, "ledger") + note + element("p", hint, "hint")


def phases(data):
    seconds = dict(data.summary.get("seconds", {}))
    total = seconds.pop("total", sum(seconds.values()))
    if not total > 0:
        return element("p", "No summary.json, or no times in it: those of the phases are not known.")
    rest = total - sum(seconds.values())
    if rest > 0:
        seconds["rest"] = rest
    rows = "".join(phase(name, value, total) for name, value in seconds.items())
    rows += element("tr", element("th", "total", more=' scope="row"') + element("td", "")
                    + element("td", f"{total:.3g} s") + element("td", ""))
    return element("table", element("tbody", rows), "phases")


def phase(name, seconds, total):
    bar = element("span", "", "bar", f' style="width:{100 * seconds / total:.2f}%"')
    return element("tr", element("th", escape(name), more=' scope="row"') + element("td", bar, "bars")
                   + element("td", f"{seconds:.3g} s") + element("td", f"{seconds / total:.1%}"))


def safe_json(value):
    """JSON that no HTML reader takes for markup."""
    text = json.dumps(value, separators=(",", ":"), allow_nan=False)
    return text.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")


def run_list(runs):
    """The names of the runs that lie over each other in the charts, with their colours; nothing of a single run."""
    if len(runs) == 1:
        return ""
    items = "".join(element("li", element("span", "", "chip", f' style="background: var(--r{k + 1})"') + escape(name))
                    for k, name in enumerate(run_names(runs)))
    hint = ("The charts of histories, loops and cycles show these runs, one colour each. Everything else on this page "
            "is of the first.")
    return element("ul", items, "runs", ' id="runs"') + element("p", hint, "hint")


FRETTING = """<section id="fretting" aria-labelledby="fretting-title">
  <h2 id="fretting-title">Fretting loop</h2>
  <p class="hint">Q and M: tangential force and moment of the top on the body, over its motion. The area of a loop is the
    work of this one component in a cycle. It is what friction dissipates where no other component does work, the cycle
    ends as it began, and nothing wears.</p>
  <div class="grid" id="fretting-loops"></div>
</section>"""
WEAR = """<section id="wear" aria-labelledby="wear-title">
  <h2 id="wear-title">Wear</h2>
  <p class="hint">The lines go through the middle of the worn volume. From one profile to the next about the same volume is
    worn.</p>
  <p class="hint" id="no-profiles" hidden>No profile: nothing is worn in the contact fields of this run, or there are none
    (Output / Contact fields = 0).</p>
  <div class="grid" id="wear-profiles"></div>
  <div class="grid" id="wear-charts"></div>
</section>"""

LINES = """<section id="lines" aria-labelledby="lines-title">
  <h2 id="lines-title">Lines in the body</h2>
  <p class="hint">s is the distance from the first end. The scales are those of all steps that can be chosen.</p>
  <div id="body-lines"></div>
</section>"""


def optional_sections(runs):
    """Sections that only some runs have, and their links."""
    found = {"fretting": (FRETTING, "Fretting", any(map(loops.is_fretting, runs)) and any(run.n_solved for run in runs)),
             "wear": (WEAR, "Wear", worn.is_worn(runs[0]) and runs[0].n_solved),
             "lines": (LINES, "Lines", bool(body_lines.lines_in(runs[0])))}
    sections = {name: section if is_there else "" for name, (section, _, is_there) in found.items()}
    links = {f"{name}_link": f'<a href="#{name}">{words}</a>' if is_there else ""
             for name, (_, words, is_there) in found.items()}
    return {**sections, **links}


def make(runs):
    """The page of the first run, with the others over it in the charts."""
    data = runs[0]
    name = data.path.resolve().name
    # First: they note what the page leaves out.
    payload, drawn = payload_of(runs), data.read("parameters.prm", lambda: model(data))
    parts = {"title": escape(name), "status": status(data), "tiles": tiles(data), "runs": run_list(runs),
             "facts": data.read("summary.json", lambda: facts(data)),
             "warnings": warnings(data), "model": drawn, "parameters": parameters(data), "ledger": ledger(data),
             **optional_sections(runs), "phases": phases(data), "data": data.read("history.csv", lambda: safe_json(payload)),
             "style": (HERE / "report.css").read_text(),
             "script": "\n".join((HERE / script).read_text() for script in SCRIPTS)}
    template = (HERE / "template.html").read_text()
    return re.sub(r"\{\{(\w+)\}\}", lambda match: parts[match[1]], template)
