// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "body/even_mesh.h"
#include "body/msh.h"
#include "body/planes.h"
#include "folder_of_files.h"
#include "rejection.h"

#include <orthocone/body/body.h>
#include <orthocone/body/shapes/body_mesh.h>

#include <deal.II/grid/tria_accessor.h>

#include <gtest/gtest.h>

#include <cmath>

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

/// Three cells about an edge of the base: the middle one has this edge and no face there.
static Msh fan_of_cells()
{
  Msh fan;
  const double high = std::sqrt(0.75);
  for (const double y : {0., 1.})
    for (const auto &[x, z] : {std::make_pair(0., 0.),
                               {1., 0.},
                               {1.5, high},
                               {0.5, high},
                               {0., 2 * high},
                               {-0.5, high},
                               {-1.5, high},
                               {-1., 0.}})
      fan.nodes.push_back({{x, y, z}});
  const auto add = [&](const unsigned int type, const unsigned int group, const std::vector<unsigned int> &at)
  {
    fan.elements.push_back({type, group, at});
    for (unsigned int i = 0; i < at.size(); ++i) // and those above
      fan.elements.back().nodes.push_back(type == 5 ? at[i] + 8 : at[at.size() - 1 - i] + 8);
  };
  add(5, 1, {1, 2, 3, 4});
  add(5, 1, {1, 4, 5, 6});
  add(5, 1, {1, 6, 7, 8});
  add(3, 1, {1, 2});
  add(3, 1, {8, 1});
  add(3, 2, {4, 5});
  add(3, 2, {5, 6});
  return fan;
}

// If another is halved, so is the middle one, and the nodes on the edge hang on those of the face that is
// left.
TEST(Refinement, HalvesCellsThatHaveALineOfTheContactSurface)
{
  const Folder folder;
  BodyOptions options;
  options.geometry = imported(folder.write("fan.msh", fan_of_cells().text()));
  options.mesh.refined_cells = {{{0, 0}}};
  for (const unsigned int degree : {1, 2, 3})
  {
    options.mesh.degree = degree;
    const Body body(options, ModelSymmetry());
    EXPECT_EQ(body.unknowns().size().cells, degree == 1 ? 10U : 17U);
    double area = 0;
    for (const ContactNode &node : body.unknowns().contact_surface().nodes)
      area += node.area;
    EXPECT_NEAR(area, 2, 1e-12);
  }
}
} // namespace orthocone::test
