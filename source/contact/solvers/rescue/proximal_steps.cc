// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "proximal_steps.h"

#include <algorithm>
#include <utility>

namespace orthocone
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
constexpr double tighter = 0.1; // tolerance of the problems with a spring

bool is_singular(const MatrixXd &w)
{
  constexpr double rounding = 1e-12;
  const Eigen::LLT<MatrixXd> factor(w);
  if (factor.info() != Eigen::Success)
    return true;
  const VectorXd pivots = factor.matrixLLT().diagonal().cwiseAbs2();
  return !(pivots.minCoeff() > rounding * pivots.maxCoeff());
}

/// A contact system whose nodes hang on springs, too.
struct SystemWithSpring
{
  SystemWithSpring(const ContactSystem &system, const FrictionLaws &laws, const double alpha)
      : compliance(system.compliance().on_springs(alpha)),
        with_spring(*compliance, laws)
  {
  }

  // Newton's steps must be exact where a small spring alone holds forces.
  std::unique_ptr<Compliance> compliance;
  ContactSystem with_spring;
};
} // namespace

ProximalSteps::ProximalSteps(const ContactSystem &system, const ContactSolverOptions &options,
                             Make *const make)
    : system_(system),
      options_(options),
      make_(make)
{
  constexpr unsigned int most_iterations = 100; // a harder problem needs a softer spring
  options_.tolerance = tighter * options.tolerance;
  options_.maximum_iterations = std::min(options.maximum_iterations, most_iterations);
}

bool ProximalSteps::are_needed() const
{
  constexpr Index most_nodes = 500;
  const DenseView *const w = system_.compliance().dense();
  if (!are_needed_)
    are_needed_ = w != nullptr && system_.n_nodes() <= most_nodes && is_singular(*w);
  return *are_needed_;
}

bool ProximalSteps::are_needed_by_few_nodes() const
{
  constexpr Index few_nodes = 12;
  const DenseView *const w = system_.compliance().dense();
  const Index size = 3 * std::min(few_nodes, system_.n_nodes());
  return w != nullptr && is_singular(w->topLeftCorner(size, size));
}

/// From forces r, a step solves d = (q - alpha r) + (W + alpha I) r_new: at r_new = r this is d = q + W r.
/// The softness alpha is a share of the largest eigenvalue of W.
unsigned int ProximalSteps::improve(const ContactStep &step, VectorXd &unknowns,
                                    const unsigned int most_iterations) const
{
  constexpr unsigned int most_steps = 60, easy = 40;                                  // iterations
  constexpr double first = 1e-4, least = 1e-8, most = 0.5, softer = 5, stiffer = 0.5; // of the softness
  unsigned int n_iterations = 0;
  double share = first;
  for (unsigned int k = 0; k < most_steps && share < most && n_iterations < most_iterations; ++k)
  {
    const double alpha = share * system_.softness();
    const SystemWithSpring held(system_, step.laws(), alpha);
    const ContactStep problem(held.with_spring, step.q() - alpha * unknowns.head(step.q().size()),
                              step.face());
    VectorXd next = unknowns;
    const SolverReport report = make_(held.with_spring, options_)->solve(problem, next);
    n_iterations += report.iterations;
    if (!report.converged)
    {
      share *= softer;
      continue;
    }
    unknowns = std::move(next);
    if (step.residual(unknowns) <= options_.tolerance / tighter)
      break;
    if (report.iterations <= easy)
      share = std::max(least, stiffer * share);
  }
  return n_iterations;
}
} // namespace orthocone
