# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Every public part of the Python module says what it takes and gives, with shapes and units, and keeps its word on them.

Usage: test_docstrings.py PROGRAM [unittest options]"""
import dataclasses
import inspect
import re
import sys
import unittest

import numpy as np
from python_module import row_of_nodes

import orthocone

UNIT = r"(?:mm/N|mm|N|without units)"
# A scalar has no shape; what a unit would be of these is not to be asked.
WITHOUT_UNITS = {"method", "tolerance", "maximum_iterations"}
FUNCTIONS = {name: value for name in orthocone.__all__ if inspect.isfunction(value := getattr(orthocone, name))}
CLASSES = {name: value for name in orthocone.__all__ if inspect.isclass(value := getattr(orthocone, name))}


def said_of(name, text):
    """What a docstring says of a parameter, up to the end of the sentence."""
    match = re.search(rf"(?<!\w){name}: (.*?)(?:\.\s|\.?\Z)", " ".join(text.split()))
    return match[1] if match else None


def members(cls):
    """Public functions and properties of a class."""
    return {name: value for name, value in vars(cls).items()
            if not name.startswith("_") and (inspect.isfunction(value) or hasattr(value, "func"))}


class DocstringTest(unittest.TestCase):
    def test_all_are_walked(self):
        self.assertEqual(len(FUNCTIONS) + len(CLASSES), len(orthocone.__all__))
        self.assertGreaterEqual(len(FUNCTIONS), 8)

    def test_arguments_have_shapes_and_units(self):
        for function, value in FUNCTIONS.items():
            for name in inspect.signature(value).parameters:
                with self.subTest(function, parameter=name):
                    said = said_of(name, value.__doc__)
                    self.assertIsNotNone(said, "not in the docstring")
                    if name not in WITHOUT_UNITS:
                        self.assertRegex(said, rf"\(\d?,? ?n?.*\), {UNIT}\b")

    def test_results_have_shapes_and_units(self):
        for function in FUNCTIONS.keys() - {"solve", "methods"}:
            with self.subTest(function):
                self.assertRegex(" ".join(FUNCTIONS[function].__doc__.split()), rf"Returns \(n.*?\).*?, {UNIT}\b")

    def test_classes_name_their_fields(self):
        for cls, value in CLASSES.items():
            self.assertTrue(value.__doc__, cls)
            if dataclasses.is_dataclass(value):
                for field in dataclasses.fields(value):
                    with self.subTest(cls, field=field.name):
                        said = said_of(field.name, value.__doc__)
                        self.assertIsNotNone(said)
                        if field.type is np.ndarray:
                            self.assertRegex(said, r"^\([nk][,)]")
            for name, member in members(value).items():
                with self.subTest(cls, member=name):
                    self.assertTrue((getattr(member, "func", member)).__doc__)

    def test_shapes_are_those_of_the_docstrings(self):
        """(n, k) gives n results, (k,) gives one; mu and p are a number, (2,) or (n, 2)."""
        random = np.random.default_rng(1)
        for function in FUNCTIONS.keys() - {"solve", "methods"}:
            value = FUNCTIONS[function]
            first, *others = inspect.signature(value).parameters
            width = int(re.search(r"\(n, (\d)\)", said_of(first, value.__doc__))[1])
            returned = re.search(r"Returns (\(n.*?\)) or (.*?),", " ".join(value.__doc__.split()))
            arrays = random.uniform(0.5, 1, (5, width))
            for law in (0.3, np.array([0.3, 0.2]), np.full((5, 2), 0.3)):
                with self.subTest(function, law=np.shape(law)):
                    many = value(arrays, **{name: law for name in others})
                    self.assertEqual(many.shape, (5,) if returned[1] == "(n,)" else (5, int(returned[1][4])))
                    one_law = law if np.ndim(law) < 2 else law[0]
                    one = value(arrays[0], **{name: one_law for name in others})
                    self.assertEqual(np.shape(one), many.shape[1:])
                    np.testing.assert_array_equal(one, many[0])

    def test_solution_is_as_its_docstring_says(self):
        W, q = row_of_nodes(5, 1)
        for mu, start, flat in ((0.3, None, q), ((0.3, 0.2), np.ones((5, 3)), q.ravel()), (np.full((5, 2), 0.3), np.ones(15), q)):
            solution = orthocone.solve(W, flat, mu, start=start)
            self.assertEqual((solution.force.shape, solution.displacement.shape, solution.status.shape), ((5, 3), (5, 3), (5,)))
        self.assertEqual(set(solution.report.law_errors), {"penetration", "complementarity", "friction_cone", "slip_rule"})
        for name in solution.report.law_errors:
            self.assertIn(name, orthocone.Solution.__doc__ + type(solution.report).__doc__)


if __name__ == "__main__":
    del sys.argv[1]
    unittest.main()
