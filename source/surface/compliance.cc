// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/compliance.h>

#include "dense_conditions.h"

#include <orthocone/surface/exact_compliance.h>

#include <stdexcept>
#include <utility>

namespace orthocone
{
std::unique_ptr<ConditionSolver> Compliance::condition_solver(double) const
{
  return nullptr;
}

ContactChange Compliance::approximate(const NodeVector &force) const
{
  ContactChange answer;
  answer.force = force;
  vmult(answer.displacement, force);
  return answer;
}

ContactChange Compliance::held_at(const Eigen::VectorXd &) const
{
  throw std::logic_error("this compliance has no body");
}

SolutionMemory &Compliance::memory() const
{
  static SolutionMemory none;
  return none;
}

Eigen::Vector3d Compliance::displacement_at(const Eigen::Index node, const NodeVector &force) const
{
  NodeVector displacement;
  vmult(displacement, force);
  return displacement.segment<3>(3 * node);
}

std::unique_ptr<Compliance> Compliance::on_springs(double) const
{
  return nullptr;
}

double Compliance::softness() const
{
  return largest_eigenvalue(n_nodes(), 1e-4,
                            [this](const NodeVector &force)
                            {
                              NodeVector displacement;
                              vmult(displacement, force);
                              return displacement;
                            });
}

double largest_eigenvalue(const Eigen::Index n_nodes, const double settled,
                          const std::function<NodeVector(const NodeVector &)> &product)
{
  constexpr double rounding = 1e-12;
  // Surfaces settle within some ten products. Whatever the spectrum, the value after the last product is
  // short by about 2 % on average over all starts (Kuczynski, Wozniakowski 1992, theorem 3.2).
  constexpr Eigen::Index least_products = 5, most_products = 60;
  // A push on the whole surface is close to the softest mode; the tilt keeps other modes in reach.
  NodeVector vector = NodeVector::LinSpaced(3 * n_nodes, 1, 1.1).normalized();
  NodeVector last = NodeVector::Zero(vector.size());
  Eigen::VectorXd diagonal(most_products), beside(most_products); // of the tridiagonal matrix
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> ritz;
  double eigenvalue = 0;
  for (Eigen::Index k = 0; k < most_products; ++k)
  {
    NodeVector next = product(vector);
    diagonal[k] = next.dot(vector);
    ritz.computeFromTridiagonal(diagonal.head(k + 1), beside.head(k), Eigen::EigenvaluesOnly);
    const double before = std::exchange(eigenvalue, ritz.eigenvalues().maxCoeff());
    next -= diagonal[k] * vector;
    if (k > 0)
      next -= beside[k - 1] * last;
    beside[k] = next.norm();
    const bool has_settled = k + 1 >= least_products && eigenvalue - before <= settled * eigenvalue;
    if (has_settled || !(beside[k] > rounding * eigenvalue))
      break;
    last = std::exchange(vector, next / beside[k]);
  }
  return eigenvalue;
}

DenseCompliance::DenseCompliance(Eigen::MatrixXd matrix)
    : own_(std::move(matrix)),
      matrix_(own_.data(), own_.rows(), own_.cols())
{
  eigen_assert(matrix_.rows() == matrix_.cols() && matrix_.rows() % 3 == 0);
}

DenseCompliance::DenseCompliance(const DenseView &view)
    : matrix_(view)
{
  eigen_assert(matrix_.rows() == matrix_.cols() && matrix_.rows() % 3 == 0);
}

void DenseCompliance::vmult(NodeVector &displacement, const NodeVector &force) const
{
  if (force.size() != last_force_.size() || force != last_force_)
  {
    last_displacement_.noalias() = matrix_.selfadjointView<Eigen::Lower>() * force;
    last_force_ = force;
  }
  displacement = last_displacement_;
}

Eigen::Matrix3d DenseCompliance::diagonal_block(const Eigen::Index node) const
{
  return matrix_.block<3, 3>(3 * node, 3 * node);
}

/// W is symmetric, and its columns are contiguous.
Eigen::Vector3d DenseCompliance::displacement_at(const Eigen::Index node, const NodeVector &force) const
{
  return matrix_.middleCols<3>(3 * node).transpose() * force;
}

std::unique_ptr<Compliance> DenseCompliance::on_springs(const double softness) const
{
  Eigen::MatrixXd matrix = matrix_;
  matrix.diagonal().array() += softness;
  return std::make_unique<ExactCompliance>(std::move(matrix));
}

std::unique_ptr<ConditionSolver> DenseCompliance::condition_solver(const double softness) const
{
  return std::make_unique<DenseConditionSolver>(matrix_, softness);
}
} // namespace orthocone
