# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What summary, tables and progress lines report of the scene: body, program, and what moves when.

Usage: test_scene_report.py PROGRAM [unittest options]"""
import json
import math
import re
import subprocess
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
from program import PROGRAM, RunTest, SMALL, main  # noqa: E402

DONE = 0


class SceneTest(RunTest):
    def run_with(self, *settings):
        result = self.run_program("run", settings=[*SMALL, *settings])
        self.assertEqual((result.returncode, result.stderr), (DONE, ""))
        return (self.folder / "run/log.txt").read_text()

    def test_summary_states_the_scene(self):
        """A reader need not guess body, program and units from other files."""
        for model in ("full", "quarter"):
            self.run_with("Mesh/Core cells=6", "Geometry/Radius=12", f"Mesh/Model={model}", "Load program/Cycles=1")
            summary = json.loads((self.folder / "run/summary.json").read_text())
            scene = summary["scene"]
            self.assertEqual(scene["outline"], {"shape": "disc", "radius_mm": 12})
            self.assertAlmostEqual(scene["area_mm2"] / (math.pi * 144), 1, delta=0.02)
            self.assertEqual(scene["legs"], "0 0 -0.1 : 5; 0 0 0 : 10")
            self.assertEqual((scene["preload"], scene["cycles"]), ("", 1))
            self.assertEqual(scene["friction"], summary["friction"])
            self.assertEqual(scene["units"]["force"], "N")

    def test_rows_and_lines_say_what_moves_when(self):
        log = self.run_with("Load program/Preload=0 0 -0.1 : 2", "Load program/Cycles=2",
                            "Load program/Legs=0.01 0 -0.1 : 2 ; 0 0 -0.1 : 1")
        rows = self.rows("run")
        self.assertEqual([row["cycle"] + row["phase"] for row in rows], ["00", "01", "10", "11", "12", "20", "21", "22"])
        self.assertEqual({row["driven"] for row in rows}, {"ux uy uz"})
        for row in rows:  # of a half, which has the moment about the normal of its plane alone
            self.assertEqual([row[name] for name in ("rx", "ry", "rz", "moment_x", "moment_z")], ["0"] * 5)
        # Friction pulls at the height of the plane, 10 mm below the centre, but the pressure moves with it.
        self.assertGreater(float(rows[3]["moment_y"]), 1000)
        self.assertLess(float(rows[3]["force_x"]), -1000)
        self.assertRegex(log, r"\nstep 4 of 8, .* s left: ux 0\.01 mm, uz -0\.1 mm, open/stick/slip ")

    def test_slips_that_leave_the_gap_behind_are_warned_of(self):
        """Gap and friction are taken at the reference position: for slips up to a tenth of what they vary over, here a
        wave of 20 mm whose range is 20 mm / pi times its slope."""
        wave = "Obstacle/Gap=0.001*(1+cos(pi*x/10))"
        for way, is_warned in ((0.1, False), (2, True)):
            log = self.run_with(wave, "Mesh/Model=full", "Load program/Cycles=1", "Mesh/Core cells=8",
                                f"Load program/Legs=uz -0.1 : 1 ; ux {way} : 1")
            warned = re.search(r"warning: load step 2: a node slips by (\d+) % of the length over which gap or friction "
                               r"change there; both are taken at the reference position", log)
            self.assertEqual(bool(warned), is_warned, log)
        self.assertAlmostEqual(float(warned[1]), 100 * way * math.pi / 20, delta=10)

    def test_the_time_of_a_check_says_that_jumps_take_none(self):
        wear = ["Wear/Law=energy", "Wear/Coefficient=1e-6"]
        time = r"^time +about \S+ s{}: set-up .* s, {} load steps of .* s \(to a factor of 3\)$"
        jumped = r", and \S+ s if no cycle is jumped"
        cycles = ["Load program/Preload=", "Load program/Legs=0 0 -0.1 : 2 ; 0 0 -0.05 : 2", "Load program/Cycles=100000"]
        for settings, expected in (
                ([*wear, *cycles], time.format("", "400000")),
                # Two cycles before a jump, and the last one; one in 101.
                ([*wear, *cycles, "Wear/Largest depth of a jump=1e-5"], time.format(jumped, "12 to 400000")),
                ([*cycles, "Load program/Jump when periodic=1e-6"], time.format(jumped, "3968 to 400000"))):
            words = [f"--set={setting}" for setting in settings]
            result = subprocess.run([PROGRAM, self.FILE, "--check", *words], capture_output=True, text=True, check=True)
            self.assertRegex(result.stdout, "(?m)" + expected)

    def test_lines_keep_their_words_where_the_body_is_only_pressed(self):
        self.assertRegex(self.run_with(), r"\nstep 4 of 45, .* s left: u_z -0\.08 mm, open/stick/slip ")

    def test_a_guided_face_drives_one_component(self):
        self.run_with("Geometry/Top face=guided", "Load program/Cycles=1")
        self.assertEqual({row["driven"] for row in self.rows("run")}, {"uz"})


if __name__ == "__main__":
    main()
