// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/node_compliance.h>

#include <orthocone/base/numbers.h>

#include <cmath>

namespace orthocone
{
// W would not do here: w_nn of a mirrored node belongs to all its images.
Eigen::VectorXd node_compliance(const ContactSurface &surface, const ModelSymmetry &symmetry,
                                const MaterialOptions &given)
{
  const MaterialOptions material = given.isotropic();
  constexpr double square = 0.7; // docs/theory.md, section 4
  const double nu = material.poisson_ratio;
  const Eigen::VectorXd shares = symmetry.force_shares(surface);
  Eigen::VectorXd compliance(shares.size());
  for (Eigen::Index i = 0; i < shares.size(); ++i)
  {
    const ContactNode &node = surface.nodes[static_cast<std::size_t>(i)];
    const double radius = node.position[0];
    const bool is_ring = symmetry.is_axisymmetric() && radius > 0;
    const double width = is_ring ? node.area / (2 * pi * radius) : 0;
    const double side = is_ring ? width : std::sqrt(node.area / shares[i]);
    // Of the force on a ring, a square of side h carries the share h^2 / area.
    const double share = is_ring ? node.area / (width * width) : shares[i];
    compliance[i] = (1 - nu * nu) / (square * material.young_modulus * side) / share;
  }
  return compliance;
}

} // namespace orthocone
