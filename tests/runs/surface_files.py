# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Files of measured surfaces, byte by byte as their formats describe them: all fields in a row, where the readers of
tools/topographies pick single ones."""
import io
import struct
import zipfile
import zlib

import numpy as np


def sur(levels, step, spacing, unit, offset, order="<", bits=16, compressed=False, lowest=None, kind=2, size=None):
    """Whole numbers (ny, nx), of which each counts `step` units; spacing (dx, dy) and offset in the unit. lowest: of the measured
    points, where others are not. size: (nx, ny) to declare in place of the true one."""
    nx, ny = size or levels.shape[::-1]
    data = levels.astype(f"{order}i{bits // 8}").tobytes()
    units = [unit.encode("latin-1")] * 6
    if compressed:
        packed = zlib.compress(data)
        data = struct.pack(order + "3I", 1, len(data), len(packed)) + packed
    comment, private = b"a comment", b"\1\2\3"
    head = struct.pack(
        order + "12s4h30s30s5hf4sh2i3i3f16s16s16s16s16s16s16s16s16s3f3h12s7hfI6s2H128s3f2f13s13s",
        b"DSCOMPRESSED" if compressed else b"DIGITAL SURF", 257 if order == ">" else 0, 1, 1, kind, b"a surface", b"somebody",
        0, 0, 0, lowest is not None, 0, 0., b"", bits, int(levels.min()) if lowest is None else lowest, int(levels.max()), nx, ny,
        min(nx * ny, 2**31 - 1), *spacing, step, b"X", b"Y", b"Z", *units, 1., 1., 1., 0, 0, 0, b"", *[0] * 7, 0.,
        len(data) if compressed else 0, b"", len(comment), len(private), b"", 0., 0., offset, 0., 0., b"", b"")
    assert len(head) == 512
    return head + comment + private + data


def mask_of(is_valid):
    """A bit for each point, the first one the lowest of its byte."""
    bits = np.pad(is_valid.ravel(), (0, -is_valid.size % 8)).reshape(-1, 8)
    return bytes(int(sum(1 << i for i in range(8) if byte[i])) for byte in bits)


def x3p(data, shape, kind, increment, offset, spacing, mask=None):
    """data: the bytes of the heights of a shape (ny, nx); increment and offset of the heights, and spacing (dx, dy), in metres."""
    valid = "<ValidPointsLink>bindata/valid.bin</ValidPointsLink>" if mask else ""
    text = f"""<?xml version="1.0" encoding="UTF-8"?>
<p:ISO5436_2 xmlns:p="http://www.opengps.eu/2008/ISO5436_2"><Record1><Revision>ISO5436 - 2000</Revision><FeatureType>SUR</FeatureType>
<Axes><CX><AxisType>I</AxisType><DataType>D</DataType><Increment>{spacing[0]}</Increment><Offset>0</Offset></CX>
<CY><AxisType>I</AxisType><DataType>D</DataType><Increment>{spacing[1]}</Increment><Offset>0</Offset></CY>
<CZ><AxisType>A</AxisType><DataType>{kind}</DataType><Increment>{increment}</Increment><Offset>{offset}</Offset></CZ></Axes></Record1>
<Record3><MatrixDimension><SizeX>{shape[1]}</SizeX><SizeY>{shape[0]}</SizeY><SizeZ>1</SizeZ></MatrixDimension>
<DataLink><PointDataLink>bindata/data.bin</PointDataLink>{valid}</DataLink></Record3></p:ISO5436_2>
"""
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("main.xml", text)
        archive.writestr("bindata/data.bin", data)
        if mask:
            archive.writestr("bindata/valid.bin", mask)
    return file.getvalue()


def al3d(heights, spacing, mark):
    """Heights (ny, nx) and spacing (dx, dy) in metres; mark: the text of the height of missing points."""
    ny, nx = heights.shape
    tags = [("Cols", nx), ("Rows", ny), ("NumberOfPlanes", 0), ("PixelSizeXMeter", f"{spacing[0]:.6e}"), ("PixelSizeYMeter", f"{spacing[1]:.6e}"),
            ("IconOffset", 0), ("DepthImageOffset", 17 + 52 * 10 + 256), ("InvalidPixelValue", mark)]
    tags = [("Version", 1), ("TagCount", len(tags)), *tags]
    head = b"".join(struct.pack("20s30s2s", name.encode(), str(value).encode(), b"\r\n") for name, value in tags)
    rows = np.zeros((ny, nx + nx % 2), dtype="<f4")
    rows[:, :nx] = heights
    return b"AliconaImaging\0\r\n" + head + bytes(256) + rows.tobytes()


def png(levels, bits):
    """Grey levels (ny, nx) of 8 or 16 bits, the upper row first."""
    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
    rows = levels.astype(f">u{bits // 8}")
    head = struct.pack(">2I5B", levels.shape[1], levels.shape[0], bits, 0, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(b"".join(b"\0" + row.tobytes() for row in rows)))
            + chunk(b"IEND", b""))


def pgm(levels):
    """Of 16 bits."""
    return f"P5\n{levels.shape[1]} {levels.shape[0]}\n65535\n".encode() + levels.astype(">u2").tobytes()
