# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The site of tools/docs: every page is there, every link leads somewhere, nothing comes from a network, the index of the
search knows the words of the pages, and a browser shows all of it, on a phone, too.

Usage: test_site.py PROGRAM [unittest options]"""
import json
import pathlib
import re
import sys
import tempfile
import time
import unittest
import urllib.parse

sys.dont_write_bytecode = True  # the source tree stays clean
from program import ROOT, main  # noqa: E402
from report_page import Page  # noqa: E402
from site_pages import Site, build  # noqa: E402

LIBRARIES = ("base", "body", "contact", "entries", "surface")
NO_MODULE = "No module named '(sphinx|myst_parser|furo|breathe)"
BACKGROUND = "return getComputedStyle(document.querySelector(arguments[0])).backgroundColor"
WIDE_TABLES = ("return [...document.querySelectorAll('article table')].filter(table => !table.closest('.table-wrapper')"
               " && table.getBoundingClientRect().right > 391).length")
SITE = None


def setUpModule():
    global SITE
    SITE = Site()
    if re.search(NO_MODULE, SITE.result.stderr):
        raise unittest.SkipTest("needs Debian's python3-sphinx, python3-myst-parser, furo and python3-breathe")


def is_remote(link):
    return bool(urllib.parse.urlsplit(link).scheme or urllib.parse.urlsplit(link).netloc)


def words(text):
    return set(re.findall(r"[A-Za-z]{4,}", text))


class SiteTest(unittest.TestCase):
    def test_no_warnings(self):
        self.assertEqual(SITE.result.returncode, 0, SITE.result.stderr)
        self.assertRegex(SITE.result.stderr, r"^docs: .*index\.html\n$")

    def test_every_page_is_there(self):
        names = {path.stem for path in ROOT.glob("*.md")} - {"README"} | {f"docs/{path.stem}"
                                                                          for path in (ROOT / "docs").glob("*.md")}
        names |= {"index", "gallery", "search", "genindex", "api/index", *(f"api/{name}" for name in LIBRARIES)}
        self.assertEqual({f"{name}.html" for name in names} - set(SITE.pages), set())
        menu = {SITE.target("index.html", link)[0] for link in SITE.pages["index.html"].links if not is_remote(link)}
        self.assertEqual({f"{name}.html" for name in names} - menu - {"search.html", "genindex.html"}, set())

    def test_pages_have_the_words_of_ours(self):
        for path in [ROOT / "README.md", *(ROOT / "docs").glob("*.md")]:
            # Links whose text is a page's name show its title.
            text = re.sub(r"<!--.*?-->|\[[\w./]+\.md\]\([^)]*\)|\]\([^)]*\)", " ", path.read_text(encoding="utf-8"), flags=re.S)
            name = "index" if path.stem == "README" else f"docs/{path.stem}"
            with self.subTest(path.name):
                self.assertEqual(words(text) - words(SITE.pages[f"{name}.html"].words()), set())

    def test_links_lead_somewhere(self):
        count = 0
        for name, page in SITE.pages.items():
            for link in {link for link in [*page.links, *page.loaded] if link and not is_remote(link)}:
                count += 1
                with self.subTest(page=name, link=link):
                    self.assertTrue(SITE.leads_somewhere(name, link))
        self.assertGreater(count, 2000)

    def test_nothing_is_loaded_from_elsewhere(self):
        for name, page in SITE.pages.items():
            with self.subTest(name):
                self.assertEqual([link for link in page.loaded if is_remote(link)], [])
                others = [link for link in page.links if link and is_remote(link)]
                self.assertEqual([link for link in others if not re.match("https?:", link)], [])
        for sheet, link in SITE.sheets():
            with self.subTest(sheet=sheet, link=link):
                self.assertFalse(is_remote(link))
                self.assertTrue(SITE.leads_somewhere(sheet, link))

    def test_search_knows_the_words(self):
        index = (SITE.folder / "searchindex.js").read_text(encoding="utf-8")
        index = json.loads(index[index.index("(") + 1:index.rindex(")")])
        for word, page in (("uzawa", "docs/theory"), ("mindlin", "docs/verification"), ("archard", "docs/parameters")):
            numbers = index["terms"][word]
            self.assertIn(page, [index["docnames"][k] for k in (numbers if isinstance(numbers, list) else [numbers])])

    def test_headers_are_described(self):
        for library in LIBRARIES:
            text = SITE.pages[f"api/{library}.html"].words()
            for file in (ROOT / "include/orthocone" / library).rglob("*.h"):
                with self.subTest(file.name):
                    self.assertIn(f"#include <orthocone/{library}/{file.relative_to(ROOT / 'include/orthocone' / library)}>",
                                  re.sub("< ", "<", text))

    def test_functions_are_described(self):
        page = SITE.pages["api/contact.html"]
        self.assertRegex(page.words(), r"project.{0,40}\( const OrthotropicFriction & law , const Eigen :: Vector3d & tau \)"
                                       r".{0,20}Nearest point of the cone K = { r : \|\|r_t\|\|_m <= r_n },")
        self.assertTrue(any("orthocone7project" in place for place in page.places))
        for name, library in (("OrthotropicFriction", "contact"), ("make_contact_solver", "contact"), ("moved_by", "surface"),
                              ("FactorizedBody", "body"), ("read_entries", "entries"), ("InputError", "base")):
            with self.subTest(name):
                self.assertTrue(any(re.search(rf"orthocone\d+{name}", place)
                                    for place in SITE.pages[f"api/{library}.html"].places))

    def test_gallery_has_every_picture(self):
        pictures = SITE.pages["gallery.html"].pictures
        files = {path.name for path in (ROOT / "docs/images").glob("*.png")}
        self.assertEqual({pathlib.Path(source).name for _, source in pictures}, files)
        for link, source in pictures:
            path, place = SITE.target("gallery.html", link)
            with self.subTest(source):
                self.assertTrue(place)
                shown = [pathlib.Path(other).name for _, other in SITE.pages[path].pictures]
                self.assertIn(pathlib.Path(source).name, shown)

    def test_folders_of_others_are_left_alone(self):
        with tempfile.TemporaryDirectory() as name:
            file = pathlib.Path(name) / "thesis.txt"
            file.write_text("mine")
            result = build(name)
            self.assertEqual((result.returncode, file.read_text()), (1, "mine"))
            self.assertRegex(result.stderr, r"^docs: .* stays as it is\n$")


class BrowserTest(Page):
    def go(self, page, width, scheme):
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                                     {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": width < 500})
        self.media(**{"prefers-color-scheme": scheme})
        self.browser.get((SITE.folder / page).as_uri())
        errors = [entry for entry in self.browser.get_log("browser") if entry["level"] in ("SEVERE", "ERROR")]
        self.assertEqual(errors, [])

    def test_pages_fit_a_phone(self):
        for page in sorted(SITE.pages):
            with self.subTest(page):
                self.go(page, 390, "light")
                self.assertLessEqual(self.script("return document.documentElement.scrollWidth"), 390)
                self.assertEqual(self.script(WIDE_TABLES), 0)

    def test_light_and_dark(self):
        self.go("docs/stability.html", 1400, "light")
        light = self.script(BACKGROUND, "body")
        self.go("docs/stability.html", 1400, "dark")
        self.assertNotEqual(self.script(BACKGROUND, "body"), light)
        self.assertEqual(self.script(BACKGROUND, "article img"), "rgb(255, 255, 255)")
        next(one for one in self.browser.find_elements("css selector", ".theme-toggle") if one.is_displayed()).click()
        self.assertEqual(self.script(BACKGROUND, "body"), light)

    def test_search_finds(self):
        self.browser.get((SITE.folder / "search.html").as_uri() + "?q=Uzawa")
        end = time.monotonic() + 20
        while "finished" not in self.text("#search-results") and time.monotonic() < end:
            time.sleep(0.05)
        links = self.script("return [...document.querySelectorAll('#search-results li a')].map(link => link.href)")
        self.assertTrue(any("docs/theory.html" in link for link in links), self.text("#search-results"))


if __name__ == "__main__":
    main()
