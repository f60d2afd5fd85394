// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "../newton/globalization.h"

#include <orthocone/contact/solvers/contact_solver.h>

namespace orthocone
{
/// Whether a step that Newton's method does not solve is followed from easier friction laws (Continuation).
enum class Continue
{
  from_easier,
  never
};

/// The method `newton` where the backend has no dense compliance.
std::unique_ptr<ContactSolver> make_whole_body_newton(const ContactSystem &system,
                                                      const ContactSolverOptions &options,
                                                      const Allowances &allowances = {},
                                                      Continue from = Continue::from_easier);
} // namespace orthocone
