// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/elastic_body.h>

#include <cstddef>
#include <list>

namespace orthocone
{
/// The mismatches of a body under the forces that were asked for last. A settled cycle repeats its forces to
/// the last bit, and a solve of the whole body has the same answer for the same forces, so that only new ones
/// have to be solved. Displacements are compared with this answer each time. Forces that were not asked for
/// longest go first where there is no room. Of a body that is solved iteratively nothing is kept, because its
/// answer depends on where the iteration begins, and a resumed run would have other last digits.
class MismatchMemory
{
public:
  static constexpr std::size_t usual_bytes = std::size_t{64} << 20U;

  /// Keeps answers of up to `most_bytes` in all. `body` must outlive the memory.
  explicit MismatchMemory(const ElasticBody &body, std::size_t most_bytes = usual_bytes);

  /// ElasticBody::mismatch(), whose solve is from memory where these forces are there. `bound` is the same in
  /// all calls. Throws SolveError where the body cannot be solved.
  BodyMismatch of(const NodeVector &force, const NodeVector &elastic, double bound);

  std::size_t n_solved() const { return n_solved_; } ///< forces that were not in memory
  std::size_t n_kept() const { return kept_.size(); }

private:
  struct Answer
  {
    NodeVector force;
    BodyMismatch mismatch;
  };

  static std::size_t bytes_of(const Answer &answer);
  void forget_oldest();

  const ElasticBody &body_;
  std::size_t most_bytes_;
  std::size_t bytes_ = 0, n_solved_ = 0;
  std::list<Answer> kept_{}; ///< the last one first
};
} // namespace orthocone
