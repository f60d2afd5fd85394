# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Values of mesh files and materials that are not allowed: name of the file, its text without the message, the message."""
FOLDER = "values"
NAME = "a name without '#', '\\', ',', ';' and ':', a number, or nothing"
SUPPORTS = "nothing, or surfaces with their directions, such as 'x+: x ; side: x y z'"
CURVED = ("nothing, or surfaces, each once, that are cylinders, spheres or planes, such as 'bore: cylinder through 0 0 5 along "
          "0 1 0 ; ball: sphere about 0 0 8 ; end: plane'")
FATIGUE = ("nothing, or constants \"name: number\" separated by ';', each name once, with the names bending limit, torsion limit, yield "
           "stress, fatemi socie k, findley k, crossland alpha, dang van a; a limit or a yield stress > 0 (MPa), the others >= 0")
REGIONS = ('nothing, or regions "name: E, nu" (E > 0 in MPa, nu > -1 and < 0.5; each volume once), separated by \';\'')


def row(name, section, entry, value, allowed):
    return (name, f"subsection {section}\n  set {entry} = {value}\nend\n",
            f"{{file}}:3: {section}/{entry} = {value}: allowed is {allowed}")


ROWS = [
    row("mesh_file_of_windows", "Geometry", "Mesh file", "parts\\pin.msh", "a path without '#' and '\\', or nothing"),
    row("contact_surface_comma_twice", "Geometry", "Contact surface", "base,, side", "names or numbers separated by commas, or nothing"),
    row("held_surface_colon", "Geometry", "Held surface", "top: clamped", NAME),
    row("symmetry_surfaces_comma_twice", "Geometry", "Symmetry surfaces", "x0,, y0", "names or numbers separated by commas, or nothing"),
    *(row(f"supports_{name}", "Geometry", "Supports", value, SUPPORTS)
      for name, value in (("without_directions", "x+"), ("of_nothing", ": x"), ("along_r", "side: r"),
                          ("along_x_twice", "side: x x"), ("without_semicolon", "x-: x, x+: x"))),
    *(row(f"curved_surfaces_{name}", "Geometry", "Curved surfaces", value, CURVED)
      for name, value in (("cone", "bore: cone"), ("zero_axis", "bore: cylinder through 0 0 0 along 0 0 0"),
                          ("two_numbers", "bore: sphere about 0 0"), ("without_axis", "bore: cylinder through 0 0 0"),
                          ("twice", "end: plane ; end: plane"))),
    row("law_plastic", "Material", "Law", "plastic", "isotropic | orthotropic"),
    row("young_moduli_two", "Material", "Young moduli", "14000, 900", "three numbers > 0 separated by commas"),
    row("poisson_ratios_four", "Material", "Poisson ratios", "0.3, 0.3, 0.3, 0.3", "three numbers separated by commas"),
    row("shear_moduli_zero", "Material", "Shear moduli", "800, 700, 0", "three numbers > 0 separated by commas"),
    row("thermal_expansion_with_unit", "Material", "Thermal expansion", "1.2e-5 K", "a number > -0.01 and < 0.01; K is a unit of temperature, "
        "and this entry has 1/K, /K, ppm/K, um/(m K)"),
    *(row(f"fatigue_{name}", "Material", "Fatigue", value, FATIGUE)
      for name, value in (("of_no_name", "300"), ("with_another_name", "endurance limit: 300"), ("zero", "yield stress: 0"),
                          ("negative", "findley k: -0.1"), ("twice", "yield stress: 300 ; yield stress: 400"),
                          ("with_unit", "yield stress: 300 MPa"))),
    row("regions_without_poisson_ratio", "Material", "Regions", "core: 70000", REGIONS),
    row("regions_incompressible", "Material", "Regions", "core: 70000, 0.5", REGIONS),
    row("regions_twice", "Material", "Regions", "core: 70000, 0.3 ; core: 1000, 0.3", REGIONS),
]
# The lower body has the entries of the other one, in sections of its own.
COUNT, POSITIVE, GRADING = "a whole number from 1 to 200", "a number > 0", "a number > 0 and <= 10"
OF_CELLS = [("Core cells", "0", COUNT), ("Rings", "-1", "a whole number from 0 to 200"), ("Layers", "0", COUNT),
            ("Degree", "5", "a whole number from 1 to 4"), ("Quadrature points", "11", "a whole number from 0 to 10"),
            ("Volumetric quadrature", "b-bar", "auto | full | projected | reduced"), ("Core ratio", "1", "a number >= 0.01 and < 1"),
            ("Rim grading", "0", GRADING), ("Cells", "8", "two or three whole numbers from 1 to 4096 separated by commas"),
            ("Edge grading", "0", GRADING), ("Layer grading", "10.1", GRADING),
            ("Refinements", "8", "a whole number from 0 to 7")]
OF_SIZES = [("Shape", "sphere", "cylinder | box | file"), ("Radius", "0", POSITIVE), ("Height", "-10", POSITIVE),
            ("Sizes", "20, 0, 10", "two or three numbers > 0 separated by commas"), ("Top face", "loose", "clamped | guided | free"),
            ("Supports", "top x", SUPPORTS)]
OF_CONSTANTS = [("Young modulus", "210 N", POSITIVE + "; N is a unit of force, and this entry has MPa, N/mm^2, N/mm2, GPa, kPa, Pa, bar"), ("Poisson ratio", "0.5", "a number > -1 and < 0.5")]
GIVEN = [(text.split("set ")[1].split(" = "), message.split("allowed is ", 1)[1], text) for _, text, message in ROWS]
for section, entries in (("Lower mesh", OF_CELLS), ("Lower geometry", OF_SIZES), ("Lower material", OF_CONSTANTS)):
    ROWS += [row(f"lower_{entry.lower().replace(' ', '_')}", section, entry, value, allowed)
             for entry, value, allowed in entries]
    ROWS += [row(f"lower_{entry.lower().replace(' ', '_')}_{number}", section, entry, value.split("\n")[0], allowed)
             for number, ((entry, value), allowed, text) in enumerate(GIVEN)
             if text.startswith(f"subsection {section[6:].capitalize()}\n")]
