# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The reader of run folders of the Python module, against the files as others read them.

Usage: test_reader.py PROGRAM [unittest options]"""
import functools
import os
import pathlib
import re
import stat
import subprocess
import sys
import tempfile

import meshio
import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
from program import ROOT, SMALL, RunTest, main  # noqa: E402

sys.path.insert(0, str(ROOT / "python"))
sys.modules["meshio"] = None  # the module does without it
import orthocone  # noqa: E402

Run = functools.partial(orthocone.Run, pandas=False)  # test_scene.py has the tables of pandas
STEP = 5
# What else can stand under the name of a file, and what is said of it.
SPECIAL = (("a pipe", os.mkfifo), ("a folder", os.mkdir), ("a device", lambda path: os.symlink("/dev/zero", path)),
           ("a socket", lambda path: os.mknod(path, stat.S_IFSOCK | 0o600)))
READ = {"history.csv": lambda run: run.history, "timing.csv": lambda run: run.timing, "checks.csv": lambda run: run.checks,
        "cycles.csv": lambda run: run.cycles, "probe-P.csv": lambda run: run.probe("P"),
        "line-L-0001.csv": lambda run: run.line("L", 1), "summary.json": lambda run: run.summary,
        "parameters.prm": lambda run: run.parameters, "contact-0001.vtu": lambda run: run.contact(1)}
BAD_TABLES = (("step,ux\n1,2\n2\n", "row 2 has 1 entries, not 2"), ("step,ux\n1,2,3\n", "row 1 has 3 entries, not 2"),
              ("step,ux,ux\n1,2,3\n", "has 2 columns 'ux'"), ("step,,ux\n1,2,3\n", "has 1 columns ''"),
              ('step\n"1\n', "is no table"), ("step\n" + "1" * 200000, "is no table"), (b"step\n\xff\n", "byte 6 is no UTF-8"))
BAD_SUMMARIES = (("", "is no JSON"), ("{", "is no JSON"), ("[]", "allowed is an object"), ("1", "allowed is an object"),
                 ("[" * 100000, "too many brackets"), (b'{"a": "\xff"}', "byte 8 is no UTF-8"))


class ReaderTest(RunTest):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        test = cls("test_tables")
        test.folder = pathlib.Path(temporary.name)
        result = test.run_program("run", settings=[*SMALL, "Load program/Cycles=1", "Output/Probes=rim: 10 0",
                                                    "Output/Lines=up-1: 0 0 0 to 0 0 4, 5", "Output/Line fields=5"])
        assert result.returncode == 0, result.stderr
        cls.folder = test.folder

    def setUp(self):
        self.run_folder = Run(self.folder / "run")

    def test_tables(self):
        for table, columns in (("history", self.run_folder.history), ("cycles", self.run_folder.cycles),
                               ("checks", self.run_folder.checks), ("probe-rim", self.run_folder.probe("rim"))):
            rows = self.rows("run", f"{table}.csv")
            self.assertEqual(list(columns), list(rows[0]))
            for name, values in columns.items():
                expected = [str(row[name]) if isinstance(values, list) else float(row[name]) for row in rows]
                np.testing.assert_array_equal(list(values), expected, name)  # to which nan is nan
        self.assertEqual(self.run_folder.probe_names(), ["rim"])
        self.assertEqual((self.run_folder.line_names(), self.run_folder.line_steps("up-1")), (["up-1"], [5, 10, 15]))
        line = self.run_folder.line("up-1", STEP)
        self.assertEqual(line["z"].tolist(), [0, 1, 2, 3, 4])
        self.assertEqual(np.isnan(line["pressure"]).tolist(), [False, True, True, True, True])
        self.assertEqual(self.run_folder.summary["status"], "complete")
        self.assertEqual(self.run_folder.parameters["Load program"]["Cycles"], "1")

    def test_fields(self):
        """meshio reads the same numbers, and the forces of the nodes are those of the history."""
        contact = self.run_folder.contact(STEP)
        other = meshio.read(contact.path)
        np.testing.assert_array_equal(contact.points, other.points)
        self.assertEqual(set(contact.data), set(other.point_data))
        for name, values in other.point_data.items():
            np.testing.assert_array_equal(contact[name], values, name)
        total = contact["nodal_force"].sum(axis=0)[2]
        self.assertAlmostEqual(total / self.run_folder.history["force_z"][STEP - 1], 1, delta=1e-5)
        self.assertEqual(contact.cells.shape[1], (contact.degree + 1)**2)

    def test_volume_files(self):
        from orthocone.vtu import Vtu
        path = self.folder / "run" / f"volume-{STEP:04d}.vtu"
        mine, other = Vtu(path), meshio.read(path)
        np.testing.assert_array_equal(mine.points, other.points)
        for name, values in other.point_data.items():
            np.testing.assert_array_equal(np.asarray(mine.fields[name]).reshape(values.shape), values, name)

    def test_pandas_takes_the_tables(self):
        try:
            import pandas
        except ImportError:
            self.skipTest("no pandas")
        frame = pandas.DataFrame(self.run_folder.history)
        self.assertEqual(len(frame), 15)

    def compare(self, points, field):
        """What another reader makes of a contact file: its points, and a function that gives its fields."""
        contact = self.run_folder.contact(STEP)
        np.testing.assert_array_equal(points, contact.points)
        for name, values in contact.data.items():
            np.testing.assert_array_equal(field(name), values, name)

    def test_vtk_takes_the_files(self):
        """PyVista reads by VTK."""
        try:
            from vtkmodules.util.numpy_support import vtk_to_numpy
            from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
        except ImportError:
            self.skipTest("no VTK")
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(self.run_folder.contact(STEP).path))
        reader.Update()
        grid = reader.GetOutput()
        self.compare(vtk_to_numpy(grid.GetPoints().GetData()), lambda name: vtk_to_numpy(grid.GetPointData().GetArray(name)))

    def test_pyvista_takes_the_files(self):
        try:
            import pyvista
        except ImportError:
            self.skipTest("no PyVista: Debian 12 has no package of it")
        grid = pyvista.read(self.run_folder.contact(STEP).path)
        self.compare(grid.points, lambda name: grid.point_data[name])

    def test_nothing_else_is_needed(self):
        """Neither pandas nor PyVista, nor what they read by, nor the compiled part."""
        code = """import sys
for name in ("pandas", "pyvista", "vtk", "vtkmodules", "meshio", "matplotlib", "orthocone._contact"):
    sys.modules[name] = None
from orthocone import Run
run = Run(sys.argv[1])
contact = run.contact(int(sys.argv[2]))
print(len(run.history["step"]), len(run.cycles["cycle"]), len(run.checks["step"]), len(contact["pressure"]) == len(contact.points))"""
        result = subprocess.run([sys.executable, "-B", "-c", code, self.folder / "run", str(STEP)], capture_output=True,
                                text=True, check=False, env={"PYTHONPATH": str(ROOT / "python")})
        self.assertEqual((result.stdout, result.stderr), ("15 1 15 True\n", ""))

    def test_what_is_not_there(self):
        with self.assertRaises(FileNotFoundError):
            self.run_folder.contact(99)
        with self.assertRaises(FileNotFoundError):
            Run(self.folder / "none")
        (self.folder / "empty").mkdir()
        begun = Run(self.folder / "empty")
        self.assertFalse(begun.has_history)
        self.assertEqual((begun.cycles, begun.problems()), ({}, {}))
        for table in ("history", "summary"):
            with self.assertRaises(FileNotFoundError):
                getattr(begun, table)

    def test_damaged_files(self):
        whole = (self.folder / "run" / f"contact-{STEP:04d}.vtu").read_bytes()
        (self.folder / "bad").mkdir(exist_ok=True)
        (self.folder / "bad/history.csv").write_text("step\n1\n")
        path = self.folder / "bad/contact-0001.vtu"
        for bad in (b"", whole[:len(whole) // 2], whole.replace(b"Float32", b"Float77"), whole.replace(b"eJ", b"!!"),
                    whole.replace(b'"NumberOfComponents', b'"N'), whole.replace(b"<Points>", b"<P>").replace(b"</Points>", b"</P>")):
            path.write_bytes(bad)
            if bad != whole:
                with self.assertRaisesRegex(ValueError, "contact-0001.vtu: not a .vtu file of a run"):
                    Run(self.folder / "bad").contact(1)

    def stranger(self, name, content):
        """A new run folder with one file: bytes, text, or made by a function."""
        folder = pathlib.Path(tempfile.mkdtemp(dir=self.folder))
        if callable(content):
            content(folder / name)
        else:
            (folder / name).write_bytes(content if isinstance(content, bytes) else content.encode())
        return Run(folder)

    def assert_bad(self, name, content, says):
        with self.subTest(name, says=says), self.assertRaises(ValueError) as caught:
            READ[name](self.stranger(name, content))
        self.assertRegex(str(caught.exception), rf"^\S*{re.escape(name)}: .*{says}[^\n]*$")

    def test_what_is_no_ordinary_file(self):
        """A pipe would be waited for, and a device has no end."""
        def huge(path):
            with open(path, "wb") as file:
                file.truncate(10**10)

        for name in READ:
            for kind, make in SPECIAL:
                self.assert_bad(name, make, f"is no ordinary file, but {kind}; allowed is a file of at most [0-9]+ bytes")
            self.assert_bad(name, huge, "has 10000000000 bytes; allowed are at most [0-9]+")

    def test_damaged_tables_and_summaries(self):
        for text, says in BAD_TABLES:
            self.assert_bad("history.csv", text, says)
        for text, says in BAD_SUMMARIES:
            self.assert_bad("summary.json", text, says)
        self.assertEqual(self.stranger("history.csv", "").history, {})
        self.assertEqual(self.stranger("parameters.prm", b"set A = 1\nsubsection B\n set C = \xff.msh\n").parameters,
                         {"B": {"C": "\udcff.msh"}})

    def test_names_that_no_run_gives(self):
        run = self.stranger("contact-0002.vtu", "")
        for name in ("contact-1x.vtu", "contact-00003.vtu", "contact-3.vtu", "contact-0004-1.vtu", "problem-x.hdf5",
                     f"contact-{'9' * 200}.vtu", "problem-0001.hdf5"):
            (run.path / name).touch()
        self.assertEqual((run.contact_steps(), list(run.problems())), ([2], [1]))

    def test_fields_that_do_not_fit_each_other(self):
        whole = (self.folder / "run" / f"contact-{STEP:04d}.vtu").read_text(encoding="ascii")
        for array, text in (("offsets", "4 2 9223372036854775807"), ("offsets", ""), ("connectivity", "0 1 2 9999"),
                            ("connectivity", "-1"), ("degree", ""), ("degree", "0"), ("degree", "1000000"), ("pressure", "1"),
                            ("pressure", "many")):
            changed = re.sub(rf'(<DataArray[^>]*Name="{array}"[^>]*)format="\w+"([^>]*>)[^<]*<', rf'\g<1>format="ascii"\g<2>{text}<', whole)
            self.assertNotEqual(changed, whole)
            self.assert_bad("contact-0001.vtu", changed, "not a .vtu file of a run|not a file of contact fields")

    def test_few_bytes_that_stand_for_many(self):
        from orthocone import vtu
        self.addCleanup(setattr, vtu, "MOST_BYTES", vtu.MOST_BYTES)
        vtu.MOST_BYTES = 1000
        self.assert_bad("contact-0001.vtu", (self.folder / "run" / f"contact-{STEP:04d}.vtu").read_bytes(),
                        "more than 1000 bytes of numbers")


if __name__ == "__main__":
    main()
