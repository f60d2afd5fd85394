// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "hardest_nodes.h"
#include "line_search.h"
#include "solvers.h"

#include <utility>

namespace orthocone
{
/// Of the linear systems of Newton's steps: a tighter bound costs more products than it saves iterations.
constexpr double inexactness_of_newton = 0.01;

/// Where steps stall, which inexact ones do sooner; what single precision gives without trouble.
constexpr double inexactness_of_stalled_newton = 1e-4;

/// One is no sign: easy steps stall where nodes change their status, and get over it inexactly.
constexpr unsigned int stalls_before_exactness = 2; // in a row

/// A step on the way to its solution.
struct NewtonProgress
{
  const ContactStep &step;
  Eigen::VectorXd &unknowns; ///< the best so far
  double residual;           ///< of them
  unsigned int iterations = 0;
  Trace trace{};
  BalanceWatch balance{};

  void note(const double residual_, const Eigen::VectorXd &unknowns_)
  {
    trace.add(iterations, residual_, step.force_scale(unknowns_));
  }

  /// Takes unknowns that are better than the best so far.
  void offer(Eigen::VectorXd candidate)
  {
    const double its_residual = step.residual(candidate);
    if (!(its_residual < residual))
      return;
    residual = its_residual;
    unknowns = std::move(candidate);
    note(residual, unknowns);
  }
};

/// Newton's steps on the natural map, which asks for the pressure first, up to the iterate where it is least.
/// Where a few nodes keep them short, these are solved by themselves.
class PressureFirstSteps
{
public:
  /// `conditions` and `hardest_nodes`, which may be null, must outlive the steps.
  PressureFirstSteps(const ContactSolverOptions &options, const ConditionSolver &conditions,
                     const HardestNodes *hardest_nodes);

  void iterate(NewtonProgress &progress) const;

private:
  bool pass_hardest_nodes(NewtonProgress &progress, Iterate &last, bool may_be_worse) const;
  Iterate start(const NewtonProgress &progress) const;

  ContactSolverOptions options_;
  const ConditionSolver &conditions_;
  const HardestNodes *hardest_nodes_;
};
} // namespace orthocone
