# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Looks at a table of measured friction (Friction/Rosette): whether it is well posed and where it is not, its picture, the
nearest table that is well posed, and the ellipses that come nearest to it."""
import argparse
import os
import pathlib
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
sys.path.insert(1, str(pathlib.Path(__file__).resolve().parent.parent / "runs"))
import nearest as nearest_table  # noqa: E402
import numpy as np  # noqa: E402
import rosette_file  # noqa: E402
from best_ellipses import best_ellipses  # noqa: E402
from rosette_curve import Curve  # noqa: E402
from rosette_law import RosetteError  # noqa: E402
from run_folder import BadFile, one_line, write_whole  # noqa: E402

WRONG_INPUT, UNSOLVED, FILE_ERROR = 2, 3, 4
KINDS = (".png", ".svg")
MOST_RATIO = 1000  # beyond, rows of a few digits do not tell whether friction is associated


class ArgumentParser(argparse.ArgumentParser):
    def error(self, message):
        self.exit(WRONG_INPUT, f"rosette: {one_line(message)}; '--help' explains\n")


def arguments():
    parser = ArgumentParser(
        prog="tools/rosette", description=__doc__,
        epilog="A table is well posed, and the program takes it, where friction opposes slip (mu_along > 0), one push has one "
               "slip (kappa = mu_along + d mu_across/da > 0) and one force has one direction of slip (d b/da > 0, b the angle "
               "of the force). Exit codes: 0 done; 2 wrong command line or no table; 3 no such nearest table was found; 4 a "
               "file could not be read or written.")
    parser.add_argument("file", metavar="FILE", type=pathlib.Path,
                        help="lines 'angle mu_along mu_across' (degrees, 1, 1), comments behind #")
    parser.add_argument("--picture", metavar="OUT", type=pathlib.Path, help="draw the table as .png or .svg")
    parser.add_argument("--nearest", metavar="OUT", type=pathlib.Path,
                        help="write the nearest table that is well posed: the least change of the rows, by least squares")
    parser.add_argument("--margin", metavar="SHARE", type=float, default=nearest_table.MARGIN,
                        help="with --nearest: what the conditions keep along the lines from row to row, as a share of isotropic "
                             f"friction ({nearest_table.MARGIN:g})")
    parser.add_argument("--table", metavar="N", type=int, default=0,
                        help="of a file with several tables: which one, counted from 0 (0)")
    parser.add_argument("--ellipses", action="store_true", help="find the ellipses of friction and slip that come nearest")
    given = parser.parse_args()
    if given.picture and given.picture.suffix not in KINDS:
        parser.error(f"--picture {given.picture}: allowed are names that end with .png or .svg")
    if not 0 < given.margin <= 0.5:
        parser.error(f"--margin {given.margin:g}: allowed is a number from 0 to 0.5, and not 0")
    outputs = [path for path in (given.picture, given.nearest) if path]
    for path in outputs:
        if os.path.exists(path) and os.path.exists(given.file) and os.path.samefile(path, given.file):
            parser.error(f"{path}: is FILE itself, and stays as it is")
    return given


def line(name, values, angles, form="{:.4g}"):
    low, high = np.argmin(values), np.argmax(values)
    is_constant = values[high] - values[low] < 1e-9
    places = ["all" if is_constant else f"{np.degrees(angles[row]):.4g}" for row in (low, high)]
    numbers = (form.format(values[low]), places[0], form.format(values[high]), places[1])
    return f"{name:38}" + "".join(f"{number:>11}" for number in numbers)


def facts(curve):
    """The short table: least and largest values, and where."""
    head = f"{'':38}" + "".join(f"{word:>11}" for word in ("least", "at degrees", "largest", "at degrees"))
    rows = (("mu_along", curve.along), ("mu_across", curve.across), ("size of the force", curve.size),
            ("kappa = mu_along + d mu_across/da", curve.kappa), ("turn of the force, d b/da", curve.turning))
    lines = [head, *(line(name, values, curve.angles) for name, values in rows)]
    departures = curve.departures()
    lines.append(line("from the curve's normal to e, degrees", np.degrees(departures), curve.angles, "{:.1f}"))
    largest, angle = curve.to_and_fro()
    differs = f"differs by up to {largest:.4g}, at {np.degrees(angle):.4g} degrees" if largest > 1e-4 * curve.mean else "is the same"
    lines.append(f"mean size of the force {curve.mean:.4g}; to and fro mu_along {differs}")
    if not curve.refusal:
        ratio = 1 / max(np.tan(np.abs(departures).max() / 2), 1e-9)**2
        lines.append("a push on a node has one slip if the stiffnesses of its springs differ by a factor "
                     + ("of any size" if ratio > MOST_RATIO else f"below {ratio:.3g}"))
    return lines


def verdict(curve):
    table = curve.table
    steps = np.degrees(table.steps)
    even = np.allclose(steps, steps[0], atol=1e-6)
    said = f"{len(table)} rows, " + (f"every {steps[0]:.4g} degrees" if even else f"{steps.min():.4g} to {steps.max():.4g} degrees apart")
    if not curve.refusal:
        return f"{said}: well posed, and the program takes it"
    return f"{said}: the program refuses it, because {curve.refusal.partition(': allowed')[0]}"


def ellipse_words(found, mean):
    return ["the best ellipses, for a section Friction:",
            f"  set Coefficients     = {found.mu[0]:.5g}, {found.mu[1]:.5g}",
            f"  set Slip potential   = {found.p[0]:.5g}, {found.p[1]:.5g}",
            f"  set Orthotropy angle = {np.degrees(found.turn):.4g}",
            f"  their forces miss those of the rows by {found.rms:.3g} (rms) and {found.largest:.3g} (largest), which is "
            f"{100 * found.rms / mean:.2g} % and {100 * found.largest / mean:.2g} % of the mean"]


def nearest_words(table, found, path):
    changes = {"mu_along": found.along - table.along, "mu_across": found.across - table.across}
    name = max(changes, key=lambda key: np.abs(changes[key]).max())
    row = np.argmax(np.abs(changes[name]))
    if not any(change.any() for change in changes.values()):
        return f"{path}: the same rows, because they are well posed"
    both = np.concatenate(list(changes.values()))
    return (f"{path}: the nearest table that is well posed; the largest change is {changes[name][row]:+.3g} of {name} at "
            f"{np.degrees(table.angles[row]):.4g} degrees, and the rms {np.sqrt((both**2).mean()):.2g}")


def save_picture(figure, path):
    if path.exists() and not path.is_file():
        raise BadFile(f"{path}: is no ordinary file, and stays as it is")
    figure.savefig(path, dpi=150, metadata={"Date": None} if path.suffix == ".svg" else None)


def chosen_table(given, tables):
    if not 0 <= given.table < len(tables):
        raise RosetteError(f"--table {given.table}: allowed are " + (f"0 to {len(tables) - 1}" if len(tables) > 1 else "0, the only table"))
    return tables[given.table]


def write_nearest(given, tables):
    """Writes the file with the nearest one in place of the chosen table, which is returned."""
    table = tables[given.table]
    found = nearest_table.nearest(table, given.margin)
    head = f"the nearest table to {one_line(given.file.name)} that is well posed"
    write_whole(given.nearest, rosette_file.text_for([*tables[:given.table], found, *tables[given.table + 1:]], head))
    return found


def look(given):
    tables = rosette_file.read(given.file)
    table = chosen_table(given, tables)
    curve = Curve(table)
    of_several = f" (table {given.table} of {len(tables)})" if len(tables) > 1 else ""
    print(f"{given.file}{of_several}: {verdict(curve)}")
    print(*facts(curve), sep="\n")
    found = write_nearest(given, tables) if given.nearest else None
    ellipses = best_ellipses(table) if given.ellipses else None
    if ellipses:
        print(*ellipse_words(ellipses, curve.mean), sep="\n")
    if found:
        print(nearest_words(table, found, given.nearest))
    elif curve.refusal:
        print("--nearest OUT.txt writes the nearest table that is well posed")
    if given.picture:
        import rosette_picture  # not at the top: Matplotlib takes a second
        title = f"{given.file.name}{of_several}: " + ("well posed" if not curve.refusal else "not well posed")
        save_picture(rosette_picture.draw(curve, title, found if found is not table else None, ellipses), given.picture)
        print(f"{given.picture}: the picture")


def main():
    given = arguments()
    sys.stdout.reconfigure(errors="surrogateescape")  # names of files need not be text
    try:
        look(given)
    except (RosetteError, nearest_table.NoTable) as problem:
        print(f"rosette: {one_line(f'{given.file}: {problem}')}", file=sys.stderr)
        sys.exit(UNSOLVED if isinstance(problem, nearest_table.NoTable) else WRONG_INPUT)
    except (OSError, BadFile) as problem:
        print(f"rosette: {one_line(problem)}", file=sys.stderr)
        sys.exit(FILE_ERROR)


if __name__ == "__main__":
    main()
