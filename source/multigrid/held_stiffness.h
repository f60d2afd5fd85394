// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "matrix_free_stiffness.h"
#include "relation_rows.h"

#include <vector>

namespace orthocone
{
/// The stiffness of a body with the relations of its contact nodes, in double precision. It maps free
/// displacements y to forces; u = y except for u_z = -follows . y_t at nodes that are held along their
/// normal.
class HeldStiffness
{
public:
  using Vector = BodyVector<double>;

  /// All arguments must outlive this object.
  HeldStiffness(const MatrixFreeStiffness<double> &stiffness, const std::vector<ContactNode> &nodes,
                const std::vector<NodeRelation> &relations)
      : stiffness_(stiffness),
        rows_{nodes, relations}
  {
  }

  void vmult(Vector &result, const Vector &free) const;

  /// The displacement that contact gives where y = 0.
  Vector given() const;

  /// The forces (N) that y must balance when the displacement is given() and the body lacks `residual` (free
  /// degrees of freedom, or empty) of its equilibrium. `forces` are K given().
  Vector right_side(const Vector &forces, const Eigen::VectorXd &residual) const;

  /// Adds the displacement u of y.
  void add_displacement(Vector &displacement, const Vector &free) const;

private:
  void test(Vector &forces) const;

  const MatrixFreeStiffness<double> &stiffness_;
  RelationRows rows_;
};
} // namespace orthocone
