// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Scenes on the axisymmetric body: known answers, the solid body, and the disc that output makes of it.
#include "results/scenes.h"

#include <orthocone/base/numbers.h>
#include <orthocone/results/step_checks.h>

namespace orthocone::test
{
namespace
{
Parameters axisymmetric_scene(const unsigned int degree)
{
  Parameters parameters = small_scene(degree);
  parameters.friction.mu = {{0.2, 0.2}};
  parameters.load.legs = {move_to(0, 0, -0.1, 1), move_to(0, 0, -0.06, 2)};
  return parameters;
}

void expect_uniform_pressure_and_force(const TestScene &scene)
{
  const double pressure = scene.parameters.material.young_modulus * 0.1 / scene.parameters.geometry.height;
  for (const ContactFields &fields : scene.evaluator.all_fields(scene.state))
    EXPECT_NEAR(fields.pressure, pressure, 1e-9 * pressure);
  const double radius = scene.parameters.geometry.radius;
  EXPECT_NEAR(scene.totals().force[2], pi * radius * radius * pressure, 1e-9 * scene.totals().force[2]);
}

Totals at_the_peak(Parameters parameters)
{
  parameters.load.legs = {move_to(0, 0, -0.1, 1)};
  TestScene scene(parameters);
  scene.march();
  return scene.totals();
}
} // namespace

TEST(Axisymmetric, PressureIsUniformWithoutFrictionOrLateralStrain)
{
  for (const unsigned int degree : {1, 2, 3, 4})
  {
    Parameters parameters = axisymmetric_scene(degree);
    parameters.mesh.rim_grading = 0.6;
    parameters.mesh.layer_grading = 0.7;
    parameters.load.legs = {move_to(0, 0, -0.1, 1)};
    parameters.geometry.top_face = TopFace::guided;
    parameters.friction.mu = {{1e-11, 1e-11}};
    TestScene guided(parameters);
    ASSERT_TRUE(guided.symmetry.is_axisymmetric());
    guided.march();
    expect_uniform_pressure_and_force(guided);
    const double lateral = parameters.material.poisson_ratio * 0.1 / parameters.geometry.height;
    for (unsigned int node = 0; node < guided.state.n_nodes(); ++node)
      EXPECT_NEAR(guided.evaluator.fields(guided.state, node).slip[0],
                  lateral * guided.discretization.contact_surface().nodes[node].position[0], 1e-9);
    parameters.geometry.top_face = TopFace::clamped;
    parameters.material.poisson_ratio = 0;
    parameters.friction.mu = {{0.2, 0.2}};
    TestScene clamped(parameters);
    clamped.march();
    expect_uniform_pressure_and_force(clamped);
  }
}

// Both are Galerkin solutions of the same scene in different spaces: they meet under refinement. (The stick
// area is that of whole nodes and rings, which differ by a node's size.)
TEST(Axisymmetric, AgreesWithTheSolidBodyUnderRefinement)
{
  double last_force = 1, last_slip = 1;
  for (const unsigned int n_cells : {2, 4})
  {
    Parameters parameters = axisymmetric_scene(3);
    parameters.contact_solver.tolerance = 1e-10;
    parameters.mesh.core_cells = parameters.mesh.rings = n_cells;
    parameters.mesh.layers = 2 * n_cells;
    parameters.mesh.rim_grading = parameters.mesh.layer_grading = 0.4;
    const Totals section = at_the_peak(parameters);
    parameters.mesh.model = ModelKind::quarter;
    const Totals solid = at_the_peak(parameters);
    const double force = std::abs(section.force[2] / solid.force[2] - 1);
    const double slip = std::abs(section.max_slip / solid.max_slip - 1);
    EXPECT_LT(force, last_force / 2);
    EXPECT_LT(slip, last_slip / 2);
    EXPECT_NEAR(section.total_dissipation / solid.total_dissipation, 1, 2e-3);
    last_force = force;
    last_slip = slip;
  }
  EXPECT_LT(last_force, 5e-5);
  EXPECT_LT(last_slip, 1e-3);
}

// Near the axis pressure is smooth; its node has a weight of its own there, which must do no harm.
TEST(Axisymmetric, PressureIsSmoothAtTheAxis)
{
  for (const unsigned int degree : {1, 2, 3, 4})
  {
    Parameters parameters = axisymmetric_scene(degree);
    parameters.load.legs = {move_to(0, 0, -0.1, 1)};
    parameters.mesh.core_cells = 8;
    parameters.mesh.layers = 6;
    TestScene scene(parameters);
    scene.march();
    const auto fields = scene.evaluator.all_fields(scene.state);
    EXPECT_LT(fields[0].slip.norm(), 1e-12); // of 0.1 mm
    EXPECT_EQ(fields[0].status, NodeStatus::stick);
    EXPECT_NEAR(fields[0].pressure / fields[1].pressure, 1, 0.02) << "degree " << degree;
  }
}

TEST(Axisymmetric, PassesAllChecksOverTheCycle)
{
  for (const unsigned int degree : {1, 2, 3, 4})
  {
    Parameters parameters = axisymmetric_scene(degree);
    parameters.load.legs = {move_to(0, 0, -0.1, 5), move_to(0, 0, 0, 10)};
    parameters.mesh.rim_grading = 0.6;
    TestScene scene(parameters);
    StepChecker checker(scene.scene, parameters.checks, parameters.contact_solver.tolerance);
    scene.march(
        [&](const ContactState &before, const ContactState &after, const LoadStep &step)
        {
          const Totals first = compute_totals(scene.evaluator, before);
          const Totals last = compute_totals(scene.evaluator, after);
          const StepChecks checks = checker.check({before, first}, {after, last}, {}, first.elastic_energy);
          EXPECT_FALSE(checker.violation(checks)) << "step " << step.number;
          EXPECT_LT(checks.equilibrium, 1e-10);
          EXPECT_LT(checks.energy_identity, 1e-12);
          EXPECT_EQ(last.force.head<2>().norm(), 0);
          EXPECT_EQ(last.n_open + last.n_stick + last.n_slip, after.n_nodes());
        });
    EXPECT_EQ(scene.totals().force.norm(), 0);
  }
}

TEST(Axisymmetric, TheWholeSurfaceIsTheDiscWithTheTotalForce)
{
  for (const unsigned int degree : {1, 2, 4})
  {
    TestScene scene(axisymmetric_scene(degree));
    scene.march();
    const ContactSurface &surface = scene.discretization.contact_surface();
    const WholeSurface whole = scene.symmetry.whole(surface);
    double area = 0;
    for (const auto &face : whole.faces)
    {
      std::vector<Eigen::Vector2d> points;
      for (const unsigned int number : face)
      {
        const auto &[node, image] = whole.nodes[number];
        const auto &place = surface.nodes[node].position;
        const Eigen::Vector2d point = whole.images[image] * Eigen::Vector2d(place[0], place[1]);
        const ContactFields fields = scene.evaluator.fields(scene.state, node);
        points.push_back(point);
        const Eigen::Vector2d slip = whole.images[image] * fields.slip.head<2>();
        EXPECT_LE(std::abs(point[0] * slip[1] - point[1] * slip[0]), 1e-15); // radial
      }
      const Eigen::Vector2d diagonal = points.back() - points.front();
      const Eigen::Vector2d across = points[points.size() - 1 - degree] - points[degree];
      const double part = 0.5 * (across[1] * diagonal[0] - across[0] * diagonal[1]);
      EXPECT_GT(part, 0); // anticlockwise
      area += part;
    }
    const double radius = scene.parameters.geometry.radius;
    const auto n = static_cast<double>(whole.images.size()) / degree;
    EXPECT_NEAR(area, 0.5 * n * radius * radius * std::sin(2 * pi / n), 1e-9 * area);
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    for (const auto &[node, image] : whole.nodes)
    {
      const Eigen::Vector3d part = scene.evaluator.fields(scene.state, node).nodal_force;
      force.head<2>() += whole.images[image] * part.head<2>();
      force[2] += part[2];
    }
    EXPECT_LE((force - scene.totals().force).norm(), 1e-12 * scene.totals().force.norm());
  }
}
} // namespace orthocone::test
