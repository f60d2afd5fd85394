// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/backends/contact_frame.h>

#include <orthocone/base/ranks.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace orthocone
{
using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

ContactFrame::ContactFrame(const BodyUnknowns &unknowns, LocalAxes axes)
    : unknowns_(unknowns),
      axes_(std::move(axes))
{
}

NodeVector ContactFrame::moved_with(const RigidMotion &held) const
{
  NodeVector moved(3 * nodes().size());
  for (std::size_t i = 0; i < nodes().size(); ++i)
  {
    moved.segment<3>(3 * static_cast<Index>(i)) =
        global_in_local(i).transpose() * held.at(unknowns_.arm(nodes()[i]));
  }
  return moved;
}

Wrench ContactFrame::wrench(const NodeVector &force) const
{
  Wrench wrench;
  for (std::size_t i = 0; i < nodes().size(); ++i)
    wrench.add(global_in_local(i) * force.segment<3>(3 * static_cast<Index>(i)), unknowns_.arm(nodes()[i]));
  return wrench;
}

VectorXd ContactFrame::with_motion(const RigidMotion &held, const VectorXd &elastic) const
{
  VectorXd displacement = VectorXd::Zero(unknowns_.n_dofs());
  displacement.head(elastic.size()) = elastic;
  unknowns_.hanging().distribute(displacement.data());
  for (unsigned int dof = 0; dof < unknowns_.n_dofs(); ++dof)
    displacement[dof] += held.at(unknowns_.position(dof) - unknowns_.held_centre())[unknowns_.direction(dof)];
  return displacement;
}

VectorXd ContactFrame::on_free_unknowns(const NodeVector &force) const
{
  VectorXd forces = VectorXd::Zero(unknowns_.n_free());
  for (std::size_t i = 0; i < nodes().size(); ++i)
  {
    if (!nodes()[i].is_here())
      continue;
    const Vector3d global = global_in_local(i) * force.segment<3>(3 * static_cast<Index>(i));
    for (Index d = 0; d < 3; ++d)
      if (nodes()[i].is_free[d])
        forces[nodes()[i].dofs[d]] = global[d];
  }
  return forces;
}

double ContactFrame::difference(const NodeVector &displacement, const VectorXd &free) const
{
  double largest = 0;
  for (std::size_t i = 0; i < nodes().size(); ++i)
  {
    if (!nodes()[i].is_here())
      continue;
    const Vector3d global = global_in_local(i) * displacement.segment<3>(3 * static_cast<Index>(i));
    for (Index d = 0; d < 3; ++d)
      largest =
          std::max(largest, std::abs(global[d] - (nodes()[i].is_free[d] ? free[nodes()[i].dofs[d]] : 0)));
  }
  return largest_of_ranks(largest);
}
} // namespace orthocone
