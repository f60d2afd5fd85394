// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Meshes as Gmsh writes them, for tests.
#pragma once

#include <orthocone/body/options.h>

#include <deal.II/grid/tria.h>
#include <deal.II/grid/tria_accessor.h>

#include <array>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

namespace orthocone::test
{
/// A mesh in the words of a file: what a test changes before it is written.
struct Msh
{
  struct Element
  {
    unsigned int type; ///< 3: a quadrilateral, 5: a hexahedron
    unsigned int group;
    std::vector<unsigned int> nodes; ///< counted from 1, in Gmsh's order
  };

  Msh() = default;

  /// The active cells of a mesh, its boundary ids as physical surfaces "base", "top", "side", "x0", "y0" of
  /// numbers 1 to 5, its material ids plus 1 as physical volumes "body" and "other".
  explicit Msh(const dealii::Triangulation<3> &mesh)
  {
    const std::array<unsigned int, 8> order{{0, 1, 3, 2, 4, 5, 7, 6}};
    for (const auto &vertex : mesh.get_vertices())
      nodes.push_back({{vertex[0], vertex[1], vertex[2]}});
    for (const auto &cell : mesh.active_cell_iterators())
    {
      elements.push_back({5, cell->material_id() + 1, {}});
      for (const unsigned int v : order)
        elements.back().nodes.push_back(cell->vertex_index(v) + 1);
    }
    for (const auto &face : mesh.active_face_iterators())
      if (face->at_boundary())
      {
        elements.push_back({3, face->boundary_id(), {}});
        for (unsigned int i = 0; i < 4; ++i)
          elements.back().nodes.push_back(face->vertex_index(order[i]) + 1);
      }
  }

  std::string names() const
  {
    return "$PhysicalNames\n7\n2 1 \"base\"\n2 2 \"top\"\n2 3 \"side\"\n2 4 \"x0\"\n2 5 \"y0\"\n"
           "3 1 \"body\"\n3 2 \"other\"\n$EndPhysicalNames\n";
  }

  /// Format 2.2, with 17 digits.
  std::string text() const
  {
    std::ostringstream out;
    out << std::setprecision(17) << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" << names();
    out << "$Nodes\n" << nodes.size() << "\n";
    for (std::size_t i = 0; i < nodes.size(); ++i)
      out << i + 1 << " " << nodes[i][0] << " " << nodes[i][1] << " " << nodes[i][2] << "\n";
    out << "$EndNodes\n$Elements\n" << elements.size() << "\n";
    for (std::size_t i = 0; i < elements.size(); ++i)
    {
      out << i + 1 << " " << elements[i].type << " 2 " << elements[i].group << " 1";
      for (const unsigned int node : elements[i].nodes)
        out << " " << node;
      out << "\n";
    }
    out << "$EndElements\n";
    return out.str();
  }

  std::vector<std::array<double, 3>> nodes;
  std::vector<Element> elements;
};

/// A body of that file; with planes of symmetry where it has such surfaces.
inline GeometryOptions imported(const std::string &file, const std::vector<std::string> &symmetry = {})
{
  GeometryOptions geometry;
  geometry.shape = BodyShape::file;
  geometry.mesh_file = file;
  geometry.contact_surfaces = {"base"};
  geometry.held_surface = "top";
  geometry.symmetry_surfaces = symmetry;
  return geometry;
}
} // namespace orthocone::test
