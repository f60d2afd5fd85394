# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Charts and tables of the study discretization."""
import itertools

import matplotlib.pyplot as plt
import style

QUANTITIES = {"largest_slip_mm": "largest slip, peak", "force_N": "total force, peak",
              "dissipation_Nmm": "dissipated energy", "stick_area_mm2": "stick area, peak"}
FIELDS = {"slip_peak": "slip, peak", "pressure_peak": "pressure, peak",
          "slip_last": "slip, almost unloaded", "pressure_last": "pressure, almost unloaded"}
PICTURES = {"discretization_quantities": (QUANTITIES, "graded cells of degree 2 and 3 are the most accurate for their time"),
            "discretization_fields": (FIELDS, "the slip field converges, the pressure only as far as the rim lets it")}
DRAWN = ("b", "quarter")  # case and model; the others are in the table and in the file of points
DEGREES = (1, 2, 3, 4)
LEAST = 3e-4  # percent; smaller errors are drawn there
BOUNDS = (5, 1, 0.3)  # percent, of the table
ELEMENTS = ((1, "full"), *((degree, quadrature) for degree in DEGREES[1:] for quadrature in ("full", "projected")))
DEFAULT = tuple(element for element in ELEMENTS if element[0] == 1 or element[1] == "projected")  # those of the program


def error(row, name):
    return max(abs(float(row[f"error_{name}"])), LEAST)


def seconds(row):
    """Of the processor: a run of one thread has the same wall time where nothing else runs."""
    return float(row["cpu_seconds"])


def chosen(rows, case, **wanted):
    wanted["case"] = case
    return [row for row in rows if all(row[name] == str(value) for name, value in wanted.items())]


def _draw_ladders(axes, rows, case, model, name):
    looks = {"uniform": {"ls": ":", "mfc": "white"}, "graded": {"ls": "-"}}
    for (degree, quadrature), family in itertools.product(DEFAULT, looks):
        line = sorted(chosen(rows, case, model=model, family=family, degree=degree, quadrature=quadrature),
                      key=lambda row: int(row["size"]))
        if line:
            axes.plot([seconds(row) for row in line], [error(row, name) for row in line], "o", color=style.COLOURS[degree - 1],
                      label=f"degree {degree}, {family}", **looks[family])


def _draw_named(axes, rows, case, model, name):
    """The resolutions of the program, and the paper's meshes."""
    words = [row for row in chosen(rows, case, model=model, family="resolution") if row["size"] != "paper"]
    axes.plot([seconds(row) for row in words], [error(row, name) for row in words], "kd", ms=6, mfc="none", ls="",
              label="coarse, medium, fine")
    for family, marker, label in (("resolution", "*", "the paper's mesh, degree 2"), ("bricks", "X", "the paper's bricks")):
        meshes = chosen(rows, case, model=model, family=family, size="paper")
        axes.plot([seconds(row) for row in meshes], [error(row, name) for row in meshes], marker, color="k", ls="",
                  ms=9 if marker == "*" else 7, label=label)


def _draw_doubt(axes, rows, case, name, bottom):
    """Differences of the two references: below them nothing is known."""
    for row in chosen(rows, case, family="reference", size="second"):
        axes.axhspan(bottom, max(error(row, name), bottom), color="#dddddd", lw=0, zorder=0,
                     label="error of the reference itself")


def _tick_labels(axes):
    style.plain_ticks(axes.xaxis, (0.5, 1, 2, 5, 10))
    axes.yaxis.set_major_formatter("{x:g}")
    bottom, top = axes.get_ylim()
    axes.yaxis.set_minor_formatter("")
    if top < 30 * bottom:
        axes.set_yticks([tick for tick in (0.5, 1, 2, 5, 10) if bottom < tick < top])
    axes.set_ylim(bottom, top)


def _picture(rows, names, message, section):
    figure, grid = plt.subplots(2, 2, figsize=(style.WIDTH, 5.6), sharex=True)
    for axes, (name, title) in zip(grid.flat, names.items()):
        axes.set(xscale="log", yscale="log", title=title)
        _draw_ladders(axes, rows, *section, name)
        _draw_named(axes, rows, *section, name)
        _tick_labels(axes)
        _draw_doubt(axes, rows, section[0], name, axes.get_ylim()[0])
    for axes in grid[:, 0]:
        axes.set_ylabel("error (%)")
    for axes in grid[-1]:
        axes.set_xlabel("processor time (s)")
    style.legend_below(figure, *grid[0, 0].get_legend_handles_labels(), 3)
    style.headline(figure, f"Case {section[0].upper()}: {message}")
    return figure


def figures(rows, sections):
    section = DRAWN if DRAWN in sections else sections[0]
    return {picture: _picture(rows, names, message, section) for picture, (names, message) in PICTURES.items()}


def _fastest(rows, names, bound):
    """The fastest of the meshes whose errors are all within the bound."""
    good = [row for row in rows if all(abs(float(row[f"error_{name}"])) <= bound for name in names)]
    if not good:
        return "—"
    best = min(good, key=seconds)
    return f"{best['family']}, {best['contact_nodes']} nodes: {seconds(best):.1f} s"


def _table_of_fastest(rows, sections):
    text = "| case, model | three errors within | " + " | ".join(f"degree {degree}, {word}" for degree, word in ELEMENTS)
    text += " |\n" + "|---" * (2 + len(ELEMENTS)) + "|\n"
    for case, model in sections:
        for bound in BOUNDS:
            meshes = [row for family in ("uniform", "graded") for row in chosen(rows, case, model=model, family=family)]
            cells = [_fastest([row for row in meshes if (row["degree"], row["quadrature"]) == (str(degree), quadrature)],
                              list(QUANTITIES)[:3], bound) for degree, quadrature in ELEMENTS]
            text += f"| {case.upper()}, {model} | {bound:g} % | {' | '.join(cells)} |\n"
    return text


def _table_of_references(rows, sections):
    text = ("| case | reference | " + " | ".join([*QUANTITIES.values(), *FIELDS.values()]) + " |\n|---|---|"
            + "---|" * (len(QUANTITIES) + len(FIELDS)) + "\n")
    units = {name: name.rsplit("_", 1)[1].replace("Nmm", "N mm").replace("mm2", "mm²") for name in QUANTITIES}
    for case in sorted({case for case, _ in sections}):
        first, *second = chosen(rows, case, family="reference")
        cells = [f"{float(first[name]):.6g} {units[name]}" for name in QUANTITIES] + [""] * len(FIELDS)
        if second:
            doubts = [f"{abs(float(second[0][f'error_{name}'])):.2g} %" for name in [*QUANTITIES, *FIELDS]]
            cells = [f"{cell} ({doubt})" if cell else doubt for cell, doubt in zip(cells, doubts)]
        text += (f"| {case.upper()} | {first['model']}, degree {first['degree']}, {first['contact_nodes']} nodes | "
                 f"{' | '.join(cells)} |\n")
    return text


def tables(rows, sections):
    return {"discretization references": _table_of_references(rows, sections),
            "discretization fastest": _table_of_fastest(rows, sections)}
