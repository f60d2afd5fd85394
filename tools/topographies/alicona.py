# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Alicona's .al3d: tags of 52 bytes (20 of a name, 30 of a value, an end of line), and at the place that a tag names heights in
metres, of four bytes, in rows of a multiple of eight bytes. The layout is that of the maker's description of 2003, as the
documentation of Bio-Formats and Gwyddion passes it on."""
import numpy as np
from file_format import Format, grid_of, unpacked
from surface import MILLIMETRES, Surface, WrongSurface, check_size

MAGIC = b"AliconaImaging\0\r\n"
TAG = 52
MOST_TAGS = 1000
SAME = 1.5e-7  # relative: the mark of missing points is written with fewer digits than heights have


def word_of(field):
    return field.split(b"\0")[0].decode("latin-1").strip()


def tags_of(content):
    """{name: text}. The first two tags are the version and the number of all others."""
    tags, i, last = {}, 0, 2
    while i < last:
        name, value, end = unpacked(content, len(MAGIC) + TAG * i, "20s30s2s", "tags")
        if end != b"\r\n":
            raise WrongSurface(f"has a tag {i + 1} that does not end with an end of line: the file is damaged, copy it again")
        tags[word_of(name)] = word_of(value)
        if i == 1:
            last += int(number(tags, "TagCount", 0, MOST_TAGS))
        i += 1
    return tags


def number(tags, name, least, most):
    try:
        value = float(tags[name])
    except (KeyError, ValueError):
        value = float("nan")
    if not least <= value <= most:
        raise WrongSurface(f"has the tag {name} = '{tags.get(name, '')}'; allowed is a number from {least:g} to {most:g}")
    return value


def read(content, told):
    if content[:len(MAGIC)] != MAGIC:
        raise WrongSurface(f"begins with {content[:len(MAGIC)]!r}; allowed is a file of Alicona, with {MAGIC!r}")
    tags = tags_of(content)
    nx, ny = (int(number(tags, name, 0, 2**31)) for name in ("Cols", "Rows"))
    check_size(nx, ny)
    dx, dy = (number(tags, f"PixelSize{axis}Meter", 1e-12, 1.) * MILLIMETRES["m"] for axis in "XY")
    start = int(number(tags, "DepthImageOffset", len(MAGIC) + 2 * TAG, 2**53))
    heights = grid_of(content, start, "<f4", nx + nx % 2, ny)[:, :nx].astype(float)
    if "InvalidPixelValue" in tags and tags["InvalidPixelValue"].lower() != "nan":
        mark = number(tags, "InvalidPixelValue", -1e300, 1e300)
        heights[np.abs(heights - mark) <= SAME * abs(mark)] = np.nan
    heights[~np.isfinite(heights)] = np.nan
    return Surface.centred(heights * MILLIMETRES["m"], dx, dy)


FORMAT = Format("Alicona", (".al3d",), read)
