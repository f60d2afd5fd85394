# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What tools/paraview/pictures.py draws with pvbatch and software rendering, and how it refuses.

Usage: test_paraview.py PROGRAM [unittest options]"""
import csv
import functools
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

PROGRAM = ""
SCRATCH = tempfile.TemporaryDirectory()
ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SCRIPT = ROOT / "tools/paraview/pictures.py"
XVFB = ["xvfb-run", "-a", "-s", "-noreset"]
PLOT_OVER_LINE = """
import json, sys
import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
for file, start, end in json.loads(sys.argv[1]):
    reader = simple.XMLUnstructuredGridReader(FileName=[file])
    place = simple.Calculator(Input=reader, ResultArrayName="place", Function="coords")
    plot = simple.PlotOverLine(Input=place, Point1=start, Point2=end)
    plot.SamplingPattern, plot.Resolution = "Sample Uniformly", 1000
    plot.UpdatePipeline()
    samples = servermanager.Fetch(plot)
    found, places = (vtk_to_numpy(samples.GetPointData().GetArray(name)) for name in ("vtkValidPointMask", "place"))
    print(len(found), found.sum(), np.abs(places - vtk_to_numpy(samples.GetPoints().GetData())).max())
"""
# A start of pvbatch takes seconds: one does for all calls that draw nothing.
SEVERAL_CALLS = """
import contextlib, io, json, os, runpy, sys
os._exit = sys.exit
script, calls = sys.argv[1], json.loads(sys.argv[2])
results = []
for words in calls:
    sys.argv, code = [script, *words], 0
    with contextlib.redirect_stdout(io.StringIO()) as output, contextlib.redirect_stderr(io.StringIO()) as errors:
        try:
            runpy.run_path(script, run_name="__main__")
        except SystemExit as end:
            code = end.code or 0
    results.append((code, output.getvalue(), errors.getvalue()))
print(json.dumps(results))
"""
WIDTH, HEIGHT = 1600, 1200
CENTRE_X, CENTRE_Y, RADIUS = 680, 600, 480  # of the contact surface in its pictures, in pixels
BACKGROUND = (255, 255, 255)
CYCLE = ["Mesh/Core cells=4", "Mesh/Layers=2", "Load program/Cycles=1",
         "Load program/Legs=0 0 -0.1 : 1 ; 0 0 -0.05 : 1 ; 0 0 0 : 1"]
RUNS = {
    "quarter": CYCLE,
    "full": [*CYCLE, "Mesh/Model=full"],
    "bare": [*CYCLE, "Output/Volume fields=0"],
    "blind": [*CYCLE, "Output/Contact fields=0"],
    "pushed": [*CYCLE, "Mesh/Degree=1", "Load program/Legs=0 0 -0.1 : 1 ; 0.02 0.01 -0.1 : 1"],
    "revolved": [*CYCLE, "Friction/Coefficients=0.2, 0.2", "Friction/Slip potential=0.2, 0.2"],
    "worn": [*CYCLE, "Mesh/Degree=1", "Wear/Law=archard", "Wear/Coefficient=1e-6"],
    "dovetail": ["Load program/Cycles=1", "Output/Volume fields=6", "Output/Contact fields=6"],
    "two": [*CYCLE[:2], "Load program/Legs=0 0 -0.1 : 1", "Lower mesh/Core cells=4", "Output/Volume fields=1"],
    "cubic": [*CYCLE, "Mesh/Core cells=2", "Mesh/Degree=3", "Mesh/Model=half", "Load program/Legs=0 0 -0.1 : 1"],
}
FILES = {"dovetail": "prm/import/dovetail.prm", "two": "prm/two_bodies/steel_on_aluminium.prm"}
STEPS = {"worn": "2,3", "two": "1", "dovetail": "6", "quarter": "all", "full": "2", "bare": "1", "pushed": "2", "cubic": "1",
         "revolved": "2"}


def setUpModule():
    missing = [name for name in ("pvbatch", "xvfb-run") if not shutil.which(name)]
    if missing:
        raise unittest.SkipTest(f"{' and '.join(missing)} not found (Debian: paraview, xvfb, xauth)")


def tearDownModule():
    SCRATCH.cleanup()


def pvbatch(script, *words, launcher=tuple(XVFB), **variables):
    environment = {**os.environ, "LIBGL_ALWAYS_SOFTWARE": "1", **variables}
    return subprocess.run([*launcher, "pvbatch", script, *words], env=environment, text=True, capture_output=True,
                          timeout=300, check=False)


def pictures(*words, **options):
    return pvbatch(SCRIPT, *words, **options)


def several_pictures(*calls):
    """The results of several calls of the script in one process."""
    script = pathlib.Path(SCRATCH.name) / "several_calls.py"
    script.write_text(SEVERAL_CALLS)
    result = pvbatch(script, SCRIPT, json.dumps([[str(word) for word in words] for words in calls]))
    if result.returncode != 0:
        raise AssertionError(f"exit code {result.returncode}\n{result.stdout}{result.stderr}")
    return [subprocess.CompletedProcess(words, *found) for words, found in zip(calls, json.loads(result.stdout.splitlines()[-1]))]


@functools.lru_cache(maxsize=None)
def run_folder(name):
    folder = pathlib.Path(SCRATCH.name) / name
    settings = [f"--set={setting}" for setting in RUNS[name]]
    subprocess.run([PROGRAM, ROOT / FILES.get(name, "prm/paper/case_b.prm"), "--quiet", "--output", folder, *settings], check=True,
                   timeout=300)
    return folder


@functools.lru_cache(maxsize=None)
def rendered(name):
    """Folder of the pictures of a run, and what the script printed."""
    folder = pathlib.Path(SCRATCH.name) / f"{name}-png"
    result = pictures(run_folder(name), "--png", folder, "--steps", STEPS[name])
    if result.returncode != 0 or result.stderr:
        raise AssertionError(f"exit code {result.returncode}\n{result.stdout}{result.stderr}")
    return folder, result.stdout


@functools.lru_cache(maxsize=None)
def picture(run, name):
    """Rows from the top, columns, red green blue."""
    reader = vtkPNGReader()
    reader.SetFileName(str(rendered(run)[0] / f"{name}.png"))
    reader.Update()
    columns, rows, _ = reader.GetOutput().GetDimensions()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    return pixels.reshape(rows, columns, -1)[::-1, :, :3].astype(int)


def surface(run, name):
    """The largest square in the contact surface."""
    half = int(0.7 * RADIUS)
    return picture(run, name)[CENTRE_Y - half:CENTRE_Y + half, CENTRE_X - half:CENTRE_X + half]


def n_colours(pixels):
    return len(np.unique(pixels.reshape(-1, 3), axis=0))


def share_different(pixels, others):
    """Part of the pixels that an eye would see as different."""
    return np.mean(np.abs(pixels - others).max(axis=2) > 24)


def history(run):
    with open(run_folder(run) / "history.csv", encoding="ascii") as file:
        return list(csv.DictReader(file))


class PictureTest(unittest.TestCase):
    def test_names_and_sizes(self):
        views = {"overview", "body", "slip", "pressure", "friction"}
        expected = {"quarter": (views, (1, 2, 3)), "full": (views, (2,)), "pushed": (views, (2,)),
                    "cubic": (views, (1,)), "revolved": (views, (2,)), "bare": (views - {"body"}, (1,))}
        for run, (kinds, steps) in expected.items():
            with self.subTest(run):
                names = {f"{kind}-{step:04d}.png" for kind in kinds for step in steps}
                self.assertEqual({file.name for file in rendered(run)[0].iterdir()}, names)
                for name in names:
                    self.assertEqual(picture(run, name[:-4]).shape, (HEIGHT, WIDTH, 3), name)

    def test_something_is_drawn(self):
        for run, step in (("quarter", 2), ("full", 2), ("pushed", 2), ("cubic", 1), ("bare", 1), ("revolved", 2)):
            for kind, least in (("slip", 200), ("pressure", 15), ("friction", 30)):
                if (run, kind) == ("revolved", "pressure"):
                    least = 10  # pressure varies along the radius alone, over six cells
                with self.subTest(run=run, kind=kind):
                    self.assertGreater(n_colours(surface(run, f"{kind}-{step:04d}")), least)
        self.assertGreater(n_colours(picture("quarter", "body-0002")), 200)
        self.assertGreater(n_colours(picture("quarter", "overview-0002")), 1000)
        self.assertGreater(n_colours(picture("revolved", "body-0002")), 200)

    def test_disc_is_round_and_whole(self):
        """To two pixels, and chords between the nodes on the rim."""
        angles = np.linspace(0, 2 * np.pi, 73)
        for run, step, half_chord in (("quarter", 2, np.pi / 32), ("cubic", 1, np.pi / 8 / 5**0.5),
                                      ("pushed", 2, np.pi / 16), ("revolved", 2, np.pi / 64)):
            pixels = picture(run, f"pressure-{step:04d}")
            for factor, is_inside in ((np.cos(half_chord) - 2 / RADIUS, True), (1 + 2 / RADIUS, False)):
                rows = np.round(CENTRE_Y + factor * RADIUS * np.sin(angles)).astype(int)
                columns = np.round(CENTRE_X + factor * RADIUS * np.cos(angles)).astype(int)
                background = np.all(pixels[rows, columns] == BACKGROUND, axis=1)
                self.assertTrue(np.all(background != is_inside), (run, factor))

    def test_mirror_symmetry(self):
        for kind in ("slip", "pressure", "friction"):
            pixels = surface("quarter", f"{kind}-0002")
            for mirrored in (pixels[::-1], pixels[:, ::-1]):
                self.assertLess(share_different(pixels, mirrored), 0.01, kind)
        pushed = surface("pushed", "friction-0002")
        self.assertGreater(share_different(pushed, pushed[:, ::-1]), 0.1)

    def test_reflected_quarter_is_the_full_body(self):
        title = 100  # rows; it has the name of the run
        for kind in ("body", "slip", "pressure", "friction"):
            self.assertLess(share_different(picture("quarter", f"{kind}-0002")[title:],
                                            picture("full", f"{kind}-0002")[title:]), 0.002, kind)

    def test_steps_differ(self):
        for kind in ("body", "slip", "pressure", "friction"):
            for one, other in ((1, 2), (2, 3)):
                self.assertGreater(share_different(picture("quarter", f"{kind}-{one:04d}")[100:],
                                                   picture("quarter", f"{kind}-{other:04d}")[100:]), 0.01, (kind, one))

    def test_unloaded(self):
        """Everything is open: one colour, the grey that the legend of friction calls so."""
        for kind in ("slip", "pressure", "friction"):
            pixels = surface("quarter", f"{kind}-0003")
            self.assertEqual(n_colours(pixels), 1, kind)
            self.assertLess(np.ptp(pixels[0, 0]), 8, kind)
            if kind != "friction":
                continue
            legend = picture("quarter", f"{kind}-0003")[240:1032, 1344:1380]
            self.assertLess(np.abs(legend - pixels[0, 0]).sum(axis=2).min(), 12, kind)
            self.assertGreater(n_colours(legend), 50, kind)

    def test_scales(self):
        """The legend of slip ends at the largest slip of all steps, those of the singular fields below the largest."""
        scales = {name: (float(upper), float(largest)) for name, upper, largest in re.findall(
            r"^(\w+): colours 0 to (\S+) \w+, values to (\S+) ", rendered("quarter")[1], re.MULTILINE)}
        self.assertEqual(set(scales), {"body", "slip", "pressure"})
        peaks = {name: max(float(row[f"max_{name}"]) for row in history("quarter")) for name in ("slip", "pressure")}
        for name, peak in peaks.items():
            self.assertAlmostEqual(scales[name][1] / peak, 1, delta=1e-5)
        self.assertEqual(*scales["slip"])
        for name in ("body", "pressure"):
            self.assertTrue(0.4 < scales[name][0] / scales[name][1] < 1, name)

    def test_wear(self):
        """A view of its own, with depths that stay when the body is lifted; none without wear (test_names_and_sizes)."""
        self.assertIn("wear-0002.png", {file.name for file in rendered("worn")[0].iterdir()})
        upper, largest = re.search(r"^wear: colours 0 to (\S+) mm, values to (\S+) mm$", rendered("worn")[1], re.M).groups()
        peak = max(float(row["max_wear_depth"]) for row in history("worn"))
        self.assertAlmostEqual(float(largest) / peak, 1, delta=1e-5)
        self.assertEqual(upper, largest)
        for step in (2, 3):
            self.assertGreater(n_colours(surface("worn", f"wear-{step:04d}")), 100)
            self.assertGreater(n_colours(picture("worn", f"overview-{step:04d}")), 1000)

    def test_an_imported_body(self):
        """The flank, 5.657 mm x 6 mm, is a rectangle around the middle of its pictures, and fills 1/2.5 of twice its reach."""
        pixels = picture("dovetail", "slip-0006")
        half = [RADIUS * size / np.hypot(8**0.5, 3) for size in (3, 8**0.5)]  # rows, columns
        for factor, is_inside in ((0.99, True), (1.01, False)):
            for i, j in ((1, 0), (-1, 0), (0, -1)):  # arrows reach beyond the other side
                row, column = (int(round(middle + factor * k * size)) for middle, k, size in
                               zip((CENTRE_Y, CENTRE_X), (i, j), half))
                self.assertEqual(bool(np.any(pixels[row, column] != BACKGROUND)), is_inside, (factor, i, j))
        self.assertGreater(n_colours(picture("dovetail", "body-0006")), 200)

    def test_two_bodies(self):
        """Seen from above at 21 degrees, 36 mm to 1200 pixels: two cylinders, 10 mm high and 20 mm wide, have this height."""
        body = picture("two", "body-0001")[100:, 280:1300]  # not title, axes, legend
        rows = np.flatnonzero(np.any(body != BACKGROUND, axis=(1, 2)))
        up = 0.35 / np.linalg.norm((0.45, 0.8, 0.35))
        self.assertAlmostEqual(np.ptp(rows) * 36 / 1200 / (20 * (1 - up**2)**0.5 + 20 * up), 1, delta=0.02)
        for half in np.array_split(body[rows[0]:rows[-1]], 2):  # coloured by stress
            self.assertGreater(n_colours(half[np.ptp(half, axis=2) > 60]), 200)

    def test_no_volume(self):
        self.assertIn("no volume.pvd (Output/Volume fields = 0)", rendered("bare")[1])


class PlotOverLineTest(unittest.TestCase):
    def test_every_sample_is_found_at_its_place(self):
        """Across the contact surface, and upwards through the modelled part of the body."""
        script = pathlib.Path(SCRATCH.name) / "plot_over_line.py"
        script.write_text(PLOT_OVER_LINE)
        lines = [(str(run_folder(run) / f"{kind}-0001.vtu"), ends[:3], ends[3:])
                 for run, (x, y) in (("quarter", (6.5, 5)), ("cubic", (6.5, 5)), ("revolved", (9, 0)))
                 for kind, ends in (("contact", (-x, -y, 0, x, y, 0)), ("volume", (0, 0, 1, x, y, 5)))]
        result = pvbatch(script, json.dumps(lines))
        self.assertEqual(result.stderr, "")
        self.assertEqual(len(result.stdout.splitlines()), len(lines))
        for line, printed in zip(lines, result.stdout.splitlines()):
            with self.subTest(line):
                total, found, error = map(float, printed.split())
                self.assertEqual((total, found), (1001, 1001))
                self.assertLess(error, 1e-5)  # mm, of single precision


class ErrorTest(unittest.TestCase):
    def assert_refused(self, result, code, pattern):
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertRegex(result.stderr, r"\Apictures\.py: " + pattern + r".*\n\Z")

    def test_folders(self):
        scratch = pathlib.Path(SCRATCH.name)
        png = ["--png", scratch / "none"]
        broken = {name: scratch / name for name in ("grid", "history", "fifo")}
        for folder in broken.values():
            shutil.copytree(run_folder("bare"), folder)
        (broken["grid"] / "contact-0001.vtu").write_text("no xml")
        (broken["history"] / "history.csv").unlink()
        (broken["fifo"] / "history.csv").unlink()
        os.mkfifo(broken["fifo"] / "history.csv")  # nobody writes into it
        calls = {"nowhere: no such folder": ["nowhere"],
                 r".*no contact\.pvd.*Output/Contact fields = 0": [run_folder("blind")],
                 r".*history\.csv": [broken["history"]],
                 r".*history\.csv: is no ordinary file": [broken["fifo"]]}
        for pattern, result in zip(calls, several_pictures(*([*words, *png] for words in calls.values()))):
            self.assert_refused(result, 4, pattern)
        # VTK's own complaint goes past Python.
        self.assert_refused(pictures(broken["grid"], *png, "--steps", "1"), 4, r".*contact-0001\.vtu: cannot be read")
        self.assertFalse(png[1].exists())

    def test_pictures_cannot_be_written(self):
        file = pathlib.Path(SCRATCH.name) / "file"
        file.write_text("mine")
        self.assert_refused(pictures(run_folder("bare"), "--png", file), 4, ".*file: File exists")
        self.assertEqual(file.read_text(), "mine")

    def test_usage(self):
        run = run_folder("bare")
        wrong_steps = ("4", "1,x", "1,")
        no_png, *wrong, usage = several_pictures([run], *([run, "--png", "none", "--steps", steps] for steps in wrong_steps),
                                                 ["--help"])
        self.assert_refused(no_png, 2, ".*--png")
        for steps, result in zip(wrong_steps, wrong):
            self.assert_refused(result, 2, rf"--steps {steps}: .*3, 1 to 3")
        self.assertIn("xvfb-run", usage.stdout)

    def test_no_display(self):
        result = pictures(run_folder("bare"), "--png", pathlib.Path(SCRATCH.name) / "dark", launcher=(), DISPLAY="")
        if result.returncode == 0:
            self.skipTest("this ParaView needs no X server")
        self.assert_refused(result, 2, ".*xvfb-run")


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
