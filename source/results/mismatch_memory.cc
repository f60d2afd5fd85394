// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/results/mismatch_memory.h>

#include <orthocone/base/ranks.h>

#include <algorithm>
#include <utility>

namespace orthocone
{
MismatchMemory::MismatchMemory(const ElasticBody &body, const std::size_t most_bytes)
    : body_(body),
      most_bytes_(most_bytes)
{
}

std::size_t MismatchMemory::bytes_of(const State &state)
{
  return sizeof(double) *
         static_cast<std::size_t>(state.force.size() + state.elastic.size() + state.mismatch.volume.size());
}

void MismatchMemory::forget_oldest()
{
  while (bytes_ > most_bytes_)
  {
    bytes_ -= bytes_of(states_.back());
    states_.pop_back();
  }
}

BodyMismatch MismatchMemory::of(const NodeVector &force, const NodeVector &elastic, const double bound)
{
  const auto known =
      std::find_if(states_.begin(), states_.end(),
                   [&](const State &state) { return state.force == force && state.elastic == elastic; });
  // The body is solved by all ranks or by none.
  if (!any_rank(known == states_.end()))
  {
    states_.splice(states_.begin(), states_, known);
    return states_.front().mismatch;
  }
  ++n_solved_;
  BodyMismatch mismatch = body_.mismatch(force, elastic, bound);
  if (known == states_.end())
  {
    states_.push_front({force, elastic, mismatch});
    bytes_ += bytes_of(states_.front());
    forget_oldest();
  }
  return mismatch;
}
} // namespace orthocone
