// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Contact surfaces of two bodies that are curved, or stand anywhere in space.
#include "surface/surfaces.h"

#include <orthocone/surface/mortar.h>
#include <orthocone/surface/strip.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace orthocone::test
{
namespace
{
using Eigen::Index;
using Eigen::MatrixX3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double of_rounding = 1e-12;

using SpaceMap = std::function<Vector3d(const Vector3d &)>;

/// The places of a surface in the plane, mapped into space, and the unit vectors that another map gives
/// there.
ContactSurface mapped(ContactSurface surface, const SpaceMap &map, const SpaceMap &inward)
{
  for (ContactNode &node : surface.nodes)
  {
    const Vector3d at = map(node.place());
    node.inward = inward(at).normalized();
    node.position = {{at[0], at[1]}};
    node.height = at[2];
  }
  return surface;
}

PlaneMap scaled(const double u, const double v)
{
  return [=](const double a, const double b) { return Eigen::Vector2d(u * a, v * b); };
}

/// Faces that are parallelograms, on which the integrals are exact.
Eigen::Vector2d sheared(const double u, const double v)
{
  return {u + 0.15 * v, v};
}

/// A part of a cylinder about y of radius 10 mm, 1.2 rad wide and 4 mm long, as the bore of an upper body or
/// as the side of a lower one.
ContactSurface bore(const unsigned int cells, const unsigned int degree, const bool is_upper,
                    const double width = 0.6, const double length = 2)
{
  const auto around = [](const Vector3d &at)
  { return Vector3d(10 * std::sin(at[0]), at[1], 10 * std::cos(at[0])); };
  const double sign = is_upper ? 1 : -1;
  return mapped(square_surface(cells, degree, {}, scaled(width, length)), around,
                [=](const Vector3d &at) { return Vector3d(sign * at[0], 0, sign * at[2]); });
}

MatrixX3d places(const ContactSurface &surface)
{
  MatrixX3d all(surface.nodes.size(), 3);
  for (std::size_t i = 0; i < surface.nodes.size(); ++i)
    all.row(static_cast<Index>(i)) = surface.nodes[i].place();
  return all;
}

/// Half of the difference of moments when forces along the normals pass from one surface to the other, by
/// their sum of absolute values: forces at the nodes of the first and at those of the second surface.
double lost_moment(const ContactSurface &surface, const ContactSurface &other, const MatrixXd &map)
{
  Vector3d moment = Vector3d::Zero();
  const MatrixX3d seen = map * places(other);
  double scale = 0;
  for (std::size_t i = 0; i < surface.nodes.size(); ++i)
  {
    const Vector3d force = (1 + 0.3 * static_cast<double>(i % 3)) * surface.nodes[i].inward;
    const Vector3d from = surface.nodes[i].place(), to = seen.row(static_cast<Index>(i));
    moment += (from - to).cross(force);
    scale += force.norm() * from.norm();
  }
  return moment.norm() / scale;
}
} // namespace

/// Flat faces see each other as they do in the plane z = 0, wherever they stand.
TEST(OpposedFaces, AreThoseOfThePlaneInAnyPlane)
{
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(2, Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  const Vector3d shift(3, 1, -2);
  const auto moved = [&](const Vector3d &at) -> Vector3d { return turn * at + shift; };
  const auto normal = [&](const double sign)
  { return [=](const Vector3d &) -> Vector3d { return sign * turn.col(2); }; };
  for (const unsigned int degree : {1, 2, 3})
  {
    const ContactSurface flat = square_surface(3, degree, {}, sheared),
                         below = square_surface(4, 2, {}, scaled(1.2, 1.3));
    const MatrixXd expected = mortar_map(flat, below).map,
                   map = mortar_map(mapped(flat, moved, normal(1)), mapped(below, moved, normal(-1)),
                                    Facing::along_normals)
                             .map;
    EXPECT_LE((map - expected).lpNorm<Eigen::Infinity>(), 1e-11) << degree;
  }
}

/// Rigid displacements are seen, so that forces are kept; and distances and moments are those of the faces'
/// geometry: their errors fall with the power degree + 1 of the cells.
TEST(OpposedFaces, SeeACurvedSurfaceToTheOrderOfItsFaces)
{
  for (const unsigned int degree : {1, 2, 3})
  {
    std::vector<double> errors, moments;
    for (const unsigned int cells : {4, 8})
    {
      const ContactSurface upper = bore(cells, degree, true),
                           lower = bore(cells + 3, degree, false, 0.62, 2.1);
      const MortarMap mortar = mortar_map(upper, lower, Facing::along_normals);
      ASSERT_TRUE(mortar.cover.is_enough()) << mortar.cover.least;
      const MatrixXd map = mortar.map;
      EXPECT_LE((map.rowwise().sum() - VectorXd::Ones(map.rows())).lpNorm<Eigen::Infinity>(), of_rounding);
      errors.push_back(distances(upper, lower, mortar.map).lpNorm<Eigen::Infinity>());
      moments.push_back(lost_moment(upper, lower, map));
    }
    EXPECT_LE(errors[1], errors[0] / std::pow(2, degree + 0.5)) << degree << " " << errors[0];
    EXPECT_LE(moments[1], moments[0] / std::pow(2, degree) + of_rounding) << degree << " " << moments[0];
  }
}

/// Distances of concentric surfaces are the difference of their radii, overlaps negative, but for what cubic
/// faces of 0.2 rad miss of a circle.
TEST(OpposedFaces, MeasureGapsAlongTheNormals)
{
  const ContactSurface upper = bore(6, 3, true);
  for (const double gap : {0.05, -0.02})
  {
    ContactSurface lower = bore(9, 3, false, 0.63, 2.1);
    for (ContactNode &node : lower.nodes)
    {
      const double scale = (10 - gap) / 10;
      node.position[0] *= scale;
      node.height *= scale;
    }
    const MortarMap mortar = mortar_map(upper, lower, Facing::along_normals);
    const VectorXd found = distances(upper, lower, mortar.map);
    EXPECT_LE((found.array() - gap).matrix().lpNorm<Eigen::Infinity>(), 2e-5);
  }
}

/// All around a shaft each face of the bore sees the near side of the shaft, not the far one.
TEST(OpposedFaces, SeeTheNearSideOfAShaft)
{
  const ModelSymmetry in_plane_strain = ModelSymmetry::of_plane_strain(2.5, false);
  const auto circle = [](const unsigned int cells, const double radius, const double sign)
  {
    constexpr unsigned int degree = 2;
    ContactSurface surface;
    surface.degree = degree;
    for (unsigned int i = 0; i < degree * cells; ++i)
    {
      const double angle = 2 * 3.141592653589793 * i / (degree * cells);
      ContactNode node{
          {{radius * std::cos(angle), 0}}, 1, {}, {{true, true, true}}, radius * std::sin(angle)};
      node.inward = sign * Vector3d(std::cos(angle), 0, std::sin(angle));
      surface.nodes.push_back(node);
    }
    for (unsigned int cell = 0; cell < cells; ++cell)
      surface.faces.push_back({2 * cell, 2 * cell + 1, (2 * cell + 2) % (2 * cells)});
    return surface;
  };
  const ContactSurface upper = circle(16, 5.002, 1), lower = circle(22, 5, -1);
  const MortarMap mortar = mortar_map(upper, lower, in_plane_strain, Facing::along_normals);
  ASSERT_TRUE(mortar.cover.is_enough());
  EXPECT_LE((MatrixXd(mortar.map) * places(lower) - places(upper)).rowwise().norm().maxCoeff(), 0.02);
  EXPECT_LE((distances(upper, lower, mortar.map).array() - 0.002).abs().maxCoeff(), 2e-4);
}

TEST(OpposedFaces, AreNotCoveredByFacesThatLookAway)
{
  EXPECT_FALSE(mortar_map(bore(4, 2, true), bore(4, 2, true), Facing::along_normals).cover.is_enough());
  EXPECT_FALSE(mortar_map(bore(4, 2, true), bore(4, 2, false, 0.5), Facing::along_normals).cover.is_enough());
  EXPECT_TRUE(mortar_map(bore(4, 2, true), bore(4, 2, false), Facing::along_normals).cover.is_enough());
}
} // namespace orthocone::test
