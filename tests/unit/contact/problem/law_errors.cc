// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "contact/contact_problems.h"
#include "contact/laws.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace orthocone::test
{
namespace
{
using Eigen::Index;
using Eigen::Vector2d;

constexpr OrthotropicFriction case_c_law{0.3, 0.15, 0.05, 0.2};

/// A solved problem, whose forces and displacements can be spoiled one at a time.
struct SolvedGrid : GridProblem
{
  SolvedGrid()
      : GridProblem(case_c_law),
        force(zero())
  {
    EXPECT_TRUE(solve_step(problem, solver_options("newton", 1e-13), force).converged);
    displacement = problem.displacement(force);
    NodeVector elastic;
    compliance.vmult(elastic, force);
    for (Index node = 0; node < problem.n_nodes(); ++node)
    {
      length = std::max({length, elastic.segment<3>(3 * node).norm(), -problem.q()[3 * node]});
      slip = std::max(slip, force[3 * node] > 0 ? displacement.segment<2>(3 * node + 1).norm() : 0);
      strength = std::max(strength, force.segment<3>(3 * node).norm());
    }
    slip = std::max(slip, length);
    strength = std::max(strength, length / problem.system().softness());
  }

  LawErrors errors() const { return law_errors(problem, force, displacement); }

  Index first(const NodeStatus status) const
  {
    for (Index node = 0; node < problem.n_nodes(); ++node)
      if (problem.statuses(force, displacement)[node] == status)
        return 3 * node;
    ADD_FAILURE() << "the problem has no node of the status wanted";
    return 0;
  }

  NodeVector force;
  NodeVector displacement;
  double length = 0;
  double slip = 0;
  double strength = 0;
};
} // namespace

TEST(LawErrors, VanishAtASolution)
{
  const LawErrors errors = SolvedGrid().errors();
  for (const double error :
       {errors.penetration, errors.complementarity, errors.friction_cone, errors.slip_rule})
    EXPECT_LE(error, 1e-11);
}

TEST(LawErrors, MeasureAPenetration)
{
  SolvedGrid grid;
  grid.displacement[grid.first(NodeStatus::slip)] = -1e-3;
  EXPECT_NEAR(grid.errors().penetration, 1e-3 / grid.length, 1e-9);
  EXPECT_NEAR(grid.errors().complementarity, 1e-3 / grid.length, 1e-9);
}

TEST(LawErrors, MeasureAForceInTheAirAndTension)
{
  SolvedGrid grid;
  const Index open = grid.first(NodeStatus::open);
  grid.displacement[open] = 0.01; // far more than the force allows
  grid.force[open] = 1e-4;
  EXPECT_NEAR(grid.errors().complementarity, 1e-4 / grid.strength, 1e-9);
  EXPECT_LE(grid.errors().penetration, 1e-11);
  grid.force[open] = -1e-4;
  EXPECT_NEAR(grid.errors().complementarity, 1e-4 / grid.strength, 1e-9);
}

TEST(LawErrors, MeasureAForceOutsideTheCone)
{
  SolvedGrid grid;
  const Index slipping = grid.first(NodeStatus::slip);
  grid.force.segment<2>(slipping + 1) *= 1.01;
  EXPECT_NEAR(grid.errors().friction_cone, 0.01 * grid.force[slipping] / grid.strength, 1e-9);
  grid.force.segment<2>(slipping + 1) *= 0.98; // inside is allowed by the cone, but not for a node that slips
  EXPECT_LE(grid.errors().friction_cone, 1e-11);
  EXPECT_GT(grid.errors().slip_rule, 1e-6);
}

TEST(LawErrors, MeasureASlipThatTheRuleForbids)
{
  const SolvedGrid solved;
  const Index slipping = solved.first(NodeStatus::slip);
  const double weight = case_c_law.mu_y * solved.force[slipping] / solved.strength;
  const Vector2d slip = solved.displacement.segment<2>(slipping + 1);
  for (const double angle : {1e-4, -1e-3, 0.1})
  {
    SolvedGrid turned;
    turned.displacement.segment<2>(slipping + 1) = Eigen::Rotation2Dd(angle) * slip;
    EXPECT_NEAR(turned.errors().slip_rule, weight * slip.norm() * std::sin(std::abs(angle)) / solved.slip,
                1e-9);
  }
  SolvedGrid reversed;
  reversed.displacement.segment<2>(slipping + 1) = -slip;
  EXPECT_NEAR(reversed.errors().slip_rule, weight * slip.norm() / solved.slip, 1e-9);
  SolvedGrid moved;
  const Index sticking = moved.first(NodeStatus::stick);
  moved.displacement[sticking + 1] += 1e-3;
  EXPECT_GT(moved.errors().slip_rule, 0);
}

TEST(LawErrors, AreNoNumbersIfTheForcesAreNone)
{
  SolvedGrid grid;
  grid.force[4] = std::numeric_limits<double>::quiet_NaN();
  LawErrors errors;
  errors.merge(grid.errors());
  errors.merge(LawErrors{});
  for (const double error :
       {errors.penetration, errors.complementarity, errors.friction_cone, errors.slip_rule})
    EXPECT_TRUE(std::isnan(error));
}
} // namespace orthocone::test
