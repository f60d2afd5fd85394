# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Reads the .vtu files of a run with NumPy alone. VTK's format: XML, the numbers as Base64 of blocks that zlib compressed,
behind their sizes."""
import base64
import xml.etree.ElementTree as xml
import zlib

import numpy as np

from .outside import content_of, understood

MOST_BYTES = 4_000_000_000  # of all numbers in a file: few compressed bytes may stand for many
_TYPES = {"Float32": "f4", "Float64": "f8", "Int32": "i4", "Int64": "i8", "UInt8": "u1", "Int8": "i1", "UInt32": "u4",
          "UInt64": "u8"}


class Vtu:
    """points: (n, 3), mm. fields: {name: (n,) or (n, k)}. blocks: [(VTK's number of the kind of cell, (m, points of a cell))],
    in the order of the file. field_data: {name: array}. Raises ValueError if this is not such a file."""

    def __init__(self, path):
        content, self._room = content_of(path), MOST_BYTES
        with understood(path, "a .vtu file of a run"):
            root = xml.fromstring(content)
            self._order = "<" if root.get("byte_order") == "LittleEndian" else ">"
            self._header = _TYPES[root.get("header_type", "UInt32")]
            grid = root.find("UnstructuredGrid")
            self.field_data = self._arrays(grid.find("FieldData"))
            piece = grid.find("Piece")
            self.points, = self._arrays(piece.find("Points")).values()
            self.fields = self._arrays(piece.find("PointData"))
            if self.points.shape[1:] != (3,) or any(len(field) != len(self.points) for field in self.fields.values()):
                raise ValueError("fields and points are of different lengths")
            cells = self._arrays(piece.find("Cells"))
            self.blocks = _blocks(cells["connectivity"], cells["offsets"], cells["types"], len(self.points))

    def _arrays(self, element):
        return {array.get("Name"): self._array(array) for array in (() if element is None else element)}

    def _array(self, element):
        kind = _TYPES[element.get("type")]
        if element.get("format") == "ascii":
            values = np.array((element.text or "").split(), dtype=kind)
        else:
            values = np.frombuffer(self._decompressed(element.text.strip()), dtype=self._order + kind).astype(kind)
        columns = int(element.get("NumberOfComponents", "1"))
        return values.reshape(-1, columns) if columns > 1 else values

    def _decompressed(self, text):
        """Header: number of blocks, size of a block, size of the last one, compressed size of each block. Base64 of the header
        is apart from that of the blocks."""
        size = np.dtype(self._header).itemsize

        def header(n):
            length = -(-n * size // 3) * 4
            return length, np.frombuffer(base64.b64decode(text[:length])[:n * size], dtype=self._order + self._header)
        n_blocks = int(header(3)[1][0])
        begin, sizes = header(3 + n_blocks)
        if len(sizes) != 3 + n_blocks:
            raise ValueError("the sizes of its blocks are wrong")
        blocks, parts = base64.b64decode(text[begin:]), []
        ends = np.cumsum(sizes[3:], dtype=np.int64)
        for first, end in zip([0, *ends], ends):
            parts.append(self._block(blocks[first:end]))
        return b"".join(parts)

    def _block(self, compressed):
        one = zlib.decompressobj()
        block = one.decompress(compressed, self._room + 1)
        self._room -= len(block)
        if self._room < 0 or not one.eof:
            raise ValueError(f"more than {MOST_BYTES} bytes of numbers" if self._room < 0 else "a block is cut off")
        return block


def _blocks(connectivity, ends, kinds, n_points):
    ends = ends.astype(np.int64)
    if len(ends) != len(kinds) or np.any(np.diff(ends, prepend=0) <= 0) or ends[-1:].sum() > len(connectivity):
        raise ValueError("the offsets of its cells are wrong")
    if len(connectivity) and not (connectivity.min() >= 0 and connectivity.max() < n_points):
        raise ValueError("its cells name points that are not there")
    begins = np.concatenate([[0], ends[:-1]]).astype(np.int64)
    changes = np.flatnonzero(np.diff(kinds)) + 1
    blocks = []
    for cells in np.split(np.arange(len(kinds)), changes):
        sizes = set((ends[cells] - begins[cells]).tolist())
        if len(sizes) == 1:
            blocks.append((int(kinds[cells[0]]), connectivity[begins[cells][:, None] + np.arange(sizes.pop())]))
        elif sizes:
            raise ValueError("cells of one kind have points in different numbers")
    return blocks
