// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "cell_products.h"

#include <orthocone/body/hanging_dofs.h>

#include <vector>

namespace orthocone
{
/// Weighted sums over degrees of freedom, one in each lane of a register.
template<typename Number>
struct LaneSums
{
  std::vector<unsigned int> targets;  ///< a degree of freedom for each sum
  std::vector<unsigned int> n_terms;  ///< of each batch of sums: the largest number of its lanes
  std::vector<unsigned int> dofs;     ///< batches x terms x lanes
  std::vector<Lanes<Number>> weights; ///< batches x terms; 0 in lanes that have fewer terms
};

/// What HangingDofs do, for many of them at a time.
template<typename Number>
class HangingProducts
{
public:
  explicit HangingProducts(const HangingDofs &hanging);

  bool empty() const { return of_hanging_.targets.empty(); }

  /// HangingDofs::distribute().
  void distribute(Number *displacement) const;

  /// Moves forces on hanging ones to the degrees of freedom that move them, which does the same work;
  /// `forces` has n_dofs numbers.
  void collect(Number *forces) const;

private:
  LaneSums<Number> of_hanging_; ///< over those that move them
  LaneSums<Number> of_moving_;  ///< over those that they move
};
} // namespace orthocone
