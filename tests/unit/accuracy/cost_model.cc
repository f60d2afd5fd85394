// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/accuracy/cost_model.h>
#include <orthocone/base/errors.h>
#include <orthocone/body/backends/stiffness_factor.h>

#include "body/even_mesh.h"

#include <gtest/gtest.h>

namespace orthocone::test
{
TEST(Estimate, OfTheSizeAloneIsAtMostThatOfTheMesh)
{
  Parameters parameters;
  for (const unsigned int layers : {2, 8})
  {
    parameters.mesh.layers = layers;
    const SymmetryPlanes quarter{true, true};
    const Body body(parameters, quarter);
    EXPECT_LE(CostModel(parameters, quarter).least().gigabytes,
              CostModel(parameters, quarter).condensed(body).gigabytes);
  }
}

/// A step that wears deep is solved with a compliance of its own beside W.
TEST(Estimate, HasTheSecondMatrixOfDeepSteps)
{
  const SymmetryPlanes quarter{true, true};
  Parameters parameters;
  const Body body(parameters, quarter);
  const double dry = CostModel(parameters, quarter).condensed(body).gigabytes;
  parameters.wear.law = "archard";
  const double rows = 3 * model_size(parameters, quarter).contact_nodes;
  EXPECT_GE(CostModel(parameters, quarter).condensed(body).gigabytes - dry, 8e-9 * rows * rows);
  parameters.wear.deep_steps = DeepWear::explicitly;
  EXPECT_EQ(CostModel(parameters, quarter).condensed(body).gigabytes, dry);
}

TEST(Estimate, OfAUsualMachineIsNearThatOfTheFactorization)
{
  const SymmetryPlanes quarter{true, true};
  Parameters parameters;
  for (const auto &[degree, refinements] : {std::pair{2U, 2U}, {3U, 2U}, {1U, 3U}})
  {
    parameters.mesh = even_mesh(degree, refinements);
    const double expected = CostModel(parameters, quarter).condensed(Body(parameters, quarter)).gigabytes;
    const double usual = CostModel(parameters, quarter).usual().gigabytes;
    EXPECT_NEAR(usual / expected, 1, 0.25) << "degree " << degree;
  }
}

TEST(MemoryNeed, KnowsWithoutMeshingWhatCannotBeCounted)
{
  Parameters parameters;
  EXPECT_NO_THROW(CostModel(parameters, SymmetryPlanes{}).require_countable());
  parameters.mesh.core_cells = 200; // 2^31 numbers are the compliance of 15446 nodes
  EXPECT_THROW(CostModel(parameters, SymmetryPlanes{}).require_countable(), TooLargeError);
  EXPECT_TRUE(is_too_large(parameters, SymmetryPlanes{}, 1e9));
  EXPECT_THROW(require_memory(parameters, SymmetryPlanes{}, {1e9, "a machine of a test has"}), TooLargeError);
  parameters.mesh.core_cells = 16;
  parameters.mesh.degree = 3;
  parameters.mesh.layers = 200; // few contact nodes below many layers
  EXPECT_THROW(CostModel(parameters, SymmetryPlanes{}).require_countable(), TooLargeError);
}
} // namespace orthocone::test
