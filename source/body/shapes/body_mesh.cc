// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/shapes/body_mesh.h>

#include <deal.II/distributed/tria.h>

#include <utility>

namespace orthocone
{
BodyMesh::BodyMesh(const GeometryOptions &geometry, const MeshOptions &options, const SymmetryPlanes &planes)
{
  constexpr auto smoothing = dealii::Triangulation<3>::limit_level_difference_at_vertices;
  auto whole = std::make_unique<dealii::Triangulation<3>>(smoothing);
  make_shape(geometry, options)->make_solid(planes, *whole);
  if (n_ranks() == 1)
  {
    refine(*whole, options);
    triangulation_ = std::move(whole);
    return;
  }
  auto shared = std::make_unique<dealii::parallel::distributed::Triangulation<3>>(MPI_COMM_WORLD, smoothing);
  shared->copy_triangulation(*whole);
  refine_shared(*shared, *whole, options);
  triangulation_ = std::move(shared);
}
} // namespace orthocone
