#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""A fretting map: regimes and dissipated energy of a scene over two quantities. See tools/fretting_map."""
import csv
import io
import math
import os
import pathlib
import re
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
import map_axes  # noqa: E402
import map_points  # noqa: E402
import sweep  # noqa: E402
import sweep_runs  # noqa: E402
from run_folder import BadFile, one_line, write_whole  # noqa: E402
from sweep import WrongInput  # noqa: E402

DONE, NOT_COMPLETE, FILE_ERROR, WRONG, INTERRUPTED = 0, 3, 4, 2, 130
LETTERS = dict(zip(map_points.REGIMES, ".pG")) | {"": "?"}
FATIGUE = ("swt", "fatemi_socie", "findley", "crossland", "dang_van", "ruiz_energy", "ruiz_tension")


def points_of(text):
    """(NX, NY) of "NXxNY"."""
    match = re.fullmatch(r"(\d{1,5})x(\d{1,5})", text)
    points = tuple(map(int, match.groups())) if match else (0, 0)
    if min(points) < 2:
        raise WrongInput(f"--points = {text}: allowed are two counts from 2 on, such as 20x10")
    return points


def parse(arguments):
    for word in arguments:
        if any("\ud800" <= letter <= "\udfff" for letter in word):  # bytes that Python could not decode
            raise WrongInput(f"'{word}' is no UTF-8: allowed are words and names of files that are text")
    parser = sweep.ArgumentParser(prog="tools/fretting_map", description=__doc__)
    parser.add_argument("file", type=pathlib.Path, metavar="FILE.prm")
    parser.add_argument("--x", default="normal", metavar="NAME[UNIT]=VALUES",
                        help="FIRST:LAST:NUMBER, or words separated by commas (the normal load of FILE and values around it)")
    parser.add_argument("--y", default="tangential", metavar="NAME[UNIT]=VALUES",
                        help="the same across (the tangential amplitude of FILE and values around it)")
    parser.add_argument("--set", action="append", default=[], metavar="Section/Entry=TEXT",
                        help="of every run; {NAME} in it is the value of the point")
    parser.add_argument("--points", default="20x10", metavar="NXxNY", help="of axes without VALUES (20x10)")
    parser.add_argument("--stick-share", type=float, default=0.9, metavar="SHARE",
                        help="of the area in contact that sticks throughout the cycle in the regime of stick (0.9)")
    parser.add_argument("--fatigue", choices=FATIGUE, help="also the worst value of this parameter; each run then keeps its fields")
    parser.add_argument("--material", type=pathlib.Path, metavar="FILE.json", help="constants of fatigue, as for tools/fatigue")
    parser.add_argument("--picture", type=pathlib.Path, help="name of the picture, .png or .svg (map.png in the folder)")
    parser.add_argument("--output", "-o", type=pathlib.Path, help="folder (output/map-FILE)")
    parser.add_argument("--jobs", "-j", type=int, default=len(os.sched_getaffinity(0)), help="runs at a time")
    parser.add_argument("--anew", action="store_true", help="run complete points again")
    parser.add_argument("--program", type=pathlib.Path, default=sweep.ROOT / "build/orthocone", help=sweep.argparse.SUPPRESS)
    given = parser.parse_args(arguments)
    if given.picture and given.picture.suffix not in (".png", ".svg"):
        raise WrongInput(f"--picture {given.picture}: allowed are names that end with .png or .svg")
    if not 0 < given.stick_share <= 1:
        raise WrongInput(f"--stick-share = {given.stick_share:g}: allowed is a number > 0 and <= 1")
    if given.material and not given.fatigue:
        raise WrongInput(f"--material {given.material} does nothing without --fatigue: allowed is one of {', '.join(FATIGUE)}")
    if given.material:
        map_points.check_constants(given.material)
    return given


def study_of(given):
    """The options of tools/sweep for the runs of the map, and its axes."""
    axes = map_axes.axes_of(given.file, given.set, given.x, given.y, points_of(given.points))
    for axis in axes:
        if axis.name in {*map_points.COLUMNS, given.fatigue}:
            raise WrongInput(f"{axis.name} is a column of the map: allowed is another name")
    given.vary = [axis.words for axis in axes]
    given.set = given.set + [axis.template for axis in axes if axis.template]
    given.fields = bool(given.fatigue)
    if given.fields:
        given.set += ["Output/Contact fields=1", "Output/Volume fields=1"]
    given.output = given.output or pathlib.Path("output") / f"map-{given.file.stem}"
    return given, axes


def write_table(path, rows):
    text = io.StringIO(newline="")
    writer = csv.DictWriter(text, rows[0].keys())
    writer.writeheader()
    writer.writerows(rows)
    write_whole(path, text.getvalue())


def span_of(rows, column):
    """Its least and largest finite value, in words."""
    rounding = 1e-12
    values = [row[column] if abs(row[column]) > rounding else 0 for row in rows if math.isfinite(row[column])]
    return f"{min(values):.3g} to {max(values):.3g}" if values else "unknown"


def printed(rows, axes, values):
    """Lines of a short table: a letter a point, and ranges."""
    regimes = {(row[axes[0].name], row[axes[1].name]): row["regime"] for row in rows}
    wide = max(len(y) for y in values[1])
    yield f"{axes[1].label} over {axes[0].label}, {values[0][0]} to {values[0][-1]}:"
    for y in reversed(values[1]):
        yield f"  {y:>{wide}}  " + " ".join(LETTERS[regimes[x, y]] for x in values[0])
    counts = {regime: sum(row["regime"] == regime for row in rows) for regime in (*map_points.REGIMES, "")}
    yield ", ".join(f"{LETTERS[regime]} {regime or 'not solved'}: {n}" for regime, n in counts.items() if n)
    yield f"dissipation in the last cycle: {span_of(rows, 'dissipation')} N mm; slip ratio: {span_of(rows, 'slip_ratio')}"


def make_map(given):
    options, axes = study_of(given)
    grid, output, runs = sweep.study_of(options, map_points.PointRun)
    sweep_runs.run_all(runs, options)
    rows = [map_points.row_of(run, given) for run in runs]
    write_table(output / "map.csv", rows)
    picture = given.picture or output / "map.png"
    values = [words for _, words in grid]
    import map_picture  # not at the top: Matplotlib takes a second
    map_picture.draw(picture, f"{given.file.name}, {len(rows)} points", rows, axes, values)
    print(*printed(rows, axes, values), f"{output / 'map.csv'}, {picture}", sep="\n")
    if options.is_interrupted:
        return INTERRUPTED
    return NOT_COMPLETE if any(row["regime"] == "" for row in rows) else DONE


def main():
    sys.stdout.reconfigure(errors="backslashreplace")  # a terminal need not have all letters of a name
    try:
        return make_map(parse(sys.argv[1:]))
    except (WrongInput, BadFile) as error:
        print(f"fretting_map: {one_line(error)}", file=sys.stderr)
        return WRONG
    except OSError as error:
        print(f"fretting_map: {one_line(error)}", file=sys.stderr)
        return FILE_ERROR


if __name__ == "__main__":
    sys.exit(main())
