// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/output/scene_description.h>
#include <orthocone/scene/parameters.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace orthocone::test
{
namespace
{
using Json = nlohmann::json;
using Point = std::array<double, 3>;

Parameters small_box()
{
  Parameters parameters;
  parameters.geometry.shape = BodyShape::box;
  parameters.geometry.sizes = {{4, 6, 2}};
  parameters.geometry.supports = {{"x-", {{true, false, false}}}};
  parameters.mesh.cells = {{2, 2, 1}};
  parameters.mesh.degree = 1;
  parameters.obstacle.gap = "(x-1)^2 + 2*y^2";
  return parameters;
}

Json scene_of(const Parameters &parameters, const bool has_mesh = true)
{
  return Json::parse(scene_description(parameters, choose_model(parameters), has_mesh));
}

const Json &surface_named(const Json &body, const std::string &name)
{
  for (const Json &surface : body["surfaces"])
    if (surface["name"] == name)
      return surface;
  throw std::invalid_argument("no surface " + name);
}

/// Twice the vector area of a polygon.
Point area_of(const Json &face)
{
  Point area{};
  for (std::size_t i = 0; i < face.size(); ++i)
  {
    const Point a = face[i], b = face[(i + 1) % face.size()];
    for (unsigned int d = 0; d < 3; ++d)
      area[d] += a[(d + 1) % 3] * b[(d + 2) % 3] - a[(d + 2) % 3] * b[(d + 1) % 3];
  }
  return area;
}
} // namespace

TEST(SceneDescription, NamesSurfacesAndTheirRoles)
{
  const Json scene = scene_of(small_box());
  const Json &body = scene["bodies"][0];
  EXPECT_EQ(surface_named(body, "base")["roles"], Json({"contact"}));
  EXPECT_EQ(surface_named(body, "top")["roles"], Json({"held"}));
  EXPECT_EQ(surface_named(body, "x-")["roles"], Json({"support"}));
  EXPECT_EQ(surface_named(body, "y = 0")["roles"], Json({"symmetry"})); // the support leaves this plane
  EXPECT_EQ(body["supports"][0]["directions"], Json({true, false, false}));
  EXPECT_TRUE(body["has_own_mesh"]);
  EXPECT_EQ(scene["model"]["mirrored"], Json({false, true}));
}

TEST(SceneDescription, HasFacesThatLookOutwardsAndCoverTheirSurface)
{
  Parameters parameters = small_box();
  parameters.obstacle.kind = ObstacleKind::body;
  parameters.lower.geometry.sizes = {{8, 8, 3}};
  parameters.lower.geometry.shape = BodyShape::box;
  parameters.lower.mesh = parameters.mesh;
  const Json scene = scene_of(parameters);
  for (const unsigned int number : {0u, 1u})
  {
    const double sign = number == 0 ? 1 : -1; // the lower body is upside down
    const Json &body = scene["bodies"][number];
    double area = 0;
    for (const Json &face : surface_named(body, "base")["faces"])
      area += area_of(face)[2] / 2;
    EXPECT_DOUBLE_EQ(area, number == 0 ? -4. * 6 / 2 : 8. * 8 / 2); // a half each
    const Point corner = surface_named(body, "top")["faces"][0][0];
    EXPECT_DOUBLE_EQ(corner[2], sign * (number == 0 ? 2 : 3));
    EXPECT_DOUBLE_EQ(body["held_centre"][2], corner[2]);
  }
}

TEST(SceneDescription, FollowsCurvedEdges)
{
  Parameters parameters;
  parameters.mesh.core_cells = 2;
  parameters.mesh.rings = 1;
  parameters.mesh.layers = 1;
  double largest = 0;
  const Json scene = scene_of(parameters);
  for (const Json &face : surface_named(scene["bodies"][0], "top")["faces"])
    largest = std::max(largest, static_cast<double>(face.size()));
  EXPECT_GT(largest, 4);
}

TEST(SceneDescription, FindsTheFirstTouchAndTheGap)
{
  const Json gap = scene_of(small_box())["gap"];
  EXPECT_EQ(gap["touch"], Json({0., 0.})); // of the nodes at x = 0 and x = 2 that nearer to the middle
  ASSERT_EQ(gap["lines"].size(), 2u);
  EXPECT_EQ(gap["lines"][0]["at"].front(), -2.);
  EXPECT_EQ(gap["lines"][1]["at"].front(), -3.); // the line goes over the whole body
  EXPECT_DOUBLE_EQ(gap["lines"][0]["gaps"].back().get<double>(), 1);
  EXPECT_DOUBLE_EQ(gap["lines"][1]["gaps"].back().get<double>(), 19);
}

TEST(SceneDescription, HasAnOutlineWhereTheMeshIsNotKnown)
{
  Parameters parameters = small_box();
  EXPECT_FALSE(scene_of(parameters, false)["bodies"][0]["has_own_mesh"]);
  parameters.mesh.cells = {{80, 80, 2}};
  const Json body = scene_of(parameters)["bodies"][0];
  EXPECT_FALSE(body["has_own_mesh"]);
  EXPECT_LT(surface_named(body, "base")["faces"].size(), 100u);
}

TEST(SceneDescription, HasForcesAgainstSlip)
{
  Parameters parameters = small_box();
  parameters.friction.mu = {{0.4, 0.2}};
  parameters.friction.angle = 90;
  const Json forces = scene_of(parameters)["friction"]["forces_against_slip"];
  EXPECT_NEAR(forces[0][0].get<double>(), -0.2, 1e-12); // slip along x
  EXPECT_NEAR(forces[0][1].get<double>(), 0, 1e-12);
  EXPECT_NEAR(forces[forces.size() / 4][1].get<double>(), -0.4, 1e-12);
  parameters.friction.mu = {{0, 0}};
  EXPECT_TRUE(scene_of(parameters)["friction"]["forces_against_slip"].empty());
}
} // namespace orthocone::test
