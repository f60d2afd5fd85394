// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Worked example of docs/extending.md: an obstacle that no expression describes well, here a row of rounded
// bars along y.
#include "results/scenes.h"

#include <orthocone/scene/obstacle.h>

namespace orthocone::test
{
namespace
{
class Bars : public Obstacle
{
public:
  Bars(const double pitch, const double radius)
      : pitch_(pitch),
        radius_(radius)
  {
  }

  double gap(const Eigen::Vector2d &place) const override
  {
    const double from_bar = std::remainder(place[0], pitch_);
    return from_bar * from_bar / (2 * radius_);
  }

  void check(const std::vector<Eigen::Vector2d> &) const override {} // there is a gap everywhere

private:
  double pitch_;  ///< mm
  double radius_; ///< mm
};
} // namespace

// One bar in the middle, two at the sides: contact lies along three lines.
TEST(ExampleObstacle, CarriesTheBodyOnItsBars)
{
  Parameters parameters = small_scene();
  parameters.geometry.shape = BodyShape::box;
  parameters.geometry.sizes = {{20, 10, 10}};
  parameters.mesh.cells = {{16, 4, 4}};
  parameters.mesh.model = ModelKind::quarter;
  const Bars bars(8, 50);
  const SurfaceSample sample = surface_sample(parameters);
  EXPECT_EQ(bars.asymmetry(SymmetryPlanes{true, true}, sample), "");
  const Scene scene(parameters, choose_model(parameters), bars);
  StepSolver solver(scene);
  ContactState state(scene.gaps());
  const LoadStep step = LoadProgram(parameters.load).steps().front();
  ASSERT_TRUE(solver.solve(state, step).converged);
  const ContactFieldEvaluator evaluator(scene);
  for (unsigned int node = 0; node < scene.surface().nodes.size(); ++node)
  {
    const double x = scene.surface().nodes[node].position[0];
    const double from_bar = std::abs(std::remainder(x, 8));
    const ContactFields fields = evaluator.fields(state, node);
    EXPECT_TRUE(from_bar > 1e-9 || fields.pressure > 0) << "on a bar, x = " << x;
    EXPECT_TRUE(from_bar <= 2 || fields.gap > 0) << "between bars, x = " << x;
  }
}
} // namespace orthocone::test
