// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Small contact problems with a known structure, without a body.
#pragma once

#include "contact/laws.h"

#include <orthocone/contact/solvers/contact_solver.h>

namespace orthocone::test
{
/// Compliance of a grid of n x n nodes that feel each other over a distance: exp(-distance) times a 3 x 3
/// block that couples normal and tangential directions. A product of positive definite kernels is positive
/// definite.
inline Eigen::MatrixXd grid_compliance(const Eigen::Index n, const double normal_to_tangential = 1)
{
  Eigen::Matrix3d block;
  block << 1, 0.1, -0.05, 0.1, 1.3, 0.1, -0.05, 0.1, 1.2;
  block.row(0) *= std::sqrt(normal_to_tangential);
  block.col(0) *= std::sqrt(normal_to_tangential);
  Eigen::MatrixXd w(3 * n * n, 3 * n * n);
  for (Eigen::Index i = 0; i < n * n; ++i)
    for (Eigen::Index j = 0; j < n * n; ++j)
    {
      const double distance =
          std::hypot(static_cast<double>(i % n - j % n), static_cast<double>(i / n - j / n));
      w.block<3, 3>(3 * i, 3 * j) = std::exp(-distance) * block;
    }
  return w;
}

/// A grid of nodes pressed down and pushed sideways by a twisting field, so that nodes stick, slip in all
/// directions and open.
struct GridProblem
{
  explicit GridProblem(const OrthotropicFriction &ellipse, const Eigen::Index n = 5, const double push = 1)
      : GridProblem(FrictionLaw(ellipse), n, push)
  {
  }

  explicit GridProblem(const FrictionLaw &law, const Eigen::Index n = 5, const double push = 1)
      : compliance(grid_compliance(n)),
        system(compliance, FrictionLaws(n * n, law)),
        problem(system, free_displacement(n, push))
  {
  }

  static NodeVector free_displacement(const Eigen::Index n, const double push)
  {
    NodeVector free(3 * n * n);
    for (Eigen::Index i = 0; i < n * n; ++i)
    {
      const double x = static_cast<double>(i % n) / static_cast<double>(n - 1) - 0.5;
      const double y = static_cast<double>(i / n) / static_cast<double>(n - 1) - 0.5;
      free.segment<3>(3 * i) =
          Eigen::Vector3d(-1 + 3 * x * x, push * (0.3 * x - 0.4 * y), push * (0.3 * y + 0.4 * x));
    }
    return free;
  }

  NodeVector zero() const { return NodeVector::Zero(3 * problem.n_nodes()); }

  DenseCompliance compliance;
  ContactSystem system;
  ContactStep problem;
};

/// Solves a step by the method that the options name, from `force` on.
inline SolverReport solve_step(const ContactStep &step, const ContactSolverOptions &options,
                               Eigen::VectorXd &force)
{
  return make_contact_solver(step.system(), options)->solve(step, force);
}

inline ContactSolverOptions solver_options(const std::string &method, const double tolerance = 1e-11)
{
  ContactSolverOptions options;
  options.method = method;
  options.tolerance = tolerance;
  options.maximum_iterations = 200000;
  return options;
}

/// What changes of force (N) and displacement (mm) lack of a condition, N.
inline double lacking_of(const NodeCondition &condition, const Eigen::Vector3d &force,
                         const Eigen::Vector3d &displacement)
{
  const Eigen::Vector3d moved = force - condition.fixed;
  const Eigen::Index n = condition.n_unknowns;
  if (n == 0)
    return moved.norm();
  const Eigen::MatrixXd basis = condition.basis.leftCols(n);
  const Eigen::VectorXd unknowns = basis.colPivHouseholderQr().solve(moved);
  const Eigen::VectorXd lacking = condition.rows.leftCols(n).transpose() * displacement +
                                  condition.diagonal.head(n).cwiseProduct(unknowns) -
                                  condition.right_side.head(n);
  return lacking.norm() + (basis * unknowns - moved).norm();
}
} // namespace orthocone::test
