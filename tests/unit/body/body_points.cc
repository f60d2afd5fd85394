// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "body/even_mesh.h"

#include <orthocone/body/body_points.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
namespace
{
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// The displacement that is `gradient` times the place.
Eigen::VectorXd linear(const Body &body, const Matrix3d &gradient)
{
  const BodyUnknowns &unknowns = body.unknowns();
  Eigen::VectorXd displacement(unknowns.n_dofs());
  for (unsigned int dof = 0; dof < unknowns.n_dofs(); ++dof)
    displacement[dof] = (gradient * unknowns.position(dof))[unknowns.direction(dof)];
  return displacement;
}

std::vector<Vector3d> points_between(const Vector3d &from, const Vector3d &to, const unsigned int n)
{
  std::vector<Vector3d> points;
  for (unsigned int i = 0; i < n; ++i)
    points.emplace_back(from + (to - from) * i / (n - 1));
  return points;
}

void expect_linear(const Body &body, const Matrix3d &gradient, const std::vector<Vector3d> &points)
{
  Strain strain;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = i; j < 3; ++j)
      strain[i][j] = (gradient(i, j) + gradient(j, i)) / 2;
  const Stress expected = Material(MaterialOptions()).stress(strain);
  const BodyPoints found(body, points);
  const std::vector<PointFields> fields = found.fields({linear(body, gradient), Strain()});
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    EXPECT_TRUE(found.is_inside(i)) << points[i].transpose();
    EXPECT_EQ(found.contact_face(i).has_value(), points[i][2] == 0) << points[i].transpose();
    EXPECT_LE((fields[i].displacement - gradient * points[i]).norm(), 1e-12);
    EXPECT_LE((fields[i].stress - expected).norm(), 1e-9 * expected.norm());
  }
  for (const PointFields &free : found.fields({linear(body, gradient), strain}))
    EXPECT_LE(free.stress.norm(), 1e-9 * expected.norm()) << "a strain without force, as that of heat";
}

BodyOptions box(const MeshOptions &mesh)
{
  BodyOptions options;
  options.geometry.shape = BodyShape::box;
  options.geometry.sizes = {{8, 6, 4}};
  options.mesh = mesh;
  return options;
}
} // namespace

// Along lines that cross cells of three sizes, run along their edges, and lie on the contact surface.
TEST(BodyPoints, HaveTheStrainOfALinearFieldWhereverTheyLie)
{
  Matrix3d gradient;
  gradient << 1e-3, 2e-3, -1e-3, 0.5e-3, -2e-3, 3e-3, 0.7e-3, -0.2e-3, 1.5e-3;
  for (const unsigned int degree : {1, 2, 3})
  {
    const Body body(box(uneven_mesh(degree)), ModelSymmetry());
    expect_linear(body, gradient, points_between({-4, -3, 4}, {4, 3, 0}, 41));
    expect_linear(body, gradient, points_between({0, 0, 0}, {0, 0, 4}, 17));
    expect_linear(body, gradient, points_between({-4, 0, 0}, {4, 0, 0}, 33));
  }
}

// On the axis the hoop strain is a limit.
TEST(BodyPoints, OfASectionHaveTheStrainOfTheWholeBody)
{
  const Matrix3d gradient = Vector3d(1e-3, 1e-3, -2e-3).asDiagonal();
  for (const unsigned int degree : {1, 2, 4})
  {
    BodyOptions options;
    options.mesh = even_mesh(degree, 1);
    const Body body(options, ModelSymmetry::of_revolution());
    expect_linear(body, gradient, points_between({0, 0, 0}, {0, 0, 10}, 11));
    expect_linear(body, gradient, points_between({0, 0, 0}, {10, 0, 0}, 11));
    expect_linear(body, gradient, points_between({0, 0, 7}, {10, 0, 1}, 23));
  }
}

TEST(BodyPoints, KnowWhatIsOutside)
{
  const Body body(box(uneven_mesh(2)), ModelSymmetry());
  const BodyPoints points(body, {{4.001, 0, 1}, {0, 0, -0.001}, {0, 3, 4.5}, {1e9, 0, 0}, {4, 3, 4}});
  for (const std::size_t i : {0, 1, 2, 3})
    EXPECT_FALSE(points.is_inside(i)) << i;
  EXPECT_TRUE(points.is_inside(4));
  EXPECT_FALSE(points.contact_face(4).has_value());
}
} // namespace orthocone::test
