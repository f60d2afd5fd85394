# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What a format is, and how its bytes are read without reaching beyond their end."""
import collections.abc
import dataclasses
import struct

import numpy as np
from surface import WrongSurface


@dataclasses.dataclass
class Format:
    """name: in words. suffixes: of files, lower case. read: (bytes, told) -> Surface, raises WrongSurface. options: what `told`
    may have (formats.read)."""
    name: str
    suffixes: tuple
    read: collections.abc.Callable
    options: tuple = ()


def unpacked(content, offset, kinds, what):
    """The numbers of struct's `kinds` at a byte of the content. Raises WrongSurface where the content ends before."""
    if offset < 0 or offset + struct.calcsize(kinds) > len(content):
        raise WrongSurface(f"ends within its {what}, after {len(content)} bytes; allowed is a whole file: copy it again")
    return struct.unpack_from(kinds, content, offset)


def grid_of(content, offset, kind, nx, ny):
    """(ny, nx) numbers of NumPy's `kind` at a byte of the content. Raises WrongSurface where the content ends before."""
    kind = np.dtype(kind)
    if offset < 0 or len(content) - offset < nx * ny * kind.itemsize:
        raise WrongSurface(f"has {max(len(content) - offset, 0)} bytes of heights; {nx} x {ny} points of {kind.itemsize} bytes are "
                           "declared: the file is cut off or damaged, copy it again")
    return np.frombuffer(content, kind, nx * ny, offset).reshape(ny, nx)
