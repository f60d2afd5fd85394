// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/fe/stiffness.h>

#include "cell_stiffness.h"
#include <orthocone/body/fe/cell_dofs.h>

#include <deal.II/base/work_stream.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <vector>

namespace orthocone
{
namespace
{
template<int dim>
struct CellMatrix
{
  Eigen::MatrixXd matrix; ///< numbered as `dofs`
  std::vector<dealii::types::global_dof_index> dofs;
};

/// Adds a cell's matrix (N/mm) to the entries of `matrix` on and below the diagonal, in rows of free degrees
/// of freedom. In order, the columns of a row are found on one way through it, without a search for each.
/// Zeros have no entry where components do not couple.
void add_cell_matrix(const Eigen::MatrixXd &cell_matrix,
                     const std::vector<dealii::types::global_dof_index> &dofs,
                     dealii::SparseMatrix<double> &matrix)
{
  std::vector<unsigned int> order(dofs.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](const auto i, const auto j) { return dofs[i] < dofs[j]; });
  std::vector<dealii::types::global_dof_index> columns;
  std::vector<double> values;
  for (auto row = order.begin(); row != order.end() && dofs[*row] < matrix.m(); ++row)
  {
    columns.clear();
    values.clear();
    for (auto column = order.begin(); column <= row; ++column)
      if (const double value = cell_matrix(*row, *column); value != 0)
      {
        columns.push_back(dofs[*column]);
        values.push_back(value);
      }
    matrix.add(dofs[*row], columns.size(), columns.data(), values.data(), false, true);
  }
}

template<int dim>
void assemble(const DisplacementSpace<dim> &space, const Materials &materials,
              dealii::SparseMatrix<double> &matrix)
{
  const auto work = [&space](const typename DisplacementSpace<dim>::Cell &cell, CellStiffness<dim> &stiffness,
                             CellMatrix<dim> &copy)
  {
    const CellBasis moving(space.hanging(), dofs_by_node(space, cell));
    copy.matrix = moving.reduced(stiffness.of(cell));
    copy.dofs = moving.dofs;
  };
  const auto add = [&](const CellMatrix<dim> &copy) { add_cell_matrix(copy.matrix, copy.dofs, matrix); };
  const auto &dof_handler = space.dof_handler();
  dealii::WorkStream::run(dof_handler.begin_active(), dof_handler.end(), work, add,
                          CellStiffness<dim>(space, materials), CellMatrix<dim>());
}
} // namespace

// In a section the component out of its plane couples with the others through friction alone, so that K has
// two blocks. Only contact nodes have entries between them, which are zero: the elimination tree of two
// blocks would be two trees, of which CHOLMOD eliminates one behind the other, and the contact unknowns would
// not come last.
template<int dim>
void make_stiffness_pattern(const DisplacementSpace<dim> &space, dealii::SparsityPattern &pattern)
{
  constexpr unsigned int out_of_plane = 1;
  const unsigned int n_free = space.n_free(), n_interior = space.n_interior();
  const auto are_apart = [&](const unsigned int row, const unsigned int column)
  {
    return dim == 2 && (row < n_interior || column < n_interior) &&
           (space.direction(row) == out_of_plane) != (space.direction(column) == out_of_plane);
  };
  dealii::DynamicSparsityPattern entries(n_free);
  std::vector<dealii::types::global_dof_index> columns;
  for (const auto &cell : space.dof_handler().active_cell_iterators())
  {
    auto dofs = CellBasis(space.hanging(), dofs_by_node(space, cell)).dofs;
    std::sort(dofs.begin(), dofs.end());
    for (auto row = dofs.begin(); row != dofs.end() && *row < n_free; ++row)
    {
      columns.clear();
      std::copy_if(dofs.begin(), row + 1, std::back_inserter(columns),
                   [&](const auto column) { return !are_apart(*row, column); });
      entries.add_entries(*row, columns.begin(), columns.end(), true);
    }
  }
  pattern.copy_from(entries);
}

template<int dim>
Stiffness::Stiffness(const DisplacementSpace<dim> &space, const Materials &materials)
{
  make_stiffness_pattern(space, pattern_);
  matrix_.reinit(pattern_);
  assemble(space, materials, matrix_);
}

template void make_stiffness_pattern(const Discretization &, dealii::SparsityPattern &);
template void make_stiffness_pattern(const SectionDiscretization &, dealii::SparsityPattern &);
template Stiffness::Stiffness(const Discretization &, const Materials &);
template Stiffness::Stiffness(const SectionDiscretization &, const Materials &);

Eigen::VectorXd diagonal_beside_hanging_nodes(const Discretization &space, const MaterialOptions &material)
{
  if (space.hanging().empty())
    return {};
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(space.n_dofs());
  CellStiffness<3> stiffness(space, Material(material));
  for (const auto &cell : space.dof_handler().active_cell_iterators())
  {
    if (!cell->is_locally_owned())
      continue;
    const auto dofs = dofs_by_node(space, cell);
    const CellBasis moving(space.hanging(), dofs);
    if (moving.basis.size() == 0)
      continue;
    const Eigen::MatrixXd &matrix = stiffness.of(cell);
    const Eigen::MatrixXd reduced = moving.reduced(matrix);
    for (std::size_t i = 0; i < dofs.size(); ++i)
      diagonal[dofs[i]] -= matrix(i, i);
    for (std::size_t i = 0; i < moving.dofs.size(); ++i)
      diagonal[moving.dofs[i]] += reduced(i, i);
  }
  return diagonal;
}

double Stiffness::rounding(const Eigen::VectorXd &displacement) const
{
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(displacement.size());
  for (unsigned int row = 0; row < matrix_.m(); ++row)
    for (auto entry = matrix_.begin(row); entry != matrix_.end(row); ++entry)
    {
      const unsigned int column = entry->column();
      const double size = std::abs(entry->value());
      sums[row] += size * std::abs(displacement[column]);
      if (column != row)
        sums[column] += size * std::abs(displacement[row]);
    }
  return std::numeric_limits<double>::epsilon() * sums.norm();
}

Eigen::VectorXd Stiffness::vmult(const Eigen::VectorXd &displacement) const
{
  // Both products with a triangle include the diagonal.
  const dealii::Vector<double> u(displacement.begin(), displacement.end());
  dealii::Vector<double> forces(u.size());
  matrix_.vmult(forces, u);
  matrix_.Tvmult_add(forces, u);
  for (unsigned int row = 0; row < matrix_.m(); ++row)
    forces[row] -= matrix_.diag_element(row) * u[row];
  return Eigen::Map<const Eigen::VectorXd>(forces.data(), displacement.size());
}
} // namespace orthocone
