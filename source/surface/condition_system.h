// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/condition_solver.h>

namespace orthocone
{
/// A compliance W as inner iterations use it, which want two digits of a product: in single precision, and
/// relative to its largest eigenvalue, so that no unit of force or length comes near the ends of the number
/// range.
class InnerOperator
{
public:
  virtual ~InnerOperator() = default;

  /// mm/N, > 0.
  virtual double scale() const = 0;

  /// The 3 x 3 block of W of a node, mm/N.
  virtual Eigen::Matrix3d own(Eigen::Index node) const = 0;

  /// W v / scale.
  virtual Eigen::VectorXf multiply(const Eigen::VectorXf &vector) const = 0;

  /// About scale W^-1 v.
  virtual Eigen::VectorXf multiply_stiffness(const Eigen::VectorXf &vector) const = 0;
};

struct IterativeChange
{
  ContactChange change;
  bool converged;
  Eigen::Index iterations;
};

/// Solves conditions of contact nodes by GMRES in single precision, whose errors Newton's next iteration
/// corrects.
IterativeChange solve_by_gmres(const ContactConditions &conditions, const InnerOperator &inner,
                               double accuracy);

/// The same as a solver, of a compliance that is known by its products.
class GmresConditions : public ConditionSolver
{
public:
  /// The solver is never less accurate than `least_accuracy`, and adds its iterations to `n_iterations`. Both
  /// that are passed by reference must outlive it.
  GmresConditions(const InnerOperator &inner, const double least_accuracy, unsigned long &n_iterations)
      : inner_(inner),
        least_accuracy_(least_accuracy),
        n_iterations_(n_iterations)
  {
  }

  ContactChange solve(const ContactConditions &conditions, double accuracy) const override;

private:
  const InnerOperator &inner_;
  double least_accuracy_;
  unsigned long &n_iterations_;
};
} // namespace orthocone
