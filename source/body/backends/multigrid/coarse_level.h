// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "node_relation.h"

#include <orthocone/body/backends/stiffness_factor.h>
#include <orthocone/body/fe/displacement_space.h>
#include <orthocone/body/fe/stiffness.h>

#include <vector>

namespace orthocone
{
/// The coarsest mesh, solved exactly with what contact holds of its nodes: the stiffness is factorized once,
/// and what is held is a small dense system in its compliance.
class CoarseLevel
{
public:
  /// `space` must outlive this. Throws as StiffnessFactor.
  CoarseLevel(const Discretization &space, const MaterialOptions &material);

  /// One relation a contact node; none at all: contact holds nothing.
  void hold(const std::vector<NodeRelation> &relations);

  /// Displacement of the free degrees of freedom by forces on them. Forces on held directions do not count.
  Eigen::VectorXd solve(Eigen::VectorXd forces) const;

private:
  const Discretization &space_;
  StiffnessFactor factor_;
  Eigen::MatrixXd compliance_; ///< of the contact unknowns, mm/N
  // Contact answers with forces f at these degrees of freedom, such that of_force f + of_displacement u = 0.
  std::vector<unsigned int> answering_;
  Eigen::MatrixXd of_displacement_;
  Eigen::PartialPivLU<Eigen::MatrixXd> system_;
};
} // namespace orthocone
