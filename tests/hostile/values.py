# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Values beyond what is allowed, and allowed ones at the ends of it."""
from bench import Row
from promises import DONE, UNSOLVED, WRONG_INPUT

# Refused values of each entry; beside tests/errors/values and tests/runs/wrong_input.py.
REFUSED = {
    "Geometry/Shape": ["Cylinder", "cylinder cylinder", ""],
    "Geometry/Radius": ["-0", "0x10", "1.2.3", "1e", "5 %", "10kg", "1e-400", "infinity", "--5", "1/2", "(10)", "1_0",
                        "10 10"],
    "Geometry/Height": ["-1e-300", "1,000.5", "e5", ".", "+", "+-5", "-", "10d0"],
    "Geometry/Kind": ["Plane strain", "plane", "2"], "Geometry/Thickness": ["-0", "1 MPa", "inf"],
    "Geometry/Periodic": ["Yes", "true", "1", "yes no", ""],
    "Geometry/Top face": ["Clamped", "clamped | guided", "0", "free free"],
    "Geometry/Supports": ["x", "x:", ":", ";", "side: X", "side: x,y", "side: x ;; top: x", "a\\b: x", "side: x: y", "0"],
    "Geometry/Curved surfaces": ["bore", "bore:", "bore: cone", "bore: cylinder", "bore: cylinder through 0 0 0",
                                 "bore: cylinder through 0 0 0 along 0 0 0", "bore: cylinder through 0 0 0 along 0 -0 1e-400",
                                 "bore: cylinder through 0 0 along 0 1 0", "bore: cylinder through 0 0 0 along y",
                                 "bore: cylinder along 0 1 0 through 0 0 0", "bore: cylinder through 0 0 nan along 0 1 0",
                                 "bore: cylinder through 0, 0, 0 along 0, 1, 0", "bore: sphere", "bore: sphere about",
                                 "bore: sphere about 0 0", "bore: sphere about 0 0 0 0", "bore: sphere about 1e999 0 0",
                                 "bore: sphere around 0 0 0", "bore: Plane", "bore: plane 0 0 1", "bore: plane ; bore: plane",
                                 "bore: plane ;; end: plane", ": plane", "a\\b: plane", "bore: planes", "bore; end: plane"],
    "Lower geometry/Curved surfaces": ["bore: sphere", "bore: cylinder through 0 0 0 along 0 0 0"],
    "Lower geometry/Supports": ["side", "side: xy"], "Lower geometry/Top face": ["Free", ""],
    "Mesh/Model": ["AUTO", "quarter half", "1/4"], "Mesh/Resolution": ["Coarse", "medium,fine"],
    "Load program/Accuracy": ["1 % %", "%", "nan %", "0.009 %", "50.1 %", "1e-2", "-0 %x", "1 percent"],
    "Mesh/Accuracy": ["1 % %", "%", "nan %", "0.009 %", "50.1 %", "1e-2", "-0 %x", "1 percent"],
    "Mesh/Accuracy of": ["", "none", "All", "slip", "largest_slip", "stick area, stick area", "stick area; loop area", "all, stick area"],
    "Mesh/Adaptive": ["-1", "11", "1.0", "one"],
    "Mesh/Refined cells": ["-1", "1-", "-", "1,2", "1;;2", ";", "1-2-3", "4294967296", "0 - 3", "1.5", "all"],
    "Mesh/Core cells": ["+5", "0x8", "8 cells", "1e1", "4294967304", "-4294967288", "2 2"],
    "Mesh/Rings": ["-0", "1e2", "1.0"],
    "Mesh/Layers": ["0.5", "2e2", "18446744073709551618"], "Mesh/Degree": ["-1", "4.0", "1-4"],
    "Mesh/Quadrature points": ["-0", "2.", "three"],
    "Mesh/Volumetric quadrature": ["Reduced", "full reduced", "projected auto"],
    "Mesh/Core ratio": ["0.00999999", "1.0000000001", "-0.5", "1e0x"],
    "Mesh/Rim grading": ["10.000001", "-1", "-0", "nan"], "Mesh/Layer grading": ["1e2", "-1e-9", "1:2"],
    "Material/Fatigue": ["bending limit", "bending limit 300", "bending limit: ", "Bending limit: 300", "bending_limit: 300", ": 300",
                         "bending limit: 1e999 ; torsion limit: 1", "bending limit: nan ; torsion limit: 200", "findley k: -1e-300",
                         "yield stress: 1 ;; yield stress: 2", "yield stress: 1, 2", "yield stress: 1 : 2"],
    "Lower material/Fatigue": ["poisson_ratio: 0.3", "young modulus: 210000"],
    "Material/Thermal expansion": ["0.011", "-1", "1.2e-5 K", "nan"], "Lower material/Thermal expansion": ["1", "e-5"],
    "Load program/Loads": ["a", "a:", ": pressure on side", "a: pressure", "a: Pressure on side", "a: pressure on side along x",
                           "a: traction on side", "a: traction on side along", "a: traction on side along w",
                           "a: traction on side along 0, 0, 0", "a: traction on side along 1, 2", "a: motion on side along 1, 1, 0",
                           "a: temperature on side", "1: pressure on side", "ux: pressure on side", "Fz: pressure on side",
                           "time: pressure on side", "a b: pressure on side", "a: pressure on side side",
                           "a: pressure on side ; a: temperature", "a: pressure on side ;; b: temperature",
                           "a: pressure at side", "a: pressure on"],
    "Material/Young modulus": ["-0", "210 000", "2.1e5kN", "2.1*10^5", "1e309"],
    "Material/Poisson ratio": ["-1.0000001", "1", "inf", "1/3"],
    "Friction/Law": ["Ellipses", "ellipses ellipses", ""],
    "Friction/Coefficients": ["0.3, 0.15, 0.1", "0.3; 0.15", "(0.3, 0.15)", "0.3,", ",0.3", "0.3, nan", "0.3,-0", ", "],
    "Friction/Slip potential": ["1", "1, inf", "1, 2, 3", "1 : 2"],
    "Friction/Rosette weight": ["-1", "1e4", "a", "1, 2", ""], "Friction/Exponent": ["1.0499", "21", "inf", "2 2"],
    "Friction/Slip exponent": ["-2", "20.1", "collinear"],
    "Friction/Orthotropy angle": ["", "1e400", "90 90"],
    "Friction/First axis": ["1", "0, 0", "0, -0, 0", "1, 0, 0, 0", "1; 0; 0", "x y z", "(1, 0, 0)", "1, 0,", ", , ", "a, b, c"],
    "Geometry/Contact surface": ["base;side", ",", "base: x", "a\\b"],
    "Lower geometry/Contact surface": ["base;side", ","],
    "Obstacle/Distance": ["1", "0", "z=1", "z;x", "z z", "1e999", "w", "sqrt(z)-", "if(z)", "rand()", "z,x", "@"],
    "Obstacle/Normal": ["Plane", "z", "surface plane", ""],
    "Obstacle/Gap": ["x=1", "1;2", "(" * 900 + "x", "x" + "+x" * 600, "rand_seed(1)", '"x"', "x y", "1e999", "x?1", "inf",
                     "-1e300*10", "if(x)", "x,y", "\u00b5", "@x", "x!y", "()", "sin", "t"],
    "Load program/Preload": ["0 0 -0.1 : 1 : 1", "0 0 -0.1 : +1", "0 0 -0.1 : 0x1"],
    "Load program/Legs": ["0 0 -0.1 : 4294967297", "0 0 -0.1 : 1e3", "0 0 -1e400 : 1", "0 0 inf : 1", ";", ":",
                          "0 0 -0.1 5", "0 0 0 0 : 1",
                          "0 0 -0.1 : 1 * 4294967297", "0 0 -0.1 : 1 ** 2", "0 0 -0.1 : 2 * -1", "(0 0 -0.1) : 1", "0 0 -0.1 : 1 ; 0 0", "0 0 0x1 : 1", "uz -0.1 N : 1"],
    "Load program/Program file": ["a\\b.csv"], "Load program/Steps per row": ["0", "1.5", "1001", "-1", ""],
    "Load program/Cycles": ["+1", "1.5", "1e6", ""],
    "Load program/Stop when periodic": ["-1e-300", "1.0", "nan", "never"],
    "Wear/Law": ["archard energy", "1", ""], "Wear/Coefficient": ["1e7", "nan", "1e-8 %"],
    "Wear/Deep steps": ["both", "Implicit explicit"],
    "Wear/Largest depth of a jump": ["-1", "inf", "0.1 N"],
    "Friction/Factor": ["0", "-1", "inf", "nan", "1 + x", "s;w", "rand()", "1e301", "", "s w", "v=1", "n n"],
    "Load program/Jump change of friction": ["-1", "0.6", "nan", "1 %", ""],
    "Load program/Jump when periodic": ["1", "inf", ""], "Load program/Jump cycles": ["-1", "1000001", "1.5"],
    "Contact solver/Method": ["NEWTON", "newton newton", "gauss_seidel", ""],
    "Contact solver/Tolerance": ["1e-15", "1.0", "-1e-10", "nan", "1e-10 N"],
    "Contact solver/Maximum iterations": ["-1", "1e6", "5 000"], "Contact solver/Relaxation": ["-0", "2.0", "1e400"],
    "Contact solver/Rho factor": ["-1", "-0", "nan"], "Checks/Equilibrium": ["-1e-8", "inf", "off"],
    "Checks/Penetration": ["0", "nan"],
    "Checks/Complementarity": ["-0", "inf"], "Checks/Friction cone": ["0", "1 %"], "Checks/Slip rule": ["0", "-inf"],
    "Checks/Energy identity": ["0", "nan"], "Checks/Energy defect": ["0", "-2"],
    "Output/Contact fields": ["1.0", "1000001x", "+1"],
    "Output/Volume fields": ["0.5", "-0", "all"], "Output/Problems": ["1.0", "-0", "every"], "Output/Checkpoint": ["-1e-9", "1.1e9", "2 mm", "nan"],
    "Output/Probes": ["P: 1e400 0", "P: nan 0", ";", "P 1 0", "P: 0 0; p: 0", "P/Q: 0 0", "P.csv: 0 0", "P: 0,0",
                      "\u00b5: 0 0", "P:: 0 0"],
    "Output/Lines": ["L: 0 0 0 to 0 0 1e400, 2", "L: nan 0 0 to 0 0 1, 2", ";", "L: 0 0 0 to 0 0 1, 2;; M: 0 0 0 to 0 0 1, 2",
                     "L: 0 0 0 to 0 0 1, 4294967298", "L: 0 0 0 to 0 0 1, -2", "L: 0 0 0 to 0 0 1, 2.0", "to: to", "L: to, 2",
                     "L: 0 0 0 TO 0 0 1, 2", "L: 0 0 0 to 0 0 1e-320 , 1e1", "L: -1.7e308 0 0 to 1.7e308 0 0, 2",
                     "L-0001: 0 0 0 to 0 0 1, 99999; L: 0 0 0 to 0 0 1, 2"],
    "Output/Line fields": ["-0", "1.5", "all"],
}
# The lower body has the entries of the other one.
REFUSED.update({f"Lower {entry[0].lower()}{entry[1:]}": REFUSED[entry][:2] for entry in
                ("Geometry/Shape", "Geometry/Radius", "Geometry/Height", "Mesh/Core cells", "Mesh/Rings", "Mesh/Layers",
                 "Mesh/Degree", "Mesh/Core ratio", "Material/Young modulus", "Material/Poisson ratio")})
# Settings of one run each that must go well.
DONE_WITH = [
    ["Geometry/Radius=1e-9", "Geometry/Height=1e-9", "Load program/Legs=0 0 -1e-11 : 2", "Output/Probes="],
    ["Geometry/Radius=1e6", "Geometry/Height=1e6", "Load program/Legs=0 0 -1e4 : 2"], ["Geometry/Radius=1e3"],
    ["Geometry/Height=1e3"],
    ["Material/Young modulus=1e-9"], ["Material/Young modulus=1e12"], ["Material/Young modulus=+210000"],
    ["Material/Young modulus=2.1E5"],
    ["Material/Poisson ratio=0"], ["Material/Poisson ratio=-0"], ["Material/Poisson ratio=-0.99"],
    ["Material/Poisson ratio=0.4999"],
    ["Material/Poisson ratio=0.4999", "Mesh/Volumetric quadrature=reduced"], ["Material/Poisson ratio=1e-320"],
    ["Mesh/Resolution=coarse", "Material/Poisson ratio=0.49999", "Mesh/Volumetric quadrature=reduced"],
    ["Mesh/Resolution=paper", "Material/Poisson ratio=-0.5"],
    ["Friction/Slip potential=collinear"], ["Friction/Coefficients=3/10, max(0.1,0.15)", "Obstacle/Gap=1-1"],
    ["Load program/Legs=1e6 0 -0.1 : 2"],
    ["Obstacle/Distance=z"], ["Obstacle/Distance=z + x*1e-3"], ["Obstacle/Distance=sqrt(x^2+y^2+(z+1e6)^2)-1e6"],
    ["Obstacle/Distance=max(z, z - 1)"], ["Obstacle/Normal=surface"], ["Friction/First axis=1e300, 0, 0"],
    ["Friction/First axis=1, x*1e-3, 0"], ["Geometry/Contact surface=base"],
    ["Geometry/Contact surface=base, side", "Geometry/Top face=guided", "Obstacle/Distance=min(z, 10.1-sqrt(x^2+y^2))",
     "Friction/Coefficients=0.2, 0.2", "Friction/Slip potential=1, 1"],
    ["Load program/Legs=uz -0.1 : 1 ; ux 0.01 : 2 ; ux 0 uz -0.05 : 1"],
    ["Friction/Law=superellipse", "Friction/Exponent=1.05"], ["Friction/Law=superellipse", "Friction/Exponent=20", "Friction/Slip exponent=1.05"],
    ["Friction/Law=superellipse", "Friction/Coefficients=0, 0"], ["Friction/Law=superellipse", "Friction/Coefficients=0.2+x*1e-3, 0.2"],
    ["Friction/Coefficients=0.01,0.01"], ["Friction/Coefficients=10,0.1"], ["Friction/Coefficients=10,10"],
    ["Friction/Slip potential=3e50,1.5e50"],
    ["Friction/Slip potential=3e99,1.5e99"], ["Friction/Slip potential=3e-99,1.5e-99"],
    ["Friction/Slip potential=0.01,1"],
    ["Friction/Orthotropy angle=-360"], ["Friction/Orthotropy angle=1e-300"], ["Friction/Orthotropy angle=45"],
    ["Mesh/Core cells=1", "Mesh/Rings=1", "Mesh/Layers=1"], ["Mesh/Core cells=1", "Mesh/Rings=200", "Mesh/Layers=1"],
    ["Mesh/Layers=1"], ["Mesh/Layers=60"],
    ["Mesh/Degree=3", "Mesh/Quadrature points=10", "Mesh/Layers=1"],
    ["Mesh/Degree=3", "Mesh/Quadrature points=4", "Mesh/Volumetric quadrature=reduced"],
    ["Mesh/Core ratio=0.01"], ["Mesh/Core ratio=0.9999999999"], ["Mesh/Rim grading=10"], ["Mesh/Rim grading=0.1"],
    ["Mesh/Layer grading=10", "Mesh/Layers=8"],
    ["Mesh/Layer grading=0.1", "Mesh/Layers=8"], ["Mesh/Model=full"], ["Mesh/Model=half"],
    ["Mesh/Resolution=custom", "Mesh/Accuracy=0"],
    ["Friction/Coefficients=0.2,0.2", "Friction/Slip potential=5,5", "Mesh/Degree=4",
     "Output/Probes=A: 0 0; B: 0 0; C: 10 0; D: 0 -10; E: -0 -0"],
    ["Geometry/Top face=guided"], ["Geometry/Top face=guided", "Friction/Coefficients=1,1",
                                   "Friction/Slip potential=1,1"],
    ["Load program/Legs=0 0 0 : 2"], ["Load program/Accuracy=50 %"], ["Load program/Legs=0 0 -0.1 : 1 * 3 ; 0 0 0 : 2"],
    ["Load program/Legs=0 0 0 : 1 * 2", "Load program/Accuracy=0.01 %"],
    ["Load program/Legs=0 0 0.1 : 2 ; 0 0 0 : 2"],
    ["Load program/Legs=0.1 0 0 : 2 ; 0 0 0 : 2"],
    ["Load program/Legs=0 0 -0.1 : 1 ; 0 0 -0.1 : 3 ; 0 0 -0.1 : 1"], ["Load program/Legs=0 0 1e10 : 1 ; 0 0 -0.1 : 1"],
    ["Load program/Legs=0 0 -1e-15 : 2"],
    ["Load program/Legs=0 0 -1e-100 : 2"], ["Load program/Legs=1000 0 -0.1 : 2"],
    ["Load program/Legs=0 0 -9.9 : 1"],
    ["Load program/Legs=0 0 -0.1 : 500", "Output/Contact fields=0"],
    ["Load program/Preload=0 0 -0.1 : 2", "Load program/Legs=", "Load program/Cycles=9"],
    ["Load program/Preload=0 0 -0.1 : 2", "Load program/Cycles=0"],
    ["Load program/Legs=0 0 0 : 2", "Load program/Cycles=4", "Load program/Stop when periodic=0.9"],
    ["Load program/Legs=0 0 0.1 : 2", "Load program/Cycles=5", "Load program/Jump when periodic=1e-6"],
    ["Load program/Cycles=1000000", "Load program/Legs=0 0 -0.1 : 1", "Load program/Jump when periodic=0.01",
     "Load program/Jump cycles=1000000",
     "Output/Contact fields=0"],
    ["Contact solver/Tolerance=1e-14"], ["Contact solver/Tolerance=1e-3"], ["Contact solver/Rho factor=1e-300"],
    ["Contact solver/Rho factor=1e3"],
    ["Contact solver/Method=gauss-seidel", "Contact solver/Relaxation=1.9"],
    ["Contact solver/Method=gauss-seidel", "Contact solver/Relaxation=0.05"],
    ["Contact solver/Method=uzawa"], ["Contact solver/Method=feng2006"], ["Contact solver/Method=plain-newton"],
    ["Checks/Equilibrium=1e9", "Checks/Penetration=1e9", "Checks/Energy defect=1e9"],
    ["Output/Contact fields=1000000", "Output/Volume fields=1000000"],
    ["Output/Contact fields=0", "Output/Checkpoint=1e9"], ["Output/Checkpoint=0", "Output/Volume fields=1"],
    ["Output/Probes=" + "; ".join(f"P{i}: 0 0" for i in range(300))], ["Output/Probes=" + "P" * 100 + ": 1e-320 -0"],
    ["Output/Lines=L-0001: 0 0 0 to 0 0 10, 2; L: 0 0 0 to 0 1e-300 1e-320, 3; to: -10 -0 -0 to 10 0 1e-15, 999"],
    ["Output/Lines=" + "; ".join(f"{'L' * 97}{i}: 0 0 {i / 9} to 1 0 {i / 9}, 2" for i in range(90))],
    ["Output/Probes=-: 0 0; _: 1 1"], ["Load program/Legs=1e9 0 -0.1 : 2"],
]
# Settings of a run that cannot be solved, and what is said.
UNSOLVED_WITH = [
    (["Material/Young modulus=1e-300"], "load step 1 of 4"),
    (["Load program/Legs=3e10 0 -0.1 : 2"], "Checks/Energy identity: .* exceeds the bound 1e-08"),
    (["Material/Young modulus=1e-320"], "load step 1"),
    (["Material/Poisson ratio=0.49999999999999994"], "stiffness|Poisson"),
    (["Mesh/Resolution=coarse", "Material/Poisson ratio=0.49999999", "Mesh/Volumetric quadrature=reduced"],
     "Checks/Equilibrium: .* Poisson ratio .* rounding leaves no more digits"),
    (["Load program/Legs=0 0 -1e-320 : 2"], "load step 1 of 2"),
    (["Contact solver/Maximum iterations=1"], "Maximum iterations"),
    (["Contact solver/Maximum iterations=1", "Contact solver/Method=uzawa"], "uzawa"),
    (["Contact solver/Method=box3"], "box3"),
    (["Contact solver/Method=feng2006", "Contact solver/Rho factor=1e-300"], "feng2006"),
    (["Contact solver/Method=gauss-seidel", "Contact solver/Relaxation=1e-300"], "gauss-seidel"),
    (["Contact solver/Tolerance=0.999"], "Checks/"),
    (["Checks/Equilibrium=1e-300"], "Checks/Equilibrium: .* exceeds the bound 1e-300"),
    (["Checks/Energy identity=1e-300", "Checks/Energy defect=1e-300"], "Checks/Energy"),
    (["Mesh/Accuracy=50 %", "Contact solver/Maximum iterations=1"], "Mesh/Accuracy: load step 1"),
    (["Load program/Accuracy=50 %", "Contact solver/Maximum iterations=1"], "Load program/Accuracy: load step 1"),
]
DEFAULT_MESH = ["Mesh/Core cells=8", "Mesh/Layers=4", "Mesh/Degree=2"]  # where the program chooses the mesh


def refused(number, entry, value):
    """Every other one in a file."""
    section, name = entry.split("/")
    says = f"{entry} (is empty|= .*): allowed" if value.strip() else f"{entry} is empty: allowed"
    row = Row(f"{entry} = {value}"[:90], ["s.prm", f"--set={entry}={value}"], WRONG_INPUT, says)
    if number % 2:
        row.arguments = ["case.prm"]
        row.files = {"case.prm": f"include s.prm\nsubsection {section}\n  set {name} = {value}\nend\n"}
        row.says = "case.prm:3: " + says
    return row


def settings(values):
    chosen = values[0] in ("Mesh/Accuracy=50 %", "Mesh/Resolution=coarse", "Mesh/Resolution=paper")
    return ["s.prm", "--quiet", *[f"--set={value}" for value in [*values, *(DEFAULT_MESH if chosen else [])]]]


def name_of(values):
    return ", ".join(values)[:90]


PAIRS = [(entry, value) for entry, values in REFUSED.items() for value in values]
ROWS = [
    *[refused(number, entry, value) for number, (entry, value) in enumerate(PAIRS)],
    *[Row(name_of(values), settings(values), DONE) for values in DONE_WITH],
    *[Row(name_of(values), settings(values), UNSOLVED, says) for values, says in UNSOLVED_WITH],
]
