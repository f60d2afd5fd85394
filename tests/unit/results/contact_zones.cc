// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "results/scenes.h"

#include <orthocone/base/numbers.h>
#include <orthocone/results/contact_zones.h>

#include <cmath>
#include <functional>

namespace orthocone::test
{
namespace
{
/// n x n nodes, 1 mm apart, between faces of degree 1. `is_quarter`: mirrored at x = 0 and y = 0.
ContactSurface grid(const unsigned int n, const bool is_quarter = false)
{
  ContactSurface surface;
  for (unsigned int y = 0; y < n; ++y)
    for (unsigned int x = 0; x < n; ++x)
      surface.nodes.push_back(
          {{{1. * x, 1. * y}}, 1, {}, {{!is_quarter || x > 0, !is_quarter || y > 0, true}}});
  for (unsigned int y = 0; y + 1 < n; ++y)
    for (unsigned int x = 0; x + 1 < n; ++x)
      surface.faces.push_back({y * n + x, y * n + x + 1, (y + 1) * n + x, (y + 1) * n + x + 1});
  return surface;
}

ZoneWidths widths_of(const ContactSurface &surface, const std::function<NodeStatus(double, double)> &status)
{
  std::vector<NodeStatus> statuses;
  for (const ContactNode &node : surface.nodes)
    statuses.push_back(status(node.position[0], node.position[1]));
  return ContactZones(surface).widths(statuses);
}

/// In contact within a distance from a node, and sticking within another one.
ZoneWidths widths_of_discs(const ContactSurface &surface, const double middle, const double contact,
                           const double stick)
{
  return widths_of(surface,
                   [&](const double x, const double y)
                   {
                     const double r = std::hypot(x - middle, y - middle);
                     return r < stick ? NodeStatus::stick : r < contact ? NodeStatus::slip : NodeStatus::open;
                   });
}

/// A cylinder pressed on a paraboloid of the given radius (mm), whose rim stays open.
Parameters sphere(const double radius)
{
  Parameters parameters = small_scene();
  parameters.mesh.core_cells = 8;
  parameters.obstacle.gap = "(x^2+y^2)/" + std::to_string(2 * radius);
  parameters.load.legs = {move_to(0, 0, -0.05, 1), move_to(0.01, 0, -0.05, 1)};
  return parameters;
}
} // namespace

TEST(ContactZones, AreAsWideAsTheDistancesBetweenTheirNodes)
{
  const ContactSurface surface = grid(11);
  EXPECT_EQ(widths_of_discs(surface, 5, 0, 0).contact, 0);
  for (const double radius : {1., 2., 3., 4.})
  {
    const ZoneWidths widths = widths_of_discs(surface, 5, radius, 0.5);
    EXPECT_EQ(widths.contact, 2 * radius - 1);
    EXPECT_EQ(widths.stick, 1);
    EXPECT_FALSE(widths.rim_touches);
  }
}

TEST(ContactZones, GoOnBehindPlanesOfSymmetryAndHaveNoBorderAtTheRim)
{
  for (const double radius : {1., 2., 3.})
  {
    const ZoneWidths widths = widths_of_discs(grid(6, true), 0, radius, 0);
    EXPECT_EQ(widths.contact, 2 * radius - 1);
    EXPECT_FALSE(widths.rim_touches) << radius;
  }
  const ZoneWidths complete = widths_of_discs(grid(6), 0, 100, 0);
  EXPECT_TRUE(std::isinf(complete.contact));
  EXPECT_TRUE(complete.rim_touches);
  EXPECT_EQ(complete.stick, 0);
}

// A strip along the rim and a ring are as wide as they are across.
TEST(ContactZones, AreMeasuredAcross)
{
  const ContactSurface surface = grid(11);
  const auto strip = [](const double x, double) { return x < 1.5 ? NodeStatus::slip : NodeStatus::open; };
  EXPECT_EQ(widths_of(surface, strip).contact, 3); // half of it would lie beyond the rim
  EXPECT_TRUE(widths_of(surface, strip).rim_touches);
  const auto ring = [](const double x, const double y)
  { return std::max(std::abs(x - 5), std::abs(y - 5)) == 3 ? NodeStatus::slip : NodeStatus::open; };
  EXPECT_EQ(widths_of(surface, ring).contact, 1);
}

TEST(ContactZones, OfACurvedContactShrinkWithItsRadius)
{
  double widths[2];
  for (const unsigned int i : {0, 1})
  {
    TestScene scene(sphere(i == 0 ? 20 : 600));
    scene.march();
    const Totals totals = scene.totals();
    widths[i] = totals.zones.contact;
    EXPECT_FALSE(totals.zones.rim_touches);
    EXPECT_GT(totals.contact_area, 0);
    EXPECT_LT(totals.contact_area, 0.9 * pi * 100);
  }
  EXPECT_LT(widths[0], 4);
  EXPECT_GT(widths[1], 4);
}

// An open node moves along the plane, too, but it does not slip.
TEST(Slip, IsThatOfNodesInContact)
{
  TestScene scene(sphere(600));
  scene.march(
      [](const ContactState &before, const ContactState &after, const LoadStep &)
      {
        for (Eigen::Index node = 0; node < after.n_nodes(); ++node)
          if (before.status[node] == NodeStatus::open && after.status[node] == NodeStatus::open)
          {
            EXPECT_EQ(after.accumulated_slip[node], before.accumulated_slip[node]);
          }
      });
  double largest = 0, of_open = 0;
  const auto &nodes = scene.discretization.contact_surface().nodes;
  for (unsigned int node = 0; node < nodes.size(); ++node)
  {
    const ContactFields fields = scene.evaluator.fields(scene.state, node);
    if (fields.status != NodeStatus::open)
      largest = std::max(largest, fields.slip.norm());
    else
    {
      EXPECT_EQ(fields.slip.norm(), 0);
      of_open = std::max(of_open, fields.displacement.head<2>().norm());
    }
  }
  EXPECT_GT(of_open, largest);
  EXPECT_EQ(scene.totals().max_slip, largest);
}

// The load of an even pressure is carried by all of the contact, that of a point by one node.
TEST(ContactZones, KnowThePartThatCarriesTheLoad)
{
  Parameters parameters = full_scene();
  parameters.load.legs = {move_to(0, 0, -0.1, 1)};
  TestScene scene(parameters);
  scene.march();
  EXPECT_TRUE(std::isinf(scene.totals().zones.load));
  scene.state.force.setZero();
  scene.state.force[0] = 1;
  EXPECT_NEAR(scene.totals().zones.load, 1, 1e-12);
}
} // namespace orthocone::test
