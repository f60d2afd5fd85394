// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "drawn_body.h"

#include <orthocone/body/shapes/boundary.h>
#include <orthocone/body/shapes/shape_kind.h>
#include <orthocone/body/shapes/supports.h>

#include <algorithm>
#include <map>
#include <utility>

namespace orthocone
{
namespace
{
using Eigen::Vector3d;

/// A point of a mesh in the axes of the scene: of a section (r, z) or (x, z) in the plane y = 0.
template<int dim>
Vector3d in_space(const dealii::Point<dim> &point)
{
  return {point[0], dim == 3 ? point[1] : 0, point[dim - 1]};
}

/// A surface of the body: its name, and what it is for. Surfaces without a name are the rest of the boundary.
struct NamedSurface
{
  std::string name;
  std::vector<std::string> roles{};
};

/// The surfaces by their boundary ids.
std::map<dealii::types::boundary_id, NamedSurface> named_surfaces(const GeometryOptions &geometry)
{
  std::map<dealii::types::boundary_id, NamedSurface> surfaces;
  const std::vector<std::string> names = kind_of(geometry).surfaces(geometry);
  const auto own_name = [&](const std::size_t i, const std::string &of_file) {
    return geometry.is_from_file() ? of_file : i < names.size() ? names[i] : std::string();
  };
  const std::vector<std::string> touching = geometry.touching_surfaces();
  for (unsigned int i = 1; i < touching.size(); ++i)
    surfaces[contact_boundary(i)] = {touching[i], {"contact"}};
  surfaces[Boundary::contact_surface] = {touching.empty() ? own_name(0, "") : touching.front(), {"contact"}};
  surfaces[Boundary::top_face] = {own_name(1, geometry.held_surface), {}};
  if (geometry.top_face != TopFace::free)
    surfaces[Boundary::top_face].roles.emplace_back("held");
  surfaces[Boundary::lateral_surface] = {};
  surfaces[Boundary::plane_normal_to_x] = {"x = 0", {"symmetry"}};
  surfaces[Boundary::plane_normal_to_y] = {"y = 0", {"symmetry"}};
  surfaces[Boundary::axis] = {"axis", {"axis"}};
  for (const std::string &name : marked_surfaces(geometry))
    surfaces[boundary_of_marked(geometry, name)].name = name;
  for (const Support &support : geometry.supports)
    surfaces[boundary_of_marked(geometry, support.surface)].roles.emplace_back("support");
  for (const Load &load : geometry.loads)
    for (const std::string &name : load.surfaces)
      if (geometry.has(load))
        surfaces[boundary_of_marked(geometry, name)].roles.emplace_back("load");
  return surfaces;
}

/// The middle of an edge, on the curved surface where it lies on one; nothing for a straight edge.
template<typename Edge>
std::optional<Vector3d> middle_off_chord(const Edge &edge)
{
  constexpr bool on_manifold = true;
  constexpr double rounding = 1e-6; // of the length of the edge
  const auto middle = edge->center(on_manifold);
  if (middle.distance((edge->vertex(0) + edge->vertex(1)) / 2) <= rounding * edge->diameter())
    return std::nullopt;
  return in_space(middle);
}

/// The corners of a quadrilateral in the order of its border, and the middles of curved edges between them.
template<typename Quad>
std::vector<Vector3d> border_of(const Quad &quad)
{
  constexpr std::array<unsigned int, 4> corners{{0, 1, 3, 2}}, edges{{2, 1, 3, 0}};
  std::vector<Vector3d> points;
  for (unsigned int i = 0; i < corners.size(); ++i)
  {
    points.push_back(in_space(quad->vertex(corners[i])));
    if (const auto middle = middle_off_chord(quad->line(edges[i])))
      points.push_back(*middle);
  }
  return points;
}

/// The points of a face on the boundary of a cell: its border, or the line of a section.
std::vector<Vector3d> points_of(const dealii::Triangulation<3>::active_cell_iterator &cell,
                                const unsigned int face)
{
  std::vector<Vector3d> points = border_of(cell->face(face));
  Vector3d area = Vector3d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i)
    area += (points[i] - points[0]).cross(points[(i + 1) % points.size()] - points[0]);
  if (area.dot(in_space(cell->face(face)->center()) - in_space(cell->center())) < 0)
    std::reverse(points.begin(), points.end());
  return points;
}

std::vector<Vector3d> points_of(const dealii::Triangulation<2>::active_cell_iterator &cell,
                                const unsigned int face)
{
  const auto line = cell->face(face);
  std::vector<Vector3d> points{in_space(line->vertex(0)), in_space(line->vertex(1))};
  if (const auto middle = middle_off_chord(line))
    points.insert(points.begin() + 1, *middle);
  return points;
}

OrderedJson json_of(std::vector<Vector3d> points, const bool is_mirrored)
{
  OrderedJson json = OrderedJson::array();
  if (is_mirrored)
    std::reverse(points.begin(), points.end()); // the mirror turns faces over
  for (const Vector3d &point : points)
    json.push_back({point[0], point[1], is_mirrored ? -point[2] : point[2]});
  return json;
}

/// Faces of the boundary by their ids.
template<int dim>
std::map<dealii::types::boundary_id, OrderedJson> faces_of(const dealii::Triangulation<dim> &mesh,
                                                           const bool is_mirrored)
{
  std::map<dealii::types::boundary_id, OrderedJson> faces;
  for (const auto &cell : mesh.active_cell_iterators())
    for (const unsigned int face : cell->face_indices())
      if (cell->face(face)->at_boundary())
        faces[cell->face(face)->boundary_id()].push_back(json_of(points_of(cell, face), is_mirrored));
  return faces;
}

OrderedJson cells_of(const dealii::Triangulation<3> &, const bool)
{
  return OrderedJson::array(); // the faces hide them
}

OrderedJson cells_of(const dealii::Triangulation<2> &mesh, const bool is_mirrored)
{
  OrderedJson cells = OrderedJson::array();
  for (const auto &cell : mesh.active_cell_iterators())
    cells.push_back(json_of(border_of(cell), is_mirrored));
  return cells;
}

OrderedJson supports_json(const GeometryOptions &geometry)
{
  OrderedJson supports = OrderedJson::array();
  for (const Support &support : geometry.supports)
    supports.push_back({{"surface", support.surface}, {"directions", support.directions}});
  return supports;
}

OrderedJson surfaces_json(const Body &body, const GeometryOptions &geometry)
{
  OrderedJson surfaces = OrderedJson::array();
  const auto names = named_surfaces(geometry);
  const auto faces =
      body.visit([&](const auto &space)
                 { return faces_of(space.dof_handler().get_triangulation(), geometry.is_mirrored()); });
  for (const auto &[id, of_surface] : faces)
  {
    const auto found = names.find(id);
    const NamedSurface named = found == names.end() ? NamedSurface() : found->second;
    surfaces.push_back({{"name", named.name}, {"roles", named.roles}, {"faces", of_surface}});
  }
  return surfaces;
}
} // namespace

BodyOptions with_outline_mesh(BodyOptions options)
{
  if (GeometryOptions &geometry = options.geometry; !kind_of(geometry).is_meshed())
  {
    geometry.shape = BodyShape::box;
    geometry.sizes[2] = std::min(geometry.sizes[0], geometry.sizes[1]) / 2;
  }
  MeshOptions outline;
  outline.section = options.mesh.section;
  outline.degree = 1;
  options.mesh = outline;
  return options;
}

unsigned int n_drawn(const Body &body)
{
  return body.visit(
      [](const auto &space)
      {
        const auto &mesh = space.dof_handler().get_triangulation();
        if (mesh.dimension == 2)
          return static_cast<unsigned int>(mesh.n_active_cells());
        unsigned int n = 0;
        for (const auto &cell : mesh.active_cell_iterators())
          for (const unsigned int face : cell->face_indices())
            n += cell->face(face)->at_boundary() ? 1 : 0;
        return n;
      });
}

OrderedJson body_json(const Body &body, const BodyOptions &options)
{
  const GeometryOptions &geometry = options.geometry;
  const Vector3d centre = body.unknowns().held_centre();
  const double up = geometry.is_mirrored() ? -1 : 1;
  return {{"text", kind_of(geometry).describe(geometry)},
          {"is_from_file", geometry.is_from_file()},
          {"top_face", to_word(geometry.top_face)},
          {"held_centre", {centre[0], centre[1], up * centre[2]}},
          {"supports", supports_json(geometry)},
          {"surfaces", surfaces_json(body, geometry)},
          {"cells", body.visit(
                        [&](const auto &space) {
                          return cells_of(space.dof_handler().get_triangulation(), geometry.is_mirrored());
                        })}};
}
} // namespace orthocone
