// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/contact/law/rosette.h>

#include "contact/contact_problems.h"
#include "contact/laws.h"

#include <orthocone/base/numbers.h>
#include <orthocone/contact/law/one_node.h>
#include <orthocone/contact/problem/law_errors.h>

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <random>

namespace orthocone::test
{
namespace
{
using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

using Coefficient = std::function<double(double)>;

Vector2d towards(const double angle)
{
  return {std::cos(angle), std::sin(angle)};
}

/// Rows at n even angles, of which the first one is not 0, in an order of no meaning.
std::vector<Rosette::Row> sampled(const unsigned int n, const Coefficient &along, const Coefficient &across)
{
  std::vector<Rosette::Row> rows;
  for (unsigned int i = 0; i < n; ++i)
  {
    const double angle = 2 * pi * ((7 * i) % n + 0.3) / n;
    rows.push_back({angle, along(angle), across(angle)});
  }
  return rows;
}

FrictionLaw law_of(std::vector<Rosette::Row> rows)
{
  return FrictionLaw(std::make_shared<const Rosette>(std::move(rows)));
}

/// The table of a law: the force against slip along -e(a), along and across e(a).
FrictionLaw sampled_from(const FrictionLaw &law, const unsigned int n)
{
  const auto along = [&](const double a) { return law.force_against(-towards(a)).dot(towards(a)); };
  const auto across = [&](const double a) { return law.force_against(-towards(a)).dot(towards(a + pi / 2)); };
  return law_of(sampled(n, along, across));
}

/// A law without centre, chirality or convexity, which is well posed.
double ratchet(const double a)
{
  return 0.25 * (1 + 0.4 * std::cos(a - 0.5) + 0.2 * std::cos(3 * a));
}

double sideways(const double a)
{
  return 0.06 * (1 + std::sin(2 * a));
}

FrictionLaw measured()
{
  return law_of(sampled(360, ratchet, sideways));
}

std::string refusal(const std::vector<Rosette::Row> &rows)
{
  try
  {
    const Rosette rosette(rows);
  }
  catch (const std::invalid_argument &error)
  {
    return error.what();
  }
  return {};
}

Vector2d force_of(const Rosette::Row &row)
{
  return row.along * towards(row.angle) + row.across * towards(row.angle + pi / 2);
}

/// Of rows in the order of their angles.
bool are_good_along_chords(const std::vector<Rosette::Row> &rows)
{
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const Rosette::Row &row = rows[i], &next = rows[(i + 1) % rows.size()];
    const Vector2d f = force_of(row), f_next = force_of(next), chord = f_next - f;
    const bool is_good = row.along > 0 && chord.dot(towards(row.angle + pi / 2)) > 0 &&
                         chord.dot(towards(next.angle + pi / 2)) > 0 && f[0] * f_next[1] > f[1] * f_next[0] &&
                         f.dot(towards(next.angle)) > 0 && f_next.dot(towards(row.angle)) > 0;
    if (!is_good)
      return false;
  }
  return true;
}

double nothing_across(const double)
{
  return 0;
}
} // namespace

// Gross sliding along 360 directions.
TEST(RosetteLaw, HasTheForcesOfItsRows)
{
  const FrictionLaw law = measured();
  for (unsigned int i = 0; i < 360; ++i)
  {
    const double a = 2 * pi * (i + 0.3) / 360;
    const Vector2d expected = ratchet(a) * towards(a) + sideways(a) * towards(a + pi / 2);
    EXPECT_LE((law.force_against(-3 * towards(a)) - expected).norm(), 1e-12);
    EXPECT_NEAR(
        std::remainder(std::atan2(law.slip_under(expected)[1], law.slip_under(expected)[0]) - a - pi, 2 * pi),
        0, 1e-12);
  }
}

TEST(RosetteLaw, IsTheCircleWhereItIsTheSameAllAround)
{
  const FrictionLaw law = law_of(sampled(
      8, [](double) { return 0.25; }, nothing_across));
  for (const double a : {0., 1., 2., 4.})
  {
    EXPECT_LE((law.force_against(towards(a)) + 0.25 * towards(a)).norm(), 1e-14);
    EXPECT_LE((law.reduced_slip(towards(a)) - 4 * towards(a)).norm(), 1e-13);
    EXPECT_LE((law.reduced_slip_derivative(towards(a)) - 4 * Matrix2d::Identity()).norm(), 1e-12);
  }
  EXPECT_NEAR(law.mean_friction(), 0.25, 1e-14);
}

// However few rows there are: between two of them directions and sizes are those of ellipses.
TEST(RosetteLaw, RepeatsTheEllipses)
{
  for (const auto &[ellipse, fewest] : {std::pair(case_a, 8U), {case_b, 8U}, {case_c, 12U}})
    for (const unsigned int n : {fewest, 36U, 360U})
    {
      const FrictionLaw law = sampled_from(ellipse, n);
      double error = 0;
      for (unsigned int i = 0; i < 1000; ++i)
      {
        const Vector2d slip = towards(2 * pi * i / 1000);
        error = std::max(error, (law.force_against(slip) - FrictionLaw(ellipse).force_against(slip)).norm());
      }
      EXPECT_LE(error, 1e-11 * std::max(ellipse.mu_x, ellipse.mu_y)) << n;
    }
}

// Rows at the same angles, whatever the axes of the law.
TEST(RosetteLaw, IsTheSameLawInTurnedAxes)
{
  constexpr unsigned int n_rows = 24;
  std::mt19937 generator(2);
  std::uniform_real_distribution<> turns(0, 2 * pi);
  for (const OrthotropicFriction &ellipse : {case_b, case_c})
    for (unsigned int i = 0; i < 1000; ++i)
    {
      const Matrix2d turn = Eigen::Rotation2Dd(turns(generator)).toRotationMatrix();
      const auto turned = [&](const Vector2d &slip)
      { return Vector2d(turn * FrictionLaw(ellipse).force_against(turn.transpose() * slip)); };
      const auto along = [&](const double a) { return turned(-towards(a)).dot(towards(a)); };
      const auto across = [&](const double a) { return turned(-towards(a)).dot(towards(a + pi / 2)); };
      const Rosette rosette(sampled(n_rows, along, across));
      const Vector2d slip = towards(turns(generator)), reduced = -rosette.reduced_slip(slip);
      EXPECT_LE((rosette.force(reduced.normalized()) - turned(slip)).norm(), 1e-11);
    }
}

// Where a law is no ellipse, with the fourth power of the step.
TEST(RosetteLaw, ConvergesToTheLawOfItsRows)
{
  std::vector<double> errors;
  for (const unsigned int n : {36, 72, 144, 288})
  {
    const FrictionLaw law = law_of(sampled(n, ratchet, sideways));
    double error = 0;
    for (unsigned int i = 0; i < 1000; ++i)
    {
      const double a = 2 * pi * i / 1000;
      const Vector2d expected = ratchet(a) * towards(a) + sideways(a) * towards(a + pi / 2);
      error = std::max(error, (law.force_against(-towards(a)) - expected).norm());
    }
    errors.push_back(error);
  }
  for (std::size_t i = 1; i < errors.size(); ++i)
    EXPECT_LE(errors[i], errors[i - 1] / 12) << errors[i];
}

// Rows that keep the conditions along straight lines from force to force have a law that keeps them.
TEST(RosetteLaw, KeepsTheConditionsOfItsRows)
{
  std::mt19937 generator(1);
  std::normal_distribution<> normal;
  std::uniform_real_distribution<> even(-0.3, 0.3);
  unsigned int n_good = 0;
  for (unsigned int trial = 0; trial < 600; ++trial)
  {
    const unsigned int n = 8 + trial % 30;
    std::array<std::array<double, 4>, 4> terms{};
    for (auto &waves : terms)
      for (std::size_t wave = 0; wave < waves.size(); ++wave)
        waves[wave] = 0.5 * normal(generator) / (1 + static_cast<double>(wave));
    const auto waves = [&](const std::size_t of, const double a)
    {
      double sum = 0;
      for (std::size_t k = 0; k < 4; ++k)
        sum += terms[of][k] * std::cos((k + 1) * a) + terms[of + 1][k] * std::sin((k + 1) * a);
      return sum;
    };
    std::vector<Rosette::Row> rows;
    for (unsigned int i = 0; i < n; ++i)
    {
      const double a = 2 * pi * (i + even(generator)) / n;
      rows.push_back({a, 0.3 + 0.2 * waves(0, a), 0.15 * waves(2, a)});
    }
    if (!are_good_along_chords(rows))
      continue;
    ++n_good;
    EXPECT_EQ(refusal(rows), "") << trial;
  }
  EXPECT_GT(n_good, 200);
}

TEST(RosetteLaw, HasTheDerivativesOfItsMaps)
{
  constexpr double step = 1e-6;
  const Rosette rosette(sampled(72, ratchet, sideways));
  for (unsigned int i = 0; i < 40; ++i)
  {
    const Vector2d at = (1 + 0.1 * i) * towards(0.37 * i);
    Matrix2d of_force, of_slip;
    for (int d = 0; d < 2; ++d)
    {
      const Vector2d way = step * Vector2d::Unit(d);
      of_force.col(d) = (rosette.reduced_force(at + way) - rosette.reduced_force(at - way)) / (2 * step);
      of_slip.col(d) = (rosette.reduced_slip(at + way) - rosette.reduced_slip(at - way)) / (2 * step);
    }
    EXPECT_LE((rosette.reduced_force_derivative(at) - of_force).norm(), 1e-7 * of_force.norm());
    EXPECT_LE((rosette.reduced_slip_derivative(at) - of_slip).norm(), 1e-6 * of_slip.norm());
    // The reduced slip keeps areas, up to the square of its factor.
    EXPECT_NEAR(std::abs(of_slip.determinant()), std::pow(rosette.reduced_slip_derivative({0, 0})(0, 0), 2),
                1e-6);
  }
}

TEST(RosetteLaw, IsSolvedAtANode)
{
  const FrictionLaw law = measured();
  OneNodeProblem problem;
  problem.compliance << 1, 0.1, -0.2, 0.1, 1.5, 0.3, -0.2, 0.3, 1.2;
  problem.compliance *= 1e-5;
  problem.stiffness = problem.compliance.inverse();
  const Vector3d none_before = Vector3d::Zero();
  unsigned int n_slips = 0;
  for (const Vector3d &q : directions())
  {
    const Vector3d r = solve_one_node(law, problem, q, none_before), d = q + problem.compliance * r;
    const double scale = r.norm() + 1e-3 * problem.stiffness.norm();
    EXPECT_LE(std::max(0., -d[0]), 1e-10);
    EXPECT_LE(law.load(r.tail<2>()), r[0] + 1e-10 * scale);
    if (r[0] <= 0 || d.tail<2>().norm() < 1e-9)
      continue;
    ++n_slips;
    const Vector2d expected = r[0] * law.force_against(d.tail<2>());
    EXPECT_LE((r.tail<2>() - expected).norm(), 1e-8 * scale);
    EXPECT_LT(r.tail<2>().dot(d.tail<2>()), 0) << "friction takes energy";
  }
  EXPECT_GT(n_slips, 20);
}

TEST(RosetteLaw, IsRefusedWhereItIsNotWellPosed)
{
  const auto quarter = [](double) { return 0.25; };
  EXPECT_EQ(refusal(sampled(7, quarter, nothing_across)), "has 7 rows: allowed are 8 and more");
  std::vector<Rosette::Row> twice = sampled(8, quarter, nothing_across);
  twice.push_back({twice[3].angle + 2 * pi, 0.25, 0});
  EXPECT_NE(refusal(twice).find("twice: allowed is a row for each angle"), std::string::npos);
  std::vector<Rosette::Row> half;
  for (unsigned int i = 0; i < 10; ++i)
    half.push_back({0.2 * i, 0.25, 0});
  EXPECT_NE(refusal(half).find("has no angle between 103.132 degrees and 360 degrees"), std::string::npos)
      << refusal(half);
  const auto starts = [&](const Coefficient &along, const Coefficient &across, const std::string &begin)
  { EXPECT_EQ(refusal(sampled(360, along, across)).compare(0, begin.size(), begin), 0) << begin; };
  starts([](const double a) { return 0.2 * std::cos(a) + 0.1; }, nothing_across, "mu_along is ");
  starts([](const double a) { return 0.2 - 0.06 * std::sin(4 * a); },
         [](const double a) { return 0.3 - 0.125 * std::sin(2 * a); },
         "kappa = mu_along + d mu_across/da is -0.0");
  starts([](const double a) { return 0.25 * (1 + 0.8 * std::cos(4 * a)); }, [](double) { return 0.2; },
         "the turn of the force, d b/da, is ");
  EXPECT_EQ(refusal(sampled(360, ratchet, sideways)), "");
}
} // namespace orthocone::test
