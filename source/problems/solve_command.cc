// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "solve_command.h"
#include "solve_options.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/machine.h>
#include <orthocone/base/stopwatch.h>
#include <orthocone/base/text.h>
#include <orthocone/base/threads.h>
#include <orthocone/contact/solvers/contact_method.h>
#include <orthocone/contact/solvers/contact_solver.h>
#include <orthocone/problems/problem_file.h>
#include <orthocone/surface/given_compliance.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <memory>
#include <new>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace orthocone
{
namespace
{
void set_laws(const SolveOptions &options, std::vector<OrthotropicFriction> &laws)
{
  for (OrthotropicFriction &law : laws)
  {
    if (options.friction)
    {
      const auto &[x, y] = *options.friction;
      law = {x, y, x, y};
    }
    if (options.slip)
      law = {law.mu()[0], law.mu()[1], options.slip->first, options.slip->second};
  }
}

FreeFace face_of(const ContactProblem &problem)
{
  if (problem.face.cols() == 0)
    return {};
  try
  {
    return {problem.face, problem.balance};
  }
  catch (const std::invalid_argument &)
  {
    throw FileError(shown_path(problem.title) +
                    ": the constraints (fclib_local/V) are not independent of each other");
  }
}

/// Prints a line of names and a line of values.
void print_csv(const std::vector<std::pair<std::string, std::string>> &values, std::ostream &out)
{
  for (const bool is_name : {true, false})
    for (std::size_t i = 0; i < values.size(); ++i)
      out << (is_name ? values[i].first : values[i].second) << (i + 1 < values.size() ? "," : "\n");
}

std::string short_text(const double value)
{
  std::ostringstream text;
  text << std::setprecision(3) << value;
  return text.str();
}

struct Answer
{
  SolverReport report;
  ProblemSolution solution;
  double seconds = 0;                   ///< of the solver and its preparation
  std::optional<StoredErrors> stored{}; ///< where the solution is that in the file
};

using Values = std::vector<std::pair<std::string, std::string>>;

/// A solver's verdict tells how it failed; forces from a file can only be right or wrong.
std::string verdict_of(const Answer &answer)
{
  return !answer.stored || answer.report.converged ? to_word(answer.report.verdict) : "unsolved";
}

Values values_of(const SolveOptions &options, const ContactProblem &problem, const Answer &answer)
{
  const SolverReport &report = answer.report;
  Values values{{"nodes", std::to_string(problem.laws.size())},
                {"constraints", std::to_string(problem.face.cols())},
                {"method", options.is_stored ? "stored" : options.solver.method},
                {"verdict", verdict_of(answer)},
                {"iterations", std::to_string(report.iterations)},
                {"seconds", short_text(answer.seconds)},
                {"residual", short_text(report.residual)},
                {"fclib_error", short_text(fclib_error(problem, answer.solution))},
                {"penetration", short_text(report.law.penetration)},
                {"complementarity", short_text(report.law.complementarity)},
                {"friction_cone", short_text(report.law.friction_cone)},
                {"slip_rule", short_text(report.law.slip_rule)},
                {"w_asymmetry", short_text(problem.mirrored.largest)}};
  if (report.folds.n > 0)
    values.emplace_back("first_fold_of_friction", short_text(report.folds.first_share));
  if (answer.stored)
  {
    values.emplace_back("stored_u_error", short_text(answer.stored->displacement));
    values.emplace_back("stored_l_error", short_text(answer.stored->multiplier));
  }
  return values;
}

/// Says where the file has something else beside the forces than they imply.
void print_contradictions(const StoredErrors &stored, std::ostream &out)
{
  constexpr double rounding = 1e-10;
  if (stored.displacement > rounding)
    out << "The stored velocities (solution/u) are not W r + q. All other numbers are of the forces alone.\n";
  if (stored.multiplier > rounding)
    out << "The stored multipliers (solution/l) do not obey the constraints.\n";
}

void print(const SolveOptions &options, const ContactProblem &problem, const GivenCompliance &given,
           const Answer &answer, std::ostream &out)
{
  const Values values = values_of(options, problem, answer);
  if (options.is_csv)
    return print_csv(values, out);
  for (const auto &[name, value] : values)
    out << std::left << std::setw(17) << name << value << '\n';
  for (const std::string &note : given.notes())
    out << note << '\n';
  if (answer.stored)
    print_contradictions(*answer.stored, out);
}

/// W as it may be used. Forces in the file may press where a node cannot move: they are judged by W itself.
GivenCompliance compliance_of(const SolveOptions &options, const ContactProblem &problem)
{
  const DenseView w(problem.w.data(), problem.w.rows(), problem.w.cols());
  try
  {
    if (problem.face.cols() > 0 && !immobile_directions(w).empty())
      throw std::invalid_argument("W has zeros on its diagonal beside constraints, which is not supported");
    if (!options.is_stored)
      return given_compliance(w, problem.q, problem.mirrored);
    const double indefiniteness = check_compliance(w, problem.mirrored);
    return {std::make_unique<DenseCompliance>(w), problem.mirrored.largest, indefiniteness};
  }
  catch (const std::invalid_argument &error)
  {
    throw FileError(shown_path(problem.title) + ": " + error.what());
  }
}

/// The unknowns of the solution in the file.
Eigen::VectorXd stored_unknowns(const std::string &file, const ContactStep &step)
{
  const auto stored = read_solution(file);
  if (!stored)
    throw FileError(shown_path(file) + ": there is no solution in it (group solution)");
  if (stored->motions.size() != step.face().n())
    throw FileError(shown_path(file) + ": solution/l has " + std::to_string(stored->motions.size()) +
                    " values where there are " + std::to_string(step.face().n()) + " constraints");
  Eigen::VectorXd unknowns(step.n_unknowns());
  unknowns << stored->force, step.face().unknowns(stored->motions);
  return unknowns;
}

Answer answer(const SolveOptions &options, const ContactProblem &problem, const Compliance &compliance)
{
  const Stopwatch watch;
  const ContactSystem system(compliance, {problem.laws.begin(), problem.laws.end()});
  const ContactStep step(system, problem.q, face_of(problem));
  Answer found;
  Eigen::VectorXd unknowns =
      options.is_stored ? stored_unknowns(options.file, step) : Eigen::VectorXd::Zero(step.n_unknowns());
  found.report = options.is_stored
                     ? make_report(step, unknowns, 0, options.solver.tolerance)
                     : solve_or_rescue(*make_contact_solver(system, options.solver), step, unknowns);
  found.seconds = watch.seconds();
  found.solution = {unknowns.head(problem.q.size()), step.displacement(unknowns),
                    step.face().motions(unknowns.tail(step.face().n())), found.report.residual};
  return found;
}

ExitCode solve(const SolveOptions &options, std::ostream &out)
{
  if (!options.write.empty())
    require_place_for_problem(options.write); // known before the work
  ContactProblem problem = read_problem(options.file);
  set_laws(options, problem.laws);
  const BlasThreads threads(problem.q.size());
  const GivenCompliance given = compliance_of(options, problem);
  Answer found;
  std::vector<double> seconds;
  for (unsigned int i = 0; i < options.n_repeats; ++i)
  {
    found = answer(options, problem, *given.compliance);
    seconds.push_back(found.seconds);
  }
  const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
  std::nth_element(seconds.begin(), middle, seconds.end());
  found.seconds = *middle;
  if (options.is_stored)
    found.stored = stored_errors(options.file);
  print(options, problem, given, found, out);
  if (!options.write.empty())
    write_problem(problem, found.solution, options.write);
  return found.report.converged ? ExitCode::done : ExitCode::unsolved_step;
}

void print_help(std::ostream &out)
{
  out << solve_usage;
  for (const ContactMethod &method : contact_methods())
    out << "  " << std::left << std::setw(19) << method.word << method.help << '\n';
}
} // namespace

int solve_command(const std::vector<std::string> &arguments, std::ostream &out, std::ostream &errors)
{
  const auto failed = [&](const std::string &message, const ExitCode code)
  {
    errors << shown_message("orthocone-solve: " + message) + "\n";
    return static_cast<int>(code);
  };
  try
  {
    const SolveOptions options = read_solve_options(arguments);
    if (options.is_help)
    {
      print_help(out);
      return static_cast<int>(ExitCode::done);
    }
    require_address_space();
    map_blas_buffers(2 * blas_threads());
    return static_cast<int>(solve(options, out));
  }
  catch (const FileError &error)
  {
    return failed(error.what(), ExitCode::file_error);
  }
  catch (const std::bad_alloc &)
  {
    return failed("memory ran out", ExitCode::unsolved_step);
  }
  catch (const std::exception &error)
  {
    return failed(error.what(), ExitCode::wrong_input);
  }
}
} // namespace orthocone
