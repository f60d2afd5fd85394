// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/contact/solvers/diagnosis.h>

#include "newton/inexact_newton.h"

#include <orthocone/base/text.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace orthocone
{
namespace
{
/// The method to work with.
std::string best_method()
{
  return ContactSolverOptions().method;
}

/// How many iterations would have been enough for the part of the step that was tried last, or 0 if this is
/// not known.
double enough_iterations(const ContactSolverOptions &options, const SolverReport &report)
{
  const double more = iterations_to_go(report.trace.points(), options.tolerance);
  return more > 0 ? report.trace.points().back().iterations + more : 0;
}

double least_residual(const SolverReport &report)
{
  double least = report.residual;
  for (const TracePoint &point : report.trace.points())
    least = std::min(least, point.residual);
  return least;
}

std::string why(const ContactSolverOptions &options, const SolverReport &report)
{
  std::ostringstream text;
  text << std::setprecision(2);
  switch (report.verdict)
  {
  case Verdict::slow:
    text << "The iteration is slow: "
         << (enough_iterations(options, report) > 0 ? "the residual still fell at the end"
                                                    : "too few iterations to say more");
    break;
  case Verdict::rounding:
    text << "Rounding stops the iteration: the residual came down to " << least_residual(report);
    break;
  case Verdict::cycling:
    text << "The iteration cycles: the residual was " << least_residual(report)
         << " at best and does not fall any more";
    break;
  case Verdict::diverged:
    text << "The iteration diverges: the forces "
         << (std::isfinite(report.residual) ? "grow without bound" : "are no longer numbers");
    break;
  case Verdict::unbalanced:
    text << "No equilibrium: the load on the held face is more than contact and friction can carry";
    break;
  case Verdict::several:
    text << "Several solutions near here: with friction growing from none, the solution turns back first at "
         << report.folds.first_share << " of the friction of this step, and " << report.folds.n
         << (report.folds.n == 1 ? " time" : " times") << " in all before the search ended";
    break;
  case Verdict::converged:
    break;
  }
  return text.str();
}

std::string more_iterations(const ContactSolverOptions &options, const SolverReport &report)
{
  std::ostringstream text;
  text << "Try more Contact solver/Maximum iterations";
  if (const double enough = enough_iterations(options, report); enough > 0)
    text << " (at this rate, some " << std::setprecision(0) << std::fixed << enough
         << " for each part of the step)";
  text << (options.method == best_method() ? "." : ", or Method = " + best_method() + ".");
  return text.str();
}

/// Residuals below are next to rounding where directions or nodes differ much in compliance, and no smaller
/// load step takes them further.
constexpr double most_to_accept = 1e-8;

std::string tolerance_above(const double residual)
{
  std::ostringstream text;
  text << std::setprecision(1) << std::scientific << "This is near rounding: a Contact solver/Tolerance of "
       << 2 * residual << " accepts it.";
  return text.str();
}

std::string less_friction(const SolverReport &report)
{
  std::ostringstream text;
  text << std::setprecision(2) << "Friction coefficients below " << report.folds.first_share
       << " of these have one solution on this way; or take a slip rule nearer to the associated one, or "
          "smaller load steps.";
  return text.str();
}

std::string remedy(const ContactSolverOptions &options, const SolverReport &report, const bool is_dense)
{
  const bool is_default = options.method == best_method() && options.rho_factor == 1;
  const bool may_iterate_more = is_dense || options.maximum_iterations < most_inexact_iterations;
  if (report.verdict == Verdict::slow && may_iterate_more)
    return more_iterations(options, report);
  if (report.verdict == Verdict::unbalanced)
    return "Take smaller forces in this leg, or a motion.";
  if (report.verdict == Verdict::rounding)
    return "Take a larger Contact solver/Tolerance.";
  if (report.verdict == Verdict::several)
    return less_friction(report);
  if (!is_default)
    return "Try Contact solver/Method = " + best_method() + " with Rho factor = 1.";
  if (!std::isfinite(report.residual))
    return "Are lengths in mm, forces in N, moduli in MPa?";
  if (!is_dense)
    return "Try smaller load steps, or Mesh/Backend = condensed, where the program can try more strategies.";
  if (const double least = least_residual(report);
      report.verdict == Verdict::cycling && least < most_to_accept)
    return tolerance_above(least);
  return "Try smaller load steps or Contact solver/Method = gauss-seidel; near incompressibility, try "
         "Mesh/Volumetric quadrature = projected; and see the line on the critical friction in log.txt.";
}
} // namespace

std::string diagnosis(const ContactSolverOptions &options, const SolverReport &report, const bool is_dense)
{
  return why(options, report) + ". " + remedy(options, report, is_dense);
}
} // namespace orthocone
