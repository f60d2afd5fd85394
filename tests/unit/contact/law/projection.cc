// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "contact/law/quartic.h"
#include "contact/laws.h"

#include <orthocone/base/numbers.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
using Eigen::Vector3d;

namespace
{
/// Points near the surface of the cone and of its polar, where projections are hardest.
std::vector<Vector3d> test_points(const OrthotropicFriction &law)
{
  std::vector<Vector3d> points = directions();
  for (const Vector3d &d : directions())
    for (const double shift : {-1e-9, 0., 1e-9})
    {
      points.emplace_back(friction_norm(law, d[1], d[2]) * (1 + shift), d[1], d[2]);
      points.emplace_back(-dual_norm(law, d[1], d[2]) * (1 + shift), d[1], d[2]);
    }
  points.emplace_back(0, 0, 0);
  return points;
}

/// Whether a point is neither in the cone nor in its polar.
bool is_outside(const OrthotropicFriction &law, const Vector3d &tau)
{
  return friction_norm(law, tau[1], tau[2]) > tau[0] && dual_norm(law, tau[1], tau[2]) + tau[0] > 0;
}

/// How far r is from the cone, and v from its polar, relative to their size.
double distance_to_cone(const OrthotropicFriction &law, const Vector3d &r)
{
  return std::max(0., friction_norm(law, r[1], r[2]) - r[0]) * std::min({1., law.mu_x, law.mu_y});
}
double distance_to_polar(const OrthotropicFriction &law, const Vector3d &v)
{
  return std::max(0., dual_norm(law, v[1], v[2]) + v[0]) / std::max({1., law.mu_x, law.mu_y});
}
} // namespace

// Moreau: tau = r + v with r in the cone, v in its polar and r orthogonal to v characterizes the projection.
TEST(Projection, SplitsEveryPointByMoreau)
{
  for (const OrthotropicFriction &law : wide_laws())
    for (const Vector3d &tau : test_points(law))
    {
      const Vector3d r = project(law, tau);
      const Vector3d v = tau - r;
      const double tolerance = 1e-13 * std::max(tau.norm(), 1e-300);
      EXPECT_LE(distance_to_cone(law, r), tolerance)
          << law.mu_x << " " << law.mu_y << "; " << tau.transpose();
      EXPECT_LE(distance_to_polar(law, v), tolerance)
          << law.mu_x << " " << law.mu_y << "; " << tau.transpose();
      EXPECT_LE(std::abs(r.dot(v)), tolerance * tau.norm())
          << law.mu_x << " " << law.mu_y << "; " << tau.transpose();
    }
}

TEST(Projection, ScalesWithItsArgumentOver24Decades)
{
  for (const OrthotropicFriction &law : {case_a, case_b, case_c})
    for (const Vector3d &tau : directions())
      for (const double scale : {1e-12, 1e-6, 1e6, 1e12})
        EXPECT_LE((project(law, scale * tau) / scale - project(law, tau)).norm(), 1e-14);
}

/// Squares of these numbers, and quotients by a small coefficient, leave the range of double.
TEST(Projection, IsThatOfTheDirectionAtTheEndsOfTheNumberRange)
{
  for (const OrthotropicFriction &law : wide_laws())
    for (const Vector3d &tau : directions())
      for (const double scale : {1e-300, 1e-200, 1e200, 1e300})
      {
        const Vector3d unit = project(law, tau), point = project(law, scale * tau);
        EXPECT_LE((point / scale - unit).norm(), 1e-13) << law.mu_x << " " << law.mu_y << "; " << scale;
        EXPECT_LE((project_with_derivative(law, scale * tau).point - point).norm(), 1e-13 * scale);
      }
  for (const double mu : {1e-300, 1e-160, 1e160, 1e300})
  {
    const OrthotropicFriction law{mu, 2 * mu, mu, mu};
    for (const Vector3d &tau : directions())
      for (const double scale : {1e-300, 1.0, 1e300})
      {
        const Vector3d point = project(law, scale * tau);
        EXPECT_TRUE(point.allFinite()) << mu << "; " << scale << "; " << tau.transpose();
        EXPECT_LE((point / scale).norm(), (1 + 1e-12) * tau.norm());
      }
  }
}

TEST(Projection, IsIdempotent)
{
  for (const OrthotropicFriction &law : wide_laws())
    for (const Vector3d &tau : test_points(law))
    {
      const Vector3d r = project(law, tau);
      EXPECT_LE((project(law, r) - r).norm(), 1e-14 * tau.norm());
    }
}

TEST(Projection, DoesNotExpandDistances)
{
  for (const OrthotropicFriction &law : {case_b, OrthotropicFriction{2, 0.01, 2, 0.01}})
    for (const Vector3d &first : directions())
      for (const Vector3d &second : directions())
        EXPECT_LE((project(law, first) - project(law, second)).norm(), (first - second).norm() + 1e-14);
}

TEST(Projection, IsTheClosedFormOnACircularCone)
{
  for (const double mu : {1e-3, 0.2, 1., 1e3})
    for (const Vector3d &tau : directions())
    {
      const OrthotropicFriction law{mu, mu, mu, mu};
      const double t = tau.tail<2>().norm();
      if (t <= mu * tau[0] || mu * t + tau[0] <= 0)
        continue;
      const double r_n = (tau[0] + mu * t) / (1 + mu * mu);
      const Vector3d expected(r_n, mu * r_n * tau[1] / t, mu * r_n * tau[2] / t);
      EXPECT_LE((project(law, tau) - expected).norm(), 1e-14);
    }
}

TEST(Projection, BeatsEveryOtherPointOfTheSurface)
{
  constexpr int n_angles = 2000;
  for (const OrthotropicFriction &law : {case_b, OrthotropicFriction{0.05, 2, 0.05, 2}})
    for (const Vector3d &tau : directions())
    {
      if (!is_outside(law, tau))
        continue;
      double least = tau.norm(); // the apex
      for (int i = 0; i < n_angles; ++i)
      {
        const double angle = 2 * pi * i / n_angles;
        const Vector3d ray = Vector3d(1, law.mu_x * std::cos(angle), law.mu_y * std::sin(angle)).normalized();
        least = std::min(least, (tau - std::max(0., ray.dot(tau)) * ray).norm());
      }
      const double distance = (tau - project(law, tau)).norm();
      EXPECT_LE(distance, least + 1e-14);
      EXPECT_NEAR(distance, least, 1e-4);
    }
}

namespace
{
/// Projection by the quartic of the paper, from the eigenvalues of its companion matrix.
Vector3d project_by_quartic(const OrthotropicFriction &law, const Vector3d &tau)
{
  const double lambda = wanted_root(law, tau, companion_roots(multiplier_quartic(law, tau)));
  return {tau[0] / (1 - lambda), tau[1] / (1 + lambda / (law.mu_x * law.mu_x)),
          tau[2] / (1 + lambda / (law.mu_y * law.mu_y))};
}

double error_of_quartic(const OrthotropicFriction &law)
{
  double error = 0;
  for (const Vector3d &tau : directions())
    if (is_outside(law, tau) && std::abs(tau[0]) > 0.01)
      error = std::max(error, (project_by_quartic(law, tau) - project(law, tau)).norm());
  return error;
}
} // namespace

// The paper's quartic has the same root. For small coefficients its terms cancel, and up to seven digits are
// lost, where Moreau's conditions hold to 1e-13 for the program's own equation (above).
TEST(Projection, AgreesWithTheQuarticAndKeepsTheDigitsThatItLoses)
{
  for (const OrthotropicFriction &law : {case_a, case_b, OrthotropicFriction{0.9, 0.5, 1, 1}})
    EXPECT_LE(error_of_quartic(law), 1e-12);
  const double lost = error_of_quartic({1e-3, 1e-3, 1, 1});
  EXPECT_GT(lost, 1e-10);
  EXPECT_LE(lost, 1e-7);
}

TEST(Projection, HasTheDerivativeOfDifferences)
{
  constexpr double step = 1e-6;
  for (const OrthotropicFriction &law : {case_a, case_b, OrthotropicFriction{2, 0.05, 2, 0.05}})
    for (const Vector3d &tau : directions())
    {
      const Projection at = project_with_derivative(law, tau);
      const Eigen::Matrix3d derivative =
          at.n_directions() == 3 ? Eigen::Matrix3d::Identity().eval()
                                 : at.ray * at.ray.transpose() + at.stiffness * at.side * at.side.transpose();
      bool is_smooth = true;
      Eigen::Matrix3d differences;
      for (int d = 0; d < 3; ++d)
      {
        const Vector3d change = step * Vector3d::Unit(d);
        is_smooth = is_smooth && project_with_derivative(law, tau + change).zone == at.zone &&
                    project_with_derivative(law, tau - change).zone == at.zone;
        differences.col(d) = (project(law, tau + change) - project(law, tau - change)) / (2 * step);
      }
      if (is_smooth)
      {
        EXPECT_LE((derivative - differences).norm(), 1e-8) << tau.transpose();
      }
    }
}

TEST(Projection, HasTheSamePointWithDerivative)
{
  for (const OrthotropicFriction &law : {case_a, case_b})
    for (const Vector3d &tau : directions())
      EXPECT_EQ(project_with_derivative(law, tau).point, project(law, tau));
}
} // namespace orthocone::test
