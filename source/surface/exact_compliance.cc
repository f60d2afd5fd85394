// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/exact_compliance.h>

#include "joined_conditions.h"

#include <limits>
#include <utility>

namespace orthocone
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
class Elimination : public ConditionSolver
{
public:
  Elimination(const DenseView &compliance, const double softness)
      : compliance_(compliance),
        softness_(softness)
  {
  }

  ContactChange solve(const ContactConditions &conditions, double) const override;

private:
  DenseView compliance_;
  double
      softness_; ///< the motions of a face are softness_ times a force (N), so that all unknowns are forces
};

ContactChange Elimination::solve(const ContactConditions &conditions, double) const
{
  const JoinedConditions nodes(conditions);
  const Index n = nodes.right_side.size(), m = conditions.face.cols();
  ContactChange change{nodes.fixed, VectorXd::Zero(m)};
  if (n == 0)
    return change;
  MatrixXd matrix = MatrixXd::Zero(n + m, n + m);
  VectorXd right_side(n + m);
  matrix.topLeftCorner(n, n) = nodes.rows.transpose() * MatrixXd(compliance_ * nodes.basis);
  matrix.diagonal().head(n) += nodes.diagonal;
  const NodeVector moved = compliance_ * nodes.fixed;
  right_side.head(n) = nodes.right_side - nodes.rows.transpose() * moved;
  if (m > 0)
  {
    matrix.topRightCorner(n, m) = nodes.rows.transpose() * MatrixXd(softness_ * conditions.face);
    matrix.bottomLeftCorner(m, n) = conditions.face.transpose() * nodes.basis;
    right_side.tail(m) = conditions.face_right_side - conditions.face.transpose() * nodes.fixed;
  }
  VectorXd unknowns = VectorXd::Constant(n + m, std::numeric_limits<double>::quiet_NaN());
  if (matrix.allFinite()) // LAPACK might not return
    unknowns = Eigen::PartialPivLU<Eigen::Ref<MatrixXd>>(matrix).solve(right_side);
  change.force += nodes.basis * unknowns.head(n);
  change.face = softness_ * unknowns.tail(m);
  return change;
}
} // namespace

std::unique_ptr<ConditionSolver> ExactCompliance::condition_solver(const double softness) const
{
  return std::make_unique<Elimination>(*dense(), softness);
}

UnsymmetricCompliance::UnsymmetricCompliance(MatrixXd matrix)
    : matrix_(std::move(matrix))
{
  eigen_assert(matrix_.rows() == matrix_.cols() && matrix_.rows() % 3 == 0);
}

void UnsymmetricCompliance::vmult(NodeVector &displacement, const NodeVector &force) const
{
  displacement = matrix_ * force;
}

Eigen::Matrix3d UnsymmetricCompliance::diagonal_block(const Index node) const
{
  return matrix_.block<3, 3>(3 * node, 3 * node);
}

std::unique_ptr<ConditionSolver> UnsymmetricCompliance::condition_solver(const double softness) const
{
  return std::make_unique<Elimination>(DenseView(matrix_.data(), matrix_.rows(), matrix_.cols()), softness);
}
} // namespace orthocone
