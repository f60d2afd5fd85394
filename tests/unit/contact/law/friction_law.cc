// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Laws that are no ellipses, given by the two maps alone: a superelliptic cone whose friction opposes slip,
// and a law as a tribometer measures it, whose friction across the slip makes it neither symmetric nor
// associated.
#include "contact/contact_problems.h"

#include <orthocone/base/numbers.h>
#include <orthocone/contact/law/natural_map.h>
#include <orthocone/contact/law/one_node.h>
#include <orthocone/contact/problem/law_errors.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace
{
Vector2d at(const double angle)
{
  return {std::cos(angle), std::sin(angle)};
}

Vector2d across(const Vector2d &e)
{
  return {-e[1], e[0]};
}

double angle_of(const Vector2d &v)
{
  return std::atan2(v[1], v[0]);
}

/// The cone |r_x/mu_x|^4 + |r_y/mu_y|^4 <= r_n^4; friction opposes slip. r' = r_t |r_t|_4 / |r_t| and g = m
/// d_t.
class Superellipse : public TangentMaps
{
public:
  Vector2d reduced_force(const Vector2d &r) const override
  {
    return r.isZero(0) ? r : Vector2d(ratio(r) * r);
  }
  Matrix2d reduced_force_derivative(const Vector2d &r) const override
  {
    if (r.isZero(0))
      return Matrix2d::Identity() / mean;
    const Vector2d cubes = r.cwiseProduct(r.cwiseAbs2()).cwiseQuotient(mu.cwiseAbs2().cwiseAbs2());
    const double size = norm(r), length = r.norm();
    const Vector2d slope = cubes / (size * size * size * length) - size * r / (length * length * length);
    return ratio(r) * Matrix2d::Identity() + r * slope.transpose();
  }
  Vector2d force(const Vector2d &reduced) const override
  {
    return reduced.isZero(0) ? reduced : Vector2d(reduced / ratio(reduced));
  }
  Vector2d reduced_slip(const Vector2d &slip) const override { return mean * slip; }
  Matrix2d reduced_slip_derivative(const Vector2d &) const override { return mean * Matrix2d::Identity(); }
  Vector2d slip(const Vector2d &reduced) const override { return reduced / mean; }

private:
  double norm(const Vector2d &r) const
  {
    return std::sqrt(std::sqrt(r.cwiseQuotient(mu).array().square().square().sum()));
  }
  double ratio(const Vector2d &r) const { return norm(r) / r.norm(); }

  const Vector2d mu{0.3, 0.15};
  const double mean = 0.2;
};

/// f(a) = mu_along(a) e(a) + mu_across(a) e'(a) against slip along -e(a): r' = r_t/R(b), where R(b) = |f(a)|
/// at the angle b(a) of the force, and g = -|d_t| w e(b(a)) with w = b'(a)^(-1/2), times the mean of R.
class Measured : public TangentMaps
{
public:
  static double along(const double a) { return 0.25 * (1 + 0.3 * std::cos(a) + 0.15 * std::cos(2 * a)); }
  static double sideways(const double a) { return 0.25 * (0.3 - 0.2 * std::sin(a)); }
  static Vector2d measured(const double a) { return along(a) * at(a) + sideways(a) * across(at(a)); }

  Vector2d reduced_force(const Vector2d &r) const override
  {
    return r.isZero(0) ? r : Vector2d(r / measured(slip_angle(angle_of(r))).norm());
  }
  Matrix2d reduced_force_derivative(const Vector2d &r) const override
  {
    if (r.isZero(0))
      return Matrix2d::Identity() / mean;
    const double a = slip_angle(angle_of(r)), size = measured(a).norm();
    const double slope = (measured(a + h).norm() - measured(a - h).norm()) / (2 * h) / turning(a);
    const Vector2d e = r.normalized();
    return (Matrix2d::Identity() - slope / size * e * across(e).transpose()) / size;
  }
  Vector2d force(const Vector2d &reduced) const override
  {
    return reduced.isZero(0) ? reduced : Vector2d(reduced * measured(slip_angle(angle_of(reduced))).norm());
  }
  Vector2d reduced_slip(const Vector2d &slip) const override
  {
    const double a = angle_of(-slip);
    return -mean * slip.norm() / std::sqrt(turning(a)) * at(force_angle(a));
  }
  Matrix2d reduced_slip_derivative(const Vector2d &slip) const override
  {
    if (slip.isZero(0))
      return mean * Matrix2d::Identity();
    const double a = angle_of(-slip), w = 1 / std::sqrt(turning(a));
    const double w_slope = (1 / std::sqrt(turning(a + h)) - 1 / std::sqrt(turning(a - h))) / (2 * h);
    const Vector2d e = at(force_angle(a));
    return mean * (w * e * at(a).transpose() +
                   (w_slope * e + w * turning(a) * across(e)) * across(at(a)).transpose());
  }
  Vector2d slip(const Vector2d &reduced) const override
  {
    const double a = slip_angle(angle_of(-reduced));
    return -reduced.norm() * std::sqrt(turning(a)) / mean * at(a);
  }

private:
  static double force_angle(const double a) { return a + std::atan2(sideways(a), along(a)); }
  static double turning(const double a) { return (force_angle(a + h) - force_angle(a - h)) / (2 * h); }
  static double slip_angle(const double b)
  {
    double a = b - std::atan2(sideways(b), along(b));
    double change = 1;
    for (int i = 0; i < 40 && std::abs(change) > 1e-15; ++i)
    {
      change = std::remainder(force_angle(a) - b, 2 * pi) / turning(a);
      a -= change;
    }
    return a;
  }

  static constexpr double h = 1e-4, mean = 0.25;
};

const std::array<FrictionLaw, 4> open_laws{
    {FrictionLaw(std::make_shared<const Superellipse>()), FrictionLaw(std::make_shared<const Measured>()),
     FrictionLaw(case_c), FrictionLaw(std::make_shared<const Measured>()).scaled(1.7)}};

/// The law in words: the gap and the normal force are not negative, and one of them vanishes. Friction is no
/// more than the law lets it be, and where the node slips it is the force against this slip.
void expect_law(const FrictionLaw &law, const Vector3d &r, const Vector3d &d, const double tolerance)
{
  EXPECT_GE(r[0], 0);
  EXPECT_GE(d[0], -tolerance);
  EXPECT_NEAR(r[0] * d[0], 0, tolerance);
  EXPECT_LE(law.load(r.tail<2>()), r[0] + tolerance);
  const Vector2d slip = d.tail<2>();
  if (r[0] > 0 && slip.norm() > 1e-6)
  {
    EXPECT_LE((r.tail<2>() - r[0] * law.force_against(slip)).norm(), tolerance / 1e-2)
        << slip.transpose() << "; " << r.transpose();
  }
}
} // namespace

/// A mistake that is easily made: the force per unit normal force in place of the force of a reduced one.
TEST(FrictionLaw, RefusesMapsThatAreNotInverse)
{
  struct Wrong : Measured
  {
    Vector2d force(const Vector2d &reduced) const override
    {
      return Measured::force(reduced.normalized() / 2);
    }
  };
  EXPECT_THROW(FrictionLaw(std::make_shared<const Wrong>()), std::invalid_argument);
  EXPECT_NO_THROW(FrictionLaw(std::make_shared<const Measured>()));
}

TEST(FrictionLaw, MapsHaveTheirInversesAndDerivatives)
{
  constexpr double step = 1e-6;
  for (const FrictionLaw &law : open_laws)
    for (double angle = 0.05; angle < 6.2; angle += 0.3)
      for (const double size : {1e-3, 1., 1e3})
      {
        const Vector2d v = size * at(angle);
        EXPECT_LE((law.force(law.reduced_force(v)) - v).norm(), 1e-12 * size);
        EXPECT_LE((law.slip(law.reduced_slip(v)) - v).norm(), 1e-12 * size);
        const Matrix2d of_force = law.force_derivative(v).inverse(), of_slip = law.reduced_slip_derivative(v);
        for (int i = 0; i < 2; ++i)
        {
          const Vector2d change = step * size * Vector2d::Unit(i);
          EXPECT_LE(
              (law.reduced_force(v + change) - law.reduced_force(v - change) - 2 * of_force * change).norm(),
              1e-6 * change.norm());
          EXPECT_LE(
              (law.reduced_slip(v + change) - law.reduced_slip(v - change) - 2 * of_slip * change).norm(),
              1e-6 * change.norm());
        }
      }
}

/// Force against slip has the size that slips, and slip under it goes back.
TEST(FrictionLaw, ForceAgainstSlipIsWhatWasMeasured)
{
  for (double angle = 0.02; angle < 6.28; angle += 0.1)
  {
    EXPECT_LE((open_laws[1].force_against(-at(angle)) - Measured::measured(angle)).norm(), 1e-9);
    for (const FrictionLaw &law : open_laws)
    {
      const Vector2d force = law.force_against(at(angle)), slip = law.slip_under(force).normalized();
      EXPECT_NEAR(law.load(force), 1, 1e-12);
      EXPECT_LE((slip - at(angle)).norm(), 1e-9);
      EXPECT_LE(law.least_friction(), force.norm() * (1 + 1e-3));
      EXPECT_NEAR(law.cone_normal(force).dot(force), 1, 1e-9) << "|r'|^2 is homogeneous of degree two";
    }
  }
  EXPECT_NEAR(open_laws[0].mean_friction(), 0.23, 0.02);
}

/// Friction forces are multiplied, slip goes where it went. For ellipses that is the law of the multiplied
/// coefficients, to the last bit where nothing is rounded.
TEST(FrictionLaw, IsScaled)
{
  for (const FrictionLaw &law : open_laws)
  {
    const FrictionLaw scaled = law.scaled(0.6);
    EXPECT_NEAR(scaled.mean_friction(), 0.6 * law.mean_friction(), 1e-15);
    EXPECT_NEAR(scaled.largest_friction(), 0.6 * law.largest_friction(), 1e-15);
    EXPECT_NEAR(scaled.slip_amplification() / law.slip_amplification(), 1, 1e-15);
    for (double angle = 0.02; angle < 6.28; angle += 0.1)
    {
      EXPECT_LE((scaled.force_against(at(angle)) - 0.6 * law.force_against(at(angle))).norm(), 1e-9);
      const Vector2d slip = scaled.slip_under(at(angle)).normalized();
      EXPECT_LE((slip - law.slip_under(at(angle)).normalized()).norm(), 1e-9);
    }
  }
  const FrictionLaw doubled = FrictionLaw(case_c).scaled(2), given(OrthotropicFriction{0.6, 0.3, 0.05, 0.2});
  EXPECT_EQ(doubled.ellipse()->mu(), given.ellipse()->mu());
  EXPECT_EQ(doubled.reduced_slip({0.3, 0.7}), given.reduced_slip({0.3, 0.7}));
  EXPECT_TRUE(FrictionLaw(OrthotropicFriction{0, 0, 1, 1}).scaled(2).is_frictionless());
}

/// kappa = mu_along + d mu_across / d a > 0: a push on a node that hangs on equal springs has one slip, from
/// wherever the search begins.
TEST(FrictionLaw, OnePushHasOneSlip)
{
  const Matrix3d w = Matrix3d::Identity();
  for (const FrictionLaw &law : open_laws)
    for (double angle = 0; angle < 6.28; angle += 0.1)
    {
      constexpr double h = 1e-4;
      const auto across_slip = [&](const double a) { return law.force_against(-at(a)).dot(across(at(a))); };
      const double kappa = law.force_against(-at(angle)).dot(at(angle)) +
                           (across_slip(angle + h) - across_slip(angle - h)) / (2 * h);
      EXPECT_GT(kappa, 0);
      const Vector3d q(-1, std::cos(angle), std::sin(angle));
      const Vector3d r = solve_one_node(law, {w, w}, q, Vector3d::Zero());
      expect_law(law, r, q + r, 1e-10);
      for (double guess = 0; guess < 6; ++guess)
        EXPECT_LE(
            (solve_one_node(law, {w, w}, q, {1, 0.1 * std::cos(guess), 0.1 * std::sin(guess)}) - r).norm(),
            1e-9);
    }
}

/// A node that is pressed down and led around: behind the first step of stick it slips all the way round, its
/// force balances what leads it, and the friction of a closed loop only takes energy.
TEST(FrictionLaw, AFrictionLoopOfOneNodeDissipates)
{
  Matrix3d w;
  w << 1, 0.1, -0.05, 0.1, 1.3, 0.1, -0.05, 0.1, 1.2;
  constexpr int n_steps = 60;
  for (const FrictionLaw &law : open_laws)
  {
    Vector2d slip = Vector2d::Zero();
    Vector3d r(1, 0, 0);
    double loop = 0;
    for (int i = 1; i <= 2 * n_steps; ++i)
    {
      const Vector2d led = 2 * at(2 * pi * i / n_steps);
      const Vector3d q(-1, led[0] - slip[0], led[1] - slip[1]);
      r = solve_one_node(law, {w, w.inverse()}, q, r);
      const Vector3d d = q + w * r;
      expect_law(law, r, d, 1e-10);
      EXPECT_LE(r.tail<2>().dot(d.tail<2>()), 1e-12) << "friction takes energy";
      slip += d.tail<2>();
      if (i > n_steps)
        loop -= r.tail<2>().dot(d.tail<2>());
    }
    EXPECT_GT(loop, 0);
  }
}

/// Nodes that feel each other stick, slip in all directions and open.
TEST(FrictionLaw, MethodsAgreeOnLawsThatAreNoEllipses)
{
  for (const FrictionLaw &law : open_laws)
  {
    const GridProblem grid(law);
    NodeVector swept = grid.zero();
    EXPECT_TRUE(solve_step(grid.problem, solver_options("gauss-seidel", 1e-12), swept).converged);
    NodeVector force = grid.zero();
    const SolverReport report = solve_step(grid.problem, solver_options("newton", 1e-11), force);
    EXPECT_TRUE(report.converged);
    EXPECT_LT(report.iterations, 40U);
    EXPECT_LE((force - swept).norm(), 1e-8 * swept.norm());
    const NodeVector d = grid.problem.displacement(force);
    std::array<unsigned int, 3> n{};
    for (const NodeStatus status : grid.problem.statuses(force, d))
      ++n[static_cast<int>(status)];
    EXPECT_GT(n[1] * n[2], 0U) << "stick and slip";
    for (Index node = 0; node < grid.problem.n_nodes(); ++node)
      expect_law(law, force.segment<3>(3 * node), d.segment<3>(3 * node), 1e-8);
    const LawErrors errors = law_errors(grid.problem, force, d);
    EXPECT_LT(errors.slip_rule, 1e-8);
    EXPECT_LT(errors.friction_cone, 1e-10);
  }
}

/// Laws belong to a step: the same system under another law has the other law's answer.
TEST(FrictionLaw, MayChangeFromStepToStep)
{
  const GridProblem grid(case_b), other(open_laws[1]);
  const ContactStep changed = grid.problem.with_laws(FrictionLaws(grid.problem.n_nodes(), open_laws[1]));
  for (const char *const method : {"newton", "gauss-seidel"})
  {
    NodeVector force = grid.zero(), expected = grid.zero();
    EXPECT_TRUE(solve_step(changed, solver_options(method), force).converged);
    solve_step(other.problem, solver_options(method), expected);
    EXPECT_LE((force - expected).norm(), 1e-9 * expected.norm());
  }
}

/// They iterate on the elliptic cone of their source.
TEST(FrictionLaw, PrintedMethodsRefuseLawsThatAreNoEllipses)
{
  const GridProblem grid(open_laws[0]);
  for (const char *const method : {"feng2006", "box3", "uzawa"})
  {
    NodeVector force = grid.zero();
    EXPECT_THROW(solve_step(grid.problem, solver_options(method), force), std::invalid_argument);
  }
}
} // namespace orthocone::test
