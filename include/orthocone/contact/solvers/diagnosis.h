// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/solvers/contact_solver.h>

#include <string>

namespace orthocone
{
/// Why a contact solver did not solve a step, and what the user may try, in one or two sentences. `is_dense`:
/// whether there is a dense compliance, with which a solver can do more.
std::string diagnosis(const ContactSolverOptions &options, const SolverReport &report, bool is_dense);
} // namespace orthocone
