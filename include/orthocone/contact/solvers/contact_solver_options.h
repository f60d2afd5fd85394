// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <string>

namespace orthocone
{
/// The entries of section Contact solver.
struct ContactSolverOptions
{
  std::string method = "newton";          ///< word of a ContactMethod
  double tolerance = 1e-10;               ///< bound of ContactStep::residual(), relative
  unsigned int maximum_iterations = 5000; ///< sweeps or iterations of one step
  double relaxation = 1;                  ///< of sweeps: the share of the one-node solution that is taken
  double rho_factor = 1;                  ///< of the methods that have a rho of their own
};
} // namespace orthocone
