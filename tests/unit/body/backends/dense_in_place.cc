// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "body/backends/dense_in_place.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace orthocone::test
{
using Eigen::Index;
using Eigen::MatrixXd;

// Sizes below, at and beyond those of tiles.
TEST(DenseInPlace, TheUpperHalfMirrorsTheLowerOne)
{
  for (const Index n : {1, 2, 63, 64, 65, 200})
  {
    const MatrixXd random = MatrixXd::Random(n, n);
    MatrixXd matrix = random;
    mirror_lower_half(matrix);
    EXPECT_EQ(matrix, MatrixXd(random.selfadjointView<Eigen::Lower>())) << n;
  }
}

// Permutations of one long cycle, of many cycles, and of none.
TEST(DenseInPlace, RowsAndColumnsGoWhereTheyShould)
{
  constexpr Index n = 50;
  const MatrixXd random = MatrixXd::Random(n, n);
  std::vector<Index> targets(n);
  std::iota(targets.begin(), targets.end(), 0);
  std::mt19937 numbers(3);
  for (int round = 0; round < 4; ++round)
  {
    MatrixXd matrix = random;
    move_rows_and_columns(matrix, targets);
    for (Index j = 0; j < n; ++j)
      for (Index i = 0; i < n; ++i)
        ASSERT_EQ(matrix(targets[i], targets[j]), random(i, j)) << round;
    if (round == 0)
      std::rotate(targets.begin(), targets.begin() + 1, targets.end());
    else
      std::shuffle(targets.begin(), targets.end(), numbers);
  }
}
} // namespace orthocone::test
