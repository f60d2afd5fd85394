// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Warnings of strains and slides that the theory is not good for, by what the steps show.
#include <orthocone/output/summary.h>
#include <orthocone/scene/parameters.h>

#include <gtest/gtest.h>

#include <limits>

namespace orthocone::test
{
namespace
{
/// The one warning of a run with this step, or nothing.
std::string motion_warning_of(const MotionChecks &motion)
{
  StepChecks checks;
  checks.motion = motion;
  Totals totals;
  totals.zones.contact = std::numeric_limits<double>::infinity();
  RunRecord record;
  record.critical_friction.factor = 2;
  record.add_step(3, {}, totals, {}, checks);
  const std::size_t of_parameters = parameter_warnings({}).size();
  const auto warnings = all_warnings({}, record);
  EXPECT_LE(warnings.size(), of_parameters + 1);
  return warnings.size() > of_parameters ? warnings.back() : "";
}
} // namespace

TEST(MotionWarnings, NameStepAndStrain)
{
  EXPECT_EQ(motion_warning_of({0.04, 0, 0.04, 0, 1}), "");
  EXPECT_EQ(motion_warning_of({0.06, 0, 0, 0, 1})
                .rfind("load step 3: the contact is displaced by 6 % of the body's", 0),
            0U);
  EXPECT_NE(motion_warning_of({0.04, 0, 0.2, 0, 1}).find("20 % of Young's modulus"), std::string::npos);
  EXPECT_NE(motion_warning_of({0.06, 0, 0.2, 0, 1}).find("displaced"), std::string::npos); // once is enough
}

TEST(MotionWarnings, NameStepAndSlide)
{
  EXPECT_EQ(motion_warning_of({0, 0, 0, 0.9, 1}), "");
  EXPECT_EQ(motion_warning_of({0, 0, 0, 2.54, 1})
                .rfind("load step 3: the body slides by 2.5 faces of the lower body", 0),
            0U);
}
} // namespace orthocone::test
