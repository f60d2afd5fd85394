// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "../names_of_groups.h"
#include "file_checks.h"
#include "shapes.h"

#include <orthocone/body/shapes/boundary.h>
#include <orthocone/body/shapes/curved_surfaces.h>
#include <orthocone/body/shapes/imported_mesh.h>
#include <orthocone/body/shapes/supports.h>

#include <array>
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
  /// The same where faces are the cells.
  double pairs_in_plane(const double degree) const
  {
    const double side = (degree + 1) * (degree + 1);
    return side * side * faces - side * edges + vertices;
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
    if (face->at_boundary() && (!contact_only || is_contact(face->boundary_id())))
    {
      ++n_faces;
      for (const unsigned int v : face->vertex_indices())
        vertices.insert(face->vertex_index(v));
      for (const unsigned int line : face->line_indices())
        lines.insert(face->line_index(line));
    }
  return {static_cast<double>(vertices.size()), static_cast<double>(lines.size()), n_faces, 0};
}

/// Counts of a plane mesh: all, its outline, and the contact lines.
std::array<Counts, 3> count_section(const dealii::Triangulation<2> &mesh)
{
  std::array<std::set<unsigned int>, 2> vertices; // of outline and contact
  std::array<double, 2> lines{};
  for (const auto &face : mesh.active_face_iterators())
    for (unsigned int i = 0; i < 2; ++i)
      if (face->at_boundary() && (i == 0 || is_contact(face->boundary_id())))
      {
        ++lines[i];
        vertices[i].insert(face->vertex_index(0));
        vertices[i].insert(face->vertex_index(1));
      }
  const auto count = [](const auto n) { return static_cast<double>(n); };
  return {{{count(mesh.n_used_vertices()), count(mesh.n_lines()), count(mesh.n_cells()), 0},
           {count(vertices[0].size()), lines[0], 0, 0},
           {count(vertices[1].size()), lines[1], 0, 0}}};
}

class FileShape : public Shape
{
public:
  FileShape(const GeometryOptions &geometry, const MeshOptions &mesh)
      : geometry_(geometry),
        imported_(geometry),
        mesh_(mesh)
  {
  }

  void make_solid(const SymmetryPlanes &planes, dealii::Triangulation<3> &triangulation) const override
  {
    if (planes.name() != imported_.planes().name() || planes.normal_to_x != imported_.planes().normal_to_x)
      throw std::logic_error("the file has another part of the body");
    imported_.copy_to(triangulation);
  }

  void make_section(const ModelSymmetry &symmetry, dealii::Triangulation<2> &triangulation) const override
  {
    if (!symmetry.is_plane_strain() || symmetry.planes().name() != imported_.planes().name())
      return Shape::make_section(symmetry, triangulation);
    imported_.copy_to(triangulation);
  }

  std::string asymmetry(const ModelSymmetry &symmetry) const override
  {
    if (symmetry.is_axisymmetric())
      return no_body_of_revolution(geometry_);
    if (const std::string why = asymmetry_of_surfaces(geometry_, symmetry); !why.empty())
      return why;
    if (symmetry.is_plane_strain() && !symmetry.planes().normal_to_x)
      return {};
    const unsigned int direction = symmetry.planes().normal_to_x ? 0 : 1;
    return (direction == 0 ? imported_.planes().normal_to_x : imported_.planes().normal_to_y)
               ? ""
               : geometry_.section + "/Symmetry surfaces lists none in " + "xy"[direction] + " = 0";
  }

  SymmetryPlanes own_planes() const override { return imported_.planes(); }

  /// This includes all refinements of all cells. Held unknowns count as free ones in the stiffness.
  ModelSize size(const ModelSymmetry &symmetry) const override
  {
    if (symmetry.is_plane_strain())
      return size_of_section(symmetry.section()->n_components());
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
  ModelSize size_of_section(const unsigned int n_components) const
  {
    dealii::Triangulation<2> mesh;
    imported_.copy_to(mesh);
    auto [all, outline, contact] = count_section(mesh);
    for (Counts *const counts : {&all, &outline, &contact})
      for (unsigned int i = 0; i < mesh_.refinements; ++i)
        *counts = counts->halved();
    const double nodes = all.nodes(mesh_.degree), pairs = (all - outline).pairs_in_plane(mesh_.degree);
    const double of_third = n_components == 3 ? (pairs + nodes) / 2 : 0; // a block of its own
    return {all.faces, contact.nodes(mesh_.degree), n_components * nodes, 2 * pairs + nodes + of_third};
  }

  const GeometryOptions geometry_;
  const ImportedMesh imported_;
  const MeshOptions mesh_;
};

Codec<std::string> group_codec()
{
  return {"a name without '#', '\\', ',', ';' and ':', a number, or nothing",
          [](const std::string &text, std::string &)
          { return is_group_name(text) ? std::optional<std::string>(text) : std::nullopt; },
          [](const std::string &name) { return name; }};
}

class FileKind : public ShapeKind
{
public:
  BodyShape shape() const override { return BodyShape::file; }

  void declare(GeometryOptions &geometry, const Condition &is_chosen, Section &section) const override
  {
    section
        .add("Mesh file", geometry.mesh_file, path_codec(),
             "Mesh by Gmsh for Shape = file (format 2.1, 2.2 or 4.1, ASCII, lengths in mm); its path is "
             "relative to the folder of the parameter file. The mesh consists of hexahedra, or in plane "
             "strain of quadrangles in the plane y = 0, whose surfaces are physical lines; those of second "
             "order have curved edges. It covers the modelled part of the body. On a counterface by Gap its "
             "contact surface lies at z >= 0, because "
             "the height of a contact node is added to Gap.")
        .path(geometry.mesh_file)
        .only_if(is_chosen);
    section
        .add("Held surface", geometry.held_surface, group_codec(),
             "Held face of a Mesh file, which moves as a rigid one whatever its shape: the name or number of "
             "a physical group, or a place such as z max. A lower body with Supports may have none.")
        .only_if(is_chosen);
    section
        .add("Symmetry surfaces", geometry.symmetry_surfaces, group_names_codec(),
             "Surfaces of a Mesh file in the planes x = 0 and y = 0 about which the body is symmetric, by "
             "their names, numbers or places.")
        .only_if(is_chosen);
    declare_curved_surfaces(geometry, is_chosen, section);
  }

  bool has_layers() const override { return false; }

  std::optional<Thickness> thickness(const GeometryOptions &geometry) const override
  {
    return Thickness{geometry.thickness, geometry.section + "/Thickness"};
  }

  void check(const BodyOptions &body) const override { check_mesh_file(body.geometry); }

  std::string chooser_of_mesh() const override
  {
    return "the file contains the mesh, which Mesh/Refinements and Adaptive refine";
  }

  bool has_known_sizes() const override { return false; }

  std::string finer_cells(const BodyOptions &body) const override
  {
    return "more " + body.mesh.section + "/Refinements, or a " + body.geometry.section +
           "/Mesh file with smaller cells there";
  }

  std::string describe(const GeometryOptions &geometry) const override
  {
    return shown_path(geometry.mesh_file);
  }

  std::unique_ptr<Shape> make(const GeometryOptions &geometry, const MeshOptions &mesh) const override
  {
    return std::make_unique<FileShape>(geometry, mesh);
  }
};
} // namespace

const ShapeKind &file_kind()
{
  static const FileKind kind;
  return kind;
}
} // namespace orthocone
