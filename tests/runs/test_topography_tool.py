# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The command tools/topography: made surfaces have what was asked for, the program reads the gaps that were meant, each step of a
measured surface does its part, and wrong input is refused in a line.

Usage: test_topography_tool.py PROGRAM [unittest options]"""
import contextlib
import io
import os
import re
import subprocess
import sys
import unittest
import unittest.mock

import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
import program  # noqa: E402
from program import ROOT, SMALL, main  # noqa: E402
from surface_files import al3d, png, sur, x3p  # noqa: E402

sys.path[:0] = [str(ROOT / "tools" / name) for name in ("topographies", "runs")]
import formats  # noqa: E402
import roughness  # noqa: E402
import run_folder  # noqa: E402
import topography  # noqa: E402
from surface import Surface  # noqa: E402

TOOL = ROOT / "tools/topographies/topography.py"
WRONG_INPUT, FILE_ERROR = 2, 4
LEVELS = np.array([[0, 7, -30, 500], [3, 12, 40, -800], [9, 5, 1, 2]])  # not alike along x and y
AMPLITUDE, WAVES = 2e-3, 5  # mm, of ridges along y in a square of 1 mm


class ToolTest(program.RunTest):
    def setUp(self):
        super().setUp()
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)

    def tool(self, *words):
        """The command in this process, because a start takes longer than most of what it is asked for."""
        streams = [io.TextIOWrapper(io.BytesIO(), encoding="utf-8") for _ in range(2)]
        with contextlib.redirect_stdout(streams[0]), contextlib.redirect_stderr(streams[1]), unittest.mock.patch("sys.argv", [str(TOOL), *words]):
            try:
                topography.main()
                code = 0
            except SystemExit as end:
                code = end.code or 0
        for stream in streams:
            stream.seek(0)
        return subprocess.CompletedProcess(words, code, *(stream.read() for stream in streams))

    def test_the_command_itself(self):
        for words, code in ((["--make", "--size", "1", "--points", "8", "--rms-height", "1um"], 0), (["none.txt"], FILE_ERROR)):
            result = subprocess.run([sys.executable, TOOL, *words], text=True, capture_output=True, check=False)
            self.assertEqual((result.returncode, result.stdout, result.stderr), (code, *(getattr(self.tool(*words), name) for name in ("stdout", "stderr"))))

    def table(self, *words):
        result = self.tool(*words)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return {match[1]: float(match[2]) for match in re.finditer(r"^(S\w+) +(\S+[0-9]\S*) ", result.stdout, re.MULTILINE)}, result.stdout

    def test_made_surfaces_have_what_was_asked_for(self):
        for words, name, value in ((["--rms-height", "0.4um"], "Sq", 0.4), (["--rms-slope", "0.05"], "Sdq", 0.05)):
            found, _ = self.table("--make", "--size", "1,0.5", "--points", "96,48", "--hurst", "0.7", "--roll-off", "0.3", "--seed", "7", *words,
                                  "--gap", "rough.txt", "--datum", "mean", "--spectrum", "rough.csv")
            self.assertEqual(found[name], value)
            surface = formats.read(self.folder / "rough.txt", {})
            self.assertEqual((surface.heights.shape, surface.x0, surface.y0), ((49, 97), -0.5, -0.25))
            surface = Surface.centred(surface.heights[:-1, :-1], surface.dx, surface.dy, periodic=True)
            made = {"Sq": 1e3 * surface.heights.std(), "Sdq": roughness.slopes(surface)[0]}[name]
            self.assertAlmostEqual(made / value, 1, delta=1e-8)
            rings = np.loadtxt(self.folder / "rough.csv", delimiter=",", skiprows=1)
            self.assertAlmostEqual(np.sum(rings[:, 2] * rings[:, 3]) / surface.heights.var(), 1, delta=1e-7)
            np.testing.assert_allclose(rings[:, 0] * rings[:, 1], 2 * np.pi, rtol=1e-8)

    def test_the_program_reads_the_gaps(self):
        """A surface of a slope, a bend and a peak, not alike along x and y: the gaps at the nodes of a body that is lifted are
        those of the highest point less the heights, bilinear between points."""
        x, y = np.linspace(-12, 12, 49), np.linspace(-11, 11, 23)
        heights = 1e-3 * (5 + 0.2 * x - 0.05 * x * y[:, None] + 3 * np.exp(-((x - 3)**2 + (y[:, None] + 2)**2) / 20))
        np.savetxt(self.folder / "measured.txt", heights * 1e3)
        self.table("measured.txt", "--pixel", "0.5,1", "--unit", "um", "--gap", "gap.txt")
        lift = 0.01
        result = self.run_program("lifted", settings=[*SMALL, f"Obstacle/Gap file={self.folder / 'gap.txt'}", "Load program/Cycles=1",
                                                      f"Load program/Legs=0 0 {lift} : 1", "Output/Contact fields=1"])
        self.assertEqual(result.returncode, 0, result.stderr)
        contact = run_folder.RunFolder(self.folder / "lifted").contact(1)
        i, j = (np.clip(np.floor(place), 0, n - 2).astype(int) for place, n in (((contact.points[:, 0] + 12) / 0.5, 49), (contact.points[:, 1] + 11, 23)))
        s, t = (contact.points[:, 0] + 12) / 0.5 - i, contact.points[:, 1] + 11 - j
        between = (1 - t) * ((1 - s) * heights[j, i] + s * heights[j, i + 1]) + t * ((1 - s) * heights[j + 1, i] + s * heights[j + 1, i + 1])
        np.testing.assert_allclose(contact["gap"], heights.max() - between + lift, atol=2e-8)

    def test_steps_of_a_measured_surface(self):
        """Tilted, with spikes and holes: level, outliers and fill give back the roughness, and every step prints its own."""
        rough = Surface.centred(np.tile(AMPLITUDE * np.sin(2 * np.pi * WAVES * np.arange(64) / 64 + 0.3), (64, 1)), 1 / 64, 1 / 64)
        tilted = rough.heights + 0.05 * rough.places[0] - 0.02 * rough.places[1][:, None]
        tilted[10, 12], tilted[40, 50] = 3, np.nan
        np.savetxt(self.folder / "a.csv", tilted, delimiter=",")
        _, said = self.table("a.csv", "--pixel", str(1 / 64))
        self.assertIn("missing points: 1", said)
        found, said = self.table("a.csv", "--pixel", str(1 / 64), "--level", "plane", "--outliers", "6", "--fill", "--gap", "gap.txt",
                                 "--centre", "-3,4", "--body", "--picture", "a.svg")
        self.assertNotIn("missing", said)
        self.assertAlmostEqual(found["Sq"] / (1e3 * AMPLITUDE / np.sqrt(2)), 1, delta=0.03)
        surface = formats.read(self.folder / "gap.txt", {})
        self.assertAlmostEqual(np.mean(surface.places[0]), -3)
        self.assertAlmostEqual(np.mean(surface.places[1]), 4)
        self.assertIn("wavelength (mm)", (self.folder / "a.svg").read_text(encoding="utf-8"))
        tilted[10, 12] = tilted[40, 50] = 0
        np.savetxt(self.folder / "b.txt", tilted)
        self.assertIn("--level plane takes it off", self.table("b.txt", "--pixel", str(1 / 64))[1])
        found, said = self.table("b.txt", "--pixel", "0.5", "--crop", "-5,5,-8,8", "--points", "9,11", "--picture", "b.png")
        self.assertIn("b.txt: 9 x 11 points every 1.188 x 1.55 mm from -4.75, -7.75 mm on, 9.5 x 15.5 mm", said)
        self.assertEqual((self.folder / "b.png").read_bytes()[:4], b"\x89PNG")

    def refused(self, words, *arguments, code=WRONG_INPUT):
        result = self.tool(*arguments)
        self.assertEqual((result.returncode, result.stdout), (code, ""), result.stderr)
        self.assertRegex(result.stderr, r"\Atopography: [^\n]*\n\Z")
        self.assertIn(words, result.stderr)

    def test_wrong_options(self):
        (self.folder / "a.txt").write_text("1 2\n3 4\n", encoding="ascii")
        made = ("--make", "--size", "1", "--rms-height", "1um")
        for words, arguments in (
                ("allowed is a SURFACE, or --make", ()), ("allowed is a SURFACE, or --make", ("a.txt", *made)),
                ("--pixel: '0': allowed are 1 or 2 lengths, separated by commas, > 0", ("a.txt", "--pixel", "0")),
                ("--pixel: '1in': allowed is a length in mm or with a unit", ("a.txt", "--pixel", "1in")),
                ("--unit: 'ell': allowed is a unit, one of mm, um", ("a.txt", "--unit", "ell")),
                ("--heights: '1': allowed are 2 lengths", ("a.txt", "--heights", "1")),
                ("--heights is not for this format", ("a.txt", "--heights", "-1,1")),
                ("--crop: '1,2': allowed are 4 lengths", ("a.txt", "--crop", "1,2")),
                ("--crop 5 to 6 mm has 0 points; allowed are at least 2", ("a.txt", "--pixel", "1", "--crop", "5,6,-1,1")),
                ("--level: invalid choice: 'cubic'", ("a.txt", "--level", "cubic")),
                ("--outliers: '0': allowed is a number from 1 to 1000", ("a.txt", "--outliers", "0")),
                ("--points: '1': allowed are one or two whole numbers", ("a.txt", "--points", "1")),
                ("--centre: '1': allowed are 2 lengths", ("a.txt", "--centre", "1")),
                ("--hurst is for a surface that is made", ("a.txt", "--hurst", "0.5")), ("--seed is for a surface that is made", ("a.txt", "--seed", "0")),
                ("--fill is for a surface that is measured", (*made, "--fill")),
                ("--size: '-1': allowed are 1 or 2 lengths, separated by commas, > 0", ("--make", "--size", "-1", "--rms-height", "1")),
                ("allowed with --size", ("--make", "--rms-height", "1")), ("one of --rms-height SQ and --rms-slope SDQ", (*made, "--rms-slope", "1")),
                ("--rms-height: '0': allowed is one length, > 1e-12", ("--make", "--size", "1", "--rms-height", "0")),
                ("--rms-slope: '-1': allowed is a number from", ("--make", "--size", "1", "--rms-slope", "-1")),
                ("--hurst: '1.5': allowed is a number from 0 to 1", (*made, "--hurst", "1.5")),
                ("--seed: '1.5': allowed is a whole number", (*made, "--seed", "1.5")),
                ("--cut-off 0.001 and --roll-off 1 mm: allowed are 0.0078125", (*made, "--cut-off", "1um")),
                ("--roll-off 2 mm: allowed are", (*made, "--roll-off", "2")), ("--cut-off 0.5 and --roll-off 0.1", (*made, "--cut-off", "0.5", "--roll-off", "0.1")),
                ("--datum is for the gap file", (*made, "--datum", "mean")), ("--datum: invalid choice", (*made, "--datum", "low")),
                ("--picture: 'a.jpg': allowed is a name that ends with .png or .svg", (*made, "--picture", "a.jpg")),
                ("a.txt: is another file of this command", ("a.txt", "--gap", "a.txt")),
                ("b.csv: is another file of this command", (*made, "--gap", "b.csv", "--spectrum", "b.csv"))):
            with self.subTest(words):
                self.refused(words, *arguments)

    def test_wrong_files(self):
        holes = "1 nan\n3 4\n"
        for name, content, words, *arguments in (
                ("a.txt", "1 2\n3 4\n", "has rows of numbers and no spacing; allowed with --pixel D"), ("a.txt", "", "has no line but comments", "--pixel", "1"),
                ("a.txt", "1 2 3\n", "has 3 x 1 points; allowed are at least 2 along x and y", "--pixel", "1"),
                ("a.txt", "1 2\n3 x\n", "line 2: '3 x': allowed are numbers", "--pixel", "1"), ("a.txt", "1 2\n3\n", "line 2: has 1 numbers", "--pixel", "1"),
                ("a.txt", "nan nan\nnan nan\n", "has no measured point", "--pixel", "1"), ("a.txt", "1 2\n3 inf\n", "has heights of up to inf mm", "--pixel", "1"),
                ("a.txt", "1 2 3\n4 nan nan\n5 nan nan\n", "--crop: has no measured point there", "--pixel", "1", "--crop", "0,1,0,1"),
                ("a.txt", "1 2\n3 1e300\n", "has heights of up to 1e+300 mm", "--pixel", "1"),
                ("a.txt", holes, "a.txt: has missing points (1); allowed are none in a gap file: --fill fills them", "--pixel", "1", "--gap", "g.txt"),
                ("a.txt", holes, "--points: has missing points (1); allowed are none: --fill", "--pixel", "1", "--points", "3"),
                ("a.txt", "0 1 2 0 1 2\n1 2\n3 4\n", "is a gap file, which says by itself what --pixel would", "--pixel", "1"),
                ("a.xyz", "1 2\n", "ends with '.xyz'; allowed are .sur (Digital Surf)"), ("a.sur", "no", "begins with b'no'; allowed is a file of Digital Surf"),
                ("a.sur", sur(LEVELS, 1, (1, 1), "um", 0), "--pixel is not for this format (Digital Surf); allowed: none of that", "--pixel", "1"),
                ("a.sur", sur(LEVELS, 1, (1, 1), "um", 0)[:-3], "has 21 bytes of heights; 4 x 3 points of 2 bytes are declared"),
                ("a.sur", sur(LEVELS, 1, (1, 1), "ells", 0), "'ells': allowed is a unit"),
                ("a.sur", sur(LEVELS, 1, (0, 1), "um", 0), "has points every 0 and 0.001 mm; allowed are spacings from 1e-09 to"),
                ("a.sur", sur(LEVELS, 1, (1, 1), "um", 0, kind=4), "has an object of kind 4"),
                ("a.sur", sur(LEVELS, 1, (1, 1), "um", 0, size=(2**30, 2**30)), "has 1073741824 x 1073741824 points; allowed are 20000000"),
                ("a.x3p", b"PK\3\4", "is no zip archive"), ("a.x3p", x3p(b"", (1, 5), "D", 1, 0, (1, 1)), "has 5 x 1 points"),
                ("a.x3p", x3p(b"12", (3, 4), "D", 1, 0, (1e-6, 1e-6)), "has 2 bytes of heights; 4 x 3 points of 8 bytes are declared"),
                ("a.x3p", x3p(b"", (10**9, 10**9), "D", 1, 0, (1, 1)), "has 1000000000 x 1000000000 points"),
                ("a.x3p", x3p(LEVELS.astype("<f8").tobytes(), LEVELS.shape, "Q", 1, 0, (1, 1)), "Record1/Axes/CZ/DataType = 'Q'; allowed is I or L or F or D"),
                ("a.x3p", x3p(LEVELS.astype("<f8").tobytes(), LEVELS.shape, "D", 1, 0, (1, "wide")), "CY/Increment = 'wide'; allowed is a finite number"),
                ("a.al3d", "Alicona", "begins with b'Alicona'; allowed is a file of Alicona"), ("a.al3d", al3d(LEVELS, (1e-6, 1e-6), "x"), "InvalidPixelValue = 'x'"),
                ("a.al3d", al3d(LEVELS, (1e-6, 1e-6), "1e10")[:-60], "bytes of heights; 4 x 3 points of 4 bytes are declared"),
                ("a.png", png(LEVELS % 256, 8), "is an image, which has no lengths; allowed with --pixel"),
                ("a.png", png(LEVELS % 256, 8), "allowed with --heights, such as --heights 0,12um", "--pixel", "1"),
                ("a.pgm", b"P6\n2 2\n255\nredgreenblue", "is an image of the kind RGB; allowed are grey levels", "--pixel", "1", "--heights", "0,1"),
                ("a.png", "no image", "is no image that can be read", "--pixel", "1", "--heights", "0,1")):
            with self.subTest(words):
                (self.folder / name).write_bytes(content if isinstance(content, bytes) else content.encode())
                self.refused(words, name, *arguments)

    def test_lost_files(self):
        made = ("--make", "--size", "1", "--points", "8", "--rms-height", "1um")
        self.refused("none.txt: No such file or directory", "none.txt", code=FILE_ERROR)
        (self.folder / "folder.txt").mkdir()
        os.mkfifo(self.folder / "pipe.sur")
        self.refused("folder.txt: is no ordinary file, but a folder", "folder.txt", code=FILE_ERROR)
        self.refused("pipe.sur: is no ordinary file, but a pipe", "pipe.sur", code=FILE_ERROR)
        for option, name in (("--gap", "none/a.txt"), ("--spectrum", "none/a.csv"), ("--picture", "none/a.png"), ("--gap", "folder.txt")):
            result = self.tool(*made, option, name)
            self.assertEqual(result.returncode, FILE_ERROR)
            self.assertRegex(result.stderr, rf"\Atopography: {name}: [^\n]*\n\Z")

    def test_the_page_shows_what_its_first_command_prints(self):
        page = (ROOT / "docs/topography.md").read_text(encoding="utf-8").split("```\n")
        words = page[1].replace("\\\n", "").split()
        self.assertEqual((words[0], words[-2]), ("tools/topography", "--picture"))
        self.assertEqual(self.tool(*words[1:-2]).stdout, page[3] + "rough.txt: the gap file\n")

    def test_the_page_has_every_option_and_number(self):
        page = (ROOT / "docs/topography.md").read_text(encoding="utf-8")
        options = set(re.findall(r"^  (--[a-z-]+)", self.tool("--help").stdout, re.MULTILINE))
        self.assertGreater(len(options), 20)
        for name in [*options, *roughness.NUMBERS, *(suffix for one in formats.FORMATS for suffix in one.suffixes)]:
            self.assertRegex(page, rf"`{re.escape(name)}\b|{re.escape(name)}`", name)


if __name__ == "__main__":
    main()
