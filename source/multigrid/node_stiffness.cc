// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "node_stiffness.h"

#include <orthocone/body/fe/cell_dofs.h>

#include <orthocone/body/fe/stiffness.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace orthocone
{
namespace
{
// Smoothed aggregation takes the rows of a node for one block, and so they must follow each other; the space
// numbers its free degrees of freedom first, and those of contact last.

/// The row of every degree of freedom, in the order of cells.
std::vector<unsigned int> rows_by_node(const Discretization &space)
{
  constexpr unsigned int none = std::numeric_limits<unsigned int>::max();
  std::vector<unsigned int> row_of_dof(space.n_dofs(), none);
  unsigned int next = 0;
  for (const auto &cell : space.dof_handler().active_cell_iterators())
    for (const auto dof : dofs_by_node(space, cell))
      if (row_of_dof[dof] == none)
        row_of_dof[dof] = next++; // the three of a node are new together
  return row_of_dof;
}

/// Rows with both triangles of the stiffness, which is stored by its lower one; ML wants whole rows.
/// Directions that do not move are as stiff as those that move.
std::vector<MatrixRow> both_triangles(const dealii::SparseMatrix<double> &lower,
                                      const std::vector<unsigned int> &row_of_dof)
{
  std::vector<MatrixRow> rows(row_of_dof.size());
  double largest = 0;
  for (unsigned int dof = 0; dof < lower.m(); ++dof)
    for (auto entry = lower.begin(dof); entry != lower.end(dof); ++entry)
    {
      const unsigned int row = row_of_dof[dof], column = row_of_dof[entry->column()];
      rows[row].add(column, entry->value());
      if (row != column)
        rows[column].add(row, entry->value());
      else
        largest = std::max(largest, entry->value());
    }
  for (std::size_t dof = lower.m(); dof < row_of_dof.size(); ++dof)
    rows[row_of_dof[dof]].add(row_of_dof[dof], largest);
  return rows;
}

/// ML takes no other matrix. The lengths of all rows are known, so that nothing is allocated twice.
NodeStiffness::Matrix matrix_of(const std::vector<MatrixRow> &rows)
{
  std::vector<unsigned int> lengths;
  for (const MatrixRow &row : rows)
    lengths.push_back(static_cast<unsigned int>(row.columns.size()));
  NodeStiffness::Matrix matrix(rows.size(), rows.size(), lengths);
  for (unsigned int row = 0; row < rows.size(); ++row)
    matrix.set(row, rows[row].columns, rows[row].values);
  matrix.compress(dealii::VectorOperation::insert);
  return matrix;
}
} // namespace

NodeStiffness::NodeStiffness(const Discretization &space, const MaterialOptions &material)
    : NodeStiffness(space, material, rows_by_node(space))
{
}

NodeStiffness::NodeStiffness(const Discretization &space, const MaterialOptions &material,
                             const std::vector<unsigned int> &row_of_dof)
    : NodeStiffness(space, row_of_dof, both_triangles(Stiffness(space, material).matrix(), row_of_dof))
{
}

/// Contact changes the rows of its nodes, and the entries in their columns.
NodeStiffness::NodeStiffness(const Discretization &space, std::vector<unsigned int> row_of_dof,
                             const std::vector<MatrixRow> &rows)
    : space_(space),
      row_of_dof_(std::move(row_of_dof)),
      free_(matrix_of(rows))
{
  for (const ContactNode &node : nodes())
    for (const unsigned int dof : node.dofs)
      for (const auto column : rows[row_of_dof_[dof]].columns)
        near_contact_.emplace(column, rows[column]);
}

std::size_t MatrixRow::place(const Column column) const
{
  const auto found = std::find(columns.begin(), columns.end(), column);
  AssertThrow(found != columns.end(), dealii::ExcInternalError());
  return static_cast<std::size_t>(found - columns.begin());
}

/// The row of a direction in which friction resists, at a node that is held along its normal.
MatrixRow NodeStiffness::tangential_row(const unsigned int direction, const ContactNode &node,
                                        const NodeRelation &relation) const
{
  const auto at = [&](const unsigned int d) { return row_of_dof_[node.dofs[d]]; };
  MatrixRow row = near_contact_.at(at(direction));
  const MatrixRow &normal = near_contact_.at(at(2));
  const Eigen::Matrix2d robin = bounded_robin(relation, near_contact_.at(at(2)).in(at(2)));
  for (std::size_t i = 0; i < normal.columns.size(); ++i)
    row.in(normal.columns[i]) += relation.coupling[direction] * normal.values[i];
  for (unsigned int d = 0; d < 2; ++d)
    if (node.is_free[d])
      row.in(at(d)) += robin(direction, d);
  return row;
}

/// Rows of directions in which friction resists. It also notes which rows are held.
std::map<unsigned int, MatrixRow> NodeStiffness::resisting_rows(const std::vector<NodeRelation> &relations)
{
  is_held_.assign(n_rows(), false);
  couplings_.clear();
  std::map<unsigned int, MatrixRow> rows;
  for (std::size_t i = 0; i < relations.size(); ++i)
    for (unsigned int d = 0; d < 3; ++d)
    {
      const unsigned int row = row_of_dof_[nodes()[i].dofs[d]];
      if (relations[i].holds(d))
        is_held_[row] = true;
      else if (relations[i].resists(d) && nodes()[i].is_free[d])
      {
        rows[row] = tangential_row(d, nodes()[i], relations[i]);
        couplings_.push_back({row, row_of_dof_[nodes()[i].dofs[2]], relations[i].coupling[d]});
      }
    }
  return rows;
}

void NodeStiffness::hold(const std::vector<NodeRelation> &relations, Matrix &matrix)
{
  if (matrix.m() != n_rows())
    matrix.copy_from(free_);
  std::map<unsigned int, MatrixRow> resisting = resisting_rows(relations);
  for (const auto &[number, free] : near_contact_)
  {
    const auto found = resisting.find(number);
    MatrixRow row = found == resisting.end() ? free : found->second;
    for (std::size_t i = 0; i < row.columns.size(); ++i)
      if (row.columns[i] != number && (is_held_[number] || is_held_[row.columns[i]]))
        row.values[i] = 0;
    matrix.set(number, row.columns, row.values);
  }
  matrix.compress(dealii::VectorOperation::insert);
}

void NodeStiffness::test(dealii::Vector<double> &forces) const
{
  for (const Coupling &coupling : couplings_)
    forces[coupling.tangential] += coupling.factor * forces[coupling.normal];
  clear_held(forces);
}

void NodeStiffness::clear_held(dealii::Vector<double> &vector) const
{
  for (unsigned int row = 0; row < n_rows(); ++row)
    if (is_held_[row])
      vector[row] = 0;
}

std::vector<double> NodeStiffness::rigid_motions() const
{
  Eigen::MatrixXd motions = Eigen::MatrixXd::Zero(n_rows(), n_rigid_motions);
  for (unsigned int dof = 0; dof < n_rows(); ++dof)
  {
    const unsigned int row = row_of_dof_[dof], d = row % 3;
    motions(row, d) = 1;
    for (unsigned int axis = 0; axis < 3; ++axis)
      motions(row, 3 + axis) = Eigen::Vector3d::Unit(axis).cross(space_.position(dof))[d];
  }
  return {motions.data(), motions.data() + motions.size()};
}
} // namespace orthocone
