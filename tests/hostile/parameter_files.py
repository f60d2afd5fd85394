# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Hostile parameter files."""
from bench import Row
from promises import DONE, FILE_ERROR, WRONG_INPUT

BASE = "include s.prm\n"
MESH = BASE + "subsection Mesh\n  set {}\nend\n"
MANY = 100000

# Name, text of case.prm, expression: all refused as wrong.
WRONG = [
    ("section and entry on a line", BASE + "subsection Mesh set Degree = 1 end\n",
     "case.prm:2: Mesh set Degree = 1 end is not a section"),
    ("two equals signs", MESH.format("Degree == 1"), "case.prm:3: Mesh/Degree = = 1: allowed"),
    ("path as a section", BASE + "subsection Mesh/Degree\nend\n", "case.prm:2: Mesh/Degree is not a section"),
    ("section in itself", BASE + "subsection Mesh\nsubsection Mesh\nend\nend\n", "case.prm:2: .*has no 'end'"),
    ("only a backslash", "\\", "case.prm: .*sets no entry"),
    ("only continued blanks", "\\\n \\\n", "case.prm: .*sets no entry"),
    ("set and a backslash", BASE + "set \\\n", "case.prm:2: 'set'"),
    ("value behind a continuation", MESH.format("Degree = \\\n 7"), "case.prm:3: Mesh/Degree = 7"),
    ("backslash at the end of the file", BASE + "subsection Mesh\n set Degree = 1 \\", "case.prm:2: .*has no 'end'"),
    ("end behind a continuation", MESH.format("Degree = 1 \\"), "case.prm:3: Mesh/Degree = 1 *end"),
    ("backslash and blank", MESH.format("Degree = 1 \\ x"), "case.prm:3: Mesh/Degree = 1"),
    ("form feed", BASE + "\fsubsection Mesh\nend\n", "case.prm: is not a text file"),
    ("vertical tab", MESH.format("Degree\v= 1"), "not a text file"),
    ("escape in a comment", BASE + "# \x1b[31m\n", "case.prm: is not a text file"),
    ("delete character", MESH.format("Degree = 1\x7f"), "not a text file"),
    ("NUL at the end", MESH.format("Degree = 1") + "\0", "case.prm: is not a text file"),
    ("byte order mark inside", BASE + "\ufeffsubsection Mesh\nend\n", "case.prm:2: "),
    ("second byte order mark", "\ufeff\ufeff" + BASE, "case.prm:1: "),
    ("control character of the second kind", MESH.format("Degree = \x9b31m1"), "case.prm:3: Mesh/Degree"),
    ("text that runs to the left", MESH.format("Degree = \u202e1"), "case.prm:3: Mesh/Degree"),
    ("zero-width blank", MESH.format("Degree = 1\u200b"), "case.prm:3: Mesh/Degree = 1.*beyond ASCII"),
    ("digits of another script", MESH.format("Degree = \u0661"), "case.prm:3: Mesh/Degree.*beyond ASCII"),
    ("fullwidth digit", MESH.format("Degree = \uff11"), "case.prm:3: "),
    ("bytes that are no text", MESH.format("Degree = ").encode() + b"\xff\xfe\n", "case.prm"),
    ("half a character at the end", BASE.encode() + b"# \xe2\x82\nx\xc3", "case.prm:3"),
    ("line of a million", BASE + "x" * 1000000 + "\n", "case.prm:2: 'xxx"),
    ("value of a million", MESH.format("Degree = " + "1" * 1000000), "case.prm:3: Mesh/Degree = 111"),
    ("entry of many letters", MESH.format("D" * MANY + " = 1"), "case.prm:3: Mesh/DDD"),
    ("section of many letters", BASE + "subsection " + "D" * MANY + "\nend\n", "case.prm:2: DDD"),
    ("many open sections", BASE + "subsection Mesh\n" * MANY, "case.prm:2: .*has no 'end'"),
    ("many ends", BASE + "end\n" * MANY, "case.prm:2: 'end' has no"),
    ("many continued lines", BASE + "x\\\n" * MANY, "case.prm:2: "),
    ("end in capitals behind a comment", BASE + "subsection Mesh # a\nEND # b\n", "case.prm:3: 'END'"),
    ("set outside of sections", BASE + "set Mesh/Degree = 1\n", "case.prm:2: Mesh/Degree is set within"),
    ("semicolon behind a value", MESH.format("Degree = 1;"), "Mesh/Degree = 1;"),
    ("quotes around a value", MESH.format('Degree = "1"'), "Mesh/Degree = .1.: allowed"),
    ("variable of the shell", MESH.format("Degree = $DEGREE"), "Mesh/Degree = .DEGREE"),
    ("formula", MESH.format("Degree = 1+1"), "Mesh/Degree = 1.1: allowed"),
    ("entry named set", BASE + "subsection Mesh\nset set = 1\nend\n", "Mesh/set is not an entry"),
    ("entry named end", BASE + "subsection Mesh\nset end = 1\nend\n", "Mesh/end is not an entry"),
    ("a program", "#!/bin/sh\necho hello\n", "case.prm:2: 'echo hello'"),
    ("a web page", "<!DOCTYPE html>\n<html></html>\n", "case.prm:1: "),
    ("formats of C", BASE + "%s%n%x\n", "case.prm:2: '%s%n%x'"),
]
# Name, included name, expression, code.
INCLUDES = [
    ("itself by a link", "self.prm", "included by itself", WRONG_INPUT),
    ("itself by a detour", "here/case.prm", "included by itself", WRONG_INPUT),
    ("itself by its absolute name", "{folder}/case.prm", "included by itself", WRONG_INPUT),
    ("link in a circle", "circle.prm", "symbolic links", FILE_ERROR),
    ("link to a folder", "here", "is a folder", FILE_ERROR),
    ("name in quotes", '"s.prm"', "cannot be read", FILE_ERROR),
    ("two names", "s.prm s.prm", "cannot be read", FILE_ERROR),
    ("home folder", "~/s.prm", "cannot be read", FILE_ERROR),
    ("missing, absolute", "/nowhere/s.prm", "/nowhere/s.prm: cannot be read", FILE_ERROR),
    ("file as a folder", "s.prm/x", "Not a directory", FILE_ERROR),
    ("pattern of the shell", "*.prm", "cannot be read", FILE_ERROR),
    ("address", "https://example.org/s.prm", "cannot be read", FILE_ERROR),
    ("JSON", "case.json", "case.json:1: ", WRONG_INPUT),
]
# Name, text of case.prm.
GOOD = [
    ("tabs everywhere", "include\ts.prm\nsubsection\tMesh\n\tset\tDegree\t=\t1\nend\t\n"),
    ("comments everywhere", "#\n" + BASE + "subsection Mesh#x\nset Degree=1#set Degree=9\nend#\n#"),
    ("mixed line ends", "include s.prm\r\nsubsection Mesh\rset Degree = 1\nend\r"),
    ("no line end at the end", BASE + "subsection Mesh\nset Degree = 1\nend"),
    ("continued include", "include \\\n s.prm\n"), ("continued blanks", BASE + "\\\n" * MANY + "\n"),
    ("many sections", BASE + "subsection Mesh\nend\n" * MANY),
    ("many zeros", MESH.format("Core ratio = " + "0" * MANY + ".5")),
    ("many digits", MESH.format("Core ratio = 0.5" + "0" * MANY)),
    ("many blanks", MESH.format("Degree =" + " " * 1000000 + "1")),
    ("include with blanks", "include s p a c e.prm\n"), ("include by detours", "include here/here/./s.prm\n"),
    ("include twice", BASE + BASE), ("include absolute", "include {folder}/s.prm\n"),
    ("comment of umlauts", BASE + "# \u00dc\u00df\u4e2d\U0001f600\n"),
    ("comment that is no UTF-8", BASE.encode() + b"# \xff\xfe\n"),
]


def neighbours(folder):
    (folder / "self.prm").symlink_to("case.prm")
    (folder / "here").symlink_to(".")
    (folder / "circle.prm").symlink_to("circle.prm")
    (folder / "s p a c e.prm").write_bytes((folder / "s.prm").read_bytes())
    (folder / "case.json").write_text('{"Mesh": {"Degree": 1}}\n', encoding="ascii")
    case = folder / "case.prm"
    case.write_bytes(case.read_bytes().replace(b"{folder}", str(folder).encode()))


def chain(length):
    """case.prm includes 1.prm includes 2.prm ..., the last of them s.prm."""
    names = ["case", *map(str, range(1, length)), "s"]
    return {f"{name}.prm": f"include {following}.prm\n" for name, following in zip(names, names[1:])}


ROWS = [
    Row("twenty-five includes in a row", ["case.prm"], WRONG_INPUT, "nested more than 20 deep", chain(25)),
    Row("nineteen includes in a row", ["case.prm", "--check"], files=chain(19), run=""),
    *[Row(name, ["case.prm", "--check"], WRONG_INPUT, says, {"case.prm": text}, neighbours) for name, text,
      says in WRONG],
    *[Row(f"include: {name}", ["case.prm"], code, "case.prm:2: .*" + says if code == FILE_ERROR else says,
          {"case.prm": f"# comment\ninclude {included}\n"}, neighbours) for name, included, says, code in INCLUDES],
    *[Row(name, ["case.prm", "--check"], DONE, "", {"case.prm": text}, neighbours, run="") for name, text in GOOD],
]
