// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "surface/surfaces.h"

#include <orthocone/base/numbers.h>
#include <orthocone/surface/half_plane.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
namespace
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double length_of_lines = 3;
const HalfSpace aluminium{70000, 0.3};

/// Lines from x = -1 to 1, or from 0, of one width but for the ends, which have half of it.
ContactSurface lines_of(const unsigned int cells, const bool is_half = false)
{
  ContactSurface surface;
  const double first = is_half ? 0 : -1, width = (1 - first) / cells;
  for (unsigned int i = 0; i <= cells; ++i)
  {
    const bool is_end = i == 0 || i == cells;
    surface.nodes.push_back({{{first + i * width, 0}},
                             width * length_of_lines / (is_end ? 2 : 1),
                             {},
                             {{!is_half || i > 0, true, true}}});
    if (i > 0)
      surface.faces.push_back({i - 1, i});
  }
  return surface;
}

VectorXd even_traction(const ContactSurface &surface, const Index direction)
{
  VectorXd forces = VectorXd::Zero(3 * static_cast<Index>(surface.nodes.size()));
  for (std::size_t i = 0; i < surface.nodes.size(); ++i)
    forces[3 * static_cast<Index>(i) + direction] = surface.nodes[i].area;
  return forces;
}

/// Displacement at x under an even traction of 1 MPa from -1 to 1, by (Johnson, 2.24): the integral of -k
/// ln(|x - s|/2).
double under_even_traction(const double x, const double k)
{
  const auto part = [](const double u) { return u == 0 ? 0 : u * (std::log(std::abs(u) / 2) - 1); };
  return -k * (part(x + 1) - part(x - 1));
}
} // namespace

TEST(HalfPlane, MovesUnderAnEvenTractionAsFlamantSays)
{
  const ContactSurface surface = lines_of(200);
  const MatrixXd w = half_plane_compliance(
      aluminium, surface, ModelSymmetry::of_plane_strain(length_of_lines, true), LocalAxes(0.));
  const double in_plane = 2 * (1 - 0.09) / (pi * 70000), antiplane = 2 * 1.3 / (pi * 70000);
  for (const auto &[direction, k] : {std::pair(0, in_plane), std::pair(1, in_plane), std::pair(2, antiplane)})
  {
    const VectorXd moved = w * even_traction(surface, direction);
    for (const std::size_t node : {10, 70, 100, 150})
    {
      const double exact = under_even_traction(surface.nodes[node].position[0], k);
      EXPECT_NEAR(moved[3 * static_cast<Index>(node) + direction] / exact, 1, 2e-5) << direction;
    }
  }
  // Pressure draws the surface towards its middle: u_x = -(1 - 2 nu)(1 + nu) p x / E.
  const VectorXd drawn = w * even_traction(surface, 0);
  EXPECT_NEAR(drawn[3 * 150 + 1], 0.4 * 1.3 / 70000 * 0.5, 1e-10 / 70000);
}

TEST(HalfPlane, IsSymmetricAndPositiveDefinite)
{
  const MatrixXd w = half_plane_compliance(
      aluminium, lines_of(30), ModelSymmetry::of_plane_strain(length_of_lines, true), LocalAxes(25.));
  EXPECT_EQ((w - w.transpose()).norm(), 0);
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<MatrixXd>(w).eigenvalues().minCoeff(), 0);
}

TEST(HalfPlane, HalfModelsMoveAsTheWholeSurface)
{
  constexpr unsigned int n = 20;
  const ContactSurface all = lines_of(2 * n), half = lines_of(n, true);
  const MatrixXd whole = half_plane_compliance(
                     aluminium, all, ModelSymmetry::of_plane_strain(length_of_lines, true), LocalAxes(0.)),
                 part = half_plane_compliance(aluminium, half,
                                              ModelSymmetry::of_plane_strain(length_of_lines, true, true),
                                              LocalAxes(0.));
  VectorXd on_half = VectorXd::Zero(3 * (n + 1)), on_all = VectorXd::Zero(3 * (2 * n + 1));
  for (Index i = 0; i <= n; ++i) // normal, x and y
    for (Index d = 0; d < 3; ++d)
    {
      const double force = d == 1 && i == 0 ? 0 : std::sin(static_cast<double>(1 + 3 * i + d));
      on_half[3 * i + d] = force;
      on_all[3 * (n + i) + d] += force;
      on_all[3 * (n - i) + d] += d == 1 ? -force : force;
    }
  const VectorXd moved = whole * on_all, moved_half = part * on_half;
  for (Index i = 0; i <= n; ++i)
    for (Index d = 0; d < 3; ++d)
      EXPECT_NEAR(moved[3 * (n + i) + d], moved_half[3 * i + d], 1e-12 * moved.lpNorm<Eigen::Infinity>());
}

TEST(HalfPlane, MeetsSectionsInPlaneStrainOnly)
{
  EXPECT_THROW(half_plane_compliance(aluminium, lines_of(2), ModelSymmetry(), LocalAxes(0.)),
               std::logic_error);
}
} // namespace orthocone::test
