# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Relations between runs: what two scenes must have in common, whatever the right answer is."""
import functools

import promises
from bench import Row
from promises import DONE

FULL = ["Mesh/Model=full", "Output/Contact fields=0", "Output/Probes="]
LEGS = "Load program/Legs="
SHEARED = LEGS + "0.02 0.01 -0.1 : 3 ; -0.01 0 -0.05 : 2"
PRESSED = LEGS + "0 0 -0.1 : 3 ; 0 0 -0.02 : 3"
MOMENTS = ("moment_x", "moment_y", "moment_z")
FORCES = ("force_x", "force_y", "force_z", *MOMENTS, "min_pressure", "max_pressure", "dissipation", "total_dissipation",
          "elastic_energy")
LENGTHS = {**dict.fromkeys(("ux", "uy", "uz", "max_slip", "max_accumulated_slip"), 1),
           **dict.fromkeys(("force_x", "force_y", "force_z", "stick_area", "contact_area"), 2),
           **dict.fromkeys(("dissipation", "total_dissipation", "elastic_energy", *MOMENTS), 3)}
TURNED = {"ux": "uy", "uy": "ux", "force_x": "force_y", "force_y": "force_x", "moment_x": "moment_y",
          "moment_y": "moment_x"}
TURNED_SIGNS = {"ux": -1, "force_x": -1, "moment_x": -1}
COUNTS = {"n_open", "n_stick", "n_slip"}
# How the steps are counted and solved, which is no physics.
SOLVER = {"step", "method", "iterations", "residual", "cycle", "phase", "driven"}
MIRRORED = {"ux": -1, "force_x": -1, "moment_y": -1, "moment_z": -1}


def history(bench, name, settings):
    code, _, err = bench.set(*settings, output=name)
    if code != DONE:
        raise ValueError(f"exit code {code}: {err[:200]}")
    return promises.rows(bench.folder / name)


def differences(rows, others, factors, names, without, bound):
    """Columns of `rows` that are not `factors` times those of `others`, which may have other `names`."""
    if len(rows) != len(others):
        return [f"{len(rows)} rows and {len(others)}"]
    faults = []
    for key in rows[0]:
        if key in SOLVER | set(without):
            continue
        of_face = key.removeprefix("held_")  # the held face has the forces of the plane, with the other sign
        factor, other = factors.get(of_face, 1), key[:-len(of_face)] + names.get(of_face, of_face)
        partners = {"force": ("force_x", "force_y", "force_z"), "moment": (*MOMENTS, "force_z")}.get(
            of_face.split("_")[0], (other,))
        scale = abs(factor) * max(abs(row[name]) for row in others for name in partners)
        worst = max(abs(row[key] - factor * line[other]) for row, line in zip(rows, others))
        if worst > bound * scale:
            faults.append(f"{key} differs by {worst / scale if scale else worst:.2g}")
    return faults


def related(settings, others, factors=(), names=(), without=(), bound=1e-6):
    """A script that compares two runs."""
    def script(bench):
        try:
            return differences(history(bench, "one", settings), history(bench, "other", others), dict(factors),
                               dict(names), without, bound)
        except ValueError as error:
            return [str(error)]
    return script


def sheared(*settings, **options):
    return related([*FULL, SHEARED, *settings], [*FULL, SHEARED], **options)


def stretched(factor):
    """Radius, height and motions times `factor`."""
    legs = LEGS + " ; ".join(" ".join(f"{x * factor:.17g}" for x in target) + f" : {steps}"
                             for target, steps in (((0.02, 0.01, -0.1), 3), ((-0.01, 0, -0.05), 2)))
    size = [f"Geometry/{name}={10 * factor:.17g}" for name in ("Radius", "Height")]
    return related([*FULL, legs, *size], [*FULL, SHEARED],
                   factors={key: factor**power for key, power in LENGTHS.items()})


def moved(legs, *settings, **options):
    return related([*FULL, LEGS + legs, *settings], [*FULL, SHEARED], **options)


def part(model, legs, cells):
    """A model by symmetry against the whole; what symmetry makes zero is zero but for rounding."""
    cells = f"Mesh/Core cells={cells}"
    return related([*FULL, LEGS + legs, f"Mesh/Model={model}", cells], [*FULL, LEGS + legs, cells], without=COUNTS)


def modulus(factor):
    return sheared(f"Material/Young modulus={210000 * factor:.17g}", factors=dict.fromkeys(FORCES, factor))


def same_bytes(first, second):
    """A script: two command lines whose tables have the same bytes; both know the files given."""
    def script(bench):
        tables = []
        for number, (files, arguments) in enumerate((first, second)):
            for name, text in files.items():
                bench.put(name, text)
            code, _, err = bench.call(*arguments, "--quiet", f"--output={number}")
            if code != DONE:
                return [f"exit code {code}: {err[:200]}"]
            tables.append((bench.folder / f"{number}/history.csv").read_bytes())
        return ["the tables differ"] * (tables[0] != tables[1])
    return script


def repeated(settings, bench):
    """parameters.prm of a run repeats it."""
    bench.set(*settings, output="one")
    code, _, err = bench.call("one/parameters.prm", "--quiet", "--output=two")
    same = code == DONE and all((bench.folder / "one" / name).read_bytes() == (bench.folder / "two" / name).read_bytes()
                                for name in ("history.csv", "parameters.prm"))
    return [] if same else [f"exit code {code}, or other tables: {err[:200]}"]


def within_the_cone(legs, bench):
    """The total force: the friction cone is convex."""
    rows = history(bench, "one", [*FULL, LEGS + legs])
    pushed = any(abs(row["force_x"]) > 0 for row in rows)
    return promises.of_cone(rows) + ["nothing is pushed aside"] * (not pushed)


TURNED_LEGS = "-0.01 0.02 -0.1 : 3 ; 0 -0.01 -0.05 : 2"
SWAPPED = ["Friction/Coefficients=0.15,0.3", "Friction/Slip potential=0.15,0.3"]
NU = "subsection Material\n  set Poisson ratio = 0.2\nend\n"
MESH = "subsection Mesh\n  set Layers = 3\nend\n"
SETTINGS = ["--set=Material/Poisson ratio=0.2", "--set=Mesh/Layers=3"]
SCRIPTS = {
    **{f"E times {factor:g}": modulus(factor) for factor in (1e-12, 1e-3, 2**-30, 1e6, 1e15)},
    **{f"lengths times {factor:g}": stretched(factor) for factor in (1e-9, 1e-3, 2**20, 1e3, 1e9)},
    "turned by 90 degrees, axes swapped": moved(TURNED_LEGS, *SWAPPED, factors=TURNED_SIGNS, names=TURNED),
    "turned by 90 degrees, angle 90": moved(TURNED_LEGS, "Friction/Orthotropy angle=90", factors=TURNED_SIGNS,
                                            names=TURNED),
    "turned by 90 degrees, angle -90": moved(TURNED_LEGS, "Friction/Orthotropy angle=-90", factors=TURNED_SIGNS,
                                             names=TURNED),
    "mirrored": moved("-0.02 0.01 -0.1 : 3 ; 0.01 0 -0.05 : 2", factors=MIRRORED),
    "mirrored with turned axes": related([*FULL, LEGS + "-0.02 0.01 -0.1 : 3", "Friction/Orthotropy angle=-30"],
                                         [*FULL, LEGS + "0.02 0.01 -0.1 : 3", "Friction/Orthotropy angle=30"],
                                         factors=MIRRORED),
    "angle 180": sheared("Friction/Orthotropy angle=180"),
    "axes swapped, angle 90": sheared(*SWAPPED, "Friction/Orthotropy angle=90"),
    **{f"slip ellipse times {p}": sheared(f"Friction/Slip potential=0.3e{p},0.15e{p}") for p in (3, -3, 30, -30)},
    "preload for the first leg": related([*FULL, "Load program/Preload=0.02 0.01 -0.1 : 3", LEGS + "-0.01 0 -0.05 : 2"],
                                         [*FULL, SHEARED]),
    "a leg in two": related(
        [*FULL, LEGS + "0.005 0.0025 -0.025 : 1 ; 0.02 0.01 -0.1 : 3"], [*FULL, LEGS + "0.02 0.01 -0.1 : 4"]),
    "cycles written out": related([*FULL, SHEARED, "Load program/Cycles=2"],
                                  [*FULL, SHEARED + " ; 0.02 0.01 -0.1 : 3 ; -0.01 0 -0.05 : 2"]),
    **{f"method {name}": sheared(f"Contact solver/Method={name}")
       for name in ("gauss-seidel", "uzawa", "feng2006", "plain-newton")},
    **{f"{model} for full, {cells} cells": part(model, PRESSED.split("=")[1], cells)
       for model in ("half", "quarter") for cells in (2, 4)},
    "half for full, moved along x": part("half", "0.02 0 -0.1 : 3 ; 0 0 -0.02 : 3", 2),
    "half for full, moved along y": part("half", "0 0.02 -0.1 : 3 ; 0 0 -0.02 : 3", 2),
    **{f"friction cone, {legs}": functools.partial(within_the_cone, legs)
       for legs in ("0.5 0 -0.1 : 3", "0 0.5 -0.1 : 2 ; 1 0 -0.1 : 2", "1 1 -0.1 : 1 ; 0 0 -0.01 : 4")},
    "settings for a file": same_bytes(({}, ["s.prm", *SETTINGS]),
                                      ({"a.prm": "include s.prm\n" + NU + MESH}, ["a.prm"])),
    "order of settings": same_bytes(({}, ["s.prm", *SETTINGS]), ({}, ["s.prm", *reversed(SETTINGS)])),
    "order of sections": same_bytes(({"a.prm": "include s.prm\n" + NU + MESH}, ["a.prm"]),
                                    ({"b.prm": "include s.prm\n" + MESH + NU}, ["b.prm"])),
    "order of includes": same_bytes(({"n.prm": NU, "m.prm": MESH,
                                      "a.prm": "include s.prm\ninclude n.prm\ninclude m.prm\n"}, ["a.prm"]),
                                    ({"b.prm": "include s.prm\ninclude m.prm\ninclude n.prm\n"}, ["b.prm"])),
    "fields and probes change no table": same_bytes(({}, ["s.prm"]),
                                                    ({},
                                                     ["s.prm", "--set=Output/Volume fields=1",
                                                      "--set=Output/Probes="])),
    "signs and zeros of numbers": same_bytes(({}, ["s.prm"]),
                                             ({}, ["s.prm", "--set=Geometry/Radius=+1.0E+1",
                                                   "--set=Friction/Coefficients=3e-1,.15"])),
    **{f"parameters.prm repeats {name}": functools.partial(repeated, settings) for name, settings in {
        "tiny numbers": [*FULL, "Load program/Legs=1e-320 -0 -0.1 : 2"],
        "long numbers": [*FULL, "Geometry/Radius=10.000000000000002"],
        "an angle": [*FULL, "Friction/Orthotropy angle=0.30000000000000004"],
        "many probes": ["Output/Probes=A: 0 0; B: 1e-5 0; C: -1 -1"]}.items()},
}
ROWS = [Row(name, script=script) for name, script in SCRIPTS.items()]
