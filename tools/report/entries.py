# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The parameters of a run: first what differs from the defaults, then the defaults, folded, then the file as it was given."""
import functools
import json
import pathlib
import re

from markup import element, escape
from run_folder import text_of

DEFAULTS = pathlib.Path(__file__).resolve().parent / "defaults.json"  # tools/reference_pages writes it


@functools.cache
def defaults():
    return json.loads(DEFAULTS.read_text(encoding="utf-8"))


def entry_table(section, entries, units):
    rows = ""
    for entry, value in entries.items():
        unit = units.get(f"{section}/{entry}", "")
        if not re.search(r"\d", value) or value.endswith(unit):  # a word, nothing, or a unit that is there
            unit = ""
        cell = escape(value) + (" " + element("span", escape(unit), "unit") if unit else "")
        rows += element("tr", element("th", escape(entry), more=' scope="row"') + element("td", cell))
    return element("table", element("tbody", rows), "entries")


def groups(data, is_wanted):
    """The entries that are wanted, by sections, and their number."""
    units, out, count = data.summary.get("units", {}), "", 0
    for section, entries in data.parameters.items():
        if section.startswith("Lower ") and not data.has_lower:
            continue
        chosen = {entry: value for entry, value in entries.items() if is_wanted(f"{section}/{entry}", value)}
        if chosen:
            out += element("div", element("h3", escape(section)) + entry_table(section, chosen, units), "group")
            count += len(chosen)
    return element("div", out, "groups"), count


def folded(summary, content):
    return element("details", element("summary", escape(summary)) + content)


def parameters(data):
    changed, n_changed = groups(data, lambda name, value: defaults().get(name) != value)
    others, n_others = groups(data, lambda name, value: defaults().get(name) == value)
    out = (changed if n_changed else element("p", "All entries are at their defaults."))
    out += folded(f"{n_others} entries at their defaults", others)
    given = next((data.path / name for name in ("input.prm", "input.json") if (data.path / name).is_file()), None)
    if given:
        out += folded(f"The file as given ({given.name})", element("pre", escape(text_of(given, errors="replace"))))
    return out
