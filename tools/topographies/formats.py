# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The files that surfaces are read from. A new format is a file with a FORMAT, and a line here."""
import alicona
import digital_surf
import grey_image
import numpy as np
import text_grid
import x3p
from run_folder import content_of
from surface import WrongSurface

FORMATS = (digital_surf.FORMAT, x3p.FORMAT, alicona.FORMAT, text_grid.FORMAT, grey_image.FORMAT)


def read(path, told):
    """The Surface of a file. told: {option: value} of what the user says about it, of 'pixel' ((dx, dy), mm), 'unit' (mm in it)
    and 'heights' ((black, white), mm); a format refuses what it knows by itself. Raises WrongSurface, BadFile and OSError."""
    found = next((one for one in FORMATS if path.suffix.lower() in one.suffixes), None)
    if found is None:
        names = "; ".join(f"{', '.join(one.suffixes)} ({one.name})" for one in FORMATS)
        raise WrongSurface(f"{path}: ends with '{path.suffix}'; allowed are {names}")
    content = content_of(path)
    try:
        unused = next((name for name in told if name not in found.options), None)
        if unused:
            allowed = ", ".join(f"--{name}" for name in found.options) or "none of that, because the file says it"
            raise WrongSurface(f"--{unused} is not for this format ({found.name}); allowed: {allowed}")
        with np.errstate(all="ignore"):  # what becomes no number is refused by Surface
            return found.read(content, told)
    except WrongSurface as problem:
        raise WrongSurface(f"{path}: {problem}") from problem
