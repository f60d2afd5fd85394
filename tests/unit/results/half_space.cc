// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "results/scenes.h"

#include <orthocone/scene/half_space_obstacle.h>
#include <orthocone/surface/half_space.h>

#include <cmath>

namespace orthocone::test
{
namespace
{
/// A cylinder on a half-space of its own modulus times a factor, pressed, pushed aside and half released.
Parameters on_half_space(const double stiffness, const unsigned int degree = 2)
{
  Parameters parameters = small_scene(degree);
  parameters.obstacle.kind.choose<HalfSpaceKind>().half_space = {stiffness * 210000, 0.2};
  parameters.load.legs = {move_to(0, 0, -0.1, 2), move_to(0, 0, -0.05, 2)};
  return parameters;
}
} // namespace

TEST(HalfSpaceScene, ReducedModelsGiveTheAnswersOfTheFullOne)
{
  for (const unsigned int degree : {1, 2})
  {
    TestScene whole(with_model(on_half_space(1, degree), ModelKind::full));
    whole.march();
    for (const ModelKind model : {ModelKind::half, ModelKind::quarter})
    {
      TestScene part(with_model(on_half_space(1, degree), model));
      part.march();
      expect_same_fields(part, whole, closeness);
      EXPECT_NEAR(part.totals().elastic_energy / whole.totals().elastic_energy, 1, closeness);
      EXPECT_NEAR(part.totals().stick_area / whole.totals().stick_area, 1, closeness);
    }
  }
}

TEST(HalfSpaceScene, IsAPlaneWhereItIsAMillionTimesStiffer)
{
  TestScene soft(on_half_space(1)), stiff(on_half_space(1e6));
  Parameters parameters = on_half_space(1);
  parameters.obstacle.kind = ObstacleKind::rigid;
  TestScene rigid(with_model(parameters, ModelKind::quarter));
  for (TestScene *const scene : {&soft, &stiff, &rigid})
    scene->march();
  constexpr double close = 1e-5;
  EXPECT_LE(largest_difference(stiff.state.force, rigid.state.force), close);
  EXPECT_NEAR(stiff.totals().total_dissipation / rigid.totals().total_dissipation, 1, close);
  EXPECT_NEAR(stiff.totals().elastic_energy / rigid.totals().elastic_energy, 1, close);
  EXPECT_LT(soft.totals().force[2], 0.8 * rigid.totals().force[2]);
}

/// Hertz: F = 4/3 E* sqrt(R d^3) (Johnson, Contact Mechanics, 1985, (4.23)). Cells outside of the contact are
/// eight times as large as those in it, and nothing may press there.
TEST(HalfSpaceScene, CarriesHertzOverAnAbruptlyGradedMesh)
{
  constexpr double radius = 120, approach = 0.003, modulus = 80000, nu = 0.4999;
  Parameters parameters;
  parameters.mesh.core_cells = 16;
  parameters.mesh.core_ratio = 0.085;
  parameters.mesh.rings = 3;
  parameters.mesh.rim_grading = 2.5;
  parameters.mesh.layers = 2;
  parameters.mesh.degree = 1;
  parameters.material = {};
  parameters.material.young_modulus = 1e12;
  parameters.material.poisson_ratio = 0;
  parameters.friction.mu = {{0, 0}};
  parameters.obstacle.kind.choose<HalfSpaceKind>().half_space = {modulus, nu};
  parameters.obstacle.gap = "(x^2+y^2)/240";
  parameters.load.legs = {move_to(0, 0, -approach, 1)};
  TestScene scene(with_model(parameters, ModelKind::quarter));
  scene.march();
  const double force = 4. / 3 * modulus / (1 - nu * nu) * std::sqrt(radius * approach * approach * approach);
  EXPECT_NEAR(scene.totals().force[2] / force, 1, 0.01);
}

TEST(HalfSpaceScene, HasASumOfCompliances)
{
  const Parameters parameters = on_half_space(2);
  const Scene scene(parameters, choose_model(parameters));
  EXPECT_EQ(scene.symmetry().name(), "quarter");
  const Eigen::MatrixXd own =
      half_space_compliance({420000, 0.2}, scene.surface(), scene.symmetry(), scene.axes());
  const DenseView &body = *scene.body().compliance().dense();
  EXPECT_EQ((*scene.compliance().dense() - (own + body)).lpNorm<Eigen::Infinity>(), 0);
  const NodeVector force = NodeVector::LinSpaced(own.rows(), 1, 2);
  EXPECT_LE((scene.given_way(force) - own * force).norm(), 1e-12 * (own * force).norm());
}

TEST(HalfSpaceScene, PassesTheChecksOfEveryStep)
{
  for (const BodyBackend backend : {BodyBackend::condensed, BodyBackend::multigrid})
  {
    Parameters parameters = on_half_space(0.5);
    parameters.mesh.backend = backend;
    TestScene scene(parameters);
    expect_checked_steps(scene);
  }
}

/// The body by V-cycles and the half-space by a hierarchical matrix: pressed, pushed by a force, let go.
TEST(HalfSpaceScene, IsThatOfTheCondensedBodyWithMultigrid)
{
  Parameters parameters = on_half_space(1);
  parameters.mesh.refinements = 1;
  parameters.contact_solver.tolerance = 1e-9;
  parameters.load.legs = {move_to(0, 0, -0.1, 1),
                          Leg{{{Drive{true, 300}, Drive{false, 0}, Drive{false, -0.1}}}, 1},
                          move_to(0, 0, -0.05, 1)};
  parameters.mesh.backend = BodyBackend::condensed;
  TestScene condensed(parameters);
  parameters.mesh.backend = BodyBackend::multigrid;
  TestScene multigrid(parameters);
  for (TestScene *const scene : {&condensed, &multigrid})
    scene->march();
  const double close = 10 * parameters.contact_solver.tolerance;
  EXPECT_LE(largest_difference(multigrid.state.force, condensed.state.force), close);
  EXPECT_NEAR(multigrid.totals().total_dissipation / condensed.totals().total_dissipation, 1, close);
  EXPECT_NEAR(multigrid.totals().elastic_energy / condensed.totals().elastic_energy, 1, close);
  EXPECT_NEAR(multigrid.totals().stick_area / condensed.totals().stick_area, 1, close);
}
} // namespace orthocone::test
