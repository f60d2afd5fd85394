# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Every scene of prm/paper and prm/verification: multigrid finds the states of a factorization, or says why it cannot.

Usage: test_multigrid_files.py PROGRAM [unittest options]"""
import json
import re
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
from multigrid_scenes import differences, numbers  # noqa: E402
from program import ROOT, RunTest, main  # noqa: E402
from resumed_runs import DONE, WRONG_INPUT  # noqa: E402

FILES = {f"{folder}/{file.stem}": file for folder in ("paper", "verification")
         for file in sorted((ROOT / "prm" / folder).glob("*.prm")) if file.stem not in ("scene", "bricks")}
# Coarse, but graded as the files have it.
CYLINDER = ["Mesh/Core cells=2", "Mesh/Rings=2", "Mesh/Layers=2", "Mesh/Refinements=1"]
BOX = ["Mesh/Cells=2, 2, 2", "Mesh/Refinements=1"]
# Neither shape nor load is its own mirror image about both planes.
NO_QUARTER = {f"verification/{name}" for name in (
    "cattaneo_line", "cattaneo_mindlin", "equal_spheres", "first_slip_in_torsion", "fretting_fatigue", "fretting_wear",
    "groove", "gross_sliding", "gross_sliding_by_force", "incline", "line_contact", "orthotropic_line_contact",
    "orthotropic_sphere",
    "pressed_by_force", "pressed_sphere_in_torsion", "pushed_block", "roller_on_block", "rounded_punch", "tilted_punch",
    "torsion", "wedge", "worn_punch", "worn_sphere")}
# Wear wants steps as short as those of the files.
WORN = {"verification/worn_punch": ["Load program/Legs=Fz -1000 : 1 ; ux 3 : 3"],
        "verification/worn_sphere": ["Load program/Legs=ux 0.1 : 2 ; ux 0 : 2"]}
PLANE = "Mesh/Backend = multigrid with Geometry/Kind = plane strain"
BODY = "Obstacle/Kind = body with Mesh/Backend = multigrid"
REFUSED = {f"verification/{name}": reason for reason, names in (
    ("Mesh/Backend = multigrid with Geometry/Shape = half-space", ("ball_on_plate", "wavy_surface")),
    ("Mesh/Backend = multigrid with a normal of the counterface that is more than 70 degrees off z", ("press_fit",)),
    (BODY, ("cattaneo_line", "filleted_punch", "fretting_fatigue", "roller_on_block", "two_balls")),
    (PLANE, ("line_contact", "orthotropic_line_contact", "pushed_block", "rounded_punch"))) for name in names}
# Fewer steps, a push that finds an equilibrium, a degree that solids have. At nu = 0.4999 the few cells of the twisted sphere,
# ten times as high as wide, are what multigrid's message says it does not solve.
OTHERS = {"verification/pressed_sphere_in_torsion": ["Material/Poisson ratio=0.45"],
          "verification/spence": ["Load program/Legs=Fz -0.4705 : 2"],
          "verification/wedge": ["Load program/Legs=Fz -1024.888306 Fx 199 : 2"],
          "verification/pressed_square": ["Mesh/Refinements=0"],  # its file has many cells
          "verification/short_cylinder": ["Mesh/Degree=3"]}


def text_of(file):
    """With all that it includes."""
    return re.sub(r"^include (.*)$", lambda match: text_of(file.parent / match[1]), file.read_text(), flags=re.MULTILINE)


def short(file):
    """A coarse mesh, one cycle, two steps a leg."""
    text = text_of(file)
    legs = {entry: re.findall(rf"set {entry} *= ([^#\n]*)", text)[-1:] for entry in ("Preload", "Legs")}
    return [*(BOX if "= box" in text else CYLINDER), "Load program/Cycles=1",
            *(f"Load program/{entry}=" + re.sub(r": \d+", ": 2", found[0]) for entry, found in legs.items() if found)]


class EveryFileTest(RunTest):
    def run_file(self, name, backend):
        model = "full" if "torsion" in name else "auto" if name in NO_QUARTER else "quarter"
        return self.run_program(backend, file=FILES[name], settings=[
            *short(FILES[name]), *WORN.get(name, []), *OTHERS.get(name, []), f"Mesh/Model={model}", f"Mesh/Backend={backend}",
            "Output/Volume fields=0", "Output/Contact fields=0"])

    def solved(self, name, backend):
        result = self.run_file(name, backend)
        self.assertEqual((result.returncode, result.stderr), (DONE, ""))
        summary = json.loads((self.folder / backend / "summary.json").read_text())
        self.assertEqual("v_cycles" in summary["contact_solver"], backend == "multigrid")
        return numbers(self.rows(backend))

    def test_same_states(self):
        """What differences() compares, to ten times the tolerance of its scale."""
        for name in FILES.keys() - REFUSED.keys():
            with self.subTest(file=name):
                condensed, multigrid = (self.solved(name, backend) for backend in ("condensed", "multigrid"))
                self.assertEqual(condensed["cycle"], multigrid["cycle"])
                for column, difference in differences(condensed, multigrid).items():
                    self.assertLessEqual(difference, 10, column)

    def test_what_cannot_be_solved_is_refused(self):
        for name, reason in REFUSED.items():
            with self.subTest(file=name):
                result = self.run_file(name, "multigrid")
                self.assertEqual((result.returncode, result.stderr.count("\n")), (WRONG_INPUT, 1))
                self.assertRegex(result.stderr, f"{reason}.*: allowed is ")

    def test_a_quarter_is_taken_where_it_can_be(self):
        for name in NO_QUARTER:
            with self.subTest(file=name):
                result = self.run_program("run", "--check", file=FILES[name], settings=["Mesh/Model=quarter"])
                self.assertEqual(result.returncode, WRONG_INPUT)
                self.assertIn("Mesh/Model = quarter is not possible", result.stderr)


if __name__ == "__main__":
    main()
