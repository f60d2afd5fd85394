# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Debian's furo is made for a web server. It is mended in its copies in the site, so that pages work as files. Browsers
refuse modules from files: its script imports one, and is one in Debian 13. Its style sheet may import one from a folder of
the server. And it leaves out that a browser that asks for dark pages gets them."""
import pathlib
import re

SHARED = pathlib.Path("/usr/share/javascript")
MODULE = re.compile(r'^import (?:\* as )?Gumshoe from "\./([\w.-]+)";\n', re.M)
SHEET = re.compile(r"^@import url\(/javascript/([\w./-]+)\);\n", re.M)
DARK = re.compile(r'^ *body\[data-theme="dark"\] (\{\s*--[^}]*\})', re.M)
ASKS_FOR_DARK = re.compile(r"body:not\(\[data-theme=\"?light\"?\]\)")


def mended_script(file):
    text = file.read_text(encoding="utf-8")
    imported = "".join((file.parent / name).read_text(encoding="utf-8") for name in MODULE.findall(text))
    return imported + MODULE.sub("", text)


def mended_sheet(file):
    text = SHEET.sub(lambda match: (SHARED / match[1]).read_text(encoding="utf-8"), file.read_text(encoding="utf-8"))
    if ASKS_FOR_DARK.search(text):
        return text
    dark = '\n  body:not([data-theme="light"]) '.join(["", *DARK.findall(text)])
    return text + f"@media screen and (prefers-color-scheme: dark) {{{dark}\n}}\n"


def mend(html):
    for name, mended in (("scripts/furo.js", mended_script), ("styles/furo.css", mended_sheet)):
        file = html / "_static" / name
        file.write_text(mended(file), encoding="utf-8")
    for file in html.rglob("*.html"):
        text = file.read_text(encoding="utf-8")
        file.write_text(text.replace('<script type="module"', "<script"), encoding="utf-8")
