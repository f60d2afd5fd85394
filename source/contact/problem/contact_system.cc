// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/contact/problem/contact_system.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace orthocone
{
ContactSystem::ContactSystem(const Compliance &compliance, FrictionLaws laws)
    : compliance_(compliance),
      laws_(std::move(laws)),
      softness_(compliance.softness())
{
  eigen_assert(static_cast<Eigen::Index>(laws_.size()) == n_nodes());
  for (Eigen::Index node = 0; node < n_nodes(); ++node)
  {
    const double largest = compliance_.diagonal_block(node).diagonal().maxCoeff();
    rho_.push_back(1 / (largest > 0 ? largest : softness_)); // a node that cannot move may have any rho
  }
}

double ContactSystem::rounding() const
{
  return std::numeric_limits<double>::epsilon() * softness_ * *std::max_element(rho_.begin(), rho_.end());
}
} // namespace orthocone
