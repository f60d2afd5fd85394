// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/contact_mesh.h>

#include <orthocone/scene/parameters.h>

#include "scene/parameter_files.h"

#include <gtest/gtest.h>

#include <cmath>

namespace orthocone::test
{
TEST(Resolution, PutsItsCellsWhereContactIsExpected)
{
  const Parameters sphere =
      parameters_with({"Obstacle/Gap=(x^2+y^2)/(2*100)", "Load program/Preload=Fz -250 : 1",
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
  const Parameters plane = parameters_with({"Mesh/Resolution=coarse"});
  EXPECT_EQ(contact_reach(plane), 0);
  EXPECT_LT(resolved_mesh(plane, false).rim_grading, 1) << "where all touches, cells shrink towards the rim";
}

TEST(Layers, AreWarnedOfWhereTheyAreTooHighForTheContact)
{
  const std::vector<std::string> sphere{"Obstacle/Gap=(x^2+y^2)/(2*100)", "Load program/Preload=Fz -250 : 1",
                                        "Load program/Legs=", "Mesh/Layers=2"}; // of 5 mm over one of 0.43 mm
  const auto warnings_with = [&](std::vector<std::string> entries)
  {
    entries.insert(entries.begin(), sphere.begin(), sphere.end());
    return layer_warnings(parameters_with(entries));
  };
  ASSERT_EQ(warnings_with({}).size(), 1u);
  EXPECT_NE(warnings_with({}).front().find("is 5 mm high"), std::string::npos);
  EXPECT_EQ(warnings_with({"Mesh/Refinements=2"}).size(), 0u) << "1.25 mm";
  EXPECT_EQ(warnings_with({"Mesh/Layers=10", "Mesh/Layer grading=0.7"}).size(), 0u);
  EXPECT_EQ(warnings_with({"Obstacle/Gap=0"}).size(), 0u);
}
} // namespace orthocone::test
