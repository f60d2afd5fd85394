// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/mortar.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
using Eigen::Index;
using Eigen::MatrixXd;

/// Fewer rows than are mapped at a time, as many, and some more.
TEST(MappedCompliance, IsTheProductAndSymmetricToTheLastBit)
{
  std::srand(1);
  for (const Index n : {3, 16, 41})
  {
    const Index m = n + 7;
    const MatrixXd factor = MatrixXd::Random(m, m), compliance = factor * factor.transpose();
    MatrixXd map = MatrixXd::Random(n, m);
    map = (map.array().abs() < 0.3).select(map, 0).eval();
    const MatrixXd mapped = mapped_compliance(map.sparseView(), DenseView(compliance.data(), m, m));
    const MatrixXd expected = map * compliance * map.transpose();
    EXPECT_EQ((mapped - mapped.transpose()).lpNorm<Eigen::Infinity>(), 0);
    EXPECT_LE((mapped - expected).norm(), 1e-14 * compliance.norm());
  }
}
} // namespace orthocone::test
