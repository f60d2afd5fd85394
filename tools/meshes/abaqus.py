# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Reads the mesh of an Abaqus or CalculiX .inp file, with its sets and surfaces. meshio reads no surfaces of such files."""
import collections
import pathlib
import re

import numpy as np
from body import Body, Fault, counted, faces_with

# Of a hexahedron, S1 to S6.
FACES = ((0, 1, 2, 3), (4, 7, 6, 5), (0, 4, 5, 1), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 4, 0))
HEXAHEDRON = re.compile(r"(A|D|DC|DCC)?C3D(8|20)[A-Z]*")
QUADRILATERAL = re.compile(r"(?:D?S|M3D|R3D|SFM3D|CPS|CPE|CAX)([48])[A-Z0-9]*")
NEITHER = re.compile(r"(T[23]D|B[23][1-3]|MASS|ROTARYI|SPRING|DASHPOT|CONN|DCOUP|GAP)[A-Z0-9]*")  # lines, points
MADE = ("NGEN", "NFILL", "NCOPY", "NMAP", "ELGEN", "ELCOPY", "SYSTEM")  # they make or move nodes
MOST_NESTED, MOST_MEMBERS = 20, 10**8


def key_of(name):
    """Names have no case."""
    return name.strip().strip('"').upper()


def found_in(sets, name):
    """What a set of this name has; behind a stop may stand the name of a set of the instance before it."""
    return sets.get(key_of(name)) or sets.get(key_of(name).rpartition(".")[2]) or []


def numbers(words, kind=float):
    try:
        return [kind(word) for word in words if word]
    except ValueError:
        raise Fault(f"has '{', '.join(words)[:60]}' where numbers belong") from None


def parameters_of(line):
    """Keyword and parameters of a line such as *ELEMENT, TYPE=C3D8, ELSET=part."""
    keyword, *words = line.lstrip("*").split(",")
    given = {}
    for word in words:
        name, _, value = word.partition("=")
        given[name.strip().upper().replace(" ", "")] = value.strip().strip('"')
    return " ".join(keyword.upper().split()), given


def blocks(path, depth=0):
    """Keyword, parameters and rows of words of everything in a file and in what it includes."""
    if depth > MOST_NESTED:
        raise Fault(f"includes files more than {MOST_NESTED} deep")
    keyword, given, rows = "", {}, []
    lines = iter(pathlib.Path(path).read_text(encoding="utf-8", errors="replace").splitlines())
    for line in lines:
        line = line.strip()
        if not line or line.startswith("**"):
            continue
        if not line.startswith("*"):
            rows.append([word.strip() for word in line.split(",")])
            continue
        while line.endswith(","):
            line += next(lines, "").strip() or " "
        yield keyword, given, rows
        (keyword, given), rows = parameters_of(line), []
        if keyword == "INCLUDE":
            yield from blocks(pathlib.Path(path).parent / given.get("INPUT", ""), depth + 1)
    yield keyword, given, rows


class AbaqusFile:
    def __init__(self, path):
        self.points, self.hexahedra, self.quadrilaterals = {}, {}, {}
        self.others = collections.Counter()
        self.node_sets, self.element_sets = collections.defaultdict(list), collections.defaultdict(list)
        self.surfaces, self.sections, self.of_elements = {}, [], []
        self.names = {}  # as they were first written
        self.instances, self.shift = 0, np.zeros(3)
        self.notes = []
        readers = {"NODE": self.read_nodes, "ELEMENT": self.read_elements, "NSET": self.read_node_set,
                   "ELSET": self.read_element_set, "SURFACE": self.read_surface, "INSTANCE": self.read_instance,
                   "SOLID SECTION": self.read_section}
        for keyword, given, rows in blocks(path):
            if keyword in MADE:
                raise Fault(f"has *{keyword}: allowed are files with the coordinates of every node and the nodes of every "
                            "element")
            if keyword in readers:
                readers[keyword](given, rows)

    def name(self, given, parameter):
        name = given.get(parameter, "")
        key = key_of(name)
        self.names.setdefault(key, name)
        return key

    def read_nodes(self, given, rows):
        if given.get("SYSTEM", "R").upper() != "R":
            raise Fault("has nodes in cylindrical or spherical coordinates: allowed are x, y, z")
        for row in rows:
            number = int(numbers(row[:1])[0])
            place = numbers(row[1:4])
            if number in self.points:
                raise Fault(f"has node {number} twice: allowed is one body (one part, one instance)")
            self.points[number] = place + [0.0] * (3 - len(place))
            if "NSET" in given:
                self.node_sets[self.name(given, "NSET")].append(number)

    def read_elements(self, given, rows):
        kind = given.get("TYPE", "").upper()
        volume, surface = HEXAHEDRON.fullmatch(kind), QUADRILATERAL.fullmatch(kind)
        if not volume and not surface:
            if not NEITHER.fullmatch(kind):
                self.others[kind or "none"] += sum(1 for row, before in zip(rows, [[]] + rows) if not before or before[-1])
            return
        n = int(volume[2] if volume else surface[1])
        words = numbers([word for row in rows for word in row], int)
        if len(words) % (n + 1):
            raise Fault(f"has elements of type {kind} without {n} nodes each: allowed are complete ones")
        elements = {row[0]: row[1:] if volume else row[1:5] for row in np.reshape(words, (-1, n + 1)).tolist()}
        if len({len(nodes) for cells in (self.hexahedra, elements if volume else {}) for nodes in cells.values()}) > 1:
            raise Fault("has hexahedra of 8 and of 20 nodes: allowed is one kind of hexahedra")
        (self.hexahedra if volume else self.quadrilaterals).update(elements)
        if "ELSET" in given:
            key = self.name(given, "ELSET")
            self.element_sets[key] += elements
            self.of_elements.append(key)

    def members(self, given, rows, sets):
        found = []
        if "GENERATE" in given:
            for row in rows:
                first, last, *step = numbers(row, int)
                if len(members := range(first, last + 1, *step)) > MOST_MEMBERS:
                    raise Fault(f"has a set of {len(members)} members")
                found += members
            return found
        for word in (word for row in rows for word in row if word):
            if word.isdigit():
                found.append(int(word))
            elif members := found_in(sets, word):
                found += members
            else:
                self.notes.append(f"a set names {word}, which is not there")
        return found

    def read_node_set(self, given, rows):
        key = self.name(given, "NSET")
        self.node_sets[key] += self.members(given, rows, self.node_sets)
        for element in found_in(self.element_sets, given.get("ELSET", "")):
            self.node_sets[key] += self.hexahedra.get(element) or self.quadrilaterals.get(element) or []

    def read_element_set(self, given, rows):
        self.element_sets[self.name(given, "ELSET")] += self.members(given, rows, self.element_sets)

    def read_surface(self, given, rows):
        if given.get("TYPE", "ELEMENT").upper() in ("ELEMENT", "NODE") and "COMBINE" not in given:
            self.surfaces[self.name(given, "NAME")] = (given.get("TYPE", "ELEMENT").upper(), rows)
        else:
            self.notes.append(f"surface {given.get('NAME', '')} is of a kind that is not read")

    def read_section(self, given, _rows):
        if "ELSET" in given:
            self.sections.append(self.name(given, "ELSET"))

    def read_instance(self, _given, rows):
        self.instances += 1
        if self.instances > 1:
            raise Fault("has several instances: allowed is one body")
        if len(rows) > 1:
            raise Fault("has an instance that is turned: allowed is one that is only moved")
        if rows:
            self.shift += (numbers(rows[0]) + [0.0] * 3)[:3]


class Sets:
    """Surfaces and volumes of a file as faces and cells of a body."""

    def __init__(self, file):
        if file.others:
            raise Fault("has " + counted(file.others) + ": allowed are hexahedra of 8 or 20 nodes (C3D8, C3D20R "
                        "and the like)")
        self.file, self.numbers = file, list(file.points)
        place = {number: index for index, number in enumerate(self.numbers)}
        missing = sorted({node for cell in file.hexahedra.values() for node in cell} - set(place))
        if missing:
            raise Fault(f"has elements with {len(missing)} nodes that are not there, such as {missing[0]}")
        self.place = place
        self.cells = {number: [place[node] for node in nodes] for number, nodes in file.hexahedra.items()}
        points = np.array(list(file.points.values()), float).reshape(-1, 3) + file.shift
        n_nodes = len(next(iter(self.cells.values()), range(8)))
        self.body = Body(points, np.array(list(self.cells.values()), int).reshape(-1, n_nodes), file.notes)

    def faces_of_row(self, name, row):
        """Of a row of *SURFACE: a set or an element, and a face of them, or all that are on the outside."""
        target, label = row[0], (row[1].upper() if len(row) > 1 else "")
        members = [int(target)] if target.isdigit() else found_in(self.file.element_sets, target)
        if not members:
            self.file.notes.append(f"surface {name} names {target}, which is not there")
        for element in members:
            if element in self.file.quadrilaterals:
                yield self.file_face(element)
            elif element in self.cells and re.fullmatch("S[1-6]", label):
                yield [self.cells[element][i] for i in FACES[int(label[1]) - 1]]
            elif element in self.cells and not label:
                yield from ([self.cells[element][i] for i in face] for face in FACES)

    def file_face(self, element):
        return [self.place.get(node, -1) for node in self.file.quadrilaterals[element]]

    def faces_at(self, numbers):
        return faces_with(self.body.border, [self.place[number] for number in numbers if number in self.place])

    def read(self):
        file = self.file
        for key, (kind, rows) in file.surfaces.items():
            name, rows = file.names[key], [row for row in rows if row and row[0]]
            if kind == "NODE":
                targets = [[int(row[0])] if row[0].isdigit() else found_in(file.node_sets, row[0]) for row in rows]
                self.body.add_surface(name, self.faces_at([node for nodes in targets for node in nodes]))
            else:
                is_free = any(len(row) < 2 or not row[1] for row in rows)
                self.body.add_surface(name, [face for row in rows for face in self.faces_of_row(name, row)], part=is_free)
        for key, elements in file.element_sets.items():
            if faces := [self.file_face(element) for element in elements if element in file.quadrilaterals]:
                self.body.add_surface(file.names[key], faces)
        for key, nodes in file.node_sets.items():
            faces = self.faces_at(nodes)
            if 0 < len(faces) < len(self.body.border) and not self.body.has_surface(file.names[key]):
                self.body.add_surface(file.names[key], faces)
        self.read_volumes()
        return self.body

    def read_volumes(self):
        """What has a material of its own, or else what the elements were given in."""
        row = {number: index for index, number in enumerate(self.cells)}
        for key in self.file.sections or self.file.of_elements:
            cells = [row[number] for number in self.file.element_sets.get(key, []) if number in row]
            self.body.add_volume(self.file.names[key], cells)


def read(path):
    try:
        return Sets(AbaqusFile(path)).read()
    except (ValueError, IndexError, TypeError, OverflowError) as error:
        raise Fault(f"is damaged ({' '.join(str(error).split())[:100]})") from None
