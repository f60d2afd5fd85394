// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/entries/formula.h>

#include <orthocone/base/errors.h>

#include <gtest/gtest.h>

#include <cmath>

namespace orthocone::test
{
namespace
{
const Formula::Names six{{"s", "w", "p", "v", "k", "n"}};
} // namespace

TEST(Formulas, HaveSixNames)
{
  const Formula formula("s + 10*w + 100*p + 1000*v + 1e4*k + 1e5*n", six);
  EXPECT_EQ(formula.value({{1, 2, 3, 4, 5, 6}}), 654321);
  EXPECT_EQ(formula.value({{6, 5, 4, 3, 2, 1}}), 123456); // the last two are read anew
  const Formula copy = formula;
  EXPECT_EQ(copy.value({{1, 2, 3, 4, 5, 6}}), 654321);
  EXPECT_EQ(formula.value({{1, 2, 3, 4, 5, 7}}), 754321);
  EXPECT_TRUE(std::isnan(Formula("sqrt(-w)", six).value({{0, 1, 0, 0, 0, 0}})));
  EXPECT_DOUBLE_EQ(Formula("cos(pi*s)", six).value({{1, 0, 0, 0, 0, 0}}), -1);
}

TEST(Formulas, KnowWhatTheyContain)
{
  const Formula formula("1 + exp(-w/3) + max(p, 0)", six);
  for (std::size_t name = 0; name < Formula::n_names; ++name)
    EXPECT_EQ(formula.has(name), name == 1 || name == 2);
  EXPECT_FALSE(formula.is_constant());
  EXPECT_TRUE(Formula("exp(1)*pi", six).is_constant());
  EXPECT_TRUE(Formula("2.5", six).is_constant());
}

TEST(Formulas, OfOtherNamesAreRefused)
{
  for (const char *const text : {"x", "s*t", "", "s,w", "rand()", "s +", "n = 2"})
    EXPECT_THROW(Formula(text, six), InputError) << text;
}
} // namespace orthocone::test
