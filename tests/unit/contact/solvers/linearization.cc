// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The parts of the Newton solver, which are no public headers.
#include "contact/solvers/linearization.h"
#include "contact/contact_problems.h"
#include "surface/inner_compliance.h"
#include "surface/krylov.h"

#include <gtest/gtest.h>

#include <array>

namespace orthocone::test
{
using Eigen::Index;
using Eigen::MatrixXf;
using Eigen::VectorXf;

namespace
{
VectorXf itself(const VectorXf &x)
{
  return x;
}

/// The same grid in other units: forces `force` times and lengths `length` times as large.
std::pair<DenseCompliance, NodeVector> in_units(const GridProblem &grid, const double force,
                                                const double length)
{
  return {DenseCompliance(length / force * *grid.compliance.dense()), length * grid.problem.q()};
}
} // namespace

TEST(Gmres, SolvesUnsymmetricSystems)
{
  constexpr Index n = 40;
  MatrixXf matrix = MatrixXf::Identity(n, n);
  for (Index i = 0; i + 1 < n; ++i)
    matrix(i, i + 1) = 0.7F;
  const VectorXf solution = VectorXf::LinSpaced(n, -1, 2);
  const VectorXf found =
      solve_gmres({n, [&](const VectorXf &x) { return matrix * x; }, itself}, matrix * solution, 1e-5F, n);
  EXPECT_LT((found - solution).norm(), 1e-4F * solution.norm());
}

TEST(Gmres, NeedsOneIterationWithThePerfectPreconditioner)
{
  constexpr Index n = 30;
  const VectorXf diagonal = VectorXf::LinSpaced(n, 1, 1000);
  unsigned int n_products = 0;
  const auto apply = [&](const VectorXf &x) -> VectorXf
  {
    ++n_products;
    return diagonal.cwiseProduct(x);
  };
  const auto precondition = [&](const VectorXf &x) -> VectorXf { return x.cwiseQuotient(diagonal); };
  const VectorXf found = solve_gmres({n, apply, precondition}, VectorXf::Ones(n), 1e-3F, n);
  EXPECT_LT((diagonal.cwiseProduct(found) - VectorXf::Ones(n)).norm(), 1e-2F);
  EXPECT_LE(n_products, 3U);
}

TEST(Gmres, TakesASystemWithoutUnknowns)
{
  EXPECT_EQ(solve_gmres({0, itself, itself}, VectorXf(), 1e-3F, 10).size(), 0);
}

TEST(InnerCompliance, StiffnessOfAFewNodesIsTheInverse)
{
  const Eigen::MatrixXd w = grid_compliance(2);
  const InnerCompliance inner(DenseView(w.data(), w.rows(), w.cols()), 2.5);
  const VectorXf force = VectorXf::LinSpaced(w.rows(), -1, 3);
  EXPECT_LT((inner.multiply(force).cast<double>() - w * force.cast<double>() / 2.5).norm(), 1e-5);
  EXPECT_LT((inner.multiply_stiffness(inner.multiply(force)) - force).norm(), 1e-3F);
}

/// Also where it is asked for the same again, and for what is nearly the same.
TEST(DenseCompliance, AnswersWhatItIsAsked)
{
  const Eigen::MatrixXd w = grid_compliance(2);
  const DenseCompliance compliance(w);
  NodeVector force = NodeVector::LinSpaced(w.rows(), -1, 3), displacement;
  const auto error = [&]
  {
    compliance.vmult(displacement, force);
    return (displacement - w * force).norm();
  };
  EXPECT_LT(error(), 1e-14);
  force[1] += 1e-9;
  EXPECT_LT(error(), 1e-14);
  EXPECT_LT(error(), 1e-14);
}

/// Along Newton's direction the natural map falls at the rate at which it would vanish after one step.
TEST(Linearization, PointsToTheZeroOfTheLinearizedMap)
{
  for (const OrthotropicFriction &law : case_laws)
  {
    const GridProblem grid(law);
    const ContactStep &problem = grid.problem;
    const auto solver = grid.compliance.condition_solver(grid.system.softness());
    const NodeVector force = NodeVector::LinSpaced(grid.zero().size(), 0.3, 0.7);
    const NodeVector displacement = problem.displacement(force);
    const Linearization linearization = linearize(problem, force, displacement);
    const NodeVector map = problem.natural_map(force, displacement);
    EXPECT_NEAR(linearization.error, map.norm(), 1e-12 * map.norm());
    const NodeVector change = newton_change(*solver, linearization, 1e-6);
    constexpr double step = 1e-6;
    const NodeVector moved = force + step * change;
    const NodeVector slope = (problem.natural_map(moved, problem.displacement(moved)) - map) / step;
    EXPECT_LT((slope + map).norm(), 1e-3 * map.norm());
  }
}

/// Single precision inside must not tie the solver to units: forces in meganewton or piconewton, lengths in
/// metres or nanometres.
TEST(Linearization, KnowsNoUnits)
{
  const GridProblem grid(case_c);
  const ContactSolverOptions options = solver_options("newton");
  NodeVector expected = grid.zero();
  solve_step(grid.problem, options, expected);
  for (const double force : {1e-30, 1e30})
    for (const double length : {1e-20, 1e20})
    {
      const auto [compliance, free] = in_units(grid, force, length);
      const ContactSystem system(compliance, std::vector<OrthotropicFriction>(compliance.n_nodes(), case_c));
      const ContactStep problem(system, step_displacement(free, grid.zero()));
      NodeVector found = grid.zero();
      EXPECT_TRUE(solve_step(problem, options, found).converged);
      EXPECT_LT((found / force - expected).norm(), 1e-9 * expected.norm());
    }
}
} // namespace orthocone::test
