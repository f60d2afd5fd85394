// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <vector>

namespace orthocone
{
/// Nested dissection of a graph by METIS: `starts` and `neighbours` have it in compressed rows, with both
/// directions of every edge. The order becomes the first entries of `order`. Throws std::bad_alloc, or
/// std::runtime_error if METIS fails.
///
/// METIS catches SIGTERM, the signal of batch systems and containers, by a handler of its own that jumps out
/// of whatever it is doing; it then may free memory twice. So it runs in a process of its own, and this
/// process keeps its handlers.
void order_by_metis(std::vector<int> &starts, std::vector<int> &neighbours, std::vector<int> &order);
} // namespace orthocone
