// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/results/solved_step.h>

namespace orthocone
{
/// Throws InputError where Output/Problems is set, but problems cannot be written.
void require_writable_problems(const Parameters &parameters, const ModelSymmetry &symmetry);

/// Writes what was solved last in a step, all of the step or its last part, as a problem of FCLIB. Throws
/// FileError.
void write_step_problem(const SolvedStep &step, const std::string &file);

/// Writes the problem of a step that is not solved, or of its part, without a solution. Throws FileError.
void write_unsolved_problem(const LoadStep &step, const ContactStep &problem, const std::string &file);
} // namespace orthocone
