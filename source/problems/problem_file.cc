// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/problems/problem_file.h>

#include "fclib_form.h"
#include "hdf5_file.h"

#include <cmath>
#include <stdexcept>

namespace orthocone
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
const std::string local = "/fclib_local";

/// Rows and columns of the entries of a matrix of FCLIB, stored by columns (nz = -1), by rows (-2), or one by
/// one.
struct Pattern
{
  std::vector<int> rows, columns;
};

std::vector<int> spread(const Hdf5File &file, const std::string &path, const std::vector<int> &begins,
                        const std::size_t n_lines, const std::size_t n_entries)
{
  std::vector<int> lines;
  if (begins.size() != n_lines + 1 || begins.front() != 0)
    file.fail(path + " does not have the lengths that its m, n and nz say");
  for (std::size_t line = 0; line < n_lines; ++line)
  {
    if (begins[line + 1] < begins[line] || static_cast<std::size_t>(begins[line + 1]) > n_entries)
      file.fail(path + "/p does not grow from 0 to the number of entries");
    lines.insert(lines.end(), begins[line + 1] - begins[line], static_cast<int>(line));
  }
  return lines;
}

Pattern read_pattern(const Hdf5File &file, const std::string &path, const std::size_t m, const std::size_t n,
                     const std::size_t n_entries)
{
  const int kind = file.integer(path + "/nz");
  std::vector<int> p = file.integers(path + "/p"), i = file.integers(path + "/i");
  if (kind == -1 || kind == -2)
  {
    std::vector<int> lines = spread(file, path, p, kind == -1 ? n : m, n_entries);
    if (i.size() > lines.size())
      i.resize(lines.size()); // there may be room for more entries than there are
    return kind == -1 ? Pattern{std::move(i), std::move(lines)} : Pattern{std::move(lines), std::move(i)};
  }
  if (kind < 0 || p.size() < static_cast<std::size_t>(kind) || i.size() < static_cast<std::size_t>(kind))
    file.fail(path + "/nz = " + std::to_string(kind) + " is no kind of matrix that FCLIB knows");
  p.resize(kind);
  i.resize(kind);
  return {std::move(p), std::move(i)};
}

/// Reads an m x n matrix; its sizes are known already, so that no damaged size demands memory.
MatrixXd read_matrix(const Hdf5File &file, const std::string &path, const Index m, const Index n)
{
  if (file.integer(path + "/m") != m || file.integer(path + "/n") != n)
    file.fail(path + " has " + std::to_string(file.integer(path + "/m")) + " x " +
              std::to_string(file.integer(path + "/n")) + " entries where the vectors want " +
              std::to_string(m) + " x " + std::to_string(n));
  const VectorXd x = file.numbers(path + "/x");
  const Pattern pattern = read_pattern(file, path, m, n, x.size());
  const std::size_t n_entries = pattern.rows.size();
  if (pattern.columns.size() != n_entries || static_cast<std::size_t>(x.size()) < n_entries)
    file.fail(path + " has fewer entries than its pattern");
  MatrixXd matrix = MatrixXd::Zero(m, n);
  for (std::size_t k = 0; k < n_entries; ++k)
  {
    const int row = pattern.rows[k], column = pattern.columns[k];
    if (row < 0 || row >= m || column < 0 || column >= n)
      file.fail(path + " has an entry outside of its " + std::to_string(m) + " x " + std::to_string(n));
    matrix(row, column) += x[static_cast<Index>(k)];
  }
  return matrix;
}

VectorXd read_vector(const Hdf5File &file, const std::string &path, const Index n)
{
  VectorXd values = file.numbers(path);
  if (values.size() != n)
    file.fail(path + " has " + std::to_string(values.size()) + " values instead of " + std::to_string(n));
  return values;
}

/// The laws of the extension, or else the laws that FCLIB knows.
std::vector<OrthotropicFriction> read_laws(const Hdf5File &file, const Index n)
{
  const bool is_ours = file.has("/orthocone");
  const VectorXd mu =
      is_ours ? read_vector(file, "/orthocone/mu", 2 * n) : read_vector(file, local + "/vectors/mu", n);
  const VectorXd p = is_ours ? read_vector(file, "/orthocone/p", 2 * n) : mu;
  std::vector<OrthotropicFriction> laws;
  for (Index i = 0; i < n; ++i)
  {
    OrthotropicFriction law{mu[i], mu[i], mu[i], mu[i]};
    if (is_ours)
      law = {mu[2 * i], mu[2 * i + 1], p[2 * i], p[2 * i + 1]};
    const bool is_allowed = law.mu_x > 0 && law.mu_y > 0 && law.p_x > 0 && law.p_y > 0;
    if (!is_allowed && !(law.mu_x == 0 && law.mu_y == 0))
      file.fail("friction of node " + std::to_string(i) + " is (" + std::to_string(law.mu_x) + ", " +
                std::to_string(law.mu_y) + "); allowed are numbers > 0, or 0 in both directions");
    if (law.mu_x == 0)
      law = {0, 0, 1, 1};
    laws.push_back(law);
  }
  return laws;
}

/// The friction of FCLIB's own group must be that of the extension in FCLIB's scale.
void check_agreement(const Hdf5File &file, const FclibScale &scale)
{
  constexpr double rounding = 1e-8;
  const VectorXd mu = read_vector(file, local + "/vectors/mu", scale.mu.size());
  for (Index i = 0; i < mu.size(); ++i)
    if (!(std::abs(mu[i] - scale.mu[i]) <= rounding * scale.mu[i]))
      file.fail("friction of node " + std::to_string(i) + " is " + std::to_string(mu[i]) + " in " + local +
                "/vectors/mu, where the laws of the group orthocone make it " + std::to_string(scale.mu[i]));
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

/// Reads u = W r + V l + q with V^T r + R l + s = 0, and eliminates l where R resists (docs/theory.md,
/// section 9).
void read_constraints(const Hdf5File &file, ContactProblem &problem)
{
  const VectorXd s = file.numbers(local + "/vectors/s");
  problem.face = read_matrix(file, local + "/V", problem.q.size(), s.size());
  const MatrixXd r = read_matrix(file, local + "/R", s.size(), s.size());
  problem.balance = -s;
  if (r.isZero(0))
    return;
  const Eigen::FullPivLU<MatrixXd> factor(r);
  if (!factor.isInvertible())
    file.fail(local + "/R is singular, but not zero: such constraints are not known here");
  problem.w -= problem.face * factor.solve(problem.face.transpose());
  problem.q -= problem.face * factor.solve(s);
  problem.face.resize(problem.q.size(), 0);
  problem.balance.resize(0);
}

/// Whether the constraints have an R, by which they are eliminated.
bool resists(const Hdf5File &file)
{
  if (!file.has(local + "/V"))
    return false;
  const Index m = file.numbers(local + "/vectors/s").size();
  return !read_matrix(file, local + "/R", m, m).isZero(0);
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

void check_kind(const Hdf5File &file)
{
  if (!file.has(local))
    file.fail(file.has("/fclib_global") ? "has a global problem; local ones are read (group fclib_local)"
                                        : "there is no problem of FCLIB in it (group fclib_local)");
  if (const int dimension = file.integer(local + "/spacedim"); dimension != 3)
    file.fail("the problem has " + std::to_string(dimension) + " dimensions; allowed are 3");
}
} // namespace

ContactProblem read_problem(const std::string &name)
{
  const Hdf5File file(name, Hdf5File::Access::read);
  check_kind(file);
  ContactProblem problem;
  problem.q = file.numbers(local + "/vectors/q");
  const Index n = problem.q.size() / 3;
  if (n == 0 || problem.q.size() % 3 != 0)
    file.fail(local + "/vectors/q has " + std::to_string(problem.q.size()) +
              " values; allowed are three a node");
  problem.laws = read_laws(file, n);
  problem.w = read_matrix(file, local + "/W", 3 * n, 3 * n);
  problem.face.resize(3 * n, 0);
  problem.title = name;
  if (file.has(local + "/V"))
    read_constraints(file, problem);
  const FclibScale scale(problem.laws);
  check_agreement(file, scale);
  if (problem.face.cols() > 0 && !scale.is_symmetric())
    file.fail("constraints beside a slip rule that is not associated are not known here");
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
  check_kind(file);
  if (!file.has("/solution/r"))
    return std::nullopt;
  const Index n = file.numbers(local + "/vectors/q").size();
  const FclibScale scale(read_laws(file, n / 3));
  ProblemSolution solution;
  solution.force = scale.force.cwiseProduct(read_vector(file, "/solution/r", n));
  solution.displacement = read_vector(file, "/solution/u", n).cwiseQuotient(scale.displacement);
  if (file.has_values("/solution/l") && !resists(file))
    solution.motions = file.numbers("/solution/l");
  if (file.has("/orthocone/residual"))
    solution.residual = file.numbers("/orthocone/residual").sum();
  return solution;
}

StoredErrors stored_errors(const std::string &name)
{
  const Hdf5File file(name, Hdf5File::Access::read);
  const VectorXd q = file.numbers(local + "/vectors/q");
  const VectorXd r = read_vector(file, "/solution/r", q.size());
  const MatrixXd w = read_matrix(file, local + "/W", q.size(), q.size());
  Sum u(q), balance(VectorXd::Zero(0));
  u.add(w, r);
  if (file.has(local + "/V"))
  {
    const VectorXd s = file.numbers(local + "/vectors/s");
    const MatrixXd v = read_matrix(file, local + "/V", q.size(), s.size());
    const MatrixXd resistance = read_matrix(file, local + "/R", s.size(), s.size());
    balance = Sum(s);
    balance.add(v.transpose(), r);
    const VectorXd l = file.has_values("/solution/l")
                           ? read_vector(file, "/solution/l", s.size())
                           : VectorXd(-resistance.fullPivLu().solve(balance.value));
    balance.add(resistance, l);
    u.add(v, l);
  }
  u.value -= read_vector(file, "/solution/u", q.size());
  return {u.error(), balance.error()};
}
} // namespace orthocone
