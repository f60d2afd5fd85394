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
std::string gap_rejection(const Obstacle &obstacle, const std::vector<Eigen::Vector2d> &places)
{
  return rejection_of([&] { obstacle.check(places); });
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
  EXPECT_EQ(elastic->gap({3, 4}), 3);
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
  EXPECT_DOUBLE_EQ(obstacle->gap({5, 5}), 5 + 1.5);
  EXPECT_EQ(gap_rejection(*obstacle, {{10, 0}}), "");
  EXPECT_EQ(
      gap_rejection(*obstacle, {{10.5, 0}}),
      "Obstacle/Gap file = " + path.string() +
          ": allowed is a grid that covers the whole contact surface, also (10.5, 0) mm; this one reaches "
          "from (0, 0) mm to (10, 10) mm");
  std::filesystem::remove(path);
}

TEST(Obstacle, IsDefinedEverywhere)
{
  EXPECT_EQ(gap_rejection(*make_obstacle({"sqrt(25-x^2)", ""}), {{3, 0}, {5, 0}}), "");
  EXPECT_EQ(
      gap_rejection(*make_obstacle({"sqrt(25-x^2)", ""}), {{3, 0}, {6, 1}}),
      "Obstacle/Gap = sqrt(25-x^2) is not a number at (6, 1) mm of the contact surface: allowed is a finite "
      "number (mm)");
  EXPECT_EQ(
      gap_rejection(*make_obstacle({"1/x", ""}), {{0, 1}}),
      "Obstacle/Gap = 1/x is infinite at (0, 1) mm of the contact surface: allowed is a finite number (mm)");
}
} // namespace orthocone::test
