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

/// How accurately the next linear system is solved: as accurately as Newton's method converges on the law,
/// which is all that is not linear, and no better than the tolerance asks for.
class Forcing
{
public:
  double next(const double of_law, const double error, const double wanted)
  {
    constexpr double coarse = 0.3, fine = 1e-2, oversolving = 0.05;
    const double reduction = last_ > 0 ? of_law / last_ : 1;
    last_ = of_law;
    return std::max(std::clamp(0.9 * reduction * reduction, fine, coarse), oversolving * wanted / error);
  }

private:
  double last_ = 0; ///< error of the law
};

/// Whether iterates have come near the solution. Steps across a ridge lead away from it again for a while.
class Nearness
{
public:
  /// Whether one had an error of no more than a share of the first one, up to that with `error`.
  bool has_come(const double error)
  {
    constexpr double share = 1e-3;
    if (first_ == 0)
      first_ = error;
    has_come_ = has_come_ || error <= share * first_;
    return has_come_;
  }

private:
  double first_ = 0;
  bool has_come_ = false;
};

/// The error that a step must stay below. Near the solution it is the larger one of the last two errors.
/// Where slip is far from associated, the error may have a minimum beside the solution. Only a step across
/// the ridge between both leads out of it (Grippo, Lampariello and Lucidi, SIAM J. Numer. Anal. 23 (1986)
/// 707). Far from the solution such steps cost more than they save. docs/performance.md, "Multigrid".
class Ridge
{
public:
  double height(const double error, const bool is_near)
  {
    const double before = std::exchange(last_, error);
    return is_near ? std::max(before, error) : error;
  }

private:
  double last_ = 0;
};

/// Whether a step hardly pays.
inline bool has_stalled(const double error, const double last_error)
{
  constexpr double share = 0.5;
  return error > share * last_error;
}

/// Tells steps that are hard from easy ones, which stall once where nodes change their status. Far from the
/// solution many nodes do, and to solve some of them exactly helps little (docs/performance.md, "Multigrid").
class Stalls
{
public:
  /// Steps that have stalled near the solution, up to the one that has led to `error`.
  unsigned int number(const double error, const bool is_near)
  {
    const double before = std::exchange(last_, error);
    if (is_near && has_stalled(error, before))
      ++number_;
    return number_;
  }

private:
  double last_ = 0;
  unsigned int number_ = 0;
};

/// What the next step may do.
struct StepRule
{
  double accuracy;      ///< of its linear system
  double bound;         ///< that its error must stay below, N
  bool may_leap;        ///< as far as there are Allowances
  bool may_solve_node;  ///< exactly, in the same way
  bool may_solve_nodes; ///< several at once
};

/// Of the steps of one solution, in their order.
class Globalization
{
public:
  /// Behind an iterate with these errors of the law alone, and of law and equilibrium together (N).
  StepRule next(const double of_law, const double error, const double wanted)
  {
    constexpr unsigned int hopeless = 5; // stalls: one node at a time has not helped
    const bool is_near = nearness_.has_come(error);
    const unsigned int stalls = stalls_.number(error, is_near);
    return {forcing_.next(of_law, error, wanted), ridge_.height(error, is_near), is_near, stalls > 0,
            stalls >= hopeless};
  }

private:
  Nearness nearness_;
  Forcing forcing_;
  Ridge ridge_;
  Stalls stalls_;
};
} // namespace orthocone
