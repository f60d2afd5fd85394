// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/node_compliance.h>

#include <cmath>

namespace orthocone
{
namespace
{
/// Length (mm) of the modelled part of the ring or line that a node of a section stands for; 0 for a point. A
/// line in a plane of symmetry has half of its width in the model.
double length_of_line(const ContactNode &node, const ModelSymmetry &symmetry)
{
  if (!symmetry.is_section())
    return 0;
  const bool is_halved = symmetry.planes().normal_to_x && node.is_on_plane(0);
  return symmetry.section()->length_at(node.position[0]) / (is_halved ? 2 : 1);
}
} // namespace

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
    const double length = length_of_line(node, symmetry);
    const double width = length > 0 ? node.area / length : 0;
    const double side = length > 0 ? width : std::sqrt(node.area / shares[i]);
    // Of the force on a ring or a line, a square of side h carries the share h^2 / area.
    const double share = length > 0 ? node.area / (width * width) : shares[i];
    compliance[i] = (1 - nu * nu) / (square * material.young_modulus * side) / share;
  }
  return compliance;
}

} // namespace orthocone
