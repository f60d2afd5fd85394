# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Times kernels and whole runs, prints ratios within this call, writes benchmark.json and charts. Started by
tools/study benchmark."""
import argparse
import json
import pathlib
import sys

import benchmark_charts
import docs_page
from benchmark_compare import compare
from benchmark_measure import BenchmarkError, measure
from benchmark_ratios import TABLES, ratios
from paths import ROOT

PAGE = ROOT / "docs/performance.md"
SIZES = (4, 6, 8, 12, 16, 24, 32)  # core cells
QUICK_SIZES = (2, 4)


def positive(text):
    number = int(text)
    if number < 1:
        raise argparse.ArgumentTypeError(f"{text} is not positive")
    return number


def parsed_options():
    parser = argparse.ArgumentParser(prog="tools/study benchmark", description=__doc__)
    parser.add_argument("--runs", type=positive, default=5, help="runs of everything, of which medians are taken (5)")
    parser.add_argument("--finest", type=int, choices=SIZES[1:], default=16, metavar="CELLS",
                        help="core cells of the finest mesh: 6, 8 (the paper's), 12, 16 (default), 24 or 32; 32 takes "
                             "20 GB and many minutes a run")
    parser.add_argument("--quick", action="store_true", help="tiny meshes, once: a test of this tool, not a measurement")
    parser.add_argument("--docs", action="store_true", help="also refresh docs/performance.md, its charts and data")
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "output/benchmark", help="folder of the results")
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/orthocone")
    parser.add_argument("--kernels", type=pathlib.Path, default=ROOT / "build/kernels")
    parser.add_argument("--against", type=pathlib.Path, metavar="PROGRAM",
                        help="only compare whole runs with those of another build of the program, in turns")
    options = parser.parse_args()
    if (options.quick or options.against) and options.docs:
        parser.error("--quick and --against measure nothing that belongs in --docs")
    options.sizes = QUICK_SIZES if options.quick else [cells for cells in SIZES if cells <= options.finest]
    options.least_seconds = 0.001 if options.quick else 0.1
    if options.quick:
        options.runs = 1
    return options


def save(result, folder):
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "benchmark.json").write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
    print(f"benchmark: {folder / 'benchmark.json'}")


def main():
    options = parsed_options()
    try:
        if options.against:
            compare(options.program, options.against, options.sizes, options.runs)
            return
        result = measure(options)
    except BenchmarkError as error:
        sys.exit(f"benchmark: {error}")
    result["ratios"] = ratios(result)
    tables = {name: make(result) for name, make in TABLES.items()}
    for table in tables.values():
        print("\n" + table, end="")
    print()
    save(result, options.output)
    images = ROOT / "docs/images" if options.docs else None
    docs_page.draw("benchmark", benchmark_charts.CHARTS, result, options.output, images)
    if options.docs:
        save(result, ROOT / "docs/data")
        docs_page.write_tables(tables, PAGE, "benchmark")

