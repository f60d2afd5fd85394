// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "size_formula.h"

namespace orthocone
{
namespace
{
/// Numbers of nodes of a grid, and of pairs of nodes that share a cell: in both orders, and each node with
/// itself.
struct Grid
{
  double nodes;
  double pairs;
};

Grid row(const double cells, const double degree)
{
  const double side = degree + 1;
  return {cells * degree + 1, cells * side * side - (cells - 1)};
}

/// Cells count the pairs within their common edges twice. Subtracting the edges takes off the pairs at inner
/// vertices once too often, so that these are added. Numbers of edges and vertices follow from Euler's
/// formula.
Grid disc(const BaseSize &base, const double degree)
{
  const double side = degree + 1;
  const double edges = (4 * base.faces + base.boundary_edges) / 2;
  const double vertices = 1 + edges - base.faces;
  const double inner_edges = edges - base.boundary_edges;
  const double inner_vertices = vertices - base.boundary_edges;
  return {vertices + edges * (degree - 1) + base.faces * (degree - 1) * (degree - 1),
          base.faces * side * side * side * side - inner_edges * side * side + inner_vertices};
}

/// `sideways` is the number of directions of displacement along the base, `share_free` the share of their
/// unknowns that no symmetry holds.
ModelSize size_of(const double cells, const Grid &base, const Grid &height, const double sideways,
                  const double share_free, const double degree, const TopFace top_face)
{
  const double directions = sideways + 1;
  // Pairs without the held node on one side, and on both sides.
  const double one_free = height.pairs - (degree + 1);
  const double both_free = one_free - degree;
  const bool is_clamped = top_face == TopFace::clamped;
  const double moving = sideways * share_free;
  const double all = (moving + 1) * (moving + 1);
  const double pairs = is_clamped ? all * both_free
                       : top_face == TopFace::free
                           ? all * height.pairs
                           : moving * moving * height.pairs + 2 * moving * one_free + both_free;
  const double at_top = is_clamped ? 0 : top_face == TopFace::free ? moving + 1 : moving;
  const double free = (moving + 1) * (height.nodes - 1) + at_top;
  return {cells, base.nodes, directions * base.nodes * height.nodes,
          (base.pairs * pairs + base.nodes * free) / 2};
}
} // namespace

ModelSize solid_size(const BaseSize &base, const unsigned int layers, const unsigned int degree,
                     const TopFace top_face)
{
  const Grid grid = disc(base, degree);
  double n_held = 0; // a plane holds one direction of its nodes
  for (const double edges : base.plane_edges)
    n_held += edges == 0 ? 0 : edges * degree + 1;
  return size_of(base.faces * layers, grid, row(layers, degree), 2, 1 - n_held / (2 * grid.nodes), degree,
                 top_face);
}

ModelSize section_size(const double base_cells, const unsigned int layers, const unsigned int degree,
                       const TopFace top_face, const ModelSymmetry &symmetry)
{
  const Grid grid = row(base_cells, degree), height = row(layers, degree);
  const bool has_axis = symmetry.is_axisymmetric();
  const double share_free = has_axis || symmetry.planes().normal_to_x ? 1 - 1 / grid.nodes : 1;
  ModelSize size = size_of(base_cells * layers, grid, height, 1, share_free, degree, top_face);
  if (symmetry.has_third()) // a block of its own, held like u_z at the top and like u_r on the axis
  {
    const ModelSize of_third = size_of(base_cells * layers, grid, height, 0, 0, degree, top_face);
    const double held = has_axis ? 1 - 1 / grid.nodes : 1;
    size.dofs += of_third.dofs;
    size.stiffness_entries += held * held * of_third.stiffness_entries;
    const double contact = row(base_cells, degree).pairs;
    size.stiffness_entries += 2 * contact; // the zeros between the blocks
  }
  return size;
}
} // namespace orthocone
