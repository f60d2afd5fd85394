// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "inner_compliance.h"

#include <orthocone/surface/nearest_nodes.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace orthocone
{
using Eigen::Index;

namespace
{
/// The largest eigenvalue that errors of RoundedMatrix at random add to W or take from it, at most: every
/// tile might have the largest entry, which is on the diagonal.
double rounding_of_eigenvalues(const DenseView &compliance)
{
  const double unit = compliance.diagonal().maxCoeff() / std::numeric_limits<std::int16_t>::max();
  return 2 * unit * std::sqrt(static_cast<double>(compliance.rows()) / 12); // Wigner: 2 sigma sqrt(n)
}
} // namespace

InnerCompliance::InnerCompliance(const DenseView &compliance, const double scale)
    : compliance_(compliance),
      scale_(scale),
      stiffness_(compliance.rows() / 3, scale)
{
  constexpr Index least_rows_to_round = 500; // with fewer, rounding costs what products gain
  double stiffest = std::numeric_limits<double>::infinity();
  const auto block = [&](const Index i, const Index j)
  { return Eigen::Matrix3d(compliance.block<3, 3>(3 * i, 3 * j)); };
  for (Index node = 0; 3 * node < compliance.rows(); ++node)
    stiffest = std::min(stiffest,
                        stiffness_.hold(nearest_nodes(compliance, node, NeighbourStiffness::n_held), block));
  if (compliance.rows() >= least_rows_to_round && rounding_of_eigenvalues(compliance) < stiffest)
    rounded_.emplace(compliance, scale);
  else
    single_ = (compliance / scale).cast<float>();
}
} // namespace orthocone
