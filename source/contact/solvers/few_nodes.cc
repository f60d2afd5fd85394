// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "few_nodes.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace orthocone
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Nodes = std::vector<Index>;

namespace
{
class DirectSolver : public ConditionSolver
{
public:
  explicit DirectSolver(const MatrixXd &compliance)
      : compliance_(compliance)
  {
  }

  ContactChange solve(const ContactConditions &conditions, double) const override
  {
    Index n = 0;
    for (const NodeCondition &condition : conditions.nodes)
      n += condition.n_unknowns;
    MatrixXd basis = MatrixXd::Zero(compliance_.rows(), n), rows = basis;
    VectorXd diagonal = VectorXd::Zero(n), right_side(n), fixed(compliance_.rows());
    Index place = 0, first = 0;
    for (const NodeCondition &condition : conditions.nodes)
    {
      const Index m = condition.n_unknowns;
      basis.block(place, first, 3, m) = condition.basis.leftCols(m);
      rows.block(place, first, 3, m) = condition.rows.leftCols(m);
      diagonal.segment(first, m) = condition.diagonal.head(m);
      right_side.segment(first, m) = condition.right_side.head(m);
      fixed.segment<3>(place) = condition.fixed;
      place += 3;
      first += m;
    }
    ContactChange change{fixed, VectorXd()};
    if (n > 0)
    {
      MatrixXd system = rows.transpose() * compliance_ * basis;
      system.diagonal() += diagonal;
      change.force +=
          basis * system.partialPivLu().solve(right_side - rows.transpose() * compliance_ * fixed);
    }
    return change;
  }

private:
  const MatrixXd &compliance_;
};
} // namespace

Nodes worst_nodes(const ContactStep &step, const VectorXd &unknowns, const NodeVector &displacement,
                  const std::size_t most)
{
  constexpr double remaining = 0.01; // of the squared map
  const VectorXd map = step.natural_map(unknowns, displacement);
  const auto part = [&](const Index node) { return map.segment<3>(3 * node).squaredNorm(); };
  Nodes nodes(step.n_nodes());
  std::iota(nodes.begin(), nodes.end(), 0);
  const auto n = std::min(most, nodes.size());
  std::partial_sort(nodes.begin(), nodes.begin() + static_cast<Index>(n), nodes.end(),
                    [&](const Index a, const Index b) { return part(a) > part(b); });
  double rest = map.head(3 * step.n_nodes()).squaredNorm();
  const double enough = remaining * rest;
  for (std::size_t i = 0; i < n; ++i)
  {
    rest -= part(nodes[i]);
    if (rest <= enough)
    {
      nodes.resize(i + 1);
      return nodes;
    }
  }
  nodes.resize(n);
  return nodes;
}

VectorXd values_at(const Nodes &nodes, const VectorXd &values)
{
  VectorXd result(3 * static_cast<Index>(nodes.size()));
  for (std::size_t i = 0; i < nodes.size(); ++i)
    result.segment<3>(3 * static_cast<Index>(i)) = values.segment<3>(3 * nodes[i]);
  return result;
}

ComplianceOfFewNodes::ComplianceOfFewNodes(MatrixXd matrix)
    : matrix_(std::move(matrix))
{
  eigen_assert(matrix_.rows() == matrix_.cols() && matrix_.rows() % 3 == 0);
}

void ComplianceOfFewNodes::vmult(NodeVector &displacement, const NodeVector &force) const
{
  displacement = matrix_ * force;
}

Eigen::Matrix3d ComplianceOfFewNodes::diagonal_block(const Index node) const
{
  return matrix_.block<3, 3>(3 * node, 3 * node);
}

std::unique_ptr<ConditionSolver> ComplianceOfFewNodes::condition_solver(double) const
{
  return std::make_unique<DirectSolver>(matrix_);
}
} // namespace orthocone
