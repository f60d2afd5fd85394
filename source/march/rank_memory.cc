// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/march/rank_memory.h>

#include <orthocone/base/ranks.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

namespace orthocone
{
using Eigen::VectorXd;

namespace
{
std::string bytes_of(const VectorXd &vector)
{
  std::string bytes(static_cast<std::size_t>(vector.size()) * sizeof(double), '\0');
  std::memcpy(bytes.data(), vector.data(), bytes.size());
  return bytes;
}

VectorXd vector_of(const std::string &bytes)
{
  VectorXd vector(bytes.size() / sizeof(double));
  std::memcpy(vector.data(), bytes.data(), bytes.size());
  return vector;
}

std::vector<VectorXd> gathered(const std::vector<VectorXd> &bodies)
{
  std::vector<VectorXd> all(bodies.size() * n_ranks());
  for (std::size_t i = 0; i < bodies.size(); ++i)
  {
    const std::vector<std::string> of_ranks = gather_on_first(bytes_of(bodies[i]));
    for (std::size_t rank = 0; rank < of_ranks.size(); ++rank)
      all[rank * bodies.size() + i] = vector_of(of_ranks[rank]);
  }
  return all;
}
} // namespace

StartMemory gathered(StartMemory memory)
{
  if (n_ranks() == 1)
    return memory;
  memory.bodies = gathered(memory.bodies);
  for (MarchMemory &coarser : memory.coarser)
    coarser.starts = gathered(std::move(coarser.starts));
  return memory;
}

StartMemory part_of_this_rank(StartMemory memory, const unsigned int n_ranks_then)
{
  const std::size_t n = n_ranks_then == n_ranks() ? memory.bodies.size() / n_ranks() : 0;
  const auto first = memory.bodies.begin() + static_cast<std::ptrdiff_t>(n * this_rank());
  memory.bodies = std::vector<VectorXd>(first, first + static_cast<std::ptrdiff_t>(n));
  for (MarchMemory &coarser : memory.coarser)
    coarser.starts = part_of_this_rank(std::move(coarser.starts), n_ranks_then);
  return memory;
}
} // namespace orthocone
