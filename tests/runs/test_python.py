# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The tools find a Python that has what they need, although another one stands first in the PATH, as those of conda and
pyenv do.

Usage: test_python.py PROGRAM [unittest options]"""
import os
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
from program import ROOT, SMALL, RunTest, main  # noqa: E402

LAUNCHER = ROOT / "tools/python"
# The real Python, but for the packages: isolated, and without its folders of packages.
BARE = f"""#!/bin/sh
exec {sys.executable} -S -E "$@"
"""
BROKEN = "#!/bin/sh\nexit 1\n"


class PythonTest(RunTest):
    def setUp(self):
        super().setUp()
        self.bin = self.folder / "first in the path"
        self.bin.mkdir()
        self.script = self.folder / "script of mine.py"
        self.script.write_text("import sys\nprint(sys.argv[1:])\nimport numpy\nsys.exit(7)\n")

    def fake(self, text):
        path = self.bin / "python3"
        path.write_text(text)
        path.chmod(0o755)
        return path

    def run_with(self, *command, path=None, **variables):
        environment = {**os.environ, "PATH": path or f"{self.bin}:{os.environ['PATH']}", **variables}
        environment.pop("ORTHOCONE_PYTHON_FOUND", None)
        return subprocess.run(command, env=environment, capture_output=True, text=True, timeout=120, check=False,
                              cwd=self.folder)

    def test_fake_has_no_numpy(self):
        """Else the other tests could not fail."""
        self.assertIn("No module named 'numpy'", self.run_with(self.fake(BARE), "-c", "import numpy").stderr)

    def test_launcher_goes_on_to_the_next(self):
        for text in (BARE, BROKEN):
            self.fake(text)
            result = self.run_with(LAUNCHER, "numpy,meshio", self.script, "a b", "--c")
            self.assertEqual((result.returncode, result.stdout), (7, "['a b', '--c']\n"), result.stderr)

    def test_modules_of_the_current_folder_are_not_run(self):
        """A numpy.py beside the user's scene is the user's, and so is one of a module that Python itself imports."""
        for name in ("numpy", "meshio", "string", "re", "sitecustomize", "matplotlib"):
            (self.folder / f"{name}.py").write_text(f"open({str(self.folder / 'trace')!r}, 'a').write('{name} ')\n")
        folder = self.folder / "elsewhere"
        folder.mkdir()
        (folder / "mine.py").write_text("import sys\nimport numpy\nsys.exit(7)\n")
        self.assertEqual(self.run_with(LAUNCHER, "numpy,meshio", folder / "mine.py").returncode, 7)
        self.assertEqual(self.run_with(ROOT / "tools/report.py", "nothing").returncode, 4)
        for places in (":", ".", "./", ".//", "./.", "././/", ".//./.", ":./:", f"./:{folder}"):
            with self.subTest(places):
                self.assertEqual(self.run_with(ROOT / "tools/report.py", "nothing", PYTHONPATH=places).returncode, 4)
                self.assertFalse((self.folder / "trace").exists())
        (folder / "on_purpose.py").touch()
        (folder / "mine.py").write_text("import on_purpose\n")
        self.assertEqual(self.run_with(LAUNCHER, "numpy", folder / "mine.py", PYTHONPATH=f"./:{folder}").returncode, 0)
        os.mkdir(folder / "below")
        self.assertEqual(self.run_with(LAUNCHER, "numpy", folder / "mine.py", PYTHONPATH="./elsewhere/below/..").returncode, 0)
        self.assertFalse((self.folder / "trace").exists())

    def test_nothing_serves(self):
        bare = self.fake(BARE)
        result = self.run_with(LAUNCHER, "numpy,meshio", self.script, ORTHOCONE_PYTHON=str(bare))
        self.assertEqual((result.returncode, result.stdout), (1, ""))
        self.assertRegex(result.stderr, "^script of mine: no Python here .*python3-numpy python3-meshio\n$")
        self.assertEqual(result.stderr.count("\n"), 1)
        # The one that is named is taken, although the first of the PATH would do as well.
        result = self.run_with(LAUNCHER, "no_such_module_anywhere", self.script, ORTHOCONE_PYTHON=sys.executable)
        self.assertIn(sys.executable, result.stderr)

    def test_report_hands_over(self):
        self.assertEqual(self.run_program("out", settings=[*SMALL, "Load program/Cycles=1"]).returncode, 0)
        bare = self.fake(BARE)
        page = self.folder / "out/report.html"
        for command in (["python3", ROOT / "tools/report.py"], [ROOT / "tools/report.py"]):
            result = self.run_with(*command, "out")
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            page.unlink()
        result = self.run_with(bare, ROOT / "tools/report.py", "out", ORTHOCONE_PYTHON=str(bare))
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, r"^report: no Python here .*python3-numpy python3-meshio\n$")
        self.assertFalse(page.exists())

    def test_drawing_tools_take_the_python_that_is_named(self):
        """Their scripts are replaced by one that prints who runs it, their set-up by one that does nothing."""
        tools = self.folder / "tools"
        (tools / "studies").mkdir(parents=True)
        self.fake(BARE)
        mine = self.folder / "mine"
        mine.write_text(f'#!/bin/sh\nMINE=1 exec {sys.executable} "$@"\n')
        mine.chmod(0o755)
        for file in ("study", "python"):
            shutil.copy(ROOT / "tools" / file, tools)
        (tools / "setup.sh").write_text('#!/bin/sh\necho "$@"\n')
        (tools / "setup.sh").chmod(0o755)
        (tools / "studies/study.py").write_text("import numpy, os, sys\nprint(os.environ.get('MINE'), sys.argv[1:])\n")
        for word, needed in (("figures", ""), ("benchmark", " benchmark"), ("peers", " peers"), ("maps", " study")):
            self.assertEqual(self.run_with(tools / "study", word, "--docs").stdout, f"release{needed}\nNone ['{word}', '--docs']\n")
            self.assertEqual(self.run_with(tools / "study", word, ORTHOCONE_PYTHON=str(mine)).stdout, f"release{needed}\n1 ['{word}']\n")
        self.assertEqual(self.run_with(tools / "study").stdout, "release study\nNone []\n")


if __name__ == "__main__":
    main()
