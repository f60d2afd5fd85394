// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/entries/expression.h>

#include <orthocone/base/errors.h>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <sstream>
#include <thread>

namespace orthocone::test
{
namespace
{
/// What is wrong with a text, or "".
std::string fault(const std::string &text)
{
  try
  {
    Expression{text};
    return {};
  }
  catch (const InputError &error)
  {
    return error.what();
  }
}
} // namespace

TEST(Expressions, AreEvaluatedWhereTheyAreAsked)
{
  EXPECT_EQ(Expression("-2.5e1").value(7, 8), -25);
  EXPECT_DOUBLE_EQ(Expression("(x^2+y^2)/(2*1000)").value(3, 4), 0.0125);
  EXPECT_DOUBLE_EQ(Expression("atan2(y,x)*180/pi").value(0, 2), 90);
  EXPECT_EQ(Expression("if (x > 1, 2, y)").value(0, 5), 5);
  EXPECT_EQ(Expression("x == 2 ? 1 : 3").value(2, 0), 1);
  EXPECT_TRUE(std::isnan(Expression("sqrt(x)").value(-1, 0)));
}

TEST(Expressions, KnowWhetherTheyVary)
{
  for (const char *const constant : {"0.3", "1/3", "exp(1)", "max(1,2)*pi"})
    EXPECT_TRUE(Expression(constant).is_constant()) << constant;
  for (const char *const varying : {"x", "0.3+0.1*y", "exp(x)", "(y)", "1-x"})
    EXPECT_FALSE(Expression(varying).is_constant()) << varying;
}

TEST(Expressions, CanBeCopiedAndAskedByOtherThreads)
{
  const Expression copy = Expression("x+2*y");
  double value = 0;
  std::thread([&] { value = copy.value(1, 2); }).join();
  EXPECT_EQ(value, 5);
  EXPECT_EQ(copy.text(), "x+2*y");
}

TEST(Expressions, TellWhatIsWrongInThem)
{
  EXPECT_EQ(fault(""), "it is empty");
  EXPECT_EQ(fault("foo(x)"), "'foo' is not known");
  EXPECT_EQ(fault("r^2"), "'r' is not known");
  EXPECT_EQ(fault("2x"), "'x' needs an operator before it");
  EXPECT_EQ(fault("(x"), "a ')' is missing");
  EXPECT_EQ(fault("x)"), "')' is not expected where it is");
  EXPECT_EQ(fault("x^"), "it ends too early");
  EXPECT_EQ(fault("atan2(x)"), "'atan2' has too few arguments");
  EXPECT_EQ(fault("x 2"), "'2' needs an operator before it");
  EXPECT_EQ(fault("x sin(y)"), "'sin' needs an operator before it");
  EXPECT_EQ(fault("*x"), "'*' has nothing before it");
  EXPECT_EQ(fault("sin(x,y)"), "'sin' has too many arguments");
  EXPECT_EQ(fault("x<1 ? 2"), "a '?' has no ':'");
  EXPECT_EQ(fault("nan"), "'nan' is not known");
  EXPECT_EQ(fault(std::string(1001, 'x')), "it is longer than 1000 characters");
}

TEST(Expressions, RefuseWhatTheLibraryTakesButNobodyMeans)
{
  EXPECT_EQ(fault("x=2"), "'=' is no comparison; '==' is one");
  EXPECT_EQ(fault("1,2"), "a ',' stands outside of parentheses");
  EXPECT_EQ(fault("1;2"), "';' is not allowed in it");
  EXPECT_EQ(fault("rand()"), "random numbers are not allowed in it");
  EXPECT_EQ(fault("1+\n2"), "'\\n' is not allowed in it");
  for (const char *const fine : {"x<=1", "x>=1", "x!=1", "x==1"})
    EXPECT_EQ(fault(fine), "") << fine;
}

TEST(Expressions, KeepTheLibraryFromTheScreen)
{
  const std::ostringstream screen;
  auto *const before = std::cerr.rdbuf(screen.rdbuf());
  const std::string message = fault("foo(x)");
  std::cerr.rdbuf(before);
  EXPECT_NE(message, "");
  EXPECT_EQ(screen.str(), "");
}
} // namespace orthocone::test
