// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/shapes/body_mesh.h>

#include <deal.II/distributed/tria.h>

#include <utility>

namespace orthocone
{
namespace
{
constexpr auto smoothing = dealii::Triangulation<3>::limit_level_difference_at_vertices;
}

BodyMesh::BodyMesh(const GeometryOptions &geometry, const MeshOptions &options, const SymmetryPlanes &planes)
    : geometry_(geometry),
      options_(options),
      planes_(planes)
{
  auto whole = unrefined();
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

std::unique_ptr<dealii::Triangulation<3>> BodyMesh::unrefined() const
{
  auto whole = std::make_unique<dealii::Triangulation<3>>(smoothing);
  make_shape(geometry_, options_)->make_solid(planes_, *whole);
  return whole;
}

std::vector<unsigned int> BodyMesh::cell_numbers() const
{
  if (n_ranks() == 1)
    return numbers_in_order(*triangulation_);
  const auto whole = unrefined();
  refine(*whole, options_);
  return numbers_in_whole(*triangulation_, *whole);
}
} // namespace orthocone
