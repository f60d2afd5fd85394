// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Rigid bodies with more contacts than degrees of freedom: W = H H^T is singular, and forces are not unique.
#include "contact/contact_problems.h"

#include <gtest/gtest.h>

#include <random>

namespace orthocone::test
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
/// The columns of H for a contact at (x, y, z) of a body: its three translations and rotations.
Eigen::Matrix<double, 3, 6> contact_of_body(const double x, const double y, const double z)
{
  Eigen::Matrix<double, 3, 6> rows;
  rows << 0, 0, 1, y, -x, 0, // normal
      1, 0, 0, 0, z, -y,     //
      0, 1, 0, -z, 0, x;
  return rows;
}

/// H of plates on each other, with contacts at random places of their faces.
MatrixXd stack(const Index n_plates, const Index n_contacts, const unsigned int seed = 1)
{
  std::mt19937 numbers(seed);
  std::uniform_real_distribution<double> place(-1, 1);
  MatrixXd h = MatrixXd::Zero(3 * n_plates * n_contacts, 6 * n_plates);
  for (Index plate = 0; plate < n_plates; ++plate)
    for (Index i = 0; i < n_contacts; ++i)
    {
      const double x = place(numbers), y = place(numbers);
      const Index row = 3 * (plate * n_contacts + i);
      h.block<3, 6>(row, 6 * plate) = contact_of_body(x, y, -0.5);
      if (plate > 0)
        h.block<3, 6>(row, 6 * (plate - 1)) = -contact_of_body(x, y, 0.5);
    }
  return h;
}

struct Solved
{
  SolverReport report;
  NodeVector force;
};

/// Solves the contacts of bodies that would move by `motion` without forces.
Solved solved(const MatrixXd &h, const VectorXd &motion, const double gap, const double mu,
              const std::string &method = "newton")
{
  NodeVector free = h * motion;
  for (Index i = 0; i < free.size(); i += 3)
    free[i] += gap;
  const DenseCompliance compliance(h * h.transpose());
  const ContactSystem system(compliance, FrictionLaws(static_cast<std::size_t>(free.size() / 3),
                                                      OrthotropicFriction{mu, mu, mu, mu}));
  NodeVector force = NodeVector::Zero(free.size());
  ContactSolverOptions options = solver_options(method, 1e-8);
  SolverReport report = solve_step(ContactStep(system, free), options, force);
  return {std::move(report), std::move(force)};
}

SolverReport report_of(const MatrixXd &h, const VectorXd &motion, const double gap, const double mu)
{
  return solved(h, motion, gap, mu).report;
}
} // namespace

// Without proximal steps the same method needs more than 6000 iterations on each of them. With steps of
// Newton's method that are solved to 1 % in single precision, the stack of 96 contacts is not solved at all.
TEST(ProximalSteps, SolveStacksOfRigidPlates)
{
  for (const auto &[n_plates, n_contacts, mu] :
       {std::tuple<Index, Index, double>{5, 6, 0.5}, {10, 8, 0.9}, {12, 6, 0.9}, {4, 12, 0.9}, {12, 8, 0.2}})
  {
    VectorXd motion(6);
    motion << 0.2, 0.05, -1, 0, 0, 0.1;
    const SolverReport report = report_of(stack(n_plates, n_contacts), motion.replicate(n_plates, 1), 0, mu);
    EXPECT_TRUE(report.converged) << n_plates << " plates: " << to_word(report.verdict);
    EXPECT_LT(report.iterations, 500u) << n_plates << " plates";
    EXPECT_LT(report.law.penetration, 1e-5);
    EXPECT_LT(report.law.slip_rule, 1e-5);
  }
}

// One plate on many contacts: sweeps do, and which of the many forces they find is theirs alone.
TEST(ProximalSteps, ComeAfterSweeps)
{
  for (const Index n_contacts : {8, 16, 40})
  {
    VectorXd motion(6);
    motion << 0.2, 0.05, -1, 0, 0, 0.1;
    const MatrixXd h = stack(1, n_contacts);
    const Solved newton = solved(h, motion, 0, 0.3), swept = solved(h, motion, 0, 0.3, "gauss-seidel");
    EXPECT_TRUE(newton.report.converged && swept.report.converged);
    EXPECT_LT((newton.force - swept.force).norm(), 1e-6 * swept.force.norm()) << n_contacts << " contacts";
  }
}

// Each plate has a motion of its own. All such stacks have a solution: lifting each plate farther than the
// one below opens all contacts.
TEST(ProximalSteps, SolveStacksAtRandom)
{
  for (unsigned int seed = 1; seed <= 8; ++seed)
  {
    std::mt19937 numbers(seed);
    const Index n_plates = std::uniform_int_distribution<Index>(5, 12)(numbers);
    const Index n_contacts = std::uniform_int_distribution<Index>(4, 8)(numbers);
    const double mu = std::pow(10., std::uniform_real_distribution<double>(-1.3, 0)(numbers));
    std::normal_distribution<double> pushed(0, 0.3);
    VectorXd motion = VectorXd::NullaryExpr(6 * n_plates, [&] { return pushed(numbers); });
    motion(Eigen::seqN(2, n_plates, 6)).array() -= 1;
    const SolverReport report = report_of(stack(n_plates, n_contacts, seed), motion, 0, mu);
    EXPECT_TRUE(report.converged) << seed << ": " << to_word(report.verdict);
    EXPECT_LT(report.iterations, 1000u) << seed;
  }
}

// A body between two walls that are too close for it: forces grow until rounding hides the walls, and the
// residual, which is relative to them, vanishes.
TEST(ProximalSteps, FindNoForcesWhereThereAreNone)
{
  MatrixXd h = MatrixXd::Zero(6, 3);
  h(0, 2) = h(1, 0) = h(2, 1) = h(4, 0) = h(5, 1) = 1;
  h(3, 2) = -1;
  const SolverReport report = report_of(h, Eigen::Vector3d(0.1, 0, 0), -1, 0.3);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.verdict, Verdict::diverged);
}
} // namespace orthocone::test
