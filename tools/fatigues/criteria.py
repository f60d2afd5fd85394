# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Fatigue parameters of stress histories over one settled cycle, (points, steps, 6), MPa. A bar under a reversed stress of the
fatigue limit has the same parameter as a place where a crack just begins: `reference` divides by it.

Shear amplitude on a plane is the radius of the smallest circle around the path of the shear traction. Half of the longest chord
would be the same for straight paths, but is blind to what a path does across its chord: a circle and an equilateral triangle
of the same chord are the same to it, though the triangle needs a circle that is larger by 2/sqrt(3)."""
import numpy as np
from enclosing_ball import enclosing_balls
from planes import FINEST, STEP, largest
from stresses import deviatoric, hydrostatic, of_deviatoric, on_planes, tensors


def shear_amplitude(shear):
    """(..., steps, 2), MPa -> (...), MPa."""
    return enclosing_balls(shear.reshape(-1, *shear.shape[-2:]))[1].reshape(shear.shape[:-2])


def amplitude_bounds(shear):
    """Between which the shear amplitude lies: half of a long chord, and the circle around the middle of a box or of the chord."""
    middle = (shear.max(axis=-2, keepdims=True) + shear.min(axis=-2, keepdims=True)) / 2

    def farthest(from_point):
        squares = ((shear - from_point)**2).sum(axis=-1)
        one = np.argmax(squares, axis=-1)[..., None]
        return (np.take_along_axis(shear, one[..., None], axis=-2), np.sqrt(np.take_along_axis(squares, one, axis=-1)[..., 0]))
    one, around_box = farthest(middle)
    other, chord = farthest(one)
    return chord / 2, np.minimum(around_box, farthest((one + other) / 2)[1])


class SmithWatsonTopper:
    """sigma_n,max * epsilon_a on the plane where the product is largest, MPa; 0 where the normal stress is never tension.
    epsilon_a is half of the range of the normal strain, by Hooke's law from all three normal stresses, which in plane strain
    includes that of the third direction. Smith, Watson and Topper (1970), as a critical plane by Socie (1987).

    young: MPa, poisson: without a unit."""
    name, unit = "swt", "MPa"

    def __init__(self, young, poisson):
        self.young, self.poisson = young, poisson

    def values(self, stress, normals):
        """(points, steps, 6) and (points or 1, planes, 3) -> (points, planes), MPa."""
        normal, _ = on_planes(stress, normals)
        strain = ((1 + self.poisson) * normal - 3 * self.poisson * hydrostatic(stress)[:, None]) / self.young
        return np.maximum(normal.max(axis=2), 0) * np.ptp(strain, axis=2) / 2

    def bounds(self, stress, normals):
        values = self.values(stress, normals)
        return values, values


class _Shear:
    """A parameter that grows with the shear amplitude and the largest normal stress of a plane, MPa."""

    def combine(self, amplitude, normal):
        raise NotImplementedError

    def values(self, stress, normals):
        """(points, steps, 6) and (points or 1, planes, 3) -> (points, planes)."""
        normal, shear = on_planes(stress, normals)
        return self.combine(shear_amplitude(shear), normal.max(axis=2))

    def bounds(self, stress, normals):
        normal, shear = on_planes(stress, normals)
        return [self.combine(bound, normal.max(axis=2)) for bound in amplitude_bounds(shear)]


class FatemiSocie(_Shear):
    """Delta gamma/2 (1 + k sigma_n,max/sigma_y) on the plane where it is largest, without a unit. Delta gamma/2 is the shear
    amplitude over the shear modulus. Pressure on a plane counts as no normal stress. Fatemi and Socie (1988).

    young, yield_stress: MPa, poisson, k: without a unit."""
    name, unit = "fatemi_socie", ""

    def __init__(self, young, poisson, yield_stress, k):
        self.shear_modulus, self.yield_stress, self.k = young / (2 * (1 + poisson)), yield_stress, k

    def combine(self, amplitude, normal):
        return amplitude / self.shear_modulus * (1 + self.k * np.maximum(normal, 0) / self.yield_stress)


class Findley(_Shear):
    """tau_a + k sigma_n,max on the plane where it is largest, MPa; pressure on a plane lowers it. Findley (1959).

    k: without a unit."""
    name, unit = "findley", "MPa"

    def __init__(self, k):
        self.k = k

    def combine(self, amplitude, normal):
        return amplitude + self.k * normal


def crossland(stress, alpha):
    """sqrt(J2,a) + alpha p_max, MPa: radius of the smallest ball around the path of deviators, and the largest hydrostatic
    stress of the cycle. Crossland (1956). (points, steps, 6) -> (points,)."""
    return enclosing_balls(deviatoric(stress))[1] + alpha * hydrostatic(stress).max(axis=1)


def dang_van(stress, a):
    """max over time of tau + a p_H, MPa. tau is the largest shear of the mesoscopic stress, which is the stress without the
    centre of the smallest ball around the path of deviators, where a grain has shaken down. Dang Van (1973).
    (points, steps, 6) -> (points,)."""
    five = deviatoric(stress)
    mesoscopic = of_deviatoric(five - enclosing_balls(five)[0][:, None])
    principal = np.linalg.eigvalsh(tensors(mesoscopic))
    return ((principal[..., 2] - principal[..., 0]) / 2 + a * hydrostatic(stress)).max(axis=1)


def ruiz(stress, traction, slip, pressed):
    """The two parameters of a surface in fretting: tau * delta (N/mm) and sigma_T * tau * delta (N^2/mm^3). Ruiz, Boddington
    and Chen (1984).

    stress: (points, steps, 6), MPa; traction: (points, steps, 2), MPa, the friction traction; slip: (points, steps, 2), mm,
    relative to the counterface; pressed: (points, steps), whether the surface is in contact. tau is the largest size of the
    traction, delta the slip amplitude, which is the radius of the smallest circle around the path of slip in contact, and
    sigma_T the largest normal stress along the axis of slip, 0 where it is never tension. Returns (points,), (points,)."""
    first = np.argmax(pressed, axis=1)
    held = np.where(pressed[..., None], slip, slip[np.arange(len(slip)), first][:, None])  # adds no point to the path
    centres, amplitude = enclosing_balls(held)
    amplitude[~pressed.any(axis=1)] = 0
    tau = np.linalg.norm(traction, axis=2).max(axis=1)
    ways = held - centres[:, None]
    along = ways[np.arange(len(ways)), np.argmax((ways**2).sum(axis=2), axis=1)]
    x, y = (along / np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-300)).T[..., None]
    tension = np.maximum((x**2 * stress[..., 0] + y**2 * stress[..., 1] + 2 * x * y * stress[..., 3]).max(axis=1), 0)
    return tau * amplitude, tension * tau * amplitude


def on_critical_planes(criterion, stress, step=STEP, finest=FINEST):
    """The largest value over all planes, (points,), and the normal of the plane, (points, 3)."""
    return largest(criterion, stress, step, finest)
