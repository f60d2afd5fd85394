# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Constants of fatigue. They come from a JSON file or from the entry Fatigue of a body's material. What is left out is that of
the hard steel of Nishihara and Kawamoto (1945), 0.51 % C, with its limits in reversed bending and torsion. The yield stress is
an assumption, and k of Fatemi and Socie is what they take where nothing is known. The other constants follow from both limits,
so that each parameter agrees with both tests."""
import dataclasses
import math

from criteria import FatemiSocie, Findley, SmithWatsonTopper
from run_folder import BadFile, object_of

DEFAULT_NAME = "hard steel (Nishihara and Kawamoto 1945; its yield stress is assumed)"
ENTRIES = {"bending_limit": 313.9, "torsion_limit": 196.2, "yield_stress": 400.0, "fatemi_socie_k": 1.0}
FURTHER = ("findley_k", "crossland_alpha", "dang_van_a")  # follow from the limits where a file does not give them
ELASTIC = ("young_modulus", "poisson_ratio")  # of the run, where a file does not give them
ALLOWED = ", ".join(("name", *ENTRIES, *FURTHER, *ELASTIC))


class WrongMaterial(ValueError):
    """Constants that are not allowed; the words are one line."""


@dataclasses.dataclass(frozen=True)
class Material:
    """bending_limit, torsion_limit, yield_stress: MPa, both limits of reversed stress; the others have no unit."""
    name: str
    bending_limit: float
    torsion_limit: float
    yield_stress: float
    fatemi_socie_k: float
    findley_k: float
    crossland_alpha: float
    dang_van_a: float
    young_modulus: float = None
    poisson_ratio: float = None
    elasticity: tuple = ()  # pairs (entry, value) of the body's section, for what is None


def constants_of_limits(where, bending, torsion):
    """{constant: number} of the constants for which a parameter is the same at both limits. Findley: the largest tau_a + k
    sigma_n is bending (k + sqrt(1 + k^2))/2 and torsion sqrt(1 + k^2)."""
    ratio = torsion / bending
    sine = 2 * ratio - 1  # k / sqrt(1 + k^2)
    if not (0 <= sine < 1):
        raise WrongMaterial(f"{where}: torsion_limit {torsion:g} is {ratio:.3g} of bending_limit {bending:g}: allowed are 0.5 up to 1, or "
                            "all of findley_k, crossland_alpha and dang_van_a")
    return {"findley_k": sine / math.sqrt(1 - sine**2), "crossland_alpha": 3 * ratio - math.sqrt(3),
            "dang_van_a": 3 * (ratio - 0.5)}


def constants_of_entry(text, entry):
    """{constant: number} of an entry Fatigue, "bending limit: 420 ; torsion limit: 250"."""
    pairs = [piece.split(":") for piece in text.split(";") if piece.strip()]
    try:
        return {name.strip().replace(" ", "_"): float(number) for name, number in pairs}
    except ValueError as error:
        raise BadFile(f"parameters.prm: {entry} is '{text}': allowed are constants 'name: number' separated by ';'") from error


def material_of(path=None, parameters=None, name_of_section="Material"):
    """The constants of a file, or those of the entry Fatigue of a body's section in a parameter file, {section: {entry: text}},
    or the default ones. Raises WrongMaterial, and BadFile and OSError for no such file."""
    section = (parameters or {}).get(name_of_section, {})
    text = section.get("Fatigue", "").strip()
    where = path or f"{name_of_section}/Fatigue"
    given = object_of(path) if path else constants_of_entry(text, where)
    name = given.pop("name", f"constants of {where}" if path or text else DEFAULT_NAME)
    for constant, value in given.items():
        if constant not in {*ENTRIES, *FURTHER, *ELASTIC}:
            raise WrongMaterial(f"{where}: '{constant}' is no constant: allowed are {ALLOWED}")
        if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value):
            raise WrongMaterial(f"{where}: {constant} is no number")
        if value < 0 or (value == 0 and constant in ("bending_limit", "torsion_limit", "yield_stress", "young_modulus")):
            raise WrongMaterial(f"{where}: {constant} is {value:g}: allowed is a number > 0")
    values = {**ENTRIES, **given}
    if any(constant not in given for constant in FURTHER):
        if ("bending_limit" in given) != ("torsion_limit" in given):
            raise WrongMaterial(f"{where}: has one of bending_limit and torsion_limit: allowed are both or neither, because other "
                                "constants follow from their ratio, or all of findley_k, crossland_alpha and dang_van_a")
        values = {**constants_of_limits(where, values["bending_limit"], values["torsion_limit"]), **values}
    if values.get("poisson_ratio") is not None and values["poisson_ratio"] >= 0.5:
        raise WrongMaterial(f"{where}: poisson_ratio is {values['poisson_ratio']:g}: allowed is a number below 0.5")
    elasticity = tuple((key, section[key]) for key in ("Law", "Regions", "Young modulus", "Poisson ratio") if key in section)
    return Material(str(name), **values, elasticity=elasticity)


def elastic_constants(material):
    """Young's modulus (MPa) and Poisson's ratio: those given with the constants of fatigue, or those of the body."""
    section = dict(material.elasticity)
    if material.young_modulus is not None and material.poisson_ratio is not None:
        return material.young_modulus, material.poisson_ratio
    if section.get("Law", "isotropic") != "isotropic" or section.get("Regions"):
        raise WrongMaterial("the run has no single Young modulus and Poisson ratio: allowed is --material with young_modulus and "
                            "poisson_ratio, or --parameters without swt and fatemi_socie")
    try:
        return float(section["Young modulus"]), float(section["Poisson ratio"])
    except (KeyError, ValueError) as error:
        raise BadFile("parameters.prm: has no Young modulus and Poisson ratio") from error


def criterion_of(name, material):
    """The criterion of a critical plane with this name."""
    if name == "findley":
        return Findley(material.findley_k)
    young, poisson = elastic_constants(material)
    if name == "swt":
        return SmithWatsonTopper(young, poisson)
    return FatemiSocie(young, poisson, material.yield_stress, material.fatemi_socie_k)
