# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Hostile command lines."""
import promises
from bench import Row
from promises import DONE, FILE_ERROR, WRONG_INPUT

LONG = "x" * 5000
OPTIONS = "'orthocone --help'|allowed"

# Name, arguments, expression of the error output: all refused as a wrong command line, and none leaves anything.
WRONG = [
    ("quiet twice", ["--quiet", "s.prm", "--quiet"], OPTIONS),
    ("check twice", ["s.prm", "--check", "--check"], OPTIONS),
    ("output twice", ["s.prm", "--output", "a", "--output", "b"], OPTIONS),
    ("output without value", ["s.prm", "--output="], "output"),
    ("empty output", ["s.prm", "--output", ""], "output"),
    ("option for a folder", ["s.prm", "--output", "--quiet"], "output"),
    ("option for a folder before the file", ["--output", "--check", "s.prm"], "output"),
    ("threads without value", ["s.prm", "--threads"], "threads"),
    ("threads twice", ["s.prm", "--threads", "1", "--threads", "1"], OPTIONS),
    ("threads in hexadecimal", ["s.prm", "--threads", "0x2"], "--threads = 0x2: allowed is a whole number from 1 to 1024"),
    ("batch and a file", ["--batch", "s.prm"], "--batch stands alone"), ("batch twice", ["--batch", "--batch"], OPTIONS),
    ("no threads", ["s.prm", "--threads", "0"], "--threads = 0: allowed is a whole number from 1 to 1024"),
    ("set without value", ["s.prm", "--set="], "set"),
    ("empty set", ["s.prm", "--set", ""], "allowed is .Section/Entry=value"),
    ("only an equals sign", ["s.prm", "--set", "="], "allowed is .Section/Entry=value"),
    ("no names", ["s.prm", "--set", "/=1"], "not an entry"),
    ("no entry", ["s.prm", "--set", "Mesh/=1"], "Mesh/ is not an entry"),
    ("no section", ["s.prm", "--set", "/Degree=1"], "is Mesh/Degree meant"),
    ("two slashes", ["s.prm", "--set", "Mesh//Degree=1"], "is Mesh/Degree meant"),
    ("three parts", ["s.prm", "--set", "a/Mesh/Degree=1"], "is Mesh/Degree meant"),
    ("backslash for slash", ["s.prm", "--set", "Mesh\\Degree=1"], "allowed is"),
    ("colon for equals", ["s.prm", "--set", "Mesh/Degree: 1"], "allowed is"),
    ("two equals", ["s.prm", "--set", "Mesh/Degree=1=2"], "Mesh/Degree = 1=2: allowed is"),
    ("two entries in one set", ["s.prm", "--set", "Mesh/Degree=1;Mesh/Layers=2"],
     "Mesh/Degree = 1;Mesh/Layers=2: allowed"),
    ("quotes around the value", ["s.prm", "--set", 'Mesh/Degree="1"'], 'Mesh/Degree = "1": allowed'),
    ("set takes the next option", ["s.prm", "--set", "--check"], "--set"),
    ("statement of a file", ["s.prm", "--set", "subsection Mesh"], "allowed is .Section/Entry=value"),
    ("entry in Greek", ["s.prm", "--set", "Friction/\u03bc=1"], "not an entry"),
    ("long entry", ["s.prm", "--set", f"Mesh/{LONG}=1"], "not an entry"),
    ("long section", ["s.prm", "--set", f"{LONG}/a=1"], "not an entry"),
    ("long value", ["s.prm", "--set", f"Mesh/Degree={LONG}"], "allowed is"),
    ("long set", ["s.prm", "--set", LONG], "allowed is"),
    ("second of two sets is wrong", ["s.prm", "--set", "Mesh/Degree=1", "--set", "Mesh/Degree=x"],
     "Mesh/Degree = x: allowed"),
    ("first of two sets is wrong", ["s.prm", "--set", "Mesh/Degree=x", "--set", "Mesh/Degree=1"],
     "Mesh/Degree = x: allowed"),
    ("check with a value", ["s.prm", "--check=yes"], OPTIONS),
    ("resume with a value", ["s.prm", "--resume=1"], OPTIONS),
    ("capitals", ["s.prm", "--CHECK"], OPTIONS), ("one dash", ["s.prm", "-check"], OPTIONS),
    ("slash", ["s.prm", "/check"], OPTIONS),
    ("dash of typesetting", ["s.prm", "\u2013check"], OPTIONS),
    ("option with an escape sequence", ["s.prm", "--\x1b[31mred\x07"], OPTIONS),
    ("option with a line break", ["s.prm", "--out\nput"], OPTIONS), ("long option", ["s.prm", f"--{LONG}"], OPTIONS),
    ("option that is not UTF-8", ["s.prm", "--\udcff\udcfe"], OPTIONS),
    ("two dashes before options", ["--", "s.prm", "--quiet"], OPTIONS),
    ("three files", ["s.prm", "s.prm", "s.prm"], OPTIONS), ("empty second file", ["s.prm", ""], OPTIONS),
    ("empty file", [""], "parameter file is missing"),
    ("resume alone", ["--resume"], "parameter file is missing"),
    ("settings alone", ["--set", "Mesh/Degree=1"], "parameter file is missing"),
    ("unknown option beside --defaults", ["--defaults", "--all"], OPTIONS),
]
# Files that cannot be read.
UNREADABLE = [("standard input as a dash", ["-"]), ("file with a slash behind", ["s.prm/"]),
              ("file as a folder", ["s.prm/x.prm"]),
              ("link in a circle", ["circle.prm"]), ("link to nothing", ["nothing.prm"]), ("parent folder", [".."]),
              ("home folder as the shell knows it", ["~/s.prm"]), ("memory of a process", ["/proc/self/mem"]),
              ("name too long", ["n" * 256])]
# Name, run folder, expression.
NO_FOLDER = [("the parameter file", "s.prm", "s.prm"), ("the parameter file, slash behind", "s.prm/", "s.prm"),
             ("below the parameter file", "s.prm/run", "s.prm"), ("a link to nothing", "nothing.prm", "nothing.prm"),
             ("below a link to nothing", "nothing.prm/run", "nothing.prm"),
             ("a link in a circle", "circle.prm", "circle.prm"),
             ("a device", "/dev/null", "/dev/null"),
             ("a file system of the kernel", "/sys/orthocone", "/sys/orthocone"),
             ("a name too long", "n" * 256, "File name too long")]
# Name, run folder as given, where the files then are.
FOLDERS = [("slash behind", "run/", "run"), ("nested", "a/b/c", "a/b/c"), ("dots", "./run/./x", "run/x"),
           ("blanks", "a run of mine", "a run of mine"),
           ("a dash", "-", "-"), ("a leading dash", "-run", "-run"),
           ("not ASCII", "\u00dcbung \u03bc", "\u00dcbung \u03bc"), ("quotes", "it's \"x\"", "it's \"x\""),
           ("a dollar", "$HOME", "$HOME"), ("a percent sign", "100%d%s", "100%d%s"),
           ("name of a file of runs", "history.csv", "history.csv"),
           ("a link to a folder", "link", "target")]
GOOD = [("two dashes", ["--", "s.prm"]), ("options before the file", ["--quiet", "--set", "Mesh/Degree=1", "s.prm"]),
        ("an entry set twice", ["s.prm", "--quiet", "--set", "Mesh/Layers=9", "--set", "Mesh/Layers=2"]),
        ("blanks in a setting", ["s.prm", "--quiet", "--set", "  Mesh /  Layers  =  2  "]),
        ("five hundred settings", ["s.prm", "--quiet", *["--set=Mesh/Layers=2"] * 500]),
        ("resume of nothing", ["s.prm", "--quiet", "--resume"]),
        ("resume before the file", ["--resume", "--quiet", "s.prm"])]
PRINTS = [["--help", "nowhere.prm"], ["--version", "--set", "nonsense"], ["--defaults", "s.prm", "--output", "x"],
          ["s.prm", "--check", "--resume"], ["s.prm", "--check", "--quiet", "--output", "x"],
          ["--help", "--version", "--defaults"],
          ["s.prm", "--check", "--set=Load program/Legs=0 0 -0.1 : 1000000"],
          ["s.prm", "--check", "--set=Mesh/Core cells=200", "--set=Mesh/Layers=200", "--set=Mesh/Degree=3"]]


def links(folder):
    (folder / "circle.prm").symlink_to("circle.prm")
    (folder / "nothing.prm").symlink_to("nowhere")


def folder_behind_link(folder):
    (folder / "target").mkdir()
    (folder / "link").symlink_to("target")


def stem_of_dots(bench):
    """The run folder of '...prm' is a folder of its own in output, not the folder above it."""
    bench.put("...prm", bench.folder.joinpath("s.prm").read_bytes())
    code, _, _ = bench.call("...prm", "--quiet")
    faults = ["files beside the parameter file"] * (bench.folder / "history.csv").exists()
    return promises.of_exit(code, DONE) + faults + ["no results"] * (not list(bench.folder.rglob("history.csv")))


def name_of_bytes(folder):
    (folder / "s\udcff.prm").write_bytes((folder / "s.prm").read_bytes())


ROWS = [
    Row("file name that is no UTF-8", ["s\udcff.prm", "--quiet"], run="output/s\udcff", prepare=name_of_bytes),
    *[Row(name, arguments, WRONG_INPUT, says) for name, arguments, says in WRONG],
    *[Row(name, arguments, FILE_ERROR, "cannot be read|is a folder", prepare=links)
      for name, arguments in UNREADABLE],
    *[Row(f"run folder is {name}", ["s.prm", "--output", folder], FILE_ERROR, says, prepare=links)
      for name, folder, says in NO_FOLDER],
    *[Row(f"run folder has {name}", ["s.prm", "--quiet", f"--output={folder}"], run=place,
          prepare=folder_behind_link if folder == "link" else None) for name, folder, place in FOLDERS],
    *[Row(name, arguments) for name, arguments in GOOD],
    *[Row("prints: " + " ".join(arguments), arguments, run="") for arguments in PRINTS],
    Row("stem of dots", script=stem_of_dots),
]
