# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What the page of tools/report.py shows along lines of the body. Read in a real browser (Chromium without a window).

Usage: test_report_lines.py PROGRAM [unittest options]"""
import shutil
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
from program import main  # noqa: E402
from report_page import Page, column, table  # noqa: E402
from report_run import COARSE, SCRATCH, report, run  # noqa: E402

LINES = [*COARSE, "Load program/Cycles=1",
         "Output/Lines=axis: 0 0 0 to 0 0 8, 17; across: -10 0 0 to 10 0 0, 21", "Output/Line fields=5"]


class LinesTest(Page):
    def open(self, folder):
        result = report(folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.read(folder / "report.html")
        self.assert_sections()

    def test_charts_have_the_numbers_of_the_files(self):
        folder = run("lines", *LINES)
        (folder / "line-measured-2024.csv").write_text("mine")
        self.open(folder)
        titles = self.script("return [...document.querySelectorAll('#body-lines h3')].map(title => title.textContent)")
        self.assertEqual(titles, ["Line axis from 0 0 0 to 0 0 8 mm", "Line across from -10 0 0 to 10 0 0 mm"])
        steps = self.script("return [...document.querySelector('#step-of-line-axis').options].map(one => one.textContent)")
        self.assertEqual(steps, ["5", "10", "15"])
        for step in (15, 5):
            self.script(f"const choice = document.querySelector('#step-of-line-axis'); choice.value = {step // 5 - 1};"
                        "choice.dispatchEvent(new Event('change'))")
            rows = table(folder, f"line-axis-{step:04d}.csv")
            saved = self.saved_table(self.menu(f"Stress along axis, step {step}"))
            drawn = column(saved, "σ_zz (MPa)")
            for one, row in zip(drawn, rows, strict=True):
                self.assertAlmostEqual(one, float(row["stress_zz"]), delta=1e-5 * abs(float(rows[0]["stress_zz"])) + 1e-6)

    def test_runs_without_lines_have_no_section(self):
        self.open(run("none", *COARSE, "Load program/Cycles=1"))
        self.assertEqual(self.script("return document.querySelectorAll('#lines, a[href=\"#lines\"]').length"), 0)

    def test_damaged_files_are_named(self):
        folder = run("damaged", *LINES)
        good = (folder / "line-axis-0005.csv").read_text()
        for text, says in ((good.replace("stress_zz", "stress"), "no column stress_zz"),
                           (good.replace("\n0,", "\nx,", 1), "column s"),
                           ("", "no points")):
            with self.subTest(says):
                (folder / "line-axis-0005.csv").write_text(text)
                result = report(folder)
                self.assertEqual((result.returncode, result.stderr.count("\n")), (4, 1), result.stderr)
                self.assertRegex(result.stderr, f"line-axis-0005.csv: .*({says})")
        shutil.rmtree(folder)


def tearDownModule():
    SCRATCH.cleanup()


if __name__ == "__main__":
    main()
