// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// A kind of load from outside: "drag", a traction along a direction as far as it is tangential to the
// surface, as a stream of air or oil causes it.
#include "results/scenes.h"

#include <orthocone/scene/parameters.h>

namespace orthocone::test
{
namespace
{
/// t = value (d - (d . n) n).
class Drag : public LoadKind
{
public:
  std::string_view word() const override { return "drag"; }
  std::string_view help() const override { return "drags along the surface, MPa"; }
  const char *unit() const override { return "MPa"; }
  Conjugate conjugate() const override { return {"u", "mm", "mean displacement along the surface"}; }
  Eigen::Vector3d traction(const Eigen::Vector3d &normal, const Eigen::Vector3d &direction) const override
  {
    return direction - direction.dot(normal) * normal;
  }
};

Parameters with_load(const std::string &text)
{
  Parameters parameters = small_scene();
  parameters.load.loads.emplace_back();
  EXPECT_EQ(parse_load(text, parameters.load.loads.front()), "");
  Leg leg;
  leg.targets[2] = Drive{false, -0.01};
  leg.loads = {{parameters.load.loads.front().name, 20}};
  parameters.load.legs = {leg};
  share_among_bodies(parameters);
  return parameters;
}
} // namespace

// Along the axis of a cylinder all of a drag is tangential, and across it the half of its force.
TEST(Example, Load)
{
  static const Drag drag;
  load_kinds().push_back(&drag);
  TestScene one(with_load("a: drag on side along z")), other(with_load("a: traction on side along z"));
  one.march();
  other.march();
  EXPECT_LE(largest_difference(one.state.force, other.state.force), 1e-12);
  TestScene across(with_load("a: drag on side along x"));
  expect_checked_steps(across);
  const Totals totals = across.totals();
  const double force = 0.5 * 20 * totals.load_areas[0];
  EXPECT_NEAR(totals.held[0] + totals.force[0], -force, 1e-2 * force); // the side has chords of a circle
  load_kinds().pop_back();
}
} // namespace orthocone::test
