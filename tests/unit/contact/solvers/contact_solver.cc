// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "contact/contact_problems.h"

#include <orthocone/contact/solvers/contact_method.h>

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <set>
#include <stdexcept>

namespace orthocone::test
{
using Eigen::Index;
using Eigen::Vector3d;

namespace
{
NodeVector solve(const ContactStep &problem, const ContactSolverOptions &options)
{
  NodeVector force = NodeVector::Zero(3 * problem.n_nodes());
  const SolverReport report = solve_step(problem, options, force);
  EXPECT_TRUE(report.converged) << report.residual;
  EXPECT_LE(problem.residual(force), options.tolerance);
  return force;
}

/// The law, checked node by node in its own words instead of by the natural map.
void expect_law(const ContactStep &problem, const NodeVector &force, const double tolerance)
{
  const NodeVector d = problem.displacement(force);
  for (Index node = 0; node < problem.n_nodes(); ++node)
  {
    const OrthotropicFriction &law = *problem.law(node).ellipse();
    const Vector3d r = force.segment<3>(3 * node);
    const Vector3d u = d.segment<3>(3 * node);
    EXPECT_GE(u[0], -tolerance);
    EXPECT_GE(r[0], 0);
    EXPECT_NEAR(r[0] * u[0], 0, tolerance);
    const double criterion = friction_norm(law, r[1], r[2]) - r[0];
    EXPECT_LE(criterion, tolerance);
    if (criterion < -1e-6)
    {
      EXPECT_LE(u.tail<2>().norm(), tolerance);
    }
    else if (r[0] > 1e-6)
    {
      const Eigen::Vector2d slip = slip_direction(law, r[1], r[2]).normalized();
      EXPECT_NEAR(slip[0] * u[2] - slip[1] * u[1], 0, tolerance);
      EXPECT_GE(slip.dot(u.tail<2>()), -tolerance);
    }
    EXPECT_LE(r.tail<2>().dot(u.tail<2>()), tolerance); // friction never drives
  }
}
} // namespace

class EverySolver : public testing::TestWithParam<std::string>
{
};

// feng2006 is left to its own test: it need not converge.
INSTANTIATE_TEST_SUITE_P(Methods, EverySolver, testing::Values("newton", "gauss-seidel", "uzawa"));

TEST_P(EverySolver, ObeysTheLaw)
{
  for (const OrthotropicFriction &law : case_laws)
    for (const double push : {0.05, 1., 20.})
    {
      const GridProblem grid(law, 5, push);
      expect_law(grid.problem, solve(grid.problem, solver_options(GetParam())), 1e-8);
    }
}

TEST_P(EverySolver, GivesTheForcesOfTheSweeps)
{
  for (const OrthotropicFriction &law : case_laws)
  {
    const GridProblem grid(law);
    const NodeVector expected = solve(grid.problem, solver_options("gauss-seidel", 1e-13));
    const NodeVector force = solve(grid.problem, solver_options(GetParam()));
    EXPECT_LE((force - expected).norm(), 1e-8 * expected.norm());
  }
}

TEST_P(EverySolver, StopsAtOnceAtTheSolution)
{
  const GridProblem grid(case_b);
  NodeVector force = solve(grid.problem, solver_options(GetParam()));
  EXPECT_EQ(solve_step(grid.problem, solver_options(GetParam()), force).iterations, 0u);
}

TEST_P(EverySolver, TakesNoForceForAnAnswer)
{
  GridProblem grid(case_b);
  const NodeVector zero = grid.zero();
  grid.problem = ContactStep(grid.system, zero);
  EXPECT_EQ(solve(grid.problem, solver_options(GetParam())).norm(), 0);
  NodeVector apart = zero;
  for (Index node = 0; node < grid.problem.n_nodes(); ++node)
    apart[3 * node] = 1;
  grid.problem = ContactStep(grid.system, apart);
  EXPECT_EQ(solve(grid.problem, solver_options(GetParam())).norm(), 0);
}

TEST_P(EverySolver, ReportsWhatItCouldNotDo)
{
  const GridProblem grid(case_c);
  ContactSolverOptions options = solver_options(GetParam());
  options.maximum_iterations = 3;
  NodeVector force = grid.zero();
  const SolverReport report = solve_step(grid.problem, options, force);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.iterations, 3u);
  EXPECT_DOUBLE_EQ(report.residual, grid.problem.residual(force));
}

// With r = D r', D = diag(1, mu_x, mu_y), the orthotropic problem is an isotropic one with mu = 1 and the
// compliance D C W D, C = diag(1, (p_x/mu_x)^2, (p_y/mu_y)^2): symmetric only if the slip rule is associated.
TEST(ScalingMap, TurnsOrthotropicFrictionIntoIsotropic)
{
  const GridProblem grid(case_b);
  const NodeVector expected = solve(grid.problem, solver_options("gauss-seidel", 1e-13));
  const NodeVector d = Vector3d(1, case_b.mu_x, case_b.mu_y).replicate(grid.problem.n_nodes(), 1);
  const DenseCompliance scaled(d.asDiagonal() * *grid.compliance.dense() * d.asDiagonal());
  const ContactSystem isotropic_system(scaled,
                                       FrictionLaws(grid.problem.n_nodes(), OrthotropicFriction{1, 1, 1, 1}));
  const ContactStep isotropic(isotropic_system,
                              step_displacement(d.cwiseProduct(grid.problem.q()), grid.zero()));
  const NodeVector force = solve(isotropic, solver_options("newton"));
  EXPECT_LE((d.cwiseProduct(force) - expected).norm(), 1e-8 * expected.norm());
}

TEST(ScalingMap, HoldsForTheUnsymmetricOperatorOfNonAssociatedSlip)
{
  const GridProblem grid(case_c);
  const NodeVector expected = solve(grid.problem, solver_options("gauss-seidel", 1e-13));
  const OrthotropicFriction circular{1, 1, 1, 1};
  const Eigen::Vector2d weights = slip_weights(normalized(case_c));
  const Vector3d d(1, case_c.mu_x, case_c.mu_y);
  const Vector3d dc(1, case_c.mu_x * weights[0], case_c.mu_y * weights[1]);
  const NodeVector u = grid.problem.displacement(expected);
  for (Index node = 0; node < grid.problem.n_nodes(); ++node)
  {
    const Vector3d r = expected.segment<3>(3 * node).cwiseQuotient(d);
    const Vector3d v = modified_displacement(circular, u.segment<3>(3 * node).cwiseProduct(dc));
    EXPECT_LE((r - project(circular, r - v)).norm(), 1e-9);
  }
}

// The paper's Box 3 takes rho = 1 / min(w): for a stuck node with w_max / w_min > 2 each iteration overshoots
// by more than it gains.
TEST(Feng2006, FailsWhereRhoTimesTheLargestComplianceExceedsTwo)
{
  for (const double ratio : {1.5, 2.5})
  {
    const DenseCompliance compliance(Vector3d(1, 1, ratio).asDiagonal().toDenseMatrix());
    const ContactSystem system(compliance, {OrthotropicFriction{0.5, 0.5, 0.5, 0.5}});
    const ContactStep problem(system, step_displacement(Vector3d(-1, 0, 0.1), Vector3d::Zero()));
    NodeVector force = Vector3d(1, 0, 0);
    ContactSolverOptions options = solver_options("feng2006");
    options.maximum_iterations = 1000;
    const SolverReport report = solve_step(problem, options, force);
    EXPECT_EQ(report.converged, ratio < 2);
    solve(problem, solver_options("newton"));
  }
}

TEST(Feng2006, GivesTheForcesOfTheSweepsWhereItConverges)
{
  for (const OrthotropicFriction &law : {case_a, case_b})
  {
    const GridProblem grid(law);
    const NodeVector expected = solve(grid.problem, solver_options("gauss-seidel", 1e-13));
    const NodeVector force = solve(grid.problem, solver_options("feng2006"));
    EXPECT_LE((force - expected).norm(), 1e-8 * expected.norm());
  }
}

TEST(Residual, NeverPassesForcesThatAreNotNumbers)
{
  const GridProblem grid(case_a);
  NodeVector force = grid.zero();
  force[4] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(grid.problem.residual(force), std::numeric_limits<double>::infinity());
  EXPECT_FALSE(make_report(grid.problem, force, 1, 1e-3).converged);
}

TEST(Relaxation, DoesNotChangeTheAnswer)
{
  const GridProblem grid(case_b);
  const NodeVector expected = solve(grid.problem, solver_options("gauss-seidel", 1e-13));
  for (const double relaxation : {0.6, 1.3})
  {
    ContactSolverOptions options = solver_options("gauss-seidel");
    options.relaxation = relaxation;
    EXPECT_LE((solve(grid.problem, options) - expected).norm(), 1e-8 * expected.norm());
  }
}

namespace
{
/// A backend that can only multiply.
class ProductsOnly : public Compliance
{
public:
  explicit ProductsOnly(const DenseCompliance &inner)
      : inner_(inner)
  {
  }
  Index n_nodes() const override { return inner_.n_nodes(); }
  void vmult(NodeVector &displacement, const NodeVector &force) const override
  {
    inner_.vmult(displacement, force);
  }
  Eigen::Matrix3d diagonal_block(const Index node) const override { return inner_.diagonal_block(node); }

private:
  const DenseCompliance &inner_;
};
} // namespace

TEST(Uzawa, RunsOnProductsAlone)
{
  const GridProblem grid(case_b);
  const ProductsOnly products(grid.compliance);
  const ContactSystem system(products, FrictionLaws(grid.problem.n_nodes(), case_b));
  const ContactStep problem(system, step_displacement(grid.problem.q(), grid.zero()));
  const NodeVector expected = solve(grid.problem, solver_options("uzawa"));
  EXPECT_LE((solve(problem, solver_options("uzawa")) - expected).norm(), 1e-12);
  EXPECT_THROW(make_contact_solver(system, solver_options("newton")), std::invalid_argument);
}

TEST(ContactMethods, HaveWordsOfTheirOwnAndSayWhatTheyDo)
{
  std::set<std::string_view> words, helps;
  for (const ContactMethod &method : contact_methods())
  {
    words.insert(method.word);
    helps.insert(method.help);
    EXPECT_EQ(find_contact_method(method.word), &method);
    EXPECT_FALSE(method.help.empty());
  }
  EXPECT_EQ(words.size(), contact_methods().size());
  EXPECT_EQ(helps.size(), contact_methods().size());
}

TEST(ContactMethods, BeginWithTheOneToWorkWith)
{
  EXPECT_EQ(contact_methods().front().word, ContactSolverOptions().method);
  EXPECT_FALSE(contact_methods().front().is_for_study);
}

TEST(ContactMethods, AreNotFoundByOtherWords)
{
  EXPECT_EQ(find_contact_method(""), nullptr);
  EXPECT_EQ(find_contact_method("Newton"), nullptr);
  EXPECT_THROW(make_contact_solver(GridProblem(OrthotropicFriction{0.3, 0.15, 0.3, 0.15}).system,
                                   solver_options("simplex")),
               std::invalid_argument);
}
} // namespace orthocone::test
