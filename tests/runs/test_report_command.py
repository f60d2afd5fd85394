# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What of tools/report.py needs no browser: errors, what is left on the disk, and how much of a long run the page holds.

Usage: test_report_command.py PROGRAM [unittest options]"""
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import meshio
import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
from program import PROGRAM, main  # noqa: E402
from report_page import table  # noqa: E402
from report_run import CASE_B, COARSE, REPORT, SCRATCH, report, run  # noqa: E402


def payload(page):
    return json.loads(re.search(r'id="data">(.*?)</script>', page.read_text())[1])


def with_points(file, points, cells):
    """The same mesh with some of its points, in this order, and other numbers of them in the cells."""
    mesh = meshio.read(file)
    data = {name: values[points] for name, values in mesh.point_data.items()}
    meshio.Mesh(mesh.points[points], [(mesh.cells[0].type, cells)], data).write(file)


def split_points(file):
    cells = meshio.read(file).cells[0].data
    with_points(file, cells.reshape(-1), np.arange(cells.size).reshape(cells.shape))


def merge_points(file):
    mesh = meshio.read(file)
    places = np.round(mesh.points, 4) + 0.0
    _, one, node = np.unique(places, axis=0, return_index=True, return_inverse=True)
    order = np.random.default_rng(1).permutation(len(one))  # not the order of the cells
    with_points(file, one[order], np.argsort(order)[node.reshape(-1)][mesh.cells[0].data])


def wait_for(happened, seconds=100):
    end = time.monotonic() + seconds
    while not happened():
        if time.monotonic() > end:
            raise AssertionError("it did not happen")
        time.sleep(0.1)


class CommandTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = run("command", *COARSE, "Load program/Cycles=1")

    def assert_error(self, result, code, pattern):
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertRegex(result.stderr, rf"^report: .*{pattern}.*\n$")
        self.assertEqual(result.stderr.count("\n"), 1)

    def test_wrong_usage(self):
        self.assert_error(report(), 2, "RUN_FOLDER")
        self.assert_error(report(self.folder, "--colour"), 2, "--colour")
        self.assert_error(report(self.folder, self.folder.parent / "command"), 2, "this run is named twice")
        self.assert_error(report(*[self.folder.parent / str(k) for k in range(9)]), 2, "9 runs, .* 8 at most")

    def test_no_run_folder(self):
        self.assert_error(report(self.folder / "nothing"), 4, "nothing: no such folder")
        empty = tempfile.mkdtemp(dir=SCRATCH.name)
        missing = "not a run folder, for history.csv and parameters.prm are missing"
        (self.folder / "report.html").unlink(missing_ok=True)  # that other tests made
        self.assert_error(report(empty), 4, missing)
        self.assert_error(report(self.folder, empty), 4, missing)
        self.assertFalse((self.folder / "report.html").exists())

    def test_output(self):
        page = self.folder / "page.html"
        result = report(self.folder, "--output", page)
        first, second = result.stdout.splitlines()
        self.assertRegex(first, rf"^report: {page} \(\d+ kB\): 15 of 15 steps; histories, maps of 15 steps, loops, cycles, "
                                "energies, solver$")
        self.assertEqual((result.returncode, second), (0, f"report: open it in a web browser: xdg-open {page}"))
        first = page.read_bytes()
        self.assertEqual(report(self.folder, "--output", page).returncode, 0)
        self.assertEqual(page.read_bytes(), first)
        self.assertFalse(list(self.folder.glob(".report*")))
        self.assertNotIn(str(self.folder.parent).encode(), first)
        self.assert_error(report(self.folder, "--output", self.folder), 4, "is no ordinary file")
        pipe = self.folder / "pipe"
        os.mkfifo(pipe)
        self.assert_error(report(self.folder, "--output", pipe), 4, "pipe: is no ordinary file")
        self.assert_error(report(self.folder, "--output", self.folder / "none/page.html"), 4, "none: no such folder")

    def tiles(self, folder):
        """{name: words} of the answers on the page."""
        self.assertEqual(report(folder).returncode, 0)
        text = (folder / "report.html").read_text(encoding="utf-8").replace("\u00a0", " ")
        return dict(re.findall(r'<div class="tile"><dt>(.*?)</dt><dd>(.*?)<', text))

    def test_answers(self):
        """Of the tables, and of summary.json where it has them."""
        folder = pathlib.Path(tempfile.mkdtemp(dir=SCRATCH.name)) / "answers"
        shutil.copytree(self.folder, folder)
        rows, tiles = table(folder), self.tiles(folder)
        self.assertEqual(tiles["largest normal force"], f"{max(float(row['force_z']) for row in rows) / 1000:.4g} kN")
        self.assertEqual(tiles["largest slip in contact"], f"{max(float(row['max_slip']) for row in rows) * 1000:.4g} \u00b5m")
        self.assertEqual(tiles["energy dissipated in the last cycle"], f"{float(rows[-1]['total_dissipation']):.4g} N mm")
        self.assertNotIn("largest tangential force", tiles)
        summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
        self.assertEqual(tiles["largest energy per area since the start"],
                         f"{summary['answers']['energy_per_area']['value']:.4g} N/mm")
        of_summary = ("energy dissipated since the start", "largest energy per area since the start")  # of one cycle
        summary["answers"] = {"slip_of_contact": {"value": 0.0123, "unit": "mm", "step": 7}, "mu_eff": {"value": None}}
        (folder / "summary.json").write_text(json.dumps(summary), encoding="utf-8")
        self.assertEqual(self.tiles(folder), {**{name: words for name, words in tiles.items() if name not in of_summary},
                                              "largest slip in contact": "12.3 \u00b5m"})

    def test_changed_entries_come_first(self):
        report(self.folder)
        text = (self.folder / "report.html").read_text(encoding="utf-8")
        changed, _, folded = text.partition('<section id="parameters"')[2].partition("<details>")
        for name, is_changed in (("Layers", True), ("Degree", True), ("Height", False), ("Rho factor", False)):
            self.assertEqual([f'row">{name}</th>' in part for part in (changed, folded)], [is_changed, not is_changed], name)

    def test_follow(self):
        """The page shows itself anew as long as the run goes on, and stands still afterwards."""
        folder = pathlib.Path(SCRATCH.name) / "followed"
        settings = [f"--set={setting}" for setting in (*COARSE, "Load program/Cycles=60000", "Output/Contact fields=0")]
        with subprocess.Popen([PROGRAM, CASE_B, "--quiet", "--output", folder, *settings], stderr=subprocess.DEVNULL) as going:
            page = folder / "report.html"
            wait_for((folder / "history.csv").exists)
            with subprocess.Popen([sys.executable, REPORT, folder, "--follow", "--every", "0.5"], stdout=subprocess.PIPE,
                                  text=True) as following:
                try:
                    wait_for(page.exists)
                    text = page.read_text(encoding="utf-8")
                finally:
                    going.send_signal(signal.SIGINT)
                said = following.communicate(timeout=100)[0]
        self.assertIn("Still running", text)
        self.assertIn('http-equiv="refresh"', text)
        self.assertEqual((following.returncode, said.count("\n")), (0, 3), said)
        text = page.read_text(encoding="utf-8")
        self.assertIn("Not complete", text)
        self.assertNotIn('http-equiv="refresh"', text)
        self.assert_error(report(folder, "--follow", "--every", "0"), 2, "seconds from 0.5")

    def test_several_runs_go_into_the_first_folder(self):
        first, second = run("first", *COARSE, "Load program/Cycles=1"), run("second", *COARSE, "Load program/Cycles=2")
        self.assertEqual(report(first, second).returncode, 0)
        self.assertEqual([(folder / "report.html").exists() for folder in (first, second)], [True, False])
        names = [(one["name"], len(one["history"]["step"])) for one in payload(first / "report.html")["runs"]]
        self.assertEqual(names, [("first", 15), ("second", 30)])

    def test_units(self):
        """Where the program's own description of an entry names a unit, the page shows it behind its value."""
        words = {"mm": r"\bin mm\b", "MPa": r"\bin MPa\b", "degrees": r"^Degrees\b", "s": r"^Least seconds",
                 "%": r"percentage", "\u00d7 tolerance": r"in multiples of Contact solver/Tolerance"}
        folder = run("units", *COARSE, "Load program/Preload=0 0 -0.01 : 1", "Load program/Cycles=1",
                     "Output/Probes=P: 1 2")
        report(folder)
        shown = dict(re.findall(r'<tr><th scope="row">([^<]*)</th><td>(.*?)</td></tr>',
                                (folder / "report.html").read_text()))
        defaults = subprocess.run([PROGRAM, "--defaults"], capture_output=True, text=True, check=True).stdout
        found = 0
        for comment, entry in re.findall(r"((?:^  #.*\n)+)  set (.+?) *=", defaults, re.MULTILINE):
            comment = " ".join(comment.replace("#", " ").split())
            if not shown[entry]:
                continue
            for unit in (unit for unit, pattern in words.items() if re.search(pattern, comment)):
                found += 1
                self.assertRegex(shown[entry], rf'<span class="unit">[^<]*{re.escape(unit)}[^<]*</span>', entry)
        self.assertGreaterEqual(found, 12)

    def test_cells_that_share_points(self):
        """Nodes that each cell has for itself, and nodes that neighbours share, give the same page."""
        pages = []
        for name, change in (("own", split_points), ("shared", merge_points)):
            folder = pathlib.Path(tempfile.mkdtemp(dir=SCRATCH.name)) / name
            shutil.copytree(self.folder, folder)
            for file in folder.glob("contact-*.vtu"):
                change(file)
            self.assertEqual(report(folder).returncode, 0)
            pages.append(payload(folder / "report.html")["maps"])
        self.assertEqual(*pages)

    def test_cycles_too_long_for_the_maps(self):
        """490 steps, 40 a cycle: not even two whole cycles fit, but the turns of the load must not be left out. Of the
        37 turns every third is on the same side of the loop: the small maps must not take those alone."""
        folder = run("fretting", *COARSE, "Load program/Preload=0 0 -0.05 : 10", "Load program/Cycles=12",
                     "Load program/Legs=0.01 0 -0.05 : 10; -0.01 0 -0.05 : 20; 0 0 -0.05 : 10")
        report(folder)
        maps = payload(folder / "report.html")["maps"]
        steps = [frame["step"] for frame in maps["frames"]]
        turns = [10 + 40 * cycle + end for cycle in range(12) for end in (10, 30, 40)]
        self.assertLessEqual(len(steps), 60)
        self.assertTrue({1, 10, *turns} <= set(steps))
        self.assertLessEqual(np.max(np.diff(steps)), 20)  # as long as the longest leg
        small = maps["small"]
        self.assertEqual((small[0], small[-1]), (1, 490))
        self.assertLessEqual(len(small), 15)
        sides = [(step - 10) % 40 for step in small]  # of the loop
        self.assertGreaterEqual(min(sides.count(10), sides.count(30), sides.count(0)), 3)

    def test_long_run(self):
        folder = run("long", *COARSE, "Load program/Cycles=70")
        self.assertEqual((report(folder).returncode, len(table(folder))), (0, 1050))
        text = (folder / "report.html").read_text()
        self.assertLess(len(text), 5e6)
        self.assertIn("The maps show 60 of the 1050 steps", text)
        data = payload(folder / "report.html")
        steps = [frame["step"] for frame in data["maps"]["frames"]]
        self.assertEqual(steps[:15] + steps[-15:], [*range(1, 16), *range(1036, 1051)])
        self.assertTrue({1, 5, 15, 1040, 1050} <= set(data["maps"]["small"]) <= set(steps))
        self.assertTrue(set(steps) <= set(data["runs"][0]["history"]["step"]))


def tearDownModule():
    SCRATCH.cleanup()


if __name__ == "__main__":
    main()
