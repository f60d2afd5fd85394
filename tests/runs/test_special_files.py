# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Parameter files that are no plain files: pipes, devices, standard input, and includes without end.

Usage: test_special_files.py PROGRAM [unittest options]"""
import json
import os
import shutil
import subprocess
import sys
import threading
import time

sys.dont_write_bytecode = True  # the source tree stays clean
from program import PROGRAM, ROOT, RunTest, SCENE, main  # noqa: E402

DONE, WRONG_INPUT, FILE_ERROR = 0, 2, 4


class SpecialFileTest(RunTest):
    def start(self, *arguments, **options):
        return subprocess.run([PROGRAM, *arguments], cwd=self.folder, text=True, capture_output=True, timeout=30,
                              check=False, **options)

    def put(self, name, text):
        (self.folder / name).write_text(text)

    def run_well(self, output, file):
        result = self.run_program(output, file=file)
        self.assertEqual((result.returncode, result.stderr), (DONE, ""))

    def assert_rejected(self, result, code, expression):
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertRegex(result.stderr, "^orthocone: " + expression)
        self.assertEqual(result.stderr.count("\n"), 1)
        self.assertFalse((self.folder / "output").exists())

    def test_pipes(self):
        """A pipe is read once, waits for a writer that is slow, and not for ever for one that never comes."""
        pipe = self.folder / "pipe.prm"
        os.mkfifo(pipe)
        self.assert_rejected(self.start("pipe.prm"), FILE_ERROR, r"pipe\.prm: is a pipe, and nobody has written")

        def write():
            with open(pipe, "w", encoding="ascii") as stream:
                stream.write(SCENE[:20])
                stream.flush()
                time.sleep(1)
                stream.write(SCENE[20:])
        writer = threading.Thread(target=write)
        writer.start()
        result = self.start("pipe.prm", "--output", "run")
        writer.join()
        self.assertEqual((result.returncode, result.stderr), (DONE, ""))
        self.assertEqual((self.folder / "run/input.prm").read_text(), SCENE)

    def test_standard_input(self):
        result = self.start("/dev/stdin", "--output", "run", input=SCENE)
        self.assertEqual((result.returncode, result.stderr), (DONE, ""))
        self.assertEqual((self.folder / "run/input.prm").read_text(), SCENE)
        self.assertEqual(len(self.rows("run")), 2)

    def test_process_substitution(self):
        script = f"'{PROGRAM}' <(cat) --output run --quiet"
        result = subprocess.run(["bash", "-c", script], cwd=self.folder, input=SCENE, text=True, capture_output=True,
                                timeout=30, check=False)
        self.assertEqual((result.returncode, result.stderr), (DONE, ""))
        self.assertEqual((self.folder / "run/input.prm").read_text(), SCENE)

    def test_devices_without_end(self):
        for device in ("/dev/zero", "/dev/urandom"):
            with self.subTest(device):
                self.assert_rejected(self.start(device), WRONG_INPUT, device + ": is larger than 4 MB")
                self.put("case.prm", f"include {device}\n")
                self.assert_rejected(self.start("case.prm"), WRONG_INPUT, rf"case\.prm:1: {device}: is larger than 4 MB")
        self.assert_rejected(self.start("/dev/null"), WRONG_INPUT, "/dev/null: is empty")

    def test_includes_that_multiply(self):
        for n_files, n_includes in ((19, 2), (8, 60)):
            for number in range(n_files):
                self.put(f"{number}.prm", f"include {number + 1}.prm\n" * n_includes)
            self.put(f"{n_files}.prm", "# nothing\n" * 2)
            with self.subTest(n_files=n_files, n_includes=n_includes):
                self.assert_rejected(self.start("0.prm"), WRONG_INPUT, r".*\.prm: is one include too many: allowed are 1000")

    def test_the_input_of_a_run_is_complete(self):
        """Included files are kept with it, so that it can be run from the run folder."""
        settings = ["Mesh/Core cells=2", "Mesh/Layers=2", "Mesh/Degree=1"]
        self.assertEqual(self.run_program("first", settings=settings).returncode, DONE)
        text = (self.folder / "first/input.prm").read_text()
        for line in (ROOT / "prm/paper/scene.prm").read_text().splitlines():
            self.assertIn(line, text)
        result = self.run_program("second", settings=settings, file=self.folder / "first/input.prm")
        self.assertEqual((result.returncode, result.stderr), (DONE, ""))
        self.assert_same_files("first", "second", ["history.csv", "parameters.prm"])

    def test_the_input_of_a_run_finds_its_files(self):
        """Files of all entries that name one, in both formats, seen from a folder that is not theirs."""
        scene = self.folder / "scene"
        (scene / "parts").mkdir(parents=True)
        (scene / "parts/gap.txt").write_text("# a hump\n-20 20 3 -20 20 3\n0.4 0.2 0.4\n0.2 0 0.2\n0.4 0.2 0.4\n")
        shutil.copy(ROOT / "prm/import/cylinder_coarse.msh", scene / "parts/body.msh")
        quarter = {"Shape": "file", "Contact surface": "base", "Held surface": "top", "Symmetry surfaces": "x0, y0",
                   "Mesh file": "parts/body.msh"}
        mesh = {"Degree": "1"}
        entries = {"Geometry": quarter, "Mesh": mesh, "Obstacle": {"Gap file": "parts/gap.txt", "Kind": "body"},
                   "Lower geometry": quarter, "Lower mesh": mesh, "Load program": {"Legs": "0 0 -0.1 : 1"}}
        (scene / "case.json").write_text(json.dumps(entries))
        sections = ("".join([f"subsection {name}\n", *(f"set {entry} = {value}\n" for entry, value in values.items()),
                             "end\n"]) for name, values in entries.items())
        (scene / "parts/all.prm").write_text("".join(sections).replace("parts/", ""))
        (scene / "case.prm").write_text("include parts/all.prm\n")
        for ending in ("prm", "json"):
            self.run_well("first", scene / f"case.{ending}")
            self.assertGreater(int(self.rows("first")[0]["n_open"]), 0)
            for copy in (f"input.{ending}", "parameters.prm"):
                with self.subTest(ending=ending, copy=copy):
                    self.run_well("second", self.folder / "first" / copy)
                    self.assert_same_files("first", "second", ["history.csv", "parameters.prm"])

    def test_an_entry_twice_in_a_section(self):
        self.put("case.prm", SCENE.replace("  set Layers     = 1\n", "  set Layers     = 1\n  set Core cells = 4\n"))
        self.assert_rejected(self.start("case.prm"), WRONG_INPUT,
                             r"case\.prm:4: Core cells is given twice in this section, before in case\.prm:2")
        self.put("mesh.prm", "set Core cells = 4\n")
        self.put("case.prm", SCENE.replace("subsection Mesh\n", "subsection Mesh\n  include mesh.prm\n"))
        self.assertEqual(self.start("case.prm", "--check").returncode, DONE)  # overrides what it includes

    def test_json_of_many_names(self):
        self.put("case.json", "{" + ", ".join(f'"name{number}": 1' for number in range(100000)) + "}")
        self.assert_rejected(self.start("case.json"), WRONG_INPUT, r"case\.json: has more than 1000 names")

    def test_names_are_shown_as_text(self):
        name = "a\x1b[31mred\nline.prm"
        self.assert_rejected(self.start(name), FILE_ERROR, r"a\\x1b\[31mred\\nline\.prm: cannot be read \(No such file")
        self.put(name, SCENE + "nonsense\n")
        self.assert_rejected(self.start(name), WRONG_INPUT, r"a\\x1b\[31mred\\nline\.prm:9: 'nonsense'")
        result = self.start("x" * 5000)
        self.assert_rejected(result, FILE_ERROR, r"\.\.\.x+: cannot be read \(File name too long")
        self.assertLess(len(result.stderr), 400)
        self.put("good.prm", SCENE)
        result = self.start("good.prm", "--output", "y" * 5000)
        self.assert_rejected(result, FILE_ERROR, r"\.\.\.y+: cannot be created")
        self.assertLess(len(result.stderr), 400)


if __name__ == "__main__":
    main()
