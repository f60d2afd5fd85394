# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Error against time of meshes: degree and volumetric quadrature, uniform or graded, axisymmetric or solid, cases A, B and C.

One proportional step to the peak, then three steps up to a fifth of it. Errors are relative to a run that is finer than
all others; the order of its own error is its difference to a second, coarser one."""
import discretization_charts
import numpy as np
from contact_surface import RevolvedSurface, SolidSurface, quarter_rule, relative_l2
from points import StudyError, program_point
from run_folder import RunFolder

PAGE = "accuracy.md"
PROGRAM = {"Load program/Legs": "0 0 -0.1 : 1; 0 0 -0.02 : 3", "Load program/Cycles": 1, "Output/Volume fields": 0,
           "Output/Contact fields": 1}
PEAK, LAST = 1, 4  # steps; in the last one most of the base slips back
QUANTITIES = ("largest_slip_mm", "force_N", "dissipation_Nmm", "stick_area_mm2")
FIELDS = {"slip_peak": ("slip", PEAK), "pressure_peak": ("pressure", PEAK),
          "slip_last": ("slip", LAST), "pressure_last": ("pressure", LAST)}
POINTS, WEIGHTS = quarter_rule()

SECTIONS = (("a", "axisymmetric"), ("a", "quarter"), ("b", "quarter"), ("c", "quarter"))
# {degree: sizes}: of uniform meshes core cells, rings and layers; of graded ones rings.
UNIFORM = {"axisymmetric": {1: (4, 8, 16, 32, 64), 2: (4, 8, 16, 32, 64), 3: (4, 8, 16, 32), 4: (4, 8, 16, 32)},
           "quarter": {1: (4, 8, 16, 24), 2: (2, 4, 8, 12), 3: (2, 4, 6, 8)}}
GRADED = {"axisymmetric": {1: (4, 8, 16, 24), 2: (4, 8, 12, 16, 24), 3: (3, 4, 6, 8, 12), 4: (3, 4, 6, 8, 12)},
          "quarter": {1: (4, 8, 12, 16), 2: (3, 4, 6, 8, 10), 3: (2, 3, 4, 6, 8)}}
WORDS = ("coarse", "medium", "fine")  # of Mesh/Resolution
QUADRATURES = {1: ("full",), 2: ("full", "projected"), 3: ("full", "projected"), 4: ("full", "projected")}
REFERENCES = {"axisymmetric": (4, 64, 40, 0.86, 48, 0.78), "quarter": (3, 12, 10, 0.55, 14, 0.45)}
SECOND = {"axisymmetric": (4, 48, 28, 0.82, 36, 0.72), "quarter": (3, 10, 7, 0.55, 12, 0.45)}
QUICK = {"axisymmetric": (4, 6, 6, 0.5, 12, 0.5), "quarter": (3, 4, 3, 0.4, 6, 0.36)}


def entries(degree, core, rings, factor, n_layers, layer_factor):
    return {"Mesh/Degree": degree, "Mesh/Core cells": core, "Mesh/Rings": rings, "Mesh/Core ratio": 0.6,
            "Mesh/Rim grading": factor, "Mesh/Layers": n_layers, "Mesh/Layer grading": layer_factor}


def graded(degree, rings):
    """Cells shrink towards the rim, base and top. A fixed factor from ring to ring would leave the widest ring as wide
    as it is, however many there are; so it rises towards 1. The lowest layer is as thick as the outermost ring."""
    factor = round(max(0.4, 1 - 3.2 / rings), 2)
    thinnest = 0.4 * factor**(rings - 1) / sum(factor**i for i in range(rings))  # of height and radius, which are equal
    layer_factor = next((grading for grading in np.round(np.arange(1, 0.3, -0.01), 2)
                         if 0.5 * grading**(rings - 1) / sum(grading**i for i in range(rings)) <= thinnest), 0.3)
    return entries(degree, rings + rings % 2, rings, factor, 2 * rings, layer_factor)


def uniform(degree, n):
    return {"Mesh/Degree": degree, "Mesh/Core cells": n, "Mesh/Layers": n}


def case_point(case, model, family, size, settings, quadrature, file=None):
    columns = {"case": case, "model": model, "family": family, "size": size, "quadrature": quadrature}
    return program_point(columns, f"paper/{file or f'case_{case}'}.prm",
                         {**PROGRAM, "Mesh/Model": model, **settings, "Mesh/Volumetric quadrature": quadrature})


def ladders(case, model, is_quick):
    n = 1 if is_quick else None
    for family, ladder, mesh in (("uniform", UNIFORM, uniform), ("graded", GRADED, graded)):
        for degree, sizes in ladder[model].items():
            for size in sizes[:n]:
                for quadrature in QUADRATURES[degree]:
                    yield case_point(case, model, family, size, mesh(degree, size), quadrature)


def marked(case, model, is_quick):
    """The meshes that have names; those of the paper's kind, whose quadrature is full, as full bodies, too."""
    for word in WORDS[:1] if is_quick else WORDS:
        yield case_point(case, model, "resolution", word, {"Mesh/Resolution": word}, "projected")
    for kind in [model] if is_quick or model == "axisymmetric" else [model, "full"]:
        yield case_point(case, kind, "resolution", "paper", {"Mesh/Resolution": "paper"}, "full")
        if model != "axisymmetric":
            yield case_point(case, kind, "bricks", "paper", {}, "full", f"case_{case}_q1")


def fields_of(run, kind):
    """{name: values at POINTS}."""
    values = {}
    for step in (PEAK, LAST):
        file = run.contact(step)
        surface = RevolvedSurface(file) if kind == "axisymmetric" else SolidSurface(file)
        surface.locate(POINTS)
        values.update({name: surface[field] for name, (field, of_step) in FIELDS.items() if of_step == step})
    return values


def quantities_of(run):
    history = run.history
    values = (history["max_slip"][PEAK - 1], history["force_z"][PEAK - 1], history["total_dissipation"][LAST - 1],
              history["stick_area"][PEAK - 1])
    return dict(zip(QUANTITIES, values))


def figures_of_run(result, point):
    """Figures of a row, and quantities and fields to compare."""
    if result.code != 0:
        raise StudyError(f"exit code {result.code}: {point.command}\n{result.errors}")
    run = RunFolder(result.folder)
    summary = run.summary
    model, values = summary["model"], quantities_of(run)
    row = {"degree": model["degree"], "contact_nodes": model["contact_nodes"], "unknowns": model["free_dofs"],
           "seconds": f"{result.seconds:.3f}", "cpu_seconds": f"{result.cpu_seconds:.3f}",
           "gigabytes": f"{result.gigabytes:.3f}", **{name: f"{value:.8g}" for name, value in values.items()}}
    return row, {**values, **fields_of(run, model["kind"])}


def errors(values, reference):
    """In percent; of quantities with their sign."""
    result = {name: 100 * (values[name] / reference[name] - 1) for name in QUANTITIES}
    result.update({name: 100 * relative_l2(values[name], reference[name], WEIGHTS) for name in FIELDS})
    return {f"error_{name}": f"{value:.4g}" for name, value in result.items()}


def reference_file(context, case):
    return context.folder / f"discretization-{case}.npz"


def reference_points(sections, size, meshes):
    """Case A has one reference for both of its models."""
    return [case_point(case, model, "reference", size, entries(*meshes[model]), "projected")
            for case, model in sections if (case, model) != ("a", "quarter")]


def kept(file):
    """Quantities and fields of a reference, which are no part of its row."""
    if not file.exists():
        raise StudyError(f"{file} is gone: the study has to be made again with --anew")
    return dict(np.load(file))


def measured(context):
    def keep(result, point):
        row, values = figures_of_run(result, point)
        np.savez_compressed(reference_file(context, point.columns["case"]), **values)
        return {**row, **errors(values, values)}

    sections = SECTIONS[::2] if context.is_quick else SECTIONS
    points = reference_points(sections, "first", QUICK if context.is_quick else REFERENCES)
    rows = context.measure(points, keep, jobs=context.jobs, threads=1)
    references = {row["case"]: kept(reference_file(context, row["case"])) for row in rows}

    def compare(result, point):
        row, values = figures_of_run(result, point)
        return {**row, **errors(values, references[point.columns["case"]])}

    if not context.is_quick:
        points = reference_points(sections, "second", SECOND)
        rows += context.measure(points, compare, jobs=context.jobs, threads=1)
    points = [point for case, model in sections for make in (ladders, marked)
              for point in make(case, model, context.is_quick)]
    return rows + context.measure(points, compare, threads=1)


def shown(rows):
    """The sections that have been measured."""
    return [section for section in SECTIONS if section in {(row["case"], row["model"]) for row in rows}]


def figures(rows):
    return discretization_charts.figures(rows, shown(rows))


def tables(rows):
    return discretization_charts.tables(rows, shown(rows))
