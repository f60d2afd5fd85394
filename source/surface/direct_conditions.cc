// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "direct_conditions.h"

#include <algorithm>
#include <limits>
#include <utility>

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

/// The changes of force that are given.
NodeVector fixed_forces(const ContactConditions &conditions)
{
  NodeVector fixed(3 * static_cast<Index>(conditions.nodes.size()));
  for (std::size_t i = 0; i < conditions.nodes.size(); ++i)
    fixed.segment<3>(3 * static_cast<Index>(i)) = conditions.nodes[i].fixed;
  return fixed;
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
  if (m > 0)
    moved.rightCols(m) = softness * conditions.face;
  return moved;
}

/// `moved_by_fixed` is the displacement by the forces `fixed`.
Equations equations_of(const ContactConditions &conditions, const std::vector<Index> &first,
                       const NodeVector &fixed, const NodeVector &moved_by_fixed, const DenseView &compliance,
                       const double softness)
{
  const Index n = first.back(), m = conditions.face.cols();
  const MatrixXd moved = moved_by_unknowns(conditions, first, compliance, softness);
  Equations equations{MatrixXd::Zero(n + m, n + m), VectorXd(n + m)};
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
    if (m > 0)
      equations.matrix.block(n, k, m, u).noalias() =
          conditions.face.middleRows<3>(place).transpose() * node.basis.leftCols(u);
  }
  if (conditions.face_stiffness.size() > 0)
    equations.matrix.bottomRightCorner(m, m) = -softness * conditions.face_stiffness;
  if (m > 0)
    equations.right_side.tail(m) = conditions.face_right_side - conditions.face.transpose() * fixed;
  return equations;
}

bool is_singular(const Eigen::PartialPivLU<MatrixXd> &factor)
{
  constexpr double rounding = 1e-13; // of the largest pivot
  const VectorXd pivots = factor.matrixLU().diagonal().cwiseAbs();
  return !(pivots.minCoeff() > rounding * pivots.maxCoeff());
}

/// The change of these unknowns.
ContactChange change_of(const ContactConditions &conditions, const std::vector<Index> &first,
                        NodeVector fixed, const VectorXd &unknowns, const double softness)
{
  ContactChange change{std::move(fixed)};
  for (std::size_t i = 0; i < conditions.nodes.size(); ++i)
  {
    const NodeCondition &node = conditions.nodes[i];
    change.force.segment<3>(3 * static_cast<Index>(i)) +=
        node.basis.leftCols(node.n_unknowns) * unknowns.segment(first[i], node.n_unknowns);
  }
  change.face = softness * unknowns.tail(conditions.face.cols());
  return change;
}

std::optional<ContactChange> eliminated(const ContactConditions &conditions, const std::vector<Index> &first,
                                        const DenseView &compliance, const double softness)
{
  NodeVector fixed = fixed_forces(conditions);
  const NodeVector moved = compliance.selfadjointView<Eigen::Lower>() * fixed;
  const Equations equations = equations_of(conditions, first, fixed, moved, compliance, softness);
  if (!equations.matrix.allFinite()) // LAPACK would leave the pivots as they are
    return std::nullopt;
  const Eigen::PartialPivLU<MatrixXd> factor(equations.matrix);
  if (is_singular(factor))
    return std::nullopt;
  return change_of(conditions, first, std::move(fixed), factor.solve(equations.right_side), softness);
}

/// Whether the face is at rest and no node slips: then displacements are given, or forces.
bool are_held(const ContactConditions &conditions)
{
  return conditions.face.cols() == 0 &&
         std::none_of(conditions.nodes.begin(), conditions.nodes.end(),
                      [](const NodeCondition &node) { return node.n_unknowns == 2; });
}

/// The forces that hold the stuck nodes: their W is symmetric, so that half of the work does.
std::optional<ContactChange> held(const ContactConditions &conditions, const std::vector<Index> &first,
                                  const DenseView &compliance)
{
  ContactChange change{fixed_forces(conditions)};
  const NodeVector moved = compliance.selfadjointView<Eigen::Lower>() * change.force;
  MatrixXd matrix(first.back(), first.back());
  VectorXd unknowns(first.back());
  for (std::size_t j = 0; j < conditions.nodes.size(); ++j)
  {
    const NodeCondition &node = conditions.nodes[j];
    const Index place = 3 * static_cast<Index>(j);
    if (node.n_unknowns == 0)
      continue;
    unknowns.segment<3>(first[j]) =
        node.rows.transpose().inverse() * node.right_side - moved.segment<3>(place);
    for (std::size_t i = j; i < conditions.nodes.size(); ++i)
      if (conditions.nodes[i].n_unknowns > 0)
        matrix.block<3, 3>(first[i], first[j]) = compliance.block<3, 3>(3 * static_cast<Index>(i), place);
  }
  const Eigen::LLT<Eigen::Ref<MatrixXd>> factor(matrix);
  if (factor.info() != Eigen::Success)
    return std::nullopt;
  factor.solveInPlace(unknowns);
  for (std::size_t i = 0; i < conditions.nodes.size(); ++i)
    if (conditions.nodes[i].n_unknowns > 0)
      change.force.segment<3>(3 * static_cast<Index>(i)) += unknowns.segment<3>(first[i]);
  return change;
}
} // namespace

VectorXd face_alone(const ContactConditions &conditions, const NodeVector &force)
{
  if (conditions.face_stiffness.size() == 0)
    return VectorXd::Zero(conditions.face.cols());
  return conditions.face_stiffness.completeOrthogonalDecomposition().solve(
      conditions.face.transpose() * force - conditions.face_right_side);
}

std::optional<ContactChange> solve_directly(const ContactConditions &conditions, const DenseView &compliance,
                                            const double softness)
{
  constexpr Index most_unknowns = 100, most_held = 240; // docs/performance.md
  const std::vector<Index> first = first_unknowns(conditions);
  const Index n = first.back();
  if (n > 0 && n <= most_held && are_held(conditions))
    return held(conditions, first, compliance);
  return n > 0 && n <= most_unknowns ? eliminated(conditions, first, compliance, softness) : std::nullopt;
}

std::optional<ContactChange> eliminate(const ContactConditions &conditions, const DenseView &compliance,
                                       const double softness)
{
  const std::vector<Index> first = first_unknowns(conditions);
  return first.back() > 0 ? eliminated(conditions, first, compliance, softness) : std::nullopt;
}

ContactChange eliminate_whatever_it_gives(const ContactConditions &conditions, const DenseView &compliance,
                                          const double softness)
{
  const std::vector<Index> first = first_unknowns(conditions);
  NodeVector fixed = fixed_forces(conditions);
  const Index m = conditions.face.cols();
  if (first.back() == 0)
    return {fixed, face_alone(conditions, fixed)};
  const NodeVector moved = compliance * fixed;
  Equations equations = equations_of(conditions, first, fixed, moved, compliance, softness);
  VectorXd unknowns = VectorXd::Constant(first.back() + m, std::numeric_limits<double>::quiet_NaN());
  if (equations.matrix.allFinite()) // LAPACK might not return
    unknowns = Eigen::PartialPivLU<Eigen::Ref<MatrixXd>>(equations.matrix).solve(equations.right_side);
  return change_of(conditions, first, std::move(fixed), unknowns, softness);
}
} // namespace orthocone
