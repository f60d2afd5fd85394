// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/half_space_fields.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace orthocone::test
{
using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace
{
Matrix3d stress_of(const HalfSpace &material, const Matrix3d &gradient)
{
  const double mu = material.young_modulus / (2 * (1 + material.poisson_ratio)),
               lambda = 2 * mu * material.poisson_ratio / (1 - 2 * material.poisson_ratio);
  return lambda * gradient.trace() * Matrix3d::Identity() + mu * (gradient + gradient.transpose());
}

double mises(const Matrix3d &stress)
{
  const Matrix3d deviator = stress - stress.trace() / 3 * Matrix3d::Identity();
  return std::sqrt(1.5) * deviator.norm();
}

const SurfaceGrid field_grid{3, 2, 0.7, 0.5};
constexpr HalfSpace field_body{1000, 0.3};

std::vector<Vector3d> some_tractions()
{
  return {{1, 0, 2}, {0, 0, 1}, {-2, 1, 3}, {0, 3, 0}, {1, 1, 1}, {0, -1, 2}};
}
} // namespace

// Unit pressure on a unit square (Love): CONTACT prints the largest von Mises stress 0.665 at the depth 0.4,
// and at the surface the mean stress -0.853 and sigma_xx = -0.780.
TEST(HalfSpaceFields, AreLovesBelowASquare)
{
  const SurfaceGrid grid{1, 1, 1, 1};
  constexpr HalfSpace material{2 * 1.28, 0.28};
  const auto at = [&](const double z) {
    return stress_of(material, fields_below(grid, material, {Vector3d(0, 0, 1)}, {0, 0, z}).gradient);
  };
  EXPECT_NEAR(mises(at(0.4)), 0.665, 5e-4);
  EXPECT_NEAR(at(0).trace() / 3, -0.853, 5e-4);
  EXPECT_NEAR(at(0)(0, 0), -0.780, 5e-4);
}

// The stress at the surface is that of the tractions, and outside of the patches no traction is left.
TEST(HalfSpaceFields, MeetTheTractionsAtTheSurface)
{
  const std::vector<Vector3d> tractions = some_tractions();
  const auto traction_at = [&](const double x, const double y) -> Vector3d
  {
    return -stress_of(field_body, fields_below(field_grid, field_body, tractions, {x, y, 0}).gradient).col(2);
  };
  for (Index node = 0; node < field_grid.n_nodes(); ++node)
  {
    const double x = (static_cast<double>(node % 3) - 1) * 0.7 + 0.1,
                 y = (node / 3 == 0 ? -0.25 : 0.25) - 0.07;
    EXPECT_LT((traction_at(x, y) - tractions[static_cast<std::size_t>(node)]).norm(), 1e-4) << node;
  }
  EXPECT_LT(traction_at(2, 0.3).norm(), 1e-5);
}

// Forces over a plane at some depth are those on the surface, and stresses are in balance: the divergence
// vanishes, by differences of its own.
TEST(HalfSpaceFields, AreInEquilibrium)
{
  const auto stress_at = [](const Vector3d &point)
  { return stress_of(field_body, fields_below(field_grid, field_body, some_tractions(), point).gradient); };
  const Vector3d point(0.2, -0.1, 0.3);
  constexpr double h = 1e-4;
  Vector3d divergence = Vector3d::Zero();
  for (Index d = 0; d < 3; ++d)
    divergence +=
        (stress_at(point + h * Vector3d::Unit(d)) - stress_at(point - h * Vector3d::Unit(d))).col(d) /
        (2 * h);
  EXPECT_LT(divergence.norm(), 1e-6 * stress_at(point).norm() / h * h + 1e-5);
  Vector3d force = Vector3d::Zero(), on_surface = Vector3d::Zero();
  for (const Vector3d &traction : some_tractions())
    on_surface += 0.7 * 0.5 * traction;
  constexpr int n = 100; // places = 40 depth tan(t), which are dense below the load
  constexpr double depth = 0.5;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
    {
      const double s = M_PI * ((i + 0.5) / n - 0.5), t = M_PI * ((j + 0.5) / n - 0.5);
      const double weight = std::pow(2 * depth * M_PI / n / std::cos(s) / std::cos(t), 2);
      force -= weight * stress_at({2 * depth * std::tan(s), 2 * depth * std::tan(t), depth}).col(2);
    }
  EXPECT_LT((force - on_surface).norm(), 0.01 * on_surface.norm());
}

// The mean of the displacement over a patch is that of the compliance of the grid.
TEST(HalfSpaceFields, MoveTheSurfaceAsTheCompliance)
{
  const GridHalfSpace half_space(field_grid, field_body);
  const std::vector<Vector3d> tractions = some_tractions();
  VectorXd force(18), moved;
  for (Index node = 0; node < 6; ++node)
  {
    const Vector3d &t = tractions[static_cast<std::size_t>(node)];
    force.segment<3>(3 * node) = 0.35 * Vector3d(t[2], t[0], t[1]);
  }
  half_space.vmult(moved, force);
  constexpr int n = 40;
  Vector3d mean = Vector3d::Zero();
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      mean += fields_below(field_grid, field_body, tractions,
                           {-0.35 + 0.7 * (i + 0.5) / n, -0.5 + 0.5 * (j + 0.5) / n, 0})
                  .displacement /
              (n * n);
  const Vector3d expected(moved[4], moved[5], moved[3]); // node 1: x, y, z of normal, x, y
  EXPECT_LT((mean - expected).norm(), 1e-3 * expected.norm());
}
} // namespace orthocone::test
