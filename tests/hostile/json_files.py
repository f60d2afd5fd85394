# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Hostile JSON files."""
import json

from bench import Row
from promises import DONE, WRONG_INPUT

# Name, text of case.json, expression: all refused as wrong.
WRONG = [
    ("null", "null", "is not valid JSON of the form"), ("a number", "0", "is not valid JSON of the form"),
    ("a string", '"s.prm"', "is not valid JSON of the form"), ("an empty array", "[]", "is not valid JSON of the form"),
    ("a word", "true", "is not valid JSON of the form"),
    ("not a word", "True", "case.json:1: is not valid JSON at column"),
    ("section of null", '{"Mesh": null}', "Mesh = null: allowed is the form"),
    ("section of an array", '{"Mesh": [{"Degree": 1}]}', "Mesh = .*: allowed is the form"),
    ("section of a string", '{"Mesh": "Degree = 1"}', "Mesh = .*: allowed is the form"),
    ("yes for a count", '{"Mesh": {"Degree": true}}', "Mesh/Degree = true: allowed"),
    ("exponent for a count", '{"Mesh": {"Degree": 1e0}}', "Mesh/Degree = 1.*: allowed"),
    ("minus zero for a count", '{"Mesh": {"Rings": "-0"}}', "Mesh/Rings = -0: allowed"),
    ("count beyond 64 bits", '{"Mesh": {"Degree": 18446744073709551617}}', "Mesh/Degree = 1.8.*: allowed"),
    ("number of 100000 digits", '{"Mesh": {"Degree": ' + "1" * 100000 + "}}", "case.json"),
    ("vanishing number", '{"Material": {"Young modulus": 1e-400}}', "Material/Young modulus = .*: allowed"),
    ("infinity", '{"Material": {"Young modulus": Infinity}}', "case.json:1: is not valid JSON at column"),
    ("string of infinity", '{"Material": {"Young modulus": "Infinity"}}', "Material/Young modulus = Infinity: allowed"),
    ("leading zero", '{"Mesh": {"Degree": 01}}', "case.json:1: is not valid JSON at column"),
    ("plus", '{"Mesh": {"Degree": +1}}', "case.json:1: is not valid JSON at column"),
    ("hexadecimal", '{"Mesh": {"Degree": 0x1}}', "case.json:1: is not valid JSON at column"),
    ("no leading zero", '{"Mesh": {"Core ratio": .5}}', "case.json:1: is not valid JSON at column"),
    ("entry without name", '{"Mesh": {"": 1}}', "Mesh/ is not an entry"),
    ("section without name", '{"": {"Degree": 1}}', "case.json: '?\"?'?\"? is not a section"),
    ("sections without name twice", '{"": {}, "": {}}', "given twice"),
    ("NUL in a name", '{"Mesh": {"Degree\\u0000": 1}}', "is Mesh/Degree meant"),
    ("NUL in a value", '{"Mesh": {"Degree": "1\\u0000"}}', r"Mesh/Degree = 1\\x00: allowed"),
    ("escape sequence in a name", '{"\\u001b[31mMesh": {"Degree": 1}}', r"\\x1b\[31mMesh is not a section"),
    ("control character of the second kind", '{"Mesh": {"Degree": "\\u009b31m"}}', "Mesh/Degree = "),
    ("text that runs to the left", '{"Mesh": {"Degree": "\\u202e1"}}', "Mesh/Degree = "),
    ("half a pair of UTF-16", '{"Mesh": {"Degree": "\\ud800"}}', "case.json:1: is not valid JSON at column"),
    ("bytes that are no UTF-8", b'{"Mesh": {"Degree": "\xff"}}', "case.json:1: is not valid JSON at column"),
    ("rest of another text", '{"Mesh": {"Degree": 1}} end', "case.json:1: is not valid JSON at column 25"),
    ("comment of C", '/* mesh */ {"Mesh": {"Degree": 1}}', "case.json:1: is not valid JSON at column"),
    ("comment of Python", '{"Mesh": {"Degree": 1}} # mesh', "case.json:1: is not valid JSON at column 25"),
    ("include", '{"include": "s.prm"}', "include is not a section"),
    ("legs as nested arrays", '{"Load program": {"Legs": [[0, 0, -0.1, 1]]}}',
     "Load program/Legs = .*: allowed is legs"),
    ("probes of null", '{"Output": {"Probes": null}}', "Output/Probes = null: allowed is probes"),
    ("method in a list", '{"Contact solver": {"Method": ["newton", "uzawa"]}}', "Contact solver/Method = .*: allowed"),
    ("percentage as a number", '{"Mesh": {"Accuracy": 5}}', "Mesh/Accuracy = 5: allowed"),
    ("long list for a count", json.dumps({"Mesh": {"Degree": [1] * 100000}}), "Mesh/Degree = .*: allowed"),
    ("long object for a count", json.dumps({"Mesh": {"Degree": {str(i): i for i in range(10000)}}}),
     "Mesh/Degree = .*"),
    ("section of 100000 letters", json.dumps({"a" * 100000: {}}), "is not a section"),
    ("entry of 100000 letters", json.dumps({"Mesh": {"a" * 100000: 1}}), "is not an entry"),
    ("long entry twice", '{"Mesh": {"' + "a" * 9999 + '": 1, "' + "a" * 9999 + '": 1}}', "is given twice"),
    ("ten arrays of objects", '{"a": ' * 8 + "[" * 8, "case.json"),
    ("hundred thousand objects", '{"a": ' * 100000, "case.json"),
    ("lines of JSON", '{"Mesh": {"Degree": 1}}\n{"Mesh": {"Layers": 2}}\n',
     "case.json:2: is not valid JSON at column 1"),
    ("separator of records", '\u001e{"Mesh": {"Degree": 1}}', "case.json"),
    ("cut within a string", '{"Mesh": {"Deg', "case.json:1: "),
    ("cut within a number", '{"Mesh": {"Degree": 1e', "case.json:1: "),
    ("cut within an escape", '{"Mesh": {"Degree": "\\u00', "case.json:1: "),
]
# Name, object: accepted.
GOOD = [
    ("strings for all", {"Mesh": {"Degree": "1", "Core ratio": "0.5"}}),
    ("numbers", {"Mesh": {"Degree": 1, "Core ratio": 5e-1}}),
    ("seventeen digits", {"Mesh": {"Core ratio": 0.30000000000000004}}),
    ("empty strings", {"Output": {"Probes": ""}, "Load program": {"Preload": ""}}),
    ("large number", {"Material": {"Young modulus": 123456789012345678901234567890}}),
    ("blanks in a pair", {"Friction": {"Coefficients": " 0.3 ,0.1 "}}),
    ("line breaks in legs", {"Load program": {"Legs": "0 0 -0.1 : 1 ;\n 0 0 0 : 1"}}),
    ("empty sections", {"Mesh": {}, "Output": {}, "Geometry": {"Radius": 9}}),
]


def same_as_prm(bench):
    """The scene as JSON gives the same bytes."""
    scene = {}
    for line in (bench.folder / "s.prm").read_text().splitlines():
        words = line.split(maxsplit=1)
        if words[0] == "subsection":
            section = scene.setdefault(words[1], {})
        elif words[0] == "set":
            name, value = map(str.strip, words[1].split("=", 1))
            section[name] = value
    bench.put("case.json", json.dumps(scene))
    faults = [f"{name}: exit code {code}" for name in ("s.prm", "case.json")
              for code in [bench.call(name, "--quiet", "--output", name + ".run")[0]] if code != DONE]
    tables = [(bench.folder / f"{name}.run/history.csv").read_bytes() for name in ("s.prm", "case.json")]
    return faults + ["the tables differ"] * (tables[0] != tables[1])


ROWS = [
    *[Row(f"JSON: {name}", ["case.json"], WRONG_INPUT, says, {"case.json": text}) for name, text, says in WRONG],
    *[Row(f"JSON: {name}", ["case.json", "--check"], files={"case.json": json.dumps(content)}, run="") for name,
      content in GOOD],
    Row("JSON: byte order mark and tabs", ["case.json", "--check"],
        files={"case.json": '\ufeff{\t"Mesh"\t:\t{"Degree"\t:1}\t}\r\n'}, run=""),
    Row("JSON: the same run", script=same_as_prm),
]
