// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "stored_matrix.h"

#include <utility>

namespace orthocone
{
using Eigen::Index;
using Eigen::VectorXd;

namespace
{
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
} // namespace

SparseMatrix read_matrix(const Hdf5File &file, const std::string &path, const Index m, const Index n)
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
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(n_entries);
  for (std::size_t k = 0; k < n_entries; ++k)
  {
    const int row = pattern.rows[k], column = pattern.columns[k];
    if (row < 0 || row >= m || column < 0 || column >= n)
      file.fail(path + " has an entry outside of its " + std::to_string(m) + " x " + std::to_string(n));
    entries.emplace_back(row, column, x[static_cast<Index>(k)]);
  }
  SparseMatrix matrix(m, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

VectorXd read_vector(const Hdf5File &file, const std::string &path, const Index n)
{
  VectorXd values = file.numbers(path);
  if (values.size() != n)
    file.fail(path + " has " + std::to_string(values.size()) + " values instead of " + std::to_string(n));
  return values;
}
} // namespace orthocone
