# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Expressions of the place and legs of named components: name of the file, its text without the message, the message."""
FOLDER = "values"

PAIR = "two numbers > 0 (or both 0: no friction) separated by a comma, or expressions of x, y and z"
AXIS = "three expressions of x, y and z separated by commas, which are not all 0, or nothing"
EXPRESSION = "a number, or an expression of x, y and z"
NAMES = "a name of ux, uy, uz, rx, ry, rz, Fx, Fy, Fz, Mx, My, Mz; "


def setting(section, entry, value, allowed):
    """Text and message of a file with this one setting, which stands in the third line."""
    return (f"subsection {section}\n  set {entry} = {value}\nend\n",
            "{file}:3: " + f"{section}/{entry} = {value}: allowed is {allowed}")


def friction(value, fault=""):
    return setting("Friction", "Coefficients", value, PAIR + fault)


def gap(value, fault=""):
    return setting("Obstacle", "Gap", value, EXPRESSION + fault)


def legs(value, allowed):
    return setting("Load program", "Legs", value, allowed)


ROWS = [
    ("mu_unknown_function", *friction("0.3, foo(x)", "; in 'foo(x)' 'foo' is not known")),
    ("mu_unknown_variable", *friction("0.3+0.1*r, 0.15", "; in '0.3+0.1*r' 'r' is not known")),
    ("mu_parenthesis_missing", *friction("0.3, (0.1+x", "; in '(0.1+x' a ')' is missing")),
    ("mu_one_expression", *friction("atan2(y,x)")),
    ("mu_half_none", *friction("0, 0.1+x^2")),
    ("mu_constant_negative", *friction("1-2, 0.1")),
    ("mu_random", *friction("0.3+0.01*rand(), 0.1", "; in '0.3+0.01*rand()' random numbers are not allowed in it")),
    ("slip_expression_operator_missing",
     *setting("Friction", "Slip potential", "2x, 1", "associated, or two numbers > 0 separated by a comma, or collinear, "
              "or expressions of x, y and z; in '2x' 'x' needs an operator before it")),
    ("slip_potential_colinear",
     *setting("Friction", "Slip potential", "colinear", "associated, or two numbers > 0 separated by a comma, or "
              "collinear, or expressions of x, y and z")),
    ("slip_potential_huge",
     *setting("Friction", "Slip potential", "1, 1e305", "associated, or two numbers > 0 and < 1e+300 separated by a "
              "comma, or collinear, or expressions of x, y and z")),
    ("angle_too_few_arguments",
     *setting("Friction", "Orthotropy angle", "atan2(x)", "a number >= -360 and <= 360, or an expression of x, y and z; "
              "'atan2' has too few arguments")),
    ("gap_word", *gap("curved", "; 'curved' is not known")),
    ("gap_infinite", *gap("1/0")),
    ("gap_nan", *gap("nan", "; 'nan' is not known")),
    ("gap_not_a_number", *gap("sqrt(-1)")),
    ("gap_beyond", *gap("1e301")),
    ("gap_ends_early", *gap("x^2+", "; it ends too early")),
    ("gap_power_of_python", *gap("x**2", "; '*' has nothing before it")),
    ("gap_equation", *gap("z = x^2", "; '=' is no comparison; '==' is one")),
    ("distance_constant", *setting("Obstacle", "Distance", "2", "an expression of x, y and z, or nothing")),
    ("distance_of_r", *setting("Obstacle", "Distance", "r - 5", "an expression of x, y and z, or nothing; 'r' is not known")),
    ("normal_along_z", *setting("Obstacle", "Normal", "z", "plane | surface")),
    ("first_axis_zero", *setting("Friction", "First axis", "0, 0, 0", AXIS)),
    ("first_axis_of_two_numbers", *setting("Friction", "First axis", "1, 2", AXIS)),
    ("gap_of_w", *gap("x+w", "; 'w' is not known")),
    ("gap_decimal_comma", *gap("0,1*x", "; a ',' stands outside of parentheses")),
    ("gap_unit", *gap("0.1 MPa", "; 'MPa' is not known; MPa is a unit of stress, and this entry has mm, um, \u00b5m, nm, cm, m")),
    ("gap_file_of_windows", *setting("Obstacle", "Gap file", "measured\\gap.txt", "a path without '#' and '\\', or nothing")),
    ("rosette_of_windows", *setting("Friction", "Rosette", "measured\\friction.txt", "a path without '#' and '\\', or nothing")),
    ("rosette_weight_negative", *setting("Friction", "Rosette weight", "-0.5", "a number >= 0 and <= 1000, or an expression of x, y and z")),
    ("exponent_of_a_rhombus", *setting("Friction", "Exponent", "1", "a number >= 1.05 and <= 20")),
    ("slip_exponent_associated", *setting("Friction", "Slip exponent", "associated", "a number >= 0 and <= 20")),
    ("wear_law_of_holm", *setting("Wear", "Law", "holm", "none | archard | energy")),
    ("wear_coefficient_negative", *setting("Wear", "Coefficient", "-1e-8", "a number >= 0 and <= 1e+06")),
    ("wear_coefficient_of_a_unit", *setting("Wear", "Coefficient", "1e-8 mm", "a number >= 0 and <= 1e+06; mm is a unit of length, and this entry has MPa\u207b\u00b9, "
                                            "1/MPa, mm^2/N, mm^3/(N mm), mm^3/Nmm, mm3/Nmm, 1/GPa, 1/Pa, mm^3/(N m), mm^3/Nm, mm3/Nm")),
    ("wear_deep_steps", *setting("Wear", "Deep steps", "both", "implicit | explicit")),
    ("wear_jump_negative", *setting("Wear", "Largest depth of a jump", "-0.1", "a number >= 0 and <= 1e+06")),
    ("legs_component_twice", *legs("uz -0.1 ux 0.1 uz 0 : 5", "a component once in a leg; uz is named twice")),
    ("legs_motion_and_force",
     *legs("uz -0.1 Fz -100 : 5", "a component once in a leg; uz and Fz are the same component")),
    ("legs_moment_and_rotation",
     *legs("0 0 -0.1 : 2 ; Mz 10 rz 1 : 5", "a component once in a leg; Mz and rz are the same component")),
    ("legs_lower_case_force", *legs("fz -100 : 5", NAMES + "'fz' is none, is Fz meant?")),
    ("legs_unknown_name", *legs("down 0.1 : 5", NAMES + "'down' is none")),
]
