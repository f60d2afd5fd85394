// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/accuracy/estimate.h>
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
    EXPECT_LE(least_estimate(model_size(parameters, quarter)).gigabytes,
              estimate(parameters, body, quarter).gigabytes);
  }
}

/// A step that wears deep is solved with a compliance of its own beside W.
TEST(Estimate, HasTheSecondMatrixOfDeepSteps)
{
  const SymmetryPlanes quarter{true, true};
  Parameters parameters;
  const Body body(parameters, quarter);
  const double dry = estimate(parameters, body, quarter).gigabytes;
  parameters.wear.law = WearKind::archard;
  const double rows = 3 * model_size(parameters, quarter).contact_nodes;
  EXPECT_GE(estimate(parameters, body, quarter).gigabytes - dry, 8e-9 * rows * rows);
  parameters.wear.deep_steps = DeepWear::explicitly;
  EXPECT_EQ(estimate(parameters, body, quarter).gigabytes, dry);
}

TEST(Estimate, OfAUsualMachineIsNearThatOfTheFactorization)
{
  const SymmetryPlanes quarter{true, true};
  Parameters parameters;
  for (const auto &[degree, refinements] : {std::pair{2U, 2U}, {3U, 2U}, {1U, 3U}})
  {
    parameters.mesh = even_mesh(degree, refinements);
    const double expected = estimate(parameters, Body(parameters, quarter), quarter).gigabytes;
    const double usual = usual_estimate(parameters, model_size(parameters, quarter), quarter).gigabytes;
    EXPECT_NEAR(usual / expected, 1, 0.25) << "degree " << degree;
  }
}
} // namespace orthocone::test
