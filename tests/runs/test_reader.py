# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The reader of run folders of the Python module, against the files as others read them.

Usage: test_reader.py PROGRAM [unittest options]"""
import pathlib
import subprocess
import sys
import tempfile

import meshio
import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
from program import ROOT, SMALL, RunTest, main  # noqa: E402

sys.path.insert(0, str(ROOT / "python"))
sys.modules["meshio"] = None  # the module does without it
from orthocone import Run  # noqa: E402

STEP = 5


class ReaderTest(RunTest):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        test = cls("test_tables")
        test.folder = pathlib.Path(temporary.name)
        result = test.run_program("run", settings=[*SMALL, "Load program/Cycles=1", "Output/Probes=rim: 10 0"])
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
                self.assertEqual([str(row[name]) if isinstance(values, list) else float(row[name]) for row in rows],
                                 list(values), name)
        self.assertEqual(self.run_folder.probe_names(), ["rim"])
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


if __name__ == "__main__":
    main()
