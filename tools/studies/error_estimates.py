#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""How good the error estimates of Mesh/Accuracy are: tools/studies/error_estimates.py [--levels N] [--solid] [SCENE...]

Solves a family of scenes on the levels of a search (for an accuracy that none reaches) and compares the estimates of each
level with the differences to a fine mesh of another kind, with another core ratio and rings of other thickness: what all
levels have in common counts as an error, too. Such a mesh misses the stick area of a solid by a per cent; there the truth is
the last level, with the smallest cells along the border, which is not judged itself. Prints a line for each scene and level and the share of estimates that
bound the true error within a factor 3, and of those that are more than 10 times too large."""
import argparse
import math
import pathlib
import re
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True  # the source tree stays clean
from one_cycle import FINEST, FINEST_SECTION, QUANTITIES, ROOT, run  # noqa: E402

FLOOR = 0.05  # percent: an estimate below that is not blamed for being too large
TRUTHS_OWN = 0.01  # percent: no estimate is blamed for a smaller error, which may be the truth's own

CYCLE = "Load program/Legs=0 0 -0.1 : 1; 0 0 -0.02 : 3"


def isotropic(mu, nu, height):
    return [f"Friction/Coefficients={mu}, {mu}", f"Friction/Slip potential={mu}, {mu}", f"Material/Poisson ratio={nu}",
            f"Geometry/Height={height}"]


def orthotropic(mu, p, nu=0.3, height=10, angle=0):
    return [f"Friction/Coefficients={mu[0]}, {mu[1]}", f"Friction/Slip potential={p[0]}, {p[1]}",
            f"Material/Poisson ratio={nu}", f"Geometry/Height={height}", f"Friction/Orthotropy angle={angle}"]


AXISYMMETRIC = {f"mu={mu} nu={nu} H={height}": isotropic(mu, nu, height)
                for mu in (0.1, 0.2, 0.4) for nu in (0.15, 0.3, 0.45) for height in (5, 10, 25)}
SOLID = {
    "B": orthotropic((0.3, 0.15), (0.3, 0.15)),
    "C": orthotropic((0.3, 0.15), (0.05, 0.2)),
    "B, mu halved": orthotropic((0.15, 0.075), (0.3, 0.15)),
    "C, mu halved": orthotropic((0.15, 0.075), (0.05, 0.2)),
    "B, nu=0.2": orthotropic((0.3, 0.15), (0.3, 0.15), nu=0.2),
    "C, nu=0.4": orthotropic((0.3, 0.15), (0.05, 0.2), nu=0.4),
    "B, H=20": orthotropic((0.3, 0.15), (0.3, 0.15), height=20),
    "C, H=5": orthotropic((0.3, 0.15), (0.05, 0.2), height=5),
    "mu=0.25, 0.15, collinear": orthotropic((0.25, 0.15), (1, 1)),
}


def levels_of(program, settings, n_levels):
    """[(contact nodes, {quantity: (value, estimated error in percent)}), ...] of the first levels."""
    levels = []
    with tempfile.TemporaryDirectory() as folder:
        words = [f"--set={setting}" for setting in (CYCLE, "Load program/Cycles=1", "Mesh/Accuracy=0.01 %", *settings)]
        with subprocess.Popen([program, ROOT / "prm/paper/case_b.prm", "--output", folder, *words], text=True,
                              stdout=subprocess.PIPE) as run:
            for line in run.stdout:
                if found := re.match(r"accuracy +level \d+, (\d+) contact nodes: (.*)", line):
                    quantities = re.findall(r"(\w+) (\S+) \((\S+) %\)", found[2])
                    levels.append((int(found[1]),
                                   {name: (float(value), float(error)) for name, value, error in quantities}))
                if len(levels) == n_levels or "wanted" in line:
                    run.kill()  # the run itself is of no interest
                    break
    return levels


def true_error(name, value, truths):
    """In percent, as the program relates it."""
    motion, contact_area = 0.1, math.pi * 10**2  # of all scenes
    least = {"stick_area_mm2": 0.1 * contact_area, "largest_slip_mm": 1e-3 * motion,
             "dissipation_Nmm": 1e-3 * motion * truths["peak_force_N"] / 2}
    least["loop_area_Nmm"] = least["dissipation_Nmm"]
    truth = truths[name]
    return 100 * abs(value - truth) / max(abs(truth), least.get(name, 0))


def truths_of(program, settings, is_solid):
    """Quantities of a scene on the fine mesh, and its contact nodes."""
    values, summary, _ = run(program, "b", [CYCLE, *settings, *(FINEST if is_solid else FINEST_SECTION)])
    return dict(zip(QUANTITIES, values)), summary["model"]["contact_nodes"]


def verdicts(levels, truths, first=2):
    """(level, quantity, estimate, true error) of the levels that a search may stop at."""
    for number, (_nodes, quantities) in enumerate(levels):
        for name in QUANTITIES if number >= first else ():
            value, estimate = quantities[name]
            yield number, name, estimate, true_error(name, value, truths)


def is_bound(estimate, error):
    return estimate >= error / 3 or error < TRUTHS_OWN


def is_gross(estimate, error):
    return estimate > max(10 * error, FLOOR)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("scenes", nargs="*", metavar="SCENE", help="only these scenes")
    parser.add_argument("--program", default=ROOT / "build/orthocone", type=pathlib.Path)
    parser.add_argument("--levels", default=9, type=int, help="to be judged, at most")
    parser.add_argument("--solid", action="store_true", help="three-dimensional scenes alone (minutes)")
    return parser.parse_args()


def main():
    options = arguments()
    family = SOLID if options.solid else AXISYMMETRIC
    scenes = {name: (AXISYMMETRIC | SOLID)[name] for name in options.scenes} if options.scenes else family
    everything = []
    for name, settings in scenes.items():
        is_solid = name in SOLID
        levels = levels_of(options.program, settings, 9 if is_solid else options.levels)
        truths, nodes = truths_of(options.program, settings, is_solid)
        if is_solid:
            truths["stick_area_mm2"] = levels.pop()[1]["stick_area_mm2"][0]
        found = list(verdicts(levels[:options.levels], truths))
        everything += found
        print(f"{name:28} truth: {nodes} nodes, " + ", ".join(f"{key} {value:.6g}" for key, value in truths.items()))
        for level, quantity, estimate, error in found:
            mark = "" if is_bound(estimate, error) else "  NOT BOUND"
            print(f"{name:28} level {level} ({levels[level][0]:4} nodes) {quantity:16} estimated {estimate:8.3f} %, "
                  f"true {error:8.3f} %{mark}", flush=True)
    n = max(1, len(everything))
    bound = sum(is_bound(estimate, error) for *_, estimate, error in everything)
    gross = sum(is_gross(estimate, error) for *_, estimate, error in everything)
    print(f"{len(everything)} estimates in {len(scenes)} scenes: {100 * bound / n:.1f} % bound the true error within a "
          f"factor 3, {100 * gross / n:.1f} % are more than 10 times too large")


if __name__ == "__main__":
    sys.exit(main())
