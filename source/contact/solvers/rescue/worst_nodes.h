// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/problem/contact_step.h>

#include <cstddef>
#include <vector>

namespace orthocone
{
/// The nodes that hold 99 % of the squared natural map, worst first, or `most` nodes if these are more.
std::vector<Eigen::Index> worst_nodes(const ContactStep &step, const Eigen::VectorXd &unknowns,
                                      const NodeVector &displacement, std::size_t most);

/// Three values of each of these nodes.
Eigen::VectorXd values_at(const std::vector<Eigen::Index> &nodes, const Eigen::VectorXd &values);
} // namespace orthocone
