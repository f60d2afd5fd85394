# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""tools/fatigue on runs: where a rig of fretting fatigue cracks, its mirror image, halves of a model, and what is refused in a
line.

Usage: test_fatigue_tool.py PROGRAM [unittest options]"""
import json
import math
import os
import re
import subprocess
import sys

import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
import program  # noqa: E402
from program import ROOT, SMALL, main  # noqa: E402

sys.path.insert(0, str(ROOT / "tools/runs"))
from run_folder import RunFolder, Vtu  # noqa: E402

TOOL = ROOT / "tools/fatigues/fatigue.py"
RIG = ROOT / "prm/rigs/fretting_fatigue.prm"
FIELDS = ["Output/Volume fields=1", "Output/Contact fields=1"]
COARSE = ["Mesh/Cells=40, 1, 10", "Mesh/Edge grading=1.2", "Mesh/Layer grading=0.5", "Lower mesh/Cells=40, 1, 10",
          "Lower mesh/Edge grading=1.2", "Lower mesh/Layer grading=0.5", "Load program/Cycles=2", *FIELDS]
MIRRORED = ["Lower geometry/Supports=x+: x", "Load program/Loads=bulk: traction on lower x- along x"]
HALF_WIDTH = 0.26  # mm, Hertz
YOUNG, POISSON = 210e3, 0.3  # of both bodies
WRONG_INPUT, FILE_ERROR = 2, 4
ROW = re.compile(r"^(\S.{24}) +([\d.e+-]+) .*?  (lower body|body|\S+) +([\d.e+-]+) +([\d.e+-]+) +[\d.e+-]+ +([\d.e+-]+)(?: +([\d.]+) +([\d.-]+))?$",
                 re.MULTILINE)


def legs(force, bulk):
    return (f"Load program/Legs=Fx {force} bulk {bulk} : 2 ; Fx {-force} bulk {-bulk} : 4 ; Fx {force} bulk {bulk} : 4")


def worst(text):
    """{parameter: (value, where, x, y, depth, inclination, azimuth)} of the first table."""
    found = {}
    for name, value, where, *numbers in ROW.findall(text.partition("\n\n")[0]):
        found.setdefault(name.strip(), (float(value), where, *(float(one) if one else None for one in numbers)))
    return found


def stresses_at(run, steps, x):
    """Stress xx, yy, zz, xz, MPa, of the lower body at (x, 0, 0): (steps, 4)."""
    found = []
    for step in steps:
        file = Vtu(run / f"lower-{step:04d}.vtu")
        here = np.abs(file.points - [x, 0, 0]).max(axis=1) < 1e-4
        found.append(file.fields["stress"][here].mean(axis=0)[[0, 4, 8, 2]])
    return np.array(found)


def on_plane(stress, angle):
    """Normal stress and shear on planes of the section, that go down and lean by an angle
    towards +x: their normal leans from x to z."""
    c, s = np.cos(angle), np.sin(angle)
    xx, _, zz, xz = stress.T
    return c * c * xx + s * s * zz + 2 * c * s * xz, c * s * (zz - xx) + (c * c - s * s) * xz


def smith_watson_topper(stress, angle):
    normal, _ = on_plane(stress, angle)
    strain = ((1 + POISSON) * normal - POISSON * stress[:, :3].sum(axis=1)) / YOUNG
    return max(normal.max(), 0) * np.ptp(strain) / 2


def findley(stress, angle):
    """k from the limits of the tool's steel: k / sqrt(1 + k^2) = 2 * 196.2 / 313.9 - 1."""
    normal, shear = on_plane(stress, angle)
    sine = 2 * 196.2 / 313.9 - 1
    return np.ptp(shear) / 2 + sine / np.sqrt(1 - sine**2) * normal.max()


class FatigueTest(program.RunTest):
    def tool(self, *words):
        environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
        return subprocess.run([sys.executable, TOOL, *words], cwd=self.folder, text=True, capture_output=True, check=False,
                              env=environment)

    def tables(self, *words):
        result = self.tool(*words)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return result.stdout

    def refused(self, code, words, *arguments):
        result = self.tool(*arguments)
        self.assertEqual((result.returncode, result.stdout), (code, ""), result.stderr)
        self.assertRegex(result.stderr, r"^fatigue: [^\n]*\n$")
        self.assertIn(words, result.stderr)

    def run_done(self, name, file, *settings):
        result = self.run_program(name, settings=settings, file=file)
        self.assertEqual((result.returncode, result.stderr), (0, ""))


class RigTest(FatigueTest):
    def test_the_crack_begins_at_the_trailing_edge_of_the_specimen(self):
        """There friction and bulk stress pull together: at x < 0 where force and bulk stress are in phase. The mirror image of
        the rig has the mirror image of the crack, and a cycle that begins at its other end has the same one."""
        self.run_done("in_phase", RIG, *COARSE, legs(155, 100))
        self.run_done("mirrored", RIG, *COARSE, *MIRRORED, legs(-155, -100))
        self.run_done("reversed", RIG, *COARSE, legs(-155, -100))
        one, other, same = (worst(self.tables(name)) for name in ("in_phase", "mirrored", "reversed"))
        self.assertEqual(len(one), 7)
        for name, (value, where, x, y, depth, inclination, azimuth) in one.items():
            with self.subTest(name):
                mirrored = other[name]
                self.assertEqual((y, depth), (0, 0))
                self.assertAlmostEqual(x, -HALF_WIDTH, delta=0.06)
                self.assertAlmostEqual(mirrored[2], -x, delta=1e-3)
                self.assertAlmostEqual(mirrored[0] / value, 1, delta=1e-3)
                self.assertAlmostEqual(same[name][0] / value, 1, delta=2e-2)
                self.assertEqual(same[name][2:5], (x, y, depth))
                if not name.startswith("Ruiz"):
                    self.assertEqual(where, "lower body")
                if inclination is not None:
                    self.assertAlmostEqual(mirrored[5], inclination, delta=0.3)
                    self.assertAlmostEqual(abs(mirrored[6] - azimuth), 180, delta=0.3)
        self.assertEqual(one["Smith-Watson-Topper"][6], 0)
        for name, at_angle in (("Smith-Watson-Topper", smith_watson_topper), ("Findley", findley)):
            value, _, x, *_, inclination, azimuth = one[name]
            stress = stresses_at(self.folder / "in_phase", range(13, 23), x)
            angles = np.arange(-90, 90, 0.1)
            values = [at_angle(stress, angle) for angle in np.radians(angles)]
            self.assertAlmostEqual(angles[np.argmax(values)], inclination if azimuth == 0 else -inclination, delta=0.3)
            self.assertAlmostEqual(value / max(values), 1, delta=1e-3)
        self.look_at_files()

    def look_at_files(self):
        """Fields, picture, chosen steps and constants of the run in phase."""
        (self.folder / "own.json").write_text(json.dumps({"name": "own steel", "bending_limit": 400, "torsion_limit": 240}))
        text = self.tables("in_phase", "--parameters", "swt,crossland", "--critical-distance", "0.05", "--material", "own.json",
                           "--output", "own.vtu", "--picture", "own.png", "--steps", "4:12")
        self.assertEqual(text.splitlines()[1], "material: own steel")
        file = Vtu(self.folder / "own.vtu")
        self.assertEqual(set(file.fields), {"body", "swt", "swt_normal", "swt_inclination", "swt_azimuth", "swt_mean", "swt_mean_normal",
                                            "swt_mean_inclination", "swt_mean_azimuth", "crossland", "crossland_mean"})
        self.assertEqual(set(np.unique(file.fields["body"])), {0, 1})
        surface = np.isfinite(file.fields["swt_mean"])
        self.assertLess(file.fields["swt_mean"][surface].max(), 0.9 * file.fields["swt"].max())
        self.assertLess(np.abs(file.points[surface, 2]).max(), 1e-6)
        self.assertEqual((self.folder / "own.png").read_bytes()[:4], b"\x89PNG")
        row = np.argmax(file.fields["swt"])
        self.assertAlmostEqual(worst(text)["Smith-Watson-Topper"][0] / file.fields["swt"][row], 1, delta=1e-3)

    def test_each_body_has_its_own_constants(self):
        """The table's share of the limit is the value over that of a bar at the limit of the body where the place lies: the
        specimen, and with a weak pad the pad."""
        strong, weak = ({"bending limit": 2 * size, "torsion limit": 1.2 * size, "yield stress": 400} for size in (200, 20))

        def entry(section, constants):
            return f"{section}/Fatigue=" + " ; ".join(f"{name}: {value}" for name, value in constants.items())
        for run, pad, specimen in (("specimen", strong, strong), ("pad", weak, strong)):
            self.run_done(run, RIG, *COARSE, legs(155, 100), entry("Material", pad), entry("Lower material", specimen))
        tables = {run: self.tables(run, "--parameters", "crossland") for run in ("specimen", "pad")}
        self.assertIn("material: constants of Material/Fatigue", tables["pad"].replace(" of the body", ""))
        self.assertIn("material of the lower body: constants of Lower material/Fatigue", tables["pad"])
        self.assertEqual(worst(tables["specimen"])["Crossland"][1], "lower body")
        self.assertEqual(worst(tables["pad"])["Crossland"][1], "body")
        shares = {run: float(next(row for row in text.splitlines() if row.startswith("Crossland")).split()[3])
                  for run, text in tables.items()}
        ratio = 1.2 / 2  # of the limits: torsion over bending
        for run, limit in (("specimen", 400), ("pad", 40)):
            at_limit = limit / math.sqrt(3) + (3 * ratio - math.sqrt(3)) * limit / 3
            self.assertAlmostEqual(shares[run] * at_limit / worst(tables[run])["Crossland"][0], 1, delta=2e-3)

    def test_what_is_not_settled_and_lines(self):
        """One cycle from rest: a warning. Lines have the stress of the bodies."""
        deep = f"Output/Lines=deep: {-HALF_WIDTH} 0 -0.001 to {-HALF_WIDTH} 0 -0.4, 41"
        self.run_done("run", RIG, *COARSE, legs(155, 100), "Load program/Cycles=1", deep)
        result = self.tool("run")
        self.assertEqual(result.returncode, 0)
        self.assertRegex(result.stderr, r"^fatigue: warning: run: cycle 1 is not settled [^\n]*Load program/Cycles[^\n]*\n$")
        self.assertIn("\nalong lines:\n", result.stdout)
        mean = self.tables("run", "--steps", "5:12", "--critical-distance", "0.05", "--method", "point")
        self.assertIn("\nstress in the depth of 0.025 mm from the first ends of lines:\n", mean)
        self.assertEqual(RunFolder(self.folder / "run").line_names(), ["deep"])


class SolidTest(FatigueTest):
    def test_halves_and_quarters_are_the_whole(self):
        settings = [*SMALL, *FIELDS, "Load program/Legs=0 0 -0.1 : 2; 0 0 -0.05 : 2", "Load program/Cycles=2",
                    "Contact solver/Tolerance=1e-12"]
        found = {}
        for model in ("full", "half", "quarter"):
            self.run_done(model, self.FILE, *settings, f"Mesh/Model={model}")
            text = self.tables(model, "--steps", "5:8", "--parameters", "findley,crossland,dang_van,fatemi_socie")
            self.assertEqual("mirror images" in text, model != "full")
            found[model] = worst(text)
        for name, whole in found["full"].items():
            for model in ("half", "quarter"):
                part = found[model][name]
                self.assertAlmostEqual(part[0] / whole[0], 1, delta=2e-4, msg=name)
                self.assertAlmostEqual(np.hypot(*part[2:4]), np.hypot(*whole[2:4]), delta=0.01, msg=name)

    def test_axisymmetric(self):
        """A section (r, z) that is pressed and released: its fields lie in y = 0."""
        self.run_done("run", self.FILE, "Mesh/Core cells=2", "Mesh/Layers=2", "Friction/Coefficients=0.2, 0.2", *FIELDS,
                      "Friction/Slip potential=0.2, 0.2", "Load program/Legs=0 0 -0.1 : 2; 0 0 -0.05 : 2")
        self.assertEqual(RunFolder(self.folder / "run").summary["model"]["kind"], "axisymmetric")
        self.assertGreater(len(worst(self.tool("run").stdout)), 3)
        self.assertEqual(np.abs(Vtu(self.folder / "run/fatigue.vtu").points[:, 1]).max(), 0)


class HalfSpaceTest(FatigueTest):
    """A half-space has no volume files: its lines alone are evaluated."""
    BALL = program.ROOT / "prm/verification/hertz.prm"
    SETTINGS = ["Geometry/Shape=half-space", "Geometry/Sizes=1.2, 1.2", "Mesh/Cells=64, 64",
                "Load program/Legs=Fz -384.615 : 1 ; Fz 0 : 1"]
    LINE = ["Output/Lines=beside: 0.6 0 0 to 0.6 0 0.2, 11", "Output/Line fields=1"]

    def test_the_tension_beside_a_ball_is_that_of_hertz(self):
        """At the distance r it is (1 - 2 nu)/3 p0 (a / r)^2 outwards, and as much pressure around: when the ball is lifted, the
        parameter of Smith, Watson and Topper is its square times (1 + nu)/(2 E)."""
        self.run_done("run", self.BALL, *self.SETTINGS, *self.LINE)
        text = self.tables("run", "--steps", "1:2", "--parameters", "swt")
        tension = (1 - 2 * POISSON) / 3 * 734.56 * (0.5 / 0.6)**2
        found = float(re.search(r"Smith-Watson-Topper +([0-9.e-]+) MPa", text)[1])
        self.assertAlmostEqual(found / (tension**2 * (1 + POISSON) / (2 * YOUNG)), 1, delta=3e-3)
        self.assertFalse((self.folder / "run/fatigue.vtu").exists())
        self.refused(WRONG_INPUT, "--picture draws their fields", "run", "--steps", "1:2", "--picture", "x.png")

    def test_without_lines_says_which_entries_are_missing(self):
        self.run_done("run", self.BALL, *self.SETTINGS)
        self.refused(WRONG_INPUT, "is of a half-space, which has no volume files: set Output/Lines from the surface down and "
                                  "Output/Line fields = 1 and run again", "run", "--steps", "1:2")


class RefusedTest(FatigueTest):
    SETTINGS = [*SMALL, "Load program/Legs=0 0 -0.1 : 2; 0 0 -0.05 : 2", "Load program/Cycles=1"]

    def test_runs_with_too_few_steps(self):
        self.run_done("run", self.FILE, *self.SETTINGS, "Output/Volume fields=4", "Output/Contact fields=1")
        self.refused(WRONG_INPUT, "run: has volume files of 1 of the 4 steps 1 to 4: set Output/Volume fields = 1 and run again", "run")
        self.run_done("run", self.FILE, *self.SETTINGS, "Output/Volume fields=1", "Output/Contact fields=0")
        self.refused(WRONG_INPUT, "run: has contact files of 0 of the 4 steps 1 to 4: set Output/Contact fields = 1 and run again", "run")
        self.refused(WRONG_INPUT, "has volume files of 4 of the 8 steps 1 to 8", "run", "--steps", "1:8")
        self.refused(FILE_ERROR, "nowhere: no such folder", "nowhere")

    def test_wrong_words_and_constants(self):
        self.run_done("run", self.FILE, *self.SETTINGS, *FIELDS)
        for words, message in ((("--steps", "8"), "allowed is FIRST:LAST"), (("--parameters", "goodman"), "'goodman': allowed are swt"),
                               (("--picture", "x.pdf"), "end with .png or .svg"), (("--critical-distance", "-1"), "a number > 0"),
                               (("--within", "nan"), "a number > 0"), (("--plane-step", "90"), "0.5 to 30 degrees"),
                               (("--output", "x.txt"), "end with .vtu"),
                               (("--critical-distance", "0.1"), "needs Output/Lines from the surface into the body")):
            self.refused(WRONG_INPUT, message, "run", *words)
        for text, message in (('{"limit": 1}', "'limit' is no constant: allowed are name, bending_limit"),
                              ('{"bending_limit": "high"}', "bending_limit is no number"), ('{"yield_stress": 0}', "allowed is a number > 0"),
                              ('{"bending_limit": 300, "torsion_limit": 100}', "allowed are 0.5 up to 1"),
                              ('{"young_modulus": 1, "poisson_ratio": 0.5}', "allowed is a number below 0.5")):
            (self.folder / "own.json").write_text(text)
            self.refused(WRONG_INPUT, message, "run", "--material", "own.json")
        (self.folder / "own.json").write_text("[1]")
        self.refused(FILE_ERROR, "own.json: is no JSON", "run", "--material", "own.json")

    def test_damaged_files(self):
        self.run_done("run", self.FILE, *self.SETTINGS, *FIELDS)
        file = self.folder / "run/volume-0003.vtu"
        text = file.read_text(encoding="ascii")
        file.write_text(text.replace('"stress"', '"other"'), encoding="ascii")
        self.refused(FILE_ERROR, "volume-0003.vtu: has no field 'stress'", "run")
        file.write_text(text[:len(text) // 2], encoding="ascii")
        self.refused(FILE_ERROR, "volume-0003.vtu: not a .vtu file of a run", "run")
        file.unlink()
        os.mkfifo(file)
        self.refused(FILE_ERROR, "is no ordinary file, but a pipe", "run")


if __name__ == "__main__":
    main()
