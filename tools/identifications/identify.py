# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Says what measured fretting loops tell of friction: finds by least squares the coefficients, the slip rule and the compliance
of the rig with which a scene has these loops, with intervals, and names what the loops do not tell."""
import argparse
import json
import os
import pathlib
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
sys.path.insert(1, str(pathlib.Path(__file__).resolve().parent.parent / "runs"))
import measured_loops  # noqa: E402
import numpy as np  # noqa: E402
import verdict  # noqa: E402
from loop_fit import UNITS, LoopFit, NoFit, WrongScene  # noqa: E402
from loop_runs import FailedRun, Model  # noqa: E402
from measured_loops import WrongData  # noqa: E402
from run_folder import BadFile, content_of, one_line, write_whole  # noqa: E402
from statistics_of_fit import proportional  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
WRONG_INPUT, UNSOLVED, FILE_ERROR, INTERRUPTED = 2, 3, 4, 130
KINDS = (".png", ".svg")
DEFAULT = "mu_x,mu_y,slip_ratio,rig_compliance"
MOST_JOBS, MOST_DRAWN = 1000, 100000


class ArgumentParser(argparse.ArgumentParser):
    def error(self, message):
        self.exit(WRONG_INPUT, f"identify: {one_line(message)}; '--help' explains\n")


def names_of(text):
    names = [word.strip() for word in text.split(",")]
    if len(set(names)) < len(names) or not set(names) <= set(UNITS):
        raise argparse.ArgumentTypeError(f"'{text}': allowed are some of {', '.join(UNITS)}, separated by commas, each once")
    if "mu" in names and {"mu_x", "mu_y"} & set(names):
        raise argparse.ArgumentTypeError(f"'{text}': allowed is mu, which is both coefficients, or mu_x and mu_y")
    return names


def count(most):
    def of_text(text):
        if not text.isdecimal() or not 1 <= int(text[:9]) <= most:
            raise argparse.ArgumentTypeError(f"'{text}': allowed is a whole number from 1 to {most}")
        return int(text)
    return of_text


def picture_file(text):
    path = pathlib.Path(text)
    if path.suffix not in KINDS:
        raise argparse.ArgumentTypeError(f"'{text}': allowed is a name that ends with {' or '.join(KINDS)}")
    return path


def arguments():
    parser = ArgumentParser(prog="tools/identify", description=__doc__)
    parser.add_argument("loops", nargs="+", type=pathlib.Path, metavar="LOOP.csv", help="measured loops, or records of wear")
    parser.add_argument("scene", type=pathlib.Path, metavar="SCENE.prm", help="the model, whose preload presses the bodies")
    parser.add_argument("--fit", type=names_of, default=DEFAULT, metavar="NAMES", help=f"{', '.join(UNITS)} ({DEFAULT})")
    parser.add_argument("--set", action="append", default=[], metavar="Section/Entry=TEXT", help="of the scene; may be repeated")
    parser.add_argument("--bootstrap", type=count(MOST_DRAWN), metavar="N", help="intervals of N fits to residuals drawn anew, too")
    parser.add_argument("--picture", type=picture_file, metavar="OUT", help="draws loops and residuals as .png or .svg")
    parser.add_argument("--output", "-o", type=pathlib.Path, default=pathlib.Path("identified.json"), metavar="OUT.json",
                        help="results (identified.json)")
    parser.add_argument("--jobs", "-j", type=count(MOST_JOBS), default=len(os.sched_getaffinity(0)), help="runs at a time")
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/orthocone", help=argparse.SUPPRESS)
    given = parser.parse_args()
    if not os.access(given.program, os.X_OK) or given.program.is_dir():
        parser.error(f"{given.program}: is no program; build it first")
    return given


def loop_results(given, loops):
    """The fit, and its part of identified.json."""
    with Model(given.scene, given.program, given.set, given.jobs) as model:
        fit = LoopFit(model, loops, given.fit, *model.probe(loops[0]))
        fit.solve()
    facts, information = verdict.loop_facts(fit), fit.information
    found = verdict.parameters(fit, given.bootstrap)
    results = {
        "parameters": found, "loops": facts, "runs": model.n_runs + 1, "iterations": fit.iterations,
        "normal_force_N": fit.normal_force, "rows": len(information.residual), "rms": float(np.sqrt(np.mean(information.residual**2))),
        "condition": float(information.singular.max() / information.singular.min()),
        "correlation": {"names": fit.names, "matrix": information.correlation().tolist()},
        "not_told": [{"direction": direction, "change_by_half": change} for direction, change in verdict.untold_directions(fit)],
        "sentences": verdict.sentences(fit, facts)}
    if "rig_compliance" in found:
        results["rig_stiffness"] = verdict.stiffness(found["rig_compliance"])
    return fit, results


def save_picture(path, title, fit):
    if path.exists() and not path.is_file():
        raise BadFile(f"{path}: is no ordinary file, and stays as it is")
    import identify_picture  # not at the top: Matplotlib takes a second
    identify_picture.draw(title, fit).savefig(path, dpi=150, metadata={"Date": None} if path.suffix == ".svg" else None)


def look(given):
    loops, records = measured_loops.read(given.loops)
    content_of(given.scene)  # an error if it cannot be read
    fit, results = loop_results(given, loops) if loops else (None, {"parameters": {}, "sentences": []})
    if records:
        energy, volume = (np.concatenate([getattr(one, name) for one in records]) for name in ("energy", "volume"))
        results["parameters"]["wear_coefficient"] = verdict.wear_parameter(*proportional(energy, volume))
    results = {"scene": str(given.scene), "files": [str(path) for path in given.loops], "settings": given.set, **results}
    print(*verdict.table(results["parameters"]), sep="\n")
    if fit:
        print(f"{results['rows']} forces, loops: {len(loops)}, rms residual {100 * results['rms']:.3g} % of the amplitude, condition "
              f"{results['condition']:.3g}, {results['runs']} runs")
    print(*map(one_line, results["sentences"]), sep="\n")
    write_whole(given.output, json.dumps(results, indent=2) + "\n")
    if given.picture and fit:
        save_picture(given.picture, f"{given.scene.name}: rms residual {100 * results['rms']:.2g} % of the amplitude", fit)
    print(f"{one_line(given.output)}: the results" + (f"\n{one_line(given.picture)}: the picture" if given.picture and fit else ""))


def main():
    given = arguments()
    sys.stdout.reconfigure(errors="surrogateescape")  # names of files need not be text
    try:
        look(given)
    except (WrongData, WrongScene, BadFile) as problem:
        words = f"{given.scene}: {problem}" if isinstance(problem, WrongScene) else problem
        print(f"identify: {one_line(words)}", file=sys.stderr)
        sys.exit(WRONG_INPUT)
    except (FailedRun, NoFit) as problem:
        print(f"identify: {one_line(problem)}", file=sys.stderr)
        sys.exit(getattr(problem, "code", UNSOLVED) if getattr(problem, "code", 0) in (WRONG_INPUT, FILE_ERROR) else UNSOLVED)
    except KeyboardInterrupt:
        print("identify: interrupted", file=sys.stderr)
        sys.exit(INTERRUPTED)
    except OSError as problem:
        print(f"identify: {one_line(problem)}", file=sys.stderr)
        sys.exit(FILE_ERROR)


if __name__ == "__main__":
    main()
