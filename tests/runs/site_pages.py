# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The site of tools/docs in a scratch folder, and its pages as they were written: what they link to, show and load."""
import html.parser
import pathlib
import re
import subprocess
import sys
import tempfile
import urllib.parse

from program import ROOT

SCRATCH = tempfile.TemporaryDirectory()


def build(output):
    return subprocess.run([sys.executable, ROOT / "tools/site/docs.py", "--output", output], capture_output=True, text=True,
                          timeout=600, check=False)


class HtmlPage(html.parser.HTMLParser):
    """links: targets of <a>. loaded: what a browser fetches. places: all ids. pictures: (what a picture leads to, file).
    text: pieces of it, and what pictures show."""

    def __init__(self, file):
        super().__init__()
        self.links, self.loaded, self.places, self.pictures = [], [], set(), []
        self.text, self.link = [], None
        self.feed(file.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.places.update(values[name] for name in ("id", "name") if values.get(name))
        if tag == "a":
            self.link = values.get("href")
            self.links.append(self.link)
        elif tag == "img":
            self.pictures.append((self.link, values["src"]))
            self.text.append(values["alt"])
        if tag != "a":
            self.loaded += [values[name] for name in ("href", "src", "srcset", "data", "poster") if values.get(name)]

    def handle_endtag(self, tag):
        if tag == "a":
            self.link = None

    def handle_data(self, data):
        self.text.append(data)

    def words(self):
        return " ".join(" ".join(self.text).split())


class Site:
    """What tools/docs wrote, and all of its pages by their paths."""

    def __init__(self):
        self.folder = pathlib.Path(SCRATCH.name) / "site"
        self.result = build(self.folder)
        self.pages = {str(file.relative_to(self.folder)): HtmlPage(file) for file in self.folder.rglob("*.html")}

    def target(self, page, link):
        """(path in the site, place in it) that a relative link leads to."""
        parts = urllib.parse.urlsplit(link)
        path = (self.folder / page).parent / urllib.parse.unquote(parts.path) if parts.path else self.folder / page
        return str(path.resolve().relative_to(self.folder.resolve())), urllib.parse.unquote(parts.fragment)

    def leads_somewhere(self, page, link):
        path, place = self.target(page, link)
        return (self.folder / path).is_file() and (not place or path not in self.pages or place in self.pages[path].places)

    def sheets(self):
        """(file, what it loads) of all style sheets; not what they hold themselves."""
        for file in self.folder.rglob("*.css"):
            text = re.sub(r"/\*.*?\*/", "", file.read_text(encoding="utf-8"), flags=re.S)
            found = re.findall(r"url\(\s*[\"']?([^\"')]+)|@import\s+[\"']([^\"']+)", text)
            yield from ((str(file.relative_to(self.folder)), one or other) for one, other in found
                        if not one.startswith(("data:", "#")))
