# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Charts of a fretting scene on the page of tools/report.py: loops, cycles, lines through the contact surface, several
runs, and what is saved of them. Read in a real browser (Chromium without a window).

Usage: test_report_charts.py PROGRAM [unittest options]"""
import re
import sys
import xml.etree.ElementTree

import meshio
import numpy as np
from matplotlib.image import imread

sys.dont_write_bytecode = True  # the source tree stays clean
from program import main  # noqa: E402
from report_page import CUT_LABELS, Page, Select, column, table  # noqa: E402
from report_run import COARSE, SCRATCH, report, run  # noqa: E402

FRETTING = [*COARSE, "Mesh/Core cells=4", "Load program/Preload=0 0 -0.05 : 5", "Load program/Cycles=4",
            "Load program/Legs=0.01 0 -0.05 : 10; -0.01 0 -0.05 : 20; 0 0 -0.05 : 10"]
JUMPING = [*FRETTING, "Mesh/Core cells=2", "Load program/Cycles=100", "Load program/Jump when periodic=1e-5",
           "Load program/Jump cycles=20", "Output/Contact fields=0"]
BOX = (318, 182)  # of the curves, in pixels of the drawing
BEYOND_THE_PICTURE = """
const picture = new DOMParser().parseFromString(arguments[0], "image/svg+xml").documentElement;
const host = document.createElement("div");
host.attachShadow({mode: "open"}).append(picture);  // where the styles of the page do not reach
document.body.append(host);
const whole = picture.getBoundingClientRect();
const cut = [...picture.querySelectorAll("text")].filter(text => {
  const place = text.getBoundingClientRect(), room = (whole.right - whole.left) / 400 / 2;
  return place.left < whole.left - room || place.right > whole.right + room || place.bottom > whole.bottom + room;
}).map(text => text.textContent);
host.remove();
return cut;
"""
LOOP = "Q_x over u_x, without the elastic part"
WHOLE_LOOP = "Fretting loop: Q_x over u_x"


def area(points):
    x, y = np.transpose(points)
    return abs(np.sum(x * np.roll(y, 1) - y * np.roll(x, 1))) / 2


class ChartsTest(Page):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.folder = run("fretting", *FRETTING)
        cls.rows = table(cls.folder)
        cls.cycles = table(cls.folder, "cycles.csv")

    def open(self, *folders):
        result = report(*folders)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.read(folders[0] / "report.html")

    def test_rotations_and_moments(self):
        """A twist by a motion, then by its moment; what is only pressed has no such charts."""
        folder = run("twisted", *COARSE, "Load program/Legs=uz -0.05 : 2 ; rz 0.05 : 4 ; Mz 0 : 4",
                     "Load program/Cycles=1")
        self.open(folder)
        rows = table(folder)
        for title, name in (("Rotation of the held face", "rz"), ("Moment of the counterface", "moment_z")):
            path = self.chart(title).find_element("css selector", "path.curve").get_attribute("d")
            pixels = np.array(re.findall(r"[ML]([\d.]+),([\d.]+)", path), dtype=float)
            values = column(rows, name)
            self.assertEqual(len(pixels), len(rows))
            self.assertGreater(np.abs(values).max(), 0)
            line = np.polyfit(values, pixels[:, 1], 1)
            self.assertLess(np.max(np.abs(np.polyval(line, values) - pixels[:, 1])), 0.02, title)
        self.assertTrue(self.chart("Fretting loop: M_z over r_z").find_elements("css selector", "path.curve"))
        self.assert_quiet()
        self.open(run("pressed", *COARSE, "Load program/Cycles=1"))
        titles = self.script("return [...document.querySelectorAll('figcaption')].map(title => title.textContent)")
        self.assertFalse([title for title in titles if "Moment" in title or "Rotation" in title], titles)

    # --- loops ---

    def test_loop_is_open_and_its_area_is_the_work(self):
        self.open(self.folder)
        saved = self.saved_table(self.menu(LOOP))
        self.assertEqual(len(saved), 165)
        for cycle in range(4):
            part = saved[4 + 40 * cycle:45 + 40 * cycle]
            motion, force = column(part, "u_x (mm)"), column(part, "Q_x \u2212 line (N)")
            work = np.sum((force[1:] + force[:-1]) / 2 * np.diff(motion))  # of the top, against the plane
            self.assertAlmostEqual(work / float(self.cycles[cycle]["work"]), 1, delta=1e-3)
        Select(self.find("#window")).select_by_visible_text("cycle 4 (steps 126\u2013165)")
        drawn = {title: area(np.concatenate(self.curves(title))) / np.prod(BOX) for title in (LOOP, WHOLE_LOOP)}
        self.assertGreater(drawn[LOOP], 0.1)
        self.assertLess(drawn[WHOLE_LOOP], 0.01)  # why the other chart is there

    def test_line_that_is_taken_away(self):
        self.open(self.folder)
        motion, force = column(self.rows[125:], "ux"), -column(self.rows[125:], "force_x")
        stiffness = np.sum((motion - motion.mean()) * (force - force.mean())) / np.sum((motion - motion.mean())**2)
        caption = self.chart(LOOP).find_element("css selector", ".caption").text
        self.assertRegex(caption, r"\(cycle 4\)")
        number = caption.split("Q_x = ")[1].split(" N/mm")[0].replace("\u2212", "-")
        self.assertAlmostEqual(float(number) / stiffness, 1, delta=1e-4)
        titles = [self.script("return [...document.querySelectorAll(`${arguments[0]} figcaption`)]"
                              ".map(caption => caption.firstChild.data)", grid)
                  for grid in ("#fretting-loops", "#body-loops")]
        # In the cycles u_z rests, so that there is no loop to see.
        self.assertEqual(titles, [[WHOLE_LOOP, LOOP], ["F_z over u_z of the held face"]])

    def test_fretting_loop_is_the_first_picture(self):
        self.open(self.folder)
        first = self.script("return document.querySelector('main svg:not(.key svg)').closest('figure')")
        self.assertEqual(first.get_attribute("outerHTML"), self.chart(WHOLE_LOOP).get_attribute("outerHTML"))
        caption = first.find_element("css selector", ".caption").text
        area = re.fullmatch(r"Area of the loop: (\S+) N mm in steps 125\u2013165, the work of Q_x alone; all components do "
                            r"(\S+) N mm of work there, and friction dissipates (\S+) N mm\.", caption)
        for number, name in zip(area.groups(), ("work", "work", "dissipation")):
            self.assertAlmostEqual(float(number) / float(self.cycles[-1][name]), 1, delta=1e-3)

    def test_energies_of_a_cycle_sum_up(self):
        self.open(self.folder)
        self.assertEqual(self.text(".sums thead th:nth-child(2)"), "cycle 4, steps 126\u2013165")
        rows = dict(self.script("return [...document.querySelectorAll('.sums tbody tr')].map(row => "
                                "[row.cells[0].textContent, row.cells[1].textContent.replace('\u2212', '-')])"))
        numbers = {name.lstrip("=\u2212 "): float(number) for name, number in rows.items()}
        for name, column_name in (("work of all components", "work"), ("dissipated by friction", "dissipation")):
            self.assertAlmostEqual(numbers[name] / float(self.cycles[-1][column_name]), 1, delta=1e-4)
        alone = sum(number for name, number in numbers.items() if " alone" in name or name == "correction")
        self.assertAlmostEqual(alone / numbers["work of all components"], 1, delta=1e-3)
        left = numbers["work of all components"] - numbers["dissipated by friction"] - numbers["change of elastic energy"]
        self.assertAlmostEqual(left, numbers["rest"], delta=1e-3 * numbers["work of all components"])

    def test_loops_of_every_driven_component(self):
        folder = run("three_ways", *COARSE, "Load program/Preload=", "Load program/Cycles=2",
                     "Load program/Legs=0.01 0.005 -0.05 : 4; -0.01 0 -0.03 : 4; 0 0 -0.05 : 4")
        self.open(folder)
        for name, of in (("Q_x", "u_x"), ("Q_y", "u_y"), ("F_z", "u_z")):
            self.assertTrue(self.chart(f"{name} over {of}, without the elastic part").is_displayed())

    def test_moment_over_rotation(self):
        """Two turns to and fro, of which the second is a closed loop: its area is the work of the top."""
        folder = run("turned", *COARSE, "Friction/Coefficients=0.1, 0.1", "Load program/Preload=uz -0.05 : 2",
                     "Load program/Legs=rz 0.1 : 8; rz -0.1 : 16; rz 0 : 8", "Load program/Cycles=2")
        self.open(folder)
        title, cycle = "Fretting loop: M_z over r_z", table(folder, "cycles.csv")[-1]
        caption = self.chart(title).find_element("css selector", ".caption").text
        self.assertAlmostEqual(float(caption.split()[4]) / float(cycle["work"]), 1, delta=2e-3)
        saved = self.saved_table(self.menu(title))
        np.testing.assert_allclose(column(saved, "M_z (N mm)"), -column(table(folder), "moment_z"), rtol=1e-6, atol=1e-3)

    def test_cycles_have_colours_from_first_to_last(self):
        self.open(self.folder)
        ends = self.script("return ['first', 'last'].map(end => { const e = document.createElement('i');"
                           "e.style.color = `var(--cycle-${end})`; document.body.append(e);"
                           "return getComputedStyle(e).color.match(/[0-9]+/g).map(Number); })")
        colours = [[round(255 * float(part)) for part in colour[11:-1].split()] for colour in self.colours(LOOP)[1:]]
        self.assertEqual((len(colours), colours[0], colours[-1]), (4, *ends))
        self.assertEqual(len(set(map(tuple, colours))), 4)
        self.assertEqual(self.chart(LOOP).find_element("css selector", ".keys").text.split(),
                         ["preload", "cycle", "1", "4"])

    # --- cycles ---

    def test_cycles_are_the_table(self):
        self.open(self.folder)
        saved = self.saved_table(self.menu("Slip since the start"))
        for name, expected in (("largest slip (mm)", "max_slip"),
                               ("largest accumulated slip (mm)", "max_accumulated_slip")):
            np.testing.assert_allclose(column(saved, name), column(self.cycles, expected), rtol=1e-6)
        pixels = self.curves("Change of the state in a cycle")[0]
        values = np.log10(column(self.cycles, "change"))
        line = np.polyfit(values, pixels[:, 1], 1)
        self.assertLess(np.max(np.abs(np.polyval(line, values) - pixels[:, 1])), 0.02)

    def test_jumped_cycles(self):
        folder = run("jumping", *JUMPING)
        self.open(folder)
        cycles, solved = table(folder, "cycles.csv"), {row["step"] for row in table(folder)}
        jumped = np.array([row["last_step"] not in solved for row in cycles])
        self.assertGreater(jumped.sum(), 2)
        energy = self.chart("Energy of a cycle")
        self.assertEqual(len(energy.find_elements("css selector", ".band")), jumped.sum())
        self.assertEqual(len(energy.find_elements("css selector", ".hollow")), 2 * jumped.sum())
        saved = self.saved_table(self.menu("Energy of a cycle"))
        np.testing.assert_allclose(column(saved, "dissipated by friction (N mm)"),
                                   column(cycles, "dissipation") / column(cycles, "n_cycles"), rtol=1e-6)
        self.assertTrue(self.find("#jumped-hint").is_displayed())
        self.assertEqual(len(self.colours(LOOP)), 1 + (~jumped).sum())  # the preload and every computed cycle
        steps = self.chart("Force of the counterface").find_element("css selector", "path.curve").get_attribute("d")
        self.assertEqual(steps.count("M"), 1 + jumped.sum())
        # The ledger has every computed cycle, whatever its number.
        self.assertIn("cycle 100 (steps 3966\u20134005)", self.text(".cycles"))
        ledger = self.saved_table(self.menu("Energies since the start"))
        total = float(table(folder)[-1]["total_dissipation"])
        self.assertAlmostEqual(float(ledger[-1]["dissipated by friction (N mm)"]) / total, 1, delta=1e-6)
        cells = self.script("return [...document.querySelectorAll('.jumps tbody tr')].pop().innerText").split("\t")
        of_steps = column(table(folder), "dissipation").sum()
        for cell, value in zip(cells[1:], (of_steps, total - of_steps, total), strict=True):
            self.assertAlmostEqual(float(cell) / value, 1, delta=1e-4)

    # --- small maps, lines ---

    def test_small_maps_are_those_where_the_load_turns(self):
        self.open(self.folder)
        words = self.script("return [...document.querySelectorAll('#thumbs button')].map(button => button.textContent)")
        steps = [int(word.split()[1]) for word in words]
        self.assertEqual(steps, [1, 5, *(45 + 40 * cycle + turn for cycle in range(4) for turn in (-30, -10, 0))])
        buttons = self.browser.find_elements("css selector", "#thumbs button")
        buttons[-1].click()
        self.assertRegex(self.text("#step-text"), "^step 165, cycle 4")
        buttons[0].click()
        self.assertRegex(self.text("#step-text"), "^step 1, preload")

    def test_tractions_along_a_line(self):
        """Turned ellipses and an oblique motion have no symmetry that could hide a line that is turned or mirrored."""
        folder = run("oblique", *COARSE, "Mesh/Core cells=4", "Friction/Orthotropy angle=30", "Load program/Cycles=1",
                     "Load program/Legs=0.02 0.01 -0.05 : 3; -0.01 0 -0.05 : 3")
        self.open(folder)
        for axis, along in enumerate("xy"):
            Select(self.find("#line")).select_by_value(str(axis))
            for step in (3, 5):
                self.go_to(step)
                file = meshio.read(folder / f"contact-{step:04d}.vtu")
                on = np.flatnonzero(np.abs(file.points[:, 1 - axis]) < 1e-4)
                place, one = np.unique(np.round(file.points[on, axis], 4), return_index=True)
                on = on[one]
                self.assert_line(f"Pressure along {along}, step {step}", place, {"pressure (MPa)":
                                                                               file.point_data["pressure"][on]})
                friction = file.point_data["friction_traction"][on]
                saved = self.assert_line(f"Friction traction along {along}, step {step}", place,
                                         {"q_x (MPa)": friction[:, 0], "q_y (MPa)": friction[:, 1]})
                self.assert_limit(saved, place, file.point_data["friction_criterion"][on])
                touches = file.point_data["status"][on] > 0  # an open node has no slip
                self.assert_line(f"Slip along {along}, step {step}", place[touches],
                                 {"slip_x (mm)": file.point_data["slip"][on, 0][touches],
                                  "slip_y (mm)": file.point_data["slip"][on, 1][touches]})

    def assert_line(self, title, place, expected):
        saved = [row for row in self.saved_table(self.menu(title)) if row[list(expected)[0]]]
        at = column(saved, next(iter(saved[0])))
        self.assertGreaterEqual(len(place), 5)
        for name, values in expected.items():
            scale = np.max(np.abs(values)) or 1
            np.testing.assert_allclose(np.interp(place, at, column(saved, name)), values, atol=1e-4 * scale)
        return saved

    def assert_limit(self, saved, place, criterion):
        """Below the limit where a node sticks by as much as the field of the program says, at it where it slips."""
        saved = [row for row in saved if row["limit: \u03bc p along q (MPa)"]]  # none without a direction
        at = column(saved, next(iter(saved[0])))
        share = column(saved, "size |q| (MPa)") / column(saved, "limit: \u03bc p along q (MPa)")
        known = np.min(np.abs(place[:, None] - at), axis=1) < 1e-3
        self.assertGreaterEqual(known.sum(), 5)
        np.testing.assert_allclose(np.interp(place, at, share)[known] - 1, criterion[known], atol=2e-3)

    # --- several runs ---

    def test_runs_over_each_other(self):
        other = run("elsewhere/fretting", *FRETTING, "Load program/Cycles=2", "Friction/Coefficients=0.1, 0.1",
                    "Load program/Legs=0.008 0.004 -0.05 : 6; 0 0 -0.05 : 6", "Output/Contact fields=0")
        self.open(self.folder, other)
        names = self.script("return [...document.querySelectorAll('#runs li')].map(item => item.textContent)")
        self.assertEqual(names, [f"{SCRATCH.name.split('/')[-1]}/fretting", "elsewhere/fretting"])
        for title, paths in (("Largest slip", 4), (LOOP, 2), ("Change of the state in a cycle", 2)):
            with self.subTest(title):
                self.assertEqual((len(self.colours(title)), len(set(self.colours(title)))), (paths, 2))
                keys = self.chart(title).find_element("css selector", ".keys").text
                self.assertIn(names[0], keys)
                self.assertIn(names[1], keys)
        saved = self.saved_table(self.menu("Dissipation"))
        drawn = [row[f"since the start, {names[1]} (N mm)"] for row in saved]
        expected = column(table(other), "total_dissipation")
        np.testing.assert_allclose([float(value) for value in drawn if value], expected, rtol=1e-6)
        self.assertEqual(len(drawn), 165)
        self.assertEqual(self.text("h1"), "fretting")
        self.assert_phone_and_paper()

    # --- files ---

    def test_saved_pictures_stand_alone(self):
        self.open(self.folder)
        self.media(**{"prefers-color-scheme": "dark"})
        for title, menu in ((LOOP, self.menu(LOOP)), ("Energy of a cycle", self.menu("Energy of a cycle")),
                            ("status: open, stick, slip", self.find("#map-save .save"))):
            with self.subTest(title):
                file = self.save(menu, "SVG")
                self.assertTrue(file.name.startswith("fretting-"), file.name)
                text = file.read_text(encoding="utf-8")
                for word in ("var(", "color-mix", "color(", "class=", "style="):
                    self.assertNotIn(word, text)
                words = [element for element in xml.etree.ElementTree.fromstring(text).iter() if element.text]
                self.assertIn(title, [element.text for element in words])
                for element in words:  # dark on white, whatever the page looks like
                    self.assertLess(max(map(int, re.findall(r"\d+", element.get("fill")))), 128, element.text)
                self.assertEqual(self.script(BEYOND_THE_PICTURE, text), [])
                picture = imread(self.save(menu, "PNG"))[..., :3]
                self.assertEqual(picture.shape[1], 1200)
                self.assertEqual(picture[0, 0].tolist(), [1, 1, 1])
                self.assertTrue(0.01 < np.mean(np.any(picture < 0.9, axis=2)) < 0.8)
        self.assert_quiet()

    def test_no_label_is_cut(self):
        probes = f"edge: 9.9 0; {'a' * 60}: -9.9 0; {'b' * 60}: 9.9 0.1; top: 0 9.9; bottom_of_it: 0 -9.9"
        self.open(run("labels", *FRETTING, "Load program/Cycles=1", "Output/Contact fields=5", f"Output/Probes={probes}"))
        self.assertEqual(self.script(CUT_LABELS), [])
        self.assert_phone_and_paper()


def tearDownModule():
    SCRATCH.cleanup()


if __name__ == "__main__":
    main()
