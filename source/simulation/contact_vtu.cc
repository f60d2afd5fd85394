// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "quadrilateral_vtu.h"

#include <orthocone/simulation/vtu.h>

namespace orthocone
{
namespace
{
using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// Calls `use` with name and value of each field, in the order of the file.
template<typename Use>
void for_each_field(const ContactFields &fields, const Use &use)
{
  use("displacement", fields.displacement);
  use("slip", fields.slip);
  use("slip_magnitude", fields.slip.norm());
  use("accumulated_slip", fields.accumulated_slip);
  use("gap", fields.gap);
  use("pressure", fields.pressure);
  use("friction_traction", fields.friction_traction);
  use("friction_criterion", fields.friction_criterion);
  use("status", static_cast<double>(fields.status));
  use("nodal_force", fields.nodal_force);
  use("dissipated_energy", fields.dissipated_energy);
}

unsigned int n_components(const double)
{
  return 1;
}

unsigned int n_components(const Vector3d &)
{
  return 3;
}

void put(const double value, const Eigen::Index column, Eigen::MatrixXf &values)
{
  values(0, column) = static_cast<float>(value);
}

void put(const Vector3d &value, const Eigen::Index column, Eigen::MatrixXf &values)
{
  values.col(column) = value.cast<float>();
}

ContactFields mapped(ContactFields fields, const Matrix2d &map)
{
  for (Vector3d *const vector :
       {&fields.displacement, &fields.slip, &fields.friction_traction, &fields.nodal_force})
    vector->head<2>() = map * vector->head<2>().eval();
  return fields;
}

std::vector<QuadrilateralSurface::Field> empty_fields(const std::size_t n_points)
{
  std::vector<QuadrilateralSurface::Field> all;
  for_each_field(ContactFields(),
                 [&](const char *const name, const auto &value) {
                   all.push_back({name, Eigen::MatrixXf(n_components(value), n_points)});
                 });
  return all;
}

/// The faces cut at their nodes. A cell of VTK with more points would be smooth, but VTK does not find the
/// place in it where a sample is asked for: it interpolates elsewhere, or finds nothing.
std::vector<std::array<std::int32_t, 4>> quadrilaterals(const WholeSurface &whole, const unsigned int degree)
{
  std::vector<std::array<std::int32_t, 4>> all;
  for (const auto &face : whole.faces)
    for (unsigned int j = 0; j < degree; ++j)
      for (unsigned int i = 0; i < degree; ++i)
      {
        const auto node = [&](const unsigned int right, const unsigned int up)
        { return static_cast<std::int32_t>(face[(j + up) * (degree + 1) + i + right]); };
        all.push_back({{node(0, 0), node(1, 0), node(1, 1), node(0, 1)}});
      }
  return all;
}
} // namespace

std::string contact_vtu(const ContactFieldEvaluator &evaluator, const ContactState &state)
{
  const ContactSurface &surface = evaluator.surface();
  const WholeSurface whole = evaluator.symmetry().whole(surface);
  const auto n_points = static_cast<Eigen::Index>(whole.nodes.size());
  const auto fields = evaluator.all_fields(state);
  QuadrilateralSurface drawn{surface.degree, Eigen::Matrix3Xf::Zero(3, n_points),
                             quadrilaterals(whole, surface.degree), empty_fields(n_points)};
  for (Eigen::Index point = 0; point < n_points; ++point)
  {
    const auto &[node, image] = whole.nodes[point];
    const auto &place = surface.nodes[node].position;
    drawn.points.col(point).head<2>() = (whole.images[image] * Vector2d(place[0], place[1])).cast<float>();
    auto field = drawn.fields.begin();
    for_each_field(mapped(fields[node], whole.images[image]),
                   [&](const char *, const auto &value) { put(value, point, (field++)->values); });
  }
  return quadrilateral_vtu(drawn);
}
} // namespace orthocone
