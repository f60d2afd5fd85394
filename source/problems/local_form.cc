// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "local_form.h"
#include "stored_matrix.h"

#include <orthocone/base/machine.h>
#include <orthocone/base/text.h>

#include <cmath>

namespace orthocone
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
const std::string local_group = "/fclib_local", global_group = "/fclib_global";

/// W is kept with all its entries, also where the file has few of them.
void require_room(const Hdf5File &file, const Index n_rows)
{
  constexpr double gigabyte = 1e9;
  const double wanted = static_cast<double>(n_rows) * static_cast<double>(n_rows) * sizeof(double) / gigabyte;
  const MemoryLimit limit = memory_limit();
  if (wanted > limit.gigabytes)
    file.fail("W has " + std::to_string(n_rows) + " rows, which take " + to_text(std::round(wanted)) +
              " GB, and " + limit.source + " " + to_text(std::round(limit.gigabytes)) + " GB");
}

LocalForm read_local(const Hdf5File &file)
{
  const Index n_rows = number_of_rows(file);
  LocalForm form{read_matrix(file, local_group + "/W", n_rows, n_rows),
                 file.numbers(local_group + "/vectors/q"), MatrixXd(n_rows, 0), MatrixXd(0, 0), VectorXd(0)};
  if (!file.has(local_group + "/V"))
    return form;
  form.s = file.numbers(local_group + "/vectors/s");
  form.v = read_matrix(file, local_group + "/V", n_rows, form.s.size());
  form.r = read_matrix(file, local_group + "/R", form.s.size(), form.s.size());
  return form;
}

using Factor = Eigen::SimplicialLLT<SparseMatrix>;

/// Factorizes M (m x m). It must be symmetric to what files in decimal form and other programs leave.
void factorize_mass(const Hdf5File &file, const Index m, Factor &factor)
{
  constexpr double rounding = 1e-8;
  const SparseMatrix mass = read_matrix(file, global_group + "/M", m, m);
  const VectorXd diagonal = mass.diagonal();
  if (!(diagonal.size() > 0 && diagonal.minCoeff() > 0))
    file.fail(global_group + "/M is not positive definite: allowed are numbers > 0 on its diagonal");
  const SparseMatrix mirrored = mass.transpose();
  const SparseMatrix difference = mass - mirrored;
  for (Index column = 0; column < m; ++column)
    for (SparseMatrix::InnerIterator entry(difference, column); entry; ++entry)
      if (std::abs(entry.value()) > rounding * std::sqrt(diagonal[entry.row()] * diagonal[column]))
        file.fail(global_group + "/M is not symmetric: entries of rows " + std::to_string(column) + " and " +
                  std::to_string(entry.row()) + " differ by more than 1e-8 of its diagonal");
  factor.compute(mass);
  if (factor.info() != Eigen::Success)
    file.fail(global_group + "/M is not positive definite, as masses and stiffnesses of held bodies are");
}

LocalForm reduce_global(const Hdf5File &file)
{
  const Index n_rows = number_of_rows(file);
  const VectorXd f = file.numbers(global_group + "/vectors/f");
  Factor factor;
  factorize_mass(file, f.size(), factor);
  const SparseMatrix h = read_matrix(file, global_group + "/H", f.size(), n_rows);
  const SparseMatrix moved = factor.solve(h);
  const VectorXd free = factor.solve(f);
  LocalForm form{SparseMatrix(h.transpose() * moved),
                 read_vector(file, global_group + "/vectors/w", n_rows) + h.transpose() * free,
                 MatrixXd(n_rows, 0), MatrixXd(0, 0), VectorXd(0)};
  if (!file.has(global_group + "/G"))
    return form;
  form.s = file.numbers(global_group + "/vectors/b");
  const SparseMatrix g = read_matrix(file, global_group + "/G", f.size(), form.s.size());
  form.v = SparseMatrix(moved.transpose() * g);
  form.r = SparseMatrix(g.transpose() * SparseMatrix(factor.solve(g)));
  form.s += g.transpose() * free;
  return form;
}
} // namespace

std::string problem_group(const Hdf5File &file)
{
  const std::string group = file.has(local_group) ? local_group : global_group;
  if (!file.has(group))
    file.fail("there is no problem of FCLIB in it (group fclib_local or fclib_global)");
  if (const int dimension = file.integer(group + "/spacedim"); dimension != 3)
    file.fail("the problem has " + std::to_string(dimension) + " dimensions; allowed are 3");
  return group;
}

Index number_of_rows(const Hdf5File &file)
{
  const std::string group = problem_group(file);
  const std::string path = group + (group == local_group ? "/vectors/q" : "/vectors/w");
  const Index n_rows = file.numbers(path).size();
  if (n_rows == 0 || n_rows % 3 != 0)
    file.fail(path + " has " + std::to_string(n_rows) + " values; allowed are three a node");
  return n_rows;
}

LocalForm read_local_form(const Hdf5File &file)
{
  require_room(file, number_of_rows(file));
  return problem_group(file) == local_group ? read_local(file) : reduce_global(file);
}
} // namespace orthocone
