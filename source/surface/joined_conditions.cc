// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/joined_conditions.h>

namespace orthocone
{
using Eigen::Index;

JoinedConditions::JoinedConditions(const ContactConditions &conditions)
{
  const auto n_rows = 3 * static_cast<Index>(conditions.nodes.size());
  std::vector<Eigen::Triplet<double>> of_basis, of_rows;
  diagonal.resize(n_rows);
  right_side.resize(n_rows);
  fixed.resize(n_rows);
  Index n = 0, place = 0;
  for (const NodeCondition &node : conditions.nodes)
  {
    for (Index k = 0; k < node.n_unknowns; ++k)
      for (Index i = 0; i < 3; ++i)
      {
        of_basis.emplace_back(place + i, n + k, node.basis(i, k));
        of_rows.emplace_back(place + i, n + k, node.rows(i, k));
      }
    diagonal.segment(n, node.n_unknowns) = node.diagonal.head(node.n_unknowns);
    right_side.segment(n, node.n_unknowns) = node.right_side.head(node.n_unknowns);
    fixed.segment<3>(place) = node.fixed;
    n += node.n_unknowns;
    place += 3;
  }
  diagonal.conservativeResize(n);
  right_side.conservativeResize(n);
  basis.resize(n_rows, n);
  rows.resize(n_rows, n);
  basis.setFromTriplets(of_basis.begin(), of_basis.end());
  rows.setFromTriplets(of_rows.begin(), of_rows.end());
}
} // namespace orthocone
