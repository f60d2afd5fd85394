# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Output/Problems: files of contact problems that orthocone-solve reads, judges as the program did, and solves again.

Usage: test_step_problems.py PROGRAM [unittest options]"""
import pathlib
import subprocess
import sys

import meshio
import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
import program  # noqa: E402
from program import PROGRAM, ROOT, SMALL, main  # noqa: E402

sys.path.insert(0, str(ROOT / "tools/studies/peers"))
import fclib_files  # noqa: E402

SOLVE = pathlib.Path(PROGRAM).resolve().parent / "orthocone-solve"
PRESS_AND_TURN = "Load program/Legs=0 0 -0.1 : 2 ; 0.01 0.004 -0.1 : 2"
FULL = [*SMALL, "Mesh/Model=full", PRESS_AND_TURN]
TOLERANCE = 1e-11  # a slip rule far from the cone makes a hundred times as much of it in the forces

# Every kind of scene that has a compliance W: settings beside the coarse mesh of case B.
SCENES = {
    "quarter": ["Mesh/Model=quarter"],
    "half": ["Mesh/Model=half", "Load program/Legs=0 0 -0.1 : 2 ; 0.01 0 -0.1 : 2"],
    "isotropic": ["Mesh/Model=full", "Friction/Coefficients=0.2, 0.2", "Friction/Slip potential=associated", PRESS_AND_TURN],
    "orthotropic": ["Mesh/Model=full", PRESS_AND_TURN],
    "not associated": ["Mesh/Model=full", "Friction/Slip potential=0.05, 0.2", PRESS_AND_TURN],
    "frictionless": ["Mesh/Model=full", "Friction/Coefficients=0, 0", "Friction/Slip potential=associated", PRESS_AND_TURN],
    "forces": ["Mesh/Model=full", "Load program/Legs=uz -0.05 : 1 ; Fz -5e5 Mx 1e5 : 2 ; Fx 2e4 : 2"],
    "released": ["Mesh/Model=full", "Load program/Legs=uz -0.05 : 2 ; Fz 0 : 2"],
    "gap": ["Mesh/Model=full", "Obstacle/Gap=(x^2+y^2)/2000", PRESS_AND_TURN],
    "friction field": ["Mesh/Model=full", "Friction/Coefficients=0.2+0.01*x, 0.2", "Friction/Orthotropy angle=5*y",
                       "Friction/Slip potential=associated", PRESS_AND_TURN],
    "half-space": ["Mesh/Model=full", "Obstacle/Kind=half-space", PRESS_AND_TURN],
    "parts": ["Mesh/Model=full", "Load program/Legs=0 0 -0.1 : 2 * 3 ; 0.01 0 -0.1 : 1 * 4"],
    "wear": ["Mesh/Model=full", "Wear/Law=archard", "Wear/Coefficient=1e-4", PRESS_AND_TURN],
}


class StepProblemsTest(program.RunTest):
    def done(self, name, *arguments, settings, file=None):
        result = self.run_program(name, *arguments, settings=[*settings, f"Contact solver/Tolerance={TOLERANCE}"], file=file)
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def row(self, file, *options):
        result = subprocess.run([SOLVE, file, "--csv", *options], text=True, capture_output=True, timeout=120, check=False)
        self.assertEqual((result.returncode, result.stderr), (0, ""), file)
        names, values = result.stdout.splitlines()
        return dict(zip(names.split(","), values.split(",")))

    def files(self, name):
        return sorted((self.folder / name).glob("problem-*"))

    def assert_same_when_solved_again(self, file):
        """The stored solution is one; solving finds its forces."""
        row = self.row(file, "--stored", "--tolerance=1e-9")
        self.assertLessEqual(float(row["residual"]), 1.01 * TOLERANCE)
        self.assertEqual(row["method"], "stored")
        again = file.with_suffix(".again")
        self.row(file, "--tolerance=1e-12", "--write", again)
        stored, solved = fclib_files.Read(file), fclib_files.Read(again)
        self.assertLess(stored.error, 1e-7)
        size = max(np.abs(stored.r).max(), 1e-300)
        self.assertLess(np.abs(solved.r - stored.r).max() / size, 1e-8)
        np.testing.assert_allclose(stored.W, solved.W, rtol=1e-13, atol=0)

    def test_scenes(self):
        for name, settings in SCENES.items():
            with self.subTest(name):
                self.done(name, settings=[*SMALL, "Load program/Cycles=1", "Output/Problems=1", *settings])
                files = self.files(name)
                self.assertEqual([f"problem-{row['step'].zfill(4)}.hdf5" for row in self.rows(name)],
                                 [file.name for file in files])
                for file in files:
                    self.assert_same_when_solved_again(file)

    def test_two_bodies(self):
        settings = ["Mesh/Core cells=4", "Mesh/Rings=3", "Mesh/Layers=3", "Lower mesh/Core cells=2", "Lower mesh/Rings=4",
                    "Lower mesh/Layers=3", "Load program/Legs=0 0 -0.1 : 2", "Output/Problems=2"]
        self.done("two", settings=settings, file=ROOT / "prm/two_bodies/steel_on_aluminium.prm")
        self.assertEqual([file.name for file in self.files("two")], ["problem-0002.hdf5"])
        self.assert_same_when_solved_again(self.files("two")[0])

    def test_what_is_in_a_file(self):
        """Forces are those of the fields, displacements the gap and the slip of the step, the title says which step."""
        self.done("run", settings=[*FULL, "Load program/Cycles=1", "Output/Problems=2", "Output/Contact fields=1",
                                   "Friction/Coefficients=0.2, 0.2", "Friction/Slip potential=associated"])
        self.assertEqual([file.name for file in self.files("run")], ["problem-0002.hdf5", "problem-0004.hdf5"])
        fields = [meshio.read(self.folder / "run" / f"contact-{step:04}.vtu").point_data for step in (3, 4)]
        read = fclib_files.Read(self.folder / "run/problem-0004.hdf5")
        force = read.r.reshape(-1, 3)[:, [1, 2, 0]]
        self.assertAlmostEqual(force[:, 2].sum(), float(self.rows("run")[3]["force_z"]), delta=1e-6 * force[:, 2].sum())
        expected = np.sort(fields[1]["nodal_force"], axis=0)
        np.testing.assert_allclose(np.sort(force, axis=0), expected, atol=1e-6 * np.abs(expected).max())
        slip = np.hypot(*(fields[1]["displacement"] - fields[0]["displacement"])[:, :2].T)  # of open nodes, too
        np.testing.assert_allclose(np.sort(np.hypot(*read.u.reshape(-1, 3)[:, 1:].T)), np.sort(slip), atol=1e-8)
        np.testing.assert_allclose(read.u, read.q + read.W @ read.r, atol=1e-12)
        self.assertIn(b"load step 4", (self.folder / "run/problem-0004.hdf5").read_bytes())

    def failed(self, name, *settings):
        """The problem of the only step that few sweeps do not solve."""
        result = self.run_program(name, settings=[*FULL, "Load program/Cycles=1", "Friction/Slip potential=0.05, 0.2",
                                                  f"Contact solver/Tolerance={TOLERANCE}", "Contact solver/Method=gauss-seidel",
                                                  *settings])
        self.assertEqual(result.returncode, 3, result.stderr)
        step = len(self.rows(name)) + 1
        self.assertIn(f"load step {step} ", result.stderr)
        return self.folder / name / f"problem-{step:04}.hdf5"

    def test_unsolved_step(self):
        """Its problem is that of the whole step, as a later attempt solves it; nobody has solved it before."""
        file = self.failed("run", "Contact solver/Maximum iterations=40", "Output/Problems=100")
        self.assertEqual(self.files("run"), [file])
        self.assertEqual(file.name, "problem-0003.hdf5")
        self.assertIn(b"load step 3, which is not solved", file.read_bytes())
        kept = self.folder / "kept"
        kept.write_bytes(file.read_bytes())
        result = subprocess.run([SOLVE, kept, "--stored"], text=True, capture_output=True, timeout=120, check=False)
        self.assertEqual((result.returncode, result.stdout), (4, ""))
        self.assertRegex(result.stderr, r"\Aorthocone-solve: .*there is no solution.*\n\Z")
        self.done("run", "--resume", settings=[*FULL, "Load program/Cycles=1", "Friction/Slip potential=0.05, 0.2",
                                               "Contact solver/Method=newton", "Output/Problems=1"])
        self.row(kept, "--tolerance=1e-12", "--write", self.folder / "again")
        unsolved, later, again = (fclib_files.Read(path, path != kept) for path in (kept, file, self.folder / "again"))
        np.testing.assert_allclose(unsolved.W, later.W, rtol=1e-14)
        np.testing.assert_allclose(unsolved.q, later.q, atol=1e-7 * np.abs(later.q).max())  # two methods, steps 1 and 2
        np.testing.assert_allclose(again.r, later.r, atol=1e-5 * np.abs(later.r).max())

    def test_unsolved_part(self):
        file = self.failed("run", "Contact solver/Maximum iterations=40", "Output/Problems=100",
                           "Load program/Legs=0 0 -0.1 : 2 ; 0.01 0.004 -0.1 : 1 * 2")
        self.assertIn(b"of which a part is not solved", file.read_bytes())

    def test_unsolved_step_without_problems(self):
        self.failed("run", "Contact solver/Maximum iterations=40", "Output/Problems=0")
        self.assertEqual(self.files("run"), [])

    def test_step_from_no_force(self):
        """Neither from the state before nor in parts is its last step solved within so many iterations; from no force it is.
        Which limit shows it depends on the rounding of the processor's BLAS."""
        scene = ["Friction/Coefficients=0.147917, 0.0877833", "Friction/Slip potential=1, 2.94685", "Friction/Orthotropy angle=45",
                 "Load program/Legs=0 0 -0.0730171 : 5 ; 0.0146034 0 -0.0730171 : 3 ; 0.0146034 0.0146034 -0.0730171 : 3",
                 "Load program/Cycles=1", "Geometry/Height=7.30171", "Material/Poisson ratio=0.49", "Mesh/Core cells=2",
                 "Mesh/Rings=1", "Mesh/Layers=2", "Mesh/Degree=3", "Mesh/Rim grading=0.480742", "Mesh/Layer grading=0.738882"]
        for most in (40, 50):
            result = self.run_program("run", file=ROOT / "prm/paper/scene.prm",
                                      settings=[*scene, f"Contact solver/Maximum iterations={most}", "Output/Problems=1"])
            if result.returncode == 0 and int(self.rows("run")[-1]["iterations"]) > 2 * most:  # of the ways before
                break
        else:
            self.fail(f"no step is solved from no force: {result.stderr}")
        self.assertEqual(len(self.files("run")), 11)
        for file in self.files("run"):
            self.row(file, "--stored", "--tolerance=1e-10")

    def test_parts_are_reported(self):
        self.done("run", settings=[*SMALL, "Mesh/Model=full", "Output/Problems=1", "Load program/Legs=0 0 -0.1 : 1 * 3",
                                   "Load program/Cycles=1"])
        self.assertIn(b"the last of the 3 parts", (self.folder / "run/problem-0001.hdf5").read_bytes())

    def test_never_by_default(self):
        self.done("run", settings=[*FULL, "Load program/Cycles=1"])
        self.assertEqual(self.files("run"), [])

    def test_results_do_not_depend_on_it(self):
        for n in (0, 1):
            self.done(str(n), settings=[*FULL, "Load program/Cycles=1", f"Output/Problems={n}"])
        self.assert_same_files("0", "1", ["history.csv", "contact-0004.vtu"])

    def test_resumed_and_replaced(self):
        """A run that goes on may begin to write them; a new run takes those of an old one away."""
        self.done("run", settings=[*FULL, "Load program/Cycles=1"])
        self.done("run", "--resume", settings=[*FULL, "Load program/Cycles=2", "Output/Problems=1"])
        self.assertEqual([file.name for file in self.files("run")], [f"problem-{step:04}.hdf5" for step in range(5, 9)])
        self.done("run", settings=[*FULL, "Load program/Cycles=1"])
        self.assertEqual(self.files("run"), [])

    def test_same_bytes_after_a_kill(self):
        settings = [*FULL, "Load program/Cycles=20", "Output/Problems=1", "Output/Checkpoint=0",
                    f"Contact solver/Tolerance={TOLERANCE}"]
        self.kill_after("killed", settings, 1.0)
        self.done("killed", "--resume", settings=settings)
        self.done("whole", settings=settings)
        self.assertEqual(len(self.files("whole")), 80)
        for file in self.files("whole"):
            read, other = fclib_files.Read(file), fclib_files.Read(self.folder / "killed" / file.name)
            np.testing.assert_array_equal(read.r, other.r)
            np.testing.assert_array_equal(read.q, other.q)

    def test_a_file_of_that_name_is_not_lost(self):
        (self.folder / "run").mkdir()
        (self.folder / "run/problem-0002.hdf5").write_text("mine")
        result = self.run_program("run", settings=[*FULL, "Output/Problems=1"])
        self.assertEqual(result.returncode, 4, result.stderr)
        self.assertIn("problem-0002.hdf5", result.stderr)
        self.assertEqual((self.folder / "run/problem-0002.hdf5").read_text(), "mine")

    def test_nothing_to_judge(self):
        W, q = np.eye(3), np.array([-1., 0, 0])
        fclib_files.write(self.folder / "bare", W, q, np.array([0.3]))
        result = subprocess.run([SOLVE, self.folder / "bare", "--stored"], text=True, capture_output=True, check=False)
        self.assertEqual(result.returncode, 4)
        self.assertRegex(result.stderr, r"\Aorthocone-solve: .*there is no solution.*\n\Z")


if __name__ == "__main__":
    main()
