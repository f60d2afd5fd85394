# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Pressure and shear that grow together: below the limit of friction nothing slips.

Mindlin and Deresiewicz (1953), Johnson, Contact Mechanics, 7.3: where normal and tangential displacements are not coupled
(nu = 1/2), Q = k P with k < mu makes the traction k p everywhere. What a computed scene slips is therefore an error, of the
load steps (a node that closes within one is held from where the step began) or of the mesh. P = 400 N, Q = 80 N, mu = 0.3,
on a sphere of 60 mm. A fretting loop of the same Q at constant P dissipates about 0.011 N mm.

Usage: test_oblique.py PROGRAM [unittest options]; with -v it prints what was dissipated."""
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
from program import RunTest, main  # noqa: E402

LOOP = 0.011  # N mm
NORMAL, SHEAR = 400, 80  # N
SCENE = """subsection Geometry
  set Radius = {radius}
  set Height = {height}
end
subsection Mesh
  set Core cells    = 10
  set Core ratio    = {core}
  set Rings         = {rings}
  set Rim grading   = 1.6
  set Layers        = {layers}
  set Layer grading = 0.5
  set Degree        = {degree}
end
subsection Material
  set Young modulus = {modulus}
  set Poisson ratio = {ratio}
end
subsection Friction
  set Coefficients = 0.3, 0.3
end
subsection Obstacle
  set Gap = (x^2+y^2)/(2*60)
{obstacle}end
subsection Load program
  set Preload = uz -0.00002 : 1
  set Legs    = Fz -400 Fx 80 : {steps}
end
subsection Output
  set Contact fields = 0
end
"""
HALF_SPACE = {"radius": 0.6, "height": 0.6, "core": 0.8, "rings": 1, "layers": 1, "degree": 1, "modulus": 2e11, "ratio": 0.3,
              "obstacle": "  set Kind = half-space\n  set Young modulus = 210000\n  set Poisson ratio = 0.499999\n"}
CYLINDER = {"radius": 6, "height": 12, "core": 0.12, "rings": 6, "degree": 2, "modulus": 210000, "ratio": 0.4999,
            "obstacle": ""}


class ObliqueTest(RunTest):
    def dissipated(self, name, **scene):
        """N mm, up to Q."""
        file = self.folder / f"{name}.prm"
        file.write_text(SCENE.format(**scene), encoding="ascii")
        result = self.run_program(name, file=file)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        last = self.rows(name)[-1]
        self.assertAlmostEqual(float(last["force_z"]), NORMAL, delta=1e-6 * NORMAL)
        self.assertAlmostEqual(float(last["held_force_x"]), SHEAR, delta=1e-6 * NORMAL)
        dissipated = float(last["total_dissipation"])
        if "-v" in sys.argv:
            print(f"{name}: {dissipated:.2e} N mm, {100 * dissipated / LOOP:.3f} % of the loop, {last['n_slip']} nodes slip",
                  file=sys.stderr)
        return dissipated

    def test_error_of_the_steps_on_a_half_space(self):
        of = {steps: self.dissipated(f"half-space, {steps} steps", **HALF_SPACE, steps=steps) for steps in (5, 20, 80)}
        self.assertLess(of[5], 0.01 * LOOP)
        self.assertLess(of[20], of[5] / 4)  # of first order at least
        self.assertLess(of[80], of[20] / 4)
        self.assertLess(of[80], 1e-4 * LOOP)

    def test_error_of_the_layers_below_the_surface(self):
        coarse, fine = (self.dissipated(f"cylinder, {layers} layers", **CYLINDER, layers=layers, steps=20)
                        for layers in (8, 10))
        self.assertLess(coarse, 0.02 * LOOP)
        self.assertLess(fine, coarse / 2)  # layers of a quarter of the height

    def test_neither_bending_nor_steps_of_a_body_matter(self):
        of = self.dissipated("cylinder of radius 6 mm", **CYLINDER, layers=8, steps=20)
        wide = {**CYLINDER, "radius": 12, "core": 0.06, "rings": 8}  # turns by a sixteenth
        for name, scene, steps in (("cylinder of radius 12 mm", wide, 20), ("cylinder, 100 steps", CYLINDER, 100)):
            self.assertAlmostEqual(self.dissipated(name, **scene, layers=8, steps=steps), of, delta=0.03 * of)


if __name__ == "__main__":
    main()
