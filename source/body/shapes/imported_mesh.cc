// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/shapes/imported_mesh.h>

#include "cell_quality.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>
#include <orthocone/body/shapes/boundary.h>

#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/grid_tools.h>

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

ImportedMesh::ImportedMesh(const GeometryOptions &geometry)
    : geometry_(geometry),
      file_(read_gmsh_file(geometry.mesh_file)),
      triangulation_(dealii::Triangulation<3>::limit_level_difference_at_vertices)
{
  read();
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
  find_planes();
  align();
  check_cells();
  check_surfaces();
}

void ImportedMesh::read()
{
  dealii::GridIn<3> reader(triangulation_);
  std::istringstream text(file_.text);
  try
  {
    reader.read_msh(text);
  }
  catch (const std::exception &)
  {
    triangulation_.clear();
    throw InputError(file_.path + ": its elements do not fit together: allowed are hexahedra whose nodes are "
                                  "all there, and physical surfaces and lines on the outside alone");
  }
  file_.text.clear();
  triangulation_.reset_all_manifolds();
}

/// Finds the plane of each symmetry surface. Each must be in one of the two planes, with the body on one side
/// of it.
void ImportedMesh::find_planes()
{
  const double tolerance = rounding * extent_;
  for (const std::string &surface : geometry_.symmetry_surfaces)
  {
    std::array<double, 2> off{};
    for (const Face &face : faces_of(number_of(surface)))
      for (const unsigned int v : face->vertex_indices())
        for (unsigned int d = 0; d < 2; ++d)
          off[d] = std::max(off[d], std::abs(face->vertex(v)[d]));
    const unsigned int d = off[0] <= off[1] ? 0 : 1;
    const std::string axis(1, "xy"[d]);
    if (off[d] > tolerance)
      throw InputError("Geometry/Symmetry surfaces: " + shown(surface) + " reaches to |" + axis +
                       "| = " + to_text(off[d]) + " mm: allowed are surfaces in the plane x = 0 or y = 0");
    if (lowest_[d] < -tolerance)
      throw InputError("Geometry/Symmetry surfaces: " + shown(surface) + " lies in " + axis +
                       " = 0, and the body reaches to " + axis + " = " + to_text(lowest_[d]) +
                       " mm: allowed is a body at " + axis + " >= 0");
    (d == 0 ? planes_.normal_to_x : planes_.normal_to_y) = true;
  }
}

void ImportedMesh::align()
{
  const std::set<unsigned int> in_contact = vertices_of(faces_of(number_of(geometry_.contact_surface)));
  const auto settle = [&](double &coordinate)
  { coordinate = std::abs(coordinate) <= rounding * extent_ ? 0 : coordinate; };
  for (const auto &cell : triangulation_.active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices())
    {
      if (planes_.normal_to_x)
        settle(cell->vertex(v)[0]);
      if (planes_.normal_to_y)
        settle(cell->vertex(v)[1]);
      if (in_contact.count(cell->vertex_index(v)) > 0)
        settle(cell->vertex(v)[2]);
    }
}

void ImportedMesh::check_cells()
{
  for (const auto &cell : triangulation_.active_cell_iterators())
    if (const double quality = scaled_jacobian(cell); !(quality > worst_quality_))
    {
      worst_quality_ = quality;
      worst_place_ = cell->center();
      if (!(quality > 0))
        throw InputError(
            file_.path + ": the cell at " + place(worst_place_) +
            " is inverted: allowed are hexahedra with a positive volume at each of their corners");
    }
  if (const unsigned int n = n_pieces(triangulation_); n > 1)
    throw InputError(file_.path + ": has " + std::to_string(n) +
                     " pieces without a common face: allowed is one body (gmsh: Coherence, Coherence Mesh)");
}

/// Refuses quadrilaterals that are not faces of a cell: they are no surface of the body, but deal.II accepts
/// them.
void ImportedMesh::require_outside(const std::string &entry, const std::string &surface) const
{
  const std::size_t given = file_.find(2, surface)->n_elements, outside = faces_of(number_of(surface)).size();
  if (outside != given)
    throw InputError("Geometry/" + entry + " = " + shown(surface) + " has " + std::to_string(given) +
                     " faces, of which " + std::to_string(outside) +
                     " are on the outside of the cells: allowed are all");
}

void ImportedMesh::check_surfaces() const
{
  require_outside("Contact surface", geometry_.contact_surface);
  require_outside("Held surface", geometry_.held_surface);
  const auto contact = faces_of(number_of(geometry_.contact_surface));
  const std::set<unsigned int> vertices = vertices_of(contact);
  for (const auto held : vertices_of(faces_of(number_of(geometry_.held_surface))))
    if (vertices.count(held) > 0)
      throw InputError("Geometry/Held surface = " + shown(geometry_.held_surface) +
                       " has nodes of the contact surface, such as " +
                       place(triangulation_.get_vertices()[held]) +
                       ": allowed are surfaces that do not touch");
  for (const auto vertex : vertices)
    if (const Point<3> &at = triangulation_.get_vertices()[vertex]; at[2] < 0)
      throw InputError("Geometry/Contact surface = " + shown(geometry_.contact_surface) +
                       " is below the plane at " + place(at) +
                       ": allowed is z >= 0, where the heights of its nodes are their gaps");
  for (const auto &cell : triangulation_.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary() && id_of(face) == Boundary::contact_surface)
        if (const auto normal = area_vector(face);
            normal * (face->center() - cell->center()) * normal[2] >= 0)
          throw InputError("Geometry/Contact surface = " + shown(geometry_.contact_surface) +
                           " does not look down at " + place(face->center()) +
                           ": allowed is a surface whose normal has a part along -z, onto the plane");
}

std::vector<ImportedMesh::Face> ImportedMesh::faces_of(const unsigned int number) const
{
  std::vector<Face> faces;
  for (const Face &face : triangulation_.active_face_iterators())
    if (face->at_boundary() && face->boundary_id() == number)
      faces.push_back(face);
  return faces;
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
  if (face->boundary_id() == number_of(geometry_.contact_surface))
    return Boundary::contact_surface;
  if (face->boundary_id() == number_of(geometry_.held_surface))
    return Boundary::top_face;
  if (planes_.normal_to_x && lies_in(0))
    return Boundary::plane_normal_to_x;
  return planes_.normal_to_y && lies_in(1) ? Boundary::plane_normal_to_y : Boundary::lateral_surface;
}

void ImportedMesh::copy_to(dealii::Triangulation<3> &triangulation) const
{
  triangulation.copy_triangulation(triangulation_);
  for (const auto &face : triangulation.active_face_iterators())
    if (face->at_boundary())
      face->set_boundary_id(id_of(face));
}
} // namespace orthocone
