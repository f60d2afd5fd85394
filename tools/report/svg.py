# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Elements of SVG as text; colours and fonts are those of the style sheet, by class."""
import html
import math


def number(value):
    return f"{value:.2f}".rstrip("0").rstrip(".")


def signed(value):
    return f"{value:g}".replace("-", "\u2212")


def element(name, content="", **attributes):
    """Underscores in attribute names stand for hyphens; `css` is the class."""
    words = []
    for key, value in attributes.items():
        key = "class" if key == "css" else key.replace("_", "-")
        words.append(f' {key}="{number(value) if isinstance(value, (int, float)) else html.escape(value)}"')
    return f"<{name}{''.join(words)}>{content}</{name}>"


def line(start, end, css, **more):
    return element("line", x1=start[0], y1=start[1], x2=end[0], y2=end[1], css=css, **more)


def polyline(points, css, closed=False):
    return element("polygon" if closed else "polyline", points=" ".join(f"{number(x)},{number(y)}" for x, y in points),
                   css=css)


def text(place, words, css="", anchor="middle"):
    return element("text", html.escape(words), x=place[0], y=place[1], css=css, text_anchor=anchor)


def arrow(start, end, css, head=7):
    """A line with a head, as long as the head is not longer than the line."""
    length = math.hypot(end[0] - start[0], end[1] - start[1])
    if length == 0:
        return ""
    ux, uy = (end[0] - start[0]) / length, (end[1] - start[1]) / length
    neck = (end[0] - head * ux, end[1] - head * uy)
    wing = 0.4 * head
    tip = [end, (neck[0] - wing * uy, neck[1] + wing * ux), (neck[0] + wing * uy, neck[1] - wing * ux)]
    return line(start, neck, css) + polyline(tip, css + " head", closed=True)


def picture(width, height, content, label):
    return element("svg", element("title", html.escape(label)) + content, viewBox=f"0 0 {width} {height}", role="img",
                   aria_label=label)
