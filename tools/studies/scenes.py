# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The scenes of the maps of failure: small ones, so that thousands of them take minutes."""
import dataclasses
import math
import random
import typing

PEAK = -0.1  # mm
# Of degree 2 and more, the program's own default; prm/paper/scene.prm has full quadrature.
ELEMENT = {"Mesh/Volumetric quadrature": "projected"}
SMALL_MESH = {**ELEMENT, "Mesh/Core cells": 4, "Mesh/Rings": 3, "Mesh/Layers": 4, "Mesh/Degree": 2}
PROGRAM = {"Load program/Legs": f"0 0 {PEAK} : 3 ; 0 0 0 : 6", "Load program/Cycles": 1,
           "Output/Contact fields": 0, "Output/Volume fields": 0}
CASES = {"A": ((0.2, 0.2), (0.2, 0.2)), "B": ((0.3, 0.15), (0.3, 0.15)), "C": ((0.3, 0.15), (0.05, 0.2))}


def number(value):
    return f"{value:.6g}"


def friction(mu, p):
    return {"Friction/Coefficients": f"{number(mu[0])}, {number(mu[1])}",
            "Friction/Slip potential": f"{number(p[0])}, {number(p[1])}"}


def scene(case="C", settings=None):
    """The settings of a small scene of the paper's case, with other settings in place of some."""
    return {"Mesh/Model": "quarter", **SMALL_MESH, **PROGRAM, **friction(*CASES[case]), **(settings or {})}


def logarithmic(first, last, n):
    return [first * (last / first)**(i / (n - 1)) for i in range(n)]


def friction_map(n=9):
    """mu times 0.05 to 10, p_x/p_y from 1/64 to 64 times mu_x/mu_y."""
    for scale in logarithmic(0.05, 10, n):
        for ratio in logarithmic(1 / 64, 64, n):
            mu = (0.3 * scale, 0.15 * scale)
            p = (mu[0] * math.sqrt(ratio), mu[1] / math.sqrt(ratio))
            yield scale, ratio, scene(settings=friction(mu, p))


def body_map(n=8):
    """Poisson's ratio from -0.5 to 0.4999, height/radius from 0.1 to 10."""
    ratios = (-0.5, -0.2, 0, 0.2, 0.3, 0.4, 0.45, 0.49, 0.499, 0.4999)
    for nu in ratios if n > 2 else ratios[3:5]:
        for height in logarithmic(0.1, 10, n - 1) if n > 2 else (0.5, 2):
            peak = PEAK * min(height, 1)
            yield nu, height, scene(settings={
                "Material/Poisson ratio": nu, "Geometry/Height": number(10 * height),
                "Load program/Legs": f"0 0 {number(peak)} : 3 ; 0 0 0 : 6"})


def mesh_map(n=5):
    """Uniform to strongly graded meshes of degree 1 to 3 in cases A, B, C."""
    for grading in logarithmic(1, 0.15, n):
        for case in CASES:
            for degree in (1, 2, 3):
                yield grading, f"{case} Q{degree}", scene(case, settings={
                    "Mesh/Degree": degree, "Mesh/Rim grading": number(grading),
                    "Mesh/Layer grading": number(grading**0.5), "Mesh/Layers": 6})


def steps_map(n=6):
    """One step to 100 steps up and down, tolerance from 1e-4 to 1e-13."""
    for steps in (1, 2, 5, 10, 30, 100) if n > 2 else (1, 5):
        for tolerance in (1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-13) if n > 2 else (1e-6, 1e-10):
            yield steps, tolerance, scene(settings={
                "Load program/Legs": f"0 0 {PEAK} : {steps} ; 0 0 0 : {steps}", "Contact solver/Tolerance": tolerance})


def rho_map(n=10):
    """Factor 0.05 to 4 of the methods' own rho, on trilinear and quadratic elements."""
    for factor in logarithmic(0.05, 4, n):
        for case in CASES:
            for degree in (1, 2):
                yield factor, f"{case} Q{degree}", scene(case, settings={
                    "Mesh/Degree": degree, "Contact solver/Rho factor": number(factor)})


def unloading_map(n=6):
    """Unloading to exactly zero, next to it, and beyond; mu times 0.05 to 10."""
    for end in (-1e-3, -1e-6, -1e-9, -1e-12, 0, 1e-9, 1e-3) if n > 2 else (0, 1e-3):
        for scale in logarithmic(0.05, 10, n):
            yield end, scale, scene(settings={
                **friction((0.3 * scale, 0.15 * scale), (0.05, 0.2)),
                "Load program/Legs": f"0 0 {PEAK} : 3 ; 0 0 {end:g} : 6"})


def random_scene(seed):
    """Everything at once, also programs that turn and elements that are not seen in the maps."""
    chance = random.Random(seed)
    mu = (chance.lognormvariate(math.log(0.3), 0.8), chance.lognormvariate(math.log(0.2), 0.8))
    p = (1, math.exp(chance.gauss(0, 1.2)))
    height = 10 * math.exp(chance.gauss(0, 0.7))
    peak = -0.01 * min(height, 10)
    turn = chance.choice((0, 0.2, 1)) * -peak
    legs = f"0 0 {number(peak)} : {chance.randint(1, 5)} ; "
    if turn:
        legs += (f"{number(turn)} 0 {number(peak)} : {chance.randint(1, 4)} ; "
                 f"{number(turn)} {number(turn)} {number(peak)} : {chance.randint(1, 4)} ; ")
    legs += f"0 0 {chance.choice(('0', number(peak / 10)))} : {chance.randint(1, 8)}"
    return {**friction(mu, p), **PROGRAM, **ELEMENT, "Friction/Orthotropy angle": chance.choice((0, 0, 30, 45)),
            "Material/Poisson ratio": number(chance.choice((-0.3, 0, 0.2, 0.3, 0.4, 0.49, 0.499))),
            "Geometry/Height": number(height), "Mesh/Core cells": chance.choice((2, 4)), "Mesh/Rings": chance.randint(1, 3),
            "Mesh/Layers": chance.randint(2, 4), "Mesh/Degree": chance.randint(1, 3),
            "Mesh/Rim grading": number(chance.uniform(0.3, 1)), "Mesh/Layer grading": number(chance.uniform(0.5, 1)),
            "Load program/Legs": legs}


def random_scenes(n=200):
    for seed in range(n):
        yield seed, "", random_scene(seed)


@dataclasses.dataclass(frozen=True)
class Map:
    """Scenes, words on the axes, what the picture says, and the four methods that it shows."""
    make: typing.Callable
    x: str
    y: str
    message: str
    shown: tuple = ("newton", "gauss-seidel", "uzawa", "plain-newton")
    left_out: tuple = ()  # methods for which nothing changes


FACTOR = "μ / μ of case C"
MAPS = {
    "friction": Map(friction_map, FACTOR, r"$(p_x/p_y)\,/\,(\mu_x/\mu_y)$",
                    "Slip rules far from associated are hard, high friction is not",
                    ("newton", "plain-newton", "uzawa", "feng2006")),
    "body": Map(body_map, "Poisson's ratio", "height / radius",
                "Tall bodies are slow for sweeps, and easy for Newton's method"),
    "mesh": Map(mesh_map, "rim grading", "", "Grading costs sweeps and projections many iterations"),
    "steps": Map(steps_map, "load steps of a leg", "tolerance", "A tight tolerance costs Newton's method little"),
    "rho": Map(rho_map, "factor on ρ", "", "Newton's method does not depend on ρ, Box 3 does",
               ("newton", "plain-newton", "feng2006", "box3"), ("gauss-seidel", "uzawa")),
    "unloading": Map(unloading_map, "$u_z$ at the end (mm)", FACTOR, "Unloading to zero is nothing special"),
}
