// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/results/mismatch_memory.h>

#include <algorithm>
#include <utility>

namespace orthocone
{
MismatchMemory::MismatchMemory(const ElasticBody &body, const std::size_t most_bytes)
    : body_(body),
      most_bytes_(body.compliance().dense() != nullptr ? most_bytes : 0)
{
}

std::size_t MismatchMemory::bytes_of(const Answer &answer)
{
  return sizeof(double) * static_cast<std::size_t>(answer.force.size() + answer.mismatch.volume.size());
}

void MismatchMemory::forget_oldest()
{
  while (bytes_ > most_bytes_)
  {
    bytes_ -= bytes_of(kept_.back());
    kept_.pop_back();
  }
}

BodyMismatch MismatchMemory::of(const NodeVector &force, const NodeVector &elastic, const double bound)
{
  const auto known =
      std::find_if(kept_.begin(), kept_.end(), [&](const Answer &answer) { return answer.force == force; });
  if (known != kept_.end())
  {
    kept_.splice(kept_.begin(), kept_, known);
    BodyMismatch mismatch = kept_.front().mismatch;
    mismatch.displacement = body_.frame().difference(elastic, mismatch.volume);
    return mismatch;
  }
  ++n_solved_;
  BodyMismatch mismatch = body_.mismatch(force, elastic, bound);
  kept_.push_front({force, mismatch});
  bytes_ += bytes_of(kept_.front());
  forget_oldest();
  return mismatch;
}
} // namespace orthocone
