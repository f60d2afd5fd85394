// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "cells.h"

#include "body/bodies.h"

#include <orthocone/base/numbers.h>

#include <deal.II/grid/grid_tools.h>

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace orthocone::test
{
namespace
{
double contact_area(const Discretization &discretization)
{
  double area = 0;
  for (const ContactNode &node : discretization.contact_surface().nodes)
    area += node.area;
  return area;
}

double volume(const BodyMesh &mesh, const unsigned int degree)
{
  return dealii::GridTools::volume(mesh.triangulation(), dealii::MappingQ<3>(degree));
}
} // namespace

TEST(Mesh, IsThePapers)
{
  const GeometryOptions geometry;
  MeshOptions options;
  options.degree = 1;
  const BodyMesh mesh(geometry, options, full);
  const Discretization discretization(mesh.triangulation(), options, geometry.top_face);
  EXPECT_EQ(mesh.triangulation().n_active_cells(), 1280u);
  EXPECT_EQ(discretization.contact_surface().nodes.size(), 337u);
  EXPECT_EQ(discretization.contact_surface().faces.size(), 320u);
  EXPECT_EQ(discretization.n_dofs(), 3u * 337 * 5);
}

// A polygon of 32 corners for degree 1; higher degrees follow the circle ever more closely.
TEST(Mesh, FillsTheCylinder)
{
  const GeometryOptions geometry;
  const double disc = pi * geometry.radius * geometry.radius;
  const double polygon = 16 * geometry.radius * geometry.radius * std::sin(2 * pi / 32);
  const std::map<unsigned int, double> tolerance{{2, 2e-5}, {3, 5e-8}};
  for (const SymmetryPlanes &planes : {full, half_x, half_y, quarter})
    for (const unsigned int degree : {1, 2, 3})
    {
      MeshOptions options;
      options.degree = degree;
      options.layers = 1;
      const BodyMesh mesh(geometry, options, planes);
      const Discretization discretization(mesh.triangulation(), options, geometry.top_face);
      const double expected = (degree == 1 ? polygon : disc) / planes.n_copies();
      const double accuracy = degree == 1 ? 1e-12 : tolerance.at(degree);
      EXPECT_NEAR(contact_area(discretization), expected, accuracy * expected);
      EXPECT_NEAR(volume(mesh, degree), geometry.height * expected, accuracy * geometry.height * expected);
      for (const ContactNode &node : discretization.contact_surface().nodes)
        EXPECT_GT(node.area, 0);
    }
}

TEST(Mesh, OfAPartIsExactlyThatPartOfTheFullMesh)
{
  const GeometryOptions geometry;
  MeshOptions options = small_mesh(2);
  options.core_cells = 4;
  const auto all = cells_of(BodyMesh(geometry, options, full));
  for (const SymmetryPlanes &planes : {half_x, half_y, quarter})
  {
    const auto part = cells_of(BodyMesh(geometry, options, planes));
    EXPECT_EQ(part.size() * planes.n_copies(), all.size());
    for (const CellKey &cell : part)
      EXPECT_EQ(all.count(cell), 1u);
  }
}

TEST(Mesh, HonoursGradings)
{
  const GeometryOptions geometry;
  MeshOptions options = small_mesh(1);
  options.rings = 3;
  options.layers = 5;
  const BodyMesh mesh(geometry, options, full);
  std::set<double> heights;
  std::set<double> radii; // along the x axis, beyond the core
  const double core = options.core_ratio * geometry.radius / std::sqrt(2.);
  for (const auto &vertex : mesh.triangulation().get_vertices())
  {
    heights.insert(vertex[2]);
    if (vertex[2] == 0 && vertex[1] == 0 && vertex[0] > core - 1e-12)
      radii.insert(vertex[0]);
  }
  ASSERT_EQ(heights.size(), 6u);
  ASSERT_EQ(radii.size(), 4u);
  const std::vector<double> z(heights.begin(), heights.end());
  for (const unsigned int layer : {0, 1})
  {
    EXPECT_NEAR((z[layer + 1] - z[layer]) / (z[layer + 2] - z[layer + 1]), 0.8, 1e-12);
    EXPECT_NEAR(z[layer] + z[5 - layer], geometry.height, 1e-12);
  }
  const std::vector<double> r(radii.begin(), radii.end());
  EXPECT_NEAR((r[2] - r[1]) / (r[1] - r[0]), 0.7, 1e-12);
  EXPECT_NEAR((r[3] - r[2]) / (r[2] - r[1]), 0.7, 1e-12);
  EXPECT_EQ(r[3], geometry.radius);
}

// Rings are equally thick all along, between vertices too, and strong grading leaves no node without area.
TEST(Mesh, CurvesEveryRing)
{
  const GeometryOptions geometry;
  for (const unsigned int degree : {2, 3})
    for (const unsigned int core_cells : {1, 2, 4})
    {
      MeshOptions options;
      options.degree = degree;
      options.core_cells = core_cells;
      options.rings = 8;
      options.layers = 1;
      options.rim_grading = 0.35;
      const BodyMesh mesh(geometry, options, full);
      const Discretization discretization(mesh.triangulation(), options, geometry.top_face);
      const double disc = pi * geometry.radius * geometry.radius;
      const double rim_thickness_at_axis = [&]
      {
        std::set<double> radii;
        for (const auto &vertex : mesh.triangulation().get_vertices())
          if (vertex[2] == 0)
            radii.insert(std::round(1e9 * std::hypot(vertex[0], vertex[1])) / 1e9);
        return geometry.radius - *std::prev(radii.end(), 2);
      }();
      double rim_area = 0;
      for (const ContactNode &node : discretization.contact_surface().nodes)
      {
        EXPECT_GT(node.area, 0);
        if (std::hypot(node.position[0], node.position[1]) > geometry.radius - 1e-9)
          rim_area += node.area;
      }
      // End weights of the Gauss-Lobatto rules: 1/6 for degree 2, 1/12 for degree 3.
      const double expected =
          (degree == 2 ? 1. / 6 : 1. / 12) * 2 * pi * geometry.radius * rim_thickness_at_axis;
      EXPECT_NEAR(rim_area, expected, 0.2 * expected) << core_cells << " cells, degree " << degree;
      EXPECT_NEAR(contact_area(discretization), disc, 0.02 * disc);
    }
}

TEST(Mesh, PutsTheRimNodesOnTheCircle)
{
  const GeometryOptions geometry;
  for (const unsigned int degree : {1, 2, 3})
  {
    const MeshOptions options = small_mesh(degree);
    const BodyMesh mesh(geometry, options, quarter);
    const Discretization discretization(mesh.triangulation(), options, geometry.top_face);
    unsigned int n_rim = 0;
    for (const ContactNode &node : discretization.contact_surface().nodes)
      if (std::abs(std::hypot(node.position[0], node.position[1]) - geometry.radius) < 1e-10)
        ++n_rim;
    EXPECT_EQ(n_rim, degree * options.core_cells + 1);
  }
}

TEST(Discretization, HoldsTopAndSymmetryPlanesOnly)
{
  GeometryOptions geometry;
  for (const TopFace top : {TopFace::clamped, TopFace::guided})
  {
    geometry.top_face = top;
    const MeshOptions options = small_mesh(2);
    const BodyMesh mesh(geometry, options, quarter);
    const Discretization discretization(mesh.triangulation(), options, geometry.top_face);
    const auto positions = dof_positions(discretization);
    const auto components = [&]
    {
      std::vector<unsigned int> list(discretization.n_dofs());
      std::vector<dealii::types::global_dof_index> dofs(discretization.fe().n_dofs_per_cell());
      for (const auto &cell : discretization.dof_handler().active_cell_iterators())
      {
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          list[dofs[i]] = discretization.fe().system_to_component_index(i).first;
      }
      return list;
    }();
    for (unsigned int dof = 0; dof < discretization.n_dofs(); ++dof)
    {
      const auto &x = positions[dof];
      const unsigned int d = components[dof];
      const bool is_top = std::abs(x[2] - geometry.height) < 1e-12 && (top == TopFace::clamped || d == 2);
      const bool is_in_plane = d < 2 && std::abs(x[d]) < 1e-12;
      EXPECT_EQ(dof >= discretization.n_free(), is_top || is_in_plane);
      const bool is_contact = x[2] == 0 && dof < discretization.n_free();
      EXPECT_EQ(dof >= discretization.n_interior() && dof < discretization.n_free(), is_contact);
    }
  }
}
} // namespace orthocone::test
