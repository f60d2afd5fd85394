# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The runs whose contact problems are raced: what the paper and the pages ask for, at sizes of which all take minutes."""
import dataclasses
import math
import random as python_random

import numpy as np

import scenes  # of tools/studies

# Displacements drive them all: Siconos' solvers of local problems know no equality constraints.
DOWN_AND_UP = "0 0 -0.1 : 5 ; 0 0 -0.01 : 9"
FRETTING = "0 0 -0.02 : 3 ; 0.01 0 -0.02 : 4 ; -0.01 0.004 -0.02 : 8 ; 0.01 0 -0.02 : 8"
LAWS = {**scenes.CASES, "isotropic": ((0.3, 0.3), (0.3, 0.3)), "narrow": ((0.6, 0.06), (0.6, 0.06)),
        "crossed": ((0.6, 0.06), (0.06, 0.6))}


UNSOLVED = "unsolved"  # the family of steps that a run ended with
NEVER = 10**6


@dataclasses.dataclass
class Run:
    """A run whose every nth problem is raced."""
    family: str
    name: str
    file: str  # relative to prm/
    settings: dict
    every: int
    law: str   # isotropic, orthotropic (both associated) or non-associated


def law_of(mu, p):
    if abs(mu[0] * p[1] - mu[1] * p[0]) > 1e-9 * mu[0] * p[1]:
        return "non-associated"
    return "isotropic" if mu[0] == mu[1] else "orthotropic"


def run(family, name, file, law, every, legs, **settings):
    mu, p = LAWS[law] if isinstance(law, str) else law
    words = {key.replace("__", "/").replace("_", " "): value for key, value in settings.items()}
    settings = {"Mesh/Model": "quarter", **scenes.friction(mu, p), "Load program/Legs": legs, "Load program/Cycles": 1}
    return Run(family, name, file, {**settings, **words}, every, law_of(mu, p))


def paper():
    """Cases A, B, C: on the paper's bricks, on its mesh of quadratic elements, and on a small mesh."""
    small = {"Mesh__Core_cells": 4, "Mesh__Rings": 3}
    for case in "ABC":
        low = case.lower()
        yield run("paper", f"{low}-bricks", f"paper/case_{low}_q1.prm", case, 4, DOWN_AND_UP, Mesh__Model="full")
        yield run("paper", f"{low}-quadratic", f"paper/case_{low}.prm", case, 4, DOWN_AND_UP)
        yield run("paper", f"{low}-small", f"paper/case_{low}.prm", case, 3, DOWN_AND_UP, **small)


def fretting():
    """A block that is pressed and moved to and fro."""
    for law in LAWS:
        for name, cells in (("coarse", "6, 6, 4"), ("fine", "11, 11, 6")):
            yield run("fretting", f"fretting-{law}-{name}".lower(), "paper/scene.prm", law, 5, FRETTING, Mesh__Model="full",
                      Geometry__Shape="box", Geometry__Sizes="10, 10, 10", Mesh__Cells=cells, Mesh__Degree=1,
                      Output__Probes="")


def counterbodies():
    """Two bodies that do not fit, and a body on a half-space."""
    for law in ("B", "C"):
        yield run("counterbody", f"two-bodies-{law}".lower(), "two_bodies/steel_on_aluminium.prm", law, 3, DOWN_AND_UP,
                  Mesh__Core_cells=4, Mesh__Rings=3, Mesh__Layers=4, Lower_mesh__Core_cells=4, Lower_mesh__Rings=4,
                  Lower_mesh__Layers=3)
        yield run("counterbody", f"half-space-{law}".lower(), "paper/scene.prm", law, 3, DOWN_AND_UP, Mesh__Core_cells=6,
                  Mesh__Rings=4, Obstacle__Kind="half-space")


def meshes():
    """Degrees 1 to 3, uniform and graded."""
    for case in "ABC":
        for degree, cells in ((1, 10), (2, 6), (3, 4)):
            for grading in (1, 0.4):
                yield run("meshes", f"mesh-{case}-q{degree}-{grading:g}".lower(), "paper/scene.prm", case, 6, DOWN_AND_UP,
                          Mesh__Degree=degree, Mesh__Core_cells=cells, Mesh__Rings=cells // 2, Mesh__Rim_grading=grading,
                          Mesh__Layer_grading=grading**0.5)


def frictions():
    """Friction of case C times 0.1, 1 and 8, slip ratios up to 32 away from the friction's."""
    for scale in (0.1, 1, 8):
        for ratio in (1 / 32, 1 / 4, 1, 8):
            mu = (0.3 * scale, 0.15 * scale)
            law = (mu, (mu[0] * ratio**0.5, mu[1] / ratio**0.5))
            yield run("friction", f"friction-{scale:g}-{ratio:.4g}", "paper/scene.prm", law, 7, DOWN_AND_UP,
                      Mesh__Core_cells=4, Mesh__Rings=3)


def random(count=30):
    """Scenes of docs/stability.md, elements of degree 3 replaced by 2; of each three the first is associated."""
    for seed in range(count):
        settings = {**scenes.random_scene(seed)}
        settings["Mesh/Degree"] = min(2, settings["Mesh/Degree"])
        law = "non-associated"
        if seed % 3 == 0:
            settings["Friction/Slip potential"] = "associated"
            law = "orthotropic"
        yield Run("random", f"random-{seed}", "paper/scene.prm", settings, 4, law)


def unsolved():
    """The random scenes of docs/stability.md that no method comes to the end of, and one that gets few iterations: only the
    step that ends them is written."""
    for seed, few in ((14, {}), (77, {}), (98, {"Contact solver/Maximum iterations": 20})):
        yield Run(UNSOLVED, f"scene-{seed}", "paper/scene.prm", {**scenes.random_scene(seed), **few}, NEVER, "non-associated")


@dataclasses.dataclass
class Stack:
    """Rigid plates on each other, with contacts at random places of their faces: more contacts than degrees of freedom, so
    that W is singular and forces are not unique. They fall, slide and turn."""
    name: str
    n_plates: int
    n_contacts: int  # of each face
    mu: float

    def problem(self):
        """W, q and mu. Plates have mass and inertia 1, sides of 2 and height 1."""
        chance = python_random.Random(self.name)
        H = np.zeros((3 * self.n_plates * self.n_contacts, 6 * self.n_plates))
        for plate in range(self.n_plates):
            for i in range(self.n_contacts):
                x, y = chance.uniform(-1, 1), chance.uniform(-1, 1)
                rows = slice(3 * (plate * self.n_contacts + i), 3 * (plate * self.n_contacts + i) + 3)
                H[rows, 6 * plate:6 * plate + 6] = contact_of_body(x, y, -0.5)
                if plate:
                    H[rows, 6 * plate - 6:6 * plate] = -contact_of_body(x, y, 0.5)
        fall = np.tile([0.2, 0.05, -1, 0, 0, 0.1], self.n_plates)
        return H @ H.T, H @ fall, np.full(len(H) // 3, self.mu)


def contact_of_body(x, y, z):
    """What moves a place of a body along the normal, x and y: its three translations and rotations."""
    return np.array([[0, 0, 1, y, -x, 0], [1, 0, 0, 0, z, -y], [0, 1, 0, -z, 0, x]])


def stacks(is_quick):
    sizes = ((1, 16, 0.4), (2, 10, 0.3), (3, 30, 0.5), (4, 12, 0.9), (5, 6, 0.5), (6, 15, 0.7), (8, 20, 0.3), (12, 6, 0.9))
    return [Stack(f"stack-{n_plates}-{n_contacts}", n_plates, n_contacts, mu)
            for n_plates, n_contacts, mu in (sizes[1:2] if is_quick else sizes)]


@dataclasses.dataclass
class ChangedLaw:
    """A problem of a run with another law, so that nobody has solved it before."""
    name: str
    base: str  # problem of another run
    mu: tuple
    p: tuple
    family: str = "changed law"

    @property
    def law(self):
        return law_of(self.mu, self.p)


def changed_laws(is_quick, count=30):
    """Laws at random, of each three the first is associated; on problems of which each has another gap, slip and mesh."""
    bases = ("fretting-isotropic-coarse/10", "a-small/6", "fretting-b-coarse/15", "c-small/9", "half-space-b/3",
             "fretting-a-coarse/20", "two-bodies-c/6", "b-small/12")
    for seed in range(2 if is_quick else count):
        chance = python_random.Random(seed)
        mu = tuple(chance.lognormvariate(math.log(0.3), 0.8) for _ in range(2))
        p = mu if seed % 3 == 0 else (1, math.exp(chance.gauss(0, 1.2)))
        yield ChangedLaw(f"law-{seed}", bases[0 if is_quick else seed % len(bases)], mu, p)
    for base, mu, p in RIGID_LAWS[:1] if is_quick else RIGID_LAWS:
        yield ChangedLaw(f"{base}-law", f"{base}/1", mu, p, "rigid")


RIGID_LAWS = (("stack-2-10", (0.3, 0.15), (0.05, 0.2)), ("stack-4-12", (0.6, 0.3), (0.6, 0.3)),
              ("stack-6-15", (0.6, 0.3), (0.3, 0.6)))
QUICK = ("b-small", "fretting-isotropic-coarse", "two-bodies-b", "mesh-c-q1-1", "friction-8-1", "random-1", "scene-98")
FAMILIES = (paper, fretting, counterbodies, meshes, frictions, random, unsolved)
NAMES = ("paper", "fretting", "counterbody", "meshes", "friction", "random", UNSOLVED, "rigid", "changed law")


def all_runs(is_quick):
    """All; for a quick test the smallest of each family."""
    for family in FAMILIES:
        runs = list(family())
        yield from [run for run in runs if run.name in QUICK] if is_quick else runs
