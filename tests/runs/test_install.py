# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The installed libraries: the examples are built against them, and what they compute is right.

Usage: test_install.py PROGRAM [unittest options]"""
import os
import pathlib
import platform
import subprocess
import sys
import tempfile
import unittest

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()


def run(*command):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True)


def install(component, prefix):
    made = run("cmake", "--install", PROGRAM.parent, "--component", component, "--prefix", prefix)
    assert made.returncode == 0, made.stderr


class InstallTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = pathlib.Path(temporary.name)
        for component in ("contact", "body"):
            install(component, cls.folder / "first")
        # Who moves the folder finds everything where it is now.
        cls.prefix = (cls.folder / "first").rename(cls.folder / "installed")

    def built(self, name, target, *options):
        """The build folder of the example, which must not look into the tree that it was installed from."""
        build = self.folder / name
        made = run("cmake", "-S", ROOT / "examples/library", "-B", build, "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={self.prefix}",
                   "-DCMAKE_BUILD_TYPE=Release", *options)
        self.assertEqual(made.returncode, 0, made.stderr)
        made = run("cmake", "--build", build, "--target", target)
        self.assertEqual(made.returncode, 0, made.stdout)
        return build

    def test_contact_needs_neither_dealii_nor_mpi(self):
        build = self.built("contact", "ten_nodes", "-DCMAKE_DISABLE_FIND_PACKAGE_deal.II=ON", "-DCMAKE_DISABLE_FIND_PACKAGE_MPI=ON",
                           "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Werror")
        result = run(build / "ten_nodes")
        self.assertEqual(result.returncode, 0, result.stderr)
        needed = run("ldd", build / "ten_nodes").stdout
        self.assertNotRegex(needed, "deal|libmpi")
        self.assert_obeys_law(result.stdout)

    def test_other_registers_are_refused(self):
        """Eigen's vectors would be freed in another way than they were made, without a word."""
        if platform.machine() != "x86_64":
            self.skipTest("registers of x86")
        made = run("g++", "-std=c++17", "-mavx", "-fsyntax-only", "-DORTHOCONE_EIGEN_ALIGNMENT=16",
                   f"-I{self.prefix}/include", "-I/usr/include/eigen3", ROOT / "examples/library/ten_nodes.cc")
        self.assertIn("compile for the processor that orthocone was compiled for", made.stderr)

    def test_python(self):
        install("python", self.prefix)
        modules = list(self.prefix.glob("lib/python*/dist-packages"))
        if not modules:
            self.skipTest("the Python module is not built")
        result = subprocess.run([sys.executable, "-B", ROOT / "examples/python/ten_nodes.py"], capture_output=True, text=True,
                                env={**os.environ, "PYTHONPATH": str(modules[0])}, check=False)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assert_obeys_law(result.stdout)

    def assert_obeys_law(self, text):
        """The law of the examples in its own terms, with W and q made once more; C++ prints six digits of the forces."""
        table = np.array([[float(word) for word in line.split()] for line in text.splitlines()])
        self.assertEqual(table.shape, (10, 4))
        force, status = table[:, :3], table[:, 3]
        near = np.exp(-0.5 * np.abs(np.subtract.outer(np.arange(10), np.arange(10))))
        q = np.array([-0.01, 0, 0]) + np.outer(np.arange(10), [0, 0.0005, 0.0003])
        d = q + 1e-5 * (near @ force) * [1, 1.2, 1.2]
        criterion = np.hypot(force[:, 1] / 0.30, force[:, 2] / 0.15) / force[:, 0]
        self.assertLess(np.abs(d[:, 0]).max(), 1e-7)
        self.assertEqual({0, 1, 2} & set(status), {1, 2})
        for i in range(10):
            if status[i] == 1:
                self.assertLess(criterion[i], 1)
                self.assertLess(np.hypot(*d[i, 1:]), 1e-7)
            else:
                self.assertAlmostEqual(criterion[i], 1, delta=1e-5)
                direction = -force[i, 1:] / [0.05**2, 0.20**2]
                along = d[i, 1:] @ direction / np.hypot(*direction)
                self.assertAlmostEqual(along, np.hypot(*d[i, 1:]), delta=1e-7)

    def test_body(self):
        """A block without a Poisson ratio is a spring. deal.II's flags would optimize it for a minute."""
        fast = "<CMAKE_CXX_COMPILER> <DEFINES> <INCLUDES> <FLAGS> -O0 -g0 -U_FORTIFY_SOURCE -o <OBJECT> -c <SOURCE>"
        result = run(self.built("body", "block", "-DWITH_BODY=ON", f"-DCMAKE_CXX_COMPILE_OBJECT={fast}") / "block")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertAlmostEqual(float(result.stdout.split()[0]), 210000 * 100 * 0.001 / 5, delta=0.05)

    def test_program(self):
        install("program", self.prefix)
        result = run(self.prefix / "bin/orthocone", "--version")
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_package_names_no_place_of_this_machine(self):
        for file in self.prefix.rglob("*.cmake"):
            for place in (ROOT, PROGRAM.parent):
                self.assertNotIn(str(place), file.read_text(encoding="utf-8"), file.name)


if __name__ == "__main__":
    unittest.main()
