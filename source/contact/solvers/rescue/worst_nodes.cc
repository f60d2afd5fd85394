// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "worst_nodes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace orthocone
{
using Eigen::Index;
using Eigen::VectorXd;

Index worst_node(const VectorXd &map, const Index n_nodes)
{
  Index worst = 0;
  double largest = -1;
  for (Index node = 0; node < n_nodes; ++node)
    if (const double part = map.segment<3>(3 * node).norm(); part > largest || std::isnan(part))
    {
      largest = part;
      worst = node;
    }
  return worst;
}

std::optional<Index> dominant_node(const ContactStep &step, const VectorXd &unknowns,
                                   const NodeVector &displacement)
{
  constexpr double least_share = 0.9;
  const VectorXd map = step.natural_map(unknowns, displacement);
  const Index worst = worst_node(map, step.n_nodes());
  return map.segment<3>(3 * worst).squaredNorm() >= least_share * map.squaredNorm() ? std::optional(worst)
                                                                                    : std::nullopt;
}

std::vector<Index> worst_nodes(const ContactStep &step, const VectorXd &unknowns, const NodeVector &displacement,
                  const std::size_t most)
{
  constexpr double remaining = 0.01; // of the squared map
  const VectorXd map = step.natural_map(unknowns, displacement);
  const auto part = [&](const Index node) { return map.segment<3>(3 * node).squaredNorm(); };
  std::vector<Index> nodes(step.n_nodes());
  std::iota(nodes.begin(), nodes.end(), 0);
  const auto n = std::min(most, nodes.size());
  std::partial_sort(nodes.begin(), nodes.begin() + static_cast<Index>(n), nodes.end(),
                    [&](const Index a, const Index b) { return part(a) > part(b); });
  double rest = map.head(3 * step.n_nodes()).squaredNorm();
  const double enough = remaining * rest;
  for (std::size_t i = 0; i < n; ++i)
  {
    rest -= part(nodes[i]);
    if (rest <= enough)
    {
      nodes.resize(i + 1);
      return nodes;
    }
  }
  nodes.resize(n);
  return nodes;
}

std::vector<Index> entries_of(const std::vector<Index> &nodes)
{
  std::vector<Index> entries;
  for (const Index node : nodes)
    entries.insert(entries.end(), {3 * node, 3 * node + 1, 3 * node + 2});
  return entries;
}
} // namespace orthocone
