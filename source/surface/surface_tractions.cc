// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/surface_tractions.h>

namespace orthocone
{
std::vector<Eigen::Vector3d> surface_tractions(const ContactSurface &surface, const LocalAxes &axes,
                                               const Eigen::VectorXd &forces)
{
  std::vector<Eigen::Vector3d> tractions;
  for (std::size_t node = 0; node < surface.nodes.size(); ++node)
  {
    const Eigen::Vector3d force =
        axes.global_in_local(node) * forces.segment<3>(3 * static_cast<Eigen::Index>(node));
    const ContactNode &at = surface.nodes[node];
    tractions.emplace_back(force / (at.area_vector.isZero(0) ? at.area : at.area_vector.norm()));
  }
  return tractions;
}
} // namespace orthocone
