# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The Debian package, unpacked: it runs from any folder, writes nowhere else, and describes what it brings.

Usage: test_package.py PROGRAM [unittest options]"""
import gzip
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True  # the source tree stays clean
from program import PROGRAM, ROOT, SMALL, main  # noqa: E402

sys.path.insert(0, str(ROOT / "tools/site"))
import installed  # noqa: E402


def run(*words, **options):
    return subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False, **options)


@unittest.skipUnless(shutil.which("dpkg-deb") and shutil.which("dpkg-shlibdeps"), "no dpkg-dev here")
class PackageTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        folder = pathlib.Path(temporary.name)
        made = run("cpack", "-G", "DEB", "-B", folder, cwd=pathlib.Path(PROGRAM).parent)
        assert made.returncode == 0, made.stdout + made.stderr
        cls.package, = folder.glob("orthocone_*.deb")
        cls.root = folder / "unpacked"
        run("dpkg-deb", "-x", cls.package, cls.root)
        cls.bin = cls.root / "usr/bin"
        cls.work = folder / "work"
        cls.work.mkdir()

    def installed(self, name, *words, **variables):
        """A command of the package, in a folder of its own."""
        return run(self.bin / name, *words, cwd=self.work, env={**os.environ, **variables})

    def test_a_listed_scene_runs_and_is_reported(self):
        listed = self.installed("orthocone", "--list").stdout
        scene = re.search(r"^(\S+/prm/paper/case_b\.prm) ", listed, re.MULTILINE)[1]
        self.assertTrue(scene.startswith(str(self.root.resolve())), scene)
        before = {file for file in self.root.rglob("*")}
        settings = [f"--set={setting}" for setting in (*SMALL, "Load program/Cycles=1")]
        for command in (("orthocone", scene, *settings), ("orthocone-report", "output/case_b"),
                        ("orthocone", scene, *settings, "--check", "--picture", "output/scene.svg")):
            result = self.installed(*command)
            self.assertEqual((result.returncode, result.stderr), (0, ""), command)
        self.assertIn("</html>", (self.work / "output/case_b/report.html").read_text(encoding="utf-8")[-100:])
        self.assertIn("top: held face", (self.work / "output/scene.svg").read_text(encoding="utf-8"))
        self.assertEqual([file.name for file in self.work.iterdir()], ["output"])
        self.assertEqual({file for file in self.root.rglob("*")}, before)

    def test_a_study_runs(self):
        result = self.installed("orthocone-sweep", self.root / "usr/share/orthocone/prm/paper/case_a.prm", "--vary",
                                "mu=0.1,0.2", "--set=Friction/Coefficients={mu}, {mu}",
                                *[f"--set={setting}" for setting in SMALL], "--output", "study")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(len((self.work / "study/sweep.csv").read_text().splitlines()), 3)
        shutil.rmtree(self.work / "study")

    def test_python_finds_the_module_of_the_package(self):
        modules = self.root / "usr/lib/python3/dist-packages"
        if not modules.exists():
            self.skipTest("the Python module is not built")
        result = run("/usr/bin/python3", "-Bc", "import orthocone; print(orthocone.__file__, list(orthocone.methods())[0])",
                     cwd=self.work, env={**os.environ, "PYTHONPATH": str(modules)})
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(result.stdout, f"{modules}/orthocone/__init__.py newton\n")

    def test_man_pages_have_every_option(self):
        for name in ("orthocone", "orthocone-solve"):
            if not (self.bin / name).exists():
                continue
            page = gzip.open(self.root / f"usr/share/man/man1/{name}.1.gz", "rt").read().replace("\\-", "-")
            options = re.findall(r"^  (?:-\w \[ )?(--[a-z-]+)", self.installed(name, "--help").stdout, re.MULTILINE)
            self.assertGreater(len(options), 6)
            for option in options:
                self.assertRegex(page, rf"(?m)^\.B.*{option}\b", name)
            self.assertEqual(re.findall(r"@\w+@|/usr\S*", page), [])  # the package may lie anywhere

    def completed(self, *words):
        """What bash offers for the last word."""
        script = f"""source {self.root}/usr/share/bash-completion/completions/orthocone
COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1))
_orthocone "$1" "${{!#}}" "${{COMP_WORDS[COMP_CWORD - 1]}}"
printf '%s\\n' "${{COMPREPLY[@]}}" """
        return run("bash", "-c", script, "bash", self.bin / "orthocone", *words, cwd=ROOT).stdout.split("\n")[:-1]

    def test_completion(self):
        self.assertEqual(self.completed("--re"), ["--resume"])
        self.assertEqual(self.completed("--set", '"Mesh/Core'), ["Mesh/Core cells=", "Mesh/Core ratio="])
        self.assertEqual(self.completed("--set", "Mesh/Core\\ c"), ["Mesh/Core\\ cells="])
        self.assertEqual(self.completed("--set", "=", "Wear/L"), ["Wear/Law=", "Wear/Largest\\ depth\\ of\\ a\\ jump="])
        self.assertEqual(self.completed("prm/paper/case_a"), ["prm/paper/case_a.prm", "prm/paper/case_a_q1.prm"])
        entries = [name for section in ("", '"')
                   for name in self.completed("--set", section) if name.replace("\\", "").startswith("Geometry/R")]
        self.assertEqual(entries, ["Geometry/Radius="] * 2)

    def test_lintian_finds_nothing(self):
        if not shutil.which("lintian"):
            self.skipTest("no lintian here")
        result = run("lintian", "--fail-on", "error,warning", self.package)
        self.assertEqual((result.returncode, result.stdout), (0, ""))

    def test_every_command_has_a_man_page(self):
        pages = {file.name for file in (self.root / "usr/share/man/man1").iterdir()}
        self.assertEqual({f"{file.name}.1.gz" for file in self.bin.iterdir()} - pages, set())

    def test_changelog_is_that_of_the_project(self):
        text = gzip.open(self.root / "usr/share/doc/orthocone/changelog.gz", "rt", encoding="utf-8").read()
        parsed = run("dpkg-parsechangelog", "--all", "-l", "-", "-S", "Version", input=text)
        self.assertEqual((parsed.returncode, parsed.stderr), (0, ""))
        ours = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
        released = re.findall(r"^## \[([\d.]+)\]", ours, re.MULTILINE)
        self.assertEqual(re.findall(r"^orthocone \(([\d.]+)\)", text, re.MULTILINE), released)
        self.assertGreaterEqual(len(re.findall(r"^  \* ", text, re.MULTILINE)), len(re.findall(r"^- ", ours, re.MULTILINE)))

    def test_what_it_depends_on(self):
        fields = run("dpkg-deb", "-f", self.package, "Depends", "Version").stdout
        for needed in ("libopenblas0-pthread", "libdeal.ii-", "python3 ", "python3-numpy", "python3-matplotlib", "python3-meshio"):
            self.assertIn(needed, fields)
        self.assertIn(f"Version: {self.installed('orthocone', '--version').stdout.split()[1]}\n", fields)


class PagesTest(unittest.TestCase):
    """The pages as packages have them; test_site.py makes a site of them."""

    def test_commands_are_those_of_the_package(self):
        for package in installed.PACKAGES:
            for path in [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]:
                name = "README" if path.stem == "README" else f"docs/{path.stem}"
                if name in installed.OF_SOURCES:
                    continue
                text = installed.page(name, path.read_text(encoding="utf-8"), package)
                with self.subTest(page=name, package=package):
                    self.assertEqual(re.findall(r"\./run [\w-]|build/orthocone|tools/report\.py|@\w+@|source tree -->|build/python", text), [])
                    for block in re.findall(r"^```\n(.*?)^```", text, re.MULTILINE | re.DOTALL):
                        self.assertNotRegex(block, r"(?m)^(\./|tools/(?!study|docs|verification|setup))")

    def test_first_page_tells_how_to_begin(self):
        text = installed.page("README", (ROOT / "README.md").read_text(encoding="utf-8"), "deb")
        self.assertIn("cp -r /usr/share/orthocone/prm .\north", text)
        self.assertNotIn("Two commands", text)


if __name__ == "__main__":
    main()
