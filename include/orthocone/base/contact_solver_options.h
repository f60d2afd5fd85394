// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

namespace orthocone
{
/// Contact solvers.
enum class ContactMethod
{
  newton,
  gauss_seidel,
  uzawa,
  feng2006,
  box3,
  plain_newton,
};

/// Section Contact solver.
struct ContactSolverOptions
{
  ContactMethod method = ContactMethod::newton;
  double tolerance = 1e-10;               ///< bound of the relative natural-map residual
  unsigned int maximum_iterations = 5000; ///< sweeps or iterations of one step
  double relaxation = 1;                  ///< of the sweeps: share of the one-node solution that is taken
  double rho_factor = 1;                  ///< of the methods that have a rho of their own
};
} // namespace orthocone
