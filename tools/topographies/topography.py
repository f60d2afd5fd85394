# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Makes a gap file (Obstacle/Gap file) of a measured surface, or of a rough surface that is made of a spectrum and a seed: reads
what profilometers write, cuts, levels, masks, fills and thins it out, and tells its spectrum and its roughness."""
import argparse
import dataclasses
import os
import pathlib
import re
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
sys.path.insert(1, str(pathlib.Path(__file__).resolve().parent.parent / "runs"))
import formats  # noqa: E402
import numpy as np  # noqa: E402
import roughness  # noqa: E402
import shaping  # noqa: E402
import spectrum  # noqa: E402
from run_folder import BadFile, one_line, write_whole  # noqa: E402
from surface import WrongSurface, length_of, unit_of  # noqa: E402
from text_grid import gap_text  # noqa: E402

WRONG_INPUT, NO_MEMORY, FILE_ERROR, INTERRUPTED = 2, 3, 4, 130
KINDS = (".png", ".svg")
OF_FILES = ("pixel", "unit", "heights")  # what a format may ask for
MEASURED = (*OF_FILES, "crop", "level", "outliers", "fill", "body")
MADE = ("hurst", "roll_off", "cut_off", "rms_height", "rms_slope", "size", "seed")
TILTED = 0.5  # of the rms height: what is left without the tilt is less, and the user hears of --level


class ArgumentParser(argparse.ArgumentParser):
    def error(self, message):
        self.exit(WRONG_INPUT, f"topography: {one_line(message)}; '--help' explains\n")


def worded(function):
    """As a type of argparse, which would not pass the words of a ValueError on."""
    def of_text(text):
        try:
            return function(text)
        except WrongSurface as problem:
            raise argparse.ArgumentTypeError(str(problem)) from problem
    return of_text


def lengths(*counts, least=-np.inf):
    """Of a text with commas: as many lengths (mm) as one of the counts, above `least`; of (1, 2), one stands for two."""
    def of_text(text):
        found = tuple(length_of(part) for part in text.split(","))
        if len(found) not in counts or not all(value > least for value in found):
            number = "is one length" if counts == (1,) else f"are {' or '.join(map(str, counts))} lengths, separated by commas"
            raise WrongSurface(f"'{text}': allowed {number}" + ("" if np.isinf(least) else f", > {least:g}"))
        return found * 2 if counts == (1, 2) and len(found) == 1 else found
    return worded(of_text)


def number(least, most, kind=float):
    """Of a text: a number within these bounds."""
    def of_text(text):
        try:
            value = kind(text)
        except ValueError:
            value = np.nan
        if not least <= value <= most:
            raise WrongSurface(f"'{text}': allowed is a {'whole ' if kind is int else ''}number from {least:g} to {most:g}")
        return value
    return worded(of_text)


@worded
def counts(text):
    """(nx, ny) of 'N' or 'NX,NY'."""
    found = text.split(",")
    if not all(part.strip().isdecimal() and 2 <= int(part[:9]) <= 20000 for part in found) or len(found) > 2:
        raise WrongSurface(f"'{text}': allowed are one or two whole numbers from 2 to 20000, separated by a comma")
    return (int(found[0]), int(found[-1]))


@worded
def picture_file(text):
    path = pathlib.Path(text)
    if path.suffix not in KINDS:
        raise WrongSurface(f"'{text}': allowed is a name that ends with {' or '.join(KINDS)}")
    return path


def new_parser():
    parser = ArgumentParser(prog="tools/topography", description=__doc__, epilog=(
        "Lengths are in mm, or have a unit behind them (0.5um, 20nm). Steps are taken in the order in which they stand here. Exit "
        "codes: 0 done; 2 wrong command line or surface; 3 out of memory; 4 a file could not be read or written."))
    add = parser.add_argument
    add("surface", nargs="?", type=pathlib.Path, metavar="SURFACE", help="measured surface: " + ", ".join(
        suffix for one in formats.FORMATS for suffix in one.suffixes))
    add("--pixel", type=lengths(1, 2, least=0), metavar="D[,DY]", help="spacing of the points of plain grids and images")
    add("--unit", type=worded(unit_of), metavar="UNIT", help="of the heights of plain grids (mm)")
    add("--heights", type=lengths(2), metavar="BLACK,WHITE", help="heights of black and white of images")
    add("--crop", type=lengths(4), metavar="X0,X1,Y0,Y1", help="keep this part; the middle of the surface is at 0, 0")
    add("--level", choices=list(shaping.DEGREES), help="take off the mean, or the nearest plane or polynomial of degree 2")
    add("--outliers", type=number(1, 1000), metavar="K", help="drop points further than K standard deviations from that")
    add("--fill", action="store_true", help="fill missing points smoothly from their neighbours")
    add("--points", type=counts, metavar="NX[,NY]", help="thin out to so many points; with --make: points of a period (256)")
    add("--body", action="store_true", help="it is the surface of the body, which lies upside down: x becomes -x")
    add("--centre", type=lengths(2), metavar="X,Y", help="place of its middle (0,0; a gap file stays)")
    add("--make", action="store_true", help="make a rough, periodic surface in place of reading one")
    add("--size", type=lengths(1, 2, least=0), metavar="LX[,LY]", help="of a period")
    add("--hurst", type=number(0, 1), metavar="H", help="Hurst exponent: the spectrum falls with q^(-2(1+H)) (0.8)")
    add("--roll-off", type=lengths(1, least=0), metavar="L", help="wavelength from which on the spectrum is constant (the size)")
    add("--cut-off", type=lengths(1, least=0), metavar="L", help="shortest wavelength (four spacings)")
    add("--rms-height", type=lengths(1, least=1e-12), metavar="SQ", help="root mean square height, or else")
    add("--rms-slope", type=number(1e-12, 1e3), metavar="SDQ", help="root mean square slope")
    add("--seed", type=number(0, 2**63, int), metavar="N", help="another one makes another surface (1)")
    add("--datum", choices=("highest", "mean", "zero"), help="height whose gap is 0 (highest)")
    add("--gap", type=pathlib.Path, metavar="FILE", help="write the gap file")
    add("--spectrum", type=pathlib.Path, metavar="FILE.csv", help="write the radial power spectral density")
    add("--picture", type=picture_file, metavar="FILE", help="draw heights, spectrum and distribution as .png or .svg")
    return parser


def joined(words):
    """A value that begins with a minus, such as -1,1,-1,1, is glued to its option: argparse would take it for one."""
    found = []
    for word in words:
        if found and re.match(r"-[.\d]", word) and found[-1].startswith("--"):
            found[-1] += f"={word}"
        else:
            found.append(word)
    return found


def arguments():
    parser = new_parser()
    given = parser.parse_args(joined(sys.argv[1:]))
    if bool(given.surface) == given.make:
        parser.error("allowed is a SURFACE, or --make in place of it")
    for name in MEASURED if given.make else MADE:
        if getattr(given, name) is not None and getattr(given, name) is not False:
            parser.error(f"--{name.replace('_', '-')} is for a surface that is {'measured' if given.make else 'made'}; leave it out")
    if given.make and (not given.size or bool(given.rms_height) == bool(given.rms_slope)):
        parser.error("--make: allowed with --size LX,LY and one of --rms-height SQ and --rms-slope SDQ")
    if given.datum and not given.gap:
        parser.error("--datum is for the gap file; allowed with --gap FILE")
    outputs = [path for path in (given.gap, given.spectrum, given.picture) if path]
    for i, path in enumerate(outputs):
        others = [given.surface, *outputs[:i]]
        if any(other and (path == other or (path.exists() and other.exists() and os.path.samefile(path, other))) for other in others):
            parser.error(f"{path}: is another file of this command, and stays as it is; name a new one")
    return given


def made(given):
    points = given.points or (256, 256)
    four = 4 * max(size / n for size, n in zip(given.size, points))
    roll_off, cut_off = ((given.roll_off or (min(given.size),))[0], (given.cut_off or (four,))[0])
    hurst, seed = (0.8 if given.hurst is None else given.hurst), (1 if given.seed is None else given.seed)
    surface = spectrum.self_affine(points, given.size, hurst, roll_off, cut_off, seed)
    if given.rms_height:
        return surface.with_heights(surface.heights * (given.rms_height[0] / np.sqrt(np.mean(surface.heights**2))))
    # The slope is linear in the heights, whatever its size: small heights are safe from rounding, too.
    return surface.with_heights(surface.heights * (given.rms_slope / roughness.slopes(surface)[0]))


def measured(given):
    surface = formats.read(given.surface, {name: getattr(given, name) for name in OF_FILES if getattr(given, name) is not None})
    try:
        if given.crop:
            surface = shaping.cropped(surface, *given.crop)
        if given.level:
            surface = shaping.levelled(surface, shaping.DEGREES[given.level], given.outliers)
        elif given.outliers:
            surface = shaping.masked(surface, given.outliers)
        surface = shaping.filled(surface) if given.fill else surface
        surface = shaping.resampled(surface, *given.points) if given.points else surface
        return shaping.turned_over(surface) if given.body else surface
    except WrongSurface as problem:
        raise WrongSurface(f"{given.surface}: {problem}") from problem


def facts(surface, name, values):
    """The lines of the short table."""
    ny, nx = surface.heights.shape
    yield (f"{name}: {nx} x {ny} points every {surface.dx:.4g} x {surface.dy:.4g} mm from {surface.x0:.6g}, {surface.y0:.6g} mm on, "
           f"{surface.size[0]:.4g} x {surface.size[1]:.4g} mm" + (", periodic" if surface.periodic else "")
           + (f"; missing points: {surface.n_missing}" if surface.n_missing else ""))
    for key, (unit, meaning) in roughness.NUMBERS.items():
        factor = {"um": 1e3, "%": 100}.get(unit, 1)
        text = f"{factor * values[key]:.5g}" if np.isfinite(values[key]) else "-"
        yield f"{key:4} {text:>12} {unit:3} {meaning}"


def tilt_words(surface, values):
    rest = shaping.levelled(surface, 1).heights
    if np.sqrt(np.nanmean(rest**2)) < TILTED * values["Sq"]:
        yield "most of Sq is a tilt of the whole surface: --level plane takes it off\n"


def save_picture(path, *drawn):
    if path.exists() and not path.is_file():
        raise BadFile(f"{path}: is no ordinary file, and stays as it is")
    import topography_picture  # not at the top: Matplotlib takes a second
    topography_picture.draw(*drawn).savefig(path, dpi=150, metadata={"Date": None} if path.suffix == ".svg" else None)


def look(given):
    name = one_line(given.surface.name if given.surface else f"made with the seed {1 if given.seed is None else given.seed}")
    surface = made(given) if given.make else measured(given)
    if given.centre:
        x, y = (middle - size / 2 for middle, size in zip(given.centre, surface.size))
        surface = dataclasses.replace(surface, x0=x, y0=y)
    gaps = gap_text(surface, given.datum or "highest", name) if given.gap else None  # refused before anything is said
    values = roughness.numbers(surface)
    print(*facts(surface, name, values), sep="\n")
    if not given.make and not given.level:
        print(*tilt_words(surface, values), sep="\n", end="")
    rings = spectrum.radial_spectrum(shaping.filled(surface)) if given.spectrum or given.picture else None
    if given.gap:
        write_whole(given.gap, gaps)
        print(f"{one_line(given.gap)}: the gap file")
    if given.spectrum:
        write_whole(given.spectrum, "q_1_per_mm,wavelength_mm,density_mm4,area_1_per_mm2\n" + "".join(
            f"{q:.9g},{2 * np.pi / q:.9g},{density:.9g},{area:.9g}\n" for q, density, area in zip(rings.q, rings.density, rings.area)))
        print(f"{one_line(given.spectrum)}: the spectrum")
    if given.picture:
        save_picture(given.picture, name, surface, rings, values)
        print(f"{one_line(given.picture)}: the picture")


def main():
    given = arguments()
    sys.stdout.reconfigure(errors="surrogateescape")  # names of files need not be text
    try:
        look(given)
    except (WrongSurface, BadFile, OSError, MemoryError, KeyboardInterrupt) as problem:
        words, code = next((words, code) for kind, words, code in (
            (WrongSurface, problem, WRONG_INPUT), (MemoryError, "memory ran out: thin the surface out", NO_MEMORY),
            (KeyboardInterrupt, "interrupted", INTERRUPTED), (Exception, problem, FILE_ERROR)) if isinstance(problem, kind))
        print(f"topography: {one_line(words)}", file=sys.stderr)
        sys.exit(code)


if __name__ == "__main__":
    main()
