# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Charts and tables of the study discretization."""
import itertools

import matplotlib.pyplot as plt
import style
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, NullFormatter

QUANTITIES = {"largest_slip_mm": "largest slip, peak", "force_N": "total force, peak",
              "dissipation_Nmm": "dissipated energy", "stick_area_mm2": "stick area, peak"}
FIELDS = {"slip_peak": "slip, peak", "pressure_peak": "pressure, peak",
          "slip_last": "slip, almost unloaded", "pressure_last": "pressure, almost unloaded"}
PICTURES = {"discretization_quantities": QUANTITIES, "discretization_fields": FIELDS}
DEGREES = (1, 2, 3, 4)
LEAST = 3e-4  # percent; smaller errors are drawn there
BOUNDS = (5, 1, 0.3)  # percent, of the table
PALE = 0.35
ELEMENTS = ((1, "full"), *((degree, quadrature) for degree in DEGREES[1:] for quadrature in ("full", "projected")))


def is_pale(degree, quadrature):
    return degree > 1 and quadrature == "full"


def error(row, name):
    return max(abs(float(row[f"error_{name}"])), LEAST)


def seconds(row):
    """Of the processor: a run of one thread has the same wall time where nothing else runs."""
    return float(row["cpu_seconds"])


def chosen(rows, case, **wanted):
    wanted["case"] = case
    return [row for row in rows if all(row[name] == str(value) for name, value in wanted.items())]


def _draw_ladders(axes, rows, case, model, name):
    """From degree 2 on full quadrature is pale, under the projected one."""
    looks = {"uniform": {"ls": ":", "mfc": "white"}, "graded": {"ls": "-"}}
    for degree, quadrature, family in itertools.product(DEGREES, ("full", "projected"), looks):
        line = sorted(chosen(rows, case, model=model, family=family, degree=degree, quadrature=quadrature),
                      key=lambda row: int(row["size"]))
        axes.plot([seconds(row) for row in line], [error(row, name) for row in line], "o", ms=3.5, lw=1.2,
                  color=style.COLOURS[degree - 1], alpha=PALE if is_pale(degree, quadrature) else 1, **looks[family])


def _draw_named(axes, rows, case, model, name):
    """The resolutions of the program; the paper's meshes with a line to the same mesh of the whole body."""
    words = [row for row in chosen(rows, case, model=model, family="resolution") if row["size"] != "paper"]
    axes.plot([seconds(row) for row in words], [error(row, name) for row in words], "kd", ms=5, mfc="none")
    for family, marker in (("resolution", "*"), ("bricks", "X")):
        meshes = [row for kind in (model, "full") for row in
                  chosen(rows, case, model=kind, family=family, size="paper") if kind != "full" or model == "quarter"]
        axes.plot([seconds(row) for row in meshes], [error(row, name) for row in meshes], "-", lw=0.8, color="k")
        for row, face in zip(meshes, ("k", "white")):
            axes.plot(seconds(row), error(row, name), marker, color="k", mfc=face, ms=9 if marker == "*" else 7)


def _draw_doubt(axes, rows, case, name, bottom):
    """Differences of the two references: below them nothing is known."""
    for row in chosen(rows, case, family="reference", size="second"):
        axes.axhspan(bottom, max(error(row, name), bottom), color="#dddddd", lw=0, zorder=0)


def _handles():
    handles = [Line2D([], [], color=style.COLOURS[degree - 1], lw=2, label=f"degree {degree}") for degree in DEGREES]
    look = {"color": "#555555", "marker": "o", "ms": 4}
    handles += [Line2D([], [], ls=":", mfc="white", label="uniform", **look),
                Line2D([], [], label="graded", **look),
                Line2D([], [], alpha=PALE, label="full (degree 2 to 4)", **look)]
    look = {"color": "k", "ls": ""}
    handles += [Line2D([], [], marker="d", mfc="none", label="coarse, medium, fine", **look),
                Line2D([], [], marker="*", ms=9, label="paper's mesh, degree 2", **look),
                Line2D([], [], marker="X", ms=7, label="paper's bricks", **look),
                Line2D([], [], marker="*", ms=9, mfc="white", label="the same, whole body", **look),
                Line2D([], [], color="#dddddd", lw=6, label="reference's own error")]
    return handles


def _picture(rows, names, sections):
    figure, grid = plt.subplots(len(names), len(sections), figsize=(11, 10.5), sharex=True, sharey="row", squeeze=False)
    times = [seconds(row) for row in rows if row["family"] != "reference"]
    low, high = min(times), max(times)
    for line, (name, title) in zip(grid, names.items()):
        for axes, (case, model) in zip(line, sections):
            axes.set(xscale="log", yscale="log")
            _draw_ladders(axes, rows, case, model, name)
            _draw_named(axes, rows, case, model, name)
            axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
            axes.xaxis.set_minor_formatter(NullFormatter())
            axes.set_xticks([tick for tick in (0.2, 0.5, 1, 2, 5, 10, 20, 50) if low <= tick <= high])
            axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        line[0].set_ylabel(f"{title}\nerror (%)")
        bottom, top = line[0].get_ylim()
        line[0].yaxis.set_minor_formatter(NullFormatter())
        if top < 30 * bottom:
            line[0].set_yticks([tick for tick in (0.1, 0.2, 0.5, 1, 2, 5, 10, 20) if bottom <= tick <= top])
        for axes, (case, _) in zip(line, sections):
            _draw_doubt(axes, rows, case, name, bottom)
        line[0].set_ylim(bottom=bottom)
    for axes, (case, model) in zip(grid[0], sections):
        axes.set_title(f"case {case.upper()}, {model}", fontsize=10)
    for axes in grid[-1]:
        axes.set_xlabel("seconds, one thread")
    figure.get_layout_engine().set(rect=(0, 0, 1, 0.94))
    figure.legend(handles=_handles(), loc="upper center", ncols=6, fontsize=9)
    return figure


def figures(rows, sections):
    return {picture: _picture(rows, names, sections) for picture, names in PICTURES.items()}


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
