// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/contact/law/law_path.h>

#include "contact/laws.h"

#include <orthocone/base/numbers.h>
#include <orthocone/contact/law/rosette.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
namespace
{
using Eigen::Vector2d;

/// Its reservoir has four lobes, and friction pulls sideways.
FrictionLaw lobed_and_chiral()
{
  std::vector<Rosette::Row> rows;
  for (unsigned int i = 0; i < 120; ++i)
  {
    const double a = 2 * pi * i / 120;
    rows.push_back({a, 0.3 * (1 + 0.2 * std::cos(4 * a)), 0.1});
  }
  return FrictionLaw(std::make_shared<const Rosette>(std::move(rows)));
}

double largest_difference(const FrictionLaw &law, const FrictionLaw &other)
{
  double largest = 0;
  for (unsigned int i = 0; i < 1000; ++i)
  {
    const Vector2d slip(std::cos(2 * pi * i / 1000), std::sin(2 * pi * i / 1000));
    largest = std::max(largest, (law.force_against(slip) - other.force_against(slip)).norm());
  }
  return largest;
}
} // namespace

TEST(LawPath, LeadsFromTheIsotropicLawToTheTable)
{
  const FrictionLaw law = lobed_and_chiral();
  EXPECT_TRUE(has_easier_law(law));
  const double m = law.mean_friction();
  EXPECT_LE(largest_difference(law_on_path(law, 0), OrthotropicFriction{m, m, m, m}), 1e-12);
  EXPECT_LE(largest_difference(law_on_path(law, 1), law), 1e-3 * m) << "of 72 directions";
  // Continuous on the way.
  for (const double t : {0.1, 0.4, 0.7})
    EXPECT_LE(largest_difference(law_on_path(law, t), law_on_path(law, t + 1e-3)), 2e-3 * m);
}

TEST(LawPath, LeadsFromAssociatedSlipToTheGivenOne)
{
  EXPECT_FALSE(has_easier_law(case_b));
  EXPECT_TRUE(has_easier_law(case_c));
  EXPECT_TRUE(law_on_path(case_b, 0.3).is_same(case_b)) << "which is associated";
  EXPECT_FALSE(has_easier_law(law_on_path(case_c, 0)));
  EXPECT_EQ(law_on_path(case_c, 0).ellipse()->mu(), case_c.mu());
  EXPECT_LE(largest_difference(law_on_path(case_c, 1), case_c), 1e-14);
}

TEST(LawPath, BeginsNowhereElseForTheCircle)
{
  EXPECT_FALSE(has_easier_law(OrthotropicFriction{0.3, 0.3, 1, 1}));
  std::vector<Rosette::Row> rows;
  for (unsigned int i = 0; i < 8; ++i)
    rows.push_back({2 * pi * i / 8, 0.3, 0});
  EXPECT_FALSE(has_easier_law(FrictionLaw(std::make_shared<const Rosette>(std::move(rows)))));
}
} // namespace orthocone::test
