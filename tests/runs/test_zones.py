# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Warnings of zones that the mesh does not resolve, of rims that touch, and of states that the theory is not good for.

Usage: test_zones.py PROGRAM [unittest options]"""
import json
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
from program import ROOT, RunTest, main  # noqa: E402

CASE_B = ROOT / "prm/paper/case_b.prm"
QUIET = ["Output/Contact fields=0", "Output/Volume fields=0", "Load program/Cycles=1"]
SMALL = [*QUIET, "Mesh/Core cells=4", "Mesh/Layers=2", "Mesh/Rings=2"]
SPHERE = "Obstacle/Gap=(x^2+y^2)/{}"  # twice its radius, mm


class ZonesTest(RunTest):
    def warnings(self, *settings, file=CASE_B, code=0):
        result = self.run_program("run", settings=settings, file=file)
        self.assertEqual(result.returncode, code, result.stderr)
        warnings = json.loads((self.folder / "run/summary.json").read_text(encoding="utf-8"))["warnings"]
        if code == 0:
            log = (self.folder / "run/log.txt").read_text(encoding="utf-8")
            for warning in warnings:
                self.assertEqual(log.count("warning: " + warning), 1, log)
        return warnings

    def assert_named(self, warnings, words):
        self.assertEqual(len([warning for warning in warnings if words in warning]), 1, warnings)

    def test_a_sphere_on_a_mesh_for_a_flat_base(self):
        coarse = ["Mesh/Core cells=4", "Mesh/Rings=3", "Mesh/Layers=6", "Mesh/Degree=3", "Mesh/Core ratio=0.6",
                  "Mesh/Rim grading=0.4", "Mesh/Layer grading=0.5"]
        sphere = [SPHERE.format(20), "Load program/Legs=Fz -20 : 1"]
        warnings = self.warnings(*QUIET, *coarse, *sphere)
        self.assert_named(warnings, "the contact is one node spacing wide")
        self.assert_named(warnings, "Mesh/Resolution = custom")
        self.assert_named(warnings, "the layer of cells at the contact is 0.71 mm high")
        self.assertEqual(self.warnings(*QUIET, "Mesh/Resolution=coarse", *sphere), [])
        self.assertFalse([warning for warning in warnings if "rim" in warning], warnings)

    def test_bodies_that_never_touch_are_warned_of(self):
        warnings = self.warnings(*SMALL, "Mesh/Degree=1", "Obstacle/Gap=0.5+x^2/1000", "Load program/Legs=0 0 -0.1 : 1")
        self.assert_named(warnings, "the bodies do not touch in any load step")

    def test_the_rim_is_warned_of_where_it_touches(self):
        gap = [*SMALL, "Mesh/Degree=1", SPHERE.format(4000)]
        self.assertFalse([w for w in self.warnings(*gap, "Load program/Legs=Fz -200 : 1") if "the rim" in w])
        self.assert_named(self.warnings(*gap, "Load program/Legs=Fz -2e5 : 1"), "do not resolve the rim")

    def test_complete_contact_is_not_warned_of(self):
        """It sticks, slips, opens at its rim and at last everywhere, on meshes of few nodes."""
        for name in ("a", "b", "c"):
            for degree in (1, 2):
                with self.subTest(case=name, degree=degree):
                    warnings = self.warnings(*SMALL, f"Mesh/Degree={degree}", file=ROOT / f"prm/paper/case_{name}.prm")
                    self.assertFalse([warning for warning in warnings if "node spacing" in warning], warnings)

    def test_strains_are_judged_by_the_state(self):
        """The same strain by motion, force and gap; flat bodies stop the run."""
        force = 0.1 * 210000 * 314
        for settings in (["Load program/Legs=0 0 -1 : 1"], [f"Load program/Legs=Fz -{force:.3g} : 1"],
                         ["Obstacle/Gap=-1", "Load program/Legs=0 0 0 : 1"]):
            with self.subTest(settings=settings):
                self.assert_named(self.warnings(*SMALL, "Mesh/Degree=1", *settings), "% of the body's height")
        for settings in (["Load program/Legs=Fz -1e30 : 1"], ["Obstacle/Gap=-20", "Load program/Legs=0 0 0 : 1"]):
            with self.subTest(settings=settings):
                self.warnings(*SMALL, "Mesh/Degree=1", *settings, code=3)


if __name__ == "__main__":
    main()
