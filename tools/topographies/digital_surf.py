# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Digital Surf's .sur, as MountainsMap and many instruments write it: a header of 512 bytes, a comment, a private zone, and whole
numbers of 16 or 32 bits, which since 2010 may be compressed by zlib. The layout is that of the maker's manual, as Gwyddion's
and RosettaSciIO's documentation pass it on."""
import struct
import zlib

from file_format import Format, grid_of, unpacked
from surface import Surface, WrongSurface, check_size, unit_of

HEADER, MOST_STREAMS = 512, 1000
PLAIN, COMPRESSED = b"DIGITAL SURF", b"DSCOMPRESSED"
BIG_ENDIAN = 257  # of the entry `format`: a Macintosh
SURFACES = (1, 2, 16)  # Gwyddion writes 1, which is a profile, for surfaces; 16 has an image behind the surface
FIELDS = {"kind": (18, "h"), "special": (86, "h"), "bits": (98, "h"), "lowest": (100, "i"), "nx": (108, "i"), "ny": (112, "i"),
          "dx": (120, "f"), "dy": (124, "f"), "dz": (128, "f"), "comment": (334, "H"), "private": (336, "H"), "offset": (474, "f")}
UNITS = {"dx": 180, "dy": 196, "dz": 212}


def inflated(content, start, order, n_bytes):
    """The streams behind a number of streams and the lengths of each, raw and compressed; no more than n_bytes."""
    n_streams, = unpacked(content, start, order + "I", "list of streams")
    if n_streams > MOST_STREAMS:
        raise WrongSurface(f"has {n_streams} streams of compressed heights; allowed are {MOST_STREAMS}: the file is damaged, copy it again")
    place, data = start + 4 + 8 * n_streams, b""
    for i in range(n_streams):
        _, length = unpacked(content, start + 4 + 8 * i, order + "2I", "list of streams")
        try:
            data += zlib.decompressobj().decompress(content[place:place + length], max(n_bytes - len(data), 1))
        except zlib.error as error:
            raise WrongSurface(f"has compressed heights that are damaged ({error}); copy the file again") from error
        place += length
        if len(data) >= n_bytes:
            break
    return data


def unit_at(content, offset):
    """mm in the unit whose name is at a byte: µ is one byte, or two."""
    word = struct.unpack_from("16s", content, offset)[0].split(b"\0")[0].decode("latin-1").replace("Â", "")
    return unit_of(word)


def read(content, told):
    if content[:12] not in (PLAIN, COMPRESSED):
        raise WrongSurface(f"begins with {content[:12]!r}; allowed is a file of Digital Surf, with {PLAIN!r} or {COMPRESSED!r}")
    unpacked(content, 0, f"{HEADER}s", "header")
    order = ">" if BIG_ENDIAN in struct.unpack_from("<h", content, 12) else "<"
    head = {name: struct.unpack_from(order + kind, content, offset)[0] for name, (offset, kind) in FIELDS.items()}
    if head["kind"] not in SURFACES or head["bits"] not in (16, 32):
        raise WrongSurface(f"has an object of kind {head['kind']} with {head['bits']} bits a point; allowed is a surface (2) of 16 or "
                           "32: save that alone")
    check_size(head["nx"], head["ny"])
    mm = {name: unit_at(content, offset) for name, offset in UNITS.items()}
    start = HEADER + head["comment"] + head["private"]
    if content[:12] == COMPRESSED:
        content, start = inflated(content, start, order, head["nx"] * head["ny"] * head["bits"] // 8), 0
    points = grid_of(content, start, f"{order}i{head['bits'] // 8}", head["nx"], head["ny"])
    heights = (points * float(head["dz"]) + head["offset"]) * mm["dz"]
    if head["special"] == 1:
        heights[points == head["lowest"] - 2] = float("nan")
    return Surface.centred(heights, head["dx"] * mm["dx"], head["dy"] * mm["dy"])


FORMAT = Format("Digital Surf", (".sur",), read)
