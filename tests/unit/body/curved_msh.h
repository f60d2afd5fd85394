// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Meshes of first and second order whose nodes are where a map of the unit cube puts them.
#pragma once

#include "body/msh.h"

#include <orthocone/body/shapes/imported_mesh.h>

#include <functional>

namespace orthocone::test
{
/// Gmsh's hexahedra by the number of their nodes.
enum class Hexahedra : unsigned int
{
  of_8_nodes = 5,
  of_20_nodes = 17,
  of_27_nodes = 12,
};

using Place = std::array<double, 3>;

/// Numbers the nodes of a mesh of n[d] cells in each direction, with those in the middles of cells.
class NodeGrid
{
public:
  NodeGrid(const std::array<unsigned int, 3> &n, const std::function<Place(const Place &)> &map)
      : n_(n)
  {
    for (unsigned int k = 0; k <= 2 * n[2]; ++k)
      for (unsigned int j = 0; j <= 2 * n[1]; ++j)
        for (unsigned int i = 0; i <= 2 * n[0]; ++i)
          nodes.push_back(map({{i / (2. * n[0]), j / (2. * n[1]), k / (2. * n[2])}}));
  }

  /// Counted from 1.
  unsigned int number(const std::array<unsigned int, 3> &at) const
  {
    return 1 + at[0] + (2 * n_[0] + 1) * (at[1] + (2 * n_[1] + 1) * at[2]);
  }

  std::vector<Place> nodes;

private:
  std::array<unsigned int, 3> n_;
};

/// Adds the face across direction d of the cell at a node, in half cells, with its nodes in Gmsh's order.
inline void add_face(const NodeGrid &grid, const unsigned int n_nodes, std::array<unsigned int, 3> at,
                     const unsigned int d, const unsigned int side, Msh &mesh)
{
  constexpr std::array<std::array<unsigned int, 2>, 9> in_face{
      {{{0, 0}}, {{2, 0}}, {{2, 2}}, {{0, 2}}, {{1, 0}}, {{2, 1}}, {{1, 2}}, {{0, 1}}, {{1, 1}}}};
  constexpr std::array<std::array<unsigned int, 2>, 3> groups{{{{4, 3}}, {{5, 3}}, {{1, 2}}}};
  mesh.elements.push_back({n_nodes == 4 ? 3U : n_nodes == 8 ? 16U : 10U, groups[d][side], {}});
  at[d] += 2 * side;
  for (unsigned int i = 0; i < n_nodes; ++i)
  {
    std::array<unsigned int, 3> node = at;
    node[(d + 1) % 3] += in_face[i][0];
    node[(d + 2) % 3] += in_face[i][1];
    mesh.elements.back().nodes.push_back(grid.number(node));
  }
}

/// The faces of the cube u, v = 0 are the surfaces "x0" and "y0", u, v = 1 "side", w = 0 "base" and w = 1
/// "top".
inline Msh mapped_cube(const std::array<unsigned int, 3> &n, const Hexahedra type,
                       const std::function<Place(const Place &)> &map)
{
  // In half cells from the first corner: corners, edges, faces, and the middle, as Gmsh orders them.
  constexpr std::array<std::array<unsigned int, 3>, 27> order{
      {{{0, 0, 0}}, {{2, 0, 0}}, {{2, 2, 0}}, {{0, 2, 0}}, {{0, 0, 2}}, {{2, 0, 2}}, {{2, 2, 2}},
       {{0, 2, 2}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}, {{2, 1, 0}}, {{2, 0, 1}}, {{1, 2, 0}},
       {{2, 2, 1}}, {{0, 2, 1}}, {{1, 0, 2}}, {{0, 1, 2}}, {{2, 1, 2}}, {{1, 2, 2}}, {{1, 1, 0}},
       {{1, 0, 1}}, {{0, 1, 1}}, {{2, 1, 1}}, {{1, 2, 1}}, {{1, 1, 2}}, {{1, 1, 1}}}};
  const unsigned int n_nodes = type == Hexahedra::of_8_nodes ? 8 : type == Hexahedra::of_20_nodes ? 20 : 27;
  const unsigned int of_face = n_nodes == 8 ? 4 : n_nodes == 20 ? 8 : 9;
  const NodeGrid grid(n, map);
  Msh mesh;
  mesh.nodes = grid.nodes;
  for (unsigned int cell = 0; cell < n[0] * n[1] * n[2]; ++cell)
  {
    const std::array<unsigned int, 3> at{
        {2 * (cell % n[0]), 2 * (cell / n[0] % n[1]), 2 * (cell / n[0] / n[1])}};
    mesh.elements.push_back({static_cast<unsigned int>(type), 1, {}});
    for (unsigned int node = 0; node < n_nodes; ++node)
      mesh.elements.back().nodes.push_back(
          grid.number({{at[0] + order[node][0], at[1] + order[node][1], at[2] + order[node][2]}}));
    for (unsigned int d = 0; d < 3; ++d)
      for (unsigned int side = 0; side < 2; ++side)
        if (at[d] == (side == 0 ? 0 : 2 * n[d] - 2))
          add_face(grid, of_face, at, d, side, mesh);
  }
  return mesh;
}

/// A mesh of the plane, v = 0, as one in the plane (x, z) with nodes of 4, 8 or 9: edges at w = 0 and 1 are
/// the lines "base" and "top", and those at u = 0 and 1 "x0" and "side".
inline std::string mapped_square(const std::array<unsigned int, 2> &n, const Hexahedra type,
                                 const std::function<std::array<double, 2>(double, double)> &map)
{
  Msh cube = mapped_cube({{n[0], 1, n[1]}}, type,
                         [&](const Place &unit)
                         {
                           const auto [x, z] = map(unit[0], unit[2]);
                           return Place{{x, unit[1] > 0 ? 1. : 0., z}};
                         });
  std::vector<Msh::Element> flat;
  const auto is_flat = [&](const unsigned int node) { return cube.nodes[node - 1][1] == 0; };
  for (const Msh::Element &element : cube.elements)
  {
    Msh::Element kept{0, element.group, {}};
    const bool is_cell = element.type != 3 && element.type != 10 && element.type != 16;
    if (is_cell)
      continue;
    for (const unsigned int node : element.nodes)
      if (is_flat(node))
        kept.nodes.push_back(node);
    if (element.group == 5) // the cells of the plane
      kept.type = element.type;
    else if (kept.nodes.size() == 2 || kept.nodes.size() == 3)
      kept.type = kept.nodes.size() == 2 ? 1 : 8;
    if (kept.type != 0 && (kept.type == 1 || kept.type == 8 || kept.nodes.size() == element.nodes.size()))
      flat.push_back(kept);
  }
  cube.elements = flat;
  for (Place &node : cube.nodes)
    node[1] = 0;
  std::string text = cube.text();
  const std::string names = cube.names();
  return text.replace(text.find(names), names.size(),
                      "$PhysicalNames\n5\n1 1 \"base\"\n1 2 \"top\"\n1 3 \"side\"\n1 4 \"x0\"\n2 5 "
                      "\"body\"\n$EndPhysicalNames\n");
}
/// The mesh of a file, halved.
inline void read_halved(const GeometryOptions &geometry, const unsigned int n_halvings,
                        dealii::Triangulation<3> &mesh)
{
  ImportedMesh(geometry).copy_to(mesh);
  mesh.refine_global(n_halvings);
}
} // namespace orthocone::test
