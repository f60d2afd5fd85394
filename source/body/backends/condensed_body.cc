// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/backends/condensed_body.h>

#include <algorithm>
#include <utility>

namespace orthocone
{
using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::VectorXd;

CondensedBody::CondensedBody(const BodyUnknowns &unknowns, const StiffnessFactor &factor, LocalAxes axes)
    : unknowns_(unknowns),
      factor_(factor),
      frame_(unknowns, std::move(axes)),
      compliance_(local_compliance(factor.trailing_inverse()))
{
}

MatrixXd CondensedBody::local_compliance(const MatrixXd &inverse) const
{
  const auto &nodes = unknowns_.contact_surface().nodes;
  const Index n_interior = unknowns_.n_interior();
  std::vector<Matrix3d> turns;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    turns.push_back(frame_.global_in_local(i));
  MatrixXd local(3 * nodes.size(), 3 * nodes.size());
  for (std::size_t j = 0; j < nodes.size(); ++j)
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
      Matrix3d block = Matrix3d::Zero();
      for (Index e = 0; e < 3; ++e)
        for (Index d = 0; d < 3; ++d)
          if (nodes[i].is_free[d] && nodes[j].is_free[e])
            block(d, e) = inverse(nodes[i].dofs[d] - n_interior, nodes[j].dofs[e] - n_interior);
      // Any positive number serves as the compliance of a held direction; one of the node's own size keeps
      // the matrix well conditioned.
      for (Index d = 0; d < 3; ++d)
        if (i == j && !nodes[i].is_free[d])
          block(d, d) = block(2, 2);
      local.block<3, 3>(3 * i, 3 * j) = turns[i].transpose() * block * turns[j];
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
