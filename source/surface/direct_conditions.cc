// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "direct_conditions.h"

namespace orthocone
{
namespace
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The equations of all nodes and, behind them, of the face; unknowns are forces (N).
struct Equations
{
  MatrixXd matrix;
  VectorXd right_side;
  NodeVector fixed; ///< changes of force that are given
};

/// Number of the first unknown of each node, and at last that of all nodes.
std::vector<Index> first_unknowns(const ContactConditions &conditions)
{
  std::vector<Index> first{0};
  first.reserve(conditions.nodes.size() + 1);
  for (const NodeCondition &node : conditions.nodes)
    first.push_back(first.back() + node.n_unknowns);
  return first;
}

/// Displacements of the nodes for each unknown.
MatrixXd moved_by_unknowns(const ContactConditions &conditions, const std::vector<Index> &first,
                           const DenseView &compliance, const double softness)
{
  const Index m = conditions.face.cols();
  MatrixXd moved(compliance.rows(), first.back() + m);
  for (std::size_t i = 0; i < conditions.nodes.size(); ++i)
    if (const NodeCondition &node = conditions.nodes[i]; node.n_unknowns > 0)
      moved.middleCols(first[i], node.n_unknowns).noalias() =
          compliance.middleCols<3>(3 * static_cast<Index>(i)) * node.basis.leftCols(node.n_unknowns);
  moved.rightCols(m) = softness * conditions.face;
  return moved;
}

Equations equations_of(const ContactConditions &conditions, const std::vector<Index> &first,
                       const DenseView &compliance, const double softness)
{
  const Index n = first.back(), m = conditions.face.cols();
  const MatrixXd moved = moved_by_unknowns(conditions, first, compliance, softness);
  Equations equations{MatrixXd::Zero(n + m, n + m), VectorXd(n + m), NodeVector(compliance.rows())};
  for (std::size_t i = 0; i < conditions.nodes.size(); ++i)
    equations.fixed.segment<3>(3 * static_cast<Index>(i)) = conditions.nodes[i].fixed;
  const NodeVector moved_by_fixed = compliance.selfadjointView<Eigen::Lower>() * equations.fixed;
  for (std::size_t i = 0; i < conditions.nodes.size(); ++i)
  {
    const NodeCondition &node = conditions.nodes[i];
    const Index k = first[i], u = node.n_unknowns, place = 3 * static_cast<Index>(i);
    if (u == 0)
      continue;
    const auto tested = node.rows.leftCols(u).transpose();
    equations.matrix.middleRows(k, u).noalias() = tested * moved.middleRows<3>(place);
    equations.matrix.diagonal().segment(k, u) += node.diagonal.head(u);
    equations.right_side.segment(k, u) = node.right_side.head(u) - tested * moved_by_fixed.segment<3>(place);
    equations.matrix.block(n, k, m, u).noalias() =
        conditions.face.middleRows<3>(place).transpose().lazyProduct(node.basis.leftCols(u));
  }
  if (m > 0) // BLAS wants no empty matrix
    equations.right_side.tail(m) = conditions.face_right_side - conditions.face.transpose() * equations.fixed;
  return equations;
}

bool is_singular(const Eigen::PartialPivLU<MatrixXd> &factor)
{
  constexpr double rounding = 1e-13; // of the largest pivot
  const VectorXd pivots = factor.matrixLU().diagonal().cwiseAbs();
  return !(pivots.minCoeff() > rounding * pivots.maxCoeff());
}
} // namespace

std::optional<ContactChange> solve_directly(const ContactConditions &conditions, const DenseView &compliance,
                                            const double softness)
{
  constexpr Index most_unknowns = 100;
  const std::vector<Index> first = first_unknowns(conditions);
  if (first.back() == 0 || first.back() > most_unknowns)
    return std::nullopt;
  const Equations equations = equations_of(conditions, first, compliance, softness);
  const Eigen::PartialPivLU<MatrixXd> factor(equations.matrix);
  if (is_singular(factor))
    return std::nullopt;
  const VectorXd unknowns = factor.solve(equations.right_side);
  ContactChange change;
  change.force = equations.fixed;
  for (std::size_t i = 0; i < conditions.nodes.size(); ++i)
  {
    const NodeCondition &node = conditions.nodes[i];
    change.force.segment<3>(3 * static_cast<Index>(i)) +=
        node.basis.leftCols(node.n_unknowns) * unknowns.segment(first[i], node.n_unknowns);
  }
  change.face = softness * unknowns.tail(conditions.face.cols());
  return change;
}
} // namespace orthocone
