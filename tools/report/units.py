# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Units of the parameters: what has none here is a pure number or a word."""
import re

UNITS = {
    "Geometry": {"Radius": "mm", "Height": "mm", "Sizes": "mm"},
    "Material": {name: "MPa" for name in ("Young modulus", "Young moduli", "Shear moduli")},
    "Mesh": {"Accuracy": "%"},
    "Friction": {"Orthotropy angle": "degrees"},
    "Obstacle": {"Gap": "mm", "Young modulus": "MPa"},
    "Load program": {"Accuracy": "%", **{name: "(mm, degrees, N, N mm : steps)" for name in ("Preload", "Legs")}},
    "Wear": {"Coefficient": "MPa\u207b\u00b9", "Largest depth of a jump": "mm"},
    "Checks": {name: "\u00d7 tolerance" for name in ("Penetration", "Complementarity", "Friction cone", "Slip rule")},
    "Output": {"Checkpoint": "s", "Probes": "(mm)"},
}
UNITS.update({"Lower geometry": UNITS["Geometry"], "Lower material": UNITS["Material"]})


def unit_of(section, entry, value):
    """The unit to be written behind a value; none behind a word, nothing, or a unit that is there."""
    unit = UNITS.get(section, {}).get(entry, "")
    return unit if re.search(r"\d", value) and not value.endswith(unit) else ""
