// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "solve_command.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/stopwatch.h>
#include <orthocone/base/threads.h>
#include <orthocone/contact/solvers/contact_method.h>
#include <orthocone/contact/solvers/contact_solver.h>
#include <orthocone/problems/problem_file.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <new>
#include <optional>
#include <sstream>
#include <tuple>
#include <utility>

namespace orthocone
{
namespace
{
using Pair = std::pair<double, double>;

struct SolveOptions
{
  std::string file{};
  std::string write{};
  std::optional<Pair> friction{}, slip{};
  ContactSolverOptions solver{};
  unsigned int n_repeats = 1;
  bool is_stored = false;
  bool is_csv = false;
  bool is_help = false;
};

const char *const usage =
    "orthocone-solve FILE.hdf5 [options]: solves a contact problem in FCLIB's format (local, 3-D)\n"
    "  --method WORD        contact solver (newton)\n"
    "  --tolerance NUMBER   bound of the residual (1e-10)\n"
    "  --iterations NUMBER  sweeps or iterations at most (5000)\n"
    "  --friction MU_X,MU_Y friction of all nodes, instead of that of the file\n"
    "  --slip P_X,P_Y       slip ellipse of all nodes, instead of that of the file\n"
    "  --repeat NUMBER      solves so many times, and prints the median of the seconds (1)\n"
    "  --stored             judges the solution in the file, instead of solving\n"
    "  --write FILE.hdf5    writes the problem and the solution\n"
    "  --csv                prints a line of names and a line of values\n"
    "Methods:\n";

double number(const std::string &option, const std::string &text, const double least, const double below)
{
  std::istringstream in(text);
  double value = 0;
  if (!(in >> value) || !in.eof() || !(value > least && value < below))
  {
    std::ostringstream message;
    message << option << " = '" << text << "': allowed is " << least << " < number < " << below;
    throw InputError(message.str());
  }
  return value;
}

Pair two_numbers(const std::string &option, const std::string &text)
{
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos)
    throw InputError(option + " = '" + text + "': allowed are two numbers > 0, such as 0.3,0.15");
  return {number(option, text.substr(0, comma), 0, 1e6), number(option, text.substr(comma + 1), 0, 1e6)};
}

void take(SolveOptions &options, const std::string &option, const std::string &value)
{
  if (option == "--method")
    options.solver.method = value;
  else if (option == "--tolerance")
    options.solver.tolerance = number(option, value, 0, 1);
  else if (option == "--iterations")
    options.solver.maximum_iterations = static_cast<unsigned int>(number(option, value, 0.5, 4e9));
  else if (option == "--repeat")
    options.n_repeats = static_cast<unsigned int>(number(option, value, 0.5, 1e4));
  else if (option == "--friction")
    options.friction = two_numbers(option, value);
  else if (option == "--slip")
    options.slip = two_numbers(option, value);
  else if (option == "--write")
    options.write = value;
  else
    throw InputError("there is no option '" + option + "'; --help lists them");
}

SolveOptions parsed(const std::vector<std::string> &arguments)
{
  SolveOptions options;
  for (std::size_t i = 0; i < arguments.size(); ++i)
    if (arguments[i] == "--help")
      options.is_help = true;
    else if (arguments[i] == "--csv")
      options.is_csv = true;
    else if (arguments[i] == "--stored")
      options.is_stored = true;
    else if (arguments[i].rfind("--", 0) != 0)
    {
      if (!options.file.empty())
        throw InputError("one file at a time: '" + options.file + "' and '" + arguments[i] + "'");
      options.file = arguments[i];
    }
    else if (const std::size_t sign = arguments[i].find('='); sign != std::string::npos)
      take(options, arguments[i].substr(0, sign), arguments[i].substr(sign + 1));
    else if (i + 1 < arguments.size())
    {
      take(options, arguments[i], arguments[i + 1]);
      ++i;
    }
    else
      throw InputError("option '" + arguments[i] + "' wants a value; --help lists them");
  if (options.file.empty() && !options.is_help)
    throw InputError("which file? --help says more");
  if (find_contact_method(options.solver.method) == nullptr)
    throw InputError("--method = '" + options.solver.method + "': --help lists the methods");
  return options;
}

void set_laws(const SolveOptions &options, std::vector<OrthotropicFriction> &laws)
{
  for (OrthotropicFriction &law : laws)
  {
    if (options.friction)
    {
      std::tie(law.mu_x, law.mu_y) = *options.friction;
      law.p_x = law.mu_x;
      law.p_y = law.mu_y;
    }
    if (options.slip)
      std::tie(law.p_x, law.p_y) = *options.slip;
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
    throw FileError(problem.title + ": the constraints (fclib_local/V) are not independent of each other");
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

void print(const SolveOptions &options, const ContactProblem &problem, const SolverReport &report,
           const double seconds, const double error, std::ostream &out)
{
  const std::vector<std::pair<std::string, std::string>> values{
      {"nodes", std::to_string(problem.laws.size())},
      {"constraints", std::to_string(problem.face.cols())},
      {"method", options.is_stored ? "stored" : options.solver.method},
      {"verdict", to_word(report.verdict)},
      {"iterations", std::to_string(report.iterations)},
      {"seconds", short_text(seconds)},
      {"residual", short_text(report.residual)},
      {"fclib_error", short_text(error)},
      {"penetration", short_text(report.law.penetration)},
      {"complementarity", short_text(report.law.complementarity)},
      {"friction_cone", short_text(report.law.friction_cone)},
      {"slip_rule", short_text(report.law.slip_rule)}};
  if (options.is_csv)
    return print_csv(values, out);
  for (const auto &[name, value] : values)
    out << std::left << std::setw(17) << name << value << '\n';
}

/// The unknowns of the solution in the file.
Eigen::VectorXd stored_unknowns(const std::string &file, const ContactStep &step)
{
  const auto stored = read_solution(file);
  if (!stored || stored->motions.size() != step.face().n())
    throw FileError(file + ": there is no solution of all unknowns in it (group solution)");
  Eigen::VectorXd unknowns(step.n_unknowns());
  unknowns << stored->force, step.face().unknowns(stored->motions);
  return unknowns;
}

struct Answer
{
  SolverReport report;
  ProblemSolution solution;
  double seconds = 0; ///< of the solver and its preparation
};

Answer answer(const SolveOptions &options, const ContactProblem &problem)
{
  const Stopwatch watch;
  const DenseCompliance compliance(DenseView(problem.w.data(), problem.w.rows(), problem.w.cols()));
  const ContactSystem system(compliance, problem.laws);
  const ContactStep step(system, problem.q, face_of(problem));
  Eigen::VectorXd unknowns =
      options.is_stored ? stored_unknowns(options.file, step) : Eigen::VectorXd::Zero(step.n_unknowns());
  Answer found;
  found.report = options.is_stored ? make_report(step, unknowns, 0, options.solver.tolerance)
                                   : make_contact_solver(system, options.solver)->solve(step, unknowns);
  found.seconds = watch.seconds();
  found.solution = {unknowns.head(problem.q.size()), step.displacement(unknowns),
                    step.face().motions(unknowns.tail(step.face().n())), found.report.residual};
  return found;
}

ExitCode solve(const SolveOptions &options, std::ostream &out)
{
  ContactProblem problem = read_problem(options.file);
  set_laws(options, problem.laws);
  const BlasThreads threads(problem.q.size());
  Answer found;
  std::vector<double> seconds;
  for (unsigned int i = 0; i < options.n_repeats; ++i)
  {
    found = answer(options, problem);
    seconds.push_back(found.seconds);
  }
  const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
  std::nth_element(seconds.begin(), middle, seconds.end());
  print(options, problem, found.report, *middle, fclib_error(problem, found.solution), out);
  if (!options.write.empty())
    write_problem(problem, found.solution, options.write);
  return found.report.converged ? ExitCode::done : ExitCode::unsolved_step;
}

void print_help(std::ostream &out)
{
  out << usage;
  for (const ContactMethod &method : contact_methods())
    out << "  " << std::left << std::setw(19) << method.word << method.help << '\n';
}
} // namespace

int solve_command(const std::vector<std::string> &arguments, std::ostream &out, std::ostream &errors)
{
  const auto failed = [&](const std::string &message, const ExitCode code)
  {
    errors << "orthocone-solve: " << message << '\n';
    return static_cast<int>(code);
  };
  try
  {
    const SolveOptions options = parsed(arguments);
    if (!options.is_help)
      return static_cast<int>(solve(options, out));
    print_help(out);
    return static_cast<int>(ExitCode::done);
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
