# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Values of friction, load program and output that are not allowed: name of the file, its text without the message, the message."""
FOLDER = "values"
ROWS = [
    ("accuracy_of_steps_a_number", "subsection Load program\n  set Cycles = 1\n  set Accuracy = 1\nend\n",
     "{file}:4: Load program/Accuracy = 1: allowed is 0, or a percentage >= 0.01 and <= 50 such as 1 %"),
    ("after_continuation",
     "subsection Load program\n  set Legs   = 0 0 -0.1 : 5 ; \\\n               0 0 0    : 10\n  set Cycles = -3\n"
     "end\n",
     "{file}:5: Load program/Cycles = -3: allowed is a whole number from 0 to 1000000"),
    ("checkpoint_negative", "subsection Output\n  set Contact fields = 1\n  set Checkpoint = -1\nend\n",
     "{file}:4: Output/Checkpoint = -1: allowed is a number >= 0 and <= 1e+09"),
    ("checkpoint_too_long", "subsection Output\n  set Contact fields = 1\n  set Checkpoint = 1e10\nend\n",
     "{file}:4: Output/Checkpoint = 1e10: allowed is a number >= 0 and <= 1e+09"),
    ("coefficients_blank",
     "subsection Friction\n  set Slip potential = 0.30, 0.15\n  set Coefficients = 0.30 0.15\nend\n",
     "{file}:4: Friction/Coefficients = 0.30 0.15: allowed is two numbers > 0 (or both 0: no friction) separated "
     "by a comma, or expressions of x, y and z"),
    ("coefficients_comma_at_end",
     "subsection Friction\n  set Slip potential = 0.30, 0.15\n  set Coefficients = 0.3, 0.15,\nend\n",
     "{file}:4: Friction/Coefficients = 0.3, 0.15,: allowed is two numbers > 0 (or both 0: no friction) separated "
     "by a comma, or expressions of x, y and z"),
    ("coefficients_decimal_comma",
     "subsection Friction\n  set Slip potential = 0.30, 0.15\n  set Coefficients = 0,30, 0,15\nend\n",
     "{file}:4: Friction/Coefficients = 0,30, 0,15: allowed is two numbers > 0 (or both 0: no friction) separated "
     "by a comma, or expressions of x, y and z"),
    ("coefficients_negative",
     "subsection Friction\n  set Slip potential = 0.30, 0.15\n  set Coefficients = -0.3, 0.15\nend\n",
     "{file}:4: Friction/Coefficients = -0.3, 0.15: allowed is two numbers > 0 (or both 0: no friction) separated "
     "by a comma, or expressions of x, y and z"),
    ("coefficients_one", "subsection Friction\n  set Slip potential = 0.30, 0.15\n  set Coefficients = 0.3\nend\n",
     "{file}:4: Friction/Coefficients = 0.3: allowed is two numbers > 0 (or both 0: no friction) separated by a "
     "comma, or expressions of x, y and z"),
    ("coefficients_zero",
     "subsection Friction\n  set Slip potential = 0.30, 0.15\n  set Coefficients = 0.3, 0\nend\n",
     "{file}:4: Friction/Coefficients = 0.3, 0: allowed is two numbers > 0 (or both 0: no friction) separated by a "
     "comma, or expressions of x, y and z"),
    ("contact_fields_negative", "subsection Output\n  set Probes = P: 6.72 6.72\n  set Contact fields = -1\nend\n",
     "{file}:4: Output/Contact fields = -1: allowed is a whole number from 0 to 1000000"),
    ("contact_fields_too_many",
     "subsection Output\n  set Probes = P: 6.72 6.72\n  set Contact fields = 1000001\nend\n",
     "{file}:4: Output/Contact fields = 1000001: allowed is a whole number from 0 to 1000000"),
    ("continued",
     "subsection Load program\n  set Legs = 0 0 -0.1 : 5 ; \\\n             0 0 -0.2 : 5 ; \\\n             0 0 0\n"
     "end\n",
     '{file}:3: Load program/Legs = 0 0 -0.1 : 5 ; 0 0 -0.2 : 5 ; 0 0 0: allowed is legs "ux uy uz : steps" '
     '(numbers in mm, at least one step) or "NAME value ... : steps" (ux, uy, uz in mm, rx, ry, rz in degrees, Fx, '
     "Fy, Fz in N, Mx, My, Mz in N mm, or with a unit as in \"ux 10 um\"), separated by ';'; "
     '"steps * parts" solves each step in so many parts'),
    ("continued_into_end", "subsection Load program\n  set Legs = 0 0 -0.1 : 5 ; \\\nend\n",
     '{file}:3: Load program/Legs = 0 0 -0.1 : 5 ; end: allowed is legs "ux uy uz : steps" (numbers in mm, at '
     'least one step) or "NAME value ... : steps" (ux, uy, uz in mm, rx, ry, rz in degrees, Fx, Fy, Fz in N, Mx, '
     "My, Mz in N mm, or with a unit as in \"ux 10 um\"), separated by ';'; "
     '"steps * parts" solves each step in so many parts'),
    ("cycles_exponent", "subsection Load program\n  set Legs = 0 0 -0.1 : 5 ; 0 0 0 : 10\n  set Cycles = 1e3\nend\n",
     "{file}:4: Load program/Cycles = 1e3: allowed is a whole number from 0 to 1000000"),
    ("cycles_negative", "subsection Load program\n  set Legs = 0 0 -0.1 : 5 ; 0 0 0 : 10\n  set Cycles = -1\nend\n",
     "{file}:4: Load program/Cycles = -1: allowed is a whole number from 0 to 1000000"),
    ("cycles_too_many",
     "subsection Load program\n  set Legs = 0 0 -0.1 : 5 ; 0 0 0 : 10\n  set Cycles = 1000001\nend\n",
     "{file}:4: Load program/Cycles = 1000001: allowed is a whole number from 0 to 1000000"),
    ("legs_of_no_parts", "subsection Load program\n  set Cycles = 1\n  set Legs = 0 0 -0.1 : 5 * 0\nend\n",
     '{file}:4: Load program/Legs = 0 0 -0.1 : 5 * 0: allowed is legs "ux uy uz : steps" (numbers in mm, at least one '
     'step) or "NAME value ... : steps" (ux, uy, uz in mm, rx, ry, rz in degrees, Fx, Fy, Fz in N, Mx, My, Mz in N '
     "mm, or with a unit as in \"ux 10 um\"), separated by ';'; "
     '"steps * parts" solves each step in so many parts'),
    ("steps_per_row_zero", "subsection Load program\n  set Cycles = 1\n  set Steps per row = 0\nend\n",
     "{file}:4: Load program/Steps per row = 0: allowed is a whole number from 1 to 1000"),
    ("program_file_of_windows", "subsection Load program\n  set Cycles = 1\n  set Program file = c:\\signal.csv\nend\n",
     "{file}:4: Load program/Program file = c:\\signal.csv: allowed is a path without '#' and '\\', or nothing"),
    ("jump_change_of_friction_negative", "subsection Load program\n  set Jump change of friction = -0.1\nend\n",
     "{file}:3: Load program/Jump change of friction = -0.1: allowed is a number >= 0 and <= 0.5"),
    ("jump_cycles_zero", "subsection Load program\n  set Jump when periodic = 1e-8\n  set Jump cycles = 0\nend\n",
     "{file}:4: Load program/Jump cycles = 0: allowed is a whole number from 1 to 1000000"),
    ("jump_when_periodic_negative", "subsection Load program\n  set Jump when periodic = -1e-8\nend\n",
     "{file}:3: Load program/Jump when periodic = -1e-8: allowed is a number >= 0 and < 1"),
    ("jump_when_periodic_percent", "subsection Load program\n  set Jump when periodic = 1 %\nend\n",
     "{file}:3: Load program/Jump when periodic = 1 %: allowed is a number >= 0 and < 1"),
    ("legs_comma_between", "subsection Load program\n  set Cycles = 3\n  set Legs = 0 0 -0.1 : 5, 0 0 0 : 10\nend\n",
     '{file}:4: Load program/Legs = 0 0 -0.1 : 5, 0 0 0 : 10: allowed is legs "ux uy uz : steps" (numbers in mm, '
     'at least one step) or "NAME value ... : steps" (ux, uy, uz in mm, rx, ry, rz in degrees, Fx, Fy, Fz in N, '
     "Mx, My, Mz in N mm, or with a unit as in \"ux 10 um\"), separated by ';'; "
     '"steps * parts" solves each step in so many parts'),
    ("legs_commas", "subsection Load program\n  set Cycles = 3\n  set Legs = 0, 0, -0.1 : 5\nend\n",
     '{file}:4: Load program/Legs = 0, 0, -0.1 : 5: allowed is legs "ux uy uz : steps" (numbers in mm, at least '
     'one step) or "NAME value ... : steps" (ux, uy, uz in mm, rx, ry, rz in degrees, Fx, Fy, Fz in N, Mx, My, Mz '
     "in N mm, or with a unit as in \"ux 10 um\"), separated by ';'; "
     '"steps * parts" solves each step in so many parts'),
    ("legs_decimal_comma", "subsection Load program\n  set Cycles = 3\n  set Legs = 0 0 -0,1 : 5\nend\n",
     '{file}:4: Load program/Legs = 0 0 -0,1 : 5: allowed is legs "ux uy uz : steps" (numbers in mm, at least one '
     'step) or "NAME value ... : steps" (ux, uy, uz in mm, rx, ry, rz in degrees, Fx, Fy, Fz in N, Mx, My, Mz in N '
     "mm, or with a unit as in \"ux 10 um\"), separated by ';'; "
     '"steps * parts" solves each step in so many parts'),
    ("legs_negative_steps", "subsection Load program\n  set Cycles = 3\n  set Legs = 0 0 -0.1 : -5\nend\n",
     '{file}:4: Load program/Legs = 0 0 -0.1 : -5: allowed is legs "ux uy uz : steps" (numbers in mm, at least one '
     'step) or "NAME value ... : steps" (ux, uy, uz in mm, rx, ry, rz in degrees, Fx, Fy, Fz in N, Mx, My, Mz in N '
     "mm, or with a unit as in \"ux 10 um\"), separated by ';'; "
     '"steps * parts" solves each step in so many parts'),
    ("legs_nothing_between", "subsection Load program\n  set Cycles = 3\n  set Legs = 0 0 -0.1 : 5 0 0 0 : 10\nend\n",
     '{file}:4: Load program/Legs = 0 0 -0.1 : 5 0 0 0 : 10: allowed is legs "ux uy uz : steps" (numbers in mm, at '
     'least one step) or "NAME value ... : steps" (ux, uy, uz in mm, rx, ry, rz in degrees, Fx, Fy, Fz in N, Mx, '
     "My, Mz in N mm, or with a unit as in \"ux 10 um\"), separated by ';'; "
     '"steps * parts" solves each step in so many parts'),
    ("legs_second", "subsection Load program\n  set Cycles = 3\n  set Legs = 0 0 -0.1 : 5 ; 0 0 : 10\nend\n",
     '{file}:4: Load program/Legs = 0 0 -0.1 : 5 ; 0 0 : 10: allowed is legs "ux uy uz : steps" (numbers in mm, at '
     'least one step) or "NAME value ... : steps" (ux, uy, uz in mm, rx, ry, rz in degrees, Fx, Fy, Fz in N, Mx, '
     "My, Mz in N mm, or with a unit as in \"ux 10 um\"), separated by ';'; "
     '"steps * parts" solves each step in so many parts'),
    ("legs_semicolon_in_front", "subsection Load program\n  set Cycles = 3\n  set Legs = ; 0 0 -0.1 : 5\nend\n",
     '{file}:4: Load program/Legs = ; 0 0 -0.1 : 5: allowed is legs "ux uy uz : steps" (numbers in mm, at least '
     'one step) or "NAME value ... : steps" (ux, uy, uz in mm, rx, ry, rz in degrees, Fx, Fy, Fz in N, Mx, My, Mz '
     "in N mm, or with a unit as in \"ux 10 um\"), separated by ';'; "
     '"steps * parts" solves each step in so many parts'),
    ("legs_third",
     "subsection Load program\n  set Cycles = 3\n  set Legs = 0 0 -0.1 : 5 ; 0.01 0 -0.1 : 5 ; 0 0 0 : ten\nend\n",
     '{file}:4: Load program/Legs = 0 0 -0.1 : 5 ; 0.01 0 -0.1 : 5 ; 0 0 0 : ten: allowed is legs "ux uy uz : '
     'steps" (numbers in mm, at least one step) or "NAME value ... : steps" (ux, uy, uz in mm, rx, ry, rz in '
     "degrees, Fx, Fy, Fz in N, Mx, My, Mz in N mm, or with a unit as in \"ux 10 um\"), separated by ';'; "
     '"steps * parts" solves each step in so many parts'),
    ("legs_two_coordinates", "subsection Load program\n  set Cycles = 3\n  set Legs = 0 -0.1 : 5\nend\n",
     '{file}:4: Load program/Legs = 0 -0.1 : 5: allowed is legs "ux uy uz : steps" (numbers in mm, at least one '
     'step) or "NAME value ... : steps" (ux, uy, uz in mm, rx, ry, rz in degrees, Fx, Fy, Fz in N, Mx, My, Mz in N '
     "mm, or with a unit as in \"ux 10 um\"), separated by ';'; "
     '"steps * parts" solves each step in so many parts'),
    ("legs_unit", "subsection Load program\n  set Cycles = 3\n  set Legs = 0 0 -0.1 mm : 5\nend\n",
     '{file}:4: Load program/Legs = 0 0 -0.1 mm : 5: allowed is legs "ux uy uz : steps" (numbers in mm, at least '
     'one step) or "NAME value ... : steps" (ux, uy, uz in mm, rx, ry, rz in degrees, Fx, Fy, Fz in N, Mx, My, Mz '
     "in N mm, or with a unit as in \"ux 10 um\"), separated by ';'; "
     '"steps * parts" solves each step in so many parts'),
    ("legs_without_steps", "subsection Load program\n  set Cycles = 3\n  set Legs = 0 0 -0.1\nend\n",
     '{file}:4: Load program/Legs = 0 0 -0.1: allowed is legs "ux uy uz : steps" (numbers in mm, at least one '
     'step) or "NAME value ... : steps" (ux, uy, uz in mm, rx, ry, rz in degrees, Fx, Fy, Fz in N, Mx, My, Mz in N '
     "mm, or with a unit as in \"ux 10 um\"), separated by ';'; "
     '"steps * parts" solves each step in so many parts'),
    ("legs_zero_steps", "subsection Load program\n  set Cycles = 3\n  set Legs = 0 0 -0.1 : 0\nend\n",
     '{file}:4: Load program/Legs = 0 0 -0.1 : 0: allowed is legs "ux uy uz : steps" (numbers in mm, at least one '
     'step) or "NAME value ... : steps" (ux, uy, uz in mm, rx, ry, rz in degrees, Fx, Fy, Fz in N, Mx, My, Mz in N '
     "mm, or with a unit as in \"ux 10 um\"), separated by ';'; "
     '"steps * parts" solves each step in so many parts'),
    ("line_fields_negative", "subsection Output\n  set Lines = L: 0 0 0 to 0 0 1, 5\n  set Line fields = -1\nend\n",
     "{file}:4: Output/Line fields = -1: allowed is a whole number from 0 to 1000000"),
    ("lines_ends_alike", "subsection Output\n  set Contact fields = 1\n  set Lines = L: 1 2 3 to 1 2 3, 5\nend\n",
     '{file}:4: Output/Lines = L: 1 2 3 to 1 2 3, 5: allowed is lines "name: x y z to x y z, points" (ends in mm that differ; '
     "2 to 100000 points, those of all lines counted; name of up to 100 letters, digits, '-', '_', used once), "
     "separated by ';'"),
    ("lines_one_point", "subsection Output\n  set Contact fields = 1\n  set Lines = L: 0 0 0 to 0 0 1, 1\nend\n",
     '{file}:4: Output/Lines = L: 0 0 0 to 0 0 1, 1: allowed is lines "name: x y z to x y z, points" (ends in mm that differ; '
     "2 to 100000 points, those of all lines counted; name of up to 100 letters, digits, '-', '_', used once), "
     "separated by ';'"),
    ("lines_path", "subsection Output\n  set Contact fields = 1\n  set Lines = ../L: 0 0 0 to 0 0 1, 5\nend\n",
     '{file}:4: Output/Lines = ../L: 0 0 0 to 0 0 1, 5:'
     ' allowed is lines "name: x y z to x y z, points" (ends in mm that differ; '
     "2 to 100000 points, those of all lines counted; name of up to 100 letters, digits, '-', '_', used once), "
     "separated by ';'"),
    ("lines_same_name",
     "subsection Output\n  set Contact fields = 1\n  set Lines = L: 0 0 0 to 0 0 1, 5; L: 0 0 0 to 1 0 0, 5\nend\n",
     '{file}:4: Output/Lines = L: 0 0 0 to 0 0 1, 5; L: 0 0 0 to 1 0 0, 5:'
     ' allowed is lines "name: x y z to x y z, points" (ends in mm that differ; '
     "2 to 100000 points, those of all lines counted; name of up to 100 letters, digits, '-', '_', used once), "
     "separated by ';'"),
    ("lines_too_many_points",
     "subsection Output\n  set Contact fields = 1\n  set Lines = L: 0 0 0 to 0 0 1, 60000; M: 0 0 0 to 1 0 0, 60000\nend\n",
     '{file}:4: Output/Lines = L: 0 0 0 to 0 0 1, 60000; M: 0 0 0 to 1 0 0, 60000:'
     ' allowed is lines "name: x y z to x y z, points" (ends in mm that differ; '
     "2 to 100000 points, those of all lines counted; name of up to 100 letters, digits, '-', '_', used once), "
     "separated by ';'"),
    ("lines_two_coordinates", "subsection Output\n  set Contact fields = 1\n  set Lines = L: 0 0 to 0 1, 5\nend\n",
     '{file}:4: Output/Lines = L: 0 0 to 0 1, 5: allowed is lines "name: x y z to x y z, points" (ends in mm that differ; '
     "2 to 100000 points, those of all lines counted; name of up to 100 letters, digits, '-', '_', used once), "
     "separated by ';'"),
    ("lines_without_points", "subsection Output\n  set Contact fields = 1\n  set Lines = L: 0 0 0 to 0 0 1\nend\n",
     '{file}:4: Output/Lines = L: 0 0 0 to 0 0 1: allowed is lines "name: x y z to x y z, points" (ends in mm that differ; '
     "2 to 100000 points, those of all lines counted; name of up to 100 letters, digits, '-', '_', used once), "
     "separated by ';'"),
    ("lines_without_to", "subsection Output\n  set Contact fields = 1\n  set Lines = L: 0 0 0, 0 0 1, 5\nend\n",
     '{file}:4: Output/Lines = L: 0 0 0, 0 0 1, 5: allowed is lines "name: x y z to x y z, points" (ends in mm that differ; '
     "2 to 100000 points, those of all lines counted; name of up to 100 letters, digits, '-', '_', used once), "
     "separated by ';'"),
    ("long_list",
     "subsection Output\n  set Probes = P1: 1 0; P2: 2 0; P3: 3 0; P4: 4 0; P5: 5 0; P6: 6 0; P7: 7 0; P8: 8 0; "
     "P9: 9 0; P10: 0 0; P11: 1 0; P12: 2 0; P13: 3 0; P14: 4 0; P15: 5 0; P16: 6 0; P17: 7 0; P18: 8 0; P19: 9 0; "
     "P20: 0 0; P21: 1 0; P22: 2 0; P23: 3 0; P24: 4 0; P25: 5 0; P26: 6 0; P27: 7 0; P28: 8 0; P29: 9 0; P30: 0 "
     "0; P31: 1 0; P32: 2 0; P33: 3 0; P34: 4 0; P35: 5 0; P36: 6 0; P37: 7 0; P38: 8 0; P39: 9 0; P40: 0 0; P41: "
     "1 0; P42: 2 0; P43: 3 0; P44: 4 0; P45: 5 0; P46: 6 0; P47: 7 0; P48: 8 0; P49: 9 0; P50: 0 0; P51: 1 0; "
     "P52: 2 0; P53: 3 0; P54: 4 0; P55: 5 0; P56: 6 0; P57: 7 0; P58: 8 0; P59: 9 0; P60: 0 0; P61: 1 0; P62: 2 "
     "0; P63: 3 0; P64: 4 0; P65: 5 0; P66: 6 0; P67: 7 0; P68: 8 0; P69: 9 0; P70: 0 0; P71: 1 0; P72: 2 0; P73: "
     "3 0; P74: 4 0; P75: 5 0; P76: 6 0; P77: 7 0; P78: 8 0; P79: 9 0; P80: 0 0; P81: 1 0; P82: 2 0; P83: 3 0; "
     "P84: 4 0; P85: 5 0; P86: 6 0; P87: 7 0; P88: 8 0; P89: 9 0; P90: 0 0; P91: 1 0; P92: 2 0; P93: 3 0; P94: 4 "
     "0; P95: 5 0; P96: 6 0; P97: 7 0; P98: 8 0; P99: 9 0; P100: 0 0; P101: 1 0; P102: 2 0; P103: 3 0; P104: 4 0; "
     "P105: 5 0; P106: 6 0; P107: 7 0; P108: 8 0; P109: 9 0; P110: 0 0; P111: 1 0; P112: 2 0; P113: 3 0; P114: 4 "
     "0; P115: 5 0; P116: 6 0; P117: 7 0; P118: 8 0; P119: 9 0; P120: 0 0; P121: 1 0; P122: 2 0; P123: 3 0; P124: "
     "4 0; P125: 5 0; P126: 6 0; P127: 7 0; P128: 8 0; P129: 9 0; P130: 0 0; P131: 1 0; P132: 2 0; P133: 3 0; "
     "P134: 4 0; P135: 5 0; P136: 6 0; P137: 7 0; P138: 8 0; P139: 9 0; P140: 0 0; P141: 1 0; P142: 2 0; P143: 3 "
     "0; P144: 4 0; P145: 5 0; P146: 6 0; P147: 7 0; P148: 8 0; P149: 9 0; P150: 0 0; P151: 1 0; P152: 2 0; P153: "
     "3 0; P154: 4 0; P155: 5 0; P156: 6 0; P157: 7 0; P158: 8 0; P159: 9 0; P160: 0 0; P161: 1 0; P162: 2 0; "
     "P163: 3 0; P164: 4 0; P165: 5 0; P166: 6 0; P167: 7 0; P168: 8 0; P169: 9 0; P170: 0 0; P171: 1 0; P172: 2 "
     "0; P173: 3 0; P174: 4 0; P175: 5 0; P176: 6 0; P177: 7 0; P178: 8 0; P179: 9 0; P180: 0 0; P181: 1 0; P182: "
     "2 0; P183: 3 0; P184: 4 0; P185: 5 0; P186: 6 0; P187: 7 0; P188: 8 0; P189: 9 0; P190: 0 0; P191: 1 0; "
     "P192: 2 0; P193: 3 0; P194: 4 0; P195: 5 0; P196: 6 0; P197: 7 0; P198: 8 0; P199: 9 0; P200: 0 0; P201: 1 "
     "0; P202: 2 0; P203: 3 0; P204: 4 0; P205: 5 0; P206: 6 0; P207: 7 0; P208: 8 0; P209: 9 0; P210: 0 0; P211: "
     "1 0; P212: 2 0; P213: 3 0; P214: 4 0; P215: 5 0; P216: 6 0; P217: 7 0; P218: 8 0; P219: 9 0; P220: 0 0; "
     "P221: 1 0; P222: 2 0; P223: 3 0; P224: 4 0; P225: 5 0; P226: 6 0; P227: 7 0; P228: 8 0; P229: 9 0; P230: 0 "
     "0; P231: 1 0; P232: 2 0; P233: 3 0; P234: 4 0; P235: 5 0; P236: 6 0; P237: 7 0; P238: 8 0; P239: 9 0; P240: "
     "0 0; P241: 1 0; P242: 2 0; P243: 3 0; P244: 4 0; P245: 5 0; P246: 6 0; P247: 7 0; P248: 8 0; P249: 9 0; "
     "P250: 0 0; P251: 1 0; P252: 2 0; P253: 3 0; P254: 4 0; P255: 5 0; P256: 6 0; P257: 7 0; P258: 8 0; P259: 9 "
     "0; P260: 0 0; P261: 1 0; P262: 2 0; P263: 3 0; P264: 4 0; P265: 5 0; P266: 6 0; P267: 7 0; P268: 8 0; P269: "
     "9 0; P270: 0 0; P271: 1 0; P272: 2 0; P273: 3 0; P274: 4 0; P275: 5 0; P276: 6 0; P277: 7 0; P278: 8 0; "
     "P279: 9 0; P280: 0 0; P281: 1 0; P282: 2 0; P283: 3 0; P284: 4 0; P285: 5 0; P286: 6 0; P287: 7 0; P288: 8 "
     "0; P289: 9 0; P290: 0 0; P291: 1 0; P292: 2 0; P293: 3 0; P294: 4 0; P295: 5 0; P296: 6 0; P297: 7 0; P298: "
     "8 0; P299: 9 0; P300: 0 0; P7: 7 0\nend\n",
     "{file}:3: Output/Probes = P1: 1 0; P2: 2 0; P3: 3 0; P4: 4 0; P5: 5 0; P6: 6 0; P7: 7 0; P8: 8 0; P9: 9 0; "
     "P10: 0 0; P11: 1 0; P12: 2 0; P13: 3 0; P14: 4 0; P15: 5 0; P16: 6 0; P17: 7 0; P18: 8 0; P19: 9 0; P20: 0 "
     "0; P21: 1 0;...: allowed is probes \"name: x y\" (numbers in mm; name of up to 100 letters, digits, '-', "
     "'_', used once), separated by ';'"),
    ("orthotropy_angle_infinite",
     "subsection Friction\n  set Coefficients = 0.30, 0.15\n  set Orthotropy angle = -inf\nend\n",
     "{file}:4: Friction/Orthotropy angle = -inf: allowed is a number >= -360 and <= 360, or an expression of x, "
     "y and z; 'inf' is not known"),
    ("orthotropy_angle_unit",
     "subsection Friction\n  set Coefficients = 0.30, 0.15\n  set Orthotropy angle = 30 mm\nend\n",
     "{file}:4: Friction/Orthotropy angle = 30 mm: allowed is a number >= -360 and <= 360, or an expression of x, "
     "y and z; 'mm' is not known; mm is a unit of length, and this entry has degrees, degree, deg, \u00b0, rad, mrad"),
    ("preload_none", "subsection Load program\n  set Legs = 0 0 -0.1 : 5 ; 0 0 0 : 10\n  set Preload = none\nend\n",
     '{file}:4: Load program/Preload = none: allowed is legs "ux uy uz : steps" (numbers in mm, at least one step) '
     'or "NAME value ... : steps" (ux, uy, uz in mm, rx, ry, rz in degrees, Fx, Fy, Fz in N, Mx, My, Mz in N mm, or with a unit as in \"ux 10 um\"), '
     "separated by ';'; "
     '"steps * parts" solves each step in so many parts'),
    ("preload_without_steps",
     "subsection Load program\n  set Legs = 0 0 -0.1 : 5 ; 0 0 0 : 10\n  set Preload = 0 0 -0.05\nend\n",
     '{file}:4: Load program/Preload = 0 0 -0.05: allowed is legs "ux uy uz : steps" (numbers in mm, at least one '
     'step) or "NAME value ... : steps" (ux, uy, uz in mm, rx, ry, rz in degrees, Fx, Fy, Fz in N, Mx, My, Mz in N '
     "mm, or with a unit as in \"ux 10 um\"), separated by ';'; "
     '"steps * parts" solves each step in so many parts'),
    ("probes_blank_in_name", "subsection Output\n  set Contact fields = 1\n  set Probes = near rim: 9 0\nend\n",
     '{file}:4: Output/Probes = near rim: 9 0: allowed is probes "name: x y" (numbers in mm; name of up to 100 '
     "letters, digits, '-', '_', used once), separated by ';'"),
    ("probes_comma_between", "subsection Output\n  set Contact fields = 1\n  set Probes = P: 1 0, Q: 2 0\nend\n",
     '{file}:4: Output/Probes = P: 1 0, Q: 2 0: allowed is probes "name: x y" (numbers in mm; name of up to 100 '
     "letters, digits, '-', '_', used once), separated by ';'"),
    ("probes_long_name",
     "subsection Output\n  set Probes = "
     "PPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPP: 1 0\n"
     "end\n",
     "{file}:3: Output/Probes = "
     "PPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPP: 1 0: "
     "allowed is probes \"name: x y\" (numbers in mm; name of up to 100 letters, digits, '-', '_', used once), "
     "separated by ';'"),
    ("probes_path", "subsection Output\n  set Contact fields = 1\n  set Probes = ../P: 1 0\nend\n",
     '{file}:4: Output/Probes = ../P: 1 0: allowed is probes "name: x y" (numbers in mm; name of up to 100 '
     "letters, digits, '-', '_', used once), separated by ';'"),
    ("probes_same_name", "subsection Output\n  set Contact fields = 1\n  set Probes = P: 1 0; P: 2 0\nend\n",
     '{file}:4: Output/Probes = P: 1 0; P: 2 0: allowed is probes "name: x y" (numbers in mm; name of up to 100 '
     "letters, digits, '-', '_', used once), separated by ';'"),
    ("probes_three_coordinates", "subsection Output\n  set Contact fields = 1\n  set Probes = P: 1 0 0\nend\n",
     '{file}:4: Output/Probes = P: 1 0 0: allowed is probes "name: x y" (numbers in mm; name of up to 100 letters, '
     "digits, '-', '_', used once), separated by ';'"),
    ("probes_without_name", "subsection Output\n  set Contact fields = 1\n  set Probes = 6.72 6.72\nend\n",
     '{file}:4: Output/Probes = 6.72 6.72: allowed is probes "name: x y" (numbers in mm; name of up to 100 '
     "letters, digits, '-', '_', used once), separated by ';'"),
    ("problems_negative", "subsection Output\n  set Contact fields = 1\n  set Problems = -1\nend\n",
     "{file}:4: Output/Problems = -1: allowed is a whole number from 0 to 1000000"),
    ("problems_too_many", "subsection Output\n  set Contact fields = 1\n  set Problems = 1000001\nend\n",
     "{file}:4: Output/Problems = 1000001: allowed is a whole number from 0 to 1000000"),
    ("sentence_of_library", "subsection Output\n  set Probes = for the entry named\nend\n",
     '{file}:3: Output/Probes = for the entry named: allowed is probes "name: x y" (numbers in mm; name of up to '
     "100 letters, digits, '-', '_', used once), separated by ';'"),
    ("slip_potential_negative",
     "subsection Friction\n  set Coefficients = 0.30, 0.15\n  set Slip potential = 1, -1\nend\n",
     "{file}:4: Friction/Slip potential = 1, -1: allowed is associated, or two numbers > 0 separated by a comma, "
     "or collinear, or expressions of x, y and z"),
    ("slip_potential_word",
     "subsection Friction\n  set Coefficients = 0.30, 0.15\n  set Slip potential = isotropic\nend\n",
     "{file}:4: Friction/Slip potential = isotropic: allowed is associated, or two numbers > 0 separated by a "
     "comma, or collinear, or expressions of x, y and z"),
    ("slip_potential_zero",
     "subsection Friction\n  set Coefficients = 0.30, 0.15\n  set Slip potential = 0, 1\nend\n",
     "{file}:4: Friction/Slip potential = 0, 1: allowed is associated, or two numbers > 0 separated by a comma, or "
     "collinear, or expressions of x, y and z"),
    ("stop_when_periodic_one", "subsection Load program\n  set Stop when periodic = 1\nend\n",
     "{file}:3: Load program/Stop when periodic = 1: allowed is a number >= 0 and < 1"),
    ("stop_when_periodic_word", "subsection Load program\n  set Cycles = 1000\n  set Stop when periodic = yes\nend\n",
     "{file}:4: Load program/Stop when periodic = yes: allowed is a number >= 0 and < 1"),
    ("volume_fields_negative", "subsection Output\n  set Contact fields = 1\n  set Volume fields = -1\nend\n",
     "{file}:4: Output/Volume fields = -1: allowed is a whole number from 0 to 1000000"),
    ("volume_fields_too_many", "subsection Output\n  set Contact fields = 1\n  set Volume fields = 1000001\nend\n",
     "{file}:4: Output/Volume fields = 1000001: allowed is a whole number from 0 to 1000000"),
]
