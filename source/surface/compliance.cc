// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/compliance.h>

#include "dense_conditions.h"

#include <cmath>
#include <utility>

namespace orthocone
{
std::unique_ptr<ConditionSolver> Compliance::condition_solver(double) const
{
  return nullptr;
}

double Compliance::softness() const
{
  constexpr unsigned int least_iterations = 15, most_iterations = 200;
  constexpr double settled = 1e-5; // from one iteration to the next
  // A push on the whole surface is close to the softest mode; the tilt keeps other modes in reach.
  NodeVector vector = NodeVector::LinSpaced(3 * n_nodes(), 1, 1.1);
  NodeVector image;
  double eigenvalue = 0;
  for (unsigned int iteration = 0; iteration < most_iterations; ++iteration)
  {
    vector.normalize();
    vmult(image, vector);
    const double last = eigenvalue;
    eigenvalue = image.norm();
    if (iteration >= least_iterations && std::abs(eigenvalue - last) <= settled * eigenvalue)
      break;
    vector.swap(image);
  }
  return eigenvalue;
}

DenseCompliance::DenseCompliance(Eigen::MatrixXd matrix)
    : matrix_(std::move(matrix))
{
  eigen_assert(matrix_.rows() == matrix_.cols() && matrix_.rows() % 3 == 0);
}

void DenseCompliance::vmult(NodeVector &displacement, const NodeVector &force) const
{
  displacement.noalias() = matrix_.selfadjointView<Eigen::Lower>() * force;
}

Eigen::Matrix3d DenseCompliance::diagonal_block(const Eigen::Index node) const
{
  return matrix_.block<3, 3>(3 * node, 3 * node);
}

std::unique_ptr<ConditionSolver> DenseCompliance::condition_solver(const double softness) const
{
  return std::make_unique<DenseConditionSolver>(matrix_, softness);
}
} // namespace orthocone
