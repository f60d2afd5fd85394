// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>

namespace orthocone
{
/// How often the steps of one solution may do what leads out of a trap, or only costs.
struct Allowances
{
  unsigned int leaps = 3;           ///< full steps to a larger error; they may lead to another solution
  unsigned int exact_nodes = 3;     ///< nodes that are solved exactly, one at a time
  std::size_t nodes_in_groups = 24; ///< the same, several at a time
};

/// Nodes in groups cost many solutions: they are for the first method alone.
inline Allowances without_groups(Allowances allowances)
{
  allowances.nodes_in_groups = 0;
  return allowances;
}

/// Whether a step hardly pays.
inline bool has_stalled(const double error, const double last_error)
{
  constexpr double share = 0.5;
  return error > share * last_error;
}

/// What the next step may do.
struct StepRule
{
  double accuracy;      ///< of its linear system
  double bound;         ///< that its error must stay below, N
  bool may_leap;        ///< as far as there are Allowances
  bool may_solve_node;  ///< exactly, in the same way
  bool may_solve_nodes; ///< several at once
};

/// Globalization of the steps of one solution: how accurate the next one is, and how far it may go.
class Globalization
{
public:
  /// Behind an iterate with these errors of the law alone, and of law and equilibrium together (N).
  StepRule next(const double of_law, const double error, const double wanted)
  {
    constexpr unsigned int hopeless = 5; // stalls: one node at a time has not helped
    constexpr double near = 1e-3;        // of the first error
    const double last_error = std::exchange(last_error_, error);
    if (first_error_ == 0)
      first_error_ = error;
    has_been_near_ = has_been_near_ || error <= near * first_error_;
    // Steps that are hard differ from easy ones, which stall once where nodes change their status. Far from
    // the solution many nodes do, and to solve some of them exactly helps little.
    if (has_been_near_ && has_stalled(error, last_error))
      ++n_stalls_;
    // Where slip is far from associated, the error may have a minimum beside the solution. Only a step across
    // the ridge between both leads out of it: near the solution the bound is the larger one of the last two
    // errors (Grippo, Lampariello and Lucidi, SIAM J. Numer. Anal. 23 (1986) 707). Far from it such steps
    // cost more than they save. Both: docs/performance.md, "Multigrid".
    const double bound = has_been_near_ ? std::max(last_error, error) : error;
    return {accuracy(of_law, error, wanted), bound, has_been_near_, n_stalls_ > 0, n_stalls_ >= hopeless};
  }

private:
  /// As accurate as Newton's method converges on the law, which is all that is not linear, and no better than
  /// the tolerance asks for (Eisenstat and Walker, SIAM J. Sci. Comput. 17 (1996) 16).
  double accuracy(const double of_law, const double error, const double wanted)
  {
    constexpr double coarse = 0.3, fine = 1e-2, oversolving = 0.05;
    const double last = std::exchange(last_of_law_, of_law);
    const double reduction = last > 0 ? of_law / last : 1;
    return std::max(std::clamp(0.9 * reduction * reduction, fine, coarse), oversolving * wanted / error);
  }

  double first_error_ = 0, last_error_ = 0, last_of_law_ = 0; ///< N
  bool has_been_near_ = false; ///< steps across a ridge lead away from the solution again for a while
  unsigned int n_stalls_ = 0;  ///< near the solution
};
} // namespace orthocone
