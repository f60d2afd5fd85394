# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""How the studies evaluate contact files between their nodes: polynomials are reproduced. And tools/study itself: points
are made once, each row redoes its point, pictures and tables are there, bad names are refused.

Usage: test_studies.py PROGRAM [unittest options]"""
import csv
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile

import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
from program import PROGRAM, ROOT, SMALL, RunTest, main  # noqa: E402

sys.path.insert(0, str(ROOT / "tools/studies"))
import paths  # noqa: E402, F401 (finds the modules of all studies)
import contact_surface  # noqa: E402
import counterbodies  # noqa: E402
import points  # noqa: E402
import wear_flicker  # noqa: E402
import wear_steps  # noqa: E402
from run_folder import ContactFile  # noqa: E402

SINGLE = 1e-6  # the files hold single precision
POINTS, WEIGHTS = contact_surface.quarter_rule()


class ContactSurfaceTest(RunTest):
    def contact_file(self, degree, model):
        settings = [*SMALL, f"Mesh/Degree={degree}", f"Mesh/Model={model}", "Load program/Legs=0 0 -0.1 : 1",
                    "Load program/Cycles=1", "Output/Volume fields=0"]
        finished = self.run_program("run", settings=settings, file=ROOT / "prm/paper/case_a.prm")
        self.assertEqual(finished.returncode, 0, finished.stderr)
        return ContactFile(pathlib.Path(self.folder) / "run/contact-0001.vtu")

    def test_solid_points_are_found_where_they_are(self):
        """Positions are polynomials of the degree of the cells; so every point inside has to find itself."""
        for degree in (1, 2, 3):
            for model in ("quarter", "full"):
                with self.subTest(degree=degree, model=model):
                    file = self.contact_file(degree, model)
                    file.data["place"] = file.points
                    file.data["plane"] = 3 + file.points @ [1., -2., 0.]
                    surface = contact_surface.SolidSurface(file)
                    inside = POINTS[np.linalg.norm(POINTS, axis=1) < 7]
                    surface.locate(inside)
                    self.assertLess(np.abs(surface["place"][:, :2] - inside).max(), 10 * SINGLE)
                    self.assertLess(np.abs(surface["plane"] - 3 - inside @ [1., -2.]).max(), 30 * SINGLE)

    def test_solid_points_beyond_the_chords_take_the_rim(self):
        surface = contact_surface.SolidSurface(self.contact_file(1, "quarter"))
        surface.locate(POINTS)
        sagitta = contact_surface.RADIUS * (1 - np.cos(np.pi / 8))  # of 8 chords
        self.assertLess(surface.distance.max(), 1.01 * sagitta)  # the nearest place but for a skew cell

    def test_solid_polynomials_of_the_cells_are_reproduced(self):
        """On the core's cells, which are squares, any polynomial of their degree, from Gauss-Lobatto nodes."""
        file = self.contact_file(3, "quarter")
        file.data["cubic"] = file.points[:, 0]**3 - file.points[:, 0] * file.points[:, 1]**2
        surface = contact_surface.SolidSurface(file)
        core = POINTS[(POINTS < 3.5).all(axis=1)]  # the core's half side is 5 / sqrt(2)
        surface.locate(core)
        self.assertLess(np.abs(surface["cubic"] - core[:, 0]**3 + core[:, 0] * core[:, 1]**2).max(), 100 * SINGLE)

    def test_revolved_polynomials_are_reproduced(self):
        for degree in (1, 2, 3, 4):
            with self.subTest(degree=degree):
                file = self.contact_file(degree, "axisymmetric")
                radius = np.linalg.norm(file.points, axis=1)
                file.data["power"] = (radius / 10)**degree
                file.data["vector"] = file.points.copy()
                surface = contact_surface.RevolvedSurface(file)
                surface.locate(POINTS)
                true = (np.linalg.norm(POINTS, axis=1) / 10)**degree
                self.assertLess(np.abs(surface["power"] - true).max(), 10 * SINGLE)
                self.assertLess(np.abs(surface["vector"][:, :2] - POINTS).max(), 30 * SINGLE)

    def test_norms_of_known_fields(self):
        self.assertAlmostEqual(WEIGHTS.sum() / (25 * np.pi), 1, 12)
        ones = np.ones(len(WEIGHTS))
        self.assertAlmostEqual(contact_surface.relative_l2(1.5 * ones, ones, WEIGHTS), 0.5, 12)
        # the norm of x - y on the quarter disc, relative to that of the radius: 1 - 2 <xy>/<r r> = 1 - 2/pi
        difference = contact_surface.relative_l2(POINTS[:, [1, 0]], POINTS, WEIGHTS)
        self.assertAlmostEqual(difference**2, 2 - 4 / np.pi, 6)


class StudyCommandTest(RunTest):
    """All in one folder: points that one test has made, another one finds there."""
    TOOL = pathlib.Path(PROGRAM).parent / "studies"

    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.folder = pathlib.Path(scratch.name)

    def setUp(self):
        pass

    def study(self, *words):
        command = [sys.executable, ROOT / "tools/studies/study.py", "--program", PROGRAM, "--studies", self.TOOL, "--output",
                   self.folder, *words]
        return subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=1000, check=False)

    def rows_of(self, name):
        with open(self.folder / f"{name}.csv", newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def test_every_study_that_is_listed_can_be_made(self):
        listed = self.study("--list")
        self.assertEqual(listed.returncode, 0, listed.stderr)
        names = [line.split()[0] for line in listed.stdout.splitlines()]
        self.assertIn("maps", names)
        finished = self.study("--quick")
        self.assertEqual(finished.returncode, 0, finished.stderr)
        for name in names:
            with self.subTest(name=name):
                rows = self.rows_of(name)
                self.assertGreater(len(rows), 0)
                self.assertTrue(all(row["command"].startswith(("build/", "mpirun ", "tools/")) for row in rows))
        pictures = {file.stem for file in self.folder.glob("*.png")}
        self.assertGreaterEqual(len(pictures), len(names))

    def test_points_of_the_pages_are_drawn_without_computing(self):
        finished = self.study("wear_steps", "backends", "--redraw", "--program", "nowhere", "--output", self.folder / "redrawn")
        self.assertEqual(finished.returncode, 0, finished.stderr)
        self.assertEqual({file.name for file in (self.folder / "redrawn").iterdir()}, {"wear_steps.png", "map_backends.png"})

    def test_points_are_made_once_and_kept_when_interrupted(self):
        self.assertEqual(self.study("spectra", "--quick").returncode, 0)
        table = (self.folder / "spectra.csv").read_text(encoding="utf-8")
        first, *others = self.rows_of("spectra")
        kept = [line for line in table.splitlines() if others[-1]["command"] not in line]
        (self.folder / "spectra.csv").write_text("\n".join(kept) + "\n", encoding="utf-8")  # as if killed before the last
        self.assertEqual(self.study("spectra", "--quick").returncode, 0)
        self.assertEqual(sorted(self.rows_of("spectra"), key=lambda row: row["command"]),
                         sorted([first, *others], key=lambda row: row["command"]))

    def test_the_command_of_a_row_redoes_its_point(self):
        self.assertEqual(self.study("spectra", "--quick").returncode, 0)
        row = next(row for row in self.rows_of("spectra") if row["iterations"])
        program, *words = shlex.split(row["command"])
        self.assertEqual(program, "build/studies")
        again = subprocess.run([self.TOOL, *words], capture_output=True, text=True, cwd=ROOT, timeout=600, check=True,
                               env={**os.environ, "OPENBLAS_NUM_THREADS": "1"})
        last = list(csv.DictReader(again.stdout.splitlines()))[-1]
        for name in ("iterations", "residual", "verdict"):
            self.assertEqual(last[name], row[name])

    def test_wear_that_is_too_deep_is_what_is_missing(self):
        """Of steps within the bound Archard's law holds to rounding; of those four times as deep volume is missing."""
        self.assertEqual(self.study("wear_steps", "--quick").returncode, 0)
        deep, shallow = self.rows_of("wear_steps")
        self.assertGreater(float(deep["ratio"]), 2)
        self.assertLess(float(shallow["ratio"] or 0.9), 1)
        self.assertGreater(wear_steps.missing(deep), 1)
        self.assertLess(abs(wear_steps.missing(shallow)), 0.01)

    def test_runs_of_a_point_are_run_each(self):
        """Medians of copies would look exact. On each counterbody the base slips, for contact to be compared."""
        self.assertEqual(self.study("counterbodies", "--quick").returncode, 0)
        rows = self.rows_of("counterbodies")
        self.assertEqual(len({row["command"] for row in rows}), len(rows))
        for kind in ("rigid", "half-space", "body"):
            one, other = (row for row in rows if row["kind"] == kind)
            self.assertEqual(one["iterations"], other["iterations"])
            self.assertNotEqual([one[name] for name in counterbodies.BODY], [other[name] for name in counterbodies.BODY])
            self.assertGreater(float(one["slipping"]), 0.05)
        point = points.Point({"run": 1}, ["true"])
        with self.assertRaisesRegex(points.StudyError, "the same command"):
            points.measure(points.Table(self.folder / "none.csv", False), [point, point], None, {})

    def test_jumps_that_wear_too_deep_flicker(self):
        """Jumps by a tenth of the flattening wear smoothly; those by most of it change the rate, and leave out volume."""
        rows = {}
        for length in (200, 3200):
            words = ["fixed_jumps", "prm/verification/fretting_wear.prm", "--cycles", str(length), "--set",
                     "Load program/Cycles=20000"]
            for entry, value in wear_flicker.SMALL.items():
                words += ["--set", f"{entry}={value}"]
            made = subprocess.run([self.TOOL, *words], capture_output=True, text=True, cwd=ROOT, timeout=600, check=True)
            rows[length] = {name: float(value) for name, value in next(csv.DictReader(made.stdout.splitlines())).items()
                            if name != "profile"}
        self.assertLess(rows[200]["flattening"], 0.15)
        self.assertLess(rows[200]["change"], 0.15)
        self.assertGreater(rows[3200]["flattening"], 0.7)
        self.assertGreater(rows[3200]["change"], 0.7)
        self.assertLess(rows[3200]["worn_volume"], 0.85 * rows[200]["worn_volume"])

    def test_wrong_words_are_refused(self):
        for words, message in ((["map"], "there is no study 'map'"), (["maps", "--quick", "--docs"], "--quick measures nothing")):
            refused = self.study(*words)
            self.assertEqual(refused.returncode, 2)
            self.assertIn(message, refused.stderr)


if __name__ == "__main__":
    main()
