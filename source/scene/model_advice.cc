// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/model_advice.h>

#include <orthocone/body/shapes/shape_kind.h>
#include <orthocone/contact/solvers/contact_method.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace orthocone
{
namespace
{
/// Whether a half-space in the place of the body can have all that the scene has.
bool may_be_half_space(const Parameters &parameters)
{
  const GeometryOptions &geometry = parameters.geometry;
  const auto &obstacle = parameters.obstacle.kind;
  return kind_of(geometry).is_meshed() && !geometry.is_from_file() && !geometry.is_plane_strain() &&
         geometry.top_face == TopFace::clamped && geometry.supports.empty() && geometry.loads.empty() &&
         parameters.material.is_uniform_and_isotropic() &&
         !find_contact_method(parameters.contact_solver.method)->needs_dense &&
         (!obstacle.chosen().gives_way() || obstacle == ObstacleKind::half_space);
}

double rounded_up(const double length)
{
  const double digit = std::pow(10, std::floor(std::log10(length)) - 1);
  return digit * std::ceil(length / digit);
}
} // namespace

// Stresses of a contact of radius a fall with the square of the distance: at a face that is h away, the body
// feels its ends by the square of a / h at most, relative to its pressures, and its approach by a / h
// (docs/accuracy.md, "The right model of a ball on a plate").
std::string half_space_advice(const Parameters &parameters, const ExpectedContact &contact)
{
  constexpr double most = 0.1, room = 1.25, percent = 100;
  if (contact.is_line() || !may_be_half_space(parameters))
    return {};
  const ShapeKind &kind = kind_of(parameters.geometry);
  const double a = std::max(contact.half_widths[0], contact.half_widths[1]),
               size =
                   std::min(kind.half_widths(parameters.geometry)[1], kind.held_height(parameters.geometry));
  if (a > most * size)
    return {};
  const auto side = [&](const unsigned int d)
  {
    const double first = contact.first_axis[d] * contact.half_widths[0],
                 second = contact.first_axis[1 - d] * contact.half_widths[1];
    return rounded_up(2 * (room * std::hypot(first, second) + std::abs(contact.centre[d])));
  };
  std::ostringstream text;
  text.precision(2);
  text
      << "Geometry/Shape = half-space with Sizes = " << side(0) << ", " << side(1)
      << " and Mesh/Cells = 64, 64 computes this contact without a mesh; it leaves out the ends of the body, "
         "which change pressures by at most about "
      << percent * a * a / (size * size) << " % and the approach by some " << percent * a / size << " %";
  return text.str();
}
} // namespace orthocone
