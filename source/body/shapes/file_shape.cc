// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "shapes.h"

#include <orthocone/body/shapes/boundary.h>
#include <orthocone/body/shapes/imported_mesh.h>

#include <cmath>
#include <set>
#include <stdexcept>

namespace orthocone
{
namespace
{
/// Numbers of vertices, edges, faces and cells of a mesh; a surface has no cells.
struct Counts
{
  double vertices, edges, faces, cells;

  Counts halved() const
  {
    return {vertices + edges + faces + cells, 2 * edges + 4 * faces + 6 * cells, 4 * faces + 12 * cells,
            8 * cells};
  }
  Counts operator-(const Counts &other) const
  {
    return {vertices - other.vertices, edges - other.edges, faces - other.faces, cells - other.cells};
  }
  double nodes(const double degree) const
  {
    const double inner = degree - 1;
    return vertices + inner * (edges + inner * (faces + inner * cells));
  }
  /// Number of pairs of nodes that share a cell, if these are the entities inside the mesh and all cells.
  /// Cells count the pairs on a face between them twice; subtracting the faces takes off the pairs on an edge
  /// too often, and so on, as in the plane.
  double pairs(const double degree) const
  {
    const double side = (degree + 1) * (degree + 1);
    return side * side * side * cells - side * side * faces + side * edges - vertices;
  }
};

Counts count_all(const dealii::Triangulation<3> &mesh)
{
  return {static_cast<double>(mesh.n_used_vertices()), static_cast<double>(mesh.n_lines()),
          static_cast<double>(mesh.n_quads()), static_cast<double>(mesh.n_cells())};
}

/// Counts the boundary, or the contact surface alone.
Counts count_surface(const dealii::Triangulation<3> &mesh, const bool contact_only)
{
  std::set<unsigned int> vertices, lines;
  double n_faces = 0;
  for (const auto &face : mesh.active_face_iterators())
    if (face->at_boundary() && (!contact_only || face->boundary_id() == Boundary::contact_surface))
    {
      ++n_faces;
      for (const unsigned int v : face->vertex_indices())
        vertices.insert(face->vertex_index(v));
      for (const unsigned int line : face->line_indices())
        lines.insert(face->line_index(line));
    }
  return {static_cast<double>(vertices.size()), static_cast<double>(lines.size()), n_faces, 0};
}

class FileShape : public Shape
{
public:
  FileShape(const GeometryOptions &geometry, const MeshOptions &mesh)
      : imported_(geometry),
        mesh_(mesh)
  {
  }

  void make_solid(const SymmetryPlanes &planes, dealii::Triangulation<3> &triangulation) const override
  {
    if (planes.name() != imported_.planes().name() || planes.normal_to_x != imported_.planes().normal_to_x)
      throw std::logic_error("the file has another part of the body");
    imported_.copy_to(triangulation);
  }

  std::string asymmetry(const ModelSymmetry &symmetry) const override
  {
    if (symmetry.is_axisymmetric())
      return no_body_of_revolution(BodyShape::file);
    const unsigned int direction = symmetry.planes().normal_to_x ? 0 : 1;
    return (direction == 0 ? imported_.planes().normal_to_x : imported_.planes().normal_to_y)
               ? ""
               : std::string("Geometry/Symmetry surfaces has none in ") + "xy"[direction] + " = 0";
  }

  SymmetryPlanes own_planes() const override { return imported_.planes(); }

  /// This includes all refinements of all cells. Held unknowns count as free ones in the stiffness.
  ModelSize size(const ModelSymmetry &) const override
  {
    dealii::Triangulation<3> mesh;
    imported_.copy_to(mesh);
    Counts all = count_all(mesh), boundary = count_surface(mesh, false), contact = count_surface(mesh, true);
    for (unsigned int i = 0; i < mesh_.refinements; ++i)
    {
      all = all.halved();
      boundary = boundary.halved();
      contact = contact.halved();
    }
    constexpr double directions = 3;
    const double nodes = all.nodes(mesh_.degree);
    const double pairs = (all - boundary).pairs(mesh_.degree);
    return {all.cells, contact.nodes(mesh_.degree), directions * nodes,
            directions * (directions * pairs + nodes) / 2};
  }

private:
  const ImportedMesh imported_;
  const MeshOptions mesh_;
};
} // namespace

std::unique_ptr<Shape> make_file_shape(const GeometryOptions &geometry, const MeshOptions &mesh)
{
  return std::make_unique<FileShape>(geometry, mesh);
}
} // namespace orthocone
