// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "body/even_mesh.h"
#include "rejection.h"

#include <orthocone/scene/model_choice.h>
#include <orthocone/scene/scene.h>

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

/// The bump lies between the nodes at which the model is chosen, off both planes.
TEST(Model, IsRefusedWhereSmallerCellsSeeThatTheSceneIsNotSymmetric)
{
  Parameters parameters;
  parameters.mesh = even_mesh(1, 0);
  parameters.obstacle.gap = "if((x-2.2)^2+(y-1.5)^2<0.5,0.01,0)";
  parameters.mesh.refined_cells = {{{0, 5}}, {{0, 47}}};
  const ModelChoice choice = choose_model(parameters);
  ASSERT_EQ(choice.symmetry.name(), "quarter");
  const std::string rejection = rejection_of([&] { Scene(parameters, choice); });
  EXPECT_NE(rejection.find("not as symmetric as its quarter model"), std::string::npos) << rejection;
  EXPECT_NE(rejection.find("allowed is Mesh/Model = full"), std::string::npos) << rejection;
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
