// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/simulation/diagnosis.h>

#include <orthocone/parameters/text.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace orthocone
{
namespace
{
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
    text << "The iteration is slow: the residual still falls";
    if (const double more = iterations_to_go(report.trace.points(), options.tolerance); more > 0)
      text << ", and at this rate " << std::setprecision(1) << std::scientific << more
           << " iterations more would do";
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
  case Verdict::converged:
    break;
  }
  return text.str();
}

std::string remedy(const ContactSolverOptions &options, const SolverReport &report)
{
  const bool is_default = options.method == ContactMethod::newton;
  switch (report.verdict)
  {
  case Verdict::slow:
    return std::string("Try more Contact solver/Maximum iterations") +
           (is_default ? "." : ", or Method = newton.");
  case Verdict::rounding:
    return "Take a larger Contact solver/Tolerance.";
  case Verdict::diverged:
    if (!std::isfinite(report.residual))
      return "Are lengths in mm, forces in N, moduli in MPa?";
    break;
  default:
    break;
  }
  return is_default ? "Try smaller load steps or Contact solver/Method = gauss-seidel; where friction is "
                      "above the critical "
                      "one, there may be no solution next to the last state."
                    : "Try Contact solver/Method = newton.";
}
} // namespace

std::string diagnosis(const ContactSolverOptions &options, const SolverReport &report)
{
  return why(options, report) + ". " + remedy(options, report);
}
} // namespace orthocone
