// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/exact_compliance.h>

#include "direct_conditions.h"

#include <utility>

namespace orthocone
{
using Eigen::Index;
using Eigen::MatrixXd;

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

  ContactChange solve(const ContactConditions &conditions, double) const override
  {
    return eliminate_whatever_it_gives(conditions, compliance_, softness_);
  }

private:
  DenseView compliance_;
  double softness_; ///< Compliance::softness()
};
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
