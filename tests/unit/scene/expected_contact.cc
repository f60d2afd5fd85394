// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/expected_contact.h>

#include <orthocone/base/numbers.h>
#include <orthocone/scene/parameters.h>

#include "scene/parameter_files.h"

#include <gtest/gtest.h>

#include <cmath>

namespace orthocone::test
{
namespace
{
/// A scene with these entries besides the defaults.
Parameters scene_with(const std::vector<std::string> &entries)
{
  const Folder folder;
  return read_parameters(folder.write("scene.prm", "subsection Geometry\n  set Radius = 10\nend\n"), entries);
}

constexpr double modulus = 210000 / (1 - 0.3 * 0.3);
} // namespace

TEST(ExpectedContact, OfASphereIsThatOfHertz)
{
  const auto contact = expected_contact(scene_with(
      {"Obstacle/Gap=((x-1)^2+y^2)/(2*100)", "Load program/Preload=Fz -250 : 1", "Load program/Legs="}));
  ASSERT_TRUE(contact);
  const double a = std::cbrt(3 * 250 * 100 / (4 * modulus));
  EXPECT_NEAR(contact->half_widths[0], a, 1e-6 * a);
  EXPECT_NEAR(contact->half_widths[1], a, 1e-6 * a);
  EXPECT_NEAR(contact->pressure, 3 * 250 / (2 * pi * a * a), 1e-5 * contact->pressure);
  EXPECT_NEAR(contact->centre[0], 1, 1e-6);
  EXPECT_FALSE(contact->is_line());
  EXPECT_TRUE(contact->contains({1 + 0.99 * a, 0}));
  EXPECT_FALSE(contact->contains({1, 1.01 * a}));
}

// K. L. Johnson, Contact Mechanics, 1985, table of section 4.2: for R_2/R_1 = 10 the axes differ 4.68-fold
// (10^(2/3) = 4.64).
TEST(ExpectedContact, OfAnEllipsoidIsLongWhereTheGapIsFlat)
{
  const auto contact = expected_contact(scene_with(
      {"Obstacle/Gap=x^2/(2*200)+y^2/(2*20)", "Load program/Preload=Fz -100 : 1", "Load program/Legs="}));
  ASSERT_TRUE(contact);
  EXPECT_NEAR(contact->radii[0], 20, 1e-6);
  EXPECT_NEAR(contact->radii[1], 200, 1e-4);
  EXPECT_NEAR(std::abs(contact->first_axis[1]), 1, 1e-6);
  EXPECT_NEAR(contact->half_widths[1] / contact->half_widths[0], 4.68, 0.06);
}

TEST(ExpectedContact, OfARollerIsALine)
{
  const auto contact = expected_contact(
      scene_with({"Geometry/Shape=box", "Geometry/Kind=plane strain", "Geometry/Sizes=20, 5, 10",
                  "Obstacle/Gap=x^2/(2*50)", "Load program/Preload=Fz -500 : 1", "Load program/Legs="}));
  ASSERT_TRUE(contact);
  const double b = std::sqrt(4 * 100 * 50 / (pi * modulus)); // 500 N on 5 mm
  EXPECT_TRUE(contact->is_line());
  EXPECT_NEAR(contact->half_widths[0], b, 1e-6 * b);
  EXPECT_NEAR(contact->pressure, 2 * 100 / (pi * b), 1e-5 * contact->pressure);
}

TEST(ExpectedContact, OfAMotionHasTheForceOfItsApproach)
{
  // A body so low that all of the motion is the contact's: delta = a^2/R.
  const auto contact =
      expected_contact(scene_with({"Geometry/Height=1e-4", "Obstacle/Gap=(x^2+y^2)/(2*100)+0.002",
                                   "Load program/Preload=0 0 -0.003 : 1", "Load program/Legs="}));
  ASSERT_TRUE(contact);
  EXPECT_NEAR(contact->half_widths[0], std::sqrt(100 * 0.001), 1e-3);
}

TEST(ExpectedContact, IsNotClaimedWhereNothingTellsIt)
{
  EXPECT_FALSE(expected_contact(scene_with({})));                             // flat
  EXPECT_FALSE(expected_contact(scene_with({"Obstacle/Gap=-x^2/200"})));      // an edge touches
  EXPECT_FALSE(expected_contact(scene_with({"Obstacle/Gap=(x^2+y^2)/2e9"}))); // all of the base touches
}

TEST(Resolution, PutsItsCellsWhereContactIsExpected)
{
  const Parameters sphere = scene_with({"Obstacle/Gap=(x^2+y^2)/(2*100)", "Load program/Preload=Fz -250 : 1",
                                        "Load program/Legs=", "Mesh/Resolution=coarse"});
  const double reach = contact_reach(sphere);
  const double a = expected_contact(sphere)->half_widths[0];
  for (const bool is_axisymmetric : {false, true})
  {
    const MeshOptions mesh = resolved_mesh(sphere, is_axisymmetric);
    const double half_side = mesh.core_ratio * sphere.geometry.radius / std::sqrt(2.);
    EXPECT_GE(half_side, reach * (1 - 1e-12)) << "the core encloses the contact";
    EXPECT_GT(2 * a / (2 * half_side / mesh.core_cells) * mesh.degree, 12) << "node spacings across it";
    EXPECT_GT(mesh.rim_grading, 1) << "rings grow outwards";
    EXPECT_LT(mesh.layer_grading, 1);
  }
  const Parameters plane = scene_with({"Mesh/Resolution=coarse"});
  EXPECT_EQ(contact_reach(plane), 0);
  EXPECT_LT(resolved_mesh(plane, false).rim_grading, 1) << "where all touches, cells shrink towards the rim";
}
} // namespace orthocone::test
