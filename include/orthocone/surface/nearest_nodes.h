// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/compliance.h>

#include <cstddef>
#include <vector>

namespace orthocone
{
/// The `n` nodes (or all) whose normal displacement a normal force on `node` changes most: `node` itself
/// first, the others in no order. `compliance` is W, 3 n_nodes x 3 n_nodes.
std::vector<Eigen::Index> nearest_nodes(const DenseView &compliance, Eigen::Index node, std::size_t n);
} // namespace orthocone
