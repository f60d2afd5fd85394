# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Elements and tables of HTML, for the pages that the tools make."""
import html


def escape(words):
    return html.escape(str(words), quote=True)


def element(name, content, css="", more=""):
    css = f' class="{css}"' if css else ""
    return f"<{name}{css}{more}>{content}</{name}>"


def table(head, rows, css=""):
    """Text cells; the first column names the row."""
    top = element("tr", "".join(element("th", escape(words), more=' scope="col"') for words in head)) if head else ""
    body = "".join(element("tr", element("th", escape(row[0]), more=' scope="row"')
                           + "".join(element("td", escape(words)) for words in row[1:])) for row in rows)
    return element("div", element("table", (element("thead", top) if top else "") + element("tbody", body), css),
                   "scroll")
