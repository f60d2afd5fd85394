# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Files have at most 400 lines, functions 40, a folder a quarter of the code; folders mirror each other.

A program for deal.II's gallery is one file, which the gallery shows as a page of text and code."""
import ast
import collections
import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
MOST_LINES, MOST_OF_FUNCTION, MOST_OF_FOLDER = 400, 40, 0.25
MOST_OF_GALLERY, GALLERY = 800, ROOT / "examples/dealii_gallery"


def files(*folders):
    return [path for folder in folders for path in sorted((ROOT / folder).rglob("*")) if path.suffix in (".cc", ".h")]


def bodies(path):
    """Blocks between braces of their own at the left margin: functions, classes and structs. Yields (line, length)."""
    opened = None
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if line == "{":
            opened = number
        elif line.startswith("}") and opened:
            if line == "}":
                yield opened, number - opened + 1
            opened = None


def inner_bodies(path):
    """All blocks between braces but those of namespaces and types. Yields (line, length)."""
    opened, last = [], ""
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        code = re.sub(r"//.*|\"(\\.|[^\"\\])*\"|'(\\.|[^'\\])*'", "", line)
        for sign in code:
            if sign == "{":
                of_type = re.search(r"\b(namespace|class|struct|enum)\b", last + " " + code)
                opened.append((number, bool(of_type)))
            elif sign == "}" and opened:
                first, of_type = opened.pop()
                if not of_type:
                    yield first, number - first + 1
        last = code if code.strip() else last


class SizeTest(unittest.TestCase):
    def test_files(self):
        for path in files("source", "include", "tests", "tools", "examples"):
            with self.subTest(path.relative_to(ROOT)):
                most = MOST_OF_GALLERY if GALLERY in path.parents else MOST_LINES
                self.assertLessEqual(len(path.read_text(encoding="utf-8").splitlines()), most)

    def test_functions(self):
        found = 0
        for path in files("source", "tests", "tools", "examples"):
            for line, length in bodies(path):
                found += 1
                with self.subTest(f"{path.relative_to(ROOT)}:{line}"):
                    self.assertLessEqual(length, MOST_OF_FUNCTION)
        self.assertGreater(found, 1000)

    def test_functions_of_scripts(self):
        for path in [*sorted((ROOT / "tools").rglob("*.py")), *sorted((ROOT / "tests").rglob("*.py"))]:
            for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
                if isinstance(node, ast.FunctionDef):
                    with self.subTest(f"{path.relative_to(ROOT)}:{node.lineno}"):
                        self.assertLessEqual(node.end_lineno - node.lineno + 1, MOST_OF_FUNCTION)

    def test_functions_in_headers(self):
        """Those of templates and classes, whose braces are not at the margin."""
        for path in files("include", "source", "tests", "tools"):
            for line, length in inner_bodies(path):
                with self.subTest(f"{path.relative_to(ROOT)}:{line}"):
                    self.assertLessEqual(length, MOST_OF_FUNCTION)

    def test_folders(self):
        lines = collections.Counter()
        for path in files("source", "include/orthocone"):
            below = path.relative_to(ROOT / ("source" if (ROOT / "source") in path.parents else "include/orthocone"))
            lines[below.parts[0]] += len(path.read_text(encoding="utf-8").splitlines())
        for folder, count in lines.items():
            with self.subTest(folder):
                self.assertLessEqual(count, MOST_OF_FOLDER * sum(lines.values()))

    def test_folders_mirror_each_other(self):
        for root in ("include/orthocone", "tests/unit"):
            for folder in sorted({path.parent.relative_to(ROOT / root) for path in files(root)}):
                with self.subTest(f"{root}/{folder}"):
                    self.assertTrue((ROOT / "source" / folder).is_dir())

    def test_tests_lie_where_their_sources_do(self):
        """Those of whole scenes and of laws in headers are named after what they show."""
        of_topics = {
            "body/backends/curved_held_face", "body/fe/projected_pressure", "body/fe/rates", "body/shapes/bad_mesh_files",
            "contact/law/frictionless", "contact/law/projection", "contact/law/slip_rule", "contact/solvers/elastic_layer", "contact/solvers/failures", "contact/solvers/grid_half_space", "multigrid/hanging_nodes",
            "results/axisymmetric", "results/forces", "results/curved_bodies", "results/frames", "results/gaps",
            "results/half_space",
            "results/imported", "results/lower_body", "results/orthotropic", "results/path_dependence", "results/physics",
            "results/loads", "results/memory", "results/plane_strain", "results/stick_at_rest", "results/supports", "results/symmetry", "results/torsion", "results/wear", "scene/body_entries", "scene/parameter_files"}
        tests = {path.relative_to(ROOT / "tests/unit").with_suffix("") for path in files("tests/unit") if path.suffix == ".cc"}
        sources = {path.relative_to(ROOT / root).with_suffix("") for root in ("source", "include/orthocone") for path in files(root)}
        self.assertEqual({str(path) for path in tests - sources}, of_topics)


if __name__ == "__main__":
    unittest.main()
