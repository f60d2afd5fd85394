// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "v_cycle.h"

#include <orthocone/body/backends/contact_frame.h>
#include <orthocone/surface/condition_solver.h>

namespace orthocone
{
/// Forces (N) and displacements (mm) of the contact nodes under a displacement of the body with the forces K
/// u = `forces`. Before, the body lacked `residual` of its equilibrium (free degrees of freedom, or empty).
/// The contact forces are those that K u requires, so that only the rest of the body lacks equilibrium.
ContactChange contact_change(const ContactFrame &frame, const BodyVector<double> &displacement,
                             const BodyVector<double> &forces, const Eigen::VectorXd &residual);

/// Solves linearized contact laws on the whole body: its stiffness with the relations of the contact nodes,
/// by flexible GMRES and V-cycles that hold the same relations on every level.
class WholeBodyConditions : public ConditionSolver
{
public:
  /// All arguments must outlive this object.
  WholeBodyConditions(const ContactFrame &frame, const MatrixFreeStiffness<double> &stiffness, VCycle &cycle);

  ContactChange solve(const ContactConditions &conditions, double accuracy) const override;

private:
  ContactChange solve_nodes(const std::vector<NodeRelation> &relations, const Eigen::VectorXd &residual,
                            double bound) const;
  std::vector<NodeRelation> relations_of(const std::vector<NodeCondition> &conditions) const;

  const ContactFrame &frame_;
  const MatrixFreeStiffness<double> &stiffness_;
  VCycle &cycle_;
};
} // namespace orthocone
