# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Charts of accuracy against time and maps of where methods fail. Started by tools/study."""
import argparse
import csv
import hashlib
import importlib
import pathlib
import sys

import docs_page
import style
from paths import ROOT
from points import StudyError, Table, measure, write_rows

# Module of each study, in the order of docs/accuracy.md and docs/stability.md. A module has PAGE, the page of docs/
# that shows it; measured(context), the rows of its points; figures(rows), {name: figure}; and, if the page has tables
# of it, tables(rows), {name: text}.
STUDIES = ("discretization", "adaptive", "solvers", "load_stepping", "slip_integration", "projection", "reduced_models", "maps",
           "measured_laws", "backends", "elastic", "choices", "half_space", "half_space_multigrid",
           "ball_models", "rough_contact", "scale", "spectra", "small_problems", "uniqueness", "locking", "wear_jumps",
           "wear_steps", "wear_flicker", "tractions", "counterbodies", "imported", "contact_examples", "identification")
# Words that stand before all others, and the modules that have their main().
OTHERS = {"figures": "paper_figures", "verification": "verification", "tutorial": "tutorial", "rigs": "rigs", "parts": "parts",
          "report": "report_picture", "law": "law_picture", "friction": "measured_friction", "benchmark": "benchmark", "peers": "peers"}


class Context:
    """What a study needs to know to measure its points."""

    def __init__(self, name, options):
        self.name = name
        self.is_quick = options.quick
        self.is_large = options.large
        self.jobs = options.jobs
        self.folder = options.output  # of files that are no rows
        self._programs = {"build/orthocone": options.program, "build/studies": options.studies}
        self._table = Table(options.output / f"{name}.csv", options.anew)

    def measure(self, points, extract, jobs=1, threads=None):
        """Rows of the points. Points whose time matters run alone (jobs=1); others with self.jobs and one BLAS thread."""
        return measure(self._table, points, extract, self._programs, jobs, threads,
                       lambda text: print(f"study: {self.name}: {text}", flush=True))


def parsed_options():
    parser = argparse.ArgumentParser(prog="tools/study", description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME", help="studies to make (all): " + ", ".join(STUDIES))
    parser.add_argument("--list", action="store_true", help="list what there is, and stop")
    parser.add_argument("--docs", action="store_true", help="also refresh the pages, pictures and tables in docs/")
    parser.add_argument("--anew", action="store_true", help="compute also the points that are there already")
    parser.add_argument("--redraw", action="store_true", help="compute nothing: pictures and tables of the points in docs/data")
    parser.add_argument("--quick", action="store_true", help="few points: a test of this tool, not a study")
    parser.add_argument("--large", action="store_true", help="also the points of `elastic` and `adaptive` that take gigabytes")
    parser.add_argument("--jobs", type=int, default=2, help="runs at a time where no time is measured (2)")
    parser.add_argument("--output", type=pathlib.Path, help="folder of the results (output/study)")
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/orthocone")
    parser.add_argument("--studies", type=pathlib.Path, default=ROOT / "build/studies")
    options = parser.parse_args()
    if options.output is None:
        options.output = ROOT / ("output/study-quick" if options.quick else "output/study")
    unknown = [name for name in options.names if name not in STUDIES]
    if unknown:
        parser.error(f"there is no study '{unknown[0]}': allowed are {', '.join(STUDIES)}")
    if options.quick and options.docs:
        parser.error("--quick measures nothing that belongs in --docs")
    return options


def fingerprint():
    """Of everything that the programs are built from: another commit of pages or tools leaves points as they are."""
    files = [ROOT / "CMakeLists.txt", *(file for folder in ("include", "source", "tools/studies/experiments", "prm")
                                        for file in (ROOT / folder).rglob("*") if file.is_file())]
    digest = hashlib.sha256()
    for file in sorted(files):
        digest.update(file.read_bytes())
    return digest.hexdigest() + "\n"


def set_aside_other_versions(name, options):
    """Points of another version of the program do not stand beside those of this one."""
    mark, table = options.output / f"{name}.version", options.output / f"{name}.csv"
    present = fingerprint()
    if table.exists() and not (mark.exists() and mark.read_text(encoding="utf-8") == present):
        table.replace(options.output / f"{name}.csv.old")
        print(f"study: {name}: points of another version are in {name}.csv.old; they are computed anew", flush=True)
    options.output.mkdir(parents=True, exist_ok=True)
    mark.write_text(present, encoding="utf-8")


def measured_rows(module, name, options):
    set_aside_other_versions(name, options)
    return module.measured(Context(name, options))


def stored_rows(name):
    """Of docs/data, as text, like those that are measured."""
    with open(ROOT / "docs/data" / f"{name}.csv", newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def make(name, options):
    module = importlib.import_module(name)
    rows = stored_rows(name) if options.redraw else measured_rows(module, name, options)
    folders = [options.output] + ([ROOT / "docs/images"] if options.docs else [])
    for picture, figure in module.figures(rows).items():
        style.save(figure, picture, folders)
        print(f"study: {options.output / picture}.png", flush=True)
    tables = module.tables(rows) if hasattr(module, "tables") else {}
    for table in tables.values():
        print("\n" + table, flush=True)
    if options.docs:
        docs_page.write_tables(tables, ROOT / "docs" / module.PAGE, "study")
        write_rows(ROOT / "docs/data" / f"{name}.csv", rows)


def main():
    if sys.argv[1:] and sys.argv[1] in OTHERS:
        importlib.import_module(OTHERS[sys.argv.pop(1)]).main()
        return
    options = parsed_options()
    if options.list:
        for name in STUDIES:
            print(f"{name:24}{importlib.import_module(name).__doc__.splitlines()[0]}")
        return
    try:
        for name in options.names or STUDIES:
            make(name, options)
    except StudyError as error:
        sys.exit(f"study: {error}")
    except KeyboardInterrupt:
        sys.exit("study: interrupted; the same command goes on")


if __name__ == "__main__":
    main()
