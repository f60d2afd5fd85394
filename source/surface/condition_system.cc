// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "condition_system.h"

#include "direct_conditions.h"
#include "krylov.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace orthocone
{
namespace
{
using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3f;
using Eigen::MatrixXf;
using Eigen::VectorXd;
using Eigen::VectorXf;

/// A condition in single precision, relative to the scale of the compliance, and what preconditions it.
struct Row
{
  Index first = 0; ///< number of its first unknown
  Index n = 0;
  Matrix3f basis = Matrix3f::Zero();
  Matrix3f rows = Matrix3f::Zero();
  Eigen::Vector3f diagonal = Eigen::Vector3f::Zero();
  Matrix3f from_rows = Matrix3f::Zero(); ///< of three unknowns: inverse of rows^T
  float across = 1;                      ///< of two unknowns: the system's diagonal entry of the second
};

Row row_of(const NodeCondition &condition, const Matrix3d &own, const double scale, const Index first)
{
  Row row;
  row.first = first;
  row.n = condition.n_unknowns;
  row.basis = condition.basis.cast<float>();
  row.rows = (scale * condition.rows).cast<float>();
  row.diagonal = condition.diagonal.cast<float>();
  if (row.n == 3)
    row.from_rows = (scale * condition.rows).transpose().inverse().cast<float>();
  else if (row.n == 2)
    if (const double entry = condition.diagonal[1] + condition.rows.col(1).dot(own * condition.basis.col(1));
        entry > 0)
      row.across = static_cast<float>(entry);
  return row;
}

/// The system of all conditions: unknowns of the nodes first, those of the face behind them.
class System
{
public:
  System(const ContactConditions &conditions, const InnerOperator &inner);

  Index n_unknowns() const { return n_ + n_face_; }

  /// Whether a node resists. Where all are open, nothing resists a motion of the face either.
  bool resists() const { return n_ > 0; }
  VectorXd right_side() const;
  VectorXf apply(const VectorXf &unknowns) const;
  VectorXf precondition(const VectorXf &rest) const;
  ContactChange change(const VectorXf &unknowns, double size) const;

private:
  VectorXf forces(const VectorXf &unknowns) const;
  VectorXf tested(const VectorXf &moved) const;
  VectorXf precondition_nodes(const VectorXf &rest) const;
  void prepare_face();

  const ContactConditions &conditions_;
  const InnerOperator &inner_;
  std::vector<Row> rows_;
  Index n_ = 0;
  Index n_face_;
  MatrixXf face_;           ///< 3 nodes x m
  MatrixXf face_columns_;   ///< motions of the face in the nodes' equations, n x m
  MatrixXf face_rows_;      ///< the unknowns in the balance of the face, m x n
  MatrixXf face_stiffness_; ///< in its balance, m x m
  MatrixXf corrections_;    ///< the nodes' preconditioner times face_columns_
  Eigen::FullPivLU<MatrixXf> schur_;
};

System::System(const ContactConditions &conditions, const InnerOperator &inner)
    : conditions_(conditions),
      inner_(inner),
      n_face_(conditions.face.cols())
{
  rows_.reserve(conditions.nodes.size());
  for (const NodeCondition &condition : conditions.nodes)
  {
    rows_.push_back(row_of(condition, inner.own(static_cast<Index>(rows_.size())), inner.scale(), n_));
    n_ += condition.n_unknowns;
  }
  if (n_face_ > 0)
    prepare_face();
}

/// Eliminates the face from the preconditioner: m columns, once for the system.
void System::prepare_face()
{
  face_ = conditions_.face.cast<float>();
  face_columns_.resize(n_, n_face_);
  face_rows_.resize(n_face_, n_);
  corrections_.resize(n_, n_face_);
  for (Index j = 0; j < n_face_; ++j)
  {
    face_columns_.col(j) = tested(face_.col(j));
    corrections_.col(j) = precondition_nodes(face_columns_.col(j));
  }
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (const Row &row = rows_[i]; row.n > 0)
      face_rows_.middleCols(row.first, row.n).noalias() =
          face_.middleRows<3>(3 * static_cast<Index>(i)).transpose() * row.basis.leftCols(row.n);
  face_stiffness_ = MatrixXf::Zero(n_face_, n_face_);
  if (conditions_.face_stiffness.size() > 0)
    face_stiffness_ = (inner_.scale() * conditions_.face_stiffness).cast<float>();
  schur_.compute(face_rows_ * corrections_ + face_stiffness_);
}

VectorXf System::forces(const VectorXf &unknowns) const
{
  VectorXf forces = VectorXf::Zero(3 * static_cast<Index>(rows_.size()));
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (const Row &row = rows_[i]; row.n == 3)
      forces.segment<3>(3 * i) = unknowns.segment<3>(row.first);
    else if (row.n == 2)
      forces.segment<3>(3 * i).noalias() = row.basis.leftCols<2>() * unknowns.segment<2>(row.first);
  return forces;
}

/// The left sides of the nodes' equations for a displacement (relative to the scale).
VectorXf System::tested(const VectorXf &moved) const
{
  VectorXf result(n_);
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (const Row &row = rows_[i]; row.n == 3)
      result.segment<3>(row.first).noalias() = row.rows.transpose() * moved.segment<3>(3 * i);
    else if (row.n == 2)
      result.segment<2>(row.first).noalias() = row.rows.leftCols<2>().transpose() * moved.segment<3>(3 * i);
  return result;
}

VectorXf System::apply(const VectorXf &unknowns) const
{
  VectorXf result(n_unknowns());
  result.head(n_) = tested(inner_.multiply(forces(unknowns)));
  for (const Row &row : rows_)
    if (row.n == 2)
      result[row.first + 1] += row.diagonal[1] * unknowns[row.first + 1];
  if (n_face_ > 0)
  {
    result.head(n_).noalias() += face_columns_ * unknowns.tail(n_face_);
    result.tail(n_face_).noalias() = face_rows_ * unknowns.head(n_);
    if (conditions_.face_stiffness.size() > 0)
      result.tail(n_face_).noalias() -= face_stiffness_ * unknowns.tail(n_face_);
  }
  return result;
}

/// Close to the inverse: a stuck node takes the force that its displacement costs, and so does a slipping
/// node along its first unknown. Across the generator friction itself is soft, and each node is taken alone.
VectorXf System::precondition_nodes(const VectorXf &rest) const
{
  VectorXf moved = VectorXf::Zero(3 * static_cast<Index>(rows_.size()));
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (const Row &row = rows_[i]; row.n == 3)
      moved.segment<3>(3 * i).noalias() = row.from_rows * rest.segment<3>(row.first);
    else if (row.n == 2)
      moved[3 * i] = rest[row.first] / row.rows(0, 0);
  const VectorXf forces = inner_.multiply_stiffness(moved);
  VectorXf result(n_);
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (const Row &row = rows_[i]; row.n == 3)
      result.segment<3>(row.first) = forces.segment<3>(3 * i);
    else if (row.n == 2)
    {
      result[row.first] = forces[3 * i] / row.basis(0, 0);
      result[row.first + 1] = rest[row.first + 1] / row.across;
    }
  return result;
}

VectorXf System::precondition(const VectorXf &rest) const
{
  if (n_face_ == 0)
    return precondition_nodes(rest);
  VectorXf result(n_unknowns());
  const VectorXf nodes = precondition_nodes(rest.head(n_));
  result.tail(n_face_) = schur_.solve(face_rows_ * nodes - rest.tail(n_face_));
  result.head(n_) = nodes - corrections_ * result.tail(n_face_);
  return result;
}

VectorXd System::right_side() const
{
  const auto n_nodes = static_cast<Index>(rows_.size());
  NodeVector fixed(3 * n_nodes);
  for (Index i = 0; i < n_nodes; ++i)
    fixed.segment<3>(3 * i) = conditions_.nodes[i].fixed;
  const double size = fixed.norm();
  VectorXd moved = VectorXd::Zero(fixed.size());
  if (size > 0)
    moved = size * inner_.multiply((fixed / size).cast<float>()).cast<double>();
  VectorXd result(n_unknowns());
  for (Index i = 0; i < n_nodes; ++i)
    for (Index k = 0; k < rows_[i].n; ++k)
      result[rows_[i].first + k] = conditions_.nodes[i].right_side[k] -
                                   rows_[i].rows.col(k).cast<double>().dot(moved.segment<3>(3 * i));
  if (n_face_ > 0)
    result.tail(n_face_) = conditions_.face_right_side - conditions_.face.transpose() * fixed;
  return result;
}

ContactChange System::change(const VectorXf &unknowns, const double size) const
{
  ContactChange change{NodeVector(3 * static_cast<Index>(rows_.size())), VectorXd()};
  for (std::size_t i = 0; i < rows_.size(); ++i)
  {
    const Row &row = rows_[i];
    change.force.segment<3>(3 * static_cast<Index>(i)) =
        conditions_.nodes[i].fixed +
        size * (row.basis.leftCols(row.n) * unknowns.segment(row.first, row.n)).cast<double>();
  }
  change.face = inner_.scale() * size * unknowns.tail(n_face_).cast<double>();
  return change;
}
} // namespace

IterativeChange solve_by_gmres(const ContactConditions &conditions, const InnerOperator &inner,
                               const double accuracy)
{
  constexpr Index most_iterations = 60;
  const System system(conditions, inner);
  const VectorXd right = system.right_side();
  const double size = right.norm();
  KrylovSolution solution{VectorXf::Zero(system.n_unknowns())};
  if (size > 0 && system.resists())
    solution = solve_gmres({system.n_unknowns(), [&](const VectorXf &x) { return system.apply(x); },
                            [&](const VectorXf &x) { return system.precondition(x); }},
                           (right / size).cast<float>(), static_cast<float>(accuracy), most_iterations);
  ContactChange change = system.change(solution.unknowns, size);
  if (!system.resists())
    change.face = face_alone(conditions, change.force);
  return {std::move(change), solution.converged, solution.iterations};
}

ContactChange GmresConditions::solve(const ContactConditions &conditions, const double accuracy) const
{
  IterativeChange solution = solve_by_gmres(conditions, inner_, std::min(accuracy, least_accuracy_));
  n_iterations_ += static_cast<unsigned long>(solution.iterations);
  return std::move(solution.change);
}
} // namespace orthocone
