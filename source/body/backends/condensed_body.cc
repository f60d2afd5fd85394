// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/backends/condensed_body.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace orthocone
{
using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
Matrix3d in_local_axes(const Matrix3d &block, const Matrix3d &axes_of_row, const Matrix3d &axes_of_column)
{
  return axes_of_row.transpose() * block * axes_of_column;
}
} // namespace

CondensedBody::CondensedBody(const BodyUnknowns &unknowns, const StiffnessFactor &factor, LocalAxes axes)
    : unknowns_(unknowns),
      factor_(factor),
      frame_(unknowns, std::move(axes)),
      compliance_(local_compliance())
{
}

CondensedBody::CondensedBody(const CondensedBody &other, LocalAxes axes)
    : unknowns_(other.unknowns_),
      factor_(other.factor_),
      frame_(unknowns_, std::move(axes)),
      compliance_(turned_compliance(other))
{
}

bool CondensedBody::can_turn() const
{
  const auto is_whole = [](const double component) { return component == 0 || std::abs(component) == 1; };
  for (std::size_t i = 0; i < frame_.nodes().size(); ++i)
    if (const Matrix3d &turn = frame_.global_in_local(i);
        !std::all_of(turn.data(), turn.data() + turn.size(), is_whole))
      return false;
  return true;
}

/// Turning out of global axes that are named in another order, or negative, adds nothing but zeros: the
/// blocks between both turns are those of local_compliance().
MatrixXd CondensedBody::turned_compliance(const CondensedBody &other) const
{
  if (!other.can_turn())
    throw std::logic_error("a compliance turns out of global axes only");
  const DenseView &before = *other.compliance_.dense();
  MatrixXd local(before.rows(), before.cols());
  const Index n = before.rows() / 3;
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i)
    {
      const Matrix3d block = other.frame_.global_in_local(i) * before.block<3, 3>(3 * i, 3 * j) *
                             other.frame_.global_in_local(j).transpose();
      local.block<3, 3>(3 * i, 3 * j) =
          in_local_axes(block, frame_.global_in_local(i), frame_.global_in_local(j));
    }
  return local;
}

/// The inverse of the Schur complement where its unknowns are directions of nodes, turned into local axes.
MatrixXd CondensedBody::local_compliance() const
{
  const auto &nodes = unknowns_.contact_surface().nodes;
  const auto n = static_cast<Index>(nodes.size());
  std::vector<Index> places(unknowns_.n_free() - unknowns_.n_interior());
  std::vector<Matrix3d> turns;
  for (Index i = 0; i < n; ++i)
  {
    turns.push_back(frame_.global_in_local(i));
    for (Index d = 0; d < 3; ++d)
      if (nodes[i].is_free[d])
        places[nodes[i].dofs[d] - unknowns_.n_interior()] = 3 * i + d;
  }
  MatrixXd local = factor_.trailing_inverse(places, 3 * n);
  for (Index i = 0; i < n; ++i)
    for (Index d = 0; d < 3; ++d)
      // Any positive number serves as the compliance of a held direction; one of the node's own size keeps
      // the matrix well conditioned.
      if (!nodes[i].is_free[d])
        local(3 * i + d, 3 * i + d) = local(3 * i + 2, 3 * i + 2);
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i)
    {
      const Matrix3d block = local.block<3, 3>(3 * i, 3 * j);
      local.block<3, 3>(3 * i, 3 * j) = in_local_axes(block, turns[i], turns[j]);
    }
  return local;
}

VectorXd CondensedBody::elastic_displacement(const NodeVector &force) const
{
  return factor_.solve(frame_.on_free_unknowns(force));
}

BodyMismatch CondensedBody::mismatch(const Stiffness &stiffness, const NodeVector &force,
                                     const NodeVector &elastic, const double bound) const
{
  const VectorXd forces = frame_.on_free_unknowns(force);
  VectorXd u = factor_.solve(forces);
  VectorXd rest = forces - stiffness.vmult(u);
  // Rounding errors grow with the condition number of K (near-incompressibility, strong grading); one
  // refinement removes them.
  constexpr double share = 0.1;
  if (rest.norm() > share * bound * forces.norm())
  {
    u += factor_.solve(rest);
    rest = forces - stiffness.vmult(u);
  }
  BodyMismatch mismatch{rest.norm(), 0, {}};
  // What rounding alone may leave does not count as a lack of balance: for a Poisson ratio close to 0.5 the
  // terms of K u cancel.
  if (mismatch.unbalanced > share * bound * forces.norm())
    mismatch.unbalanced = std::max(0., mismatch.unbalanced - stiffness.rounding(u));
  if (mismatch.unbalanced != 0)
    mismatch.unbalanced /= forces.norm();
  mismatch.displacement = frame_.difference(elastic, u);
  mismatch.volume = std::move(u);
  return mismatch;
}
} // namespace orthocone
