# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The program for deal.II's code gallery: it computes what orthocone does on the same meshes, the known answer of its block,
and the numbers of its README.

Usage: test_gallery.py PROGRAM [unittest options]"""
import csv
import functools
import math
import pathlib
import re
import subprocess
import tempfile
import unittest

import numpy as np

import program

GALLERY = program.ROOT / "examples/dealii_gallery"
BINARY = pathlib.Path(program.PROGRAM).parent / "tests/orthotropic_friction"
TABLES = tempfile.TemporaryDirectory()
PROBES = {"cylinder": (0.625, 3.125, 6.25, 8.75, 10), "block": (-10, -3, 0, 4.5, 10), "sphere": (0.625, 1.25, 1.875, 2.5)}
FORCES, TRACTIONS, SLIPS = 1e-9, 1e-7, 1e-8  # relative to the largest value: what the README promises

ORTHOCONE = {
    "cylinder": f"""include {program.ROOT}/prm/paper/case_a.prm
subsection Mesh
  set Rings      = 12                 # with 4 cells of the core: 16 equal columns
  set Core ratio = 0.353553390593274  # sqrt(2) / 4
  set Layers     = 8
end
""",
    "block": """subsection Geometry
  set Kind  = plane strain
  set Shape = box
  set Sizes = 20, 1, 10
end
subsection Mesh
  set Cells                 = 20, 1, 10
  set Volumetric quadrature = full
end
subsection Friction
  set Coefficients   = 0.30, 0.15
  set Slip potential = 0.05, 0.20
end
subsection Load program
  set Legs = 0 0 -0.01 : 2 ; 0.01 0.01 -0.01 : 10 ; -0.01 -0.01 -0.01 : 20
end
"""}
ORTHOCONE["sphere"] = ORTHOCONE["cylinder"] + """subsection Obstacle
  set Gap = (x^2+y^2)/(2*100)
end
"""
CHANGED = {"sphere": ("cylinder", "  subsection Body\n    set Curvature = 0.01\n  end\n")}


def rows(file):
    with open(file, encoding="ascii") as lines:
        return list(csv.DictReader(lines))


def column(table, name):
    return np.array([float(row[name]) for row in table])


@functools.lru_cache(maxsize=None)
def gallery(case, added=""):
    """The folder of a run of a shipped file, to which parameters are added."""
    shipped, change = CHANGED.get(case, (case, ""))
    folder = pathlib.Path(tempfile.mkdtemp(dir=TABLES.name))
    change += added
    text = (GALLERY / f"{shipped}.prm").read_text(encoding="utf-8")
    (folder / "case.prm").write_text(f"{text}\nsubsection Orthotropic friction\n{change}\nend\n", encoding="utf-8")
    return folder, subprocess.run([BINARY, "case.prm"], cwd=folder, capture_output=True, text=True, check=False, timeout=300)


class GalleryTest(program.RunTest):
    def both(self, case):
        """The folders of a run of the gallery's program and of one of orthocone."""
        folder, run = gallery(case)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        scene = self.folder / f"{case}.prm"
        probes = "; ".join(f"at{i}: {x} 0" for i, x in enumerate(PROBES[case]))
        scene.write_text(ORTHOCONE[case] + f"subsection Output\n  set Probes = {probes}\nend\n", encoding="utf-8")
        ours = self.run_program(case, settings=("Contact solver/Tolerance=1e-12",), file=scene)
        self.assertEqual((ours.returncode, ours.stderr), (0, ""))
        return folder, self.folder / case

    def assert_close(self, values, expected, scale, tolerance):
        self.assertLess(np.abs(values - expected).max(), tolerance * scale)

    def assert_same_history(self, theirs, ours):
        scale = column(ours, "force_z").max()
        is_plane = column(ours, "force_y").any()
        for name in ("force_x", "force_y", "force_z") if is_plane else ("force_z",):  # radial forces have no sum
            self.assert_close(column(theirs, name), column(ours, name), scale, FORCES)
        self.assert_close(column(theirs, "max_slip"), column(ours, "max_slip"), column(ours, "max_slip").max(), SLIPS)
        pressed = column(ours, "force_z") > 0  # at the apex rounding decides
        for name in ("n_open", "n_stick", "n_slip"):
            np.testing.assert_array_equal(column(theirs, name)[pressed], column(ours, name)[pressed], name)

    def assert_same_points(self, case, points, folder):
        most = {"pressure": column(points, "pressure").max(), "slip": np.abs(column(points, "slip_x")).max()}
        for i, x in enumerate(PROBES[case]):
            with self.subTest(x=x):
                ours = rows(folder / f"probe-at{i}.csv")
                theirs = [row for row in points if math.isclose(float(row["x"]), x, abs_tol=1e-9)]
                self.assertEqual(len(theirs), len(ours))
                closed = np.array([row["status"] != "open" for row in ours])  # orthocone's slip of an open node is 0
                for name in ("pressure", "traction_x", "traction_y"):
                    self.assert_close(column(theirs, name), column(ours, name), most["pressure"], TRACTIONS)
                for name in ("slip_x", "slip_y"):
                    self.assert_close(column(theirs, name)[closed], column(ours, name)[closed], most["slip"], SLIPS)

    def test_it_agrees_with_orthocone(self):
        for case in ORTHOCONE:
            with self.subTest(case):
                folder, ours = self.both(case)
                history = rows(folder / "history.csv")
                self.assertLess(column(history, "residual").max(), 1e-11)
                self.assert_same_history(history, rows(ours / "history.csv"))
                self.assert_same_points(case, rows(folder / "contact.csv"), ours)
                if case == "sphere":
                    self.assertGreater(column(history, "n_open").min(), 5)

    def test_block_slides_as_the_slip_rule_says(self):
        folder, _ = gallery("block")
        last = rows(folder / "history.csv")[-1]
        direction = np.square((0.05, 0.20))
        known = direction / np.hypot(*(direction / (0.30, 0.15)))
        ratio = np.array([float(last[f"force_{axis}"]) / float(last["force_z"]) for axis in "xy"])
        self.assert_close(ratio, known, 1, 1e-7)
        page = (GALLERY / "README.md").read_text(encoding="utf-8")
        for name, numbers in (("known answer", known), ("last load step of `block.prm`", ratio)):
            self.assertIn(f"| {name} | {numbers[0]:.7f} | {numbers[1]:.7f} |", page)

    def test_table_of_meshes_is_current(self):
        page = (GALLERY / "README.md").read_text(encoding="utf-8")
        printed = re.findall(r"^\| (\d+) x (\d+) \| ([\d.]+) \| ([\d.]+) \|$", page, re.MULTILINE)
        self.assertEqual(len(printed), 4)
        for columns, layers, slip, force in printed[:2]:  # the others take longer
            folder, _ = gallery("cylinder", f"subsection Body\nset Columns = {columns}\nset Layers = {layers}\nend\n")
            peak = rows(folder / "history.csv")[4]
            self.assertEqual((f"{float(peak['max_slip']):.5f}", f"{float(peak['force_z']) / 1000:.1f}"), (slip, force))

    def test_volume_files_have_the_motion_of_the_plate(self):
        import meshio
        folder, _ = gallery("block")
        grid = meshio.read(folder / "volume-0012.vtu")
        top = np.isclose(grid.points[:, 1], 10)
        np.testing.assert_allclose(grid.point_data["displacement"][top][:, :2], [[0.01, -0.01]] * top.sum(), atol=1e-9)
        np.testing.assert_allclose(grid.point_data["displacement_y"][top].ravel(), 0.01, atol=1e-9)

    def test_wrong_parameters_are_refused(self):
        plate = "subsection Motion of the plate\nset {}\nend\n"
        for added, said in ((plate.format("z = -0.1"), "one number for each leg"), (plate.format("x = 0, 1"), "along z only"),
                            ("subsection Friction\nset Coefficients = 0.2, 0\nend\n", "two numbers > 0"),
                            ("subsection Solver\nset Sweeps = 10\nend\n", "after 10 sweeps")):
            _, run = gallery("cylinder", added)
            self.assertEqual(run.returncode, 1)
            self.assertIn(said, " ".join(run.stderr.split()))


def tearDownModule():
    TABLES.cleanup()


if __name__ == "__main__":
    program.main()
