# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Reads the .vtu files of a run with NumPy alone. VTK's format: XML, the numbers as Base64 of blocks that zlib compressed,
behind their sizes."""
import base64
import xml.etree.ElementTree as xml
import zlib

import numpy as np

_TYPES = {"Float32": "f4", "Float64": "f8", "Int32": "i4", "Int64": "i8", "UInt8": "u1", "Int8": "i1", "UInt32": "u4",
          "UInt64": "u8"}


class Vtu:
    """points: (n, 3), mm. fields: {name: (n,) or (n, k)}. blocks: [(VTK's number of the kind of cell, (m, points of a cell))],
    in the order of the file. field_data: {name: array}. Raises ValueError if this is not such a file."""

    def __init__(self, path):
        try:
            root = xml.parse(path).getroot()
            self._order = "<" if root.get("byte_order") == "LittleEndian" else ">"
            self._header = _TYPES[root.get("header_type", "UInt32")]
            grid = root.find("UnstructuredGrid")
            self.field_data = self._arrays(grid.find("FieldData"))
            piece = grid.find("Piece")
            self.points, = self._arrays(piece.find("Points")).values()
            self.fields = self._arrays(piece.find("PointData"))
            cells = self._arrays(piece.find("Cells"))
            self.blocks = _blocks(cells["connectivity"], cells["offsets"], cells["types"])
        except (xml.ParseError, zlib.error, LookupError, AttributeError, TypeError, ValueError) as error:
            raise ValueError(f"{path}: not a .vtu file of a run ({error})") from error

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
        blocks, parts = base64.b64decode(text[begin:]), []
        ends = np.cumsum(sizes[3:], dtype=np.int64)
        for first, end in zip([0, *ends], ends):
            parts.append(zlib.decompress(blocks[first:end]))
        return b"".join(parts)


def _blocks(connectivity, ends, kinds):
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
