# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Bodies from mesh files: the shipped examples, both backends, and runs that are refused.

Usage: test_import.py PROGRAM [unittest options]"""
import json
import math
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
import program  # noqa: E402
from program import ROOT  # noqa: E402

IMPORT = ROOT / "prm/import"
WRONG_INPUT = 2


class ImportTest(program.RunTest):
    FILE = IMPORT / "cylinder.prm"
    ONE_CYCLE = ["Load program/Cycles=1", "Output/Volume fields=0"]

    def numbers(self, output, *settings, file=None, step=5):
        result = self.run_program(output, settings=[*self.ONE_CYCLE, *settings], file=file)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        row = self.rows(output)[step - 1]
        return {key: float(row[key]) for key in ("force_x", "force_z", "max_slip", "total_dissipation")}

    def assert_near(self, numbers, expected, share):
        for key in ("force_z", "max_slip"):
            self.assertAlmostEqual(numbers[key] / expected[key], 1, delta=share, msg=key)

    def test_cylinder_of_gmsh(self):
        """22 quadrilaterals of its quarter against the 80 of the built-in one; the facets lack 0.6 % of the area."""
        self.assert_near(self.numbers("file"), self.numbers("built_in", file=ROOT / "prm/paper/case_b.prm"), 0.03)

    def test_finer_meshes_of_gmsh_come_near_the_built_in_cylinder(self):
        """The facets lack an area that falls with the square of their size; the force differs by less than that."""
        peak = ["Load program/Legs=0 0 -0.1 : 5", "Output/Contact fields=0"]
        expected = self.numbers("built_in", *peak, "Mesh/Resolution=medium", file=ROOT / "prm/paper/case_b.prm")
        errors = []
        for mesh in ("cylinder_coarse", "cylinder", "cylinder_fine"):  # each has cells of half the size of the one before
            found = self.numbers(mesh, *peak, f"Geometry/Mesh file={IMPORT / mesh}.msh")
            area = json.loads((self.folder / mesh / "summary.json").read_text())["scene"]["area_mm2"]
            errors.append({"area": abs(area / (100 * math.pi) - 1),
                           **{key: abs(found[key] / expected[key] - 1) for key in ("force_z", "max_slip", "total_dissipation")}})
            self.assertLess(errors[-1]["force_z"], errors[-1]["area"])
        for coarse, fine in zip(errors, errors[1:]):
            self.assertAlmostEqual(coarse["area"] / fine["area"], 4, delta=0.1)
            for key, factor in (("force_z", 4), ("max_slip", 1.3), ("total_dissipation", 1.7)):
                self.assertGreater(coarse[key] / fine[key], factor, key)
        self.assertLess(errors[-1]["force_z"], 0.0012)

    def test_backends(self):
        halved = ["Mesh/Refinements=1", "Mesh/Degree=1"]
        condensed = self.numbers("condensed", *halved, "Mesh/Backend=condensed")
        self.assert_near(self.numbers("multigrid", *halved, "Mesh/Backend=multigrid"), condensed, 1e-7)

    def test_pin_has_its_gap(self):
        """As a cylinder on the plane with the gap of the sphere; the bodies differ by the cap."""
        cap = self.numbers("cap", file=IMPORT / "pin.prm", step=10)
        gap = self.numbers("gap", "Geometry/Shape=cylinder", "Geometry/Radius=3", "Geometry/Height=6", "Mesh/Model=quarter",
                           "Obstacle/Gap=10-sqrt(100-x^2-y^2)", file=IMPORT / "pin.prm", step=10)
        self.assertAlmostEqual(cap["force_z"] / gap["force_z"], 1, delta=0.1)

    def test_dovetail_slides(self):
        peak = self.numbers("dovetail", file=IMPORT / "dovetail.prm", step=6)
        self.assertGreater(peak["force_z"], 0)
        self.assertAlmostEqual(abs(peak["force_x"]) / peak["force_z"], 0.3, delta=1e-3)

    def test_check_reports_what_was_found(self):
        result = self.run_program("none", "--check")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        for line in (r"volume +body \(5\): 88 cells, 780\.361 mm\^3", r"surface +base \(1\): 22 faces, 78\.0361 mm\^2",
                     r"worst cell +at \(.*\) mm, scaled Jacobian 0\.71", r"contact height 0 to 0 mm above z = 0",
                     r"model +quarter \(the part that the mesh file contains\)"):
            self.assertRegex(result.stdout, rf"(?m)^{line}")

    def test_what_does_not_go_together(self):
        for settings, expression in (
                (["Mesh/Model=full"], "Mesh/Model = full is not possible: the mesh file contains the quarter body"),
                (["Friction/Orthotropy angle=10"], "Geometry/Symmetry surfaces: the mesh file ends at x = 0, about which"),
                (["Mesh/Accuracy=1 %"], "Mesh/Accuracy = 1 % with Geometry/Shape = file: allowed is 0"),
                (["Mesh/Resolution=fine"], "Mesh/Resolution = fine with Geometry/Shape = file: allowed is custom"),
                (["Material/Regions=bdy: 1, 0"], r"Material/Regions: 'bdy' is no physical volume: allowed in \S+ are body \(5\)"),
                (["Material/Regions=body: 1, 0", "Mesh/Backend=multigrid"], "Material/Regions = body: 1, 0 with Mesh/Backend = multigrid")):
            with self.subTest(settings=settings):
                result = self.run_program("none", "--check", settings=settings)
                self.assertEqual(result.returncode, WRONG_INPUT)
                self.assertRegex(result.stderr, rf"^orthocone: \S*cylinder\.prm: {expression}.*\n$")

    def test_bad_mesh_files_get_one_line(self):
        """A handful of those of the unit tests BadMeshFile, through the program."""
        good = (IMPORT / "cylinder.msh").read_text(encoding="ascii")
        file = self.folder / "bad.msh"
        for fault, text, expression in (
                ("empty", "", "is empty; a mesh is wanted"),
                ("cut", good[:len(good) // 2], "cut off or damaged"),
                ("binary", good.replace("4.1 0 8", "4.1 1 8"), "is a binary mesh: allowed is one in ASCII"),
                ("STL", "solid body\nendsolid\n", r"begins with 'solid body': allowed is \$MeshFormat"),
                ("no number", good.replace("\n10 0 10\n", "\n10 nan 10\n"), "has 'nan': allowed is a number"),
                ("below", good.replace("\n10 0 0\n", "\n10 0 -1\n"), r"is below the plane at \(10, 0, -1\) mm"),
                ("name", good.replace('"base"', '"foot"'), r"Contact surface = base is no physical surface: allowed in \S+ are foot")):
            with self.subTest(fault):
                self.assertNotEqual(text, good)
                file.write_text(text, encoding="ascii")
                result = self.run_program("none", settings=[f"Geometry/Mesh file={file}"])
                self.assertEqual((result.returncode, result.stdout), (WRONG_INPUT, ""))
                self.assertRegex(result.stderr, rf"^orthocone: [^\n]*{expression}[^\n]*\n$")
                self.assertFalse((self.folder / "none").exists())

    def test_force_before_contact(self):
        """The pin lifted by 0.1 mm: a force alone would not say how it comes down."""
        lines = (IMPORT / "pin.msh").read_text(encoding="ascii")
        head, rest = lines.split("$Nodes\n")
        nodes, tail = rest.split("$EndNodes")
        lifted = "\n".join(" ".join([*line.split()[:2], repr(float(line.split()[2]) + 0.1)])
                           if len(line.split()) == 3 else line for line in nodes.split("\n"))
        (self.folder / "pin.msh").write_text(head + "$Nodes\n" + lifted + "$EndNodes" + tail, encoding="ascii")
        result = self.run_program("none", "--check", file=IMPORT / "pin.prm", settings=[
            f"Geometry/Mesh file={self.folder / 'pin.msh'}", "Load program/Legs=Fz -10 : 1"])
        self.assertEqual(result.returncode, WRONG_INPUT)
        self.assertRegex(result.stderr, r"Fz presses from leg 1 on, where a gap of 0\.1\d* mm is open")

    def test_resume_refuses_another_mesh(self):
        mesh = self.folder / "own.msh"
        text = (IMPORT / "cylinder.msh").read_text(encoding="ascii")
        mesh.write_text(text, encoding="ascii")
        settings = [*self.ONE_CYCLE, f"Geometry/Mesh file={mesh}"]
        self.assertEqual(self.run_program("run", settings=settings).returncode, 0)
        self.assertEqual(self.run_program("run", "--resume", settings=settings).returncode, 0)
        mesh.write_text(text.replace("\n10 0 10\n", "\n10 0 10.5\n"), encoding="ascii")
        result = self.run_program("run", "--resume", settings=settings)
        self.assertEqual(result.returncode, WRONG_INPUT)
        self.assertRegex(result.stderr, r"Geometry/Mesh file = \S+own\.msh: has other content than when the run in ")


if __name__ == "__main__":
    program.main()
