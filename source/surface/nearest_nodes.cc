// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/nearest_nodes.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace orthocone
{
using Eigen::Index;

std::vector<Index> nearest_nodes(const DenseView &compliance, const Index node, const std::size_t n)
{
  std::vector<Index> nodes(compliance.rows() / 3);
  std::iota(nodes.begin(), nodes.end(), 0);
  std::swap(nodes[0], nodes[node]);
  const auto is_nearer = [&](const Index a, const Index b)
  { return compliance(3 * a, 3 * node) > compliance(3 * b, 3 * node); };
  if (nodes.size() > n)
  {
    std::nth_element(nodes.begin() + 1, nodes.begin() + static_cast<std::ptrdiff_t>(n), nodes.end(),
                     is_nearer);
    nodes.resize(n);
  }
  return nodes;
}
} // namespace orthocone
