# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""A scene of bodies.py as an input file of CalculiX, and what its results say of each step."""
import re

import numpy as np

import bodies

PLATE = (bodies.SIZE * 1.5, 2.)  # half of its edges, height: the rigid plane, one brick
# Kind of contact, stiffness against penetration and against slip of what sticks, MPa/mm.
VARIANTS = {"face to face": ("SURFACE TO SURFACE", 1e8, 1e7), "mortar": ("LINMORTAR", 1e9, 1e8)}
CORNERS = (0, 1, 3, 2, 4, 5, 7, 6)  # x fastest to around


def blocks_of_numbers(numbers, width=12):
    return [", ".join(str(number) for number in numbers[i:i + width]) for i in range(0, len(numbers), width)]


def mesh_lines(nodes, bricks):
    edge, height = PLATE
    plate = [(x, y, z) for z in (-height, 0.) for y in (-edge, edge) for x in (-edge, edge)]
    n = len(nodes)
    lines = ["*NODE, NSET=NALL", *(f"{i + 1}, " + ", ".join(f"{x:.12g}" for x in node) for i, node in enumerate(nodes)),
             "*NODE, NSET=NPLANE", *(f"{n + 1 + i}, {x}, {y}, {z}" for i, (x, y, z) in enumerate(plate)),
             "*ELEMENT, TYPE=C3D8, ELSET=EBODY",
             *(f"{i + 1}, " + ", ".join(str(node + 1) for node in brick[list(CORNERS)]) for i, brick in enumerate(bricks)),
             "*ELEMENT, TYPE=C3D8, ELSET=EPLANE",
             f"{len(bricks) + 1}, " + ", ".join(str(n + 1 + i) for i in CORNERS)]
    for name, z in (("NBASE", 0), ("NTOP", bodies.SIZE)):
        lines += [f"*NSET, NSET={name}", *blocks_of_numbers(bodies.at_height(nodes, z) + 1)]
    base = [i + 1 for i, brick in enumerate(bricks) if np.abs(nodes[brick[:4], 2]).max() < bodies.ROUNDING]
    return lines + ["*ELSET, ELSET=EBASE", *blocks_of_numbers(base)]


def model_lines(variant, friction):
    kind, stiffness, stick = VARIANTS[variant]
    return ["*SURFACE, NAME=SLAVE, TYPE=ELEMENT", "EBASE, S1", "*SURFACE, NAME=MASTER, TYPE=ELEMENT", "EPLANE, S2",
            "*MATERIAL, NAME=STEEL", "*ELASTIC", f"{bodies.YOUNG:g}, {bodies.POISSON:g}",
            "*SOLID SECTION, ELSET=EBODY, MATERIAL=STEEL", "*SOLID SECTION, ELSET=EPLANE, MATERIAL=STEEL",
            "*SURFACE INTERACTION, NAME=TOUCH", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR", f"{stiffness:g}",
            "*FRICTION", f"{friction:g}, {stick:g}", f"*CONTACT PAIR, INTERACTION=TOUCH, TYPE={kind}", "SLAVE, MASTER",
            "*BOUNDARY", "NPLANE, 1, 3"]


def leg_lines(place, n):
    """A leg in n equal increments; iterations as many as contact asks for."""
    return ["*STEP, INC=500", "*CONTROLS, PARAMETERS=TIME INCREMENTATION", "40, 40, 9, 60, 40, 4, , 40, , ", "*STATIC, DIRECT",
            f"{1 / n:.12g}, 1.", "*BOUNDARY", *(f"NTOP, {i + 1}, {i + 1}, {value}" for i, value in enumerate(place)),
            "*NODE PRINT, NSET=NBASE", "U", "*NODE PRINT, NSET=NTOP, TOTALS=ONLY", "RF", "*END STEP"]


def write(scene, variant, path):
    nodes, bricks = scene.mesh()
    lines = mesh_lines(nodes, bricks) + model_lines(variant, scene.friction)
    for *place, n in scene.legs:
        lines += leg_lines(place, n)
    path.write_text("\n".join(lines) + "\n", encoding="ascii")


def results(path):
    """A row a step, of JOB.dat."""
    text = path.read_text(encoding="ascii")
    number = r"\s+([-+0-9.Ee]+)"
    forces = re.findall(r"total force \(fx,fy,fz\) for set NTOP.*?\n\s*\n" + number * 3, text)
    slips = []
    for block in re.split(r"displacements \(vx,vy,vz\) for set NBASE and time.*\n", text)[1:]:
        values = re.findall(r"^\s+\d+" + number * 3 + r"\s*$", block, re.M)
        slips.append(max(np.hypot(float(x), float(y)) for x, y, _ in values))
    return [{"force_x": -float(x), "force_y": -float(y), "force_z": -float(z), "max_slip": slip}
            for (x, y, z), slip in zip(forces, slips)]
