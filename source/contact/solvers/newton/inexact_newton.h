// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "../solvers.h"
#include "globalization.h"
#include "newton_steps.h"

namespace orthocone
{
/// Iterations of Newton's method without a dense compliance: more have never helped, and each is expensive.
constexpr unsigned int most_inexact_iterations = 60;

/// Newton's method where the backend has no dense compliance, on one map. rescue/ladder.h has the order in
/// which maps are tried.
std::unique_ptr<ContactSolver> make_inexact_newton(const ContactSystem &system,
                                                   const ContactSolverOptions &options,
                                                   const Allowances &allowances = {}, Map *map = linearize);
} // namespace orthocone
