// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "coarse_curves.h"

#include "curved_manifold.h"

#include <orthocone/body/shapes/curved_cells.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace orthocone
{
using dealii::Point;

namespace
{
template<std::size_t n>
std::array<unsigned int, n> sorted_key(const std::vector<unsigned int> &vertices)
{
  std::array<unsigned int, n> key{};
  std::copy(vertices.begin(), vertices.end(), key.begin());
  std::sort(key.begin(), key.end());
  return key;
}

/// The middle of a line, a quadrilateral or a hexahedron, by its vertices.
template<int dim>
Point<dim> middle_of(const CoarseCurves<dim> &curves, const std::vector<unsigned int> &vertices)
{
  switch (vertices.size())
  {
  case 2:
    return curves.of_lines.at(sorted_key<2>(vertices));
  case 4:
    return curves.of_quads.at(sorted_key<4>(vertices));
  default:
    return curves.of_hexes.at(sorted_key<8>(vertices));
  }
}

/// Numbers in the mesh of the corners between which a node of a cell of second order is the middle.
template<int dim, typename Cell>
std::vector<unsigned int> vertices_around(const Cell &cell, const unsigned int node)
{
  const auto places = QuadraticCell<dim>::places(node);
  std::vector<unsigned int> vertices;
  for (unsigned int v = 0; v < (1U << dim); ++v)
  {
    bool is_near = true;
    for (unsigned int d = 0; d < dim; ++d)
      is_near = is_near && (places[d] == 1 || places[d] / 2 == ((v >> d) & 1U));
    if (is_near)
      vertices.push_back(cell->vertex_index(v));
  }
  return vertices;
}

/// The sides of the cell on which a node lies; those of directions in which it is in the middle are 0.
template<int dim>
std::array<unsigned int, dim> sides_of(const unsigned int node)
{
  std::array<unsigned int, dim> sides = QuadraticCell<dim>::places(node);
  for (unsigned int &side : sides)
    side /= 2;
  return sides;
}

template<int dim>
unsigned int first_direction(const unsigned int node, const bool of_middle)
{
  const auto places = QuadraticCell<dim>::places(node);
  return static_cast<unsigned int>(std::find_if(places.begin(), places.end(),
                                                [&](const unsigned int place)
                                                { return (place == 1) == of_middle; }) -
                                   places.begin());
}
} // namespace

void complete(CoarseCurves<3> &curves, const dealii::Triangulation<3> &mesh)
{
  for (const auto &quad : mesh.active_face_iterators())
    for (const unsigned int i : quad->line_indices())
      curves.of_lines.emplace(key_of<2>(quad->line(i)),
                              (quad->line(i)->vertex(0) + quad->line(i)->vertex(1)) / 2);
  for (const auto &[key, forms] : curves.forms_of_lines)
    curves.of_lines.at(key) = projected(forms, curves.of_lines.at(key));
  for (const auto &quad : mesh.active_face_iterators())
  {
    Point<3> middle;
    for (unsigned int i = 0; i < 4; ++i)
      middle += curves.of_lines.at(key_of<2>(quad->line(i))) / 2 - quad->vertex(i) / 4;
    curves.of_quads.emplace(key_of<4>(quad), middle);
  }
  for (const auto &[key, form] : curves.forms_of_quads)
    curves.of_quads.at(key) = form.project(curves.of_quads.at(key));
  for (const auto &cell : mesh.active_cell_iterators())
  {
    Point<3> middle;
    for (const unsigned int face : cell->face_indices())
      middle += curves.of_quads.at(key_of<4>(cell->face(face))) / 2;
    for (const unsigned int line : cell->line_indices())
      middle -= curves.of_lines.at(key_of<2>(cell->line(line))) / 4;
    for (const unsigned int v : cell->vertex_indices())
      middle += cell->vertex(v) / 8;
    curves.of_hexes.emplace(key_of<8>(cell), middle);
  }
}

template<int dim>
CurvedCell<dim> curved_cell(const CoarseCurves<dim> &curves,
                            const typename dealii::Triangulation<dim>::cell_iterator &cell)
{
  typename QuadraticCell<dim>::Nodes nodes;
  std::vector<typename CurvedCell<dim>::Edge> edges;
  std::vector<typename CurvedCell<dim>::Face> faces;
  const auto &points = cell->get_triangulation().get_vertices();
  for (unsigned int node = 0; node < nodes.size(); ++node)
  {
    const std::vector<unsigned int> around = vertices_around<dim>(cell, node);
    nodes[node] = around.size() == 1 ? points[around[0]] : middle_of(curves, around);
    if (around.size() == 2)
    {
      const auto found = curves.forms_of_lines.find(sorted_key<2>(around));
      if (found != curves.forms_of_lines.end())
        edges.push_back({first_direction<dim>(node, true), sides_of<dim>(node), found->second});
    }
    else if (dim == 3 && around.size() == 4)
    {
      const auto found = curves.forms_of_quads.find(sorted_key<4>(around));
      const unsigned int direction = first_direction<dim>(node, false);
      if (found != curves.forms_of_quads.end())
        faces.push_back({direction, sides_of<dim>(node)[direction], found->second});
    }
  }
  return CurvedCell<dim>(nodes, std::move(edges), std::move(faces));
}

template<int dim>
void attach(const CoarseCurves<dim> &curves, dealii::Triangulation<dim> &mesh)
{
  std::vector<CurvedCell<dim>> cells;
  for (const auto &cell : mesh.active_cell_iterators())
    cells.push_back(curved_cell<dim>(curves, cell));
  mesh.set_all_manifold_ids(curved_cells_manifold);
  mesh.set_manifold(curved_cells_manifold, CurvedManifold<dim>(std::move(cells)));
}

CoarseCurves<2> flattened(const CoarseCurves<3> &layer, const std::map<unsigned int, unsigned int> &numbers)
{
  CoarseCurves<2> section;
  const auto in_section = [&](auto key)
  {
    for (unsigned int &vertex : key)
    {
      const auto found = numbers.find(vertex);
      if (found == numbers.end())
        return std::optional<decltype(key)>();
      vertex = found->second;
    }
    std::sort(key.begin(), key.end());
    return std::make_optional(key);
  };
  for (const auto &[key, place] : layer.of_lines)
    if (const auto flat = in_section(key))
      section.of_lines[*flat] = {place[0], place[2]};
  for (const auto &[key, place] : layer.of_quads)
    if (const auto flat = in_section(key))
      section.of_quads[*flat] = {place[0], place[2]};
  for (const auto &[key, forms] : layer.forms_of_lines)
    if (const auto flat = in_section(key))
      section.forms_of_lines[*flat] = forms;
  return section;
}

template CurvedCell<2> curved_cell(const CoarseCurves<2> &, const CoarseCell2 &);
template CurvedCell<3> curved_cell(const CoarseCurves<3> &, const CoarseCell3 &);
template void attach(const CoarseCurves<2> &, dealii::Triangulation<2> &);
template void attach(const CoarseCurves<3> &, dealii::Triangulation<3> &);
} // namespace orthocone
