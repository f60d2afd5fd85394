# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The book of known answers: every row beside ours. Started by tools/verification."""
import argparse
import csv
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "studies")]

import paths  # noqa: E402, F401 (finds the modules of all studies)
import load_steps  # noqa: E402
from row import ROOT, ProgramError, Runs  # noqa: E402
from rows import CHAPTERS, ROWS  # noqa: E402


def parsed_options():
    parser = argparse.ArgumentParser(prog="tools/verification", description=__doc__)
    parser.add_argument("ids", nargs="*", metavar="ID", help="rows whose names begin so, such as hertz or torsion.0.9 (all)")
    parser.add_argument("--csv", action="store_true", help="print id, quantity, ours, reference, difference, bound as CSV")
    parser.add_argument("--list", action="store_true", help="print the rows with the commands of their scenes, and run nothing")
    parser.add_argument("--orders", action="store_true", help="also the orders of convergence, over three meshes")
    parser.add_argument("--docs", action="store_true", help="also refresh tables and chart of docs/verification.md")
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "output/verification", help="folder of the runs")
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/orthocone")
    options = parser.parse_args()
    if options.docs and (options.ids or options.csv or options.list):
        parser.error("--docs takes all rows: it stands alone, or beside --output and --program")
    options.orders = options.orders or options.docs
    unknown = [name for name in options.ids if not any(row.id.startswith(name) for row in ROWS)]
    if unknown:
        parser.error(f"no row begins with '{unknown[0]}': --list names them")
    return options


def shown(value):
    return f"{value:.7g}"


def percent(share):
    """Of a difference or a bound, with as many digits as it has."""
    return f"{100 * share:.2f} %" if abs(share) >= 5e-5 or share == 0 else f"{100 * share:.0e} %"


def difference(row, ours):
    share = row.difference(ours)
    return percent(share) if row.scale else ("+" if share >= 0 else "") + percent(share)


def table(rows, values, orders):
    """Of the page, in Markdown."""
    lines = ["| row | quantity | orthocone | known | difference | bound | order | source, and what theory leaves out |",
             "|---|---|--:|--:|--:|--:|--:|---|"]
    for row in rows:
        notes = "; ".join(filter(None, (row.source, row.limit, row.printed)))
        order = f"{orders[row.id]:.1f}" if row.id in orders else ""
        lines.append(f"| `{row.id}` | {row.quantity} | {shown(values[row.id])} | {shown(row.reference)} | "
                     f"{difference(row, values[row.id])} | {percent(row.bound)} | {order} | {notes} |")
    return "\n".join(lines) + "\n"


def print_row(row, ours, order):
    end = "" if row.passes(ours) else "  <-- beyond its bound"
    print(f"{row.id:22}{shown(ours):>13}{shown(row.reference):>13}{difference(row, ours):>11} of {percent(row.bound):8}"
          f"{order and f' order {order:.1f}':11} {row.quantity}{end}", flush=True)


def of_all(rows, runs, options):
    """Values and orders of the rows, {id: number}, as they are printed."""
    values, orders = {}, {}
    writer = csv.writer(sys.stdout) if options.csv else None
    if writer:
        writer.writerow(["id", "quantity", "ours", "reference", "difference", "bound"])
    for row in rows:
        values[row.id] = ours = row.measured(runs, row.scene)
        if options.orders and row.meshes:
            orders[row.id] = row.order_of(runs)
        if writer:
            writer.writerow([row.id, row.quantity, repr(ours), repr(float(row.reference)), f"{row.difference(ours):.3e}", row.bound])
        else:
            print_row(row, ours, orders.get(row.id, ""))
    return values, orders


def refresh_page(runs, values, orders):
    import docs_page  # here, for it needs matplotlib
    tables = {name: table(rows, values, orders) for name, rows in CHAPTERS.items()}
    docs_page.draw("verification", {"verification_steps": load_steps.chart}, runs, runs.folder, ROOT / "docs/images")
    docs_page.write_tables({**tables, "steps": load_steps.table(runs)}, ROOT / "docs/verification.md", "verification")


def main():
    options = parsed_options()
    rows = [row for row in ROWS if not options.ids or any(row.id.startswith(name) for name in options.ids)]
    if options.list:
        for row in rows:
            print(f"{row.id:22} {row.quantity}\n{'':22} {row.scene.command()}")
        return
    runs = Runs(options.program, options.output)
    try:
        values, orders = of_all(rows, runs, options)
        if options.docs:
            refresh_page(runs, values, orders)
    except ProgramError as error:
        sys.exit(f"verification: {error}")
    failed = [row.id for row in rows if not row.passes(values[row.id])]
    if failed:
        sys.exit(f"verification: {len(failed)} of {len(rows)} rows are beyond their bounds: {', '.join(failed)}")
    if not options.csv:
        print(f"verification: {len(rows)} rows are within their bounds")


if __name__ == "__main__":
    main()
