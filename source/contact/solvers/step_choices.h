// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <algorithm>
#include <utility>

namespace orthocone
{
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

/// Of the first error: errors below this share of it are near the solution.
constexpr double near_solution = 1e-3;

/// The error that a step must stay below. Near the solution it is the larger one of the last two errors.
/// Where slip is far from associated, the error may have a minimum beside the solution. Only a step across
/// the ridge between both leads out of it (Grippo, Lampariello and Lucidi, SIAM J. Numer. Anal. 23 (1986)
/// 707). Far from the solution such steps cost more than they save. docs/performance.md, "Multigrid".
class Ridge
{
public:
  double height(const double error)
  {
    if (first_ == 0)
      first_ = error;
    const double before = std::exchange(last_, error);
    return error <= near_solution * first_ ? std::max(before, error) : error;
  }

private:
  double first_ = 0, last_ = 0;
};

/// Whether a step hardly pays.
inline bool has_stalled(const double error, const double last_error)
{
  constexpr double share = 0.5;
  return error > share * last_error;
}

/// Tells steps that are hard from easy ones, which stall now and then where nodes change their status. Far
/// from the solution many nodes do, and to solve one of them exactly helps little (docs/performance.md,
/// "Multigrid").
class Stalls
{
public:
  /// Whether so many steps have stalled up to the one that has led to `error`.
  bool are_many(const double error)
  {
    constexpr unsigned int many = 2;
    if (first_ == 0)
      first_ = error;
    const double before = std::exchange(last_, error);
    if (error <= near_solution * first_ && has_stalled(error, before))
      ++n_;
    return n_ >= many;
  }

private:
  double first_ = 0, last_ = 0;
  unsigned int n_ = 0;
};

/// What the next step may do.
struct StepChoice
{
  double accuracy;     ///< of its linear system
  double bound;        ///< that its error must stay below, N
  bool may_solve_node; ///< exactly
};

/// Of the steps of one solution, in their order.
class StepChoices
{
public:
  /// Behind an iterate with these errors of the law alone, and of law and equilibrium together (N).
  StepChoice next(const double of_law, const double error, const double wanted)
  {
    return {forcing_.next(of_law, error, wanted), ridge_.height(error), stalls_.are_many(error)};
  }

private:
  Forcing forcing_;
  Ridge ridge_;
  Stalls stalls_;
};
} // namespace orthocone
