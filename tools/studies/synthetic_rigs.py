# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Rigs whose friction is known: their loops are those of prm/identify on another mesh behind a spring, with noise, and
tools/identify has to find friction and spring again. `synthetic_rigs.py SEED` prints one line of JSON for one rig, and with
--write FILE.csv also keeps its loops."""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True  # the source tree stays clean
import numpy as np  # noqa: E402
from paths import ROOT  # noqa: E402

sys.path.insert(1, str(ROOT / "tools/identifications"))
from loop_curves import BRANCHES  # noqa: E402
from loop_runs import Model  # noqa: E402

SCENE, TOOL = ROOT / "prm/identify/cylinder.prm", ROOT / "tools/identifications/identify.py"
# Finer than that of the scene, with other elements.
MESH = ["Mesh/Cells=48, 1, 12", "Mesh/Edge grading=1.16", "Mesh/Layer grading=0.65", "Mesh/Degree=3"]
NORMAL_FORCE, STIFFNESS = 900., 3e5  # N, and of the scene in stick, about, N/mm
# Angles of the motion, degrees, and displacements of the body over those at which it would slide if it were rigid: along x the
# first loop sticks in part.
MOTIONS = ((0, 0.6), (0, 3), (90, 3), (40, 6))
ALONG_AXIS, OBLIQUE = (20, 20, 20, 100, 100), (40, 40, 40, 250, 250)  # load steps of the branches
ROWS, NOISE = 100, 0.02


def truth_of(seed):
    """{name: value} of a rig."""
    chance = np.random.default_rng(seed)
    mu_x, ratio, slip = chance.uniform(0.2, 0.8), 2**chance.uniform(-1, 1), 2**chance.uniform(-1, 1)
    return {"mu_x": mu_x, "mu_y": mu_x / ratio, "slip_ratio": slip, "rig_compliance": 1 / (10**chance.uniform(4.7, 5.5))}


def loops_of(truth, program, motions=MOTIONS, rows=ROWS, seed=0, noise=NOISE, mesh=MESH):
    """{column: (n,)} of all loops, numbered by `loop`."""
    settings = [*mesh, f"Friction/Coefficients={truth['mu_x']:.12g}, {truth['mu_y']:.12g}",
                f"Friction/Slip potential={truth['slip_ratio']:.12g}, 1"]
    directions = [np.round([np.cos(np.radians(angle)), np.sin(np.radians(angle))], 12) for angle, _ in motions]
    wanted = []
    for direction, (_, far) in zip(directions, motions):
        reach = far * NORMAL_FORCE / (STIFFNESS * np.hypot(*(direction / [truth["mu_x"], truth["mu_y"]])))
        steps = zip(BRANCHES, OBLIQUE if np.all(direction) else ALONG_AXIS)
        wanted.append((direction, {name: (1 if name == "first" else 2) * reach * (np.arange(1, n + 1) / n)**1.5 for name, n in steps}, []))
    with Model(SCENE, program, settings) as model:
        curves = model.curves(wanted)
        wanted = [(direction, one.steps(ways["first"][-1], 0), []) for (direction, ways, _), one in zip(wanted, curves)]
        curves = model.curves(wanted)
    chance = np.random.default_rng(seed)
    return joined([rows_of(one, truth["rig_compliance"], rows, chance, noise) for one in curves])


def rows_of(curves, compliance, rows, chance, noise):
    """{column: (n,)} of a loop: the motion of the actuator, and the force with noise."""
    stroke, at = curves.of_rig("down", compliance)[-1], np.linspace(0, 1, rows // 2)
    force = np.concatenate([curves.change("down", compliance, stroke * at),
                            curves.branches["down"][1][-1] + curves.change("up", compliance, stroke * at)])
    force = np.round(force - (force.max(axis=0) + force.min(axis=0)) / 2, 6)
    place = stroke * np.concatenate([0.5 - at, at - 0.5])
    along = np.abs(force @ curves.direction).max()
    force = force + noise * along * chance.normal(size=force.shape) * (np.abs(curves.direction) > 0)
    return {"ux": place * curves.direction[0], "uy": place * curves.direction[1], "held_force_x": force[:, 0], "held_force_y": force[:, 1]}


def joined(loops):
    numbers = np.concatenate([np.full(len(loop["ux"]), i) for i, loop in enumerate(loops, 1)])
    return {"loop": numbers, **{name: np.concatenate([loop[name] for loop in loops]) for name in loops[0]}}


def write(path, columns):
    np.savetxt(path, np.column_stack(list(columns.values())), fmt=["%d", "%.7g", "%.7g", "%.5g", "%.5g"], delimiter=",",
               header=",".join(columns), comments="")


def identified(file, program, folder, *options):
    """The content of identified.json."""
    words = [sys.executable, TOOL, file, SCENE, "--output", folder / "identified.json", "--program", program, *options]
    subprocess.run(words, check=True, stdout=subprocess.DEVNULL)
    return json.loads((folder / "identified.json").read_text(encoding="utf-8"))


def row_of(seed, program, kept=None):
    """Truth, estimates and intervals of a rig."""
    truth = truth_of(seed)
    with tempfile.TemporaryDirectory() as name:
        file = kept or pathlib.Path(name) / "loops.csv"
        write(file, loops_of(truth, program, seed=seed))
        begin = time.perf_counter()
        found = identified(file, program, pathlib.Path(name))
        row = {"runs": found["runs"], "iterations": found["iterations"], "rms": f"{found['rms']:.5f}",
               "seconds": f"{time.perf_counter() - begin:.1f}"}
    for key, value in truth.items():
        one = found["parameters"][key]
        low, high = one["interval"] or (None, None)
        row |= {key: f"{value:.6g}", f"{key}_found": one["estimate"], f"{key}_low": low, f"{key}_high": high}
    return row


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("seed", type=int)
    parser.add_argument("--program", default=ROOT / "build/orthocone")
    parser.add_argument("--write", type=pathlib.Path)
    given = parser.parse_args()
    print(json.dumps(row_of(given.seed, given.program, given.write)))
