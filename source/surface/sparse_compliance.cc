// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/sparse_compliance.h>

#include "dense_conditions.h"
#include "direct_conditions.h"
#include <orthocone/surface/joined_conditions.h>

#include <Eigen/SparseLU>

#include <utility>

namespace orthocone
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
using SparseMatrix = Eigen::SparseMatrix<double>;

/// Eliminates all unknowns by a sparse factorization. Where the system is singular, GMRES finds what can be
/// found.
class SparseElimination : public ConditionSolver
{
public:
  SparseElimination(const SparseMatrix &entries, const DenseView &compliance, const double softness)
      : entries_(entries),
        softness_(softness),
        otherwise_(compliance, softness)
  {
  }

  ContactChange solve(const ContactConditions &conditions, double accuracy) const override;

private:
  SparseMatrix system_of(const ContactConditions &conditions, const JoinedConditions &nodes) const;

  const SparseMatrix &entries_;
  double
      softness_; ///< the motions of a face are softness_ times a force (N), so that all unknowns are forces
  DenseConditionSolver otherwise_;
};

/// The equations of the nodes, and of a face behind them.
SparseMatrix SparseElimination::system_of(const ContactConditions &conditions,
                                          const JoinedConditions &nodes) const
{
  const Index n = nodes.right_side.size(), m = conditions.face.cols();
  const SparseMatrix moved = entries_ * nodes.basis;
  SparseMatrix of_nodes = nodes.rows.transpose() * moved;
  std::vector<Eigen::Triplet<double>> triplets;
  for (Index column = 0; column < n; ++column)
  {
    triplets.emplace_back(column, column, nodes.diagonal[column]);
    for (SparseMatrix::InnerIterator entry(of_nodes, column); entry; ++entry)
      triplets.emplace_back(entry.row(), column, entry.value());
  }
  const MatrixXd face = m > 0 ? conditions.face : MatrixXd(nodes.rows.rows(), 0);
  const MatrixXd right = softness_ * (nodes.rows.transpose() * face);
  const MatrixXd below = face.transpose() * nodes.basis;
  for (Index j = 0; j < m; ++j)
    for (Index i = 0; i < n; ++i)
    {
      triplets.emplace_back(i, n + j, right(i, j));
      triplets.emplace_back(n + j, i, below(j, i));
    }
  if (conditions.face_stiffness.size() > 0)
    for (Index j = 0; j < m; ++j)
      for (Index i = 0; i < m; ++i)
        triplets.emplace_back(n + i, n + j, -softness_ * conditions.face_stiffness(i, j));
  SparseMatrix system(n + m, n + m);
  system.setFromTriplets(triplets.begin(), triplets.end());
  return system;
}

ContactChange SparseElimination::solve(const ContactConditions &conditions, const double accuracy) const
{
  constexpr double solved = 1e-6; // of the right side: what is left where a singular system went unnoticed
  const JoinedConditions nodes(conditions);
  const Index n = nodes.right_side.size(), m = conditions.face.cols();
  ContactChange change{nodes.fixed, face_alone(conditions, nodes.fixed)};
  if (n == 0)
    return change;
  const SparseMatrix system = system_of(conditions, nodes);
  VectorXd right_side(n + m);
  const NodeVector moved = entries_ * nodes.fixed;
  right_side.head(n) = nodes.right_side - nodes.rows.transpose() * moved;
  if (m > 0)
    right_side.tail(m) = conditions.face_right_side - conditions.face.transpose() * nodes.fixed;
  Eigen::SparseLU<SparseMatrix, Eigen::AMDOrdering<int>> factor;
  factor.isSymmetric(true); // by its pattern
  const bool is_finite =
      right_side.allFinite() && Eigen::Map<const VectorXd>(system.valuePtr(), system.nonZeros()).allFinite();
  if (is_finite)
    factor.compute(system);
  if (!is_finite || factor.info() != Eigen::Success)
    return otherwise_.solve(conditions, accuracy);
  const VectorXd unknowns = factor.solve(right_side);
  if (!((system * unknowns - right_side).norm() <= solved * right_side.norm()))
    return otherwise_.solve(conditions, accuracy);
  change.force += nodes.basis * unknowns.head(n);
  change.face = softness_ * unknowns.tail(m);
  return change;
}

/// The entries of the 3 x 3 blocks that are not zero.
SparseMatrix entries_of(const DenseView &w)
{
  std::vector<Eigen::Triplet<double>> triplets;
  for (Index column = 0; column < w.cols(); ++column)
    for (Index node = 0; node < w.rows() / 3; ++node)
      if (!w.block<3, 3>(3 * node, column - column % 3).isZero(0))
        for (Index row = 3 * node; row < 3 * node + 3; ++row)
          triplets.emplace_back(row, column, w(row, column));
  SparseMatrix entries(w.rows(), w.cols());
  entries.setFromTriplets(triplets.begin(), triplets.end());
  return entries;
}
} // namespace

bool SparseCompliance::pays_for(const DenseView &w)
{
  constexpr Index least_nodes = 30; // fewer are solved by elimination anyway
  constexpr double most_blocks = 0.25;
  const Index n = w.rows() / 3;
  Index n_blocks = 0;
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i)
      n_blocks += w.block<3, 3>(3 * i, 3 * j).isZero(0) ? 0 : 1;
  return n >= least_nodes && static_cast<double>(n_blocks) <= most_blocks * static_cast<double>(n * n);
}

SparseCompliance::SparseCompliance(MatrixXd matrix)
    : DenseCompliance(std::move(matrix)),
      entries_(entries_of(*dense()))
{
}

SparseCompliance::SparseCompliance(const DenseView &view)
    : DenseCompliance(view),
      entries_(entries_of(view))
{
}

void SparseCompliance::vmult(NodeVector &displacement, const NodeVector &force) const
{
  displacement = entries_ * force;
}

Eigen::Vector3d SparseCompliance::displacement_at(const Index node, const NodeVector &force) const
{
  Eigen::Vector3d displacement = Eigen::Vector3d::Zero();
  const int *const begin = entries_.outerIndexPtr() + 3 * node;
  const int n = begin[1] - begin[0]; // W is symmetric: its columns are its rows, and three have one pattern
  const int *const rows = entries_.innerIndexPtr() + begin[0];
  for (int d = 0; d < 3; ++d)
  {
    const double *const values = entries_.valuePtr() + begin[d];
    for (int k = 0; k < n; ++k)
      displacement[d] += values[k] * force[rows[k]];
  }
  return displacement;
}

std::unique_ptr<Compliance> SparseCompliance::on_springs(const double softness) const
{
  MatrixXd matrix = *dense();
  matrix.diagonal().array() += softness;
  return std::make_unique<SparseCompliance>(std::move(matrix));
}

std::unique_ptr<ConditionSolver> SparseCompliance::condition_solver(const double softness) const
{
  return std::make_unique<SparseElimination>(entries_, *dense(), softness);
}

std::unique_ptr<DenseCompliance> compliance_of_matrix(MatrixXd matrix)
{
  if (SparseCompliance::pays_for({matrix.data(), matrix.rows(), matrix.cols()}))
    return std::make_unique<SparseCompliance>(std::move(matrix));
  return std::make_unique<DenseCompliance>(std::move(matrix));
}

std::unique_ptr<DenseCompliance> compliance_of_matrix(const DenseView &view)
{
  if (SparseCompliance::pays_for(view))
    return std::make_unique<SparseCompliance>(view);
  return std::make_unique<DenseCompliance>(view);
}
} // namespace orthocone
