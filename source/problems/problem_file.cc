// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/problems/problem_file.h>

#include "fclib_form.h"
#include "local_form.h"
#include "stored_matrix.h"

#include <cmath>
#include <stdexcept>

namespace orthocone
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
/// The laws of the extension, or else the laws that FCLIB knows.
std::vector<OrthotropicFriction> read_laws(const Hdf5File &file, const Index n)
{
  const bool is_ours = file.has("/orthocone");
  const VectorXd mu = is_ours ? read_vector(file, "/orthocone/mu", 2 * n)
                              : read_vector(file, problem_group(file) + "/vectors/mu", n);
  const VectorXd p = is_ours ? read_vector(file, "/orthocone/p", 2 * n) : mu;
  std::vector<OrthotropicFriction> laws;
  for (Index i = 0; i < n; ++i)
  {
    OrthotropicFriction law{mu[i], mu[i], mu[i], mu[i]};
    if (is_ours)
      law = {mu[2 * i], mu[2 * i + 1], p[2 * i], p[2 * i + 1]};
    const bool is_allowed = (law.mu().array() > 0).all() && (law.p().array() > 0).all();
    if (!is_allowed && !law.mu().isZero(0))
      file.fail("friction of node " + std::to_string(i) + " is (" + std::to_string(law.mu()[0]) + ", " +
                std::to_string(law.mu()[1]) + "); allowed are numbers > 0, or 0 in both directions");
    if (is_frictionless(law))
      law = {0, 0, 1, 1};
    laws.push_back(law);
  }
  return laws;
}

/// The friction of FCLIB's own group must be that of the extension in FCLIB's scale.
void check_agreement(const Hdf5File &file, const FclibScale &scale)
{
  constexpr double rounding = 1e-8;
  const std::string path = problem_group(file) + "/vectors/mu";
  const VectorXd mu = read_vector(file, path, scale.mu.size());
  for (Index i = 0; i < mu.size(); ++i)
    if (!(std::abs(mu[i] - scale.mu[i]) <= rounding * scale.mu[i]))
      file.fail("friction of node " + std::to_string(i) + " is " + std::to_string(mu[i]) + " in " + path +
                ", where the laws of the group orthocone make it " + std::to_string(scale.mu[i]));
}

/// Makes W exactly symmetric if it is symmetric up to rounding. Throws FileError if it is not.
void make_symmetric(const Hdf5File &file, ContactProblem &problem)
{
  const DenseView w(problem.w.data(), problem.w.rows(), problem.w.cols());
  try
  {
    problem.mirrored = mirror_difference(w);
  }
  catch (const std::invalid_argument &error)
  {
    file.fail(
        std::string(error.what()) +
        ". (A slip rule that is not associated makes it so, too: then the group orthocone has the law)");
  }
  problem.w = symmetric_part(w);
}

/// Takes over u = W r + V l + q with V^T r + R l + s = 0, and eliminates l where R resists (docs/theory.md,
/// section 9).
void take_form(const Hdf5File &file, const LocalForm &form, ContactProblem &problem)
{
  problem.w = form.w;
  problem.q = form.q;
  if (form.r.isZero(0))
  {
    problem.face = form.v;
    problem.balance = -form.s;
    return;
  }
  const Eigen::FullPivLU<MatrixXd> factor(form.r);
  if (!factor.isInvertible())
    file.fail(
        "R is singular (of a global problem: G^T M^-1 G), but not zero: such constraints are not supported");
  problem.w -= form.v * factor.solve(form.v.transpose());
  problem.q -= form.v * factor.solve(form.s);
  problem.face.resize(problem.q.size(), 0);
}

/// A sum of products, and how large its parts are.
struct Sum
{
  explicit Sum(const VectorXd &first)
      : value(first),
        size(first.cwiseAbs())
  {
  }

  void add(const MatrixXd &matrix, const VectorXd &vector)
  {
    value += matrix * vector;
    size += matrix.cwiseAbs() * vector.cwiseAbs();
  }

  /// The largest entry, relative to the largest parts.
  double error() const
  {
    const double largest = size.size() > 0 ? size.maxCoeff() : 0;
    return largest > 0 ? value.cwiseAbs().maxCoeff() / largest : 0;
  }

  VectorXd value, size;
};
} // namespace

ContactProblem read_problem(const std::string &name)
{
  const Hdf5File file(name, Hdf5File::Access::read);
  ContactProblem problem;
  problem.laws = read_laws(file, number_of_rows(file) / 3);
  problem.title = name;
  take_form(file, read_local_form(file), problem);
  const FclibScale scale(problem.laws);
  check_agreement(file, scale);
  if (problem.face.cols() > 0 && !scale.is_symmetric())
    file.fail("constraints beside a slip rule that is not associated are not supported");
  problem.w =
      scale.displacement.cwiseInverse().asDiagonal() * problem.w * scale.force.cwiseInverse().asDiagonal();
  problem.q = problem.q.cwiseQuotient(scale.displacement).eval();
  problem.face = scale.displacement.cwiseInverse().asDiagonal() * problem.face;
  make_symmetric(file, problem);
  return problem;
}

std::optional<ProblemSolution> read_solution(const std::string &name)
{
  const Hdf5File file(name, Hdf5File::Access::read);
  const Index n = number_of_rows(file);
  if (!file.has("/solution/r"))
    return std::nullopt;
  const FclibScale scale(read_laws(file, n / 3));
  ProblemSolution solution;
  solution.force = scale.force.cwiseProduct(read_vector(file, "/solution/r", n));
  solution.displacement = read_vector(file, "/solution/u", n).cwiseQuotient(scale.displacement);
  if (file.has_values("/solution/l") && read_local_form(file).r.isZero(0))
    solution.motions = file.numbers("/solution/l");
  if (file.has("/orthocone/residual"))
    solution.residual = file.numbers("/orthocone/residual").sum();
  return solution;
}

StoredErrors stored_errors(const std::string &name)
{
  const Hdf5File file(name, Hdf5File::Access::read);
  const LocalForm form = read_local_form(file);
  const VectorXd r = read_vector(file, "/solution/r", form.q.size());
  Sum u(form.q), balance(form.s);
  u.add(form.w, r);
  if (form.has_constraints())
  {
    balance.add(form.v.transpose(), r);
    const VectorXd l = file.has_values("/solution/l") ? read_vector(file, "/solution/l", form.s.size())
                                                      : VectorXd(-form.r.fullPivLu().solve(balance.value));
    balance.add(form.r, l);
    u.add(form.v, l);
  }
  u.value -= read_vector(file, "/solution/u", form.q.size());
  return {u.error(), balance.error()};
}
} // namespace orthocone
