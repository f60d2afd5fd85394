// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "body/even_mesh.h"
#include "body/planes.h"
#include "rejection.h"

#include <orthocone/body/shapes/body_mesh.h>

#include <deal.II/grid/tria_accessor.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
/// Eight cells for one, and what keeps neighbours' edges within a factor of two.
TEST(Refinement, HalvesTheCellsOfEachRound)
{
  const GeometryOptions geometry;
  MeshOptions mesh = even_mesh(1, 0);
  EXPECT_EQ(BodyMesh(geometry, mesh, quarter).triangulation().n_active_cells(), 6U);
  mesh.refined_cells = {{{2, 2}, {4, 5}}};
  EXPECT_EQ(BodyMesh(geometry, mesh, quarter).triangulation().n_active_cells(), 3U + 3 * 8);
  mesh.refined_cells.push_back({{3, 3}});
  const BodyMesh refined(geometry, mesh, quarter);
  for (const auto &cell : refined.triangulation().active_cell_iterators())
    for (const unsigned int face : cell->face_indices())
      EXPECT_LE(cell->at_boundary(face) ? 0 : cell->level() - cell->neighbor(face)->level(), 1);
}

TEST(Refinement, IsUndoneLevelByLevel)
{
  const GeometryOptions geometry;
  MeshOptions mesh = uneven_mesh(1);
  const auto n_levels = [&] { return BodyMesh(geometry, mesh, quarter).triangulation().n_levels(); };
  ASSERT_EQ(n_levels(), 3U);
  for (const unsigned int n : {2U, 1U})
  {
    ++mesh.coarsenings;
    EXPECT_EQ(n_levels(), n);
  }
}

TEST(Refinement, RejectsACellThatThereIsNot)
{
  MeshOptions mesh = even_mesh(1, 0);
  mesh.refined_cells = {{{0, 0}}, {{5, 13}}};
  EXPECT_EQ(rejection_of([&] { BodyMesh({}, mesh, quarter); }),
            "Mesh/Refined cells: round 2 has cell 13: allowed is a number up to 12, the last cell of the "
            "mesh then");
}
} // namespace orthocone::test
