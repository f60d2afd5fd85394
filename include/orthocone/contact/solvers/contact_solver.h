// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/problem/convergence.h>
#include <orthocone/contact/problem/law_errors.h>
#include <orthocone/contact/solvers/contact_solver_options.h>

#include <memory>
#include <optional>

namespace orthocone
{
/// A contact problem and its solution.
struct SolvedProblem
{
  ContactStep problem;
  Eigen::VectorXd unknowns; ///< size ContactStep::n_unknowns(), N and mm
};

/// Where the path of a step's solutions over a growing share of its friction turns back. Behind a fold there
/// are several solutions for the shares that the path passes again.
struct Folds
{
  unsigned int n = 0;
  double first_share = 0; ///< of the friction, at the first fold
};

/// A solver's report on one load step. All numbers are recomputed from the final forces by make_report(), so
/// that no solver judges itself.
struct SolverReport
{
  bool converged = false;
  unsigned int iterations = 0; ///< sweeps and Newton iterations together
  double residual = 0;         ///< ContactStep::residual()
  Eigen::Index worst_node = 0; ///< node with the largest part of the residual
  double penetration = 0;      ///< largest -gap (mm), the paper's own measure of convergence
  unsigned int n_parts = 1;    ///< 1, unless the step had to be divided
  bool is_released = false; ///< nothing presses any more: the face has its first motion that opens all nodes
  LawErrors law;            ///< errors of the same solution in the contact law's own terms
  Trace trace{};            ///< of the step, or of its part that failed
  Verdict verdict = Verdict::slow;
  Folds folds{}; ///< where the step was followed from no friction: ContactSolver::rescue()
  std::shared_ptr<const SolvedProblem> last_part{}; ///< in a march: the part of the step that was solved last
};

/// Report on `unknowns` as the solution of `step`, whoever found them. `tolerance` bounds the residual.
SolverReport make_report(const ContactStep &step, const Eigen::VectorXd &unknowns, unsigned int iterations,
                         double tolerance, Trace trace = {});

/// Solver of the contact problem of a load step. A failure to converge is a value of the report, not an
/// exception.
class ContactSolver
{
public:
  virtual ~ContactSolver() = default;

  /// Improves `unknowns` (ContactStep; on entry the start) until the residual of the step is within the
  /// tolerance. Throws SolveError where the body itself cannot be solved (multigrid).
  virtual SolverReport solve(const ContactStep &step, Eigen::VectorXd &unknowns) const = 0;

  /// What is left for a step that solve() fails on, whatever it starts from and in parts, too. It costs as
  /// much as many failures. Returns nothing where the method has no such thing, or it does not tell anything
  /// new; `unknowns` are changed only where they are a solution.
  virtual std::optional<SolverReport> rescue(const ContactStep & /*step*/,
                                             Eigen::VectorXd & /*unknowns*/) const
  {
    return std::nullopt;
  }
};

/// ContactSolver::solve(), and rescue() where that fails. The iterations are those of both.
SolverReport solve_or_rescue(const ContactSolver &solver, const ContactStep &step, Eigen::VectorXd &unknowns);

/// The solver that the options name, for all steps of `system`, which must outlive it. Construction prepares
/// what stays the same from step to step. Throws std::invalid_argument if there is no such method, or if it
/// needs what the backend of the compliance does not have.
std::unique_ptr<ContactSolver> make_contact_solver(const ContactSystem &system,
                                                   const ContactSolverOptions &options);
} // namespace orthocone
