# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The page that tools/report.py makes of a run, read in a real browser (Chromium without a window).

Usage: test_report.py PROGRAM [unittest options]"""
import json
import pathlib
import re
import shutil
import sys
import time

import meshio
import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
from program import main  # noqa: E402
from report_page import CUT_LABELS, Keys, Page, Select, column, table  # noqa: E402
from report_run import COARSE, SCRATCH, report, run  # noqa: E402

SMALL = ["Mesh/Core cells=4", "Mesh/Layers=2", "Load program/Cycles=2", "Output/Volume fields=0",
         "Output/Probes=P: 6.72 6.72; __proto__: 3 -3; -: -6 0; edge_of_the_surface: 9.9 0"]
STATE_COLOURS = [(200, 200, 200), (0, 114, 178), (240, 165, 30)]  # open, stick, slip
WARNING = "<i>beware</i> of </script><script>throw 1</script> & \"quotes\""


class PageTest(Page):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.folder = run('<b>&"x\'<script>', *SMALL)
        cls.decorate(cls.folder)
        cls.rows = table(cls.folder)

    @staticmethod
    def decorate(folder):
        """Warnings with markup, and checks of known values."""
        summary = json.loads((folder / "summary.json").read_text())
        (folder / "summary.json").write_text(json.dumps({**summary, "warnings": [WARNING]}))
        names = "step,equilibrium,penetration,complementarity,friction_cone,slip_rule,work,energy_defect"
        rows = [f"{row['step']},1e-12,0,2e-13,1e-14,3e-12,7,1e-5" for row in table(folder)]
        (folder / "checks.csv").write_text("\n".join([names, *rows, ""]))

    def open(self, folder):
        result = report(folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.read(folder / "report.html")

    # --- a whole run ---

    def test_everything_is_there(self):
        self.open(self.folder)
        self.assert_sections()
        self.assertEqual(self.text("#run-status"), "\u26a0 Complete, with 1 warning")
        self.assertEqual(self.text("ul.warnings li"), WARNING)
        self.assertEqual(self.text("h1"), self.folder.name)
        self.assertEqual(self.browser.title, f"{self.folder.name} \u2013 orthocone report")
        titles = self.script("return [...document.querySelectorAll('section h2')].map(title => title.textContent)")
        self.assertEqual(titles, ["Warnings", "Histories", "Maps of the contact surface", "Hysteresis loops", "Cycles",
                                  "Energies", "Contact solver", "Time", "Model", "Parameters"])
        probes = self.script("return [...document.querySelectorAll('#probe-loops h3')].map(title => title.textContent)")
        self.assertEqual(probes, ["Probe - at (-6, 0) mm", "Probe P at (6.72, 6.72) mm",
                                  "Probe __proto__ at (3, -3) mm", "Probe edge_of_the_surface at (9.9, 0) mm"])
        entries = self.text("#parameters")
        for section in ("Geometry", "Mesh", "Material", "Friction", "Load program", "Contact solver", "Output"):
            self.assertIn(section, entries)

    def test_curves_are_the_table(self):
        self.open(self.folder)
        for title, name in (("Force of the counterface", "force_z"), ("Largest slip", "max_slip"),
                            ("Iterations", "iterations"), ("Motion of the held face", "uz"),
                            ("Dissipation", "total_dissipation"), ("Residual", "residual")):
            with self.subTest(title):
                path = self.chart(title).find_element("css selector", "path.curve").get_attribute("d")
                pixels = np.array(re.findall(r"[ML]([\d.]+),([\d.]+)", path), dtype=float)
                values = column(self.rows, name)
                self.assertEqual(len(pixels), len(self.rows))
                self.assertLess(np.max(np.abs(np.diff(pixels[:, 0], n=2))), 0.02)
                if name == "residual":  # on a logarithmic axis none at all, as of steps without forces, lies at the foot
                    self.assertTrue(np.all(pixels[values == 0, 1] >= pixels[values > 0, 1].max()))
                    values, pixels = np.log10(values[values > 0]), pixels[values > 0]
                    self.assertGreater(len(values), len(self.rows) / 2)
                line = np.polyfit(values, pixels[:, 1], 1)
                self.assertLess(np.max(np.abs(np.polyval(line, values) - pixels[:, 1])), 0.02)
                self.assertLess(line[0], 0)  # up is more

    def test_read_out(self):
        self.open(self.folder)
        svg = self.chart("Largest slip").find_element("css selector", ".chart")
        svg.send_keys(Keys.END)
        text = self.text("#readout")
        self.assertRegex(text, rf"^step {len(self.rows)}\n")
        svg.send_keys(Keys.HOME, *[Keys.ARROW_RIGHT] * 6)
        slip = re.match(r"step 7\nslip: (\S+) mm", self.text("#readout"))
        self.assertAlmostEqual(float(slip[1]) / float(self.rows[6]["max_slip"]), 1, delta=1e-5)

    def test_history_table(self):
        self.open(self.folder)
        self.find("#history-table summary").click()
        time.sleep(0.1)  # the event comes after the click
        cells = self.script("return [...document.querySelectorAll('#history-table tr')].map(row => row.children.length)")
        self.assertEqual(len(cells), len(self.rows) + 1)
        self.assertEqual(len(set(cells)), 1)

    def test_window_of_a_cycle(self):
        self.open(self.folder)
        Select(self.find("#window")).select_by_visible_text("cycle 2 (steps 16\u201330)")
        path = self.chart("Force of the counterface").find_element("css selector", "path.curve").get_attribute("d")
        self.assertEqual(len(re.findall("[ML]", path)), 15)
        self.assert_quiet()

    def test_ledger_and_checks(self):
        self.open(self.folder)
        rows = self.script("return [...document.querySelectorAll('.cycles tbody tr')].map(row => row.innerText)")
        self.assertEqual(len(rows), 2)
        for row, cycle in zip(rows, (self.rows[:15], self.rows[15:])):
            cells = row.split("\t")
            self.assertEqual(float(cells[1]), 105)  # 15 steps of 7 N mm, as the checks have it
            self.assertAlmostEqual(float(cells[2]) / column(cycle, "dissipation").sum(), 1, delta=1e-4)
        self.assertTrue(self.chart("Checks of friction and energy").is_displayed())

    # --- the maps ---

    def assert_legend(self, step):
        row = self.rows[step - 1]
        expected = "".join(f"{name}: {row[f'n_{name}']} nodes" for name in ("open", "stick", "slip"))
        self.assertEqual(self.text("#map-legend"), expected)
        self.assertRegex(self.text("#step-text"), rf"^step {step}, cycle")

    def test_slider(self):
        self.open(self.folder)
        slider = self.find("#step")
        self.go_to(5)
        before = self.picture()
        self.assert_legend(5)
        slider.send_keys(Keys.ARROW_RIGHT)
        self.assert_legend(6)
        self.assertNotEqual(self.picture(), before)
        marks = self.script("return [...document.querySelectorAll('#history-charts .mark')].map(mark => {"
                            "const frame = mark.closest('svg').querySelector('.frame'), of = name => frame.getAttribute(name);"
                            "return ((mark.getAttribute('x1') - of('x')) / of('width')).toFixed(6); })")
        self.assertEqual(len(marks), 7)
        self.assertEqual(len(set(marks)), 1)
        self.find("#forward").click()
        self.assert_legend(7)
        self.find("#play").click()
        time.sleep(1)
        self.find("#play").click()
        self.assertGreater(int(slider.get_attribute("value")), 6)
        self.assert_quiet()

    def test_map_shows_the_field(self):
        """Friction along turned axes has no symmetry that could hide a map that is turned or mirrored."""
        folder = run("turned", *SMALL, "Friction/Orthotropy angle=30", "Load program/Cycles=1",
                     "Load program/Legs=0.02 0.01 -0.05 : 3; -0.01 0 -0.05 : 3")
        self.open(folder)
        for step in (3, 5):
            self.go_to(step)
            file = meshio.read(folder / f"contact-{step:04d}.vtu")
            expected = np.array(STATE_COLOURS)[file.point_data["status"].astype(int)]
            colours = self.map_colours(file.points[:, :2], 10)
            self.assertEqual(set(colours[:, 3]), {255})
            self.assertGreater(np.mean(np.all(colours[:, :3] == expected, axis=1)), 0.98)

    def test_fields(self):
        self.open(self.folder)
        self.go_to(20)  # in the first steps the accumulated slip is the slip
        pictures = {self.picture()}
        field = Select(self.find("#field"))
        for value in ("slip_magnitude", "pressure", "friction_criterion", "accumulated_slip", "dissipated_energy"):
            field.select_by_value(value)
            pictures.add(self.picture())
            if value == "pressure":
                largest = self.script("return document.querySelector('.colour-ends span:last-child').textContent")
                expected = column(self.rows, "max_pressure").max()
                self.assertAlmostEqual(float(largest.split()[0]) / expected, 1, delta=1e-3)
                self.find("#own-scale").click()
                pictures.add(self.picture())
        self.assertEqual(len(pictures), 7)
        self.assert_quiet()

    def test_looks(self):
        self.open(self.folder)
        self.assertEqual(self.script(CUT_LABELS), [])
        self.assert_light_and_dark()
        self.open(self.folder)
        self.assert_phone_and_paper()

    def drawn(self, css):
        """Corners of an area of the drawings."""
        path = self.script("return document.querySelector(arguments[0]).getAttribute('d')", css)
        return np.array(re.findall(r"[\d.]+", path), dtype=float).reshape(-1, 2)

    # --- runs that are not whole, or not like the others ---

    def test_failed_run(self):
        folder = run("failed", *COARSE, "Contact solver/Method=feng2006", "Friction/Slip potential=0.01, 0.3",
                     "Contact solver/Maximum iterations=50", "Load program/Legs=0 0 0 : 1 ; 0 0 -0.1 : 2", code=3)
        self.open(folder)
        self.assertRegex(self.text("#run-status"), "Not complete, 1 of 9 steps: .*load step 2 of 9 .*feng2006")
        self.assert_sections()

    def test_no_step_solved(self):
        folder = run("none", *COARSE, "Contact solver/Method=feng2006", "Contact solver/Maximum iterations=1", code=3)
        self.open(folder)
        self.assertIn("No step was finished", self.text("#histories"))
        self.assertIn("nothing to map", self.text("#no-maps"))

    def test_interrupted_run(self):
        folder = pathlib.Path(SCRATCH.name) / "interrupted"
        shutil.copytree(self.folder, folder)
        (folder / "summary.json").unlink()
        (folder / "checks.csv").unlink()
        (folder / "history.csv").write_text("".join((folder / "history.csv").read_text().splitlines(True)[:8]))
        self.open(folder)
        self.assertRegex(self.text("#run-status"), "Interrupted: summary.json is missing. 7 of 30 steps")
        self.assertTrue(self.find("#no-checks").is_displayed())
        self.assert_sections()

    def test_other_runs(self):
        tangential = ["Load program/Preload=0 0 -0.05 : 2", "Load program/Legs=0.02 0.01 -0.05 : 3; 0 0 -0.05 : 3",
                      "Friction/Orthotropy angle=30", "Load program/Cycles=2", "Output/Probes="]
        for name, maps, settings in (("no_fields", False, ["Output/Contact fields=0"]), ("tangential", True, tangential),
                                     ("cubic", True, ["Mesh/Degree=3", "Mesh/Model=half", "Output/Contact fields=4"]),
                                     ("revolved", True, ["Friction/Coefficients=0.2, 0.2", "Friction/Slip potential=1, 1"]),
                                     ("one_step", True, ["Load program/Legs=0 0 -0.1 : 1", "Load program/Cycles=1"])):
            with self.subTest(name):
                self.open(run(name, *COARSE, *settings))
                self.assert_sections()
                self.assertEqual(self.find("#map").is_displayed(), maps)
                self.assertEqual(self.find("#no-maps").is_displayed(), not maps)
                self.media(**{"prefers-color-scheme": "dark"})
                self.assert_contrast()

    def test_another_scene(self):
        """A box on a cylinder, pressed by a force and pushed by a motion, with friction that varies: half of it is modelled."""
        folder = run("box", *COARSE, "Geometry/Shape=box", "Geometry/Sizes=20, 10, 8", "Mesh/Cells=4, 4, 2",
                     "Obstacle/Gap=y^2/2000", "Friction/Coefficients=0.2 + 0.001*x, 0.1", "Friction/Slip potential=associated",
                     "Load program/Legs=Fz -2e4 : 2 ; ux 0.02 : 2", "Load program/Cycles=1", "Output/Probes=P: 3 2")
        self.open(folder)
        self.assert_sections()
        drawn = self.text("#model")
        for words in ("20 mm x 10 mm", "Box, from the side", "l_x = 20 mm; rigid, with a gap, \u03bc varies", "at the centre",
                      "F_z = \u221220000 N", "u_x = 0.02 mm"):
            self.assertIn(words, drawn)
        corners, whole = self.drawn("#model .modelled"), self.drawn("#model .disc")
        # Symmetric about y = 0 alone: all of x, and the half that is up in the picture.
        self.assertEqual(list(corners.min(axis=0)), list(whole.min(axis=0)))
        self.assertAlmostEqual(np.ptp(corners[:, 1]) / np.ptp(whole[:, 1]), 0.5, 2)
        self.assertEqual(self.find("#map").is_displayed(), True)


def tearDownModule():
    SCRATCH.cleanup()


if __name__ == "__main__":
    main()
