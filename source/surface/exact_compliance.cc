// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/exact_compliance.h>

#include <Eigen/Sparse>

#include <limits>
#include <utility>

namespace orthocone
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
using SparseMatrix = Eigen::SparseMatrix<double>;

/// The conditions of all nodes as matrices: change of force = fixed + basis x with rows^T (change of
/// displacement) + diagonal x = right_side.
struct Joined
{
  explicit Joined(const ContactConditions &conditions);

  SparseMatrix basis, rows; ///< 3 n x unknowns
  VectorXd diagonal, right_side, fixed;
};

Joined::Joined(const ContactConditions &conditions)
{
  const auto n_rows = 3 * static_cast<Index>(conditions.nodes.size());
  std::vector<Eigen::Triplet<double>> of_basis, of_rows;
  diagonal.resize(n_rows);
  right_side.resize(n_rows);
  fixed.resize(n_rows);
  Index n = 0, place = 0;
  for (const NodeCondition &node : conditions.nodes)
  {
    for (Index k = 0; k < node.n_unknowns; ++k)
      for (Index i = 0; i < 3; ++i)
      {
        of_basis.emplace_back(place + i, n + k, node.basis(i, k));
        of_rows.emplace_back(place + i, n + k, node.rows(i, k));
      }
    diagonal.segment(n, node.n_unknowns) = node.diagonal.head(node.n_unknowns);
    right_side.segment(n, node.n_unknowns) = node.right_side.head(node.n_unknowns);
    fixed.segment<3>(place) = node.fixed;
    n += node.n_unknowns;
    place += 3;
  }
  diagonal.conservativeResize(n);
  right_side.conservativeResize(n);
  basis.resize(n_rows, n);
  rows.resize(n_rows, n);
  basis.setFromTriplets(of_basis.begin(), of_basis.end());
  rows.setFromTriplets(of_rows.begin(), of_rows.end());
}

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
  const Joined nodes(conditions);
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
