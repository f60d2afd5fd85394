// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/output/peaks.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
namespace
{
Totals totals_of(const double fx, const double fz, const double contact, const double stick)
{
  Totals totals;
  totals.force = {fx, 0, fz};
  totals.contact_area = contact;
  totals.stick_area = stick;
  return totals;
}
} // namespace

TEST(Peaks, HaveTheAreasOfTheLargestTangentialForce)
{
  Peaks peaks;
  peaks.consider(1, totals_of(0, 100, 5, 5));
  peaks.consider(2, totals_of(-30, 90, 4, 1));
  peaks.consider(3, totals_of(10, 200, 7, 6));
  EXPECT_EQ(peaks.force_z, Peaks::Peak(200, 3));
  EXPECT_EQ(peaks.tangential_force, Peaks::Peak(30, 2));
  EXPECT_EQ(peaks.contact_area, Peaks::Peak(7, 3));
  EXPECT_EQ(peaks.sheared_contact, Peaks::Peak(4, 2));
  EXPECT_EQ(peaks.sheared_stick, Peaks::Peak(1, 2));
  EXPECT_EQ(peaks.friction, Peaks::Peak(30. / 90, 2));
}

TEST(Peaks, OfFrictionLeaveOutAContactThatIsAboutToOpen)
{
  Peaks peaks;
  peaks.consider(1, totals_of(20, 100, 5, 5));
  peaks.consider(2, totals_of(0.05, 0.06, 1, 0));
  EXPECT_EQ(peaks.friction.second, 1u);
}
} // namespace orthocone::test
