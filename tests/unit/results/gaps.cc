// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "results/scenes.h"

#include <orthocone/base/numbers.h>

namespace orthocone::test
{
namespace
{
Parameters pushed_scene()
{
  Parameters parameters = full_scene();
  parameters.load.legs = {move_to(0, 0, -0.05, 2), move_to(0.01, 0, -0.05, 2)};
  return parameters;
}
} // namespace

TEST(Gap, OfOneWidthOnlyDelaysContact)
{
  TestScene flat(pushed_scene());
  flat.march();
  Parameters parameters = pushed_scene();
  parameters.obstacle.gap = "0.02";
  parameters.load.preload = {move_to(0, 0, -0.02, 1)};
  parameters.load.legs = {move_to(0, 0, -0.07, 2), move_to(0.01, 0, -0.07, 2)};
  TestScene apart(parameters);
  apart.march();
  EXPECT_LT(largest_difference(apart.state.force, flat.state.force), 1e-9);
  EXPECT_LT(largest_difference(apart.state.displacement, flat.state.displacement), 1e-9);
  const ContactFields fields = apart.evaluator.fields(apart.state, 0);
  EXPECT_NEAR(fields.displacement[2], fields.gap - 0.02, 1e-15);
}

// A body on an inclined plane is the body on a level one, turned: gap a x, turned about y by a.
TEST(Gap, ThatIsInclinedIsClosedByARotation)
{
  constexpr double slope = 1e-3;
  TestScene flat(pushed_scene());
  flat.march();
  Parameters parameters = pushed_scene();
  parameters.obstacle.gap = "1e-3*x";
  const double height = parameters.geometry.height;
  for (Leg &leg : parameters.load.legs)
  {
    leg.targets[0] = Drive{false, leg.targets[0]->value + slope * height};
    leg.targets[4] = Drive{false, slope * 180 / pi};
  }
  Leg turn = move_to(slope * height, 0, 0, 1);
  turn.targets[4] = Drive{false, slope * 180 / pi};
  parameters.load.preload = {turn};
  TestScene inclined(parameters);
  inclined.march();
  EXPECT_LT(largest_difference(inclined.state.force, flat.state.force), 1e-9);
}

TEST(FrictionThatVaries, IsTheSameFrictionWhereItDoesNot)
{
  TestScene numbers(pushed_scene());
  numbers.march();
  Parameters parameters = pushed_scene();
  parameters.friction.varying_mu = std::array<Expression, 2>{{Expression("0.3+0*x"), Expression("0.15+0*y")}};
  parameters.friction.varying_angle = Expression("0*x");
  TestScene expressions(parameters);
  expressions.march();
  EXPECT_EQ(expressions.state.force, numbers.state.force);
}

// Turning all axes by place and back by exchanging the semi-axes changes nothing.
TEST(FrictionThatVaries, DoesNotDependOnTheNamesOfItsAxes)
{
  TestScene straight(pushed_scene());
  straight.march();
  Parameters parameters = pushed_scene();
  parameters.friction.varying_mu =
      std::array<Expression, 2>{{Expression("if(x>1,0.15,0.3)"), Expression("if(x>1,0.3,0.15)")}};
  parameters.friction.varying_angle = Expression("if(x>1,90,0)");
  TestScene turned(parameters);
  turned.march();
  for (unsigned int node = 0; node < turned.evaluator.surface().nodes.size(); ++node)
    EXPECT_NEAR((turned.evaluator.fields(turned.state, node).nodal_force -
                 straight.evaluator.fields(straight.state, node).nodal_force)
                    .norm(),
                0, 1e-9 * straight.state.force.norm());
}
} // namespace orthocone::test
