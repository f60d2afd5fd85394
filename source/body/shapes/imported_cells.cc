// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "imported_cells.h"

#include <orthocone/base/errors.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <array>

namespace orthocone
{
namespace
{
/// Finds the faces of each physical surface. A face may be in several.
FacesOfGroups faces_of_groups(const GmshFile &file, const std::vector<unsigned int> &vertex_of_node,
                              const dealii::Triangulation<3> &triangulation)
{
  using Face = FacesOfGroups::mapped_type::value_type;
  using Corners = std::array<unsigned int, 4>;
  FacesOfGroups faces_of_group;
  std::map<Corners, Face> outside;
  for (const Face &face : triangulation.active_face_iterators())
    if (face->at_boundary() && !file.quadrilaterals.empty())
    {
      Corners corners{
          {face->vertex_index(0), face->vertex_index(1), face->vertex_index(2), face->vertex_index(3)}};
      std::sort(corners.begin(), corners.end());
      outside.emplace(corners, face);
    }
  for (const auto &given : file.quadrilaterals)
  {
    Corners corners{};
    std::transform(given.nodes.begin(), given.nodes.end(), corners.begin(),
                   [&](const unsigned int node) { return vertex_of_node[node]; });
    std::sort(corners.begin(), corners.end());
    const auto found = outside.find(corners);
    if (found == outside.end())
      continue;
    faces_of_group[given.group].push_back(found->second);
    if (found->second->boundary_id() == 0)
      found->second->set_boundary_id(given.group);
  }
  for (auto &[number, faces] : faces_of_group)
  {
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  }
  return faces_of_group;
}

/// Corners of edges and faces of Gmsh's hexahedron, in the order of the nodes in their middles.
constexpr std::array<std::array<unsigned int, 2>, 12> ends_of_edges{{{{0, 1}},
                                                                     {{0, 3}},
                                                                     {{0, 4}},
                                                                     {{1, 2}},
                                                                     {{1, 5}},
                                                                     {{2, 3}},
                                                                     {{2, 6}},
                                                                     {{3, 7}},
                                                                     {{4, 5}},
                                                                     {{4, 7}},
                                                                     {{5, 6}},
                                                                     {{6, 7}}}};
constexpr std::array<std::array<unsigned int, 4>, 6> corners_of_faces{
    {{{0, 3, 2, 1}}, {{0, 1, 5, 4}}, {{0, 4, 7, 3}}, {{1, 2, 6, 5}}, {{2, 3, 7, 6}}, {{4, 5, 6, 7}}}};

/// Enters the middles of the cells. Returns whether cells agree about those that they share.
class MiddleReader
{
public:
  MiddleReader(const GmshFile &file, const std::vector<unsigned int> &vertex_of_node, CoarseCurves<3> &curves)
      : file_(file),
        vertex_of_node_(vertex_of_node),
        curves_(curves)
  {
  }

  bool read(const GmshFile::Element<8> &cell)
  {
    bool is_consistent = true;
    const auto n = cell.middles.size();
    constexpr auto n_edges = ends_of_edges.size(), n_faces = corners_of_faces.size();
    for (std::size_t i = 0; i < n_edges && i < n; ++i)
      is_consistent &= enter(curves_.of_lines, key_of(cell, ends_of_edges[i]), cell.middles[i]);
    for (std::size_t i = 0; i < n_faces && n_edges + i < n; ++i)
      is_consistent &= enter(curves_.of_quads, key_of(cell, corners_of_faces[i]), cell.middles[n_edges + i]);
    if (n > n_edges + n_faces)
      is_consistent &=
          enter(curves_.of_hexes, key_of(cell, std::array<unsigned int, 8>{{0, 1, 2, 3, 4, 5, 6, 7}}),
                cell.middles.back());
    return is_consistent;
  }

private:
  template<std::size_t n>
  std::array<unsigned int, n> key_of(const GmshFile::Element<8> &cell,
                                     const std::array<unsigned int, n> &corners) const
  {
    std::array<unsigned int, n> key{};
    for (std::size_t i = 0; i < n; ++i)
      key[i] = vertex_of_node_[cell.nodes[corners[i]]];
    std::sort(key.begin(), key.end());
    return key;
  }

  template<typename Key>
  bool enter(std::map<Key, dealii::Point<3>> &middles, const Key &key, const unsigned int node) const
  {
    const auto &given = file_.nodes[node];
    const dealii::Point<3> place(given[0], given[1], given[2]);
    return middles.emplace(key, place).first->second == place;
  }

  const GmshFile &file_;
  const std::vector<unsigned int> &vertex_of_node_;
  CoarseCurves<3> &curves_;
};

[[noreturn]] void fail_to_fit(const GmshFile &file, dealii::Triangulation<3> &triangulation)
{
  triangulation.clear();
  throw InputError(file.path +
                   ": its elements do not fit together: allowed are hexahedra that share whole "
                   "faces, each with one other" +
                   (file.is_second_order ? ", and all nodes of these" : ""));
}
} // namespace

/// Makes the cells as deal.II's reader of such files does. Quadrilaterals that are no faces on the outside
/// are left out: files without physical surfaces have them between parts of the body.
FacesOfGroups make_imported_cells(const GmshFile &file, dealii::Triangulation<3> &triangulation,
                                  CoarseCurves<3> &curves)
{
  constexpr std::array<unsigned int, 8> place_of{{0, 1, 5, 4, 2, 3, 7, 6}}; // of Gmsh's nodes in a cell
  constexpr unsigned int unused = dealii::numbers::invalid_unsigned_int;
  std::vector<unsigned int> vertex_of_node(file.nodes.size(), unused);
  for (const auto &cell : file.hexahedra)
    for (const unsigned int node : cell.nodes)
      vertex_of_node[node] = 0;
  std::vector<dealii::Point<3>> vertices;
  for (std::size_t i = 0; i < file.nodes.size(); ++i)
    if (const auto &node = file.nodes[i]; vertex_of_node[i] != unused)
    {
      vertex_of_node[i] = static_cast<unsigned int>(vertices.size());
      vertices.emplace_back(node[0], node[1], node[2]);
    }
  std::vector<dealii::CellData<3>> cells;
  for (const auto &given : file.hexahedra)
  {
    dealii::CellData<3> &cell = cells.emplace_back();
    for (unsigned int i = 0; i < place_of.size(); ++i)
      cell.vertices[place_of[i]] = vertex_of_node[given.nodes[i]];
    cell.material_id = given.group;
  }
  try
  {
    dealii::GridTools::invert_cells_with_negative_measure(vertices, cells);
    dealii::GridTools::consistently_order_cells(cells);
    triangulation.create_triangulation(vertices, cells, dealii::SubCellData());
  }
  catch (const std::exception &)
  {
    fail_to_fit(file, triangulation);
  }
  MiddleReader middles(file, vertex_of_node, curves);
  for (const auto &given : file.hexahedra)
    if (!middles.read(given))
      fail_to_fit(file, triangulation);
  return faces_of_groups(file, vertex_of_node, triangulation);
}
} // namespace orthocone
