# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Names of sections and entries that do not exist: name of the file, its text without the message, the message."""
FOLDER = "names"
ROWS = [
    ("angle", "subsection Friction\n  set Angle = 30\nend\n",
     "{file}:3: Friction/Angle is not an entry; is Friction/Orthotropy angle meant? 'orthocone --defaults' lists "
     "all of them"),
    ("coefficient", "subsection Friction\n  set Coefficients = 0.30, 0.15\n  set Coefficient = 0.3, 0.15\nend\n",
     "{file}:4: Friction/Coefficient is not an entry; is Friction/Coefficients meant? 'orthocone --defaults' lists "
     "all of them"),
    ("coefficients_in_material",
     "subsection Material\n  set Young modulus = 210000\n  set Coefficients = 0.3, 0.15\nend\n",
     "{file}:4: Material/Coefficients is not an entry; is Friction/Coefficients meant? 'orthocone --defaults' "
     "lists all of them"),
    ("colon_equals", "subsection Mesh\n  set Core cells = 8\n  set Degree := 2\nend\n",
     "{file}:4: Mesh/Degree : is not an entry; is Mesh/Degree meant? 'orthocone --defaults' lists all of them"),
    ("complimentarity", "subsection Checks\n  set Equilibrium = 1e-8\n  set Complimentarity = 1e4\nend\n",
     "{file}:4: Checks/Complimentarity is not an entry; is Checks/Complementarity meant? 'orthocone --defaults' "
     "lists all of them"),
    ("core_cells_capitals", "subsection Mesh\n  set Core cells = 8\n  set Core Cells = 8\nend\n",
     "{file}:4: Mesh/Core Cells is not an entry; is Mesh/Core cells meant? 'orthocone --defaults' lists all of them"),
    ("core_cells_underscore", "subsection Mesh\n  set Core cells = 8\n  set Core_cells = 8\nend\n",
     "{file}:4: Mesh/Core_cells is not an entry; is Mesh/Core cells meant? 'orthocone --defaults' lists all of them"),
    ("cycle", "subsection Load program\n  set Legs = 0 0 -0.1 : 5 ; 0 0 0 : 10\n  set Cycle = 3\nend\n",
     "{file}:4: Load program/Cycle is not an entry; is Load program/Cycles meant? 'orthocone --defaults' lists all "
     "of them"),
    ("degre", "subsection Mesh\n  set Core cells = 8\n  set Degre = 2\nend\n",
     "{file}:4: Mesh/Degre is not an entry; is Mesh/Degree meant? 'orthocone --defaults' lists all of them"),
    ("degree_lower_case", "subsection Mesh\n  set Core cells = 8\n  set degree = 2\nend\n",
     "{file}:4: Mesh/degree is not an entry; is Mesh/Degree meant? 'orthocone --defaults' lists all of them"),
    ("degree_without_section", "set Degree = 2\n",
     "{file}:2: Degree is not an entry; is Mesh/Degree meant? 'orthocone --defaults' lists all of them"),
    ("diameter", "subsection Geometry\n  set Radius = 10\n  set Diameter = 20\nend\n",
     "{file}:4: Geometry/Diameter is not an entry; is Geometry/Radius meant? 'orthocone --defaults' lists all of "
     "them"),
    ("element_degree", "subsection Mesh\n  set Element degree = 2\nend\n",
     "{file}:3: Mesh/Element degree is not an entry; is Mesh/Degree meant? 'orthocone --defaults' lists all of them"),
    ("folder", "subsection Output\n  set Folder = results\nend\n",
     "{file}:3: Output/Folder is not an entry; 'orthocone --defaults' lists all of them"),
    ("long_name",
     "subsection Mesh\n  set Core cells = 8\n  set very very very very very very very very very very very very "
     "very very very very very very very very very very very very very very very very very very very very very "
     "very very very very very very very very very very very very very very very very very very very very very "
     "very very very very very very very very very very very very very very very very very very very very very "
     "very very very very very very very very very very very very very very very very very very very very very "
     "very very very very fine = 2\nend\n",
     "{file}:4: Mesh/very very very very very very very very very very very very very very very very very very "
     "very very very very very very very very very very very very very very very very very very very very very ... "
     "is not an entry; 'orthocone --defaults' lists all of them"),
    ("max_iterations", "subsection Contact solver\n  set Method = newton\n  set Max iterations = 500\nend\n",
     "{file}:4: Contact solver/Max iterations is not an entry; is Contact solver/Maximum iterations meant? "
     "'orthocone --defaults' lists all of them"),
    ("mu", "subsection Friction\n  set Coefficients = 0.30, 0.15\n  set mu = 0.3, 0.15\nend\n",
     "{file}:4: Friction/mu is not an entry; is Friction/Coefficients meant? 'orthocone --defaults' lists all of "
     "them"),
    ("number_of_cycles", "subsection Load program\n  set Number of cycles = 3\nend\n",
     "{file}:3: Load program/Number of cycles is not an entry; is Load program/Cycles meant? 'orthocone "
     "--defaults' lists all of them"),
    ("order", "subsection Mesh\n  set Order = 2\nend\n",
     "{file}:3: Mesh/Order is not an entry; is Mesh/Degree meant? 'orthocone --defaults' lists all of them"),
    ("orthotropic_angle", "subsection Friction\n  set Coefficients = 0.30, 0.15\n  set Orthotropic angle = 30\nend\n",
     "{file}:4: Friction/Orthotropic angle is not an entry; is Friction/Orthotropy angle meant? 'orthocone "
     "--defaults' lists all of them"),
    ("path", "set Mesh/Degree = 2\n", "{file}:2: Mesh/Degree is set within 'subsection Mesh', as 'set Degree = 2'"),
    ("path_in_section", "subsection Mesh\n  set Mesh/Layers = 3\nend\n",
     "{file}:3: Mesh/Layers is set within 'subsection Mesh', as 'set Layers = 3'"),
    ("poissons_ratio", "subsection Material\n  set Young modulus = 210000\n  set Poissons ratio = 0.3\nend\n",
     "{file}:4: Material/Poissons ratio is not an entry; is Material/Poisson ratio meant? 'orthocone --defaults' "
     "lists all of them"),
    ("pre-load",
     "subsection Load program\n  set Legs = 0 0 -0.1 : 5 ; 0 0 0 : 10\n  set Pre-load = 0 0 -0.05 : 1\nend\n",
     "{file}:4: Load program/Pre-load is not an entry; is Load program/Preload meant? 'orthocone --defaults' lists "
     "all of them"),
    ("radius_in_mesh", "subsection Mesh\n  set Core cells = 8\n  set Radius = 10\nend\n",
     "{file}:4: Mesh/Radius is not an entry; is Geometry/Radius meant? 'orthocone --defaults' lists all of them"),
    ("raduis", "subsection Geometry\n  set Radius = 10\n  set Raduis = 10\nend\n",
     "{file}:4: Geometry/Raduis is not an entry; is Geometry/Radius meant? 'orthocone --defaults' lists all of them"),
    ("rings_in_geometry", "subsection Geometry\n  set Radius = 10\n  set Rings = 8\nend\n",
     "{file}:4: Geometry/Rings is not an entry; is Mesh/Rings meant? 'orthocone --defaults' lists all of them"),
    ("section_colon", "subsection Output:\n  set Volume fields = 1\nend\n",
     "{file}:2: Output: is not a section; is Output meant? 'orthocone --defaults' lists all of them"),
    ("section_contact_slover", "subsection Contact slover\n  set Method = newton\nend\n",
     "{file}:2: Contact slover is not a section; is Contact solver meant? 'orthocone --defaults' lists all of them"),
    ("section_geometrie", "subsection Geometrie\n  set Radius = 10\nend\n",
     "{file}:2: Geometrie is not a section; is Geometry meant? 'orthocone --defaults' lists all of them"),
    ("section_is_entry", "subsection Legs\nend\n",
     "{file}:2: Legs is not a section; is Load program/Legs meant? 'orthocone --defaults' lists all of them"),
    ("section_load", "subsection Load\n  set Cycles = 3\nend\n",
     "{file}:2: Load is not a section; is Load program meant? 'orthocone --defaults' lists all of them"),
    ("section_loading_program", "subsection Loading program\n  set Cycles = 3\nend\n",
     "{file}:2: Loading program is not a section; is Load program meant? 'orthocone --defaults' lists all of them"),
    ("section_material_properties", "subsection Material properties\n  set Young modulus = 1\nend\n",
     "{file}:2: Material properties is not a section; is Material meant? 'orthocone --defaults' lists all of them"),
    ("section_mesh_lower_case", "subsection mesh\n  set Degree = 2\nend\n",
     "{file}:2: mesh is not a section; is Mesh meant? 'orthocone --defaults' lists all of them"),
    ("section_meshes", "subsection Meshes\n  set Degree = 2\nend\n",
     "{file}:2: Meshes is not a section; is Mesh meant? 'orthocone --defaults' lists all of them"),
    ("section_solver", "subsection Solver\n  set Method = newton\nend\n",
     "{file}:2: Solver is not a section; is Contact solver meant? 'orthocone --defaults' lists all of them"),
    ("section_time_stepping", "subsection Time stepping\n  set Steps = 15\nend\n",
     "{file}:2: Time stepping is not a section; 'orthocone --defaults' lists all of them"),
    ("section_unknown_inside",
     "subsection Mesh\n  set Core cells = 8\n  subsection Refinement\n    set Layers = 4\n  end\nend\n",
     "{file}:4: Mesh/Refinement is not a section; is Mesh/Resolution meant? 'orthocone --defaults' lists all of "
     "them"),
    ("solver", "subsection Contact solver\n  set Solver = newton\nend\n",
     "{file}:3: Contact solver/Solver is not an entry; is Contact solver/Method meant? 'orthocone --defaults' "
     "lists all of them"),
    ("tolerence", "subsection Contact solver\n  set Method = newton\n  set Tolerence = 1e-8\nend\n",
     "{file}:4: Contact solver/Tolerence is not an entry; is Contact solver/Tolerance meant? 'orthocone "
     "--defaults' lists all of them"),
    ("youngs_modulus", "subsection Material\n  set Young modulus = 210000\n  set Young's modulus = 210000\nend\n",
     "{file}:4: Material/Young's modulus is not an entry; is Material/Young modulus meant? 'orthocone --defaults' "
     "lists all of them"),
]
