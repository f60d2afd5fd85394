// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The revolved section with twist: closed forms of torsion, and the solid body.
#include "results/scenes.h"

#include <orthocone/base/numbers.h>
#include <orthocone/results/step_checks.h>

namespace orthocone::test
{
namespace
{
constexpr unsigned int about_z = 5;

Leg turned_by(const double value, const bool by_force, const unsigned int steps)
{
  Leg leg;
  leg.targets[about_z] = Drive{by_force, value};
  leg.steps = steps;
  return leg;
}

/// A cylinder of isotropic friction, pressed and turned by `degrees`.
Parameters twisted(const unsigned int degree, const double degrees)
{
  Parameters parameters = small_scene(degree);
  parameters.friction.mu = {{0.2, 0.2}};
  parameters.contact_solver.tolerance = 1e-11;
  parameters.load.legs = {move_to(0, 0, -0.1, 1), turned_by(degrees, false, 2)};
  return parameters;
}

Totals after_march(const Parameters &parameters)
{
  TestScene scene(parameters);
  expect_checked_steps(scene);
  return scene.totals();
}

/// The differences of section and solid, relative to the solid: moment, largest slip, dissipated energy.
std::array<double, 3> difference_to_solid(Parameters parameters, const ModelKind solid)
{
  EXPECT_EQ(choose_model(parameters).symmetry.full_name(), "axisymmetric with twist");
  const Totals section = after_march(parameters);
  parameters.mesh.model = solid;
  const Totals whole = after_march(parameters);
  return {{std::abs(section.moment[2] / whole.moment[2] - 1), std::abs(section.max_slip / whole.max_slip - 1),
           std::abs(section.total_dissipation / whole.total_dissipation - 1)}};
}

Parameters with_cells(Parameters parameters, const unsigned int n)
{
  parameters.mesh.core_cells = parameters.mesh.rings = n;
  parameters.mesh.layers = 2 * n;
  parameters.mesh.rim_grading = parameters.mesh.layer_grading = 0.5;
  return parameters;
}
} // namespace

// Without lateral contraction and slip the section twists like a bar: traction G theta r / H, moment G J
// theta / H with J = pi R^4 / 2. A moment drives it back half of the way.
TEST(Torsion, OfAStuckShaftIsThatOfABar)
{
  constexpr double degrees = 0.5;
  for (const unsigned int degree : {1, 2, 3, 4})
  {
    Parameters parameters = twisted(degree, degrees);
    parameters.friction.mu = {{5, 5}};
    parameters.material.poisson_ratio = 0;
    const double radius = parameters.geometry.radius, height = parameters.geometry.height;
    const double rate = parameters.material.young_modulus / 2 * degrees * pi / 180 / height;
    const double moment = rate * pi * std::pow(radius, 4) / 2;
    TestScene scene(parameters);
    scene.march();
    EXPECT_NEAR(scene.totals().moment[2], -moment, 1e-9 * moment);
    EXPECT_EQ(scene.totals().force.head<2>().norm() + scene.totals().moment.head<2>().norm(), 0);
    EXPECT_NEAR(scene.scene.held_wrench(scene.state.force, scene.state.motion)[about_z], moment,
                1e-9 * moment);
    const auto &nodes = scene.discretization.contact_surface().nodes;
    for (unsigned int node = 0; degree >= 3 && node < nodes.size(); ++node) // weights that integrate r^2 N
      EXPECT_NEAR(scene.evaluator.fields(scene.state, node).friction_traction[1],
                  -rate * nodes[node].position[0], 1e-8 * rate * radius);
    parameters.load.legs.push_back(turned_by(moment / 2, true, 1));
    TestScene back(parameters);
    back.march();
    EXPECT_NEAR(back.state.motion[about_z], degrees * pi / 360, 1e-9);
  }
}

// Both are Galerkin solutions of the same scene in different spaces: they meet under refinement.
TEST(Torsion, AgreesWithTheSolidBodyUnderRefinement)
{
  std::array<double, 3> before{{1, 1, 1}};
  for (const unsigned int n : {2, 4})
  {
    const auto difference = difference_to_solid(with_cells(twisted(2, 0.2), n), ModelKind::full);
    for (const unsigned int i : {0, 1}) // that of the dissipation changes its sign
      EXPECT_LT(difference[i], before[i] / 2) << "number " << i << ", cells " << n;
    before = difference;
  }
  EXPECT_LT(before[0], 1e-3);
  EXPECT_LT(before[2], 1e-2);
}

// Spirals turn what is only pressed.
TEST(Torsion, FollowsFromAxesOfFrictionThatAreSpirals)
{
  Parameters parameters = with_cells(small_scene(2), 4);
  parameters.friction.mu = {{0.3, 0.1}};
  parameters.friction.varying_angle = Expression("atan2(y,x)*180/pi+30");
  parameters.contact_solver.tolerance = 1e-11;
  parameters.load.legs = {move_to(0, 0, -0.1, 2)};
  const auto difference = difference_to_solid(parameters, ModelKind::full);
  EXPECT_GT(std::abs(after_march(parameters).moment[2]), 1e3);
  EXPECT_LT(difference[0], 1e-2);
}
} // namespace orthocone::test
