// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// What users read of a run besides its steps, and of a step at which it ends.
#pragma once

#include <orthocone/contact/solvers/contact_solver.h>
#include <orthocone/output/log.h>
#include <orthocone/scene/load_program.h>
#include <orthocone/scene/scene.h>

#include <string>
#include <vector>

namespace orthocone
{
/// Of a step of the program `steps` that no halving solves, and what to try.
std::string unsolved_step_text(const LoadStep &step, const std::vector<LoadStep> &steps,
                               const ContactSolverOptions &options, const SolverReport &report,
                               const Scene &scene);

/// Of a step that forces drive beyond what can be carried. `carried`: StepSolver::carried_share().
std::string no_equilibrium_text(const LoadStep &step, const std::vector<LoadStep> &steps, double carried);

/// Of a step that is solved, but does not pass the check that `which` tells.
std::string wrong_step_text(const LoadStep &step, const std::vector<LoadStep> &steps,
                            const std::string &which);

/// Of a step that cannot be solved because the body cannot, which `why` tells.
std::string broken_step_text(const LoadStep &step, const std::vector<LoadStep> &steps,
                             const std::string &why);

/// What a log begins with, behind the model.
void tell_versions_and_warnings(const Parameters &parameters, Log &log);
} // namespace orthocone
