# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The portable package, unpacked: without any variable of the environment it computes what the built program does, and
loads nothing of the system but the C library. tools/package_check tries it in other Debians.

Usage: test_portable.py PROGRAM [unittest options]"""
import ast
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True  # the source tree stays clean
from program import PROGRAM, ROOT, main  # noqa: E402

PACKAGING = ROOT / "tools/packaging"
sys.path.insert(0, str(PACKAGING))
import debian  # noqa: E402

# A body without a matrix: it starts MPI, whose plug-ins are loaded late.
SETTINGS = ["Mesh/Core cells=2", "Mesh/Rings=1", "Mesh/Core ratio=0.6", "Mesh/Layers=2", "Mesh/Backend=multigrid",
            "Mesh/Refinements=1", "Load program/Legs=0 0 -0.05 : 1", "Load program/Cycles=1"]


def run(*words, **options):
    return subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False, **options)


@unittest.skipUnless(shutil.which("patchelf") and shutil.which("ompi_info"), "needs Debian's patchelf and openmpi-bin")
class PortableTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = pathlib.Path(temporary.name)
        build = pathlib.Path(PROGRAM).parent
        made = run(sys.executable, PACKAGING / "portable.py", build, cls.folder, "--level", "1")
        assert made.returncode == 0, made.stdout + made.stderr
        archive = pathlib.Path(made.stdout.strip())
        assert run("tar", "-xzf", archive, "-C", cls.folder).returncode == 0
        archive.unlink()
        cls.root = cls.folder / archive.name[:-len(".tar.gz")]
        cls.scene = cls.root / "share/orthocone/prm/paper/case_b.prm"
        cls.words = ["-q", "--threads", "1", *[f"--set={setting}" for setting in SETTINGS]]
        cls.result = cls.installed("orthocone", cls.scene, *cls.words)

    @classmethod
    def installed(cls, name, *words):
        """A command of the package. The files loaded.PID say what the dynamic linker does for each process."""
        return run("env", "-i", "PATH=/usr/bin:/bin", "LD_DEBUG=libs", f"LD_DEBUG_OUTPUT={cls.folder}/loaded",
                   cls.root / "bin" / name, *words, cwd=cls.folder)

    def strangers(self, program):
        """What processes of a program in libexec load that is neither the package's nor the C library's."""
        found, processes = set(), 0
        for file in self.folder.glob("loaded.*"):
            text = file.read_text()
            if re.search(rf"initialize program: {self.root.resolve()}/libexec/{program}$", text, re.MULTILINE):
                processes += 1
                found.update(pathlib.Path(name) for name in re.findall(r"calling init: (\S+)", text))
        self.assertGreater(processes, 0)
        self.assertGreater(len(found), 10)
        return {path for path in found if self.root.resolve() not in path.resolve().parents and path.name not in debian.glibc()}

    def test_results_are_those_of_the_built_program(self):
        self.assertEqual((self.result.returncode, self.result.stderr), (0, ""))
        built = run(PROGRAM, self.scene, *self.words, "-o", "built", cwd=self.folder)
        self.assertEqual(built.returncode, 0, built.stderr)
        same = run(sys.executable, PACKAGING / "same_results.py", "output/case_b", "built", cwd=self.folder)
        self.assertEqual(same.returncode, 0, same.stdout + same.stderr)

    def test_all_libraries_are_in_it(self):
        self.assertEqual(self.strangers("orthocone"), set())

    def test_mpirun_is_its_own(self):
        """Two processes that wait for each other would take both cores; tools/package_check runs them."""
        started = self.installed("orthocone-mpirun", "--allow-run-as-root", "-n", "1", self.root / "bin/orthocone", "--version")
        self.assertEqual((started.returncode, started.stderr), (0, ""))
        self.assertIn("orthocone ", started.stdout)
        self.assertEqual(self.strangers("mpi/bin/orterun"), set())

    def test_report_by_its_own_python(self):
        result = self.installed("orthocone-report", "output/case_b")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertIn("</html>", (self.folder / "output/case_b/report.html").read_text(encoding="utf-8")[-100:])
        self.assertEqual(self.strangers("python/bin/python3"), set())
        asked = self.installed("orthocone-python", "-c", "import matplotlib.pyplot, orthocone; print(orthocone.__file__)")
        self.assertEqual(asked.stdout, f"{self.root.resolve()}/libexec/python/lib/python3/dist-packages/orthocone/__init__.py\n")

    def test_readme(self):
        text = (self.root / "README.md").read_text(encoding="utf-8")
        self.assertEqual(re.findall(r"@\w+@", text), [])
        self.assertIn(f"# {self.root.name}\n", text)
        commands = set(re.findall(r"\| `(orthocone[a-z-]*)", text))
        self.assertEqual(commands - {"orthocone-solve"}, {file.name for file in self.root.glob("bin/*")} - {"orthocone-solve"})
        self.assertLess({"libdeal.ii", "libopenmpi", "python3-numpy"}, {
            re.match(r"lib(deal\.ii|openmpi)|python3-numpy|", line)[0]
            for line in (self.root / "share/doc/orthocone/licences/packages.txt").read_text().splitlines()})


class RecipesTest(unittest.TestCase):
    """The recipes are for other systems: what can be seen here is that they are well-formed and of this version."""
    VERSION = re.search(r"project\(orthocone VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]

    def assert_is_shell(self, text):
        self.assertTrue(text.strip())
        checked = run("sh", "-n", input=text)
        self.assertEqual(checked.returncode, 0, checked.stderr)
        for script in re.findall(r"/orthocone/(tools/\w+)", text):
            self.assertTrue((ROOT / script).is_file(), script)

    def test_containers(self):
        lines = (PACKAGING / "Dockerfile").read_text(encoding="utf-8").splitlines()
        instructions = [line.split(" ", 1) for line in lines if line and not line.startswith("#")]
        self.assertLessEqual({name for name, _ in instructions}, {"ARG", "FROM", "COPY", "RUN", "WORKDIR", "ENTRYPOINT", "CMD"})
        for name, words in instructions:
            if name == "RUN":
                self.assert_is_shell(words)
        sections = re.split(r"^%(\w+)[^\n]*\n", (PACKAGING / "orthocone.def").read_text(encoding="utf-8"), flags=re.MULTILINE)
        for name, text in zip(sections[1::2], sections[2::2]):
            self.assertIn(name, ("files", "post", "runscript", "test", "help"))
            if name in ("post", "runscript", "test"):
                self.assert_is_shell(text.partition("Bootstrap:")[0])

    def test_spack_and_conda(self):
        package = (PACKAGING / "spack/packages/orthocone/package.py").read_text(encoding="utf-8")
        ast.parse(package)
        self.assertIn(f'version("{self.VERSION}")', package)
        self.assertIn(f'version: "{self.VERSION}"', (PACKAGING / "conda/meta.yaml").read_text(encoding="utf-8"))
        script = (PACKAGING / "conda/build.sh").read_text(encoding="utf-8")
        self.assert_is_shell(script)
        options = (ROOT / "CMakeLists.txt").read_text() + (ROOT / "cmake/OrthoconePython.cmake").read_text()
        for option in {*re.findall(r"ORTHOCONE_\w+", package), *re.findall(r"-D(ORTHOCONE_\w+)", script)}:
            self.assertRegex(options, rf"(?:option|set)\({option} ")


if __name__ == "__main__":
    main()
