// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/text.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
TEST(Numbers, HaveOneSign)
{
  EXPECT_EQ(parse_number("+5"), 5);
  EXPECT_EQ(parse_number("-5e-3"), -5e-3);
  for (const char *const text : {"+-5", "-+5", "++5", "--5", "+", "-", "", "5-", "+ 5"})
    EXPECT_FALSE(parse_number(text)) << text;
}

TEST(Numbers, AreFiniteAndAllOfTheText)
{
  for (const char *const text : {"nan", "inf", "1e999", "0x10", "1,5", "5 ", "5mm"})
    EXPECT_FALSE(parse_number(text)) << text;
}

TEST(Counts, HaveNoSignAndFit)
{
  EXPECT_EQ(parse_count("4294967295"), 4294967295u);
  for (const char *const text : {"4294967296", "-1", "+1", "1.0", "1e3", ""})
    EXPECT_FALSE(parse_count(text)) << text;
}

TEST(Percentages, AreZeroOrHaveTheirSign)
{
  EXPECT_EQ(parse_percentage("0"), 0);
  EXPECT_EQ(parse_percentage("1.5 %"), 1.5);
  for (const char *const text : {"1.5", "%", "+-1 %", "1 %%"})
    EXPECT_FALSE(parse_percentage(text)) << text;
}
} // namespace orthocone::test
