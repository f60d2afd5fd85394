// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/solvers/contact_solver_options.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace orthocone
{
/// What the command line of orthocone-solve asks for.
struct SolveOptions
{
  std::string file{};
  std::string write{};
  std::optional<std::pair<double, double>> friction{}, slip{};
  ContactSolverOptions solver{};
  unsigned int n_repeats = 1;
  bool is_stored = false;
  bool is_csv = false;
  bool is_help = false;
};

/// Reads the words of the command line. Throws InputError.
SolveOptions read_solve_options(const std::vector<std::string> &arguments);

/// What --help prints before the methods.
extern const char *const solve_usage;
} // namespace orthocone
