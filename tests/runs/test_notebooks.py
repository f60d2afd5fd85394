# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The notebooks of examples/notebooks run from the first cell to the last, and are stored without what they print.

Usage: test_notebooks.py PROGRAM [unittest options]"""
import json
import os
import pathlib
import re
import sys
import tempfile
import unittest
import unittest.mock

sys.dont_write_bytecode = True  # the source tree stays clean
from program import PROGRAM, ROOT, main  # noqa: E402

try:
    import nbclient
    import nbformat
    import pandas  # noqa: F401
except ImportError:
    nbclient = None

FOLDER = ROOT / "examples/notebooks"
BUILT = pathlib.Path(PROGRAM).parent / "python"


class NotebookTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def executed(self, name):
        """The outputs of a notebook, run as a user would run it, but for the folders of Jupyter."""
        if nbclient is None:
            self.skipTest("needs Debian's python3-nbclient, python3-nbformat, python3-ipykernel and python3-pandas")
        if not list(BUILT.glob("orthocone/_contact*")):
            self.skipTest("the Python module is not built")
        own = {f"JUPYTER_{kind}_DIR": str(self.folder / kind) for kind in ("CONFIG", "DATA", "RUNTIME")}
        own |= {"IPYTHONDIR": str(self.folder / "ipython"), "PYTHONPATH": str(BUILT), "ORTHOCONE": PROGRAM,
                "PYTHONDONTWRITEBYTECODE": "1", "PYDEVD_DISABLE_FILE_VALIDATION": "1"}
        with unittest.mock.patch.dict(os.environ, own):
            book = nbformat.read(FOLDER / f"{name}.ipynb", as_version=4)
            nbformat.validate(book)
            nbclient.NotebookClient(book, timeout=900, kernel_name="python3",
                                    resources={"metadata": {"path": str(self.folder)}}).execute()
        return [output for cell in book.cells for output in cell.get("outputs", [])]

    def text_of(self, outputs):
        self.assertEqual([output.text for output in outputs if output.get("name") == "stderr"], [])
        return "".join(output.get("text", "") for output in outputs)

    def pictures(self, outputs):
        return [output for output in outputs if "image/png" in output.get("data", {})]

    def test_first_loop(self):
        """The energy of the loop is what friction dissipates."""
        outputs = self.executed("first_loop")
        text = self.text_of(outputs)
        area, dissipated = (float(value) for value in re.findall(r"([\d.]+) N mm$", text, re.MULTILINE))
        self.assertAlmostEqual(area, dissipated, delta=0.02 * area)
        self.assertEqual(len(self.pictures(outputs)), 2)

    def test_study(self):
        """Its energies are those of the theory, and fall with friction."""
        outputs = self.executed("study")
        self.text_of(outputs)
        shown = [str(output.get("data", {}).get("text/plain")) for output in outputs]
        table, = (text for text in shown if "theory" in text)
        rows = [line.split() for line in table.splitlines() if re.match(r"0\.\d", line)]
        energies = [(float(row[1]), float(row[2])) for row in rows if len(row) >= 3][:4]
        self.assertEqual(len(energies), 4)
        for computed, theory in energies:
            self.assertAlmostEqual(computed, theory, delta=0.1 * theory)
        self.assertEqual(energies, sorted(energies, reverse=True))
        self.assertEqual(len(self.pictures(outputs)), 1)

    def test_own_compliance(self):
        """The forces are those of Hertz and Mindlin."""
        outputs = self.executed("own_compliance")
        text = self.text_of(outputs)
        for computed, theory in re.findall(r"force ([\d.]+) N, \w+ ([\d.]+) N", text):
            self.assertAlmostEqual(float(computed), float(theory), delta=0.02 * float(theory))
        self.assertEqual(len(self.pictures(outputs)), 2)

    def test_stored_without_outputs(self):
        files = sorted(FOLDER.glob("*.ipynb"))
        self.assertEqual([file.stem for file in files], ["first_loop", "own_compliance", "study"])
        for file in files:
            book = json.loads(file.read_text(encoding="utf-8"))
            for cell in book["cells"]:
                with self.subTest(file.name, cell=cell["id"]):
                    self.assertEqual((cell.get("outputs", []), cell.get("execution_count"), cell["metadata"]), ([], None, {}))


if __name__ == "__main__":
    main()
