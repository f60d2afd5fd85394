# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""tools/identify: statistics and curves beside closed forms, a rig whose friction is known, what loops cannot tell, and what is
refused in a line.

Usage: test_identify.py PROGRAM [unittest options]"""
import json
import os
import subprocess
import sys
import unittest

import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
import program  # noqa: E402
from program import PROGRAM, ROOT, main  # noqa: E402

sys.path[:0] = [str(ROOT / "tools" / name) for name in ("studies", "identifications", "runs", "sweeps")]
import synthetic_rigs  # noqa: E402
import verdict  # noqa: E402
from loop_curves import Curves, interpolated, sense  # noqa: E402
from loop_fit import LoopFit  # noqa: E402
from measured_loops import loop_of  # noqa: E402
from statistics_of_fit import Information, proportional, student  # noqa: E402

TOOL = ROOT / "tools/identifications/identify.py"
WRONG_INPUT, UNSOLVED, FILE_ERROR = 2, 3, 4
PRESSED, STIFFNESS = 500., 2e5  # N, N/mm, of the sphere in closed form
TRUTH = {"mu_x": 0.45, "mu_y": 0.3, "slip_ratio": 0.8, "rig_compliance": 6e-6}


def mindlin(way, mu):
    """Tangential force (N) of a pressed sphere that goes a way (mm) from rest."""
    return mu * PRESSED * (1 - np.maximum(1 - way / (1.5 * mu * PRESSED / STIFFNESS), 0)**1.5)


class Sphere:
    """Stands in for the program: branches by Mindlin and Masing, along x and y."""

    def curves(self, wanted):
        return [self.one(*words) for words in wanted]

    def one(self, direction, ways, settings):
        mu = [float(word) for word in dict(text.split("=") for text in settings)["Friction/Coefficients"].split(",")]
        branches = {}
        for name, way in ways.items():
            way = np.concatenate([[0], way])
            force = mindlin(way, mu[np.argmax(direction)]) if name == "first" else 2 * mindlin(way / 2, mu[np.argmax(direction)])
            branches[name] = way, np.outer(sense(name) * force, direction)
        return Curves(np.array(direction), branches)


def sphere_loop(direction, reach, mu, compliance, seed, noise=0.02):
    """A loop of the sphere, which itself moves by +-reach (mm), behind a rig."""
    place = np.linspace(reach, -reach, 150)
    force = mindlin(reach, mu) - 2 * mindlin((reach - place) / 2, mu)
    place, force = np.concatenate([place, -place]), np.concatenate([force, -force])
    noise = noise * np.abs(force).max() * np.random.default_rng(seed).normal(size=len(force))
    motion, force = np.outer(place + compliance * force, direction).T, np.outer(force + noise, direction).T
    return loop_of(f"loop {seed}", {"ux": motion[0], "uy": motion[1], "held_force_x": force[0], "held_force_y": force[1]})


def sphere_fit(loops, names):
    entries = {"Friction": {"Coefficients": "0.5, 0.5", "Slip potential": "associated"}}
    fit = LoopFit(Sphere(), loops, names, PRESSED, entries)
    fit.solve()
    return fit


class StatisticsTest(unittest.TestCase):
    def test_quantiles_are_those_of_student(self):
        for dof, value in ((10, 2.2281), (30, 2.0423), (1000, 1.9623)):
            self.assertAlmostEqual(student(dof), value, delta=1.5e-3)

    def test_intervals_hold_the_truth_as_often_as_they_say(self):
        """Lines with noise: 95 % of the intervals, by theory and by bootstrap, hold the parameters 0."""
        chance, n, trials = np.random.default_rng(5), 60, 400
        jacobian = np.stack([np.ones(n), np.linspace(0, 1, n)], axis=1)
        inside = np.zeros((2, 2))
        for _ in range(trials):
            noise = 0.05 * chance.normal(size=n)
            estimate = np.linalg.lstsq(jacobian, noise, rcond=None)[0]
            information = Information(noise - jacobian @ estimate, jacobian)
            inside[0] += np.abs(estimate) < information.intervals()
            low, high = estimate + information.bootstrap([np.arange(n)], 200)
            inside[1] += (low < 0) & (high > 0)
        self.assertTrue(np.all(np.abs(inside[0] / trials - 0.95) < 0.03), inside)
        self.assertTrue(np.all(np.abs(inside[1] / trials - 0.93) < 0.05), inside)

    def test_wear_is_a_line_through_the_origin(self):
        energy = np.linspace(0, 1000, 50)
        volume = 2e-6 * energy + 1e-5 * np.random.default_rng(1).normal(size=50)
        slope, half = proportional(energy, volume)
        self.assertLess(abs(slope - 2e-6), half)
        self.assertLess(half, 2e-8)

    def test_cubics_are_monotone_and_exact_on_lines(self):
        t = np.array([0, 1, 3, 4, 8.])
        at = np.linspace(0, 10, 201)
        np.testing.assert_allclose(interpolated(t, np.stack([2 * t, 1 - t], axis=1), at), np.stack([2 * at, 1 - at], axis=1), atol=1e-12)
        self.assertTrue(np.all(np.diff(interpolated(t, np.array([[0.], [5], [5.1], [9], [9]]), at)[:, 0]) >= -1e-12))


class SphereTest(unittest.TestCase):
    def test_a_sphere_behind_a_spring(self):
        """Friction and spring lie in their intervals, and the slip rule, which loops along axes do not show, gets no number."""
        loops = [sphere_loop((1, 0), 6e-4, 0.45, 4e-6, 1), sphere_loop((1, 0), 4e-3, 0.45, 4e-6, 2), sphere_loop((0, 1), 4e-3, 0.3, 4e-6, 3)]
        fit = sphere_fit(loops, ["mu_x", "mu_y", "slip_ratio", "rig_compliance"])
        found = verdict.parameters(fit, 100)
        for name, value in (("mu_x", 0.45), ("mu_y", 0.3), ("rig_compliance", 4e-6)):
            low, high = found[name]["interval"]
            self.assertTrue(low < value < high, (name, found[name]))
            self.assertLess(high - low, 0.03 * value)
            self.assertAlmostEqual(np.ptp(found[name]["bootstrap"]) / (high - low), 1, delta=0.3)
        self.assertEqual((found["slip_ratio"]["identified"], found["slip_ratio"]["estimate"]), (False, None))
        self.assertEqual([fact["slides"] for fact in verdict.loop_facts(fit)], [False, True, True])

    def test_little_slip_tells_little(self):
        """A loop along x far below sliding: the spring is told, friction along y is not, and the words say why."""
        fit = sphere_fit([sphere_loop((1, 0), 1e-4, 0.45, 4e-6, 4)], ["mu_x", "mu_y", "rig_compliance"])
        found, words = verdict.parameters(fit, None), " ".join(verdict.sentences(fit, verdict.loop_facts(fit)))
        self.assertFalse(found["mu_x"]["identified"] or found["mu_y"]["identified"])
        self.assertIn("The loops do not tell mu_y", words)
        self.assertIn("no loop moves along y", words)
        self.assertIn("The loops do not tell mu_x", words)
        self.assertIn("no loop with a motion along x slides as a whole", words)

    def test_first_loading_is_left_out_and_signs_may_differ(self):
        """Rows that go up from rest to a loop do not count, whichever side the force is told from."""
        rest = np.linspace(0, 4e-3, 40)
        rows = {"ux": rest, "force_x": -mindlin(rest, 0.45)}
        loop = sphere_loop((1, 0), 4e-3, 0.45, 0, 5, noise=0)
        rows = {"ux": np.concatenate([rest, loop.place[:220]]), "force_x": -np.concatenate([mindlin(rest, 0.45), loop.force[:220, 0]])}
        found = loop_of("loop", rows)
        self.assertEqual(len(found.way), 221)  # and the turning point
        self.assertAlmostEqual(found.amplitude, 4e-3, delta=1e-12)
        np.testing.assert_allclose(found.along()[-1], loop.force[219, 0])


class ToolTest(program.RunTest):
    def tool(self, *words):
        return subprocess.run([sys.executable, TOOL, *words, "--program", PROGRAM], cwd=self.folder, text=True, capture_output=True,
                              check=False, env={**os.environ, "OPENBLAS_NUM_THREADS": "1"})

    def results(self, *words):
        result = self.tool(*words)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return json.loads((self.folder / "identified.json").read_text(encoding="utf-8")), result.stdout

    def write(self, name, motions, seed=1, **options):
        synthetic_rigs.write(self.folder / name, synthetic_rigs.loops_of(TRUTH, PROGRAM, motions, seed=seed, **options))

    def refused(self, code, words, *arguments):
        result = self.tool(*arguments)
        self.assertEqual((result.returncode, result.stdout), (code, ""), result.stderr)
        self.assertRegex(result.stderr, r"^identify: [^\n]*\n$")
        self.assertIn(words, result.stderr)


class RigTest(ToolTest):
    def test_a_rig_is_found_again(self):
        """Loops of a finer mesh with 2 % noise: friction within 1 %, the spring within 2 %, all in their intervals."""
        self.write("loops.csv", synthetic_rigs.MOTIONS)
        found, text = self.results("loops.csv", synthetic_rigs.SCENE, "--picture", "fit.png", "--bootstrap", "50")
        for name, most in (("mu_x", 0.01), ("mu_y", 0.01), ("rig_compliance", 0.02), ("slip_ratio", 0.05)):
            one = found["parameters"][name]
            self.assertAlmostEqual(one["estimate"] / TRUTH[name], 1, delta=most, msg=name)
            self.assertTrue(one["interval"][0] < TRUTH[name] < one["interval"][1], (name, one))
        self.assertAlmostEqual(found["rms"], 0.02, delta=0.002)
        self.assertIn("rig_stiffness", text)
        self.assertGreater((self.folder / "fit.png").stat().st_size, 10000)

    def test_what_loops_do_not_tell_is_said(self):
        """A small loop along x: no friction along y. Its sides lean by spring and Young's modulus alike."""
        self.write("small.csv", [(0, 0.3)], rows=80)
        found, text = self.results("small.csv", synthetic_rigs.SCENE, "--fit", "mu_y,rig_compliance,young_modulus")
        self.assertEqual([one["identified"] for one in found["parameters"].values()], [False] * 3)
        self.assertIn("The loops do not tell mu_y", text)
        self.assertIn("The loops do not tell rig_compliance and young_modulus apart", text)


class InputTest(ToolTest):
    def loops(self, name, head, *rows):
        (self.folder / name).write_text("\n".join([head, *rows]) + "\n", encoding="utf-8")
        return name

    def test_wear_alone_needs_no_run(self):
        rows = [f"{energy},{3e-6 * energy}" for energy in range(0, 1000, 50)]
        found, _ = self.results(self.loops("wear.csv", "total_dissipation,worn_volume", *rows), synthetic_rigs.SCENE)
        self.assertAlmostEqual(found["parameters"]["wear_coefficient"]["estimate"], 3e-6)

    def test_wrong_input_is_one_line(self):
        line = [f"{i / 10},{i}" for i in range(20)]
        to_and_fro = line + line[-2::-1]
        scene = synthetic_rigs.SCENE
        for words, file in (
                ("row 3, column ux: '1,5': allowed is a number", self.loops("a.csv", "ux,force_x", *line[:2], '"1,5",3', *line)),
                ("has no column of force; allowed are ux", self.loops("b.csv", "ux,F", *line)),
                ("has 5 rows; allowed are at least", self.loops("c.csv", "ux,held_force_x", *line[:5])),
                ("does not turn back", self.loops("d.csv", "ux,held_force_x", *line)),
                ("row 2 has 1 entries, not 2", self.loops("e.csv", "ux,held_force_x", line[0], "3")),
                ("loop 7: has 2 rows", self.loops("f.csv", "ux,held_force_x,loop", "1,2,7", "2,3,7")),
                ("has forces against its motion", self.loops("g.csv", "ux,force_x", *line, "0,-20", *(f"{i / 10},{i - 40}" for i in range(19, 0, -1))))):
            self.refused(WRONG_INPUT, words, file, scene)
        good = self.loops("good.csv", "ux,held_force_x", *to_and_fro)
        self.refused(WRONG_INPUT, "allowed are some of mu_x", good, scene, "--fit", "nu")
        self.refused(WRONG_INPUT, "allowed is mu, which is both", good, scene, "--fit", "mu,mu_x")
        self.refused(WRONG_INPUT, "allowed is a whole number", good, scene, "--bootstrap", "0")
        self.refused(WRONG_INPUT, "Preload", good, scene, "--set", "Load program/Preload=")
        self.refused(FILE_ERROR, "nothing.csv: No such file", "nothing.csv", scene)
        self.refused(FILE_ERROR, "nothing.prm: No such file", good, "nothing.prm")


if __name__ == "__main__":
    main()
