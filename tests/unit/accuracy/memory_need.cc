// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/accuracy/estimate.h>
#include <orthocone/accuracy/memory_need.h>
#include <orthocone/base/errors.h>
#include <orthocone/body/backends/stiffness_factor.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
TEST(MemoryNeed, KnowsWithoutMeshingWhatCannotBeCounted)
{
  Parameters parameters;
  EXPECT_NO_THROW(require_countable(model_size(parameters, SymmetryPlanes{})));
  parameters.mesh.core_cells = 200; // 2^31 numbers are the compliance of 15446 nodes
  EXPECT_THROW(require_countable(model_size(parameters, SymmetryPlanes{})), TooLargeError);
  EXPECT_TRUE(is_too_large(parameters, SymmetryPlanes{}, 1e9));
  EXPECT_THROW(require_memory(parameters, SymmetryPlanes{}, {1e9, "a machine of a test has"}), TooLargeError);
  parameters.mesh.core_cells = 16;
  parameters.mesh.degree = 3;
  parameters.mesh.layers = 200; // few contact nodes below many layers
  EXPECT_THROW(require_countable(model_size(parameters, SymmetryPlanes{})), TooLargeError);
}
} // namespace orthocone::test
