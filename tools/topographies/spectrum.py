# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The power spectrum of a rough surface, and surfaces that are made of one. Definitions are those of Persson, Albohr, Tartaglino,
Volokitin and Tosatti, J. Phys.: Condens. Matter 17 (2005) R1, section 2: C(q) is the Fourier transform of the mean of
h(0) h(x), over (2 pi)^2, so that its integral over the plane of wavevectors is the mean square height."""
import dataclasses

import numpy as np
from surface import Surface, WrongSurface, check_size

RING = 1.12  # between the ends of a ring of wavevectors, where that is more than the spacing of these


@dataclasses.dataclass
class Spectrum:
    """Rings of wavevectors: q (n,), mean wavenumber, 1/mm; density (n,), mean of C, mm^4; area (n,), of the ring's wavevectors,
    1/mm^2. The sum of density * area is the mean square height."""
    q: np.ndarray
    density: np.ndarray
    area: np.ndarray

    def mean_square(self):
        """mm^2."""
        return float(self.density @ self.area)


def wavenumbers(surface):
    """(ny, nx), 1/mm, in the order of a Fourier transform, and the spacing of wavevectors along x and y, 1/mm."""
    ny, nx = surface.heights.shape
    qx, qy = 2 * np.pi * np.fft.fftfreq(nx, surface.dx), 2 * np.pi * np.fft.fftfreq(ny, surface.dy)
    return np.hypot(qx, qy[:, None]), 2 * np.pi / (nx * surface.dx), 2 * np.pi / (ny * surface.dy)


def radial_spectrum(surface):
    """The Spectrum of heights about their mean; none may be missing. Heights that are not periodic get a Hann window, because
    their ends do not fit each other, and the spectrum is scaled to their mean square."""
    heights = surface.heights - surface.heights.mean()
    square = np.mean(heights**2)
    if not surface.periodic:
        window = np.outer(*(np.sin(np.pi * (np.arange(n) + 0.5) / n)**2 for n in heights.shape))
        heights = window * (heights - np.sum(window * heights) / window.sum())
    power = np.abs(np.fft.fft2(heights) / heights.size)**2
    power[0, 0] = 0
    power *= square / power.sum() if power.sum() else 0
    q, step_x, step_y = wavenumbers(surface)
    ends = [0, 0.5 * max(step_x, step_y)]
    while ends[-1] < q.max():
        ends.append(max(ends[-1] + max(step_x, step_y), RING * ends[-1]))
    ring = np.digitize(q.ravel()[1:], ends)
    count = np.bincount(ring)
    sums = [np.bincount(ring, values.ravel()[1:])[count > 0] for values in (q, power)]
    count = count[count > 0]
    cell = step_x * step_y
    return Spectrum(sums[0] / count, sums[1] / (count * cell), count * cell)


def self_affine(points, size, hurst, roll_off, cut_off, seed):
    """A periodic Surface with the mean 0 and an arbitrary scale. points: (nx, ny). size: (along x, along y) of the period, mm. C is
    constant for wavelengths from roll_off (mm) on, falls with q^(-2 (1 + hurst)) down to the wavelength cut_off (mm), and is 0
    below (Persson et al. 2005, section 2.2). All phases are random, and amplitudes are not, so that the spectrum is this
    one exactly. The same seed makes the same surface. Raises WrongSurface."""
    nx, ny = points
    check_size(nx, ny)
    surface = Surface.centred(np.zeros((ny, nx)), size[0] / nx, size[1] / ny, periodic=True)
    least = 2 * max(surface.dx, surface.dy)
    if not least * (1 - 1e-9) <= cut_off <= roll_off * (1 + 1e-9) or roll_off > min(size) * (1 + 1e-9):
        raise WrongSurface(f"--cut-off {cut_off:g} and --roll-off {roll_off:g} mm: allowed are {least:g} (two spacings) <= cut-off <= "
                           f"roll-off <= {min(size):g} (the size)")
    q, *_ = wavenumbers(surface)
    amplitude = np.where(q <= 2 * np.pi / cut_off * (1 + 1e-9), np.maximum(q, 2 * np.pi / roll_off)**-(1 + hurst), 0)
    amplitude[0, 0] = 0
    noise = np.fft.fft2(np.random.default_rng(seed).normal(size=(ny, nx)))
    return surface.with_heights(np.fft.ifft2(amplitude * noise / np.abs(noise)).real)
