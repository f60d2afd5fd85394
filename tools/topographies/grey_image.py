# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Images whose grey levels are heights. The upper row of an image lies at the largest y, so that a surface looks as its image."""
import io
import warnings

import numpy as np
from file_format import Format
from surface import MOST_POINTS, Surface, WrongSurface, check_size

KINDS = ("PNG", "TIFF", "BMP", "PPM")


def grey_levels(content):
    """(ny, nx) levels and the level of white: 255, or 65535 of 16 bits."""
    from PIL import Image  # comes with Matplotlib, and only images need it
    Image.MAX_IMAGE_PIXELS = MOST_POINTS
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            image = Image.open(io.BytesIO(content), formats=KINDS)
            check_size(*image.size)
            levels, kind = np.asarray(image), image.mode
    except WrongSurface:
        raise
    except Exception as error:  # whatever a decoder stumbles over
        raise WrongSurface(f"is no image that can be read ({error}); allowed are whole files of {', '.join(KINDS)}") from error
    if kind in ("RGB", "RGBA") and np.all(levels[..., :3] == levels[..., :1]):
        levels, kind = levels[..., 0], "L"
    if kind != "L" and not (kind.startswith("I") and levels.min() >= 0 and levels.max() <= 65535):
        raise WrongSurface(f"is an image of the kind {kind}; allowed are grey levels of 8 or 16 bits: save it as such")
    return levels, 255 if kind == "L" else 65535


def read(content, told):
    for name, example in (("pixel", "0.5um"), ("heights", "0,12um")):
        if name not in told:
            raise WrongSurface(f"is an image, which has no lengths; allowed with --{name}, such as --{name} {example}")
    levels, white = grey_levels(content)
    low, high = told["heights"]
    return Surface.centred(low + (high - low) * levels[::-1] / white, *told["pixel"])


FORMAT = Format("grey levels", (".png", ".tif", ".tiff", ".bmp", ".pgm"), read, ("pixel", "heights"))
