#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""A parameter study: see tools/sweep."""
import argparse
import hashlib
import itertools
import json
import math
import os
import pathlib
import re
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
import sweep_page  # noqa: E402
import sweep_runs  # noqa: E402
from run_folder import BadFile, content_of, object_of, one_line, write_whole  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
MOST_RUNS, MOST_JOBS = 100000, 400
MOST_BYTES_OF_NAME, MOST_BYTES_OF_PATH = 255, 4000  # of a run's folder, and of the study's: Linux takes no more
MOST_FILES = 1000  # that a scene includes or names: the program takes no more
FILE_ENTRIES = ("Obstacle/Gap file", "Geometry/Mesh file", "Lower geometry/Mesh file")


class WrongInput(Exception):
    """One line for the user."""


def values_of(text):
    """The values, as the words that files have, of "0.1:0.5:9" or "0.1, 0.3, coarse"."""
    parts = text.split(":")
    if len(parts) == 3:
        try:
            first, last, number = float(parts[0]), float(parts[1]), int(parts[2])
        except ValueError:
            number = 0
        if not 2 <= number <= MOST_RUNS or not math.isfinite(first) or not math.isfinite(last - first):
            raise WrongInput(f"--vary: '{text}': allowed is FIRST:LAST:NUMBER with two numbers and a count from 2 to "
                             f"{MOST_RUNS}, or words separated by commas")
        return [f"{first + (last - first) * i / (number - 1):.10g}" for i in range(number)]
    words = [word.strip() for word in text.split(",")]
    if not all(words) or len(set(words)) < len(words):
        raise WrongInput(f"--vary: '{text}': allowed are words separated by commas, each of them once")
    return words


def grid_of(variables):
    """[(name, values), ...] of the words NAME=VALUES."""
    grid = []
    for words in variables:
        name, equals, values = words.partition("=")
        name = name.strip()
        if not equals or not name or name in dict(grid):
            raise WrongInput(f"--vary: '{words}': allowed is NAME=VALUES, each name once")
        grid.append((name, values_of(values)))
    return grid


def settings_of(point, templates):
    """What --set gets at a point {name: value}: the templates with its values in their places, and entries it names."""
    def filled(text):
        for name, value in point.items():
            text = text.replace("{" + name + "}", value)
        return text

    settings = [filled(text) for text in templates]
    return settings + [f"{name}={value}" for name, value in point.items() if "/" in name]


def texts_of(scene):
    """The bytes of a parameter file, and of all that it includes or names, each once. The program says what is wrong with
    includes that lead to themselves, too deep, or to too many files."""
    seen, waiting, texts = set(), [scene], []
    while waiting and len(seen) < MOST_FILES:
        path = waiting.pop(0)
        if path.resolve() in seen:
            continue
        seen.add(path.resolve())
        texts.append(content_of(path))
        for line in texts[-1].decode("utf-8", "surrogateescape").splitlines():
            match = re.match(r"\s*(?:include\s+|set\s+(?:Gap|Mesh) file\s*=\s*)(\S.*?)\s*(?:#.*)?$", line)
            if match and (other := path.parent / match[1]).is_file():
                waiting.append(other)
    return texts


def other_files_of(options, points):
    """The files with gaps and meshes that a JSON file, --set or --vary name."""
    settings = {setting for point in points for setting in settings_of(point, options.set)}
    files = {pathlib.Path(setting.partition("=")[2].strip()) for setting in settings
             if setting.partition("=")[0].strip() in FILE_ENTRIES}
    if options.file.suffix == ".json":
        for section, entry in (name.split("/") for name in FILE_ENTRIES):
            try:
                files.add(options.file.parent / object_of(options.file)[section][entry])
            except (ValueError, KeyError, TypeError):
                pass  # it names none, or the program says what is wrong with it
    return sorted(file for file in files if file.is_file())


def checksum_of(options, points):
    """Of all that the runs read."""
    texts = texts_of(options.file) + [content_of(file) for file in other_files_of(options, points)]
    return hashlib.sha256(b"\0".join(texts)).hexdigest()


def check_use(grid, templates):
    """Every name must stand somewhere, every brace must be of a name, and no name may be one of a column."""
    for name, _ in grid:
        if name in sweep_runs.OWN_COLUMNS:
            raise WrongInput(f"--vary: {name} is a column of the table: allowed is another name")
        if "/" not in name and not any("{" + name + "}" in text for text in templates):
            raise WrongInput(f"--vary: {name} stands in no --set: allowed is a name that stands there as {{{name}}}, or an "
                             "entry such as 'Material/Poisson ratio'")
    names = {name for name, _ in grid}
    for text in templates:
        for name in re.findall(r"{([^{}]*)}", text):
            if name not in names:
                raise WrongInput(f"--set: '{text}': {{{name}}} is not varied; allowed are {', '.join(sorted(names))}")


def folder_name(point):
    """Such as "mu=0.1,Poisson ratio=0.3", without what a name of a folder cannot have."""
    words = ",".join(f"{name.rpartition('/')[2]}={value}" for name, value in point.items())
    return re.sub(r"[^\w.,=+ -]", "_", words)


class ArgumentParser(argparse.ArgumentParser):
    def error(self, message):
        raise WrongInput(f"{message}; '--help' explains")


def parse(arguments):
    for word in arguments:
        if any("\ud800" <= letter <= "\udfff" for letter in word):  # bytes that Python could not decode
            raise WrongInput(f"'{word}' is no UTF-8: allowed are words and names of files that are text, because the table "
                             "and the page name them")
    parser = ArgumentParser(prog="tools/sweep", description="A parameter study.")
    parser.add_argument("file", type=pathlib.Path, metavar="FILE.prm")
    parser.add_argument("--vary", action="append", required=True, metavar="NAME=VALUES",
                        help="FIRST:LAST:NUMBER, or words separated by commas; may be repeated: a grid")
    parser.add_argument("--set", action="append", default=[], metavar="Section/Entry=TEXT",
                        help="of every run; {NAME} in it is the value of the point")
    parser.add_argument("--output", "-o", type=pathlib.Path, help="folder (default: output/sweep-FILE)")
    parser.add_argument("--jobs", "-j", type=int, default=len(os.sched_getaffinity(0)), help="runs at a time")
    parser.add_argument("--fields", action="store_true", help="write the field files that FILE asks for")
    parser.add_argument("--anew", action="store_true", help="run complete points again")
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/orthocone", help=argparse.SUPPRESS)
    return parser.parse_args(arguments)


def earlier_study(path, study):
    """What sweep.json says of the runs in its folder. It may be damaged, or somebody else's."""
    remedy = "the scene of the runs beside it is unknown; remove it with them, or --output DIR takes another folder"
    try:
        earlier = object_of(path)
    except BadFile as error:
        raise WrongInput(f"{error}; {remedy}") from error
    if {key: type(value) for key, value in earlier.items()} != {key: type(value) for key, value in study.items()} or \
            not all(isinstance(text, str) for text in earlier["set"]):
        raise WrongInput(f"{path}: is damaged; {remedy}")
    return earlier


def require_same_study(folder, study, anew):
    """A folder holds one study: runs of others would stand in its table. With --anew no old run stays in it."""
    path = folder / "sweep.json"
    if path.exists():
        earlier = earlier_study(path, study)
        if anew:
            earlier["checksum"] = study["checksum"]
        if earlier != study:
            same = earlier | {"checksum": study["checksum"]} == study
            what = f"of {study['file']} as it was before it changed" if same else \
                f"of other runs ({earlier['file']}, {'; '.join(earlier['set']) or 'no --set'})"
            raise WrongInput(f"{folder}: holds a study {what}; --output DIR takes another folder")
    elif folder.exists() and any(folder.iterdir()):
        raise WrongInput(f"{folder}: is not empty, and holds no study; --output DIR takes another folder")
    folder.mkdir(parents=True, exist_ok=True)
    write_whole(path, json.dumps(study, indent=2) + "\n")


def study_of(options, kind_of_run=sweep_runs.Run):
    """The grid of a study, the folder that is its own, and its runs. Raises WrongInput."""
    grid = grid_of(options.vary)
    check_use(grid, options.set)
    content_of(options.file)  # an error if it cannot be read
    if not 1 <= options.jobs <= MOST_JOBS:
        raise WrongInput(f"--jobs = {options.jobs}: allowed is a whole number from 1 to {MOST_JOBS}")
    if not os.access(options.program, os.X_OK) or options.program.is_dir():
        raise WrongInput(f"{options.program}: is no program; build it first")
    names = [name for name, _ in grid]
    if (n_points := math.prod(len(values) for _, values in grid)) > MOST_RUNS:
        raise WrongInput(f"--vary: makes {n_points} runs: allowed are {MOST_RUNS}")
    points = [dict(zip(names, values)) for values in itertools.product(*(values for _, values in grid))]
    folders = [folder_name(point) for point in points]
    if len(set(folders)) < len(points):
        raise WrongInput(f"--vary: makes {len(points)} runs, but they have only {len(set(folders))} different names: "
                         "allowed are runs that all have different ones")
    if (longest := max(len(name.encode()) for name in folders)) > MOST_BYTES_OF_NAME:
        raise WrongInput(f"--vary: makes names of folders of {longest} bytes: allowed are {MOST_BYTES_OF_NAME}; vary a short "
                         "NAME that stands in --set for a long one")
    output = options.output or pathlib.Path("output") / f"sweep-{options.file.stem}"
    if len(str(output).encode()) > MOST_BYTES_OF_PATH or len(output.parts) > MOST_BYTES_OF_PATH // 20:
        raise WrongInput(f"--output: the name has {len(str(output).encode())} bytes and {len(output.parts)} parts: allowed are "
                         f"{MOST_BYTES_OF_PATH} and {MOST_BYTES_OF_PATH // 20}")
    fixed = [] if options.fields else ["Output/Contact fields=0", "Output/Volume fields=0"]
    require_same_study(output, {"file": str(options.file.resolve()), "set": options.set, "names": names,
                                "fields": options.fields,
                                "checksum": checksum_of(options, points)}, options.anew)
    runs = [kind_of_run(point, output / "runs" / name, [*fixed, *settings_of(point, options.set)])
            for point, name in zip(points, folders)]
    return grid, output, runs


def run_study(options):
    grid, output, runs = study_of(options)
    sweep_runs.run_all(runs, options)
    rows = sweep_runs.write_table(runs, output / "sweep.csv")
    sweep_page.write_page(output / "sweep.html", options.file, options.set, grid, rows)
    failed = [run for run in runs if run.exit != 0]
    print(f"{len(runs)} points, {len(failed)} of them not complete; {output / 'sweep.csv'}, {output / 'sweep.html'}")
    if options.is_interrupted:
        return 130
    return 3 if failed else 0


def main():
    sys.stdout.reconfigure(errors="backslashreplace")  # a terminal need not have all letters of a name
    try:
        return run_study(parse(sys.argv[1:]))
    except (WrongInput, BadFile) as error:
        print(f"sweep: {one_line(error)}", file=sys.stderr)
        return 2
    except OSError as error:
        print(f"sweep: {one_line(error)}", file=sys.stderr)
        return 4


if __name__ == "__main__":
    sys.exit(main())
