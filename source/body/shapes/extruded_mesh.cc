// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "extruded_mesh.h"

#include <orthocone/base/text.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace orthocone
{
namespace
{
/// Finds nodes beside the plane y = 0, and moves all others into it.
void check_plane(GmshFile &file)
{
  constexpr double rounding = 1e-9;
  double extent = 0;
  for (const auto &node : file.nodes)
    extent = std::max({extent, std::abs(node[0]), std::abs(node[2])});
  for (auto &node : file.nodes)
  {
    if (std::abs(node[1]) > rounding * extent)
    {
      file.faults.add("has a node at y = " + to_text(node[1]) +
                      " mm: allowed with Geometry/Kind = plane strain are quadrangles in the plane (x, z), "
                      "y = 0");
      return;
    }
    node[1] = 0;
  }
}

using Edge = std::pair<unsigned int, unsigned int>;

Edge edge_of(const unsigned int a, const unsigned int b)
{
  return {std::min(a, b), std::max(a, b)};
}

bool lies_in_section(const dealii::Triangulation<3>::face_iterator &face)
{
  for (const unsigned int v : face->vertex_indices())
    if (face->vertex(v)[1] != 0)
      return false;
  return true;
}

/// The edge in y = 0 of a face across the layer, by numbers of vertices of the layer.
Edge edge_in_section(const dealii::Triangulation<3>::face_iterator &face)
{
  std::vector<unsigned int> ends;
  for (const unsigned int v : face->vertex_indices())
    if (face->vertex(v)[1] == 0)
      ends.push_back(face->vertex_index(v));
  if (ends.size() != 2)
    throw std::logic_error("a layer of cells has a face that does not cross it");
  return edge_of(ends[0], ends[1]);
}

/// Numbers the vertices of the layer in y = 0 in the order in which cells name them.
class SectionVertices
{
public:
  unsigned int number_of(const unsigned int vertex, const dealii::Point<3> &place)
  {
    const auto [found, is_new] = numbers_.emplace(vertex, static_cast<unsigned int>(points.size()));
    if (is_new)
      points.emplace_back(place[0], place[2]);
    return found->second;
  }
  unsigned int number_of(const unsigned int vertex) const { return numbers_.at(vertex); }

  const std::map<unsigned int, unsigned int> &numbers() const { return numbers_; }

  std::vector<dealii::Point<2>> points;

private:
  std::map<unsigned int, unsigned int> numbers_;
};
} // namespace

/// The nodes in the middle of the hexahedron over a quadrangle, in Gmsh's order; those above a node are
/// `above` it, and those half way are `half_way`.
static std::vector<unsigned int> extruded_middles(const GmshFile::Element<4> &quadrangle,
                                                  const unsigned int above, const unsigned int half_way)
{
  const auto &corners = quadrangle.nodes;
  const auto &middles = quadrangle.middles; // of its edges from corner to corner, and perhaps its own
  if (middles.empty())
    return {};
  std::vector<unsigned int> all{middles[0],
                                middles[3],
                                corners[0] + half_way,
                                middles[1],
                                corners[1] + half_way,
                                middles[2],
                                corners[2] + half_way,
                                corners[3] + half_way,
                                middles[0] + above,
                                middles[3] + above,
                                middles[1] + above,
                                middles[2] + above};
  if (middles.size() > 4)
    for (const unsigned int node :
         {middles[4], middles[0] + half_way, middles[3] + half_way, middles[1] + half_way,
          middles[2] + half_way, middles[4] + above, middles[4] + half_way})
      all.push_back(node);
  return all;
}

void extrude(GmshFile &file)
{
  check_plane(file);
  const auto n = static_cast<unsigned int>(file.nodes.size());
  for (unsigned int layer = 1; layer <= (file.is_second_order ? 2 : 1); ++layer)
    for (unsigned int i = 0; i < n; ++i)
      file.nodes.push_back({{file.nodes[i][0], *file.thickness / layer, file.nodes[i][2]}});
  for (const auto &quadrangle : file.quadrilaterals)
  {
    const auto &nodes = quadrangle.nodes;
    file.hexahedra.push_back(
        {{{nodes[0], nodes[1], nodes[2], nodes[3], nodes[0] + n, nodes[1] + n, nodes[2] + n, nodes[3] + n}},
         quadrangle.group,
         extruded_middles(quadrangle, n, 2 * n)});
  }
  file.quadrilaterals.clear();
  for (const auto &line : file.lines)
    file.quadrilaterals.push_back(
        {{{line.nodes[0], line.nodes[1], line.nodes[1] + n, line.nodes[0] + n}}, line.group});
  file.lines.clear();
  for (PhysicalGroup &group : file.groups)
    ++group.dimension;
}

std::map<unsigned int, unsigned int> flatten(const dealii::Triangulation<3> &layer,
                                             dealii::Triangulation<2> &section)
{
  SectionVertices vertices;
  std::vector<dealii::CellData<2>> cells;
  for (const auto &cell : layer.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (lies_in_section(face))
      {
        dealii::CellData<2> &flat = cells.emplace_back();
        for (const unsigned int v : face->vertex_indices())
          flat.vertices[v] = vertices.number_of(face->vertex_index(v), face->vertex(v));
        flat.material_id = cell->material_id();
      }
  if (cells.size() != layer.n_active_cells())
    throw std::logic_error("a layer of cells has not one face of each in y = 0");
  std::map<Edge, dealii::types::boundary_id> ids;
  for (const auto &face : layer.active_face_iterators())
    if (face->at_boundary() && std::abs(face->center()[1]) > 0 && face->vertex(0)[1] != face->vertex(3)[1])
    {
      const Edge edge = edge_in_section(face);
      ids[edge_of(vertices.number_of(edge.first), vertices.number_of(edge.second))] = face->boundary_id();
    }
  dealii::GridTools::invert_cells_with_negative_measure(vertices.points, cells);
  dealii::GridTools::consistently_order_cells(cells);
  section.create_triangulation(vertices.points, cells, dealii::SubCellData());
  for (const auto &face : section.active_face_iterators())
    if (face->at_boundary())
      face->set_boundary_id(ids.at(edge_of(face->vertex_index(0), face->vertex_index(1))));
  return vertices.numbers();
}
} // namespace orthocone
