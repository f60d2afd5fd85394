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

// Whatever a message quotes, it fits a terminal, and both its ends are there.
TEST(Messages, AreBoundedAndPrintable)
{
  EXPECT_EQ(shown_message("orthocone: a.prm: is empty\nsecond line"),
            "orthocone: a.prm: is empty\nsecond line");
  const std::string text =
      shown_message("orthocone: " + std::string(100000, 'x') + ": allowed is less\nsecond");
  EXPECT_LE(text.size(), 600 + std::string("\nsecond").size());
  EXPECT_EQ(text.find("orthocone: xxx"), 0u);
  EXPECT_NE(text.find("x: allowed is less\nsecond"), std::string::npos);
  EXPECT_EQ(shown_message("a\x1b[31mb\xff"), "a\\x1b[31mb\\xff");
  std::string umlauts;
  for (unsigned int i = 0; i < 1000; ++i)
    umlauts += "\xc3\xa4";
  EXPECT_EQ(shown_message(umlauts).find("\\x"), std::string::npos) << "no character is cut";
}
} // namespace orthocone::test
