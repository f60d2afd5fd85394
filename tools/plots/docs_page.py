# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Pictures and tables of the pages in docs/, as the tools write them with --docs."""
import io
import re

import numpy as np
from PIL import Image


def fitting_dpi(figure, pixels):
    """The resolution that makes so many pixels of the figure, but not more than 120 dots per inch."""
    return min(120, (pixels / np.prod(figure.get_size_inches()))**0.5)


def save_small(figure, path):
    """A picture for the page, with a palette."""
    buffer = io.BytesIO()
    figure.savefig(buffer, dpi=fitting_dpi(figure, 1e6))
    Image.open(buffer).convert("RGB").quantize(256, dither=Image.Dither.NONE).save(path, optimize=True)


def write_tables(tables, page, tool):
    """Puts the tables {name: text} between their markers in the page."""
    text = page.read_text(encoding="utf-8")
    for name, rows in tables.items():
        pattern = rf"(<!-- table {name}[^>]*-->\n).*?(<!-- end {name} -->)"
        text, found = re.subn(pattern, lambda match, rows=rows: match[1] + rows + match[2], text, flags=re.S)
        if found != 1:
            raise SystemExit(f"{tool}: {page.name}: the markers of the table '{name}' stand there {found} times, not "
                             "once")
    page.write_text(text, encoding="utf-8")
    print(f"{tool}: tables of {page}")
