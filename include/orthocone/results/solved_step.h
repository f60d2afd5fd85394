// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/solvers/contact_solver.h>
#include <orthocone/results/step_checks.h>
#include <orthocone/results/totals.h>
#include <orthocone/scene/load_program.h>

#include <string>

namespace orthocone
{
/// A solved step, as the tables list it.
struct SolvedStep
{
  const ContactState &state;
  const Totals &before; ///< of the step before
  const Totals &totals;
  const SolverReport &report;
  const StepChecks &checks;
  double seconds; ///< wall time of the solver
  LoadStep step{};
  std::string method = ContactSolverOptions().method; ///< word of a ContactMethod
  std::string driven{};        ///< components of the held face that the step drives, such as "ux uy uz"
  unsigned int n_v_cycles = 0; ///< on the finest mesh, since the step before
  unsigned int n_gmres_iterations = 0; ///< Compliance::n_gmres_iterations() since the step before
};
} // namespace orthocone
