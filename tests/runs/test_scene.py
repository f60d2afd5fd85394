# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Scenes of the Python module: entries are read and set as the program has them, and runs end as the program does.

Usage: test_scene.py PROGRAM [unittest options]"""
import concurrent.futures
import os
import pathlib
import pickle
import shutil
import signal
import subprocess
import sys

import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
from program import PROGRAM, ROOT, SCENE, RunTest, main  # noqa: E402

sys.path.insert(0, str(ROOT / "python"))
import orthocone  # noqa: E402
from orthocone import FileError, Run, Scene, UnknownEntry, UnsolvedStep, WrongInput  # noqa: E402
from orthocone.parameter_file import entries_of, with_whole_paths  # noqa: E402

FRICTION, LEGS = "Friction/Coefficients", "Load program/Legs"
# Forms that a parameter file may have; all set Degree = 1 and the friction 0.5, 0.2.
FORMS = {"comment.prm": "subsection Friction\n  set Coefficients = 0.5, 0.2 # both\nend\nsubsection Mesh\nset Degree=1\nend",
         "lines.prm": "subsection Friction\r\n\tset Coefficients=0.5,\\ \r\n 0.2\r\nend\r\nsubsection Mesh\r\n"
                      "set Degree = 1\r\nend",
         "include.prm": "\ufeffsubsection Friction\nset Coefficients = 1, 1\nend\ninclude comment.prm",
         "object.json": '{"Friction": {"Coefficients": "0.5, 0.2"}, "Mesh": {"Degree": 1}}'}
# A run from Python that is interrupted as by a key, which terminals send to both.
CTRL_C = """import os, signal, sys, orthocone
def progress(step, steps, line):
    if step == 3:
        os.killpg(0, signal.SIGINT)
try:
    orthocone.Scene.from_file(sys.argv[1]).run("stopped", threads=1, progress=progress)
except KeyboardInterrupt as error:
    print("stopped")
"""


class SceneTest(RunTest):
    def setUp(self):
        super().setUp()
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)
        os.environ["ORTHOCONE"] = PROGRAM
        pathlib.Path("my.prm").write_text(SCENE)
        self.scene = Scene.from_file("my.prm")

    def assert_says(self, kind, words, function, *arguments, **options):
        with self.assertRaisesRegex(kind, words) as caught:
            function(*arguments, **options)
        self.assertNotIn("\n", str(caught.exception))
        return caught.exception

    def test_entries_are_read(self):
        self.assertEqual((self.scene["Mesh/Degree"], self.scene[LEGS]), ("1", "0 0 -0.1 : 2"))
        self.assertEqual((self.scene["Mesh/Resolution"], self.scene["Obstacle/Gap file"]), ("custom", ""))
        self.assertEqual(len(self.scene), len(dict(self.scene)))
        self.assertTrue(FRICTION in self.scene and "Friction/Coeficients" not in self.scene)
        for name, text in FORMS.items():
            pathlib.Path(name).write_text(text, newline="")
            with self.subTest(name):
                scene = Scene.from_file(name)
                self.assertEqual((scene[FRICTION], scene["Mesh/Degree"]), ("0.5, 0.2", "1"))
                self.assertIn("0.5, 0.2", str(scene.check()))  # the program reads the same
        self.assertEqual(Scene.from_text("include comment.prm")[FRICTION], "0.5, 0.2")

    def test_shipped_files_are_read_as_the_program_reads_them(self):
        """Each entry that a file sets is one of the program, and --defaults is read as what it is."""
        for file in sorted((ROOT / "prm").rglob("*.prm")):
            with self.subTest(file.name):
                entries = entries_of(file)
                self.assertGreater(len(entries), 0)
                self.assertEqual(entries.keys() - set(self.scene), set())
        defaults = subprocess.run([PROGRAM, "--defaults"], capture_output=True, text=True, check=True).stdout
        pathlib.Path("defaults.prm").write_text(defaults)
        self.assertEqual(dict(Scene.from_file("defaults.prm")), dict(Scene.from_text("subsection Mesh\nend")))

    def test_values_become_texts(self):
        for value, text in (((0.3, 0.15), "0.3, 0.15"), ([1, 2], "1, 2"), (np.array([0.3, 1e-5]), "0.3, 1e-05"), (2, "2"),
                            (np.float64(0.25), "0.25"), (np.int64(3), "3"), (True, "true"), (" collinear ", "collinear"),
                            (("x^2", 0.1), "x^2, 0.1")):
            self.scene[FRICTION] = value
            self.assertEqual(self.scene[FRICTION], text)
        for value in (None, 1j, {0.3}, b"0.3", [[0.3, 0.15]], np.ones((2, 2))):
            with self.subTest(value), self.assertRaisesRegex(TypeError, "^Friction/Coefficients = .*: allowed is"):
                self.scene[FRICTION] = value
        self.scene["Obstacle/Gap file"] = "gap.txt"
        self.assertEqual(self.scene["Obstacle/Gap file"], str(self.folder.resolve() / "gap.txt"))
        del self.scene[FRICTION], self.scene["Obstacle/Gap file"]
        self.assertEqual(self.scene.changes, {})

    def test_copies(self):
        changed = self.scene.with_(**{FRICTION: (0.4, 0.4)})
        twice = changed.with_({"Mesh/Degree": 2, LEGS: "0 0 -0.1 : 1"})
        self.assertEqual([scene[FRICTION] for scene in (self.scene, changed, twice)], ["0.3, 0.15", "0.4, 0.4", "0.4, 0.4"])
        self.assertEqual(len({scene._folder_name() for scene in (self.scene, changed, twice)}), 3)
        self.assertEqual(changed._folder_name(), "my,Friction.Coefficients=0.4_0.4")
        self.assertEqual(dict(pickle.loads(pickle.dumps(twice))), dict(twice))

    def test_unknown_entries(self):
        """The program's words, with its suggestions."""
        meant = f"^Friction/Coeficients is not an entry; is {FRICTION} meant\\? .*--defaults"
        scene = self.scene
        for function, arguments in ((scene.__getitem__, ()), (scene.__setitem__, (0.3,)), (scene.__delitem__, ())):
            self.assert_says(KeyError, meant, function, "Friction/Coeficients", *arguments)
        self.assert_says(UnknownEntry, f"is {FRICTION} meant", scene.__getitem__, "Coefficients")
        self.assert_says(UnknownEntry, "^3=3: allowed is", scene.with_, {3: 3})

    def test_wrong_values_and_files(self):
        self.assert_says(WrongInput, r"^--set: Friction/Coefficients = 0\.3: allowed is",
                         self.scene.with_({FRICTION: 0.3}).check)
        error = self.assert_says(ValueError, r"^bad\.prm:2: Degree = 9|^bad\.prm:2: Mesh/Degree = 9: allowed is",
                                 Scene.from_text("subsection Mesh\n set Degree = 9\nend", "bad").run)
        self.assertEqual((error.code, pathlib.Path("output").exists()), (2, False))
        self.assert_says(FileError, "none.prm: cannot be read", Scene.from_file, "none.prm")
        self.assert_says(FileError, "none.prm: cannot be read", Scene.from_text("include none.prm").__getitem__, FRICTION)
        self.assert_says(WrongInput, "spher.*is sphere_on_flat meant", Scene.rig, "spher_on_flat")
        copy = pickle.loads(pickle.dumps(error))
        self.assertEqual((type(copy), str(copy), copy.code), (WrongInput, str(error), 2))

    def test_check(self):
        check = self.scene.with_({"Wear/Deep steps": "explicit"}).check()
        self.assertRegex(str(check), "(?m)^model ")
        self.assertEqual(check.warnings[-1], "Wear/Deep steps = explicit is ignored with Wear/Law = none")

    def test_run(self):
        steps = []
        run = self.scene.run(threads=1, progress=lambda *words: steps.append(words[:2]))
        self.assertEqual((steps, str(run.path)), ([(1, 2), (2, 2)], "output/my"))
        history = Run("output/my", pandas=False).history
        self.assertEqual(history["step"].tolist(), [1, 2])
        self.assertEqual(list(run.history), list(history))
        np.testing.assert_array_equal(run.contact()["pressure"], run.contact(2)["pressure"])
        for name in self.scene:
            section, entry = name.split("/")
            if name in entries_of("my.prm"):
                self.assertEqual(run.parameters[section][entry], self.scene[name])

    def test_tables_are_those_of_pandas(self):
        try:
            import pandas
        except ImportError:
            self.skipTest("no pandas")
        run = self.scene.run()
        self.assertIsInstance(run.history, pandas.DataFrame)
        self.assertEqual((len(run.history), run.history["method"].iloc[-1]), (2, "newton"))
        self.assertEqual(len(Run(run.path, pandas=True).cycles), 1)

    def test_study(self):
        """Several at a time; each has a folder, and the force of sliding is that of its friction."""
        scene = self.scene.with_({LEGS: "Fz -1000 : 1 ; ux 1 : 1"})
        scenes = [scene.with_({FRICTION: (mu, mu)}) for mu in (0.1, 0.2)]
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            runs = list(pool.map(lambda scene: scene.run(threads=1), scenes))
        forces = [float(Run(run.path, pandas=False).history["held_force_x"][-1]) for run in runs]
        np.testing.assert_allclose(forces, [100, 200], rtol=1e-6)

    def test_unsolved_step(self):
        scene = self.scene.with_({"Contact solver/Method": "gauss-seidel", "Contact solver/Maximum iterations": 1,
                                  LEGS: "0 0 0 : 1 ; 0 0 -0.1 : 2", FRICTION: (0.3, 0.15)})
        error = self.assert_says(UnsolvedStep, "step 2", scene.run, "unsolved")
        self.assertEqual((error.code, len(error.run.history)), (3, 1))
        self.assertIn("history.csv", error.details)

    def test_interrupted_runs_go_on(self):
        scene = self.scene.with_({LEGS: "0 0 -0.1 : 60"})
        scene.run("whole", threads=1)

        def stop(step, *_):
            if step == 3:
                os.kill(os.getpid(), signal.SIGINT)
        with self.assertRaises(KeyboardInterrupt):
            scene.run("stopped", threads=1, progress=stop)
        self.assertLess(len(Run("stopped").history), 60)
        self.assertTrue(Run("stopped").summary["status"].startswith("interrupted"))
        self.assertEqual(len(scene.run("stopped", resume=True).history), 60)
        self.assert_same_files("stopped", "whole", ["history.csv"])

    def test_the_key_of_a_terminal_is_one_interruption(self):
        pathlib.Path("long.prm").write_text(SCENE.replace(": 2", ": 60"))
        done = subprocess.run([sys.executable, "-B", "-c", CTRL_C, "long.prm"], capture_output=True, text=True, check=False,
                              start_new_session=True, env={**os.environ, "PYTHONPATH": str(ROOT / "python")})
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "stopped\n", ""))
        self.assertTrue(Run("stopped").summary["status"].startswith("interrupted"))

    def test_errors_of_progress_end_the_run(self):
        self.assert_says(ZeroDivisionError, "", self.scene.run, progress=lambda step, *_: 1 // (step - 1))
        self.scene.run(resume=True)

    def test_rigs_and_texts(self):
        rig = Scene.rig("brushed_plate")
        self.assertEqual((rig.name, rig["Friction/Orthotropy angle"]), ("brushed_plate", "30"))
        first, second = Scene.from_text(SCENE), Scene.from_text(SCENE + "\n")
        self.assertNotEqual(first._folder_name(), second._folder_name())
        self.assertEqual(len(first.run().history), 2)
        with self.assertRaisesRegex(ValueError, "name = 'a/b': allowed is"):
            Scene.from_text(SCENE, "a/b")
        text = "include a.prm # one\n set Gap file = sub/gap.txt\nset Mesh file=\\\n"
        self.assertEqual(with_whole_paths(text, "/x", ["Obstacle/Gap file"]),
                         "include /x/a.prm # one\n set Gap file = /x/sub/gap.txt\nset Mesh file=\\\n")

    def test_where_the_program_is(self):
        """A copy of the module alone finds what the environment and the PATH have."""
        shutil.copytree(ROOT / "python/orthocone", "module/orthocone", ignore=shutil.ignore_patterns("__pycache__"))
        pathlib.Path("bin").mkdir()
        os.symlink(PROGRAM, "bin/orthocone")
        code = "import orthocone.program as p\ntry: print(p.find_program())\nexcept p.FileError as error: print(error)"

        def found(**variables):
            return subprocess.run([sys.executable, "-B", "-c", code], env={"PYTHONPATH": "module", **variables},
                                  capture_output=True, text=True, check=True).stdout
        self.assertEqual(found(PATH="bin", ORTHOCONE=PROGRAM), f"{PROGRAM}\n")
        self.assertEqual(found(PATH="bin"), "bin/orthocone\n")
        self.assertRegex(found(PATH="nowhere"), "^the program orthocone is neither .*ORTHOCONE names it\n$")
        self.assertRegex(found(PATH="bin", ORTHOCONE="nothing"), "^ORTHOCONE = nothing: is no program; allowed is .*\n$")

    def test_public_names(self):
        self.assertEqual([name for name in orthocone.__all__ if name not in dir(orthocone)], [])


if __name__ == "__main__":
    main()
