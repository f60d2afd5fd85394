// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "node_relation.h"

#include <orthocone/body/fe/displacement_space.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <map>
#include <vector>

namespace orthocone
{
/// Entries of a row of a matrix.
struct MatrixRow
{
  using Column = dealii::types::global_dof_index;

  void add(const Column column, const double value)
  {
    columns.push_back(column);
    values.push_back(value);
  }
  /// The place of an entry that exists.
  std::size_t place(Column column) const;
  double &in(const Column column) { return values[place(column)]; }
  double in(const Column column) const { return values[place(column)]; }

  std::vector<Column> columns;
  std::vector<double> values;
};

/// The assembled stiffness of a solid, with three rows (x, y, z) for each node, as algebraic multigrid
/// requires. Rows of directions that do not move have only a diagonal entry.
class NodeStiffness
{
public:
  using Matrix = dealii::TrilinosWrappers::SparseMatrix;

  /// `space` must outlive this object.
  NodeStiffness(const Discretization &space, const MaterialOptions &material);

  unsigned int n_rows() const { return static_cast<unsigned int>(row_of_dof_.size()); }
  unsigned int row(const Eigen::Index dof) const { return row_of_dof_[static_cast<std::size_t>(dof)]; }

  /// The stiffness without contact, N/mm.
  const Matrix &free() const { return free_; }

  /// Makes `matrix` the operator of Level::vmult(), with the relations of the contact nodes. It must be
  /// empty, or come from an earlier call.
  void hold(const std::vector<NodeRelation> &relations, Matrix &matrix);

  /// Turns forces into the left sides of the equations of the last relations, as HeldStiffness::test() does.
  void test(dealii::Vector<double> &forces) const;

  /// Sets the directions that the last relations hold to zero.
  void clear_held(dealii::Vector<double> &vector) const;

  static constexpr int n_rigid_motions = 6;

  /// Three translations and three rotations, each with all rows.
  std::vector<double> rigid_motions() const;

private:
  /// The factor with which a force on one row counts on another one.
  struct Coupling
  {
    unsigned int tangential, normal; ///< rows
    double factor;
  };

  NodeStiffness(const Discretization &space, const MaterialOptions &material,
                const std::vector<unsigned int> &row_of_dof);
  NodeStiffness(const Discretization &space, std::vector<unsigned int> row_of_dof,
                const std::vector<MatrixRow> &rows);
  std::map<unsigned int, MatrixRow> resisting_rows(const std::vector<NodeRelation> &relations);
  MatrixRow tangential_row(unsigned int direction, const ContactNode &node,
                           const NodeRelation &relation) const;

  const std::vector<ContactNode> &nodes() const { return space_.contact_surface().nodes; }

  const Discretization &space_;
  std::vector<unsigned int> row_of_dof_;
  Matrix free_;
  std::map<unsigned int, MatrixRow> near_contact_; ///< rows that contact changes, without contact
  std::vector<bool> is_held_;                      ///< by rows
  std::vector<Coupling> couplings_;
};
} // namespace orthocone
