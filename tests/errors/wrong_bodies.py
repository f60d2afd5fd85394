# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Values of mesh files and materials that are not allowed: name of the file, its text without the message, the message."""
FOLDER = "values"
NAME = "a name without '#', '\\', ',', ';' and ':', a number, or nothing"
REGIONS = ('nothing, or regions "name: E, nu" (E > 0 in MPa, nu > -1 and < 0.5; each volume once), separated by \';\'')


def row(name, section, entry, value, allowed):
    return (name, f"subsection {section}\n  set {entry} = {value}\nend\n",
            f"{{file}}:3: {section}/{entry} = {value}: allowed is {allowed}")


ROWS = [
    row("mesh_file_of_windows", "Geometry", "Mesh file", "parts\\pin.msh", "a path without '#' and '\\', or nothing"),
    row("contact_surface_list", "Geometry", "Contact surface", "base, side", NAME),
    row("held_surface_colon", "Geometry", "Held surface", "top: clamped", NAME),
    row("symmetry_surfaces_comma_twice", "Geometry", "Symmetry surfaces", "x0,, y0", "names or numbers separated by commas, or nothing"),
    row("law_plastic", "Material", "Law", "plastic", "isotropic | orthotropic"),
    row("young_moduli_two", "Material", "Young moduli", "14000, 900", "three numbers > 0 separated by commas"),
    row("poisson_ratios_four", "Material", "Poisson ratios", "0.3, 0.3, 0.3, 0.3", "three numbers separated by commas"),
    row("shear_moduli_zero", "Material", "Shear moduli", "800, 700, 0", "three numbers > 0 separated by commas"),
    row("regions_without_poisson_ratio", "Material", "Regions", "core: 70000", REGIONS),
    row("regions_incompressible", "Material", "Regions", "core: 70000, 0.5", REGIONS),
    row("lower_radius_zero", "Lower geometry", "Radius", "0", "a number > 0"),
    row("lower_shape_sphere", "Lower geometry", "Shape", "sphere", "cylinder | box | file"),
    row("lower_layers_none", "Lower mesh", "Layers", "0", "a whole number from 1 to 200"),
    row("lower_refinements_many", "Lower mesh", "Refinements", "8", "a whole number from 0 to 7"),
    row("lower_poisson_ratio_half", "Lower material", "Poisson ratio", "0.5", "a number > -1 and < 0.5"),
    row("regions_twice", "Material", "Regions", "core: 70000, 0.3 ; core: 1000, 0.3", REGIONS),
]
