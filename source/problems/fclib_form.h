// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/problems/contact_problem.h>

namespace orthocone
{
/// The map of a problem to FCLIB's isotropic, associated form, node by node: r = `force` r' and d' =
/// `displacement` d, with `force` = D = diag(1, mu_x, mu_y), `displacement` = D diag(1, Q^2) and mu = 1
/// (docs/theory.md, section 9). Nodes whose law is isotropic and associated, or without friction, stay in
/// their own scale.
struct FclibScale
{
  explicit FclibScale(const std::vector<OrthotropicFriction> &laws);

  /// Whether the problem in FCLIB's form is symmetric.
  bool is_symmetric() const { return force == displacement; }

  Eigen::VectorXd force;        ///< 3 n
  Eigen::VectorXd displacement; ///< 3 n
  Eigen::VectorXd mu;           ///< n
};
} // namespace orthocone
