// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "rejection.h"

#include <orthocone/scene/parameters.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
namespace
{
Parameters box()
{
  Parameters parameters;
  parameters.geometry.shape = BodyShape::box;
  parameters.mesh.edge_grading = parameters.mesh.layer_grading = 0.5;
  return parameters;
}

std::string check_rejection(const Parameters &parameters)
{
  return rejection_of([&] { check_parameters(parameters); });
}
} // namespace

TEST(BoxChecks, TakeADefaultBox)
{
  EXPECT_EQ(check_rejection(box()), "");
  EXPECT_TRUE(parameter_warnings(box()).empty());
}

TEST(BoxChecks, LeaveTheMeshToItsCells)
{
  Parameters parameters = box();
  parameters.mesh.accuracy = 2;
  EXPECT_EQ(check_rejection(parameters),
            "Mesh/Accuracy = 2 % with Geometry/Shape = box: allowed is 0; Mesh/Cells "
            "chooses the mesh of a box");
  parameters = box();
  parameters.mesh.resolution = MeshResolution::fine;
  EXPECT_EQ(check_rejection(parameters),
            "Mesh/Resolution = fine with Geometry/Shape = box: allowed is custom; "
            "Mesh/Cells chooses the mesh of a box");
  parameters = box();
  parameters.mesh.edge_grading = 0.01;
  EXPECT_EQ(check_rejection(parameters), "Mesh/Edge grading = 0.01 with 8 cells along x: allowed is a value "
                                         "that leaves every cell at least 1e-6 of the side");
}

TEST(BoxChecks, WantProbesOnTheRectangle)
{
  Parameters parameters = box();
  parameters.geometry.sizes = {{30, 8, 10}};
  parameters.output.probes = {{"Corner", {{15, -4}}}};
  EXPECT_EQ(check_rejection(parameters), "");
  parameters.output.probes = {{"Far", {{0, 5}}}};
  EXPECT_EQ(check_rejection(parameters),
            "Output/Probes: 'Far' at (0, 5) is off the contact surface: allowed are "
            "|x| <= 15 and |y| <= 4, halves of Geometry/Sizes");
}

TEST(BoxChecks, DoNotLetTheLoadPressItFlat)
{
  Parameters parameters = box();
  parameters.geometry.sizes[2] = 0.1;
  EXPECT_EQ(check_rejection(parameters),
            "Load program/Legs: u_z = -0.1 mm presses the body flat: allowed is more "
            "than -l_z of Geometry/Sizes = -0.1 mm");
}

TEST(BoxChecks, WarnOfCoarseRimsStrainsAndIgnoredEntries)
{
  Parameters parameters = box();
  parameters.mesh.edge_grading = 1;
  parameters.mesh.degree = 1;
  auto warnings = parameter_warnings(parameters);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].rfind("Mesh: elements of degree 1 and 25 % of half the shorter side do not", 0), 0u);
  parameters = box();
  parameters.geometry.sizes[2] = 1;
  warnings = parameter_warnings(parameters);
  ASSERT_FALSE(warnings.empty());
  EXPECT_NE(warnings[0].find("0.1 mm on l_z of Geometry/Sizes = 1 mm is a strain of 10 %"),
            std::string::npos);
  parameters = box();
  parameters.geometry.radius = 5;
  warnings = parameter_warnings(parameters);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0], "Geometry/Radius = 5 is ignored with Geometry/Shape = box");
}
} // namespace orthocone::test
