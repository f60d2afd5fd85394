// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/contact/problem/convergence.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace orthocone::test
{
namespace
{
constexpr double stop = 1e-10;
constexpr double rounding = 1e-14;
const double infinity = std::numeric_limits<double>::infinity();

std::vector<TracePoint> trace_of(const std::function<double(unsigned int)> &residual,
                                 const std::function<double(unsigned int)> &force)
{
  std::vector<TracePoint> points;
  for (unsigned int i = 0; i <= 1000; i += 10)
    points.push_back({i, residual(i), force(i), 0});
  return points;
}

std::vector<TracePoint> trace_of(const std::function<double(unsigned int)> &residual)
{
  return trace_of(residual, [](unsigned int) { return 1.; });
}
} // namespace

TEST(Convergence, JudgesByTheTrend)
{
  const auto falling = [](const unsigned int i) { return std::pow(0.99, i); };
  const auto standing = [](const unsigned int i) { return 0.1 + 0.05 * std::sin(i); };
  EXPECT_EQ(judge(trace_of(falling), 1e-3, rounding), Verdict::converged);
  EXPECT_EQ(judge(trace_of(falling), stop, rounding), Verdict::slow);
  const auto creeping = [](const unsigned int i) { return 0.1 - 1e-6 * i; };
  EXPECT_EQ(judge(trace_of(standing), stop, rounding), Verdict::cycling);
  EXPECT_EQ(judge(trace_of([](unsigned int) { return 0.1; }), stop, rounding), Verdict::cycling);
  EXPECT_EQ(judge(trace_of(creeping), stop, rounding), Verdict::slow);
  EXPECT_EQ(judge(trace_of(standing, [](const unsigned int i) { return std::pow(1.01, i); }), stop, rounding),
            Verdict::diverged);
  const auto lost = [](const unsigned int i) { return i < 1000 ? 0.1 : infinity; };
  EXPECT_EQ(judge(trace_of(lost), stop, rounding), Verdict::diverged);
}

TEST(Convergence, TellsRoundingFromCycling)
{
  const auto stopping = [](const unsigned int i) { return std::max(std::pow(0.9, i), 2e-14); };
  EXPECT_EQ(judge(trace_of(stopping), 1e-15, 1e-13), Verdict::rounding);
  EXPECT_EQ(judge(trace_of(stopping), 1e-15, 1e-14), Verdict::cycling);
}

TEST(Convergence, CountsTheIterationsThatAreMissing)
{
  const auto falling = [](const unsigned int i) { return std::pow(0.99, i); };
  const double all = std::log(stop) / std::log(0.99);
  EXPECT_NEAR(iterations_to_go(trace_of(falling), stop), all - 1000, 2);
  EXPECT_EQ(iterations_to_go(trace_of([](unsigned int) { return 0.1; }), stop), 0);
}

TEST(Convergence, SaysNothingOfWhatItDidNotSee)
{
  EXPECT_EQ(judge({}, stop, rounding), Verdict::slow);
  EXPECT_EQ(judge({{0, 1, 1, 0}}, stop, rounding), Verdict::slow);
  EXPECT_EQ(iterations_to_go({}, stop), 0);
}
} // namespace orthocone::test
