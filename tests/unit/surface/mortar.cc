// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/mortar.h>

#include "surface/surfaces.h"

#include <gtest/gtest.h>

namespace orthocone::test
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
constexpr double rounding = 1e-12;

PlaneMap turned_disc(const double angle, const double radius = 1)
{
  return [=](const double u, const double v) -> Eigen::Vector2d
  { return radius * (Eigen::Rotation2Dd(angle) * on_disc(u, v)); };
}

MatrixXd positions(const ContactSurface &surface)
{
  MatrixXd places(surface.nodes.size(), 2);
  for (std::size_t i = 0; i < surface.nodes.size(); ++i)
    places.row(static_cast<Index>(i)) << surface.nodes[i].position[0], surface.nodes[i].position[1];
  return places;
}

/// Forces of a unit pressure on the square (-1, 1)^2: the weights of Gauss and Lobatto, by the edges of a
/// cell.
VectorXd unit_pressure(const unsigned int cells, const unsigned int degree)
{
  static const std::array<std::vector<double>, 3> weights{
      {{0.5, 0.5}, {1. / 6, 4. / 6, 1. / 6}, {1. / 12, 5. / 12, 5. / 12, 1. / 12}}};
  VectorXd line = VectorXd::Zero(cells * degree + 1);
  for (unsigned int cell = 0; cell < cells; ++cell)
    for (unsigned int i = 0; i <= degree; ++i)
      line[cell * degree + i] += 2. / cells * weights[degree - 1][i];
  const MatrixXd both = line * line.transpose();
  return Eigen::Map<const VectorXd>(both.data(), both.size());
}
} // namespace

TEST(Mortar, IsTheIdentityBetweenLikeSurfaces)
{
  for (const unsigned int degree : {1, 2, 3})
  {
    const ContactSurface surface = square_surface(2, degree, {}, on_disc);
    const MortarMap mortar = mortar_map(surface, surface);
    EXPECT_NEAR(mortar.cover.least, 1, rounding);
    const MatrixXd map = mortar.map;
    EXPECT_LE((map - MatrixXd::Identity(map.rows(), map.cols())).lpNorm<Eigen::Infinity>(), 1e-11) << degree;
  }
}

/// So sums of forces and moments are the same on both sides.
TEST(Mortar, SeesRigidMotionsAndTheirLinearKin)
{
  for (const unsigned int degree : {1, 2, 3})
    for (const unsigned int other_degree : {1, 2, 3})
    {
      const ContactSurface surface = square_surface(2, degree, {}, on_disc);
      const ContactSurface other = square_surface(3, other_degree, {}, turned_disc(0.3, 1.3));
      const MatrixXd map = mortar_map(surface, other).map;
      ASSERT_GT(map.size(), 0);
      EXPECT_LE((map.rowwise().sum() - VectorXd::Ones(map.rows())).lpNorm<Eigen::Infinity>(), rounding);
      EXPECT_LE((map * positions(other) - positions(surface)).lpNorm<Eigen::Infinity>(), rounding);
    }
}

TEST(Mortar, PassesAUniformPressureThroughUnequalCells)
{
  for (const unsigned int degree : {1, 2, 3})
    for (const unsigned int other_degree : {1, 2, 3})
    {
      const MatrixXd map = mortar_map(square_surface(4, degree), square_surface(3, other_degree)).map;
      EXPECT_LE((map.transpose() * unit_pressure(4, degree) - unit_pressure(3, other_degree))
                    .lpNorm<Eigen::Infinity>(),
                rounding);
    }
}

/// Outlines that only resemble each other: what one lacks of the other has no part in the map.
TEST(Mortar, JoinsDiscsOfUnequalCells)
{
  const ContactSurface surface = square_surface(3, 2, {}, on_disc);
  const ContactSurface other = square_surface(4, 2, {}, turned_disc(0.3));
  const MortarMap mortar = mortar_map(surface, other);
  EXPECT_GT(mortar.cover.least, 0.97);
  EXPECT_LT(mortar.cover.least, 1);
  EXPECT_LE((mortar.map * positions(other) - positions(surface)).lpNorm<Eigen::Infinity>(), rounding);
}

TEST(Mortar, IsRefusedWhereFacesAreNotCovered)
{
  const auto scaled = [](const double scale)
  { return [=](const double u, const double v) { return Eigen::Vector2d(scale * u, scale * v); }; };
  const ContactSurface surface = square_surface(2, 2);
  EXPECT_GT(mortar_map(surface, square_surface(2, 1, {}, scaled(0.95))).map.size(), 0);
  const MortarMap small = mortar_map(surface, square_surface(2, 1, {}, scaled(0.94)));
  EXPECT_EQ(small.map.size(), 0);
  EXPECT_NEAR(small.cover.least, 0.94 * 0.94, rounding);
  EXPECT_NEAR(std::abs(small.cover.uncovered[0]), 0.5, rounding);
}

TEST(Mortar, CoverIsKnownWithoutTheMap)
{
  for (const double size : {0.7, 1., 1.3})
  {
    const ContactSurface surface = square_surface(3, 2, {}, on_disc);
    const ContactSurface other = square_surface(4, 3, {}, turned_disc(0.3, size));
    const SurfaceCover cover = surface_cover(surface, other), of_map = mortar_map(surface, other).cover;
    EXPECT_NEAR(cover.least, of_map.least, rounding);
    EXPECT_EQ(cover.uncovered, of_map.uncovered);
    EXPECT_EQ(cover.is_enough(), size >= 1);
  }
}

/// Fewer rows than are mapped at a time, as many, and some more.
TEST(MappedCompliance, IsTheProductAndSymmetricToTheLastBit)
{
  std::srand(1);
  for (const Index n : {3, 16, 41})
  {
    const Index m = n + 7;
    const MatrixXd factor = MatrixXd::Random(m, m), compliance = factor * factor.transpose();
    MatrixXd map = MatrixXd::Random(n, m);
    map = (map.array().abs() < 0.3).select(map, 0).eval();
    const MatrixXd mapped = mapped_compliance(map.sparseView(), DenseView(compliance.data(), m, m));
    const MatrixXd expected = map * compliance * map.transpose();
    EXPECT_EQ((mapped - mapped.transpose()).lpNorm<Eigen::Infinity>(), 0);
    EXPECT_LE((mapped - expected).norm(), 1e-14 * compliance.norm());
  }
}
} // namespace orthocone::test
