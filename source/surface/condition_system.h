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
};

/// Solves conditions of contact nodes by GMRES in single precision, whose errors Newton's next iteration
/// corrects.
IterativeChange solve_by_gmres(const ContactConditions &conditions, const InnerOperator &inner,
                               double accuracy);
} // namespace orthocone
