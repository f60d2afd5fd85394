// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/accuracy/adaptive_mesh.h>
#include <orthocone/accuracy/first_cycle.h>
#include <orthocone/accuracy/mesh_search.h>
#include <orthocone/body/shapes/mesh_ladder.h>
#include <orthocone/scene/parameters.h>

#include "body/even_mesh.h"

#include <gtest/gtest.h>

namespace orthocone::test
{
namespace
{
constexpr double enough = 1000; // GB

/// The paper's case A, pressed and half released, on few cells.
Parameters coarse_case_a(const ModelKind model, const unsigned int rounds)
{
  Parameters parameters;
  parameters.friction.mu = {{0.2, 0.2}};
  parameters.load.legs = {move_to(0, 0, -0.1, 2), move_to(0, 0, -0.05, 2)};
  parameters.mesh = even_mesh(2, 0);
  parameters.mesh.model = model;
  parameters.mesh.adaptive = rounds;
  return parameters;
}

Quantities quantities_of(const Parameters &parameters)
{
  const Scene scene(parameters, choose_model(parameters));
  StepSolver solver(scene);
  return march_first_cycle(scene, parameters.load, solver, "").quantities;
}

double slip_error(const Parameters &parameters, const double truth)
{
  return std::abs(quantities_of(parameters)[0] / truth - 1);
}

void say_nothing(const std::string &) {}
} // namespace

/// Singular edges: rounds that halve few cells gain what halving all of them gains, with far fewer unknowns.
TEST(AdaptiveMesh, ReachesWhatEvenCellsReachWithFewerUnknowns)
{
  for (const ModelKind model : {ModelKind::axisymmetric, ModelKind::quarter})
  {
    Parameters reference = coarse_case_a(ModelKind::axisymmetric, 0);
    reference.mesh = ladder_mesh({}, reference.mesh, true, 6);
    const double truth = quantities_of(reference)[0];
    const Parameters adaptive = coarse_case_a(model, 2);
    const ModelChoice choice = choose_model(adaptive);
    Parameters adapted = adaptive, even = adaptive;
    adapted.mesh = adapted_mesh(adaptive, choice, say_nothing, enough);
    even.mesh.adaptive = 0;
    const double base_error = slip_error(even, truth);
    even.mesh.refinements = 2;
    EXPECT_EQ(adapted.mesh.adaptive, 0U);
    EXPECT_EQ(adapted.mesh.refined_cells.size(), 2U);
    EXPECT_LT(Body(adapted, choice.symmetry).unknowns().n_dofs(),
              0.8 * Body(even, choice.symmetry).unknowns().n_dofs());
    EXPECT_LT(slip_error(adapted, truth), 1.1 * slip_error(even, truth));
    EXPECT_LT(slip_error(adapted, truth), 0.4 * base_error);
  }
}

/// What Adaptive chooses stands in entries that mean the same mesh again.
TEST(AdaptiveMesh, StandsInTheParameters)
{
  const Parameters adaptive = coarse_case_a(ModelKind::axisymmetric, 3);
  const ModelChoice choice = choose_model(adaptive);
  const ChosenModel chosen = choose_mesh_and_steps(adaptive, choice, say_nothing);
  EXPECT_EQ(chosen.given.mesh.adaptive, 3U);
  EXPECT_EQ(chosen.parameters.mesh.refined_cells.size(), 3U);
  const Parameters again = with_section(adaptive, "Mesh", entry_values(chosen.parameters));
  EXPECT_EQ(again.mesh.adaptive, 0U);
  const Body first(chosen.parameters, choice.symmetry), second(again, choice.symmetry);
  ASSERT_EQ(first.unknowns().n_dofs(), second.unknowns().n_dofs());
  for (unsigned int dof = 0; dof < first.unknowns().n_dofs(); ++dof)
    EXPECT_EQ(first.unknowns().position(dof), second.unknowns().position(dof));
}

TEST(AdaptiveMesh, EndsWhereMemoryDoes)
{
  const Parameters adaptive = coarse_case_a(ModelKind::axisymmetric, 3);
  std::string reported;
  const MeshOptions mesh = adapted_mesh(
      adaptive, choose_model(adaptive), [&](const std::string &line) { reported += line + "\n"; }, 1e-3);
  EXPECT_TRUE(mesh.refined_cells.empty());
  EXPECT_NE(reported.find("would need more memory"), std::string::npos) << reported;
}
} // namespace orthocone::test
