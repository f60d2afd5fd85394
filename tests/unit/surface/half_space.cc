// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/half_space.h>

#include "surface/half_space_patches.h"
#include "surface/surfaces.h"

#include <orthocone/base/numbers.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>

namespace orthocone::test
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
constexpr HalfSpace steel{210000, 0.3};

MatrixXd compliance(const ContactSurface &surface, const SymmetryPlanes &planes = {},
                    const HalfSpace &half_space = steel, const LocalAxes &axes = LocalAxes(0))
{
  return half_space_compliance(half_space, surface, planes, axes);
}

/// Forces of a traction (normal, x, y) of 1 MPa: the areas of the patches.
VectorXd uniform(const ContactSurface &surface, const Index direction)
{
  const WholeSurface whole = ModelSymmetry().whole(surface);
  const auto patches = surface_patches(surface, whole, 2);
  VectorXd force = VectorXd::Zero(3 * static_cast<Index>(surface.nodes.size()));
  for (std::size_t i = 0; i < patches.size(); ++i)
    force[3 * static_cast<Index>(whole.nodes[i].node) + direction] = patches[i].area;
  return force;
}

Index node_at(const ContactSurface &surface, const double x, const double y)
{
  for (std::size_t i = 0; i < surface.nodes.size(); ++i)
    if (std::hypot(surface.nodes[i].position[0] - x, surface.nodes[i].position[1] - y) < 1e-9)
      return static_cast<Index>(i);
  return -1;
}

/// Mean over the unit square of the potential of itself: 4/3 (1 - sqrt 2) + 4 log(1 + sqrt 2).
const double square_potential = 4. / 3 * (1 - std::sqrt(2.)) + 4 * std::log(1 + std::sqrt(2.));
} // namespace

TEST(HalfSpacePatches, TileTheSurface)
{
  for (const unsigned int degree : {1, 2, 3})
  {
    const ContactSurface surface = square_surface(4, degree);
    EXPECT_NEAR(uniform(surface, 0).sum(), 4, 1e-12);
    const WholeSurface whole = ModelSymmetry().whole(surface);
    for (const SurfacePatch &patch : surface_patches(surface, whole, 3))
    {
      double shares = 0;
      for (const auto &point : patch.points)
        shares += point.share;
      EXPECT_NEAR(shares, 1, 1e-14);
      EXPECT_LE(patch.edges.size(), 8U);
    }
  }
}

/// Cells that are nine times as large from the middle of each side on, sheared so that they are no
/// rectangles.
Eigen::Vector2d abruptly_graded(const double u, const double v)
{
  const auto graded = [](const double t)
  { return std::abs(t) <= 0.5 ? 0.2 * t : std::copysign(0.1 + 1.8 * (std::abs(t) - 0.5), t); };
  return {graded(u) + 0.2 * graded(v), graded(v)};
}

// Gap and body are taken at the node: beside it, the displacement of a slope is that of another place.
TEST(HalfSpacePatches, ForceHasItsCentreAtTheNode)
{
  for (const unsigned int degree : {1, 2, 3})
  {
    const ContactSurface surface = square_surface(4, degree, {}, abruptly_graded);
    const WholeSurface whole = ModelSymmetry().whole(surface);
    const auto patches = surface_patches(surface, whole, 3);
    const unsigned int side = 4 * degree + 1;
    for (std::size_t i = 0; i < patches.size(); ++i)
    {
      const std::size_t node = whole.nodes[i].node;
      const auto &at = surface.nodes[node].position;
      Eigen::Vector2d centre = Eigen::Vector2d::Zero();
      for (const auto *const points : {&patches[i].points, &patches[i].close_points})
        for (const SurfacePatch::Point &point : *points)
        {
          EXPECT_GT(point.share, 0);
          centre += point.share / 2 * point.position;
        }
      EXPECT_LE((centre - patches[i].centre).norm(), 1e-12);
      const std::size_t column = node % side, row = node / side;
      const bool is_inside = column > 0 && column + 1 < side && row > 0 && row + 1 < side;
      const bool is_on_two_lines = column % degree == 0 && row % degree == 0;
      EXPECT_TRUE(!is_inside || !is_on_two_lines ||
                  (centre - Eigen::Vector2d(at[0], at[1])).norm() <= 1e-8 * patches[i].radius)
          << node;
    }
  }
}

// Turned by a right angle, x is y and y is -x.
TEST(HalfSpace, TurnsWithTheSurface)
{
  const ContactSurface surface = square_surface(6, 1, {}, abruptly_graded);
  ContactSurface turned = surface;
  for (ContactNode &node : turned.nodes)
    node.position = {{-node.position[1], node.position[0]}};
  const MatrixXd w = compliance(surface), of_turned = compliance(turned);
  const Index n = w.rows() / 3;
  MatrixXd turn = MatrixXd::Zero(3 * n, 3 * n);
  for (Index i = 0; i < n; ++i)
    turn.block<3, 3>(3 * i, 3 * i) << 1, 0, 0, 0, 0, -1, 0, 1, 0; // normal, x, y
  EXPECT_LE((of_turned - turn * w * turn.transpose()).lpNorm<Eigen::Infinity>(),
            1e-9 * w.lpNorm<Eigen::Infinity>());
}

// Whatever the patches, a uniform pressure does the same work: all that is wrong of it is quadrature.
double error_of_work(const unsigned int degree, const unsigned int cells, const unsigned int n_points)
{
  const double exact = 8 * (1 - 0.09) / (pi * 210000) * square_potential; // side 2
  const ContactSurface surface = square_surface(cells, degree);
  const VectorXd force = uniform(surface, 0);
  return std::abs(force.dot(compliance(surface, {}, {210000, 0.3, n_points}) * force) / exact - 1);
}

// The patches of one face of degree 1 touch each other. What one of them does has x log(x) at its edges,
// which n Gauss points integrate to 1/n^4.
TEST(HalfSpace, QuadratureHasItsOrderInPoints)
{
  for (const unsigned int n : {1, 2, 4, 8})
  {
    const double order = std::log2(error_of_work(1, 1, n) / error_of_work(1, 1, 2 * n));
    EXPECT_NEAR(order, 3.75, 0.25) << n;
  }
  EXPECT_LT(error_of_work(1, 1, 16), 2e-7);
}

// Far patches see each other through few points: this leaves a share of what each patch does, and patches
// that are half as large do half as much.
TEST(HalfSpace, QuadratureHasItsOrderInCells)
{
  EXPECT_LT(error_of_work(2, 1, 2), 1e-4);
  EXPECT_LT(error_of_work(2, 8, 2), 1.1e-4);
  EXPECT_LT(error_of_work(2, 8, 4), 4e-5);
  EXPECT_GT(std::log2(error_of_work(2, 8, 2) / error_of_work(2, 16, 2)), 0.8);
}

// Johnson, 3.3: p a (1 - nu^2) / (pi E) times four integrals of corners.
TEST(HalfSpace, UniformPressureOnASquareConvergesToLove)
{
  const double centre = 4 * std::log(1 + std::sqrt(2.)) * 2 / pi * (1 - 0.09) / 210000;
  std::vector<double> middle, corner;
  for (const unsigned int cells : {2, 4, 8})
  {
    const ContactSurface surface = square_surface(cells, 2);
    const VectorXd u = compliance(surface) * uniform(surface, 0);
    middle.push_back(std::abs(u[3 * node_at(surface, 0, 0)] / centre - 1));
    corner.push_back(std::abs(u[3 * node_at(surface, 1, 1)] / (centre / 2) - 1)); // mean of a patch
  }
  EXPECT_LT(middle[1], middle[0] / 3); // the mean over a patch, of second order before quadrature is felt
  EXPECT_LT(middle[2], middle[1] / 3);
  EXPECT_LT(middle[2], 5e-4);
  EXPECT_LT(corner[2], corner[1] / 1.7);
}

// Johnson, (3.29) and (3.30), and Cerruti's integral at the centre.
TEST(HalfSpace, UniformTractionsOnACircleConvergeToClosedForms)
{
  const double nu = 0.3, modulus = 210000 / (1 - nu * nu);
  std::vector<std::array<double, 5>> errors;
  for (const unsigned int cells : {4, 8})
  {
    const ContactSurface surface = square_surface(cells, 2, {}, on_disc);
    const MatrixXd w = compliance(surface);
    const VectorXd pressure = uniform(surface, 0);
    const VectorXd u = w * pressure, v = w * uniform(surface, 1);
    const Index centre = node_at(surface, 0, 0), rim = node_at(surface, 1, 0),
                inner = node_at(surface, 0.5, 0);
    errors.push_back({{u[3 * centre] * modulus / 2 - 1, u[3 * rim] * modulus * pi / 4 - 1,
                       pressure.dot(u) * modulus * 3 / 16 - 1,
                       // r presses down where it moves up, and the surface towards the axis then.
                       u[3 * inner + 1] / ((1 - 2 * nu) * (1 + nu) * 0.5 / (2 * 210000)) - 1,
                       v[3 * centre + 1] / ((2 - nu) * (1 + nu) / 210000) - 1}});
  }
  for (const unsigned int smooth : {0, 2, 3, 4})
    EXPECT_LT(std::abs(errors[1][smooth]), std::abs(errors[0][smooth]) / 3) << smooth;
  EXPECT_LT(std::abs(errors[1][0]), 2e-3);
  EXPECT_LT(std::abs(errors[1][3]), 1e-3);
  EXPECT_LT(std::abs(errors[1][1]), std::abs(errors[0][1]) / 1.5);
}

TEST(HalfSpace, IsSymmetricAndPositiveDefinite)
{
  for (const unsigned int degree : {1, 2, 3})
    for (const SymmetryPlanes &planes :
         {SymmetryPlanes{}, SymmetryPlanes{true, false}, SymmetryPlanes{true, true}})
      for (const double nu : {-0.9, 0., 0.3, 0.499})
      {
        const ContactSurface surface = square_surface(4, degree, planes, on_disc);
        std::vector<double> angles;
        for (std::size_t i = 0; i < surface.nodes.size(); ++i)
          angles.push_back((planes.n_copies() == 1 ? 3 : 90) * static_cast<double>(i));
        const MatrixXd w = compliance(surface, planes, {210000, nu}, LocalAxes(angles));
        EXPECT_LE((w - w.transpose()).lpNorm<Eigen::Infinity>(), 1e-15 * w.lpNorm<Eigen::Infinity>());
        const VectorXd eigenvalues = w.selfadjointView<Eigen::Lower>().eigenvalues();
        EXPECT_GT(eigenvalues.minCoeff(), 0.2 * w.diagonal().minCoeff());
      }
}

// Forces that are as symmetric as the model; those on a plane of symmetry are shared.
TEST(HalfSpace, ModelsMoveAsTheWholeSurface)
{
  const auto force_at = [](const ContactNode &node)
  {
    const double x = node.position[0], y = node.position[1];
    return Eigen::Vector3d(1 + x * x + 2 * y * y * y * y, x * (1 + y * y), y * (2 + x * x));
  };
  const auto moved = [&](const ContactSurface &surface, const ModelSymmetry &symmetry)
  {
    const VectorXd shares = symmetry.force_shares(surface);
    VectorXd force(3 * static_cast<Index>(surface.nodes.size()));
    for (std::size_t i = 0; i < surface.nodes.size(); ++i)
      force.segment<3>(3 * static_cast<Index>(i)) =
          shares[static_cast<Index>(i)] * force_at(surface.nodes[i]);
    return VectorXd(half_space_compliance(steel, surface, symmetry, LocalAxes(0)) * force);
  };
  const ContactSurface whole = square_surface(6, 2, {}, on_disc);
  const VectorXd expected = moved(whole, ModelSymmetry());
  for (const SymmetryPlanes &planes :
       {SymmetryPlanes{true, false}, SymmetryPlanes{false, true}, SymmetryPlanes{true, true}})
  {
    const ContactSurface part = square_surface(6, 2, planes, on_disc);
    const VectorXd u = moved(part, planes);
    for (std::size_t i = 0; i < part.nodes.size(); ++i)
    {
      const Index other = node_at(whole, part.nodes[i].position[0], part.nodes[i].position[1]);
      ASSERT_GE(other, 0);
      EXPECT_LE((u.segment<3>(3 * static_cast<Index>(i)) - expected.segment<3>(3 * other)).norm(),
                1e-12 * expected.lpNorm<Eigen::Infinity>());
    }
  }
}

// Where a face borders on smaller ones, nodes stand for parts of the hanging places' patches.
TEST(HalfSpace, PassesAUniformPressureOverHangingNodes)
{
  ContactSurface surface;
  const auto add = [&](const double x, const double y) {
    surface.nodes.push_back({{{x, y}}, 1, {}, {{true, true, true}}});
  };
  for (const auto &[x, y] :
       {std::array<double, 2>{{0, 0}}, {{2, 0}}, {{0, 2}}, {{2, 2}}, {{3, 0}}, {{3, 1}}, {{3, 2}}})
    add(x, y);
  surface.hanging.push_back({{{{2, 1}}, 0, {}, {{true, true, true}}}, {{1, 0.5}, {3, 0.5}}});
  surface.faces = {{0, 1, 2, 3}, {1, 4, 7, 5}, {7, 5, 3, 6}};
  const MatrixXd w = compliance(surface);
  EXPECT_EQ((w - w.transpose()).lpNorm<Eigen::Infinity>(), 0);
  VectorXd force = VectorXd::Zero(21); // areas: quarters of faces, and halves of the hanging one's
  const std::array<double, 7> areas{{1, 1.5, 1, 1.5, 0.25, 0.5, 0.25}};
  for (Index i = 0; i < 7; ++i)
    force[3 * i] = areas[static_cast<std::size_t>(i)];
  // The mean over a rectangle a x b of its own potential, a longer than b (A. E. H. Love).
  const double a = 3, b = 2, d = std::hypot(a, b);
  const double mean = 2 * (a * a * b * std::asinh(b / a) + a * b * b * std::asinh(a / b) -
                           (d * d * d - a * a * a - b * b * b) / 3);
  EXPECT_NEAR(force.dot(w * force) / ((1 - 0.09) / (pi * 210000) * mean), 1, 1e-3);
}

TEST(HalfSpace, HasNoSection)
{
  EXPECT_THROW(
      half_space_compliance(steel, square_surface(1, 1), ModelSymmetry::of_revolution(), LocalAxes(0)),
      std::logic_error);
}
} // namespace orthocone::test
