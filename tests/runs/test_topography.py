# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""tools/topographies: files of every format are read as they were written, forms leave nothing, holes are filled as membranes
are, roughness, spectra and made surfaces beside closed forms. test_topography_tool.py has the command.

Usage: test_topography.py PROGRAM [unittest options]"""
import sys
import unittest
import warnings

import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
import program  # noqa: E402
from program import ROOT, main  # noqa: E402
from surface_files import al3d, mask_of, pgm, png, sur, x3p  # noqa: E402

sys.path[:0] = [str(ROOT / "tools" / name) for name in ("topographies", "runs")]
import formats  # noqa: E402
import roughness  # noqa: E402
import shaping  # noqa: E402
import spectrum  # noqa: E402
import text_grid  # noqa: E402
from surface import Surface, WrongSurface, length_of  # noqa: E402

LEVELS = np.array([[0, 7, -30, 500], [3, 12, 40, -800], [9, 5, 1, 2]])  # not alike along x and y
AMPLITUDE, WAVES = 2e-3, 5  # mm, of a sine in a square of 1 mm


def sine(n=128, periodic=True):
    """Ridges along y."""
    x = np.arange(n) / n
    return Surface.centred(np.tile(AMPLITUDE * np.sin(2 * np.pi * WAVES * x + 0.3), (n, 1)), 1 / n, 1 / n, periodic)


def polynomial(degree, shape=(40, 61)):
    """Heights (mm) of all terms up to this degree, and their surface."""
    y, x = np.meshgrid(*(np.linspace(-1, 2, n) for n in shape), indexing="ij")
    terms = [0.3 + 0 * x, 0.2 * x, -0.1 * y, 0.05 * x**2, 0.02 * x * y, -0.07 * y**2]
    return Surface.centred(sum(terms[:(1, 3, 6)[degree]]), 0.02, 0.03)


class FormatTest(program.RunTest):
    def read(self, name, content, **told):
        (self.folder / name).write_bytes(content if isinstance(content, bytes) else content.encode())
        return formats.read(self.folder / name, told)

    def check(self, surface, heights, dx, dy, accuracy=1e-6):
        np.testing.assert_allclose(surface.heights, heights, rtol=accuracy, atol=accuracy * np.nanmax(np.abs(heights)))
        np.testing.assert_allclose((surface.dx, surface.dy), (dx, dy), rtol=accuracy)
        np.testing.assert_allclose((surface.x0, surface.y0), (-1.5 * dx, -dy), rtol=accuracy)

    def test_digital_surf(self):
        """Of both byte orders and widths, compressed or not; the mark of a missing point lies two below the lowest one."""
        missing = np.where(LEVELS == 12, -802, LEVELS)
        expected = np.where(LEVELS == 12, np.nan, LEVELS * 20e-6 + 3e-3)  # 20 nm a level, offset 3 um
        for order in "<>":
            for bits in (16, 32):
                for compressed in (False, True):
                    content = sur(missing, 0.02, (0.5, 0.25), "µm", 3, order, bits, compressed, lowest=-800)
                    with self.subTest(order=order, bits=bits, compressed=compressed):
                        self.check(self.read("a.SUR", content), expected, 0.5e-3, 0.25e-3)
        self.check(self.read("a.sur", sur(LEVELS, 2, (5e-4, 1e-3), "mm", 0)), LEVELS * 2., 5e-4, 1e-3)

    def test_x3p(self):
        for kind, code in (("I", "<i2"), ("L", "<i4"), ("F", "<f4"), ("D", "<f8")):
            content = x3p(LEVELS.astype(code).tobytes(), LEVELS.shape, kind, 1e-8, 2e-6, (5e-7, 2.5e-7))
            self.check(self.read("a.x3p", content), (LEVELS * 1e-8 + 2e-6) * 1e3, 5e-4, 2.5e-4)
        is_valid = LEVELS != 12
        content = x3p(LEVELS.astype("<i2").tobytes(), LEVELS.shape, "I", 1e-8, 0, (1e-6, 1e-6), mask_of(is_valid))
        self.check(self.read("a.x3p", content), np.where(is_valid, LEVELS * 1e-5, np.nan), 1e-3, 1e-3)

    def test_al3d(self):
        """Of an odd number of columns, too, whose rows are filled up."""
        for heights in (LEVELS * 1e-9, LEVELS[:, :3] * 1e-9):
            surface = self.read("a.al3d", al3d(np.where(heights == 12e-9, 1e10, heights), (2e-7, 3e-7), "1e10"))
            np.testing.assert_allclose(surface.heights, np.where(heights == 12e-9, np.nan, heights * 1e3), rtol=1e-6)
            np.testing.assert_allclose((surface.dx, surface.dy), (2e-4, 3e-4))
        self.assertEqual(self.read("a.al3d", al3d(np.where(LEVELS == 9, np.nan, LEVELS * 1e-9), (1e-6, 1e-6), "NaN")).n_missing, 1)

    def test_plain_grids(self):
        expected = np.array([[1, 2.5, np.nan, 4], [0, -1e-3, 2, 3], [7, 8, 9, 1]])
        for text in ("# of a lab\n1 2.5 nan 4\n0 -1e-3 2 3\n\n7 8 9 1 # last\n", "1,2.5,,4\r\n0,-1e-3,2,3\r\n7,8,9,1\r\n",
                     "1;2,5;;4\n0;-1e-3;2;3\n7;8;9;1", "\ufeff1\t2,5\tNaN\t4\n0\t-1e-3\t2\t3\n7\t8\t9\t1\t\n", "1, 2.5, nan, 4,\n0, -1e-3, 2, 3,\n7, 8, 9, 1,\n"):
            self.check(self.read("a.csv", text, pixel=(0.5, 0.25), unit=1e-3), expected * 1e-3, 0.5, 0.25)

    def test_images(self):
        """The upper row lies at the largest y."""
        for content, white in ((png(LEVELS % 256, 8), 255), (png(LEVELS % 65536, 16), 65535), (pgm(LEVELS % 65536), 65535)):
            name = "a.png" if content[:1] == b"\x89" else "a.pgm"
            surface = self.read(name, content, pixel=(0.1, 0.1), heights=(-1e-3, 3e-3))
            self.check(surface, -1e-3 + 4e-3 * (LEVELS % (white + 1))[::-1] / white, 0.1, 0.1)

    def test_lengths(self):
        for text, value in (("0.5", 0.5), ("0.5um", 5e-4), ("5 µm", 5e-3), ("-20nm", -2e-5), ("1e-3m", 1), ("2 cm", 20)):
            self.assertAlmostEqual(length_of(text), value, delta=1e-12)
        for text in ("", "um", "nan", "inf", "5 in", "1e400mm"):
            with self.assertRaises(WrongSurface):
                length_of(text)

    def test_gap_files_come_back(self):
        """In both directions; a periodic surface gets its first row and column again."""
        surface = Surface.centred(LEVELS * 1e-4, 0.3, 0.7)
        surface.x0, surface.y0 = 5, -2
        found = self.read("a.txt", text_grid.gap_text(surface, "zero", "a\nname"))
        np.testing.assert_allclose(found.heights, surface.heights, rtol=1e-8)
        self.assertEqual((found.dx, found.dy, found.x0, found.y0), (0.3, 0.7, 5, -2))
        self.assertEqual(text_grid.gaps_of(surface, "highest").min(), 0)
        self.assertAlmostEqual(text_grid.gaps_of(surface, "mean").mean(), 0, delta=1e-15)
        made = sine(16)
        found = self.read("a.txt", text_grid.gap_text(made, "zero", ""))
        np.testing.assert_allclose(found.heights, -text_grid.gaps_of(made, "zero"), rtol=1e-8)
        np.testing.assert_allclose(found.heights[:, -1], made.heights[:, 0].tolist() + made.heights[:1, 0].tolist(), rtol=1e-8)
        self.assertEqual((found.size, found.x0, found.y0), ((1, 1), -0.5, -0.5))

    def test_damaged_files_are_read_or_refused(self):
        """Cut off anywhere, and with any bytes changed: never another error."""
        chance = np.random.default_rng(3)
        told = {"pixel": (0.1, 0.1)}
        files = {"a.sur": sur(LEVELS, 1, (1, 1), "um", 0), "b.sur": sur(LEVELS, 1, (1, 1), "um", 0, compressed=True),
                 "a.x3p": x3p(LEVELS.astype("<i2").tobytes(), LEVELS.shape, "I", 1e-8, 0, (1e-6, 1e-6), mask_of(LEVELS > 0)),
                 "a.al3d": al3d(LEVELS * 1e-9, (1e-6, 1e-6), "1e10"), "a.png": png(LEVELS % 256, 8),
                 "a.txt": text_grid.gap_text(sine(4), "zero", "").encode(), "b.txt": b"1 2 3\n4 5 6\n"}
        refused = 0
        for name, whole in files.items():
            changed = [bytearray(whole) for _ in range(60)]
            for content in changed:
                for _ in range(chance.integers(1, 6)):
                    content[chance.integers(len(content))] = chance.integers(256)
            extra = {"heights": (0, 1)} if name == "a.png" else {}
            for content in [whole[:n] for n in chance.integers(len(whole), size=30)] + changed:
                try:
                    with warnings.catch_warnings():
                        warnings.simplefilter("error")
                        self.read(name, bytes(content), **(told if name in ("a.png", "b.txt") else {}), **extra)
                except WrongSurface as problem:
                    refused += 1
                    self.assertEqual(len(str(problem).splitlines()), 1)
        self.assertGreater(refused, 200)


class ShapingTest(unittest.TestCase):
    def test_forms_leave_nothing(self):
        """With missing points, too; what is missing stays so."""
        for degree in (0, 1, 2):
            for share in (0, 0.3):
                surface = polynomial(degree)
                surface.heights[np.random.default_rng(1).random(surface.heights.shape) < share] = np.nan
                rest = shaping.levelled(surface, degree)
                self.assertLess(np.nanmax(np.abs(rest.heights)), 1e-13)
                self.assertEqual(rest.n_missing, surface.n_missing)

    def test_what_is_left_is_orthogonal_to_the_form(self):
        noise = np.random.default_rng(2).normal(size=(40, 61))
        surface = polynomial(2)
        rest = shaping.levelled(surface.with_heights(surface.heights + noise), 2).heights
        y, x = np.meshgrid(*(np.linspace(-1, 1, n) for n in rest.shape), indexing="ij")
        for term in (1 + 0 * x, x, y, x * x, x * y, y * y):
            self.assertLess(abs(np.sum(rest * term)), 1e-10)

    def test_outliers(self):
        """Spikes on a rough plane, however large: all are out, and the form is that of the others."""
        surface, chance = polynomial(1), np.random.default_rng(4)
        rough = surface.with_heights(surface.heights + 1e-4 * chance.normal(size=surface.heights.shape))
        spikes = chance.random(rough.heights.shape) < 0.02
        spiked = rough.with_heights(np.where(spikes, rough.heights + 5, rough.heights))
        found = shaping.levelled(spiked, 1, outliers=6)
        np.testing.assert_array_equal(np.isnan(found.heights), spikes)
        expected = shaping.levelled(rough.with_heights(np.where(spikes, np.nan, rough.heights)), 1).heights
        np.testing.assert_allclose(found.heights, expected, atol=1e-12)
        np.testing.assert_array_equal(np.isnan(shaping.masked(sine(32), 1.2).heights), np.abs(sine(32).heights) > 1.2 * 1.4826 * AMPLITUDE / np.sqrt(2))

    def test_holes_are_filled_as_a_membrane_is(self):
        """x^2 - y^2 and planes solve Laplace's equation on the grid, too, and so they come back; no height is beyond others."""
        x, y = polynomial(0).places
        harmonic = polynomial(0).with_heights(x**2 - y[:, None]**2 + 0.3 * x)
        holed = harmonic.with_heights(harmonic.heights.copy())
        holed.heights[5:30, 7:40] = holed.heights[33, 50] = np.nan
        np.testing.assert_allclose(shaping.filled(holed).heights, harmonic.heights, atol=1e-9)
        noise = np.random.default_rng(5).random((30, 30))
        noise[np.random.default_rng(6).random((30, 30)) < 0.6] = np.nan
        found = shaping.filled(Surface.centred(noise, 1, 2)).heights
        self.assertTrue(np.nanmin(noise) - 1e-8 <= found.min() and found.max() <= np.nanmax(noise) + 1e-8)
        np.testing.assert_array_equal(found[~np.isnan(noise)], noise[~np.isnan(noise)])

    def test_other_points(self):
        """A plane stays one; finer points are bilinear; waves that coarser points cannot show are gone."""
        plane = polynomial(1)
        for nx, ny in ((7, 40), (61, 13), (200, 90), (2, 2)):
            found = shaping.resampled(plane, nx, ny)
            np.testing.assert_allclose(shaping.levelled(found, 1).heights, 0, atol=1e-13)
            np.testing.assert_allclose(found.size, plane.size)
            np.testing.assert_allclose(found.heights[[0, -1]][:, [0, -1]], plane.heights[[0, -1]][:, [0, -1]], atol=1e-13)
        finer = shaping.resampled(sine(9, periodic=False), 17, 9).heights
        np.testing.assert_allclose(finer[:, 1::2], (finer[:, :-1:2] + finer[:, 2::2]) / 2, atol=1e-15)
        waves = Surface.centred(np.tile(np.sin(2 * np.pi * np.arange(401) / 4.1), (5, 1)), 1, 1)
        self.assertLess(np.abs(shaping.resampled(waves, 41, 5).heights[:, 2:-2]).max(), 0.03)

    def test_crop_and_turn(self):
        surface = Surface.centred(LEVELS * 1., 0.5, 1)
        part = shaping.cropped(surface, -0.25, 0.75, -0.5, 1)
        np.testing.assert_array_equal(part.heights, LEVELS[1:, 1:])
        self.assertEqual((part.x0, part.y0), (-0.25, 0))
        turned = shaping.turned_over(part)
        self.assertEqual([float(values) for values in turned.places[0]], [-0.75, -0.25, 0.25])
        np.testing.assert_array_equal(turned.heights, part.heights[:, ::-1])


class RoughnessTest(unittest.TestCase):
    def test_a_sine(self):
        """Means of a sine by points are exact; the slope is that of chords, which are shorter by sin(t)/t."""
        found = roughness.numbers(sine())
        chord = np.sinc(WAVES / 128)
        for name, value, accuracy in (("Sa", 2 * AMPLITUDE / np.pi, 1e-2), ("Sq", AMPLITUDE / np.sqrt(2), 1e-12), ("Sz", 2 * AMPLITUDE, 1e-2),
                                      ("Sku", 1.5, 1e-12), ("Sdq", 2 * np.pi * WAVES * AMPLITUDE / np.sqrt(2) * chord, 1e-12),
                                      ("Sal", np.arccos(0.2) / (2 * np.pi * WAVES), 2e-3)):
            self.assertAlmostEqual(found[name] / value, 1, delta=accuracy, msg=name)
        self.assertLess(abs(found["Ssk"]), 1e-12)
        self.assertAlmostEqual(found["Sp"] + found["Sv"], found["Sz"])
        self.assertTrue(np.isnan(found["Str"]))  # along the ridges nothing decays
        fine = roughness.numbers(Surface.centred(np.tile(sine(4000).heights[0], (4, 1)), 1 / 4000, 1, True))
        self.assertAlmostEqual(fine["Sa"] / (2 * AMPLITUDE / np.pi), 1, delta=1e-5)
        # The area of a sine: the mean of sqrt(1 + slope^2), which is 1 + Sdq^2/2 - <slope^4>/8.
        slope = 2 * np.pi * WAVES * AMPLITUDE * np.cos(np.linspace(0, 2 * np.pi, 4001)[1:])
        self.assertAlmostEqual(fine["Sdr"] / (np.mean(np.sqrt(1 + slope**2)) - 1), 1, delta=1e-4)

    def test_a_tilted_plane(self):
        """Its slope and area are exact, with holes, too; a surface without a whole cell has none."""
        surface = Surface.centred(0.3 * 0.02 * np.arange(9) + 0.4 * 0.05 * np.arange(7)[:, None], 0.02, 0.05)
        surface.heights[3, 4] = np.nan
        np.testing.assert_allclose(roughness.slopes(surface), (0.5, np.sqrt(1.25) - 1), rtol=1e-12)
        self.assertTrue(np.isnan(roughness.slopes(Surface.centred([[0, np.nan], [1, 2]], 1, 1))).all())
        flat = roughness.numbers(Surface.centred(np.ones((4, 4)), 1, 1))
        self.assertEqual((flat["Sq"], flat["Sdq"]), (0, 0))
        self.assertTrue(np.isnan(flat["Ssk"]) and np.isnan(flat["Sal"]))

    def test_texture(self):
        """Equal all around, until it is stretched."""
        surface = spectrum.self_affine((256, 256), (1., 1.), 0.7, 0.1, 0.02, 3)
        found = roughness.numbers(surface)
        self.assertGreater(found["Str"], 0.97)
        surface.dy *= 3
        stretched = roughness.numbers(surface)
        self.assertAlmostEqual(stretched["Str"], 1 / 3, delta=0.02)
        self.assertAlmostEqual(stretched["Sal"] / found["Sal"], 1, delta=0.02)
        surface.dy /= 3
        surface.periodic = False  # the same texture, of which only pairs within the surface count
        self.assertAlmostEqual(roughness.numbers(surface)["Sal"] / found["Sal"], 1, delta=0.15)


class SpectrumTest(unittest.TestCase):
    def test_the_integral_is_the_mean_square(self):
        chance = np.random.default_rng(8)
        for shape, periodic in (((32, 32), True), ((31, 70), True), ((64, 33), False)):
            surface = Surface.centred(chance.normal(size=shape) + 5, 0.1, 0.3, periodic)
            found = spectrum.radial_spectrum(surface)
            self.assertAlmostEqual(found.mean_square() / surface.heights.var(), 1, delta=1e-12)
            self.assertTrue(np.all(np.diff(found.q) > 0))

    def test_a_sine_is_one_wavenumber(self):
        """Also behind a window, which spreads it over three."""
        for periodic in (True, False):
            found = spectrum.radial_spectrum(sine(periodic=periodic))
            share = found.density * found.area / found.mean_square()
            near = np.abs(found.q / (2 * np.pi * WAVES) - 1) < (0.1 if periodic else 0.35)
            self.assertGreater(share[near].sum(), 0.99)

    def test_white_noise_is_flat(self):
        """C = mean square * dx dy/(2 pi)^2."""
        surface = Surface.centred(np.random.default_rng(9).normal(size=(300, 300)), 0.1, 0.1)
        found = spectrum.radial_spectrum(surface)
        density = found.density[found.area > 300 * found.area[0]]
        np.testing.assert_allclose(density, 0.01 / (2 * np.pi)**2, rtol=0.15)

    def test_made_surfaces_are_self_affine(self):
        for hurst in (0.3, 0.8, 1.):
            surface = spectrum.self_affine((512, 512), (2., 2.), hurst, 0.4, 0.02, 1)
            found = spectrum.radial_spectrum(surface)
            inside = (found.q > 1.3 * 2 * np.pi / 0.4) & (found.q < 0.9 * 2 * np.pi / 0.02)
            slope = np.polyfit(np.log(found.q[inside]), np.log(found.density[inside]), 1)[0]
            self.assertAlmostEqual(slope, -2 * (1 + hurst), delta=0.02)
            plateau = found.density[found.q < 0.8 * 2 * np.pi / 0.4]
            np.testing.assert_allclose(plateau, plateau[0], rtol=1e-9)
            self.assertLess(found.density[found.q > 1.1 * 2 * np.pi / 0.02].max(), 1e-20 * plateau[0])
            self.assertLess(abs(surface.heights.mean()), 1e-12 * surface.heights.std())

    def test_slope_and_height_of_a_spectrum(self):
        """Sdq^2/Sq^2 is the integral of q^3 C over that of q C (Persson et al. 2005), where waves are long beside the spacing."""
        surface = spectrum.self_affine((768, 768), (1., 1.), 0.8, 0.125, 0.025, 2)
        low, high, fall = 2 * np.pi / 0.125, 2 * np.pi / 0.025, 2 * (1 + 0.8)
        q = np.linspace(0, high, 200001)[1:]
        density = np.maximum(q, low)**-fall
        expected = np.sqrt(np.sum(q**3 * density) / np.sum(q * density))
        self.assertAlmostEqual(roughness.slopes(surface)[0] / surface.heights.std() / expected, 1, delta=0.02)

    def test_seeds(self):
        one, same, other = (spectrum.self_affine((32, 48), (1., 1.5), 0.8, 0.5, 0.1, seed).heights for seed in (5, 5, 6))
        np.testing.assert_array_equal(one, same)
        self.assertLess(abs(np.corrcoef(one.ravel(), other.ravel())[0, 1]), 0.5)


if __name__ == "__main__":
    main()
