# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Writes fields of fatigue as a VTU file, in the format of the program's own files."""
import base64
import zlib

import numpy as np

_NAMES = {"float64": "Float64", "float32": "Float32", "int64": "Int64", "uint8": "UInt8"}
_BLOCK = 1 << 15


def _encoded(values):
    """One block, or several: their number, size and compressed sizes, and behind them the blocks."""
    content = np.ascontiguousarray(values).astype(values.dtype.newbyteorder("<")).tobytes()
    blocks = [content[first:first + _BLOCK] for first in range(0, len(content), _BLOCK)]
    compressed = [zlib.compress(block) for block in blocks]
    last = len(blocks[-1]) % _BLOCK if blocks else 0
    head = np.array([len(blocks), _BLOCK, last, *map(len, compressed)], dtype="<u4").tobytes()
    return (base64.b64encode(head) + base64.b64encode(b"".join(compressed))).decode("ascii")


def _array(name, values):
    values = np.asarray(values)
    columns = f' NumberOfComponents="{values.shape[1]}"' if values.ndim > 1 else ""
    return (f'<DataArray type="{_NAMES[values.dtype.name]}" Name="{name}"{columns} format="binary">{_encoded(values)}</DataArray>\n')


def text_of_vtu(points, cells, fields):
    """points: (n, 3). cells: [(VTK's number, (m, k))]. fields: {name: (n,) or (n, 3)}."""
    connectivity = np.concatenate([block.ravel() for _, block in cells]).astype(np.int64)
    offsets = np.cumsum(np.concatenate([np.full(len(block), block.shape[1]) for _, block in cells])).astype(np.int64)
    kinds = np.concatenate([np.full(len(block), kind) for kind, block in cells]).astype(np.uint8)
    return "".join((
        '<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="0.1" compressor="vtkZLibDataCompressor" '
        'byte_order="LittleEndian" header_type="UInt32">\n<UnstructuredGrid>\n'
        f'<Piece NumberOfPoints="{len(points)}" NumberOfCells="{len(kinds)}">\n<Points>\n',
        _array("Points", np.asarray(points, dtype=np.float64)), "</Points>\n<Cells>\n", _array("connectivity", connectivity),
        _array("offsets", offsets), _array("types", kinds), "</Cells>\n<PointData>\n",
        *(_array(name, values) for name, values in fields.items()),
        "</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n"))
