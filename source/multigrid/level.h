// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "matrix_free_stiffness.h"
#include "node_relation.h"

#include <deal.II/base/subscriptor.h>
#include <deal.II/lac/precondition.h>

#include <memory>
#include <vector>

namespace orthocone
{
/// One mesh of the hierarchy with what contact holds of its nodes: the operator
///   rows of free nodes: K u;  of a node that is held along its normal: (K u)_t + coupling (K u)_z + robin
///   u_t;
/// without the directions that are held, and a Chebyshev smoother of it. Single precision is enough, because
/// it preconditions. It does without the relations' right sides, and without `follows`, whose part vanishes
/// at the solution.
class Level : public dealii::Subscriptor
{
public:
  using Vector = BodyVector<float>;

  /// `space` must outlive the level.
  Level(const Discretization &space, const MaterialOptions &material);
  Level(const Level &) = delete; // the smoother refers to it
  Level &operator=(const Level &) = delete;

  const Discretization &space() const { return space_; }
  Vector make_vector() const { return stiffness_.make_vector(); }

  /// `relations` has one relation for each contact node; if it is empty, contact holds nothing.
  void hold(std::vector<NodeRelation> relations);
  const std::vector<NodeRelation> &relations() const { return relations_; }

  void vmult(Vector &result, const Vector &vector) const;
  dealii::types::global_dof_index m() const { return space_.size().dofs; }

  /// Sets held directions to zero.
  void clear_held(Vector &vector) const;

  /// Smooths from zero, and from `solution`.
  void smooth_from_zero(Vector &solution, const Vector &right_side) const;
  void smooth(Vector &solution, const Vector &right_side) const;

private:
  /// The inverse of the diagonal of K, and of the 2 x 2 blocks of nodes that are held along their normal.
  class Jacobi
  {
  public:
    explicit Jacobi(const Level &level)
        : level_(level)
    {
    }
    void vmult(Vector &result, const Vector &vector) const;

  private:
    const Level &level_;
  };

  const std::vector<ContactNode> &nodes() const { return space_.contact_surface().nodes; }
  void invert_blocks();

  const Discretization &space_;
  MatrixFreeStiffness<float> stiffness_;
  Vector inverse_diagonal_;
  std::vector<NodeRelation> relations_;
  std::vector<Eigen::Matrix2f> robin_;  ///< of the relations
  std::vector<Eigen::Matrix2f> blocks_; ///< inverse
  dealii::PreconditionChebyshev<Level, Vector, Jacobi> smoother_;
};
} // namespace orthocone
