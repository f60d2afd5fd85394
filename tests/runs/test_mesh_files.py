# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Meshes as other programs write them: surfaces by their place, and files that tools/import converts.

Usage: test_mesh_files.py PROGRAM [unittest options]"""
import contextlib
import io
import itertools
import re
import subprocess
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
import meshio  # noqa: E402
import numpy as np  # noqa: E402
import program  # noqa: E402
from program import ROOT  # noqa: E402

WRONG_INPUT, FILE_ERROR = 2, 4
CELLS, SIZES = (3, 4, 2), (3.0, 2.0, 1.0)  # mm
CORNERS = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))  # in the order of Gmsh
FACES = {"S1": (0, 1, 2, 3), "S2": (4, 7, 6, 5), "S3": (0, 4, 5, 1), "S4": (1, 5, 6, 2), "S5": (2, 6, 7, 3), "S6": (3, 7, 4, 0)}
PLACED = ["Geometry/Contact surface=z min", "Geometry/Held surface=z = 1"]
NAMED = ["Geometry/Contact surface=foot", "Geometry/Held surface=head"]
TABLES = ("history.csv", "contact-0002.vtu", "checks.csv")


def box():
    """Nodes of a box of cells that are no bricks inside, and the cells."""
    steps = [np.linspace(0, size, n + 1) for size, n in zip(SIZES, CELLS)]
    nodes = np.array(list(itertools.product(*steps)))
    inside = np.all((nodes > 0) & (nodes < SIZES), axis=1)
    nodes[inside] += 0.1 * np.sin(np.arange(3 * inside.sum())).reshape(-1, 3)
    number = np.arange(len(nodes)).reshape([n + 1 for n in CELLS])
    cells = [[number[tuple(np.add(cell, corner))] for corner in CORNERS] for cell in itertools.product(*map(range, CELLS))]
    return nodes, np.array(cells)


EDGES = ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7))  # in the order of Abaqus
IN_GMSH = (0, 3, 8, 1, 9, 2, 10, 11, 4, 7, 5, 6)


def with_middles(nodes, cells):
    """Nodes with those in the middles of bent edges, and the cells of 20 nodes in the order of Abaqus."""
    ends = np.sort(cells[:, EDGES], axis=2)
    edges, number = np.unique(ends.reshape(-1, 2), axis=0, return_inverse=True)
    middles = nodes[edges].mean(axis=1)
    middles += 0.1 * np.sin(np.arange(middles.size)).reshape(-1, 3) * (middles[:, 2] * (1 - middles[:, 2]))[:, None]
    return np.vstack([nodes, middles]), np.hstack([cells, len(nodes) + number.reshape(len(cells), -1)])


def faces_at(nodes, cells, z):
    """Rows of cell, label and nodes of the faces at a height."""
    return [(cell, label, cells[cell][list(face)]) for cell in range(len(cells)) for label, face in FACES.items()
            if np.all(nodes[cells[cell][list(face)], 2] == z)]


def msh(nodes, elements, names="", version="2.2"):
    """Elements are rows of type, group and nodes."""
    lines = ["$MeshFormat", f"{version} 0 8", "$EndMeshFormat"]
    lines += [f"$PhysicalNames\n{names.count(chr(10)) + 1}\n{names}\n$EndPhysicalNames"] if names else []
    lines += ["$Nodes", len(nodes), *(f"{i} {x!r} {y!r} {z!r}" for i, (x, y, z) in enumerate(nodes.tolist(), 1)), "$EndNodes"]
    lines += ["$Elements", len(elements), *(f"{i} {kind} 2 {group} {group} " + " ".join(str(node + 1) for node in rest)
                                            for i, (kind, group, rest) in enumerate(elements, 1)), "$EndElements", ""]
    return "\n".join(map(str, lines))


def binary_41(nodes, blocks, names):
    """Format 4.1; blocks are rows of dimension, type, physical group and an array of nodes. All are entities."""
    def section(name, *parts):
        return f"${name}\n".encode() + b"".join(np.asarray(part).tobytes() for part in parts) + f"\n$End{name}\n".encode()

    surfaces = sum(dim == 2 for dim, *_ in blocks)
    entities = [part for _, _, group, _ in blocks
                for part in (np.int32(group), np.zeros(6), np.uint64(1), np.int32(group), np.uint64(0))]
    elements, n = [], 0
    for dim, kind, group, rows in blocks:
        elements += [np.int32([dim, group, kind]), np.uint64(len(rows)),
                     np.column_stack([np.arange(n, n + len(rows)), rows]).astype(np.uint64) + np.uint64(1)]
        n += len(rows)
    return (b"$MeshFormat\n4.1 1 8\n" + np.int32(1).tobytes() + b"\n$EndMeshFormat\n"
            + f"$PhysicalNames\n{len(blocks)}\n{names}\n$EndPhysicalNames\n".encode()
            + section("Entities", np.uint64([0, 0, surfaces, len(blocks) - surfaces]), *entities)
            + section("Nodes", np.uint64([1, len(nodes), 1, len(nodes)]), np.int32([3, blocks[-1][2], 0]),
                      np.uint64([len(nodes), *range(1, len(nodes) + 1)]), nodes)
            + section("Elements", np.uint64([len(blocks), n, 1, n]), *elements))


def inp(nodes, cells, sets):
    rows = ["** as a preprocessor writes it", "*Heading", "*NODE, NSET=all", *(
        f"{i}, " + ", ".join(map(repr, place)) for i, place in enumerate(nodes.tolist(), 1)), "*Element, type=C3D8R, ELSET=Part"]
    for i, cell in enumerate(cells, 1):
        rows += [f"{i}, " + ", ".join(str(node + 1) for node in cell[:4]) + ",", ", ".join(str(node + 1) for node in cell[4:])]
    return "\n".join([*rows, sets, "*MATERIAL, NAME=steel", "*ELASTIC", "210000., 0.3", ""])


class MeshFileTest(program.RunTest):
    SETTINGS = ["Geometry/Shape=file", "Mesh/Degree=1", "Load program/Legs=0 0 -0.001 : 1 ; 0.0005 0 -0.001 : 1",
                "Load program/Cycles=1", "Output/Checkpoint=0", "Output/Probes="]

    def setUp(self):
        super().setUp()
        self.FILE = self.folder / "scene.prm"
        self.FILE.write_text("subsection Load program\n  set Legs = 0 0 -0.001 : 2\nend\n", encoding="ascii")
        self.nodes, self.cells = box()
        self.foot, self.head = (faces_at(self.nodes, self.cells, z) for z in (0, 1))
        hexahedra = [(5, 7, cell) for cell in self.cells]
        quads = [(3, group, face) for group, faces in ((1, self.foot), (2, self.head)) for _, _, face in faces]
        self.write("named.msh", msh(self.nodes, quads + hexahedra, '2 1 "foot"\n2 2 "head"\n3 7 "part"'))
        self.write("one_tag.msh", msh(self.nodes, [(kind, 1, rest) for kind, _, rest in quads + hexahedra]))
        self.write("cells.msh", msh(self.nodes, hexahedra, version="2.1"))

    def write(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")

    def solve(self, mesh, *settings):
        output = f"run-{mesh}"
        result = self.run_program(output, "--threads=1", settings=[*self.SETTINGS, f"Geometry/Mesh file={self.folder / mesh}",
                                                                   *settings])
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return output

    def convert(self, *words):
        return subprocess.run([sys.executable, ROOT / "tools/meshes/import_mesh.py", *words], cwd=self.folder, text=True,
                              capture_output=True, timeout=60, check=False)

    def converted(self, name):
        result = self.convert(name, "converted.msh")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return result.stdout

    def refused(self, name, expression, code=WRONG_INPUT):
        result = self.convert(name, "none.msh")
        self.assertEqual((result.returncode, result.stdout), (code, ""))
        self.assertRegex(result.stderr, rf"^import: [^\n]*{expression}[^\n]*\n$")
        self.assertFalse((self.folder / "none.msh").exists())


class PlaceTest(MeshFileTest):
    def test_places_are_names(self):
        """To the last bit, also with one tag for all elements, and with nothing but cells in format 2.1."""
        names = self.solve("named.msh", *NAMED)
        for mesh in ("one_tag.msh", "cells.msh"):
            self.assert_same_files(self.solve(mesh, *PLACED), names, TABLES)
        result = self.run_program("again", "--threads=1", file=self.folder / "run-cells.msh/parameters.prm")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assert_same_files("again", names, TABLES)

    def test_a_bar_by_its_places(self):
        """Without friction and lateral strain, the force is E A u / H."""
        bar = self.solve("cells.msh", *PLACED, "Material/Poisson ratio=0", "Material/Young modulus=1000",
                         "Friction/Coefficients=0, 0", "Load program/Legs=0 0 -0.001 : 1")
        self.assertAlmostEqual(float(self.rows(bar)[0]["force_z"]), 1000 * 6 * 0.001, delta=1e-8)

    def test_places_of_both_bodies(self):
        lower = ["Obstacle/Kind=body", "Lower geometry/Shape=file", "Lower mesh/Degree=1"]
        results = [self.solve(mesh, *upper, *lower, f"Lower geometry/Mesh file={self.folder / mesh}",
                              *(f"Lower {word[0].lower()}{word[1:]}" for word in upper))
                   for mesh, upper in (("named.msh", NAMED), ("cells.msh", PLACED))]
        self.assert_same_files(*results, TABLES)
        result = self.run_program("none", settings=[*self.SETTINGS, *lower, *PLACED, "Lower geometry/Contact surface=z = 3",
                                                    f"Lower geometry/Mesh file={self.folder / 'cells.msh'}",
                                                    f"Geometry/Mesh file={self.folder / 'cells.msh'}"])
        self.assertEqual(result.returncode, WRONG_INPUT)
        self.assertRegex(result.stderr, "Lower geometry/Contact surface = z = 3 has no faces; Lower geometry/Held surface is "
                         "empty: ")

    def test_a_message_says_how_to_name_a_surface(self):
        result = self.run_program("none", settings=[*self.SETTINGS, *NAMED, f"Geometry/Mesh file={self.folder / 'cells.msh'}"])
        self.assertEqual((result.returncode, result.stdout), (WRONG_INPUT, ""))
        self.assertRegex(result.stderr, r"^orthocone: \S+: Geometry/Contact surface = foot is no physical surface; Geometry/Held "
                         r"surface = head is no physical surface: allowed in \S+, which has no physical surfaces \(gmsh: Physical "
                         r'Surface\("base"\) = \{1\}\), are x min \(0\), x max \(3\), y min \(0\), y max \(2\), z min \(0\), '
                         r"z max \(1\) and other planes on its outside such as x = 0\n$")

    def test_words_that_are_no_places(self):
        for word in ("z mx", "z = nan", "w min", "x = 1e400", "", "zmin", "z =", "z = 1 mm", "z = 1e-400x", "z = 0x1", b"z \xff"):
            with self.subTest(word=word):
                word = word if isinstance(word, bytes) else word.encode()
                held = b"--set=Geometry/Held surface=" + word
                result = subprocess.run([*self.command("none", settings=[
                    *self.SETTINGS, PLACED[0], f"Geometry/Mesh file={self.folder / 'cells.msh'}"]), held],
                    capture_output=True, timeout=60, check=False)
                self.assertEqual((result.returncode, result.stdout), (WRONG_INPUT, b""))
                self.assertRegex(result.stderr, rb"^orthocone: [^\n]*Geometry/Held surface (is empty|= [^\n]* is no physical surface"
                                 rb")[^\n]*z max \(1\)[^\n]*\n$")


class ImportTest(MeshFileTest):
    def test_files_of_gmsh(self):
        """Binary files keep names and numbers: the same run to the last bit."""
        names = self.solve("named.msh", *NAMED)
        file = self.folder / "binary.msh"
        with contextlib.redirect_stdout(io.StringIO()):  # meshio prints an empty line
            named = meshio.read(self.folder / "named.msh")
        foot, head = (np.array([face for _, _, face in faces]) for faces in (self.foot, self.head))
        blocks = [(2, 3, 1, foot), (2, 3, 2, head), (3, 5, 7, self.cells)]
        for version, write in {
                "2.2": lambda: meshio.write(file, named, file_format="gmsh22", binary=True),
                "4.1": lambda: file.write_bytes(binary_41(self.nodes, blocks, '2 1 "foot"\n2 2 "head"\n3 7 "part"'))}.items():
            with self.subTest(version):
                write()
                result = self.run_program("none", settings=[*self.SETTINGS, f"Geometry/Mesh file={self.folder / 'binary.msh'}"])
                self.assertEqual(result.returncode, WRONG_INPUT)
                self.assertRegex(result.stderr, r"is not a text file; a mesh by Gmsh in ASCII .* which tools/import makes of binary ")
                self.assertIn("surfaces: foot (12 faces), head (12 faces)\nimport: volumes: part\n", self.converted("binary.msh"))
                self.assert_same_files(self.solve("converted.msh", *NAMED), names, TABLES)

    def test_second_order(self):
        """Hexahedra of 20 nodes by Abaqus and in binary files keep their edges: the same run to the last bit."""
        nodes, cells = with_middles(self.nodes, self.cells)
        middle = {frozenset(cell[list(edge)]): cell[8 + i] for cell in cells for i, edge in enumerate(EDGES)}
        hexahedra = [(17, 3, cell[[*range(8), *(8 + i for i in IN_GMSH)]]) for cell in cells]
        quads = [(16, group, [*face, *(middle[frozenset(pair)] for pair in zip(face, np.roll(face, -1)))])
                 for group, faces in ((1, self.foot), (2, self.head)) for _, _, face in faces]
        self.write("curved.msh", msh(nodes, quads + hexahedra, '2 1 "foot"\n2 2 "head"\n3 3 "Part"'))
        curved = self.solve("curved.msh", *NAMED, "Mesh/Degree=2")
        faces = {name: "\n".join(f"{cell + 1}, {label}" for cell, label, _ in rows)
                 for name, rows in (("foot", self.foot), ("head", self.head))}
        rows = ["*ELEMENT, TYPE=C3D20R, ELSET=Part\n"] + [
            f"{i}, {', '.join(str(node + 1) for node in cell)}\n" for i, cell in enumerate(cells, 1)]
        self.write("curved.inp", "*NODE\n" + "".join(f"{i}, {x!r}, {y!r}, {z!r}\n" for i, (x, y, z) in enumerate(nodes.tolist(), 1))
                   + "".join(rows) + "".join(f"*SURFACE, NAME={name}\n{text}\n" for name, text in faces.items()))
        with contextlib.redirect_stdout(io.StringIO()):
            meshio.write(self.folder / "binary.msh", meshio.read(self.folder / "curved.msh"), file_format="gmsh22", binary=True)
        for name in ("curved.inp", "binary.msh"):
            with self.subTest(name):
                self.assertIn("surfaces: foot (12 faces), head (12 faces)\nimport: volumes: Part\n", self.converted(name))
                self.assert_same_files(self.solve("converted.msh", *NAMED, "Mesh/Degree=2"), curved, TABLES)
        straight = self.solve("named.msh", *NAMED, "Mesh/Degree=2")
        self.assertNotEqual((self.folder / straight / TABLES[0]).read_bytes(), (self.folder / curved / TABLES[0]).read_bytes())

    def test_surfaces_of_abaqus(self):
        """Faces of elements, sets of shells, sets of nodes: the same run to the last bit."""
        names = self.solve("named.msh", *NAMED)
        faces = {name: "\n".join(f"{cell + 1}, {label}" for cell, label, _ in rows)
                 for name, rows in (("foot", self.foot), ("head", self.head))}
        nodes = {name: ",\n".join(str(node + 1) for node in np.unique([face for _, _, face in rows]))
                 for name, rows in (("foot", self.foot), ("head", self.head))}
        shells = "\n".join(f"{900 + i}, " + ", ".join(str(node + 1) for node in face) for i, (_, _, face) in enumerate(self.foot))
        (label,) = {label for _, label, _ in self.foot}
        low = "\n".join(f"{cell + 1}," for cell, _, _ in self.foot)
        for kind, sets in {
                "faces": f"*SURFACE, NAME=foot, TYPE=ELEMENT\n{faces['foot']}\n*Surface, name=head\n{faces['head']}",
                "sets of elements": f"*ELSET, ELSET=_low\n{low}\n*SURFACE, NAME=foot\n_LOW, {label}\n*SURFACE,\nNAME=head\n"
                                    f"{faces['head']}",
                "shells": f"*ELEMENT, TYPE=S4, ELSET=foot\n{shells}\n*NSET, NSET=head\n{nodes['head']}",
                "nodes": f"*NSET, NSET=set-1\n{nodes['foot']}\n*SURFACE, TYPE=NODE, NAME=foot\nassembly.set-1, 1.\n"
                         f"*NSET, NSET=head, INSTANCE=part-1\n{nodes['head']}"}.items():
            with self.subTest(kind):
                self.write("part.inp", inp(self.nodes, self.cells, sets))
                said = self.converted("part.inp")
                for name in ("foot", "head"):
                    self.assertIn(f"{name} (12 faces)", said)
                self.assert_same_files(self.solve("converted.msh", *NAMED), names, TABLES)

    def test_free_surface_and_generated_set_of_abaqus(self):
        n = len(self.cells)
        self.write("part.inp", inp(self.nodes, self.cells, f"*ELSET, ELSET=every, GENERATE\n1, {n}, 1\n*SURFACE, NAME=skin\nevery\n"
                                   "*SURFACE, NAME=none\nnobody, S1"))
        said = self.converted("part.inp")
        self.assertIn("surfaces: skin (52 faces)\n", said)  # 2 (3 x 4 + 3 x 2 + 4 x 2)
        self.assertIn("note: surface none names nobody, which is not there\n", said)

    def test_metres_become_millimetres(self):
        result = self.convert("named.msh", "mm.msh", "--scale", "1000")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertRegex(result.stdout, r"24 hexahedra in x = 0 to 3000, y = 0 to 2000, z = 0 to 1000 mm")

    def test_what_is_no_mesh_of_hexahedra_is_refused(self):
        nodes = "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n4, 0, 0, 1\n"
        for text, expression in (
                ("", "bad.inp: is empty"), ("*HEADING\n", "has no hexahedra"),
                (nodes + "*ELEMENT, TYPE=C3D4\n1, 1, 2, 3, 4\n*ELEMENT, TYPE=S3\n2, 1, 2, 3\n", "has 1 C3D4, 1 S3: allowed are "),
                (nodes + "*ELEMENT, TYPE=C3D8\n1, 1, 2, 3, 4\n", "type C3D8 without 8 nodes each"),
                (nodes + "*ELEMENT, TYPE=C3D8\n1, 1, 2, 3, 4, 5, 6, 7, 8\n", "4 nodes that are not there, such as 5"),
                (nodes + "1, 0, 0, 0\n", "has node 1 twice"), (nodes + "five, 0, 0, 0\n", "has 'five' where numbers belong"),
                (nodes + "*NGEN\n1, 4\n", r"has \*NGEN"), ("*INCLUDE, INPUT=bad.inp\n", "includes files more than 20 deep"),
                ("*NSET, NSET=a, GENERATE\n1, 999999999999\n", "has a set of 999999999999 members"),
                ("*NSET, NSET=a, GENERATE\n1, 5, 0\n", "is damaged"), ("*NODE\n,,,\n", "is damaged"),
                ("*NODE\n1e400, 0\n", "is damaged"), ("*INSTANCE\n*INSTANCE\n", "has several instances"),
                ("*NODE\n\x1b[31m" + 700 * "1", r"has '\\x1b\[31m1{40,}"),
                ("$MeshFormat\n4.1 1 8\n", "is no mesh that meshio reads|has no hexahedra"),
                ("\x00\x01", "has no hexahedra")):
            with self.subTest(text=text):
                self.write("bad.inp", text)
                self.refused("bad.inp", expression)
        self.refused("nowhere.inp", "nowhere.inp: No such file", FILE_ERROR)
        self.refused(".", "Is a directory", FILE_ERROR)

    def test_files_stay_as_they_are(self):
        text = (self.folder / "named.msh").read_bytes()
        result = self.convert("named.msh", "named.msh")
        self.assertEqual((result.returncode, result.stdout), (WRONG_INPUT, ""))
        self.assertEqual((self.folder / "named.msh").read_bytes(), text)
        result = self.convert("named.msh", "no/folder.msh")
        self.assertEqual((result.returncode, result.stdout), (FILE_ERROR, ""))
        self.assertTrue(re.fullmatch(r"import: no/folder\.msh: [^\n]+\n", result.stderr), result.stderr)


if __name__ == "__main__":
    program.main()
