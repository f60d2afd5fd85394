// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/shapes/imported_mesh.h>

#include "cell_quality.h"
#include "extruded_mesh.h"
#include "imported_cells.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/numbers.h>
#include <orthocone/base/text.h>
#include <orthocone/body/shapes/boundary.h>
#include <orthocone/body/shapes/supports.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <set>
#include <sstream>

namespace orthocone
{
namespace
{
using dealii::Point;

constexpr double rounding = 1e-9; // of the extent: the rounding of mesh programs

std::string place(const Point<3> &point)
{
  std::ostringstream text;
  text << std::setprecision(4) << "(" << point[0] << ", " << point[1] << ", " << point[2] << ") mm";
  return text.str();
}

std::set<unsigned int> vertices_of(const std::vector<dealii::Triangulation<3>::active_face_iterator> &faces)
{
  std::set<unsigned int> all;
  for (const auto &face : faces)
    for (const unsigned int v : face->vertex_indices())
      all.insert(face->vertex_index(v));
  return all;
}
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
      triangulation_(dealii::Triangulation<3>::limit_level_difference_at_vertices)
{
  faces_of_group_ = make_imported_cells(file_, triangulation_);
  file_ = GmshFile{file_.path, file_.groups, {}, {}, {}, {}};
  const auto &vertices = triangulation_.get_vertices();
  lowest_ = highest_ = vertices[0];
  for (const Point<3> &vertex : vertices)
    for (unsigned int d = 0; d < 3; ++d)
    {
      lowest_[d] = std::min(lowest_[d], vertex[d]);
      highest_[d] = std::max(highest_[d], vertex[d]);
    }
  for (unsigned int d = 0; d < 3; ++d)
    extent_ = std::max(extent_, highest_[d] - lowest_[d]);
  for (const std::string &surface : geometry_.contact_surfaces)
  {
    touching_.push_back(faces_of(surface));
    contact_.insert(contact_.end(), touching_.back().begin(), touching_.back().end());
  }
  std::sort(contact_.begin(), contact_.end());
  held_ = faces_of(geometry_.held_surface);
  for (const std::string &surface : marked_surfaces(geometry_))
    marked_.push_back(faces_of(surface));
  find_planes();
  align();
  check_cells();
  check_surfaces();
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
      for (const unsigned int v : face->vertex_indices())
        for (unsigned int d = 0; d < 2; ++d)
          off[d] = std::max(off[d], std::abs(face->vertex(v)[d]));
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
  double of_symmetry = rounding * extent_;
  for (const std::string &surface : geometry_.symmetry_surfaces)
    of_symmetry = std::max(of_symmetry, tolerance_of(surface));
  double of_contact = 0;
  for (const std::string &surface : geometry_.contact_surfaces)
    of_contact = std::max(of_contact, tolerance_of(surface));
  const auto settle = [](double &coordinate, const double tolerance)
  { coordinate = std::abs(coordinate) <= tolerance ? 0 : coordinate; };
  for (const auto &cell : triangulation_.active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices())
    {
      if (planes_.normal_to_x)
        settle(cell->vertex(v)[0], of_symmetry);
      if (planes_.normal_to_y)
        settle(cell->vertex(v)[1], of_symmetry);
      if (in_contact.count(cell->vertex_index(v)) > 0)
        settle(cell->vertex(v)[2], of_contact);
    }
}

void ImportedMesh::check_cells()
{
  std::vector<std::string> inverted;
  for (const auto &cell : triangulation_.active_cell_iterators())
    if (const double quality = scaled_jacobian(cell); !(quality > 0))
      inverted.push_back(place(cell->center()));
    else if (quality <= worst_quality_)
    {
      worst_quality_ = quality;
      worst_place_ = cell->center();
    }
  const bool is_one = inverted.size() == 1;
  FaultList faults;
  if (!inverted.empty())
    faults.add((is_one ? "the cell at " : "the cells at ") + enumeration(inverted) +
               (is_one ? " is" : " are") +
               " inverted: allowed are hexahedra with a positive volume at each of their corners");
  if (const unsigned int n = n_pieces(triangulation_); n > 1)
    faults.add("has " + std::to_string(n) +
               " pieces without a common face: allowed is one body (gmsh: Coherence, Coherence Mesh)");
  faults.throw_if_any(file_.path + ": ");
}

/// Finds quadrilaterals of a physical surface that are no faces of the body.
void ImportedMesh::check_outside(const std::string &given, const std::string &surface,
                                 FaultList &faults) const
{
  const PhysicalGroup *const group = file_.find(2, surface);
  const std::size_t outside = faces_of(surface).size(),
                    n_given = group == nullptr ? outside : group->n_elements;
  if (outside != n_given)
    faults.add(given + " has " + std::to_string(n_given) + " faces, of which " + std::to_string(outside) +
               " are on the outside of the cells: allowed are all");
}

/// Finds places where the contact surface is below its plane or does not look down on it.
void ImportedMesh::check_contact(FaultList &faults) const
{
  const std::string given = geometry_.contact_entry();
  std::vector<std::string> below, upwards;
  for (const auto vertex : vertices_of(contact_))
    if (const Point<3> &at = triangulation_.get_vertices()[vertex]; at[2] < 0)
      below.push_back(place(at));
  for (const auto &cell : triangulation_.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary() && is_contact(id_of(face)))
        if (const auto normal = area_vector(face);
            normal * (face->center() - cell->center()) * normal[2] >= 0)
          upwards.push_back(place(face->center()));
  if (!below.empty())
    faults.add(given + " is below the plane at " + enumeration(below) +
               ": allowed is z >= 0, because the height of a contact node is its gap, or a counterface by "
               "Obstacle/Distance");
  if (!upwards.empty())
    faults.add(given + " does not look down at " + enumeration(upwards) +
               ": allowed is a surface that faces downwards, towards the counterface, or a counterface by "
               "Obstacle/Distance or with Obstacle/Normal = surface");
}

void ImportedMesh::check_surfaces() const
{
  FaultList faults;
  const auto check = [&](const std::string &entry, const std::string &surface)
  { check_outside(geometry_.section + "/" + entry + " = " + shown(surface), surface, faults); };
  for (const std::string &surface : geometry_.contact_surfaces)
    check("Contact surface", surface);
  check("Held surface", geometry_.held_surface);
  if (const auto twice = std::adjacent_find(contact_.begin(), contact_.end()); twice != contact_.end())
    faults.add(geometry_.contact_entry() + " has a face in two of its surfaces, at " +
               place((*twice)->center()) + ": allowed are surfaces without common faces");
  const std::set<unsigned int> vertices = vertices_of(contact_);
  std::vector<std::string> common;
  for (const auto held : vertices_of(held_))
    if (vertices.count(held) > 0)
      common.push_back(place(triangulation_.get_vertices()[held]));
  if (!common.empty())
    faults.add(geometry_.section + "/Held surface = " + shown(geometry_.held_surface) +
               " has nodes of the contact surface, such as " + common.front() +
               ": allowed are surfaces that do not touch");
  check_marked(faults);
  if (geometry_.faces_down)
    check_contact(faults);
  faults.throw_if_any();
}

/// Finds surfaces of supports and loads with faces of another surface that counts: each face has one name.
void ImportedMesh::check_marked(FaultList &faults) const
{
  const std::vector<std::string> names = marked_surfaces(geometry_);
  for (std::size_t i = 0; i < marked_.size(); ++i)
  {
    const bool is_support = std::any_of(geometry_.supports.begin(), geometry_.supports.end(),
                                        [&](const Support &support) { return support.surface == names[i]; });
    const std::string given =
        (is_support ? geometry_.section + "/Supports: " : std::string("Load program/Loads: ")) +
        shown(names[i]);
    check_outside(given, names[i], faults);
    for (const Face &face : marked_[i])
    {
      const auto id = id_of(face);
      const std::string other = is_contact(id)                 ? "the contact surface"
                                : id == Boundary::top_face     ? "the held surface"
                                : id < Boundary::first_support ? "a plane of symmetry"
                                : id < Boundary::first_support + i
                                    ? shown(names[id - Boundary::first_support])
                                    : "";
      if (other.empty())
        continue;
      faults.add(given + " has faces of " + other + ", such as the one at " + place(face->center()) +
                 ": allowed are surfaces without common faces");
      break;
    }
  }
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
  const auto is_in_plane = [&](const Point<3> &point)
  { return std::abs(point[plane->axis] - plane->at) <= box_.tolerance(); };
  for (const Face &face : triangulation_.active_face_iterators())
    if (plane && face->at_boundary() && is_in_plane(face->vertex(0)) && is_in_plane(face->vertex(1)) &&
        is_in_plane(face->vertex(2)) && is_in_plane(face->vertex(3)))
      faces.push_back(face);
  std::sort(faces.begin(), faces.end());
  return faces;
}

/// How far off their plane the nodes of a surface may be moved into it: those of a surface that is named by
/// its place are all that lie there.
double ImportedMesh::tolerance_of(const std::string &surface) const
{
  return file_.find(2, surface) == nullptr ? box_.tolerance() : rounding * extent_;
}

dealii::types::boundary_id ImportedMesh::id_of(const Face &face) const
{
  const auto lies_in = [&](const unsigned int d)
  {
    for (const unsigned int v : face->vertex_indices())
      if (face->vertex(v)[d] != 0)
        return false;
    return true;
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
  flatten(layer, section);
  for (const auto &face : section.active_face_iterators())
    if (geometry_.held_surface.empty() || (face->at_boundary() && face->boundary_id() == Boundary::top_face))
      return;
  throw InputError(geometry_.section + "/Held surface = " + shown(geometry_.held_surface) +
                   " has no line of the plane (x, z): allowed is a physical line, or a place such as z max");
}

/// Whether faces of a surface meet at angles that are neither nearly 0 nor as large as at an edge.
bool ImportedMesh::is_curved() const
{
  const double least = std::cos(pi / 1800), most = std::cos(pi / 4);             // 0.1 and 45 degrees
  std::map<std::pair<unsigned int, unsigned int>, dealii::Tensor<1, 3>> normals; // by line and surface
  for (const auto &cell : triangulation_.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
    {
      if (!face->at_boundary())
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
  if ((mesh.refinements > 0 || mesh.adaptive > 0 || !mesh.refined_cells.empty()) && is_curved())
    warnings.emplace_back(mesh.section +
                          "/Refinements: the cells of the file have plane faces, so that smaller cells keep "
                          "the facets of curved surfaces; only a finer mesh by gmsh follows the curves");
  if (!geometry_.faces_down && mesh.degree > 1 && is_curved())
    warnings.push_back(
        geometry_.section +
        "/Mesh file: the cells of the file have plane faces, so that the contact surface is made "
        "of facets where the body is curved; under a curved Obstacle/Distance their edges touch "
        "first, and pressures differ from node to node. Obstacle/Normal = surface fits the "
        "facets, and smaller cells make them smaller");
  constexpr double poor = 0.1;
  if (worst_quality_ < poor)
    warnings.push_back(geometry_.section + "/Mesh file: the worst cell has a scaled Jacobian of " +
                       to_text(std::round(1e4 * worst_quality_) / 1e4) +
                       ", so that stresses near it are not to be trusted; improve the mesh there");
  return warnings;
}
} // namespace orthocone
