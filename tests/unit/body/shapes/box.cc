// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "cells.h"

#include "body/bodies.h"

#include <gtest/gtest.h>

#include <set>

namespace orthocone::test
{
namespace
{
GeometryOptions small_box()
{
  GeometryOptions geometry;
  geometry.shape = BodyShape::box;
  geometry.sizes = {{12, 7, 5}};
  return geometry;
}

MeshOptions graded_mesh(const unsigned int degree)
{
  MeshOptions mesh;
  mesh.cells = {{6, 4, 3}};
  mesh.degree = degree;
  mesh.edge_grading = 0.7;
  mesh.layer_grading = 0.8;
  return mesh;
}

/// Sorted places of the vertices along an axis.
std::vector<double> places(const BodyMesh &mesh, const unsigned int direction)
{
  std::set<double> all;
  for (const auto &vertex : mesh.triangulation().get_vertices())
    all.insert(vertex[direction]);
  return {all.begin(), all.end()};
}
} // namespace

TEST(Box, IsGradedTowardsItsEnds)
{
  const BodyMesh mesh(small_box(), graded_mesh(1), full);
  const std::vector<double> x = places(mesh, 0);
  ASSERT_EQ(x.size(), 7u);
  EXPECT_EQ(x[0], -6);
  EXPECT_EQ(x[3], 0);
  EXPECT_EQ(x[6], 6);
  EXPECT_NEAR((x[1] - x[0]) / (x[2] - x[1]), 0.7, 1e-12);
  EXPECT_NEAR((x[6] - x[5]) / (x[5] - x[4]), 0.7, 1e-12);
  EXPECT_NEAR(x[4] - x[3], x[3] - x[2], 1e-14);
  const std::vector<double> z = places(mesh, 2);
  ASSERT_EQ(z.size(), 4u);
  EXPECT_EQ(z[0], 0);
  EXPECT_EQ(z[3], 5);
  EXPECT_NEAR((z[1] - z[0]) / (z[2] - z[1]), 0.8, 1e-12);
}

TEST(Box, PartsHaveTheCellsOfTheWhole)
{
  const auto all = cells_of(BodyMesh(small_box(), graded_mesh(1), full));
  EXPECT_EQ(all.size(), 6u * 4 * 3);
  for (const SymmetryPlanes &planes : {half_x, half_y, quarter})
  {
    const auto part = cells_of(BodyMesh(small_box(), graded_mesh(1), planes));
    EXPECT_EQ(part.size() * planes.n_copies(), all.size());
    for (const CellKey &cell : part)
    {
      EXPECT_EQ(all.count(cell), 1u);
      for (const auto &corner : cell)
        EXPECT_TRUE((!planes.normal_to_x || corner[0] >= 0) && (!planes.normal_to_y || corner[1] >= 0));
    }
  }
}

TEST(Box, HasTheAreaOfItsBase)
{
  const GeometryOptions geometry = small_box();
  for (const SymmetryPlanes &planes : {full, half_x, half_y, quarter})
    for (const unsigned int degree : {1, 2, 3})
    {
      const BodyMesh mesh(geometry, graded_mesh(degree), planes);
      const Discretization discretization(mesh.triangulation(), graded_mesh(degree), geometry.top_face);
      double area = 0;
      for (const ContactNode &node : discretization.contact_surface().nodes)
      {
        area += node.area;
        EXPECT_EQ(node.height, 0);
        EXPECT_EQ(node.is_free[0], !planes.normal_to_x || node.position[0] != 0);
        EXPECT_EQ(node.is_free[1], !planes.normal_to_y || node.position[1] != 0);
      }
      EXPECT_NEAR(planes.n_copies() * area, 12 * 7, 1e-11);
      EXPECT_LE((discretization.held_centre() - Eigen::Vector3d(0, 0, 5)).norm(), 1e-12);
    }
}

// Without lateral contraction a uniform pressure E u / l_z lifts the base by u everywhere.
TEST(Box, PassesThePatchTest)
{
  MaterialOptions material;
  material.poisson_ratio = 0;
  constexpr double u = 0.01;
  const GeometryOptions geometry = small_box();
  const double pressure = material.young_modulus * u / geometry.sizes[2];
  for (const SymmetryPlanes &planes : {full, half_y, quarter})
    for (const unsigned int degree : {1, 2, 3})
    {
      const LoadableBody body(geometry, graded_mesh(degree), material, planes);
      const auto &nodes = body.discretization.contact_surface().nodes;
      NodeVector force = NodeVector::Zero(3 * static_cast<Eigen::Index>(nodes.size()));
      for (std::size_t i = 0; i < nodes.size(); ++i)
        force[3 * static_cast<Eigen::Index>(i)] = pressure * nodes[i].area;
      NodeVector moved;
      body.condensed.compliance().vmult(moved, force);
      for (std::size_t i = 0; i < nodes.size(); ++i)
      {
        const Eigen::Vector3d d = moved.segment<3>(3 * static_cast<Eigen::Index>(i));
        EXPECT_LE((d - Eigen::Vector3d(u, 0, 0)).norm(), 1e-11 * u);
      }
    }
}

TEST(Box, HasNoSection)
{
  EXPECT_THROW(SectionMesh(small_box(), graded_mesh(1)), std::logic_error);
}
} // namespace orthocone::test
