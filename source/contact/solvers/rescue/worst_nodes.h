// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/problem/contact_step.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace orthocone
{
/// The node with the largest part of a natural map, or the last one whose part is no number. `map` has three
/// numbers for each of the n nodes, and may have more behind them.
Eigen::Index worst_node(const Eigen::VectorXd &map, Eigen::Index n_nodes);

/// The node that holds most of the natural map: nine tenths of its square or more. Nothing if no node does.
std::optional<Eigen::Index> dominant_node(const ContactStep &step, const Eigen::VectorXd &unknowns,
                                          const NodeVector &displacement);

/// The nodes that hold 99 % of the squared natural map, worst first, or `most` nodes if these are more.
std::vector<Eigen::Index> worst_nodes(const ContactStep &step, const Eigen::VectorXd &unknowns,
                                      const NodeVector &displacement, std::size_t most);

/// The numbers of the three entries of each of these nodes: indices for Eigen's vectors and matrices.
std::vector<Eigen::Index> entries_of(const std::vector<Eigen::Index> &nodes);
} // namespace orthocone
