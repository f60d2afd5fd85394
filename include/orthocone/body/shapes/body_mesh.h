// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/base/ranks.h>
#include <orthocone/body/shapes/refinement.h>
#include <orthocone/body/shapes/shape.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <numeric>
#include <vector>

namespace orthocone
{
/// For each active cell its place among the active cells.
template<int dim>
std::vector<unsigned int> numbers_in_order(const dealii::Triangulation<dim> &triangulation)
{
  std::vector<unsigned int> numbers(triangulation.n_active_cells());
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

/// Hexahedra (mm) of the modelled part of the body whose shape the options name. The mesh of a half or a
/// quarter consists of exactly those cells of the full mesh that lie there. Where cells of different sizes
/// meet, their edges differ by a factor of two at most, also across an edge or a corner. Several processes
/// share the cells.
class BodyMesh
{
public:
  BodyMesh(const GeometryOptions &geometry, const MeshOptions &options, const SymmetryPlanes &planes);

  const dealii::Triangulation<3> &triangulation() const { return *triangulation_; }

  /// For each active cell its number in Mesh/Refined cells; cells of other processes have none. Where several
  /// processes share the cells, each of them makes the whole mesh for this.
  std::vector<unsigned int> cell_numbers() const;

private:
  std::unique_ptr<dealii::Triangulation<3>> unrefined() const;

  GeometryOptions geometry_;
  MeshOptions options_;
  SymmetryPlanes planes_;
  std::unique_ptr<dealii::Triangulation<3>> triangulation_;
};

/// Quadrilaterals (mm) of the section of a body, (r, z) or (x, z). The constructor throws what make_shape(),
/// make_section() and refine() throw.
class SectionMesh
{
public:
  SectionMesh(const GeometryOptions &geometry, const MeshOptions &options,
              const ModelSymmetry &symmetry = ModelSymmetry::of_revolution())
      : triangulation_(dealii::Triangulation<2>::limit_level_difference_at_vertices)
  {
    make_shape(geometry, options)->make_section(symmetry, triangulation_);
    refine(triangulation_, options);
  }

  const dealii::Triangulation<2> &triangulation() const { return triangulation_; }

  /// As BodyMesh::cell_numbers(); one process has all cells.
  std::vector<unsigned int> cell_numbers() const { return numbers_in_order(triangulation_); }

private:
  dealii::Triangulation<2> triangulation_;
};

/// The longest edge of a cell divided by its shortest one: the largest ratio of all cells, over all
/// processes.
template<int dim>
double stretch(const dealii::Triangulation<dim> &triangulation)
{
  double largest = 1;
  for (const auto &cell : triangulation.active_cell_iterators())
  {
    if (!cell->is_locally_owned())
      continue;
    double longest = 0, shortest = std::numeric_limits<double>::max();
    for (const unsigned int line : cell->line_indices())
    {
      longest = std::max(longest, cell->line(line)->diameter());
      shortest = std::min(shortest, cell->line(line)->diameter());
    }
    largest = std::max(largest, longest / shortest);
  }
  return largest_of_ranks(largest);
}

/// Throws InputError if Mesh/Refined cells names a cell that the mesh of the model does not have, and
/// TooLargeError as refine() does.
inline void require_refined_cells(const GeometryOptions &geometry, const MeshOptions &options,
                                  const ModelSymmetry &symmetry)
{
  if (options.refined_cells.empty())
    return;
  if (symmetry.is_section())
    SectionMesh(geometry, options, symmetry);
  else
    BodyMesh(geometry, options, symmetry.planes());
}
} // namespace orthocone
