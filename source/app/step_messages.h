// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Texts on a run besides its steps, and on a step at which it ends.
#pragma once

#include <orthocone/contact/solvers/contact_solver.h>
#include <orthocone/output/log.h>
#include <orthocone/scene/load_program.h>
#include <orthocone/scene/scene.h>

#include <string>
#include <vector>

namespace orthocone
{
/// Text for a step of the program `steps` that no halving solves, and what to try.
std::string unsolved_step_text(const LoadStep &step, const LoadSteps &steps,
                               const ContactSolverOptions &options, const SolverReport &report,
                               const Scene &scene);

/// Text for a step that forces drive beyond what can be carried. `carried`: StepSolver::carried_share().
std::string no_equilibrium_text(const LoadStep &step, const LoadSteps &steps, double carried,
                                const BodyUnknowns &unknowns);

/// Text for a run that had to compute too many steps, because fewer cycles were jumped than might have been.
std::string too_few_jumps_text(std::size_t n_computed, std::size_t n_left);

/// Text for a step that is solved, but does not pass the check that `which` names.
std::string wrong_step_text(const LoadStep &step, const LoadSteps &steps, const std::string &which,
                            BodyBackend backend);

/// Text for a step that cannot be solved because the body cannot; `why` says why.
std::string broken_step_text(const LoadStep &step, const LoadSteps &steps, const std::string &why);

/// Writes the lines of a log behind the model: versions of the libraries, and warnings.
void report_versions_and_warnings(const Parameters &parameters, Log &log);
} // namespace orthocone
