// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/grading.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
TEST(Grading, MakesEachIntervalAMultipleOfTheOneBefore)
{
  const auto x = graded_positions(4, 0.5);
  ASSERT_EQ(x.size(), 5u);
  EXPECT_EQ(x.front(), 0);
  EXPECT_EQ(x.back(), 1);
  for (unsigned int i = 1; i < 4; ++i)
    EXPECT_NEAR((x[i + 1] - x[i]) / (x[i] - x[i - 1]), 0.5, 1e-14);
  EXPECT_NEAR(last_share(4, 0.5), x[4] - x[3], 1e-15);
  EXPECT_NEAR(thinnest_share(4, 0.5), x[4] - x[3], 1e-15);
  EXPECT_NEAR(thinnest_share(4, 2), x[4] - x[3], 1e-15);
  EXPECT_NEAR(last_share(4, 2), x[1] - x[0], 1e-15);
}

TEST(Grading, IsTheSameTowardsBothEnds)
{
  for (const unsigned int n : {1, 2, 5, 6})
  {
    const auto z = positions_graded_to_both_ends(7, n, 0.8);
    ASSERT_EQ(z.size(), n + 1);
    EXPECT_EQ(z.front(), 0);
    EXPECT_EQ(z.back(), 7);
    for (unsigned int i = 0; i <= n; ++i)
      EXPECT_NEAR(z[i] + z[n - i], 7, 1e-14);
    for (unsigned int i = 1; i < n / 2; ++i)
      EXPECT_NEAR((z[i] - z[i - 1]) / (z[i + 1] - z[i]), 0.8, 1e-14);
    EXPECT_NEAR(7 * end_share(n, 0.8), z[1] - z[0], 1e-14);
  }
}
} // namespace orthocone::test
