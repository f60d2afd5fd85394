# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Peers side by side: the same problems and the same scenes by orthocone, Siconos, GetFEM and CalculiX. Started by
tools/peers."""
import argparse
import dataclasses
import os
import pathlib
import random
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path[:0] = [str(ROOT / "tools/studies"), str(ROOT / "tools/plots")]

from points import StudyError, write_rows  # noqa: E402

from benchmark_measure import processor  # noqa: E402

import bodies  # noqa: E402
import docs_page  # noqa: E402
import problems  # noqa: E402
import profiles  # noqa: E402
import race  # noqa: E402
import scenes_race  # noqa: E402
import tables  # noqa: E402

OF_THE_ERROR_CHART = ("a-bricks/8", "fretting-c-fine/10", "random-1/4")
SICONOS_HEADERS = ("/usr/include/siconos/numerics", "/usr/include/siconos")


def say(text):
    print(f"peers: {text}", flush=True)


def parsed_options():
    parser = argparse.ArgumentParser(prog="tools/peers", description=__doc__)
    parser.add_argument("--only", choices=("problems", "scenes"), help="one of the two parts (both)")
    parser.add_argument("--list", action="store_true", help="print the problems with their commands, and stop")
    parser.add_argument("--docs", action="store_true", help="also refresh page, pictures and tables in docs/")
    parser.add_argument("--anew", action="store_true", help="compute also what is there already")
    parser.add_argument("--minutes", type=float, default=30, help="no new problem after this time (30); the same command goes on")
    parser.add_argument("--quick", action="store_true", help="few problems and steps: a test of this tool, not a study")
    parser.add_argument("--output", type=pathlib.Path, help="folder of the results (output/peers)")
    options = parser.parse_args()
    if options.output is None:
        options.output = ROOT / ("output/peers-quick" if options.quick else "output/peers")
    if options.quick and options.docs:
        parser.error("--quick measures nothing that belongs in --docs")
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
    here = pathlib.Path(__file__).resolve().parent
    return {"orthocone": ROOT / "build/orthocone", "solve": ROOT / "build/orthocone-solve",
            "siconos": compiled([here / "siconos_solve.c", here / "fclib_problem.c"], folder / "siconos_solve",
                                *(f"-I{path}" for path in SICONOS_HEADERS), "-lsiconos_numerics", "-lfclib", "-lm"),
            "clock": compiled([here / "cpu_clock.c"], folder / "cpu_clock.so", "-shared", "-fPIC")}


def raced(options, tools, found):
    """Rows of all problems."""
    answers = race.Answers(options.output / "answers.csv", options.anew)
    missing = [problem for problem in found if not answers.has(problem.name)]
    random.Random(0).shuffle(missing)  # so that what is there of an interrupted run is a sample of them all
    say(f"{len(found)} problems, of which {len(missing)} are to be solved")
    racer, begin = race.Racer(tools, options.output), time.monotonic()
    for count, problem in enumerate(missing, 1):
        if time.monotonic() - begin > 60 * options.minutes:
            say(f"the time is up: {len(missing) - count + 1} problems are left out; the same command goes on")
            break
        answers.add(racer.race(problem))
        if count % 10 == 0 or count == len(missing):
            say(f"{len(found) - len(missing) + count} of {len(found)} problems, {time.monotonic() - begin:.0f} s")
    names = {problem.name for problem in found}
    return [row for row in race.within_limits(answers.rows) if row["problem"] in names]


def raced_errors(options, tools, found):
    """Rows of some problems with other bounds of the error."""
    answers = race.Answers(options.output / "errors.csv", options.anew)
    named = {problem.name: problem for problem in found}
    for name in OF_THE_ERROR_CHART:
        for bound in race.BOUNDS:
            key = f"{name} to {bound:g}"
            if name in named and not answers.has(key):
                problem = dataclasses.replace(named[name], name=key)
                answers.add(race.Racer(tools, options.output, bound).race(problem, 1))
    return answers.rows


def conditions(n_raced, n_found):
    """With what the rows were measured."""
    versions = subprocess.run([ROOT / "build/orthocone", "--version"], capture_output=True, text=True, check=True).stdout
    return (f"{n_raced} of {n_found} problems, one thread, {os.cpu_count()} cores ({processor()}), load average at the end "
            f"{os.getloadavg()[0]:.1f}; {versions.splitlines()[0]}.\n")


def problems_part(options):
    """Pictures and tables of the problems; in docs/ also their rows and commands."""
    if not any((pathlib.Path(path) / "fc3d_Solvers.h").exists() for path in SICONOS_HEADERS):
        say("no Siconos here (Debian's libsiconos-numerics-dev): nobody to race with")
        return {}
    tools = programs(options.output / "bin")
    found = problems.listed(options.quick, tools, say)
    if options.list:
        for problem in found:
            print(f"{problem.name:32}{problem.command}")
        return {}
    rows, errors = raced(options, tools, found), raced_errors(options, tools, found)
    folders = [options.output, *([ROOT / "docs/images"] if options.docs else [])]
    profiles.save(profiles.figures(rows, errors), folders)
    if options.docs:
        write_rows(ROOT / "docs/data/peers.csv", rows)
        write_rows(ROOT / "docs/data/peers_errors.csv", errors)
        commands = {problem.name: problem.command for problem in found}
        write_rows(ROOT / "docs/data/peers_problems.csv", [{"problem": name, "command": text} for name, text in commands.items()])
    return {**tables.all_tables(rows), "conditions": conditions(len({row["problem"] for row in rows}), len(found))}


def scenes_part(options):
    names = list(bodies.SCENES)[1:2] if options.quick else list(bodies.SCENES)
    rows = scenes_race.raced(names, options, ROOT / "build/orthocone", 1 if options.quick else scenes_race.ROUNDS, say)
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


if __name__ == "__main__":
    main()
