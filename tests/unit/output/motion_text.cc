// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/numbers.h>
#include <orthocone/output/motion_text.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
namespace
{
std::vector<LoadStep> program_to(const RigidMotion &motion)
{
  return {{RigidMotion(), 1, 1, 1, 0}, {motion, 2, 2, 1, 1}};
}

LoadStep step_to(const RigidMotion &motion)
{
  return {motion, 2, 2, 1, 1};
}
} // namespace

TEST(MotionText, NamesWhatMoves)
{
  RigidMotion motion = moved_by(0, 0, -0.1);
  EXPECT_EQ(MotionText(program_to(motion))(step_to(motion)), "u_z -0.1 mm");
  EXPECT_EQ(MotionText(program_to(motion))(step_to(motion), " = "), "u_z = -0.1 mm");
  motion = moved_by(0.03, 0, -0.1);
  const MotionText text(program_to(motion));
  EXPECT_EQ(text(step_to(motion)), "ux 0.03 mm, uz -0.1 mm");
  EXPECT_EQ(text(step_to({})), "ux 0 mm, uz 0 mm");
  EXPECT_EQ(MotionText(program_to(moved_by(0, 0.5, 0)))(step_to(moved_by(0, 0.25, 0))), "uy 0.25 mm");
  motion = RigidMotion();
  motion[5] = pi / 2;
  EXPECT_EQ(MotionText(program_to(motion))(step_to(motion)), "rz 90 degrees");
}

TEST(MotionText, NamesTheForcesThatDrive)
{
  LoadStep step = step_to(moved_by(0.01, 0, 0));
  step.by_force[2] = true;
  step.force[2] = -5e4;
  EXPECT_EQ(MotionText({step})(step), "ux 0.01 mm, Fz -50000 N");
}
} // namespace orthocone::test
