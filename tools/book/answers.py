# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Known answers of frictional contact on elastic half-spaces and half-planes.

Lengths mm, forces N, stresses MPa, forces of line contact N/mm. Each formula is checked by an integration of its own in
tests/runs/test_book.py. Integrals without a closed form take 60 points of Gauss where what is integrated is smooth.

Hertz 1882; Cattaneo 1938; Love 1939; Mindlin 1949; Lubkin 1951; Sneddon 1965; Johnson, Contact Mechanics, 1985;
Nowell and Hills 1987; Jaeger 1998; Ciavarella 1998."""
import dataclasses
import math

import numpy as np

YOUNG = 210000  # MPa, where a scene says nothing else
POINTS, WEIGHTS = np.polynomial.legendre.leggauss(60)


def integral(function, low, high):
    """Of a smooth function of an array."""
    half = (high - low) / 2
    return half * np.sum(WEIGHTS * function((low + high) / 2 + half * POINTS))


def elliptic(k):
    """Complete elliptic integrals K and E of the modulus k, by the arithmetic-geometric mean."""
    a, b, power, rest = 1.0, math.sqrt(1 - k * k), 1.0, 1 - k * k / 2
    while abs(a - b) > 1e-15 * a:
        a, b, c = (a + b) / 2, math.sqrt(a * b), (a - b) / 2
        rest -= power * c * c
        power *= 2
    return math.pi / (2 * a), rest * math.pi / (2 * a)


def plane_modulus(*bodies):
    """E* of bodies (E, nu), rigid ones left out."""
    return 1 / sum((1 - poisson**2) / young for young, poisson in bodies)


@dataclasses.dataclass(frozen=True)
class Sphere:
    """A half-space (MPa) pressed by `force` (N) on a sphere of `radius` (mm), rigid or with a material of its own."""

    force: float
    radius: float = 100
    poisson: float = 0.3
    mu: float = 0.3
    counterface: tuple = ()  # Young's modulus (MPa) and Poisson's ratio of another half-space; (): rigid
    young: float = YOUNG

    @property
    def plane_modulus(self):
        """E*, of both."""
        return plane_modulus((self.young, self.poisson), *([self.counterface] if self.counterface else []))

    @property
    def shear_modulus(self):
        return self.young / (2 * (1 + self.poisson))

    @property
    def shear_compliance(self):
        """Sum of (2 - nu) / G over the bodies, 1/MPa."""
        lower = (2 - self.counterface[1]) * 2 * (1 + self.counterface[1]) / self.counterface[0] if self.counterface else 0
        return (2 - self.poisson) / self.shear_modulus + lower

    @property
    def contact_radius(self):
        return (0.75 * self.force * self.radius / self.plane_modulus) ** (1 / 3)

    @property
    def largest_pressure(self):
        return 1.5 * self.force / (math.pi * self.contact_radius**2)

    @property
    def approach(self):
        return self.contact_radius**2 / self.radius

    def pressure(self, r):
        """MPa at distances r (mm) from the axis."""
        return self.largest_pressure * np.sqrt(np.maximum(0, 1 - (r / self.contact_radius) ** 2))

    # Cattaneo and Mindlin; `shear` is the tangential force in N.

    def stick_radius(self, shear):
        return self.contact_radius * (1 - shear / (self.mu * self.force)) ** (1 / 3)

    def traction(self, r, shear):
        """Tangential, MPa, at the first loading."""
        c = self.stick_radius(shear)
        inner = self.mu * self.largest_pressure * c / self.contact_radius * np.sqrt(np.maximum(0, 1 - (r / c) ** 2))
        return self.mu * self.pressure(r) - inner

    def shift(self, shear):
        """Tangential, mm, at the first loading, of what is far from the contact."""
        most = 3 * self.mu * self.force * self.shear_compliance / (16 * self.contact_radius)
        return most * (1 - (1 - shear / (self.mu * self.force)) ** (2 / 3))

    def stuck_shift(self, shear):
        """The same of a patch that sticks."""
        return self.shear_compliance * shear / (8 * self.contact_radius)

    def unloading_shift(self, largest, shear):
        """The same on the way back from the largest shear (Mindlin and Deresiewicz 1953)."""
        return self.shift(largest) - 2 * self.shift((largest - shear) / 2)

    def loop_area(self, largest):
        """Dissipation of a cycle between -largest and largest, N mm."""
        q = largest / (self.mu * self.force)
        factor = 0.9 * (self.mu * self.force) ** 2 * self.shear_compliance / self.contact_radius
        return factor * (1 - (1 - q) ** (5 / 3) - 5 * q / 6 * (1 + (1 - q) ** (2 / 3)))

    # Lubkin; moments N mm, rotations in radians, c / a of the zone that sticks.

    def rotation(self, c):
        """At the first loading, c = c / a."""
        return 0.5 * self.mu * self.largest_pressure / self.shear_modulus * self._annulus(c)

    @staticmethod
    def _annulus(t):
        first, second = elliptic(math.sqrt(1 - t * t))
        return first - second

    def moment(self, c):
        """With q = -d/dr of the integral of f(t) / sqrt(t^2 - r^2) over r < t < a, G u = (1/r) times that of t f(t) / sqrt(r^2
        - t^2) over 0 < t < r: f = (4/pi) G theta t where it sticks, (2/pi) mu p0 t (K - E)(t) where it slips, and the moment
        is 4 pi times the integral of t f(t)."""
        # t = 1 - s^2: K has a logarithm at t = 0 only, where nothing is asked for.
        slip = integral(lambda s: np.array([2 * x * (1 - x * x)**2 * self._annulus(1 - x * x) for x in s]), 0, math.sqrt(1 - c))
        stick = c**3 / 3 * self._annulus(c)
        return 8 * self.mu * self.largest_pressure * self.contact_radius**3 * (stick + slip)

    def loop_of_torsion(self, c):
        """Dissipation of a cycle that leaves c = c / a at both ends, by Masing's rule, N mm: eight times the integral of M
        d theta, less 4 M theta."""
        # By parts over c, d M = (16/3) G a^3 (c/a)^3 d theta: both zones change at the border only.
        inner = integral(lambda t: np.array([self.rotation(x) * self._moment_slope(x) for x in t]), c, 1)
        return 4 * self.moment(c) * self.rotation(c) - 8 * inner

    def _moment_slope(self, c):
        """- d M / d c = 16/3 G a^3 c^3 (- d theta / d c), d (K - E) / d c = - E / c."""
        second = elliptic(math.sqrt(1 - c * c))[1]
        return 8 / 3 * self.mu * self.largest_pressure * self.contact_radius**3 * c * c * second


def elliptic_hertz(force, modulus, radius_x, radius_y):
    """Semi-axes a > b, largest pressure and approach under a rigid body whose radii are radius_x > radius_y along x and y."""
    low, high = 1e-9, 1 - 1e-9  # b / a
    for _ in range(200):
        ratio = (low + high) / 2
        first, second = elliptic(math.sqrt(1 - ratio**2))
        curvatures = (second / ratio**2 - first) / (first - second)  # radius_x / radius_y
        low, high = (ratio, high) if curvatures > radius_x / radius_y else (low, ratio)
    e2 = 1 - ratio**2
    # 1 / (2 radius_x) = p0 b (K - E) / (E* e^2 a^2), p0 = 3 P / (2 pi a b)
    a = (3 * force * radius_x * (first - second) / (math.pi * modulus * e2)) ** (1 / 3)
    largest = 1.5 * force / (math.pi * a * a * ratio)
    return a, ratio * a, largest, largest * ratio * a * first / modulus


def punch_pressure(r, force, radius=1.0):
    """Under a flat punch, MPa at r < radius (mm)."""
    return force / (2 * math.pi * radius * np.sqrt(radius**2 - r**2))


def punch_slope(force, inclination, radius=1.0, poisson=0.3):
    """s in the pressures 1 + s x under an inclined punch relative to a level one, 1/mm."""
    approach = force / (2 * YOUNG / (1 - poisson**2) * radius)
    return 2 * inclination / approach


def truncated_sphere(force, modulus, radius, flat):
    """Contact radius, and approach of a sphere with a flat of radius `flat`: P = 2 E* / (3 R) (2 a^2 + b^2) sqrt(a^2 - b^2)."""
    low, high = flat, flat + (force * radius / modulus) ** (1 / 3) + flat
    for _ in range(200):
        a = (low + high) / 2
        carried = 2 * modulus / (3 * radius) * (2 * a * a + flat**2) * math.sqrt(a * a - flat**2)
        low, high = (a, high) if carried < force else (low, a)
    return a, a * math.sqrt(a * a - flat**2) / radius


@dataclasses.dataclass(frozen=True)
class Cylinder:
    """A half-plane pressed on a cylinder along y by `force` (N/mm), in plane strain. modulus: E* of both."""

    force: float
    modulus: float
    radius: float = 100
    mu: float = 0.3

    @property
    def half_width(self):
        return 2 * math.sqrt(self.force * self.radius / (math.pi * self.modulus))

    @property
    def largest_pressure(self):
        return 2 * self.force / (math.pi * self.half_width)

    def circle(self, x, c):
        """mu p0 (c/a) sqrt(1 - x^2/c^2) within |x| < c."""
        return self.mu * self.largest_pressure * c / self.half_width * np.sqrt(np.maximum(0, 1 - (x / c)**2))

    def stick(self, shear):
        """Half width of the zone that sticks under a tangential force (N/mm), along x or along y."""
        return self.half_width * math.sqrt(1 - shear / (self.mu * self.force))

    def traction(self, x, shear):
        """At the first loading, MPa."""
        return self.circle(x, self.half_width) - self.circle(x, self.stick(shear))

    def unloaded_traction(self, x, largest, shear):
        """On the way back from the largest shear to `shear`."""
        return self.traction(x, largest) - 2 * self.traction(x, (largest - shear) / 2)


@dataclasses.dataclass(frozen=True)
class Fretted(Cylinder):
    """A pad on a specimen, both of one material: `shear` (N/mm) along +x on the specimen while `bulk` (MPa) pulls it along x.
    Friction on it is the circle on the contact less that on |x - e| < c, which strains the stick zone by as much as the bulk
    stress does (Nowell and Hills 1987). It holds while e + c <= a."""

    shear: float = 0
    bulk: float = 0

    @property
    def shift(self):
        """e, mm."""
        return self.bulk * self.half_width / (4 * self.mu * self.largest_pressure)

    def friction(self, x):
        """MPa on the specimen."""
        return self.circle(x, self.half_width) - self.circle(x - self.shift, self.stick(self.shear))

    @property
    def edge_stress(self):
        """Of the specimen along x at x = -a, MPa, where friction and bulk stress both pull: bulk - (2/pi) times the integral of
        friction(s) / (x - s), which is -pi mu p0 for the circle on the contact."""
        a, stick = self.half_width, self.stick(self.shear)
        root = math.sqrt((a + self.shift)**2 - stick**2)
        return self.bulk + 2 * self.mu * self.largest_pressure * (root - self.shift) / a

    def stress_of_height(self, height):
        """What a specimen of this height on rollers, held at x-, has more than a half-plane, MPa, to the first order of a /
        height. The end carries the shear, so that half of its mean stress is at the contact. The force is that on a strip twice
        as high, pressed on both sides: waves of the pressure bring -(sinh t - t) / (sinh t + t) of it, t = 2 k height."""
        grown = integral(lambda t: t / (np.sinh(t) + t), 1e-12, 40) / math.pi
        return (self.shear / 2 + grown * self.force) / height


@dataclasses.dataclass(frozen=True)
class RoundedPunch:
    """A flat punch of half width `flat` with edges of `radius`, in line contact. As contact grows from b to a, flat punches of
    half width s add up: dP'/ds = E* s arccos(b/s) / R, and so P' = E* / (2 R) (a^2 arccos(b/a) - b sqrt(a^2 - b^2))."""

    modulus: float
    flat: float = 1
    radius: float = 10

    def force(self, a):
        """N/mm that makes contact of half width a."""
        b = self.flat
        return self.modulus / (2 * self.radius) * (a * a * math.acos(b / a) - b * math.sqrt(a * a - b * b))

    def half_width(self, force):
        low, high = self.flat, 100 * self.flat
        for _ in range(200):
            a = (low + high) / 2
            low, high = (a, high) if self.force(a) < force else (low, a)
        return a

    def pressure(self, x, a):
        """MPa at x: each punch of half width s > |x| brings dP'/ds / (pi sqrt(s^2 - x^2)); s^2 = x^2 + t^2."""
        start, end = math.sqrt(max(0, self.flat**2 - x * x)), math.sqrt(a * a - x * x)
        # t = start + u^2 takes the root of arccos at s = b away.
        grown = integral(lambda u: np.arccos(np.minimum(1, self.flat / np.sqrt(x * x + (start + u * u)**2))) * 2 * u, 0,
                         math.sqrt(end - start))
        return self.modulus / (math.pi * self.radius) * grown

    def largest_pressure(self, a):
        """Pressure and its place."""
        low, high = self.flat, a
        for _ in range(6):
            x = np.linspace(low, high, 41)[1:-1]
            best = int(np.argmax([self.pressure(place, a) for place in x]))
            low, high = x[max(0, best - 1)], x[min(len(x) - 1, best + 1)]
        return self.pressure(x[best], a), float(x[best])


def deepest_shear(poisson=None):
    """Largest half difference of the principal stresses in the plane below Hertz' contact, by p0, and its depth, by a (Johnson
    1985, 4.2 and 3.4): below a circle with this Poisson's ratio, below a line without one."""
    low, high = 0.0, 3.0
    for _ in range(8):
        z = np.linspace(low, high, 101)
        if poisson is None:
            shear = z - z * z / np.sqrt(1 + z * z)
        else:
            turn = np.arctan2(1, z)  # of 1 / z
            shear = np.abs(1.5 / (1 + z * z) - (1 + poisson) * (1 - z * turn)) / 2
        best = int(np.argmax(shear))
        low, high = z[max(0, best - 1)], z[min(100, best + 1)]
    return float(shear[best]), float(z[best])


def gross_sliding(mu, p, direction):
    """Force per unit normal force on a body that slides along `direction` (radians): against the normal of the slip ellipse."""
    along = np.array([p[0]**2 * math.cos(direction), p[1]**2 * math.sin(direction)])
    return -along / math.hypot(along[0] / mu[0], along[1] / mu[1])


def radius_of_punch(middle, force):
    """Of the punch whose pressure in the middle (MPa) this is, mm: that of a circle which nodes follow roughly."""
    return math.sqrt(force / (2 * math.pi * middle))


def below_square(depth, poisson):
    """Von Mises and mean normal stress on the axis below a square of side 1 on a half-space under the pressure 1 (Love 1929): the
    sum of the normal stresses is -(1 + nu)/pi times the solid angle of the square, and that along z is four times that below the
    corner of a quarter."""
    a, reach = 0.5, math.sqrt(0.5 + depth * depth)
    quarter = math.atan2(a * a, depth * reach)
    along = -2 / math.pi * (quarter + (2 * a * a * depth / (reach * (a * a + depth * depth)) if depth > 0 else 0))
    total = -(1 + poisson) / math.pi * 4 * quarter
    return abs(along - (total - along) / 2), total / 3


def largest_mises_below_square(poisson):
    return max(below_square(depth, poisson)[0] for depth in np.linspace(0.2, 0.6, 401))
