// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/march/implicit_wear.h>

#include <gtest/gtest.h>

#include <cmath>

namespace orthocone::test
{
namespace
{
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double own_compliance = 2e-4; // of the node in every direction, mm/N
constexpr double area = 0.5;            // mm^2
constexpr double pressed = 30;          // before the step, N
constexpr double way = 4;               // of the step, mm

/// A law that wears `z` times the flattening of the node on its way, with friction of 0.1.
WearLaw law_of(const char *const kind, const double z)
{
  WearOptions options;
  options.law = kind;
  options.coefficient = z * own_compliance * area / way / (options.law.word() == "energy" ? 0.1 : 1);
  return {options, Eigen::VectorXd::Constant(1, area)};
}

/// The force of the node behind a step that slides it by `way` at a fixed height.
double force_behind(const WearLaw &wear)
{
  const DenseCompliance body(own_compliance * Eigen::Matrix3d::Identity());
  const ContactSystem system(body, {OrthotropicFriction{0.1, 0.1, 0.1, 0.1}});
  const ContactStep step(system, Vector3d(-own_compliance * pressed, way, 0));
  ContactState before(Vector3d::Zero()), after(Vector3d(0, way, 0));
  before.force = after.force = Vector3d(pressed, -0.1 * pressed, 0);
  before.status = after.status = {NodeStatus::slip};
  VectorXd unknowns = after.force;
  const ImplicitWear implicit(wear, {}, VectorXd::Constant(1, own_compliance));
  const VectorXd depths = implicit.depths(step, before, after, unknowns);
  EXPECT_NEAR(depths[0], own_compliance * (pressed - unknowns[0]), 1e-12 * own_compliance * pressed);
  return unknowns[0];
}
} // namespace

/// r' = -z r over a step of length 1, whose mean is that of both ends with the weight.
TEST(ImplicitWear, WeighsTheEndsOfAnExponential)
{
  for (const double z : {1e-9, 0.99e-4, 1.01e-4, 1e-2, 0.5, 3.0, 50.0, 1e6})
  {
    const double theta = weight_of_end(z), mean = -std::expm1(-z) / z;
    EXPECT_NEAR(theta * std::exp(-z) + 1 - theta, mean, 1e-12) << z;
  }
  EXPECT_NEAR(weight_of_end(0), 0.5, 0);
}

/// However far it slides, and by either law: friction is a tenth of the normal force.
TEST(ImplicitWear, ForceOfASingleNodeDecaysExponentially)
{
  for (const char *const kind : {"archard", "energy"})
    for (const double z : {0.01, 1.0, 5.0, 20.0})
      EXPECT_NEAR(force_behind(law_of(kind, z)), pressed * std::exp(-z), 1e-9 * pressed) << z;
}

TEST(ImplicitWear, IsForDeepStepsAlone)
{
  ContactState before(Vector3d::Zero()), after(Vector3d(0, way, 0));
  before.force = after.force = Vector3d(pressed, 0, 0);
  const auto is_for = [&](const double z, const DeepWear deep)
  {
    WearOptions options;
    options.law = "archard";
    options.deep_steps = deep;
    after.wear_depth[0] = z * own_compliance * pressed;
    return ImplicitWear({options, VectorXd::Constant(1, area)}, {}, VectorXd::Constant(1, own_compliance))
        .is_for(before, after);
  };
  EXPECT_FALSE(is_for(0.89, DeepWear::implicitly));
  EXPECT_TRUE(is_for(0.91, DeepWear::implicitly));
  EXPECT_FALSE(is_for(0.91, DeepWear::explicitly));
}
} // namespace orthocone::test
