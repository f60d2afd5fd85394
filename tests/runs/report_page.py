# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""A page in Chromium without a window, what the tests ask of it, and the tables it is compared with. Where there is no
such browser, the tests are skipped."""
import csv
import os
import pathlib
import re
import tempfile
import time
import unittest

import numpy as np

try:
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.keys import Keys
    from selenium.webdriver.support.ui import Select
except ImportError:
    webdriver = Keys = Select = None

CHROMIUM, DRIVER = "/usr/bin/chromium", "/usr/bin/chromedriver"
LEAST_CONTRAST = 4.5
CUT_LABELS = """
const inside = (inner, outer) => inner.left >= outer.left - 1 && inner.right <= outer.right + 1
  && inner.top >= outer.top - 1 && inner.bottom <= outer.bottom + 1;
const place = element => element.getBoundingClientRect();
const drawn = [...document.querySelectorAll("svg text")].filter(text => text.getClientRects().length);
// What a chart draws beyond its own box is still seen, but not what is beyond its card.
const frame = text => getComputedStyle(text.ownerSVGElement).overflow === "visible" ? text.closest("section")
                                                                                    : text.ownerSVGElement;
const boxes = [...document.querySelectorAll("button, .key, figcaption, .caption, summary, td, th, .tile dd, .tile dt")]
  .filter(box => box.getClientRects().length && !box.closest(".scroll"));
return [...drawn.filter(text => !inside(place(text), place(frame(text)))),
        ...boxes.filter(box => box.scrollWidth > box.clientWidth + 1 && getComputedStyle(box).display !== "inline")]
  .map(element => `${element.tagName} ${element.className}: ${element.textContent}`);
"""

COLOURS = """
const canvas = document.createElement("canvas");  // a copy: the page's own is not made for being read
canvas.width = canvas.height = 660;
const context = canvas.getContext("2d", {willReadFrequently: true});
context.drawImage(document.getElementById("map"), 0, 0);
const data = context.getImageData(0, 0, 660, 660).data;
return arguments[0].map(([column, row]) => [...data.slice(4 * (660 * row + column), 4 * (660 * row + column) + 4)]);
"""
CONTRASTS = """
const number = text => text.match(/[\\d.]+/g).map(Number);
const light = rgb => rgb.slice(0, 3).map(c => c / 255)
  .map(c => c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4)
  .reduce((sum, c, k) => sum + c * [0.2126, 0.7152, 0.0722][k], 0);
const back = element => {
  const rgb = element ? number(getComputedStyle(element).backgroundColor) : [255, 255, 255];
  return rgb.length < 4 || rgb[3] > 0 ? rgb : back(element.parentElement);
};
const hasText = element => [...element.childNodes].some(node => node.nodeType === 3 && node.textContent.trim());
return [...document.querySelectorAll("body *")]
  .filter(element => hasText(element) && element.getClientRects().length)
  .map(element => {
    const style = getComputedStyle(element);
    const [a, b] = [light(number(element.closest("svg") ? style.fill : style.color)), light(back(element))];
    return [(Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05), element.outerHTML.slice(0, 90)];
  });
"""


def table(folder, name="history.csv"):
    with open(folder / name, encoding="ascii") as file:
        return list(csv.DictReader(file))


def column(rows, name):
    return np.array([float(row[name]) for row in rows])


@unittest.skipIf(webdriver is None, "needs Debian's python3-selenium")
@unittest.skipUnless(os.path.exists(CHROMIUM) and os.path.exists(DRIVER), "needs Debian's chromium and chromium-driver")
class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        profile = tempfile.TemporaryDirectory()
        cls.addClassCleanup(profile.cleanup)
        options = webdriver.ChromeOptions()
        options.binary_location = CHROMIUM
        for word in ("headless=new", "no-sandbox", "disable-gpu", "no-first-run", "disable-background-networking",
                     "disable-component-update", "disable-sync", "window-size=1280,900",
                     f"user-data-dir={profile.name}"):
            options.add_argument(f"--{word}")
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        cls.browser = webdriver.Chrome(service=Service(DRIVER, log_path=os.devnull), options=options)
        cls.addClassCleanup(cls.browser.quit)
        cls.downloads = pathlib.Path(profile.name) / "downloads"
        cls.downloads.mkdir()
        cls.browser.execute_cdp_cmd("Browser.setDownloadBehavior", {"behavior": "allow",
                                                                    "downloadPath": str(cls.downloads)})

    def read(self, file):
        self.media(**{"prefers-color-scheme": "light"})
        self.browser.get(file.resolve().as_uri())
        self.assert_quiet()

    def assert_quiet(self):
        self.assertEqual(self.browser.get_log("browser"), [])
        self.assertEqual(self.script("return performance.getEntriesByType('resource').map(entry => entry.name)"), [])

    def script(self, text, *arguments):
        return self.browser.execute_script(text, *arguments)

    def save(self, menu, kind):
        """The file that the menu of a chart saves; nothing else is in the folder of the browser."""
        for old in self.downloads.iterdir():
            old.unlink()
        self.script("arguments[0].open = true; arguments[0].scrollIntoView({block: 'center'})", menu)
        next(button for button in menu.find_elements("css selector", "button") if button.text == kind).click()
        end = time.monotonic() + 20
        while time.monotonic() < end:
            files = [file for file in self.downloads.iterdir() if file.suffix == f".{kind.lower()}"]
            if files and files[0].stat().st_size:
                return files[0]
            time.sleep(0.05)
        raise AssertionError(f"no {kind} was saved")

    def saved_table(self, menu):
        with open(self.save(menu, "CSV"), encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def menu(self, title):
        return self.chart(title).find_element("css selector", ".save")

    def curves(self, title):
        """Pixels of the curves of a chart, in the order in which they are drawn."""
        paths = self.chart(title).find_elements("css selector", "path.curve")
        pairs = [re.findall(r"[ML]([\d.-]+),([\d.-]+)", path.get_attribute("d")) for path in paths]
        return [np.array(one, dtype=float) for one in pairs]

    def colours(self, title):
        return self.script("return [...arguments[0].querySelectorAll('path.curve')]"
                           ".map(path => getComputedStyle(path).stroke)", self.chart(title))

    def media(self, medium="", **features):
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {
            "media": medium, "features": [{"name": name, "value": value} for name, value in features.items()]
            + [{"name": "prefers-reduced-motion", "value": "reduce"}]})  # clicks need things that stand still

    def text(self, css):
        return self.script("return document.querySelector(arguments[0]).textContent", css)

    def find(self, css):
        return self.browser.find_element("css selector", css)

    def chart(self, title):
        figures = self.browser.find_elements("css selector", "figure")
        return next(figure for figure in figures if figure.text.startswith(title))

    def picture(self):
        return self.script("return document.getElementById('map').toDataURL()")

    def map_colours(self, points, radius):
        """Colours of the map at points of the contact surface (mm), slightly towards the middle."""
        scale = 0.995 * (660 / 2 - 34) / radius
        pixels = np.floor([[330 + scale * x, 330 - scale * y] for x, y in points]).astype(int)
        return np.array(self.script(COLOURS, pixels.tolist()))

    def assert_sections(self):
        sizes = self.script("return [...document.querySelectorAll('section, .chart, .figures svg')]"
                            ".filter(element => !element.closest('figure[hidden]')).map(element => "
                            "[element.getBoundingClientRect().width, element.getBoundingClientRect().height])")
        self.assertGreater(len(sizes), 9)
        self.assertGreater(np.min(sizes), 20)

    def assert_contrast(self):
        found = self.script(CONTRASTS)
        self.assertGreater(len(found), 200)
        self.assertEqual([entry for entry in found if entry[0] < LEAST_CONTRAST], [])
        return self.script("return getComputedStyle(document.body).backgroundColor")

    def assert_light_and_dark(self):
        light = self.assert_contrast()
        self.media(**{"prefers-color-scheme": "dark"})
        dark = self.assert_contrast()
        self.assertNotEqual(light, dark)
        self.find("#theme").click()
        self.assertEqual(self.assert_contrast(), light)
        self.find("#theme").click()
        self.script("dispatchEvent(new Event('beforeprint'))")
        self.assertEqual(self.assert_contrast(), light)

    def assert_phone_and_paper(self):
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                                     {"width": 390, "height": 800, "deviceScaleFactor": 1, "mobile": True})
        self.assertLessEqual(self.script("return document.documentElement.scrollWidth"), 390)
        self.assert_sections()
        self.assertEqual(self.script(CUT_LABELS), [])
        self.browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
        self.media("print")
        self.assert_sections()
        self.assertFalse(self.find("nav").is_displayed())

    def go_to(self, step):
        self.script("const slider = document.getElementById('step'); slider.value = arguments[0];"
                    "slider.dispatchEvent(new Event('input'))", step - 1)
