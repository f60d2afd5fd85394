// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/condition_solver.h>

#include <Eigen/Sparse>

namespace orthocone
{
/// The conditions of all nodes as matrices: change of force = fixed + basis x with rows^T (change of
/// displacement) + diagonal x = right_side.
struct JoinedConditions
{
  explicit JoinedConditions(const ContactConditions &conditions);

  Eigen::SparseMatrix<double> basis, rows; ///< 3 n x unknowns
  Eigen::VectorXd diagonal, right_side, fixed;
};
} // namespace orthocone
