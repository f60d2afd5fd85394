# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The picture of a scene before its run: what it names, and what is said where it cannot be drawn.

Usage: test_scene_picture.py PROGRAM [unittest options]"""
import os
import re
import subprocess
import sys
import xml.etree.ElementTree as xml

sys.dont_write_bytecode = True  # the source tree stays clean
import program  # noqa: E402
from program import PROGRAM, ROOT, SMALL, main  # noqa: E402

DONE, WRONG_INPUT, FILE_ERROR = 0, 2, 4
BOX = ["Geometry/Shape=box", "Geometry/Sizes=8, 6, 4", "Mesh/Cells=4, 4, 2", "Mesh/Degree=1", "Output/Probes="]


class ScenePictureTest(program.RunTest):
    def check(self, picture, file, settings=(), **variables):
        words = [PROGRAM, "--check", "--picture", picture, file, *(f"--set={setting}" for setting in settings)]
        return subprocess.run(words, cwd=self.folder, text=True, capture_output=True, timeout=120, check=False,
                              env={**os.environ, **variables})

    def words_of(self, file, settings=()):
        """The texts of the picture, the lines of a label joined."""
        result = self.check("scene.svg", file, settings)
        self.assertEqual((result.returncode, result.stderr), (DONE, ""))
        self.assertTrue(result.stdout.endswith("picture        scene.svg\n"), result.stdout)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["scene.svg"])
        texts = [" ".join("".join(text.itertext()).split()) for text in xml.parse(self.folder / "scene.svg").iter()
                 if text.tag.endswith("}text")]
        return "\n".join(texts)

    def assert_says(self, words, *expected):
        for part in expected:
            with self.subTest(part):
                self.assertRegex(words, rf"(?m)^{re.escape(part)}")

    def test_a_cylinder(self):
        words = self.words_of(ROOT / "prm/paper/case_b.prm", SMALL)
        self.assert_says(words, "uz = -0.1 mm", "top: held face", "base: contact surface", "x = 0: plane of symmetry",
                         "rigid counterface", "friction ellipse μ = 0.3, 0.15", "5 mm along x", "Model: quarter", "z", "x (mm)",
                         "Contact surface from above: ")
        self.assertNotIn("Gap", words)  # both surfaces are flat

    def test_two_sections_with_a_load(self):
        words = self.words_of(ROOT / "prm/rigs/fretting_fatigue.prm", ["Mesh/Cells=8, 1, 4", "Lower mesh/Cells=8, 1, 4"])
        self.assert_says(words, "Fx = -155 to 155 N", "Fz = -543 N", "bulk: traction on lower x+", "lower x-: support, held",
                         "lower base: contact surface", "lower top: held along z", "Model: plane strain", "Mesh at the first touch",
                         "Gap along x: heights drawn ")
        self.assertIn("-100 to 100 MPa", words.replace("\n", " "))

    def test_a_box_that_only_supports_and_loads_hold(self):
        words = self.words_of(ROOT / "prm/paper/scene.prm", [
            *BOX, "Geometry/Top face=free", "Geometry/Supports=x+: x ; y-: y", "Obstacle/Kind=half-space", "Obstacle/Gap=x^2/50",
            "Load program/Loads=press: pressure on top ; heat: temperature", "Material/Thermal expansion=1e-5",
            "Load program/Legs=press 20 : 1 ; heat 50 : 1", "Load program/Cycles=1"])
        self.assert_says(words, "press: pressure on top, 20 MPa", "heat: temperature, 50 K", "x+: support, held along x",
                         "y-: support, held along y", "elastic half-space", "Gap along x: heights drawn ")
        self.assertNotIn("held face", words)

    def test_a_revolved_section_on_a_mesh_that_the_run_chooses(self):
        words = self.words_of(ROOT / "prm/paper/scene.prm", [
            "Mesh/Resolution=custom", "Mesh/Accuracy=1 %", "Friction/Coefficients=0.2, 0.2", "Obstacle/Gap=(x^2+y^2)/200"])
        self.assert_says(words, "Model: axisymmetric", "Gap along x", "uz = -0.1 mm")
        self.assertIn("The mesh of the run is not drawn", words)

    def test_formats_and_what_stands_in_the_way(self):
        scene = self.folder / "scene.prm"
        scene.write_text(program.SCENE)
        self.assertEqual(self.check("a.png", scene).returncode, DONE)
        self.assertEqual((self.folder / "a.png").read_bytes()[:4], b"\x89PNG")
        (self.folder / "folder.svg").mkdir()
        for picture, variables, message in (
                ("nowhere/a.svg", {}, "--picture: nowhere/a.svg: cannot be written (No such file or directory)\n"),
                ("folder.svg", {}, "--picture: folder.svg: is no ordinary file, and stays as it is\n"),
                ("b.svg", {"ORTHOCONE_PYTHON": "/bin/false"}, "in Debian's packages python3-numpy python3-matplotlib\n")):
            with self.subTest(picture):
                result = self.check(picture, scene, **variables)
                self.assertEqual((result.returncode, result.stderr.count("\n")), (FILE_ERROR, 1), result.stderr)
                self.assertTrue(result.stderr.startswith("orthocone: --picture: "), result.stderr)
                self.assertTrue(result.stderr.endswith(message), result.stderr)
        self.assertEqual({path.name for path in self.folder.iterdir()}, {"a.png", "folder.svg", "scene.prm"})


if __name__ == "__main__":
    main()
