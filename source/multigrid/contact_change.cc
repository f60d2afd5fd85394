// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "contact_change.h"

#include <orthocone/base/ranks.h>

#include <utility>

namespace orthocone
{
using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

ContactChange contact_change(const ContactFrame &frame, const BodyVector<double> &displacement,
                             const BodyVector<double> &forces, const VectorXd &residual)
{
  const auto n = static_cast<Index>(frame.n_free());
  ContactChange change;
  change.body = {VectorXd(n), residual.size() == 0 ? VectorXd(VectorXd::Zero(n)) : VectorXd(-residual)};
  // First this is K u less the forces that the body lacks already; then the contact forces are taken out.
  VectorXd &left = change.body.residual;
  for (Index i = 0; i < n; ++i)
  {
    change.body.displacement[i] = displacement.local_element(i);
    left[i] += forces.local_element(i);
  }
  change.force.setZero(3 * frame.nodes().size());
  change.displacement.setZero(change.force.size());
  for (std::size_t i = 0; i < frame.nodes().size(); ++i)
  {
    if (!frame.nodes()[i].is_here())
      continue;
    Vector3d force = Vector3d::Zero(), moved = Vector3d::Zero();
    for (unsigned int d = 0; d < 3; ++d)
      if (frame.nodes()[i].is_free[d])
      {
        const unsigned int dof = frame.nodes()[i].dofs[d];
        std::swap(force[d], left[dof]);
        moved[d] = displacement.local_element(dof);
      }
    const auto place = 3 * static_cast<Index>(i);
    change.force.segment<3>(place) = frame.global_in_local(i).transpose() * force;
    change.displacement.segment<3>(place) = frame.global_in_local(i).transpose() * moved;
  }
  sum_over_ranks(change.force.data(), static_cast<std::size_t>(change.force.size()));
  sum_over_ranks(change.displacement.data(), static_cast<std::size_t>(change.displacement.size()));
  left *= -1;
  if (residual.size() > 0)
    left -= residual;
  return change;
}
} // namespace orthocone
