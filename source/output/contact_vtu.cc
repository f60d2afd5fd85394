// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "quadrilateral_vtu.h"

#include <orthocone/output/vtu.h>

namespace orthocone
{
namespace
{
std::vector<QuadrilateralSurface::Field> empty_fields(const std::vector<ContactField> &list,
                                                      const Eigen::Index n_points)
{
  std::vector<QuadrilateralSurface::Field> all;
  for (const ContactField &field : list)
    all.push_back({field.name, Eigen::MatrixXf(field.n_components(), n_points)});
  return all;
}

/// The faces, cut at their nodes. A cell of VTK with more points would be smooth, but VTK does not find the
/// place of a sample in it: it interpolates elsewhere, or finds nothing.
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

std::string contact_vtu(const ContactFieldEvaluator &evaluator, const std::vector<ContactFields> &fields)
{
  const ContactSurface &surface = evaluator.surface();
  const GeometryOptions &geometry = evaluator.scene().parameters().geometry;
  const std::vector<ContactField> list = contact_field_list(evaluator.scene().parameters());
  const WholeSurface whole = evaluator.symmetry().whole(surface);
  const auto n_points = static_cast<Eigen::Index>(whole.nodes.size());
  QuadrilateralSurface drawn{surface.degree, Eigen::Matrix3Xf::Zero(3, n_points),
                             quadrilaterals(whole, surface.degree), empty_fields(list, n_points)};
  for (Eigen::Index point = 0; point < n_points; ++point)
  {
    const auto &[node, image] = whole.nodes[point];
    const ContactNode &place = surface.place(node);
    drawn.points.col(point).head<2>() = whole.place(whole.nodes[point], place.position).cast<float>();
    drawn.points(2, point) = static_cast<float>(place.height);
    ContactFields seen = mapped(fields[node], whole.images[image]);
    seen.surface = image_of_surface(geometry, seen.surface, whole.images[image]);
    for (std::size_t i = 0; i < drawn.fields.size(); ++i)
    {
      const ContactField &field = list[i];
      drawn.fields[i].values.col(point) = field.value(seen).head(field.n_components()).cast<float>();
    }
  }
  return quadrilateral_vtu(drawn);
}
} // namespace orthocone
