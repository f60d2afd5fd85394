// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "condition_system.h"
#include "neighbour_stiffness.h"
#include "rounded_matrix.h"

#include <orthocone/surface/compliance.h>

#include <optional>

namespace orthocone
{
/// A dense compliance for inner iterations. Single precision halves the memory to read, and rounded entries
/// halve it again, where they leave W positive definite: a body that is thousands of times stiffer in one
/// direction has modes so stiff that rounding hides them.
class InnerCompliance : public InnerOperator
{
public:
  /// `compliance`: W, 3 n x 3 n, which must outlive this object; `scale` > 0.
  InnerCompliance(const DenseView &compliance, double scale);

  double scale() const override { return scale_; }

  Eigen::Matrix3d own(const Eigen::Index node) const override
  {
    return compliance_.block<3, 3>(3 * node, 3 * node);
  }

  /// Whether entries are rounded.
  bool is_rounded() const { return rounded_.has_value(); }

  Eigen::VectorXf multiply(const Eigen::VectorXf &vector) const override
  {
    return rounded_ ? *rounded_ * vector : single_.selfadjointView<Eigen::Lower>() * vector;
  }

  Eigen::VectorXf multiply_stiffness(const Eigen::VectorXf &vector) const override
  {
    return stiffness_ * vector;
  }

private:
  DenseView compliance_;
  double scale_;
  Eigen::MatrixXf single_{}; ///< one of these two
  std::optional<RoundedMatrix> rounded_{};
  NeighbourStiffness stiffness_;
};
} // namespace orthocone
