# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The two quantities of a fretting map: their names, units and values, and the entries that take them."""
import dataclasses
import pathlib
import re
import sys

import sweep

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent.parent / "python"))
from orthocone.parameter_file import entries_of  # noqa: E402

NUMBER = r"[-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?"
UNITS = {"F": "N", "u": "mm"}
# Names that stand for what a file has: the entry, the components that may be it, and the share of its value at both ends.
OF_FILE = {"normal": ("Load program/Preload", ("Fz", "uz"), (0.5, 1.5)),
           "tangential": ("Load program/Legs", ("Fx", "ux", "Fy", "uy"), (0.1, 2.0))}


@dataclasses.dataclass
class Axis:
    """A quantity of the map. words: NAME=VALUES, as for tools/sweep. template: the setting that takes the values, or ""."""

    name: str
    unit: str
    words: str
    template: str = ""

    @property
    def label(self):
        name = self.name.rpartition("/")[2]
        return {"normal": "normal load", "tangential": "tangential amplitude"}.get(name, name) + (f" ({self.unit})" if self.unit else "")


def template_of(name, entries):
    """The setting in which NAME stands for the amplitude of the file's own legs, that amplitude, and its component: the numbers
    of this size behind the first component that is there keep their signs."""
    entry, components, _ = OF_FILE[name]
    text = entries.get(entry, "")
    for component in components:
        pattern = re.compile(rf"\b{component} +({NUMBER})(?= *(?:$|[;:]|[A-Za-z]\w* +[-+.0-9]))")
        numbers = [float(number) for number in pattern.findall(text)]
        if not any(numbers):
            continue
        largest = max(map(abs, numbers))
        if {abs(number) for number in numbers} - {0, largest} or len(numbers) != len(re.findall(rf"\b{component}\b", text)):
            raise sweep.WrongInput(f"{name}: {entry} = {text}: allowed are legs with one size of {component}, without a unit, or "
                                   f"--x and --y with other names, which stand in --set")
        filled = pattern.sub(lambda match: match[0] if float(match[1]) == 0 else
                             f"{component} {'-' if float(match[1]) < 0 else ''}{{{name}}}", text)
        return f"{entry}={filled}", largest, component
    raise sweep.WrongInput(f"{name}: {entry} = {text}: allowed are legs with {' or '.join(components)} and a number, or --x and "
                           "--y with other names, which stand in --set")


def axis_of(option, words, entries, n_points, is_set):
    """The axis of NAME=VALUES, NAME[UNIT]=VALUES, or of a name of OF_FILE alone, which gets n_points around the file's value.
    is_set(name): whether a --set of the user takes its values, so that it stands for nothing else."""
    head, equals, values = words.partition("=")
    match = re.fullmatch(r"\s*([^\[\]]*?)\s*(?:\[([^\[\]]*)\]\s*)?", head)
    is_of_file = bool(match) and match[1] in OF_FILE and not is_set(match[1])
    if not match or not match[1] or not (equals or is_of_file):
        raise sweep.WrongInput(f"{option}: '{words}': allowed is NAME=VALUES or NAME[UNIT]=VALUES")
    axis = Axis(match[1], match[2] or "", f"{match[1]}={values}")
    if is_of_file:
        axis.template, own, component = template_of(axis.name, entries)
        axis.unit = axis.unit or UNITS[component[0]]
        if not equals:
            first, last = (share * own for share in OF_FILE[axis.name][2])
            axis.words = f"{axis.name}={first:.10g}:{last:.10g}:{n_points}"
    try:
        (_, found), = sweep.grid_of([axis.words])
    except sweep.WrongInput as error:
        raise sweep.WrongInput(str(error).replace("--vary", option)) from error
    if len(found) < 2:
        raise sweep.WrongInput(f"{option}: '{words}': allowed are two values and more")
    return axis


def axes_of(file, settings, x, y, points):
    """Both axes. settings: those of --set, whose legs stand in the place of the file's."""
    entries = entries_of(file)
    for setting in settings:
        name, _, text = setting.partition("=")
        entries["/".join(word.strip() for word in name.split("/"))] = text.strip()
    def is_set(name):
        return any("{" + name + "}" in setting for setting in settings)

    axes = [axis_of(option, words, entries, n, is_set) for option, words, n in (("--x", x, points[0]), ("--y", y, points[1]))]
    if axes[0].name == axes[1].name:
        raise sweep.WrongInput(f"--x and --y: both are {axes[0].name}: allowed are two names")
    return axes
