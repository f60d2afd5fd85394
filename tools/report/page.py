# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Puts the page together: text and tables as HTML, the drawings, and the data for the scripts."""
import json
import math
import pathlib
import re

import answers
import body_lines
import energies
import entries
import loops
import model_picture
from markup import element, escape, table
from payload import payload_of, run_names

HERE = pathlib.Path(__file__).resolve().parent
SCRIPTS = ("numbers.js", "elements.js", "scales.js", "charts.js", "reading.js", "save.js", "maps.js", "space.js", "lines.js",
           "distribution.js",
           "player.js", "map_picture.js", "specs.js", "loops.js", "cycles.js", "wear.js", "body_lines.js", "report.js")
MARKS = {"good": "\u2713", "warned": "\u26a0", "bad": "\u26a0", "running": "\u23f1"}


def fallback(value, form="{}"):
    return "\u2013" if value is None else form.format(value)


# --- header ---

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
                (("grid", f"{model['cells']} patches on a half-space, {model['dofs']} degrees of freedom")
                 if model.get("backend") == "half-space" else
                 ("mesh", f"{model['cells']} cells of degree {model['degree']}, {model['dofs']} degrees of freedom")),
                ("contact nodes", f"{model['contact_nodes']} in the model"), rows[1],
                ("contact solver", f"{solver['method']}, tolerance {solver['tolerance']:g}, {solver['iterations']} "
                 "iterations"),
                ("versions", ", ".join(f"{name} {version}" for name, version in summary.get("versions", {}).items()))]
    return table((), [(name, fallback(value)) for name, value in rows], "facts")


def status(data, seconds):
    """With `seconds`, until the page is made anew."""
    kind, words = data.status()
    lines = "<br>".join(escape(line) for line in words.splitlines())
    if kind == "warned":
        lines = f'<a href="#warnings">{lines}</a>'
    if kind == "running" and seconds:
        lines += f". This page is made anew about every {seconds:.0f} s, and a browser shows the new one by itself."
    return element("p", element("strong", MARKS[kind] + " ") + lines, f"status {kind}", ' id="run-status"')


def listed(lines, css):
    return element("ul", "".join(element("li", escape(line)) for line in lines), css)


def warnings_of(data):
    recorded = data.summary.get("warnings")
    if recorded:
        return listed(recorded, "warnings")
    return element("p", "This run recorded no list of warnings." if recorded is None else "The program gave no warnings.")


def warnings(runs):
    """What the program warned of in each run, and what the page leaves out."""
    names = [element("h3", escape(name)) for name in run_names(runs)] if len(runs) > 1 else [""]
    out = "".join(name + warnings_of(data) for name, data in zip(names, runs))
    notes = list(dict.fromkeys(runs[0].notes))
    return out + (element("h3", "About this page") + listed(notes, "notes") if notes else "")


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
    return element("tr", element("th", escape(name.replace("_", " ")), more=' scope="row"') + element("td", bar, "bars")
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
    hint = ("Every chart shows these runs over each other, one colour each. Maps, tables and drawings are those of the "
            "first one.")
    return element("ul", items, "runs", ' id="runs"') + element("p", hint, "hint")


FRETTING = """<section id="fretting" aria-labelledby="fretting-title">
  <h2 id="fretting-title">Fretting loop</h2>
  <p class="hint">Q and M: tangential force and moment of the held face on the body, over its motion. The area of a closed loop is
    the work of this one component in a cycle; <a href="#energy">Energies</a> sets it beside the work of all components and
    the energy that friction dissipates.</p>
  <div class="grid" id="fretting-loops"></div>
</section>"""
WEAR = """<section id="wear" aria-labelledby="wear-title">
  <h2 id="wear-title">Wear</h2>
  <p class="hint" id="profiles-hint">The lines go through the middle of the worn volume. From one profile to the next about the same volume is
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
             "wear": (WEAR, "Wear", any(run.wears and run.n_solved for run in runs)),
             "lines": (LINES, "Lines", any(map(body_lines.lines_in, runs)))}
    sections = {name: section if is_there else "" for name, (section, _, is_there) in found.items()}
    links = {f"{name}_link": f'<a href="#{name}">{words}</a>' if is_there else ""
             for name, (_, words, is_there) in found.items()}
    return {**sections, **links}


def make(runs, seconds=None):
    """The page of the first run, with the others over it in the charts. `seconds`: the page shows itself anew after them."""
    data = runs[0]
    name = data.path.resolve().name
    # First: they note what the page leaves out.
    payload, drawn = payload_of(runs), data.read("parameters.prm", lambda: model(data))
    refresh = f'<meta http-equiv="refresh" content="{math.ceil(seconds)}">' if seconds and data.is_running else ""
    parts = {"title": escape(name), "refresh": refresh, "status": status(data, seconds),
             "answers": data.read("history.csv", lambda: answers.answers(runs, run_names(runs))), "runs": run_list(runs),
             "facts": data.read("summary.json", lambda: facts(data)),
             "warnings": warnings(runs), "model": drawn, "parameters": entries.parameters(data),
             "ledger": data.read("history.csv", lambda: energies.ledger(data)),
             **optional_sections(runs), "phases": phases(data), "data": data.read("history.csv", lambda: safe_json(payload)),
             "style": (HERE / "report.css").read_text(),
             "script": "\n".join((HERE / script).read_text() for script in SCRIPTS)}
    template = (HERE / "template.html").read_text()
    return re.sub(r"\{\{(\w+)\}\}", lambda match: parts[match[1]], template)


def said_of(runs):
    """What is on the page, in a line."""
    data = runs[0]
    sections = [words for words, is_there in (
        ("fretting loop", any(map(loops.is_fretting, runs))), ("histories", True),
        (f"maps of {len(data.maps.steps)} steps", bool(data.maps.mesh)), ("loops", True),
        ("lines", any(map(body_lines.lines_in, runs))), ("wear", any(run.wears for run in runs)),
        ("cycles", any(len(run.cycles.get("cycle", ())) for run in runs)), ("energies", True), ("solver", True)) if is_there]
    of_runs = f"{len(runs)} runs, " if len(runs) > 1 else ""
    shown = ", ".join(sections) if any(run.n_solved for run in runs) else "no charts, because no step was finished"
    return f"{of_runs}{data.n_solved} of {data.n_planned} steps; {shown}"
