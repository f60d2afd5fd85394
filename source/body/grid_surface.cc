// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/grid_surface.h>

namespace orthocone
{
using Eigen::Index;

SurfaceGrid surface_grid(const GeometryOptions &geometry, const MeshOptions &mesh)
{
  const Index halves = Index{1} << mesh.refinements, n_x = halves * mesh.cells[0],
              n_y = halves * mesh.cells[1];
  return {n_x, n_y, geometry.sizes[0] / static_cast<double>(n_x),
          geometry.sizes[1] / static_cast<double>(n_y), geometry.is_periodic};
}

GridSurface::GridSurface(const GeometryOptions &geometry, const MeshOptions &mesh)
    : grid_(surface_grid(geometry, mesh))
{
  const auto n = static_cast<unsigned int>(grid_.n_nodes());
  size_ = {n, 3 * n, 3 * n};
  n_owned_ = n_free_ = 3 * n;
  add_nodes();
  add_faces();
}

void GridSurface::add_nodes()
{
  const auto middle = [](const Index n) { return static_cast<double>(n - 1) / 2; };
  positions_ = Eigen::Matrix3Xd::Zero(3, 3 * grid_.n_nodes());
  for (Index j = 0; j < grid_.n_y; ++j)
    for (Index i = 0; i < grid_.n_x; ++i)
    {
      const double x = (static_cast<double>(i) - middle(grid_.n_x)) * grid_.width,
                   y = (static_cast<double>(j) - middle(grid_.n_y)) * grid_.height;
      const auto first = static_cast<unsigned int>(directions_.size());
      contact_surface_.nodes.push_back(
          {{{x, y}}, grid_.width * grid_.height, {{first, first + 1, first + 2}}, {{true, true, true}}});
      for (unsigned int d = 0; d < 3; ++d)
      {
        directions_.push_back(static_cast<unsigned char>(d));
        positions_.col(first + d).head<2>() << x, y;
      }
    }
}

void GridSurface::add_faces()
{
  const auto n_x = static_cast<unsigned int>(grid_.n_x);
  for (unsigned int j = 0; j + 1 < grid_.n_y; ++j)
    for (unsigned int i = 0; i + 1 < n_x; ++i)
    {
      const unsigned int node = j * n_x + i;
      contact_surface_.faces.push_back({node, node + 1, node + n_x, node + n_x + 1});
    }
}
} // namespace orthocone
