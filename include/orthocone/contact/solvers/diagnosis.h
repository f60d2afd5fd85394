// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/solvers/contact_solver.h>

#include <string>

namespace orthocone
{
/// Says in one or two sentences why a contact solver did not solve a step and what the user may try.
/// `is_dense`: whether there is a dense compliance, which allows more methods.
std::string diagnosis(const ContactSolverOptions &options, const SolverReport &report, bool is_dense);
} // namespace orthocone
