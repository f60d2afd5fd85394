// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/shapes/imported_mesh.h>

#include "cell_quality.h"
#include "coarse_curves.h"
#include "extruded_mesh.h"
#include "fitted_surfaces.h"
#include "imported_cells.h"
#include "imported_places.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/numbers.h>
#include <orthocone/base/text.h>
#include <orthocone/body/shapes/boundary.h>
#include <orthocone/body/shapes/supports.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace orthocone
{
namespace
{
using dealii::Point;

constexpr double rounding_of_files = 1e-9; // of the extent: what mesh programs round
} // namespace

GmshFile read_mesh_file(const GeometryOptions &geometry)
{
  return read_gmsh_file(geometry.mesh_file, geometry.is_plane_strain()
                                                ? std::optional<double>(geometry.section_thickness())
                                                : std::nullopt);
}

ImportedMesh::ImportedMesh(const GeometryOptions &geometry)
    : geometry_(geometry),
      file_(read_mesh_file(geometry)),
      box_(file_),
      triangulation_(dealii::Triangulation<3>::limit_level_difference_at_vertices),
      curves_(std::make_unique<CoarseCurves<3>>())
{
  faces_of_group_ = make_imported_cells(file_, triangulation_, *curves_);
  file_ = GmshFile{file_.path, file_.groups, {}, {}, {}, {}, file_.is_second_order};
  measure_box();
  for (const std::string &surface : geometry_.contact_surfaces)
  {
    touching_.push_back(faces_of(surface));
    contact_.insert(contact_.end(), touching_.back().begin(), touching_.back().end());
  }
  std::sort(contact_.begin(), contact_.end());
  held_ = faces_of(geometry_.held_surface);
  for (const std::string &surface : marked_surfaces(geometry_))
    marked_.push_back(faces_of(surface));
  follow_curves();
  find_planes();
  align();
  check_cells();
  check_surfaces();
  if (!curves_->is_empty())
    attach(*curves_, triangulation_);
}

ImportedMesh::~ImportedMesh() = default;

void ImportedMesh::measure_box()
{
  lowest_ = highest_ = triangulation_.get_vertices()[0];
  const auto take = [this](const Point<3> &node)
  {
    for (unsigned int d = 0; d < 3; ++d)
    {
      lowest_[d] = std::min(lowest_[d], node[d]);
      highest_[d] = std::max(highest_[d], node[d]);
    }
  };
  for (const Point<3> &vertex : triangulation_.get_vertices())
    take(vertex);
  for (const auto &middle : curves_->of_lines)
    take(middle.second);
  for (const auto &middle : curves_->of_quads)
    take(middle.second);
  for (unsigned int d = 0; d < 3; ++d)
    extent_ = std::max(extent_, highest_[d] - lowest_[d]);
}

void ImportedMesh::follow_curves()
{
  std::vector<FacesOfSurface> surfaces;
  for (const CurvedSurface &surface : geometry_.curved_surfaces)
    surfaces.push_back({surface, faces_of(surface.surface)});
  if (!surfaces.empty())
    fit_surfaces(surfaces, geometry_.section + "/Curved surfaces", extent_, triangulation_, *curves_);
  if (!surfaces.empty() || !curves_->is_empty())
    complete(*curves_, triangulation_);
}

std::vector<Point<3>> ImportedMesh::nodes_of(const Face &face) const
{
  std::vector<Point<3>> nodes;
  for (const unsigned int v : face->vertex_indices())
    nodes.push_back(face->vertex(v));
  const auto take = [&](const auto &middles, const auto &key)
  {
    if (const auto found = middles.find(key); found != middles.end())
      nodes.push_back(found->second);
  };
  for (const unsigned int line : face->line_indices())
    take(curves_->of_lines, key_of<2>(face->line(line)));
  take(curves_->of_quads, key_of<4>(face));
  return nodes;
}

/// Finds the plane of each symmetry surface. Each must be in one of the two planes, with the body on one side
/// of it.
void ImportedMesh::find_planes()
{
  for (const std::string &surface : geometry_.symmetry_surfaces)
  {
    const double tolerance = tolerance_of(surface);
    std::array<double, 2> off{};
    for (const Face &face : faces_of(surface))
      for (const Point<3> &node : nodes_of(face))
        for (unsigned int d = 0; d < 2; ++d)
          off[d] = std::max(off[d], std::abs(node[d]));
    const unsigned int d = off[0] <= off[1] ? 0 : 1;
    const std::string axis(1, "xy"[d]);
    if (off[d] > tolerance)
      throw InputError(geometry_.section + "/Symmetry surfaces: " + shown(surface) + " reaches to |" + axis +
                       "| = " + to_text(off[d]) + " mm: allowed are surfaces in the plane x = 0 or y = 0");
    if (lowest_[d] < -tolerance)
      throw InputError(geometry_.section + "/Symmetry surfaces: " + shown(surface) + " lies in " + axis +
                       " = 0, and the body reaches to " + axis + " = " + to_text(lowest_[d]) +
                       " mm: allowed is a body at " + axis + " >= 0");
    if (d == 1 && geometry_.is_plane_strain())
      throw InputError(geometry_.section + "/Symmetry surfaces: " + shown(surface) +
                       " lies in y = 0: allowed with Geometry/Kind = plane strain are lines in x = 0");
    (d == 0 ? planes_.normal_to_x : planes_.normal_to_y) = true;
  }
}

void ImportedMesh::align()
{
  const std::set<unsigned int> in_contact = vertices_of(contact_);
  double of_symmetry = rounding_of_files * extent_;
  for (const std::string &surface : geometry_.symmetry_surfaces)
    of_symmetry = std::max(of_symmetry, tolerance_of(surface));
  double of_contact = 0;
  for (const std::string &surface : geometry_.contact_surfaces)
    of_contact = std::max(of_contact, tolerance_of(surface));
  const auto settle = [](double &coordinate, const double tolerance)
  { coordinate = std::abs(coordinate) <= tolerance ? 0 : coordinate; };
  const auto settle_node = [&](Point<3> &node, const bool is_in_contact)
  {
    if (planes_.normal_to_x)
      settle(node[0], of_symmetry);
    if (planes_.normal_to_y)
      settle(node[1], of_symmetry);
    if (is_in_contact)
      settle(node[2], of_contact);
  };
  for (const auto &cell : triangulation_.active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices())
      settle_node(cell->vertex(v), in_contact.count(cell->vertex_index(v)) > 0);
  const auto touches = [&](const auto &key)
  { return std::all_of(key.begin(), key.end(), [&](const auto v) { return in_contact.count(v) > 0; }); };
  for (auto &[key, middle] : curves_->of_lines)
    settle_node(middle, touches(key));
  for (auto &[key, middle] : curves_->of_quads)
    settle_node(middle, touches(key));
}

std::vector<ImportedMesh::Face> ImportedMesh::faces_of(const std::string &surface) const
{
  if (const PhysicalGroup *const group = file_.find(2, surface); group != nullptr)
  {
    const auto found = faces_of_group_.find(group->number);
    return found == faces_of_group_.end() ? std::vector<Face>() : found->second;
  }
  std::vector<Face> faces;
  const std::optional<PlaneOfAxis> plane = box_.find(surface);
  const auto lies_in_plane = [&](const Face &face)
  {
    const std::vector<Point<3>> nodes = nodes_of(face);
    return std::all_of(nodes.begin(), nodes.end(),
                       [&](const Point<3> &node)
                       { return std::abs(node[plane->axis] - plane->at) <= box_.tolerance(); });
  };
  for (const Face &face : triangulation_.active_face_iterators())
    if (plane && face->at_boundary() && lies_in_plane(face))
      faces.push_back(face);
  std::sort(faces.begin(), faces.end());
  return faces;
}

/// How far off their plane the nodes of a surface may be moved into it: those of a surface that is named by
/// its place are all that lie there.
double ImportedMesh::tolerance_of(const std::string &surface) const
{
  return file_.find(2, surface) == nullptr ? box_.tolerance() : rounding_of_files * extent_;
}

dealii::types::boundary_id ImportedMesh::id_of(const Face &face) const
{
  const auto lies_in = [&](const unsigned int d)
  {
    const std::vector<Point<3>> nodes = nodes_of(face);
    return std::all_of(nodes.begin(), nodes.end(), [&](const Point<3> &node) { return node[d] == 0; });
  };
  for (unsigned int surface = 0; surface < touching_.size(); ++surface)
    if (std::binary_search(touching_[surface].begin(), touching_[surface].end(), face))
      return contact_boundary(surface);
  if (std::binary_search(held_.begin(), held_.end(), face))
    return Boundary::top_face;
  if (planes_.normal_to_x && lies_in(0))
    return Boundary::plane_normal_to_x;
  if (planes_.normal_to_y && lies_in(1))
    return Boundary::plane_normal_to_y;
  for (std::size_t i = 0; i < marked_.size(); ++i)
    if (std::binary_search(marked_[i].begin(), marked_[i].end(), face))
      return static_cast<dealii::types::boundary_id>(Boundary::first_support + i);
  return Boundary::lateral_surface;
}

void ImportedMesh::copy_to(dealii::Triangulation<3> &triangulation) const
{
  triangulation.copy_triangulation(triangulation_);
  auto own = triangulation_.begin_active_face();
  for (const auto &face : triangulation.active_face_iterators())
  {
    if (face->at_boundary())
      face->set_boundary_id(id_of(own));
    ++own;
  }
}

void ImportedMesh::copy_to(dealii::Triangulation<2> &section) const
{
  dealii::Triangulation<3> layer;
  copy_to(layer);
  const std::map<unsigned int, unsigned int> numbers = flatten(layer, section);
  if (!curves_->is_empty())
    attach(flattened(*curves_, numbers), section);
  for (const auto &face : section.active_face_iterators())
    if (geometry_.held_surface.empty() || (face->at_boundary() && face->boundary_id() == Boundary::top_face))
      return;
  throw InputError(geometry_.section + "/Held surface = " + shown(geometry_.held_surface) +
                   " has no line of the plane (x, z): allowed is a physical line, or a place such as z max");
}

/// Whether plane faces of a surface meet at angles that are neither nearly 0 nor as large as at an edge.
/// Those of second order, and of surfaces that are named, are not plane.
bool ImportedMesh::has_facets(const Among surfaces) const
{
  if (file_.is_second_order)
    return false;
  const double least = std::cos(pi / 1800), most = std::cos(pi / 4);             // 0.1 and 45 degrees
  std::map<std::pair<unsigned int, unsigned int>, dealii::Tensor<1, 3>> normals; // by line and surface
  for (const auto &cell : triangulation_.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
    {
      if (!face->at_boundary() || curves_->forms_of_quads.count(key_of<4>(face)) > 0 ||
          (surfaces == Among::contact && !is_contact(face->boundary_id())))
        continue;
      dealii::Tensor<1, 3> normal = area_vector(face) / area_vector(face).norm();
      normal *= normal * (face->center() - cell->center()) > 0 ? 1 : -1;
      for (const unsigned int line : face->line_indices())
      {
        const auto [other, is_first] =
            normals.emplace(std::make_pair(face->line_index(line), face->boundary_id()), normal);
        if (const double cosine = other->second * normal; !is_first && cosine < least && cosine > most)
          return true;
      }
    }
  return false;
}

std::vector<std::string> ImportedMesh::warnings(const MeshOptions &mesh) const
{
  std::vector<std::string> warnings;
  if (extent_ < 1)
    warnings.push_back(geometry_.section + "/Mesh file: the body is " + to_text(extent_) +
                       " mm long, because lengths are read as mm; scale a mesh in metres by 1000 (gmsh: "
                       "Mesh.ScalingFactor = 1000)");
  if ((mesh.refinements > 0 || mesh.adaptive > 0 || !mesh.refined_cells.empty()) && has_facets(Among::all))
    warnings.emplace_back(
        mesh.section +
        "/Refinements: the cells of the file have plane faces, so that smaller cells keep "
        "the facets of curved surfaces; elements of second order (gmsh: Mesh.ElementOrder = 2) and " +
        geometry_.section + "/Curved surfaces follow the curves");
  if (!geometry_.faces_down && mesh.degree > 1 && has_facets(Among::contact))
    warnings.push_back(
        geometry_.section +
        "/Mesh file: the cells of the file have plane faces, so that the contact surface is made "
        "of facets where the body is curved; under a curved Obstacle/Distance their edges touch "
        "first, and pressures differ from node to node. A rigid counterface fits the facets with "
        "Obstacle/Normal = surface; elements of second order (gmsh: Mesh.ElementOrder = 2) and " +
        geometry_.section + "/Curved surfaces have none");
  if (!curves_->is_empty() && mesh.degree == 1)
    warnings.push_back(mesh.section + "/Degree = 1: elements of this degree have straight edges between the "
                                      "nodes, whereas the edges of the file are curved; a degree of 2 and "
                                      "more follows them");
  constexpr double poor = 0.1;
  if (worst_quality_ < poor)
    warnings.push_back(geometry_.section + "/Mesh file: the worst cell has a scaled Jacobian of " +
                       to_text(std::round(1e4 * worst_quality_) / 1e4) +
                       ", so that stresses near it are not to be trusted; improve the mesh there");
  return warnings;
}
} // namespace orthocone
