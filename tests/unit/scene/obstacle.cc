// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "rejection.h"

#include <orthocone/scene/half_space_obstacle.h>
#include <orthocone/scene/obstacle.h>

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>

namespace orthocone::test
{
namespace
{
std::string gap_rejection(const Obstacle &obstacle, const Eigen::Vector3d &place)
{
  return rejection_of([&] { obstacle.check({{place}}); });
}
} // namespace

TEST(Obstacle, IsAPlaneWithoutAGap)
{
  EXPECT_TRUE(make_obstacle({})->is_plane());
  EXPECT_FALSE(make_obstacle({"0.1", ""})->is_plane());
}

TEST(Obstacle, GivesWayWhereItIsAHalfSpace)
{
  const auto rigid = make_obstacle({"x", ""});
  ObstacleOptions half_space{"x", ""};
  half_space.kind.choose<HalfSpaceKind>().half_space = {1000, 0.1};
  const auto elastic = make_obstacle(half_space);
  EXPECT_FALSE(rigid->material());
  EXPECT_EQ(elastic->material()->young_modulus, 1000);
  EXPECT_FALSE(elastic->is_plane());
  EXPECT_EQ(elastic->gap({{3, 4, 0}}), 3);
  ContactSurface surface; // one face
  for (const auto &[x, y] : {std::array<double, 2>{{0, 0}}, {{1, 0}}, {{0, 1}}, {{1, 1}}})
    surface.nodes.push_back({{{x, y}}, 0.25, {}, {{true, true, true}}});
  surface.faces = {{0, 1, 2, 3}};
  EXPECT_EQ(rigid->compliance(surface, ModelSymmetry(), LocalAxes(0)).size(), 0);
  EXPECT_EQ(elastic->compliance(surface, ModelSymmetry(), LocalAxes(0)).rows(), 12);
}

TEST(Obstacle, HasNoSectionWhereItIsAHalfSpace)
{
  const SurfaceSample sample;
  const auto elastic = make_obstacle({"0", "", ObstacleKind::half_space});
  EXPECT_EQ(elastic->asymmetry(ModelSymmetry::of_revolution(), sample),
            "Obstacle/Kind = half-space has no section (r, z)");
  EXPECT_EQ(elastic->asymmetry(SymmetryPlanes{true, true}, sample), "");
}

TEST(Obstacle, AddsTheHeightOfTheNode)
{
  ContactSurface surface;
  surface.nodes = {{{{3, 4}}, 1, {}, {}, 0}, {{{0, 2}}, 1, {}, {}, 0.5}};
  const NodeVector gaps = gaps_of(*make_obstacle({"(x^2+y^2)/100", ""}), surface);
  EXPECT_DOUBLE_EQ(gaps[0], 0.25);
  EXPECT_DOUBLE_EQ(gaps[3], 0.54);
  EXPECT_EQ(gaps.segment(1, 2).norm() + gaps.segment(4, 2).norm(), 0);
}

TEST(Obstacle, AddsFileAndExpression)
{
  const auto path = std::filesystem::temp_directory_path() / "orthocone_obstacle_gap.txt";
  std::ofstream(path) << "0 10 2 0 10 2\n0 1\n2 3\n";
  const auto obstacle = make_obstacle({"x", path.string()});
  EXPECT_DOUBLE_EQ(obstacle->gap({{5, 5, 0}}), 5 + 1.5);
  EXPECT_EQ(gap_rejection(*obstacle, {10, 0, 0}), "");
  EXPECT_EQ(
      gap_rejection(*obstacle, {10.5, 0, 0}),
      "Obstacle/Gap file = " + path.string() +
          ": allowed is a grid that covers the whole contact surface, also (10.5, 0) mm; this one reaches "
          "from (0, 0) mm to (10, 10) mm");
  std::filesystem::remove(path);
}

TEST(Obstacle, IsDefinedEverywhere)
{
  EXPECT_EQ(gap_rejection(*make_obstacle({"sqrt(25-x^2)", ""}), {5, 0, 0}), "");
  EXPECT_EQ(
      gap_rejection(*make_obstacle({"sqrt(25-x^2)", ""}), {6, 1, 0}),
      "Obstacle/Gap = sqrt(25-x^2) is not a number at (6, 1) mm of the contact surface: allowed is a finite "
      "number (mm)");
  EXPECT_EQ(
      gap_rejection(*make_obstacle({"1/x", ""}), {0, 1, 0}),
      "Obstacle/Gap = 1/x is infinite at (0, 1) mm of the contact surface: allowed is a finite number (mm)");
}

namespace
{
std::unique_ptr<const Obstacle> at_distance(const std::string &distance)
{
  ObstacleOptions options;
  options.distance = distance;
  return make_obstacle(options);
}
} // namespace

// The gradient of a distance by differences: of a plane, a sphere, a bore and a cone, to rounding.
TEST(Obstacle, HasTheGradientOfItsDistanceAsNormal)
{
  const std::vector<SurfacePoint> points{{{3, 1, 2}}, {{-2, 4, 5}}, {{0.5, -3, 1}}};
  const auto expect = [&](const std::string &distance, const auto &exact)
  {
    const auto normals = at_distance(distance)->normals(points);
    for (std::size_t i = 0; i < points.size(); ++i)
      EXPECT_LE((normals[i] - exact(points[i].place).normalized()).norm(), 1e-12) << distance;
  };
  using V = Eigen::Vector3d;
  expect("0.6*z - 0.8*x + 3", [](const V &) { return V(-0.8, 0, 0.6); });
  expect("sqrt(x^2+y^2+(z+20)^2) - 20", [](const V &p) { return V(p[0], p[1], p[2] + 20); });
  expect("7 - sqrt(x^2+y^2)", [](const V &p) { return V(-p[0], -p[1], 0); });
  expect("0.6*z - 0.8*sqrt(x^2+y^2)",
         [](const V &p) { return V(-0.8 * p[0], -0.8 * p[1], 0.6 * p.head<2>().norm()); });
  EXPECT_EQ(at_distance("0.6*z - 0.8*x + 3")->gap(points[0]), 0.6 * 2 - 0.8 * 3 + 3);
}

// min() of two planes: beside the edge each point has the normal of its own side, and on it the mean.
TEST(Obstacle, KeepsToOneSideOfAnEdge)
{
  const auto groove = at_distance("min(0.8*z - 0.6*x, 0.8*z + 0.6*x)");
  const std::vector<SurfacePoint> points{{{5, 0, 4}}, {{-1e-4, 2, 4}}, {{0, 1, 4}}};
  const auto normals = groove->normals(points);
  EXPECT_LE((normals[0] - Eigen::Vector3d(-0.6, 0, 0.8)).norm(), 1e-10);
  EXPECT_LE((normals[1] - Eigen::Vector3d(0.6, 0, 0.8)).norm(), 1e-8);
  EXPECT_LE((normals[2] - Eigen::Vector3d(0, 0, 1)).norm(), 1e-8);
  const auto warnings = groove->warnings(points);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("has an edge at (0, 1, 4) mm"), std::string::npos) << warnings[0];
}

TEST(Obstacle, NeedsADistanceWithAGradient)
{
  EXPECT_EQ(gap_rejection(*at_distance("0*x + 1"), {1, 2, 3}),
            "Obstacle/Distance = 0*x + 1 has the gradient 0 at (1, 2, 3) mm of the contact surface, so that "
            "there is no normal: allowed is a distance whose gradient has the length 1 there, such as z");
  EXPECT_EQ(gap_rejection(*at_distance("1/x"), {0, 2, 3}),
            "Obstacle/Distance = 1/x is infinite at (0, 2, 3) mm of the contact surface: allowed is a finite "
            "number (mm)");
  const auto warnings = at_distance("x^2+y^2+z^2-9")->warnings({{{3, 0, 0}}, {{0, 3, 0}}});
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("its gradient has the length 6 at"), std::string::npos) << warnings[0];
}
} // namespace orthocone::test
