# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""X3P of ISO 25178-72 and ISO 5436-2: a zip archive with main.xml, which describes axes and size, and heights as numbers of the
machine. All lengths are in metres. The layout is that of the schema of openGPS (www.opengps.eu)."""
import io
import math
import xml.etree.ElementTree as xml
import zipfile

import numpy as np
from file_format import Format, grid_of
from surface import MILLIMETRES, Surface, WrongSurface, check_size

KINDS = {"I": "<i2", "L": "<i4", "F": "<f4", "D": "<f8"}
MOST_XML = 10_000_000  # bytes


def member(archive, name, most):
    """The bytes of a file of the archive, of which no more than `most` are unpacked."""
    try:
        if archive.getinfo(name).file_size > most:
            raise WrongSurface(f"has {name} of {archive.getinfo(name).file_size} bytes; allowed are {most}, which is what is declared")
        with archive.open(name) as file:
            return file.read(most)
    except WrongSurface:
        raise
    except KeyError as error:
        raise WrongSurface(f"has no {name}; allowed is an archive of ISO 25178-72") from error
    except Exception as error:  # whatever the reader of archives stumbles over
        raise WrongSurface(f"has {name} that is damaged or locked ({error}); copy the file again") from error


def text_at(root, path, otherwise=None):
    """The text of an element, whatever its name space; `otherwise` if it is not there or empty."""
    found = root.find("/".join("{*}" + name for name in path.split("/")))
    text = (found.text or "").strip() if found is not None else ""
    if not text and otherwise is None:
        raise WrongSurface(f"main.xml has no {path}; allowed is one of ISO 25178-72")
    return text or otherwise


def number_at(root, path, otherwise=None):
    text = text_at(root, path, otherwise)
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise WrongSurface(f"main.xml has {path} = '{text}'; allowed is a finite number")
    return value


def description(archive):
    content = member(archive, "main.xml", MOST_XML)
    if b"<!DOCTYPE" in content or b"<!ENTITY" in content:
        raise WrongSurface("main.xml has definitions of its own; allowed is one of ISO 25178-72, which has none")
    try:
        root = xml.fromstring(content)
    except (xml.ParseError, ValueError, LookupError) as error:
        raise WrongSurface(f"main.xml is no XML ({error}); copy the file again") from error
    for path, allowed in (("Record1/FeatureType", ("SUR",)), ("Record1/Axes/CX/AxisType", ("I",)), ("Record1/Axes/CY/AxisType", ("I",)),
                          ("Record1/Axes/CZ/DataType", tuple(KINDS))):
        if text_at(root, path) not in allowed:
            raise WrongSurface(f"main.xml has {path} = '{text_at(root, path)}'; allowed is {' or '.join(allowed)}: a surface on a regular grid")
    return root


def read(content, told):
    try:
        archive = zipfile.ZipFile(io.BytesIO(content))
    except Exception as error:
        raise WrongSurface(f"is no zip archive ({error}); allowed is X3P of ISO 25178-72: copy the file again") from error
    root = description(archive)
    nx, ny, nz = (number_at(root, f"Record3/MatrixDimension/Size{axis}", "1" if axis == "Z" else None) for axis in "XYZ")
    if nz != 1 or nx % 1 or ny % 1:
        raise WrongSurface(f"main.xml has {nx:g} x {ny:g} x {nz:g} points; allowed are whole numbers, and one layer")
    nx, ny = int(nx), int(ny)
    check_size(nx, ny)
    kind = KINDS[text_at(root, "Record1/Axes/CZ/DataType")]
    data = member(archive, text_at(root, "Record3/DataLink/PointDataLink"), nx * ny * np.dtype(kind).itemsize)
    heights = grid_of(data, 0, kind, nx, ny) * number_at(root, "Record1/Axes/CZ/Increment", "1") + number_at(root, "Record1/Axes/CZ/Offset", "0")
    if text_at(root, "Record3/DataLink/ValidPointsLink", "-") != "-":
        n_bytes = -(-nx * ny // 8)
        bits = grid_of(member(archive, text_at(root, "Record3/DataLink/ValidPointsLink"), n_bytes), 0, "u1", n_bytes, 1)
        heights[np.unpackbits(bits.ravel(), bitorder="little")[:nx * ny].reshape(ny, nx) == 0] = np.nan
    dx, dy = (number_at(root, f"Record1/Axes/C{axis}/Increment") * MILLIMETRES["m"] for axis in "XY")
    return Surface.centred(heights * MILLIMETRES["m"], dx, dy)


FORMAT = Format("ISO 25178-72", (".x3p",), read)
