// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/output/step_problem.h>

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>
#include <orthocone/body/shapes/shape_kind.h>

#include <stdexcept>

// Only a program that is built with FCLIB has this header.
#if __has_include(<orthocone/problems/problem_file.h>)
#define ORTHOCONE_WRITES_PROBLEMS
#include <orthocone/problems/problem_file.h>
#endif

namespace orthocone
{
namespace
{
#ifdef ORTHOCONE_WRITES_PROBLEMS
constexpr bool has_fclib = true;
#else
constexpr bool has_fclib = false;
#endif
} // namespace

void require_writable_problems(const Parameters &parameters, const ModelSymmetry &symmetry)
{
  if (parameters.output.problem_interval == 0)
    return;
  const std::string entry = "Output/Problems = " + std::to_string(parameters.output.problem_interval);
  if (parameters.mesh.backend == BodyBackend::multigrid)
    throw InputError(entry +
                     " with Mesh/Backend = multigrid, which has no matrix W to write: allowed is 0, or "
                     "Backend = auto or condensed");
  constexpr double most = 2000; // nodes, whose W has 288 MB
  const ShapeKind &shape = kind_of(parameters.geometry);
  if (!shape.is_meshed() &&
      make_shape(parameters.geometry, parameters.mesh)->size(symmetry).contact_nodes > most)
    throw InputError(entry + " with " + parameters.geometry.shape_entry() + " and more than " +
                     to_text(most) + " patches, whose W is not written: allowed is 0, or fewer Mesh/Cells");
  if (symmetry.is_axisymmetric())
    throw InputError(entry +
                     " with the axisymmetric model, whose nodes are rings: allowed is 0, or Mesh/Model "
                     "= full, half or quarter");
  if (!parameters.friction.has_ellipses())
    throw InputError(entry + " with Friction/Law = " + parameters.friction.law.word() +
                     ", and FCLIB knows cones of ellipses only: allowed is 0, or Friction/Law = ellipses");
  if (LoadProgram(parameters.load).has_forces() && !parameters.friction.is_associated())
    throw InputError(entry +
                     " with forces in the load program and a slip rule that is not associated, which "
                     "have no common form in FCLIB: allowed is 0, or Friction/Slip potential = associated");
  if (!has_fclib)
    throw InputError(entry + ": this program was built without FCLIB; 'tools/setup.sh release problems' "
                             "installs it and builds the program with it; allowed is 0");
}

#ifdef ORTHOCONE_WRITES_PROBLEMS
namespace
{
std::string title_of(const SolvedStep &step)
{
  const unsigned int n_parts = step.report.n_parts;
  return "load step " + std::to_string(step.step.number) +
         (n_parts > 1 ? ", the last of the " + std::to_string(n_parts) + " parts that it was solved in"
                      : "") +
         (step.report.is_released ? ", in which nothing presses" : "");
}

/// W, whose columns are products where it is no matrix.
Eigen::MatrixXd matrix_of(const Compliance &compliance)
{
  if (const DenseView *const w = compliance.dense())
    return w->selfadjointView<Eigen::Lower>();
  const Eigen::Index n = 3 * compliance.n_nodes();
  Eigen::MatrixXd matrix(n, n);
  NodeVector column;
  for (Eigen::Index i = 0; i < n; ++i)
  {
    compliance.vmult(column, NodeVector::Unit(n, i));
    matrix.col(i) = column;
  }
  return (matrix + matrix.transpose()) / 2; // without rounding
}

ContactProblem data_of(const ContactStep &problem, const std::string &title)
{
  ContactProblem data{matrix_of(problem.system().compliance()),
                      problem.q(),
                      {},
                      problem.face().columns(),
                      problem.face().balance(),
                      title};
  for (const FrictionLaw &law : problem.laws())
  {
    if (law.ellipse() == nullptr)
      throw std::logic_error("a friction law that is no ellipse cannot be written");
    data.laws.push_back(*law.ellipse());
  }
  return data;
}
} // namespace

void write_step_problem(const SolvedStep &step, const std::string &file)
{
  const ContactStep &problem = step.report.last_part->problem;
  const Eigen::VectorXd &unknowns = step.report.last_part->unknowns;
  write_problem(data_of(problem, title_of(step)),
                ProblemSolution{unknowns.head(problem.q().size()), problem.displacement(unknowns),
                                unknowns.tail(problem.face().n()), problem.residual(unknowns)},
                file);
}

void write_unsolved_problem(const LoadStep &step, const ContactStep &problem, const std::string &file)
{
  const std::string what = step.parts.empty() ? "which" : "of which a part";
  write_problem(data_of(problem, "load step " + std::to_string(step.number) + ", " + what + " is not solved"),
                {}, file);
}
#else
namespace
{
[[noreturn]] void refuse(const std::string &file)
{
  throw std::logic_error(file + ": a program without FCLIB writes no problems");
}
} // namespace

void write_step_problem(const SolvedStep &, const std::string &file)
{
  refuse(file);
}

void write_unsolved_problem(const LoadStep &, const ContactStep &, const std::string &file)
{
  refuse(file);
}
#endif
} // namespace orthocone
