// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "entries/parsed.h"
#include "scene/parameter_files.h"

#include <orthocone/scene/legs.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
namespace
{
std::string allowed_instead_of(const std::string &text)
{
  std::string allowed;
  EXPECT_FALSE(parsed(legs_codec(), text, &allowed).has_value()) << text;
  return allowed;
}
} // namespace

TEST(Legs, NameComponentsOfMotionAndForce)
{
  const auto legs =
      parsed(legs_codec(), "uz -0.1 : 5 ; Fz -2e5 ux 0.03 : 6; rz 0.5 : 10 ; Mz\t1e4  Fx 10 : 5");
  ASSERT_TRUE(legs.has_value());
  ASSERT_EQ(legs->size(), 4u);
  EXPECT_EQ((*legs)[0].targets[2], (Drive{false, -0.1}));
  EXPECT_FALSE((*legs)[0].targets[0].has_value());
  EXPECT_EQ((*legs)[1].targets[2], (Drive{true, -2e5}));
  EXPECT_EQ((*legs)[1].motion(0), 0.03);
  EXPECT_FALSE((*legs)[1].motion(2).has_value()) << "a force is no motion";
  EXPECT_EQ((*legs)[2].targets[5], (Drive{false, 0.5}));
  EXPECT_EQ((*legs)[3].targets[5], (Drive{true, 1e4}));
  EXPECT_EQ((*legs)[3].targets[0], (Drive{true, 10}));
  EXPECT_EQ((*legs)[3].steps, 5u);
}

TEST(Legs, ReadBackAsTheyArePrinted)
{
  const std::string text = "0 0 -0.1 : 5; uz -0.2 : 1; ux 1 Fz -2e+05 rx 0.1 : 2; Mx 1 My 2 Mz 3 : 4; "
                           "ux 0 uy 0 uz 0 rz 1 : 1";
  EXPECT_EQ(legs_codec().print(*parsed(legs_codec(), text)), text);
  EXPECT_EQ(legs_codec().print(*parsed(legs_codec(), "uz 3 ux 1 uy 2 : 1")), "1 2 3 : 1")
      << "three motions are three numbers";
}

TEST(Legs, MayBeSolvedInParts)
{
  const std::string text = "0 0 -0.1 : 5; uz 0 : 10 * 4";
  const auto legs = parsed(legs_codec(), text);
  ASSERT_TRUE(legs.has_value());
  EXPECT_EQ((*legs)[0].parts, 1u);
  EXPECT_EQ((*legs)[1].steps, 10u);
  EXPECT_EQ((*legs)[1].parts, 4u);
  EXPECT_EQ(legs_codec().print(*legs), text);
  EXPECT_EQ(parsed(legs_codec(), "1 2 3 : 5 * 2")->front().parts, 2u);
  for (const char *const wrong : {"5 * 0", "0 * 5", "5 *", "* 5", "5 * 2 * 2", "5 * 2.5", "5 * x", "5 2"})
    EXPECT_EQ(allowed_instead_of(std::string("0 0 0 : ") + wrong), legs_codec().allowed) << wrong;
}

TEST(Legs, NameAComponentOnce)
{
  EXPECT_EQ(allowed_instead_of("uz -0.1 ux 1 uz 2 : 1"), "a component once in a leg; uz is named twice");
  EXPECT_EQ(allowed_instead_of("0 0 0 : 1; uz -0.1 Fz 2 : 1"),
            "a component once in a leg; uz and Fz are the same component");
  EXPECT_EQ(allowed_instead_of("Mx 1 rx 2 : 1"),
            "a component once in a leg; Mx and rx are the same component");
  EXPECT_TRUE(parsed(legs_codec(), "uz -0.1 : 1; Fz 2 : 1").has_value()) << "two legs";
}

TEST(Legs, SuggestTheComponentThatIsMeant)
{
  const std::string names = "a name of ux, uy, uz, rx, ry, rz, Fx, Fy, Fz, Mx, My, Mz; ";
  EXPECT_EQ(allowed_instead_of("fz -1 : 1"), names + "'fz' is none, is Fz meant?");
  EXPECT_EQ(allowed_instead_of("u_z -1 : 1"), names + "'u_z' is none, is uz meant?");
  EXPECT_EQ(allowed_instead_of("force -1 : 1"), names + "'force' is none");
}

TEST(Legs, MayHaveUnitsBehindTheirValues)
{
  const auto legs = parsed(legs_codec(), "uz -10 um : 5; Fz -2 kN ux 30um Mz 1 N m : 6; rz 1 mrad uy 2 : 1");
  ASSERT_TRUE(legs.has_value());
  EXPECT_EQ((*legs)[0].targets[2], (Drive{false, -0.01}));
  EXPECT_EQ((*legs)[1].targets[2], (Drive{true, -2000}));
  EXPECT_EQ((*legs)[1].targets[0], (Drive{false, 0.03}));
  EXPECT_EQ((*legs)[1].targets[5], (Drive{true, 1000}));
  EXPECT_NEAR((*legs)[2].targets[5]->value, 0.0573, 1e-4);
  EXPECT_EQ((*legs)[2].motion(1), 2);
  EXPECT_EQ(allowed_instead_of("Fz -2 um : 1"), "for Fz a unit of N, kN, MN, mN; um is a unit of length");
  EXPECT_NE(allowed_instead_of("Fz -2 kn : 1").find("'kn' is none"), std::string::npos);
  EXPECT_EQ(allowed_instead_of("0 0 -10 um : 1"), legs_codec().allowed) << "of which number?";
}

TEST(Legs, TellTheirForm)
{
  for (const char *const wrong : {"uz : 1", "uz -1", "uz -1 : 0", "uz 1 ux : 1", "uz 1 2 : 1", "1 uz : 1",
                                  "uz nan : 1", "uz=1 : 1", "0 0 0 rz 1 : 1", ": 1"})
    EXPECT_EQ(allowed_instead_of(wrong), legs_codec().allowed) << wrong;
}
} // namespace orthocone::test
