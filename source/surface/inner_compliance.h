// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "rounded_matrix.h"

#include <orthocone/surface/compliance.h>

#include <optional>

namespace orthocone
{
/// The compliance as inner iterations use it, which want two digits of a product. Single precision halves the
/// memory to read, and rounded entries halve it again, where they leave W positive definite: a body that is
/// thousands of times stiffer in one direction has modes so stiff that rounding hides them. It is relative to
/// its largest eigenvalue, so that no unit of force or length comes near the ends of the number range.
class InnerCompliance
{
public:
  /// `compliance`: W, 3 n x 3 n; `scale` > 0.
  InnerCompliance(const DenseView &compliance, double scale);

  double scale() const { return scale_; }

  /// Whether entries are rounded.
  bool is_rounded() const { return rounded_.has_value(); }

  /// W v / scale.
  Eigen::VectorXf multiply(const Eigen::VectorXf &vector) const
  {
    return rounded_ ? *rounded_ * vector : single_.selfadjointView<Eigen::Lower>() * vector;
  }

  /// About scale W^-1 v: for each node its nearest neighbours are held, and the others carry no force. The
  /// inverse of a compliance decreases so fast with the distance that more neighbours make no better
  /// preconditioner.
  Eigen::VectorXf multiply_stiffness(const Eigen::VectorXf &vector) const;

private:
  static constexpr Eigen::Index n_held = 8; ///< a node and its neighbours

  double hold(Eigen::Index node, const DenseView &compliance);

  double scale_;
  Eigen::MatrixXf single_{}; ///< one of these two
  std::optional<RoundedMatrix> rounded_{};
  Eigen::Matrix<Eigen::Index, n_held, Eigen::Dynamic> held_;        ///< the nodes held for each node
  Eigen::Matrix<float, 3 * n_held, Eigen::Dynamic> holding_forces_; ///< on them, 3 columns a node
};
} // namespace orthocone
