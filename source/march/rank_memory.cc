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

/// Those of all processes behind one another.
std::map<unsigned int, VectorXd> gathered(const std::map<unsigned int, VectorXd> &body_of_phase)
{
  std::map<unsigned int, VectorXd> all;
  for (const auto &[phase, body] : body_of_phase)
  {
    std::string bytes;
    for (const std::string &of_rank : gather_on_first(bytes_of(body)))
      bytes += of_rank;
    all[phase] = vector_of(bytes);
  }
  return all;
}

/// The parts of this process, which has `n_bodies` of all `bodies`: these have the sizes of all parts.
std::map<unsigned int, VectorXd> own_parts(const std::map<unsigned int, VectorXd> &body_of_phase,
                                           const std::vector<VectorXd> &bodies, const std::size_t n_bodies)
{
  std::map<unsigned int, VectorXd> own;
  if (n_bodies == 0)
    return own;
  Eigen::Index first = 0;
  for (unsigned int rank = 0; rank < this_rank(); ++rank)
    first += bodies[n_bodies * rank].size();
  const Eigen::Index size = bodies[n_bodies * this_rank()].size();
  for (const auto &[phase, body] : body_of_phase)
    if (first + size <= body.size())
      own[phase] = body.segment(first, size);
  return own;
}
} // namespace

StartMemory gathered(StartMemory memory)
{
  if (n_ranks() == 1)
    return memory;
  memory.bodies = gathered(memory.bodies);
  memory.body_of_phase = gathered(memory.body_of_phase);
  for (MarchMemory &coarser : memory.coarser)
    coarser.starts = gathered(std::move(coarser.starts));
  return memory;
}

StartMemory part_of_this_rank(StartMemory memory, const unsigned int n_ranks_then)
{
  const std::size_t n = n_ranks_then == n_ranks() ? memory.bodies.size() / n_ranks() : 0;
  memory.body_of_phase = own_parts(memory.body_of_phase, memory.bodies, n);
  const auto first = memory.bodies.begin() + static_cast<std::ptrdiff_t>(n * this_rank());
  memory.bodies = std::vector<VectorXd>(first, first + static_cast<std::ptrdiff_t>(n));
  for (MarchMemory &coarser : memory.coarser)
    coarser.starts = part_of_this_rank(std::move(coarser.starts), n_ranks_then);
  return memory;
}
} // namespace orthocone
