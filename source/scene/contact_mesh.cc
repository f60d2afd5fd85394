// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/contact_mesh.h>

#include <orthocone/body/shapes/mesh_ladder.h>
#include <orthocone/body/shapes/shape_kind.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace orthocone
{
double contact_reach(const Parameters &parameters)
{
  constexpr double with_room = 1.25;
  constexpr double most_of_base = 0.5;
  const auto contact = expected_contact(parameters);
  if (!contact || contact->is_line())
    return 0;
  const double reach =
      contact->centre.norm() + with_room * std::max(contact->half_widths[0], contact->half_widths[1]);
  const auto widths = kind_of(parameters.geometry).half_widths(parameters.geometry);
  return reach < most_of_base * widths[1] ? reach : 0;
}

MeshOptions ladder_mesh(const Parameters &parameters, const bool is_axisymmetric, const unsigned int level)
{
  return ladder_mesh(parameters.geometry, parameters.mesh, is_axisymmetric, level, contact_reach(parameters));
}

MeshOptions resolved_mesh(const Parameters &parameters, const bool is_axisymmetric)
{
  const bool needs_reach = parameters.mesh.resolution != MeshResolution::custom &&
                           parameters.mesh.resolution != MeshResolution::paper;
  return resolved_mesh(parameters.geometry, parameters.mesh, is_axisymmetric,
                       needs_reach ? contact_reach(parameters) : 0);
}

std::vector<std::string> layer_warnings(const Parameters &parameters)
{
  // Stresses decay over the width of the contact, so that much higher cells do not see them.
  constexpr double most = 4; // half widths, docs/accuracy.md, "Zones that the mesh does not resolve"
  const MeshOptions &mesh = parameters.mesh;
  if (mesh.resolution != MeshResolution::custom || mesh.accuracy != 0)
    return {};
  const double layer =
      std::ldexp(kind_of(parameters.geometry).base_layer(parameters), -static_cast<int>(mesh.refinements));
  const auto contact = layer > 0 ? expected_contact(parameters) : std::nullopt;
  if (!contact || layer <= most * contact->half_widths[0])
    return {};
  std::ostringstream text;
  text << std::setprecision(2) << "Mesh: the layer of cells at the contact is " << layer
       << " mm high, but the half width of the contact to be expected is only " << contact->half_widths[0]
       << " mm; pressure may be wrong by tens of percent: take more layers, or a smaller Layer grading";
  return {text.str()};
}
} // namespace orthocone
