// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "body/shapes/curved_cell.h"

#include <gtest/gtest.h>

#include <cmath>

namespace orthocone::test
{
namespace
{
using dealii::Point;

/// A quarter of a ring of radii 1 and 2, bent and twisted along the axis y.
template<int dim>
typename QuadraticCell<dim>::Nodes bent_nodes()
{
  typename QuadraticCell<dim>::Nodes nodes;
  for (unsigned int i = 0; i < nodes.size(); ++i)
  {
    const Point<dim> unit = QuadraticCell<dim>::unit_node(i);
    const double angle = 0.5 * M_PI * unit[0], radius = 1 + unit[dim - 1];
    nodes[i][0] = radius * std::cos(angle);
    nodes[i][dim - 1] = radius * std::sin(angle);
    if (dim == 3)
      nodes[i][1] = 0.7 * unit[1] + 0.1 * unit[0] * unit[0];
  }
  return nodes;
}

/// About the axis y.
SurfaceForm unit_cylinder()
{
  return {SurfaceKind::cylinder, {0, 0, 0}, dealii::Point<3>(0, 1, 0), 1};
}

template<int dim>
void expect_inverse(const CurvedCell<dim> &cell)
{
  for (unsigned int point = 0; point < 216; ++point)
  {
    Point<dim> unit;
    unit[0] = point % 6 / 5.;
    unit[dim - 1] = point / 36 / 5.;
    if (dim == 3)
      unit[1] = point / 6 % 6 / 5.;
    const auto found = cell.pull_back(cell.push_forward(unit));
    ASSERT_TRUE(found);
    EXPECT_LE(found->distance(unit), 1e-13);
  }
}
} // namespace

TEST(CurvedCell, IsInvertedAtEveryPoint)
{
  expect_inverse(CurvedCell<2>(bent_nodes<2>(), {}, {}));
  expect_inverse(CurvedCell<3>(bent_nodes<3>(), {}, {}));
  const SurfaceForm bore = unit_cylinder();
  expect_inverse(CurvedCell<2>(bent_nodes<2>(), {{0, {{0, 0}}, {bore}}}, {}));
}

// The edges and the face of a cell lie on the cylinder, and all points between have the inverse.
TEST(CurvedCell, FollowsItsCylinder)
{
  auto nodes = bent_nodes<3>();
  for (unsigned int i = 0; i < nodes.size(); ++i)
    nodes[i][1] = 0.7 * QuadraticCell<3>::unit_node(i)[1];
  const SurfaceForm bore = unit_cylinder();
  const CurvedCell<3> cell(nodes,
                           {{0, {{0, 0, 0}}, {bore}},
                            {0, {{0, 1, 0}}, {bore}},
                            {1, {{0, 0, 0}}, {bore}},
                            {1, {{1, 0, 0}}, {bore}}},
                           {{2, 0, bore}});
  expect_inverse(cell);
  double lack = 0;
  for (const double u : {0., 0.1, 0.45, 0.8})
    for (const double v : {0., 0.3, 1.})
    {
      const auto on_bore = cell.push_forward({u, v, 0}), on_rim = cell.push_forward({u, v, 1});
      EXPECT_NEAR(std::hypot(on_bore[0], on_bore[2]), 1, 1e-15);
      lack = std::max(lack, std::abs(std::hypot(on_rim[0], on_rim[2]) - 2));
    }
  EXPECT_GT(lack, 1e-4); // the rim is a parabola
}

TEST(QuadraticCell, FitsIntoItsBox)
{
  auto nodes = bent_nodes<2>();
  nodes[1] = {1.5, 1.2}; // the parabola overshoots its nodes
  const QuadraticCell<2> cell(nodes);
  const auto box = cell.box();
  for (double u = 0; u <= 1; u += 1. / 64)
    for (double v = 0; v <= 1; v += 1. / 64)
      EXPECT_TRUE(box.point_inside(cell.value({u, v}), 1e-12));
}

// A cell whose corners are those of a cube, but whose middle of an edge is beyond a quarter of its length.
TEST(QuadraticCell, IsInvertedBetweenItsCorners)
{
  QuadraticCell<3>::Nodes nodes;
  for (unsigned int i = 0; i < nodes.size(); ++i)
    nodes[i] = QuadraticCell<3>::unit_node(i);
  EXPECT_EQ(scaled_jacobian(QuadraticCell<3>(nodes)), 1);
  nodes[1][0] = 0.26;
  EXPECT_GT(scaled_jacobian(QuadraticCell<3>(nodes)), 0);
  nodes[1][0] = 0.24;
  EXPECT_LT(scaled_jacobian(QuadraticCell<3>(nodes)), 0);
}
} // namespace orthocone::test
