# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The faulty input that test_errors.py gives to the program, and the sentences it expects. One row, one fault."""
import re

SCENE = """subsection Mesh
  set Core cells = 2
  set Rings      = 2
  set Layers     = 1
  set Degree     = 1
end
subsection Load program
  set Legs = 0 0 -0.1 : 1
end
"""
LEGS = SCENE.split("end\n")[1] + "end\n"

POSITIVE = "a number > 0"
PAIR = "two numbers > 0 (or both 0: no friction) separated by a comma"
LEG = "legs \"ux uy uz : steps\""
PROBE = "probes \"name: x y\""

# Values that are wrong by themselves: section, entry, what the message says is allowed, values.
WRONG_VALUES = [
    ("Geometry", "Shape", "cylinder | box | file | half-space", ["cube"]),
    ("Geometry", "Sizes", "two or three numbers > 0 separated by commas", ["1", "0, 1, 1", "1 2 3", "1, 2, inf"]),
    ("Mesh", "Cells", "two or three whole numbers from 1 to 4096 separated by commas", ["8", "0, 1, 1", "4097, 1, 1", "1.5, 1, 1"]),
    ("Geometry", "Radius", POSITIVE, ["ten", "", "1,5", "+-5", "++5"]),
    ("Material", "Young modulus", POSITIVE, ["0", "-1", "nan", "inf", "1e999", "2 Gpa"]),
    ("Material", "Poisson ratio", "a number > -1 and < 0.5", ["0.5", "-1", "0.7", "steel"]),
    ("Friction", "Coefficients", PAIR, ["0, 0.1", "0.1, -0.1", "0.3", "0.3 0.1", "0.3, inf"]),
    ("Friction", "Slip potential", "associated, or two numbers > 0 separated by a comma", ["0, 1", "1, -1"]),
    ("Friction", "Orthotropy angle", "a number >= -360 and <= 360", ["nan", "360.1", "-1e300"]),
    ("Mesh", "Model", "auto | full | half | quarter | axisymmetric", ["eighth"]),
    ("Mesh", "Layers", "a whole number from 1 to 200", ["-1", "0", "2.5", "two", "99999999999"]),
    ("Mesh", "Degree", "a whole number from 1 to 4", ["9", "0"]),
    ("Mesh", "Core ratio", "a number >= 0.01 and < 1", ["1", "0"]),
    ("Mesh", "Rim grading", "a number > 0 and <= 10", ["0"]),
    ("Contact solver", "Method", "newton | gauss-seidel | uzawa | feng2006 | box3 | plain-newton", ["magic"]),
    ("Contact solver", "Tolerance", "a number >= 1e-14 and < 1", ["0"]),
    ("Contact solver", "Maximum iterations", "a whole number from 1 to 10000000", ["0"]),
    ("Load program", "Legs", LEG, ["0 0 -0.1 : 0", "0 0 -0.1", "0 -0.1 : 5", "down : 5", "0 0 nan : 5",
                                   "0 0 -0.1 : many", "0 0 -0.1 : 2.5", "0 0 -0.1 : 1 ;; 0 0 0 : 1"]),
    ("Load program", "Preload", LEG, ["0 0 : 1"]),
    ("Load program", "Cycles", "a whole number from 0 to 1000000", ["-1"]),
    ("Output", "Contact fields", "a whole number from 0 to 1000000", ["always"]),
    ("Output", "Probes", PROBE, ["P: 1 0; P: 2 0", "a/b: 1 0", "../P: 1 0", "P: 1", "P", ": 1 0",
                                 "P: 1 0 ;; Q: 2 0"]),
]
WRONG_VALUES = [(f"{section}/{entry}" + (f" = {value}" if value else " is empty"), section, entry, value, allowed)
                for section, entry, allowed, values in WRONG_VALUES for value in values]

# Entries that do not fit together: overrides, expression. The sentence names the parameter file as well.
CONTRADICTIONS = [
    (["Load program/Legs="], "Load program/Legs.*empty.*allowed is at least one leg"),
    (["Load program/Cycles=0"], r"Load program/Cycles = 0\b.*allowed"),
    (["Load program/Legs=0 0 -0.1 : 4000000000"], r"Load program: .* 4000000000 load steps: allowed are 1000000"),
    (["Mesh/Rim grading=1e-6", "Mesh/Rings=3"], r"Mesh/Rim grading = 1e-0?6 with 3 rings: allowed is"),
    (["Mesh/Layer grading=1e-6", "Mesh/Layers=8"], r"Mesh/Layer grading = 1e-0?6 with 8 layers: allowed is"),
    (["Mesh/Refined cells=0-99999"], r"Mesh/Refined cells: round 1 has cell 99999: allowed is a number up to \d+,"),
    (["Mesh/Refined cells=0", "Mesh/Refinements=7"], r"Mesh/Refined cells: more than \S+ cells follow: a coarser"),
    (["Mesh/Refined cells=0; 99999", "Obstacle/Gap=1e-4*x^2"], "Mesh/Refined cells: round 2 has cell 99999: allowed is"),
    (["Mesh/Quadrature points=1"], r"Mesh/Quadrature points = 1\b.*Mesh/Degree = 1\b.*allowed is 0 or more than the"),
    (["Mesh/Degree=3", "Mesh/Quadrature points=3"], r"Mesh/Quadrature points = 3\b.*Mesh/Degree = 3\b.*allowed is"),
    (["Geometry/Shape=box", "Output/Probes=P: 0 0; Far: 8 -12"], r"Output/Probes.*Far.*8.*-12.*allowed .*\|y\| <= 10\b"),
    (["Geometry/Shape=box", "Mesh/Accuracy=2 %"], r"Mesh/Accuracy = 2 % .*box.*allowed is 0\b"),
    (["Geometry/Shape=box", "Mesh/Model=axisymmetric"], r"Mesh/Model = axisymmetric .*box is no body of revolution"),
    (["Output/Probes=P: 0 0; Far: 8 -8"], r"Output/Probes.*Far.*8.*-8.*allowed .*Geometry/Radius = 10\b"),
    (["Friction/Orthotropy angle=30", "Mesh/Model=quarter"],
     r"Mesh/Model = quarter .*Friction/Orthotropy angle = 30\b.*possible models are full$"),
    (["Friction/Orthotropy angle=30", "Mesh/Model=half"],
     r"Mesh/Model = half .*Friction/Orthotropy angle = 30\b.*possible models are full$"),
    (["Load program/Legs=0.1 0 -0.1 : 1", "Mesh/Model=quarter"],
     r"Mesh/Model = quarter .*load program .*along x.*possible models are full, half$"),
    (["Load program/Legs=0 0.1 -0.1 : 1 ; 0 0 -0.1 : 1", "Mesh/Model=quarter"],
     r"Mesh/Model = quarter .*load program .*along y.*possible models are full, half$"),
    (["Load program/Preload=0 0.1 -0.1 : 1", "Mesh/Model=quarter"],
     r"Mesh/Model = quarter .*load program .*along y.*possible models are full, half$"),
    (["Load program/Legs=0.1 0.1 -0.1 : 1", "Mesh/Model=half"],
     r"Mesh/Model = half .*along x.*along y.*possible models are full$"),
    (["Mesh/Core cells=3", "Mesh/Model=quarter"],
     r"Mesh/Model = quarter .*Mesh/Core cells = 3\b.*possible models are full$"),
    (["Mesh/Core cells=3", "Mesh/Model=half"], r"Mesh/Model = half .*Mesh/Core cells = 3\b.*possible models are full$"),
    (["Geometry/Top face=guided", "Load program/Legs=0.1 0 -0.1 : 1"],
     r"Geometry/Top face = guided .*quarter.*load program .*along x"),
    (["Geometry/Top face=guided", "Mesh/Model=full"],
     r"Geometry/Top face = guided .*Mesh/Model = full .*possible models are .*quarter"),
]

NOT_AN_ENTRY = " is not an entry.*--defaults"
LIST = "'orthocone --defaults' lists all of them"


def not_an_entry(name, suggested):
    return f"{name} is not an entry; " + (f"is {suggested} meant? " if suggested else "") + LIST


GRAMMAR = ".*expected is 'subsection NAME'"
# Texts that cannot be parsed: text of case.prm, exit code, expression.
WRONG_TEXTS = [
    (LEGS + "subsection Msh\n  set Degree = 1\nend\n", 2,
     r"case\.prm:4: Msh is not a section; is Mesh meant\? .*--defaults"),
    (LEGS + "subsection Mesh\n  set Degre = 1\nend\n", 2, r"case\.prm:5: Mesh/Degre" + NOT_AN_ENTRY),
    (LEGS + "set Degree = 1\n", 2, r"case\.prm:4: " + re.escape(not_an_entry("Degree", "Mesh/Degree")) + "$"),
    (LEGS + "subsection Contact slover\nend\n", 2,
     r"case\.prm:4: Contact slover is not a section; is Contact solver meant\? " + LIST + "$"),
    (LEGS + "subsection Foo\nend\n", 2, r"case\.prm:4: Foo is not a section; " + LIST + "$"),
    (LEGS + "subsection Mesh\n  set Degree = 1\n", 2, r"case\.prm.*Mesh.*'end'"),
    (LEGS + "end\n", 2, r"case\.prm:4: 'end' has no 'subsection'$"),
    (LEGS + "hello world\n", 2, r"case\.prm:4: 'hello world'" + GRAMMAR),
    (LEGS + "subsection Mesh\n  set Degree 1\nend\n", 2, r"case\.prm:5: 'set Degree 1'" + GRAMMAR),
    (LEGS + "subsection Mesh\n  Degree = 1\nend\n", 2, r"case\.prm:5: 'Degree = 1'" + GRAMMAR),
    (LEGS + "subsection Mesh\n  set Degree = 1\n  set Degree = 7 # septic\nend\n", 2,
     r"case\.prm:6: Mesh/Degree = 7: allowed is a whole number from 1 to 4$"),
    (LEGS + "subsection Mesh\r\n  set Degree = 7\r\nend\r\n", 2, r"case\.prm:5: Mesh/Degree = 7: allowed is a whole"),
    ("subsection Load program\n  set Legs = 0 0 -0.1 : 2 ; \\\n  0 0 0 : 0\nend\n", 2,
     r"case\.prm:[23]: Load program/Legs = 0 0 -0\.1 : 2 ;\s*0 0 0 : 0: allowed is legs"),
    (LEGS + "include nowhere.prm\n", 4, r"case\.prm:4: nowhere\.prm: cannot be read \(No such file or directory\)"),
    (LEGS + "include .\n", 4, r"case\.prm:4: .*is a folder"),
    (LEGS + "include case.prm\n", 2, r"case\.prm:4: case\.prm: is included by itself$"),
    (LEGS + "include\n", 2, r"case\.prm:4: 'include'" + GRAMMAR),
    ("", 2, r"case\.prm: is empty.*--defaults"),
    ("\n   \n\t\n", 2, r"case\.prm: is empty.*--defaults"),
    ("# nothing but a comment\n", 2, r"case\.prm: sets no entry.*--defaults"),
    (SCENE + "\0\1\2\0", 2, r"case\.prm: is not a text file.*\.prm or \.json"),
]

# Faults of parts/mesh.prm, which parts/middle.prm includes, which case.prm includes: text, expression.
FAULTS_OF_INCLUDED_FILE = [
    ("\nsubsection Mesh\n  set Degree = 9\nend\n", r"parts/mesh\.prm:3: Mesh/Degree = 9: allowed is a whole"),
    ("\nsubsection Mesh\n  set Degre = 1\nend\n", r"parts/mesh\.prm:3: Mesh/Degre" + NOT_AN_ENTRY),
    ("\nnonsense\n", r"parts/mesh\.prm:2: 'nonsense'" + GRAMMAR),
    ("\nsubsection Mesh\n  set Degree = 1\n", r"parts/mesh\.prm:2: .*Mesh.*'end'"),
    ("", r"parts/middle\.prm:2: parts/mesh\.prm: is empty"),
]

# Faults of JSON files: text of case.json, expression.
WRONG_JSON = [
    ({"Mesh": {"Degree": "9"}}, r"case\.json: .*Mesh/Degree = 9: allowed is a whole number from 1 to 4"),
    ({"Mesh": {"Degree": 1.5}}, r"case\.json: .*Mesh/Degree = 1\.5: allowed is a whole number from 1 to 4"),
    ({"Mesh": {"Degre": 1}}, r"case\.json: .*Mesh/Degre" + NOT_AN_ENTRY),
    ({"Msh": {"Degree": 1}}, r"case\.json: .*Msh.* is not an? (entry|section).*--defaults"),
    ({"Mesh": {"Degre": 1}}, r"case\.json: " + re.escape(not_an_entry("Mesh/Degre", "Mesh/Degree")) + "$"),
    ({"Geometry": {"Degree": 1}}, r"case\.json: " + re.escape(not_an_entry("Geometry/Degree", "Mesh/Degree")) + "$"),
    ({"Contact slover": {"Method": "newton"}},
     r"case\.json: Contact slover is not a section; is Contact solver meant\? " + LIST + "$"),
    ({"Foo": {"Bar": 1}}, r"case\.json: Foo is not a section; " + LIST + "$"),
    ({"Mesh": {"Foo": 1}}, r"case\.json: " + re.escape(not_an_entry("Mesh/Foo", "")) + "$"),
    ("[" * 200000, r"case\.json: is nested more than 10 deep; allowed is \{"),
    ({"Mesh": {"Degree": [1]}}, r"case\.json: .*Mesh/Degree"),
    ('{"Mesh": {"Degree": 1}\n', r"case\.json(:\d+)?: is not valid JSON"),
    ("subsection Mesh\nend\n", r"case\.json(:\d+)?: is not valid JSON"),
    ("", r"case\.json: is empty"),
]

# Names that --set does not know, and the entries that it takes for the ones that were meant.
NAMES_ON_COMMAND_LINE = [
    ("Mesh/Degre", "Mesh/Degree"), ("mesh/degree", "Mesh/Degree"), ("Msh/Degree", "Mesh/Degree"),
    ("Geometry/Degree", "Mesh/Degree"), ("Contact slover/Method", "Contact solver/Method"),
    ("Solver/Tolerance", "Contact solver/Tolerance"), ("Material/Youngs modulus", "Material/Young modulus"),
    ("Contact solver/Max iterations", "Contact solver/Maximum iterations"),
    ("Load program/Slip potential", "Friction/Slip potential"), ("Foo/Bar", ""), ("Material/Density", ""),
    ("Friction/Angle", "Friction/Orthotropy angle"), ("Mesh/Element degree", "Mesh/Degree"),
    # A right section is no reason to take an entry for another.
    ("Solver options/Verbose", ""), ("Parameters/Mesh", ""), ("Contact solver/Solver", "Contact solver/Method"), ("Output/Folder", ""),
]

# Command lines: arguments, exit code, expression.
COMMAND_LINES = [
    (["good.prm", "--set", "Mesh/Degree"], 2, "--set Mesh/Degree: allowed is \"Section/Entry=value\""),
    (["good.prm", "--set", "Degree=1"], 2,
     "--set Degree=1: allowed is \"Section/Entry=value\"; is Mesh/Degree meant\\?$"),
    (["good.prm", "--set", "Foo=1"], 2, "--set Foo=1: allowed is \"Section/Entry=value\"$"),
    (["good.prm", "--set", "Mesh/Model=half\x1b[1m\n"], 2, r"--set: Mesh/Model = half\\x1b\[1m: allowed is auto \|"),
    (["good.prm", "--set", "Mesh/Fo\no=1"], 2, r"--set: Mesh/Fo\\no is not an entry; 'orthocone"),
    (["good.prm", "--set", "Mesh/Degre=1"], 2, "--set: Mesh/Degre" + NOT_AN_ENTRY),
    (["good.prm", "--set", "Msh/Degree=1"], 2, "--set: Msh/Degree" + NOT_AN_ENTRY),
    (["good.prm", "--set", "Mesh/Degree=7"], 2, "--set: Mesh/Degree = 7: allowed is a whole number from 1 to 4"),
    (["good.prm", "--set"], 2, "command line: .*--set.*--help"),
    (["good.prm", "--output"], 2, "command line: .*--output.*--help"),
    (["good.prm", "--fast"], 2, "command line: .*--fast.*--help"),
    (["good.prm", "--che"], 2, "command line: .*--che.*--help"),
    (["good.prm", "good.prm"], 2, "command line: .*--help"),
    ([], 2, "command line: a parameter file is missing.*--help"),
    (["--check"], 2, "command line: a parameter file is missing.*--help"),
    (["good.prm", "--picture", "scene.svg"], 2, r"command line: --picture = 'scene\.svg' without --check: allowed is 'orthocone --check"),
    (["good.prm", "--check", "--picture", "scene.pdf"], 2,
     r"command line: --picture = 'scene\.pdf': allowed is the name of a file that ends in \.svg or \.png"),
    (["good.prm", "--check", "--picture", ""], 2, "command line: --picture = '': allowed is the name of a file that ends"),
    (["good.prm", "--picture", "--check"], 2, "command line: --picture = '--check': allowed is the name of a file that ends"),
    (["good.prm", "--check", "--picture"], 2, "command line: .*--picture.*--help"),
    (["nowhere.prm"], 4, r"nowhere\.prm: cannot be read \(No such file or directory\)"),
    (["nowhere.json"], 4, r"nowhere\.json: cannot be read \(No such file or directory\)"),
    (["."], 4, r"\.: is a folder; a parameter file \(\.prm or \.json\) is wanted"),
]

# Grids of gaps that are none, and what is said of them behind the name of the file.
HOLE = "allowed is a finite number \\(mm\\), because a grid has no holes$"
GAP_FILES = [
    ("-10 10 3 -10 20 2\n0 nan 0\n0 0 0\n", ":2: number 2 is 'nan': " + HOLE),
    ("-10 10 3 -10 20 2\n0 0 0\n# hole\n0 0 -inf\n", ":4: number 3 is '-inf': " + HOLE),
    ("-10 10 3 -10 20 2\n0 0 0\n0 - 0\n", ":3: number 2 is '-': " + HOLE),
    ("-10 10 3 -10 20 2\n0 0 0\n0 0\n", ":3: has 2 numbers: allowed are nx = 3 in each row, without holes$"),
    ("-10 10 3 -10 20 2\n0 0 0\n", ": has 1 rows: allowed are ny = 2, without holes$"),
    ("-10 10 3 -10 0 2\n0 0 0\n0 0 0\n", ":1: '-10 10 3 -10 0 2': allowed is 'x0 dx nx y0 dy ny'"),
    ("", ": is empty; a grid of gaps is wanted$"),
]

# Fields that are not defined on the whole surface, and forces that press on nothing: override, end of the sentence.
PLACE = r" at \(\S+, \S+\) mm of the contact surface: allowed "
FIELDS = [
    ("Obstacle/Gap=sqrt(25-x^2)", r"Obstacle/Gap = sqrt\(25-x\^2\) is not a number" + PLACE + r"is a finite number \(mm\)"),
    ("Obstacle/Gap=1/x", r"Obstacle/Gap = 1/x is infinite" + PLACE + r"is a finite number \(mm\)"),
    ("Friction/Coefficients=0.3-x/20, 0.15",
     r"Friction/Coefficients = 0\.3-x/20, 0\.15 is -0\.\d+, 0\.15" + PLACE +
     r"are two finite numbers > 0, or both 0 \(no friction\)"),
    ("Friction/Slip potential=1, x-1", r"Friction/Slip potential = 1, x-1 is 1, -\S+" + PLACE + "are two finite numbers > 0"),
    ("Friction/Slip potential=sqrt(x-1), 1", r"Friction/Slip potential = sqrt\(x-1\), 1 is not a number, 1" + PLACE +
     "are two finite numbers > 0"),
    ("Friction/Orthotropy angle=1/x", "Friction/Orthotropy angle = 1/x is infinite" + PLACE +
     r"is a finite number \(degrees\)"),
]
EARLY_FORCES = [
    (["Obstacle/Gap=0.01", "Load program/Legs=Fz -1 : 1"],
     r"Load program/Legs: Fz presses from leg 1 on, where a gap of 0\.01 mm is open: allowed is a leg before it that "
     "closes the gap by a motion of uz"),
    (["Load program/Preload=uz 0.1 : 1 ; Fz -1 : 1", "Obstacle/Gap=x^2/100"],
     r"Load program/Preload: Fz presses from leg 2 on, where a gap of 0\.1 mm is open: allowed is a leg before it that "
     "closes the gap by a motion of uz"),
]

# Unusual but valid: overrides, word that the resolved model begins with.
VALID = [
    (["Obstacle/Gap=(x^2+y^2)/200", "Friction/Coefficients=0.3, 0.3"], "axisymmetric"),
    (["Obstacle/Gap=x^2/200"], "quarter"), (["Obstacle/Gap=0.01+x/1000"], "half"),
    (["Friction/Orthotropy angle=atan2(y,x)*180/pi"], "axisymmetric"), (["Friction/Orthotropy angle=x*y"], "quarter"),
    (["Friction/Coefficients=0.3+x/100, 0.15"], "half"), (["Friction/Slip potential=collinear"], "quarter"),
    (["Friction/Orthotropy angle=90"], "quarter"), (["Friction/Orthotropy angle=-180"], "quarter"),
    (["Friction/Orthotropy angle=30"], "full"), (["Load program/Legs=0.1 0 -0.1 : 1"], "half"),
    (["Friction/Orthotropy angle=33", "Friction/Coefficients=0.2, 0.2", "Friction/Slip potential=1, 1"], "axisymmetric"),
    (["Mesh/Core cells=3"], "full"), (["Output/Probes=A: 0 -10; B: 7.071067811865475 7.071067811865475"], "quarter"),
    (["Output/Probes=On-the-rim_but_for_rounding: 7.071067811865476 7.071067811865476"], "quarter"),
    (["Load program/Legs=", "Load program/Preload=0 0 -0.1 : 1"], "quarter"),
]

SLIP, RIM = "Friction/Slip potential = ", "Mesh: elements of degree "
STRAIN, LOCKING = r"Load program: \|u_z\| up to ", "Material/Poisson ratio = "
SHEAR, NO_CONTACT = r"Load program: \|u_t\| without sliding up to ", "Load program: no leg has u_z < 0"
PERIOD = r"Load program/{} when periodic = 1e-10 is less than a hundred times Contact solver/Tolerance = 1e-10, "
# Legal but suspicious: overrides of prm/paper/case_b.prm, which has nothing suspicious, and the warnings of --check.
WARNINGS = [
    ([], []),
    (["Friction/Slip potential=20, 1"], []),
    (["Friction/Slip potential=20.5, 1"], [SLIP + r"20\.5, 1: the axes differ more than 20-fold"]),
    (["Friction/Slip potential=0.01, 0.3"], [SLIP + r"0\.01, 0\.3: the axes differ more than 20-fold"]),
    (["Material/Poisson ratio=0.48"], []),
    (["Material/Poisson ratio=0.499"], [LOCKING + r"0\.499 with Mesh/Degree = 2 and full volumetric quadrature: "]),
    (["Material/Poisson ratio=0.499", "Mesh/Volumetric quadrature=auto"], []),
    (["Material/Poisson ratio=0.48", "Mesh/Degree=1", "Mesh/Layers=12"], []),
    (["Material/Poisson ratio=0.495", "Mesh/Degree=1", "Mesh/Layers=12"],
     [LOCKING + r"0\.495 with Mesh/Degree = 1 and full .* take Mesh/Volumetric quadrature = projected$"]),
    (["Material/Poisson ratio=0.495", "Mesh/Degree=1", "Mesh/Layers=12", "Mesh/Volumetric quadrature=reduced"], []),
    (["Mesh/Resolution=medium", "Mesh/Volumetric quadrature=reduced"], []),
    (["Load program/Legs=0 0 -0.5 : 5"], []),
    (["Load program/Jump when periodic=1e-3"], []),
    (["Load program/Jump when periodic=0.999"], [r"Load program/Jump when periodic = 0\.999: cycles count as periodic although"]),
    (["Load program/Stop when periodic=0.01"], [r"Load program/Stop when periodic = 0\.01: cycles count as periodic although"]),
    (["Load program/Legs=0 0 -0.1 : 5 ; 0 0 -0.6 : 5 ; 0 0 0 : 10"],
     [STRAIN + r"0\.6 mm on Geometry/Height = 10 mm is a strain of 6 %"]),
    (["Load program/Preload=0 0 -1 : 5"], [STRAIN + "1 mm on Geometry/Height = 10 mm is a strain of 10 %"]),
    (["Geometry/Height=1"], [STRAIN + r"0\.1 mm on Geometry/Height = 1 mm is a strain of 10 %"]),
    (["Load program/Legs=0.3 0.4 -0.1 : 5"], []),
    (["Load program/Legs=3 4 -0.1 : 5"], []),
    (["Load program/Legs=3 4 -0.1 : 5", "Friction/Coefficients=10, 0.15"],
     [SHEAR + r"2\.6 mm on Geometry/Height = 10 mm is a shear of 26 %"]),
    (["Load program/Preload=100 0 -1 : 5"], [STRAIN, SHEAR + r"0\.78 mm"]),
    (["Load program/Preload=0 0 -1 : 5", "Load program/Legs=9 0 -9 : 5", "Load program/Cycles=0"],
     [STRAIN + "1 mm "]),
    (["Load program/Legs=0 0 0.1 : 5 ; 0.1 0 0 : 10"], [NO_CONTACT + ".* no contact forces; Legs or Preload need "]),
    (["Load program/Preload=0 0 -1e-9 : 1", "Load program/Legs=0.1 0 0 : 10"], []),
    (["Load program/Stop when periodic=2e-8", "Load program/Cycles=10"], []),
    (["Load program/Stop when periodic=1e-10"], [PERIOD.format("Stop")]),
    (["Load program/Jump when periodic=1e-10"], [PERIOD.format("Jump")]),
    (["Contact solver/Relaxation=1.5", "Contact solver/Method=gauss-seidel"], []),
    (["Contact solver/Relaxation=1.5"], ["Contact solver/Relaxation = 1.5 is ignored with Contact solver/Method = "
                                         "newton; the entry is for gauss-seidel$"]),
    (["Mesh/Layers=2"], [RIM + "2 and 50 % of the radius do not resolve the rim.*more layers and rings"]),
    (["Mesh/Layers=2", "Mesh/Degree=3"], []),
    (["Mesh/Layers=2", "Obstacle/Gap=(x^2+y^2)/900"], []),  # whether the rim touches is for the steps to say
    (["Mesh/Layers=2", "Obstacle/Gap=(x^2+y^2)/900", "Load program/Legs=Fz -10 : 1"],
     ["Mesh: the contact to be expected has . nodes? across, and four are the least",
      "Mesh: the layer of cells at the contact is 5 mm high, but the half width of the contact to be expected is only "]),
    (["Mesh/Rings=1"], [RIM + "2 and 50 % of the radius"]),
    (["Mesh/Degree=1"], [RIM + "1 and 25 % of the radius"]),
    (["Mesh/Degree=1", "Material/Poisson ratio=0.495", "Friction/Slip potential=50, 1", "Geometry/Height=1"],
     [SLIP, LOCKING, STRAIN]),
]
