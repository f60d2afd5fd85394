// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/contact/solvers/diagnosis.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace orthocone::test
{
namespace
{
SolverReport report(const Verdict verdict, const double factor = 1)
{
  SolverReport report;
  report.verdict = verdict;
  for (unsigned int i = 0; i <= 100; i += 10)
    report.trace.add(i, std::pow(factor, i), 1);
  report.residual = report.trace.points().back().residual;
  return report;
}

void expect_words(const SolverReport &report, const ContactSolverOptions &options,
                  const std::vector<std::string> &words, const bool is_dense = true)
{
  const std::string text = diagnosis(options, report, is_dense);
  for (const std::string &word : words)
    EXPECT_NE(text.find(word), std::string::npos) << text;
}
} // namespace

TEST(Diagnosis, SaysHowTheIterationFailedAndWhatToTry)
{
  const ContactSolverOptions newton;
  ContactSolverOptions uzawa;
  uzawa.method = "uzawa";
  expect_words(report(Verdict::cycling), newton, {"cycles", "smaller load steps"});
  expect_words(report(Verdict::cycling), uzawa, {"cycles", "Method = newton"});
  expect_words(report(Verdict::diverged), uzawa, {"grow without bound", "Method = newton"});
  expect_words(report(Verdict::rounding), newton, {"Rounding", "larger Contact solver/Tolerance"});
  SolverReport lost = report(Verdict::diverged);
  lost.residual = std::numeric_limits<double>::infinity();
  expect_words(lost, newton, {"no longer numbers", "lengths in mm"});
}

TEST(Diagnosis, NamesTheFrictionOfTheFirstFold)
{
  SolverReport folded = report(Verdict::several);
  folded.folds = {74, 0.1949};
  expect_words(
      folded, {},
      {"Several solutions near here", "first at 0.19 of the friction", "74 times", "below 0.19 of these"});
}

TEST(Diagnosis, NamesOnlyWhatABodyWithoutADenseComplianceHas)
{
  for (const Verdict verdict : {Verdict::cycling, Verdict::slow, Verdict::diverged})
  {
    expect_words(report(verdict), {}, {"Mesh/Backend = condensed"}, false);
    EXPECT_EQ(diagnosis({}, report(verdict), false).find("gauss-seidel"), std::string::npos);
  }
  ContactSolverOptions few;
  few.maximum_iterations = 2;
  expect_words(report(Verdict::slow), few, {"Maximum iterations"}, false);
}

// 0.9^i reaches the tolerance of 1e-10 after ln(1e-10)/ln(0.9) = 218.5 iterations.
TEST(Diagnosis, TellsHowManyIterationsWouldDo)
{
  expect_words(report(Verdict::slow, 0.9), {}, {"still fell", "some 219 for each part"});
  expect_words(report(Verdict::slow), {}, {"too few iterations to say", "Maximum iterations."});
}
} // namespace orthocone::test
