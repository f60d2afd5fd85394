// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The parts of the Newton solver, which are no public headers.
#include "contact/solvers/newton/linearization.h"
#include "contact/contact_problems.h"
#include "surface/direct_conditions.h"
#include "surface/inner_compliance.h"
#include "surface/krylov.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <array>
#include <limits>

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
  const LinearMap map{n, [&](const VectorXf &x) { return matrix * x; }, itself};
  const KrylovSolution found = solve_gmres(map, matrix * solution, 1e-5F, n);
  EXPECT_TRUE(found.converged);
  EXPECT_LT((found.unknowns - solution).norm(), 1e-4F * solution.norm());
  EXPECT_FALSE(solve_gmres(map, matrix * solution, 1e-5F, 3).converged);
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
  const VectorXf found = solve_gmres({n, apply, precondition}, VectorXf::Ones(n), 1e-3F, n).unknowns;
  EXPECT_LT((diagonal.cwiseProduct(found) - VectorXf::Ones(n)).norm(), 1e-2F);
  EXPECT_LE(n_products, 3U);
}

TEST(Gmres, TakesASystemWithoutUnknowns)
{
  EXPECT_EQ(solve_gmres({0, itself, itself}, VectorXf(), 1e-3F, 10).unknowns.size(), 0);
}

TEST(InnerCompliance, StiffnessOfAFewNodesIsTheInverse)
{
  const Eigen::MatrixXd w = grid_compliance(2);
  const InnerCompliance inner(DenseView(w.data(), w.rows(), w.cols()), 2.5);
  const VectorXf force = VectorXf::LinSpaced(w.rows(), -1, 3);
  EXPECT_LT((inner.multiply(force).cast<double>() - w * force.cast<double>() / 2.5).norm(), 1e-5);
  EXPECT_LT((inner.multiply_stiffness(inner.multiply(force)) - force).norm(), 1e-3F);
}

/// Entries of 16 bits hide the stiff modes of a body that gives way in one direction ten thousand times less
/// than in the others: with them, inner iterations would work with a matrix that is not positive definite.
TEST(InnerCompliance, IsPositiveDefiniteWhereDirectionsDifferTenThousandfold)
{
  Eigen::MatrixXd w = grid_compliance(13); // 507 rows
  for (const double stiff : {1.0, 1e-2})
  {
    for (Index node = 0; node < w.rows() / 3; ++node)
    {
      w.row(3 * node + 2) *= stiff;
      w.col(3 * node + 2) *= stiff;
    }
    const DenseView view(w.data(), w.rows(), w.cols());
    const InnerCompliance inner(view, w.diagonal().maxCoeff());
    EXPECT_EQ(inner.is_rounded(), stiff == 1.0);
    MatrixXf used(w.rows(), w.cols());
    for (Index column = 0; column < w.cols(); ++column)
      used.col(column) = inner.multiply(VectorXf::Unit(w.cols(), column));
    const Eigen::SelfAdjointEigenSolver<MatrixXf> modes(used, Eigen::EigenvaluesOnly);
    EXPECT_GT(modes.eigenvalues().minCoeff(), 0);
  }
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

/// Too little force, so that nodes penetrate, stick, slip in all directions and are open.
NodeVector weak_force(const GridProblem &grid)
{
  NodeVector force = grid.zero();
  solve_step(grid.problem, solver_options("gauss-seidel"), force);
  return 0.8 * force;
}

/// Few unknowns are eliminated, many are left to GMRES.
constexpr std::array<Index, 2> grid_sizes{{5, 8}};

/// Along Newton's direction a map falls at the rate at which it would vanish after one step.
TEST(Linearization, PointsToTheZeroOfTheLinearizedMap)
{
  for (const auto map : {linearize, linearize_on_elliptic_cone})
    for (const OrthotropicFriction &law : case_laws)
      for (const Index size : grid_sizes)
      {
        const GridProblem grid(law, size);
        const ContactStep &problem = grid.problem;
        const auto solver = grid.compliance.condition_solver(grid.system.softness());
        const NodeVector force = weak_force(grid);
        const Linearization linearization = map(problem, force, problem.displacement(force), 1);
        const NodeVector change = newton_change(*solver, linearization, 1e-6);
        constexpr double step = 1e-6;
        const NodeVector moved = force + step * change;
        const double error = map(problem, moved, problem.displacement(moved), 1).error;
        EXPECT_NEAR((linearization.error - error) / step, linearization.error, 1e-3 * linearization.error);
      }
}

TEST(Linearization, HasTheErrorOfTheNaturalMap)
{
  const GridProblem grid(case_c);
  const NodeVector force = NodeVector::LinSpaced(grid.zero().size(), 0.3, 0.7);
  const NodeVector displacement = grid.problem.displacement(force);
  const double error = grid.problem.natural_map(force, displacement).norm();
  EXPECT_NEAR(linearize(grid.problem, force, displacement).error, error, 1e-12 * error);
}

/// It asks for the law, at nodes that stick, slip and are open.
TEST(Linearization, VanishesAtTheSolution)
{
  for (const OrthotropicFriction &law : case_laws)
  {
    const GridProblem grid(law);
    NodeVector force = grid.zero();
    solve_step(grid.problem, solver_options("gauss-seidel", 1e-13), force);
    const NodeVector displacement = grid.problem.displacement(force);
    for (const auto map : {linearize, linearize_on_elliptic_cone})
    {
      EXPECT_LT(map(grid.problem, force, displacement, 1).error, 1e-10 * force.norm());
      const NodeVector other = 1.1 * force;
      const NodeVector moved = grid.problem.displacement(other);
      EXPECT_GT(map(grid.problem, other, moved, 1).error, 1e-3 * force.norm());
    }
  }
}

void expect_met(const ContactConditions &conditions, const DenseView &w, const ContactChange &change)
{
  NodeVector moved = w * change.force;
  if (conditions.face.cols() > 0)
    moved += conditions.face * change.face;
  for (std::size_t i = 0; i < conditions.nodes.size(); ++i)
  {
    const NodeCondition &node = conditions.nodes[i];
    const auto place = static_cast<Index>(3 * i);
    const Index n = node.n_unknowns;
    const Eigen::Vector3d free = change.force.segment<3>(place) - node.fixed;
    if (n == 0)
    {
      EXPECT_LT(free.norm(), 1e-12);
      continue;
    }
    const Eigen::VectorXd x = node.basis.leftCols(n).colPivHouseholderQr().solve(free);
    EXPECT_LT((node.basis.leftCols(n) * x - free).norm(), 1e-12);
    const Eigen::VectorXd left =
        node.rows.leftCols(n).transpose() * moved.segment<3>(place) + node.diagonal.head(n).cwiseProduct(x);
    EXPECT_LT((left - node.right_side.head(n)).norm(), 1e-12);
  }
}

/// Nodes that stick, slip and are open, one of them with a force that is given, and a face that moves.
TEST(DirectConditions, AreMet)
{
  const GridProblem grid(case_c);
  const DenseView &w = *grid.compliance.dense();
  const NodeVector force = weak_force(grid);
  ContactConditions conditions = linearize(grid.problem, force, grid.problem.displacement(force)).conditions;
  conditions.nodes[3] = {};
  conditions.nodes[3].fixed << 0.2, 0.1, -0.1;
  conditions.face = NodeVector::LinSpaced(w.rows(), 1, 2).normalized();
  conditions.face_right_side = Eigen::VectorXd::Constant(1, 0.5);
  const auto change = solve_directly(conditions, w, grid.system.softness());
  ASSERT_TRUE(change.has_value());
  expect_met(conditions, w, *change);
  EXPECT_NEAR(conditions.face.col(0).dot(change->force), 0.5, 1e-12);
}

/// More unknowns than elsewhere are no obstacle where no node slips.
TEST(DirectConditions, AreMetWhereAllNodesStickOrAreOpen)
{
  const GridProblem grid(case_c, 8);
  const DenseView &w = *grid.compliance.dense();
  ContactConditions conditions{{}, Eigen::MatrixXd(w.rows(), 0), {}};
  for (Index i = 0; i < w.rows() / 3; ++i)
  {
    NodeCondition node;
    node.fixed << 0.1, 0.02 * static_cast<double>(i % 3), -0.2;
    if (i % 5 != 0)
    {
      node.n_unknowns = 3;
      node.basis.setIdentity();
      node.rows << 2, 0.3, 0, 0.1, 1.5, 0, 0, 0.2, 1;
      node.right_side << 0.4, -0.1, 0.05 * static_cast<double>(i % 7);
    }
    conditions.nodes.push_back(node);
  }
  const auto change = solve_directly(conditions, w, grid.system.softness());
  ASSERT_TRUE(change.has_value());
  expect_met(conditions, w, *change);
}

/// Such systems, and those with many unknowns, are left to GMRES.
TEST(DirectConditions, AreNotSolvedWhereTheyAreSingular)
{
  const Eigen::MatrixXd one_body = Eigen::MatrixXd::Ones(75, 75);
  const GridProblem grid(case_a), large(case_a, 8);
  const auto conditions = [](const GridProblem &of)
  {
    const NodeVector force = weak_force(of);
    return linearize(of.problem, force, of.problem.displacement(force)).conditions;
  };
  EXPECT_FALSE(solve_directly(conditions(grid), DenseView(one_body.data(), 75, 75), 75).has_value());
  EXPECT_TRUE(solve_directly(conditions(grid), *grid.compliance.dense(), 1).has_value());
  EXPECT_FALSE(solve_directly(conditions(large), *large.compliance.dense(), 1).has_value());
  ContactConditions infinite = conditions(grid);
  infinite.nodes[12].n_unknowns = 2;
  infinite.nodes[12].rows(0, 0) = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(solve_directly(infinite, *grid.compliance.dense(), 1).has_value());
}

TEST(LargestEigenvalue, IsFoundFromBelow)
{
  for (const Index n : {1, 2, 5, 12})
  {
    const DenseCompliance compliance(grid_compliance(n));
    const Eigen::MatrixXd w = *compliance.dense();
    const double exact = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(w).eigenvalues().maxCoeff();
    EXPECT_LE(compliance.softness(), exact * (1 + 1e-12));
    EXPECT_GE(compliance.softness(), exact * (1 - 1e-3));
  }
}

/// Single precision inside must not tie the solver to units: forces in meganewton or piconewton, lengths in
/// metres or nanometres.
TEST(Linearization, KnowsNoUnits)
{
  for (const Index size : grid_sizes)
  {
    const GridProblem grid(case_c, size);
    const ContactSolverOptions options = solver_options("newton");
    NodeVector expected = grid.zero();
    solve_step(grid.problem, options, expected);
    for (const double force : {1e-30, 1e30})
      for (const double length : {1e-20, 1e20})
      {
        const auto [compliance, free] = in_units(grid, force, length);
        const ContactSystem system(compliance, FrictionLaws(compliance.n_nodes(), case_c));
        const ContactStep problem(system, step_displacement(free, grid.zero()));
        NodeVector found = grid.zero();
        EXPECT_TRUE(solve_step(problem, options, found).converged);
        EXPECT_LT((found / force - expected).norm(), 1e-9 * expected.norm());
      }
  }
}
} // namespace orthocone::test
