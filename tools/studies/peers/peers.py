# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Peers side by side: the same problems and the same scenes by orthocone, Siconos, GetFEM and CalculiX. Started by
tools/study peers."""
import argparse
import dataclasses
import os
import pathlib
import random
import subprocess
import sys
import time

from paths import ROOT
from points import StudyError, write_rows
from benchmark_measure import processor
import bodies
import docs_page
import families
import forces
import problems
import profiles
import race
import scenes_race
import tables

OF_THE_ERROR_CHART = ("a-bricks/8", "fretting-c-fine/10", "random-1/4")
FCLIB = "fclib"
SICONOS_HEADERS = ("/usr/include/siconos/numerics", "/usr/include/siconos")
HDF5_HEADERS = "/usr/include/hdf5/serial"  # FCLIB's library needs them, too
BUILD = ROOT / "build"


def say(text):
    print(f"peers: {text}", flush=True)


def parsed_options():
    parser = argparse.ArgumentParser(prog="tools/study peers", description=__doc__)
    parser.add_argument("--only", choices=("problems", "scenes"), help="one of the two parts (both)")
    parser.add_argument("--families", metavar="NAME,NAME", help=f"some of {', '.join((*families.NAMES, FCLIB))} (all)")
    parser.add_argument("--problems", metavar="DIR", type=pathlib.Path,
                        help=f"also the files *.hdf5 of FCLIB below this folder, as the family {FCLIB}")
    parser.add_argument("--list", action="store_true", help="print the problems with their commands, and stop")
    parser.add_argument("--docs", action="store_true", help="also refresh page, pictures and tables in docs/")
    parser.add_argument("--anew", action="store_true", help="compute also what is there already")
    parser.add_argument("--minutes", type=float, default=30, help="no new problem after this time (30); the same command goes on")
    parser.add_argument("--quick", action="store_true", help="few problems and steps: a test of this tool, not a study")
    parser.add_argument("--output", type=pathlib.Path, help="folder of the results (output/peers)")
    options = parser.parse_args()
    if options.output is None:
        options.output = ROOT / ("output/peers-quick" if options.quick else "output/peers")
    if options.docs and (options.quick or options.families):
        parser.error("--quick and --families measure nothing that belongs in --docs")
    names = (*families.NAMES, *([FCLIB] if options.problems else []))
    options.families = options.families.split(",") if options.families else names
    if unknown := set(options.families).difference(names):
        parser.error(f"--families {','.join(sorted(unknown))}: allowed are {', '.join(names)}")
    if options.problems and not options.problems.is_dir():
        parser.error(f"--problems {options.problems}: there is no such folder")
    return options


def compiled(sources, target, *words):
    """Compiles C files unless the result is newer."""
    if not target.exists() or any(target.stat().st_mtime < source.stat().st_mtime for source in sources):
        target.parent.mkdir(parents=True, exist_ok=True)
        result = subprocess.run(["cc", "-O2", "-o", target, *sources, *words], capture_output=True, text=True, check=False)
        if result.returncode:
            raise StudyError(f"{target.name} cannot be compiled:\n{result.stderr}")
    return target


def programs(folder):
    """Those of the race; without siconos_solve where there is no Siconos."""
    here = ROOT / "tools/studies/peers"
    judge, fclib = here / "fclib_problem.c", (f"-I{HDF5_HEADERS}", "-lfclib", "-lhdf5_serial", "-lm")
    found = {"orthocone": BUILD / "orthocone", "solve": BUILD / "orthocone-solve",
             "judge": compiled([here / "judge_forces.c", judge], folder / "judge_forces", *fclib),
             "clock": compiled([here / "cpu_clock.c"], folder / "cpu_clock.so", "-shared", "-fPIC")}
    if any((pathlib.Path(path) / "fc3d_Solvers.h").exists() for path in SICONOS_HEADERS):
        headers = (f"-I{path}" for path in SICONOS_HEADERS)
        found["siconos"] = compiled([here / "siconos_solve.c", judge], folder / "siconos_solve", *headers,
                                    "-lsiconos_numerics", *fclib)
    else:
        say("no Siconos here (Debian's libsiconos-numerics-dev): our methods race alone")
    return found


def raced(options, tools, found):
    """Rows of all problems."""
    prints = race.Fingerprints(tools)
    answers = race.Answers(options.output / "answers.csv", {problem.name: prints.of(problem) for problem in found},
                           options.anew)
    names = set(answers.missing())
    missing = [problem for problem in found if problem.name in names]
    random.Random(0).shuffle(missing)  # so that what is there of an interrupted run is a sample of them all
    say(f"{len(found)} problems, of which {len(missing)} are to be solved")
    racer, begin = race.Racer(tools, options.output), time.monotonic()
    for count, problem in enumerate(missing, 1):
        if time.monotonic() - begin > 60 * options.minutes:
            say(f"the time is up: {len(missing) - count + 1} problems are left out; the same command goes on")
            break
        answers.add(racer.race(problem, 1 if options.quick else race.ROUNDS))
        if count % 10 == 0 or count == len(missing):
            say(f"{len(found) - len(missing) + count} of {len(found)} problems, {time.monotonic() - begin:.0f} s")
    return list(race.within_limits(answers.asked_for()))


def raced_errors(options, tools, found):
    """Rows of some problems with other bounds of the error."""
    points = {f"{problem.name} to {bound:g}": (problem, bound) for bound in race.BOUNDS for name in OF_THE_ERROR_CHART
              for problem in found if problem.name == name}
    prints = race.Fingerprints(tools)
    answers = race.Answers(options.output / "errors.csv", {key: prints.of(problem) for key, (problem, _) in points.items()},
                           options.anew)
    for key in answers.missing():
        problem, bound = points[key]
        answers.add(race.Racer(tools, options.output, bound).race(dataclasses.replace(problem, name=key), 1))
    return answers.asked_for()


def raced_forces(options, tools, found, rows):
    """Rows of Siconos with a bound that is a thousand times tighter, of the problems of which it finds the forces only nearly."""
    prints, nearly = race.Fingerprints(tools), forces.nearly(rows)
    asked = {problem.name: problem for problem in found if problem.name in nearly}
    answers = race.Answers(options.output / "forces.csv", {name: prints.of(asked[name]) for name in asked}, options.anew)
    racer = race.Racer(tools, options.output, race.BOUND / 1000)
    for name in answers.missing():
        answers.add(racer.of_solvers(asked[name], forces.SOLVERS))
    return answers.asked_for()


def conditions(n_raced, n_found):
    """With what the rows were measured."""
    versions = subprocess.run([BUILD / "orthocone", "--version"], capture_output=True, text=True, check=True).stdout
    return (f"{n_raced} of {n_found} problems, one thread, {os.cpu_count()} cores ({processor()}), load average at the end "
            f"{os.getloadavg()[0]:.1f}; {versions.splitlines()[0]}.\n")


def problems_part(options):
    """Pictures and tables of the problems; in docs/ also their rows and commands."""
    tools = programs(options.output / "bin")
    if options.docs and "siconos" not in tools:
        raise StudyError("--docs is of a race with Siconos")
    found = problems.listed(problems.Writer(options.output / "problems", tools, say), options.quick, options.families)
    if FCLIB in options.families:
        found += problems.at_hand(options.problems, tools, say)
    if options.list:
        for problem in found:
            print(f"{problem.name:32}{problem.command}")
        return {}
    rows, errors = raced(options, tools, found), raced_errors(options, tools, found)
    tight = raced_forces(options, tools, found, rows) if "siconos" in tools else []
    folders = [options.output, *([ROOT / "docs/images"] if options.docs else [])]
    profiles.save(profiles.figures(rows, errors), folders)
    if options.docs:
        write_rows(ROOT / "docs/data/peers.csv", rows)
        write_rows(ROOT / "docs/data/peers_errors.csv", errors)
        commands = {problem.name: problem.command for problem in found}
        write_rows(ROOT / "docs/data/peers_problems.csv", [{"problem": name, "command": text} for name, text in commands.items()])
    return {**tables.all_tables(rows, forces.agreement([*rows, *tight])), "conditions": conditions(len({row["problem"] for row in rows}), len(found))}


def scenes_part(options):
    names = list(bodies.SCENES)[1:2] if options.quick else list(bodies.SCENES)
    rows = scenes_race.raced(names, options, BUILD / "orthocone", 1 if options.quick else scenes_race.ROUNDS, say)
    if options.docs:
        write_rows(ROOT / "docs/data/peers_scenes.csv", rows)
    return {"scenes": tables.scenes(rows)}


def main():
    options = parsed_options()
    options.output.mkdir(parents=True, exist_ok=True)
    try:
        found = {**(problems_part(options) if options.only != "scenes" else {}),
                 **(scenes_part(options) if options.only != "problems" and not options.list else {})}
    except StudyError as error:
        sys.exit(f"peers: {error}")
    except KeyboardInterrupt:
        sys.exit("peers: interrupted; the same command goes on")
    for table in found.values():
        print("\n" + table, flush=True)
    if options.docs:
        docs_page.write_tables(found, ROOT / "docs/peers.md", "peers")

