// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "rejection.h"

#include <orthocone/scene/model_choice.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
namespace
{
Parameters box(const unsigned int nx, const unsigned int ny)
{
  Parameters parameters;
  parameters.geometry.shape = BodyShape::box;
  parameters.mesh.cells = {{nx, ny, 2}};
  parameters.friction.mu = {{0.3, 0.3}};
  return parameters;
}

std::string model_rejection(const Parameters &parameters)
{
  return rejection_of([&] { choose_model(parameters); });
}
} // namespace

TEST(BoxModel, IsTheSmallestWhoseCellsEndAtThePlanes)
{
  EXPECT_EQ(choose_model(box(4, 6)).symmetry.name(), "quarter");
  EXPECT_EQ(choose_model(box(3, 6)).symmetry.name(), "half");
  EXPECT_EQ(choose_model(box(3, 6)).reason, "Mesh/Cells has an odd number along x, 3");
  EXPECT_EQ(choose_model(box(3, 5)).symmetry.name(), "full");
}

TEST(BoxModel, IsNeverRevolved)
{
  Parameters parameters = box(4, 4);
  parameters.mesh.model = ModelKind::axisymmetric;
  EXPECT_EQ(model_rejection(parameters),
            "Mesh/Model = axisymmetric is not possible: Geometry/Shape = box is no body "
            "of revolution; possible models are full, half, quarter");
}
} // namespace orthocone::test
