// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "surface/surfaces.h"

#include <orthocone/surface/strip.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
namespace
{
using Eigen::VectorXd;

const ModelSymmetry in_plane_strain = ModelSymmetry::of_plane_strain(2.5, true);

ContactSurface lines_between(const double first, const double last, const unsigned int cells,
                             const unsigned int degree)
{
  ContactSurface surface;
  surface.degree = degree;
  for (const double x : places_of_line(first, last, cells, degree))
    surface.nodes.push_back({{{x, 0}}, 1, {}, {{true, true, true}}});
  for (unsigned int cell = 0; cell < cells; ++cell)
  {
    surface.faces.emplace_back();
    for (unsigned int i = 0; i <= degree; ++i)
      surface.faces.back().push_back(cell * degree + i);
  }
  return surface;
}

VectorXd at_nodes(const ContactSurface &surface, const double constant, const double slope)
{
  VectorXd values(surface.nodes.size());
  for (Eigen::Index i = 0; i < values.size(); ++i)
    values[i] = constant + slope * surface.nodes[static_cast<std::size_t>(i)].position[0];
  return values;
}
} // namespace

TEST(Strip, HasTheFacesOfItsLines)
{
  const ContactSurface lines = lines_between(-1, 1, 3, 2), strip = as_faces(lines, in_plane_strain);
  EXPECT_EQ(strip.nodes.size(), 3 * lines.nodes.size());
  ASSERT_EQ(strip.faces.size(), 3);
  const auto place = [&](const unsigned int i) { return strip.nodes[strip.faces[1][i]].position; };
  EXPECT_EQ(place(0)[1], 0);
  EXPECT_EQ(place(8)[1], 2.5);
  EXPECT_LT(place(0)[0], place(2)[0]);
  EXPECT_EQ(covered_share(strip, strip), 1);
}

// Lines of two meshes see each other as faces do: linear displacements stay linear, sums of forces stay the
// same.
TEST(Strip, JoinsLinesThatDoNotMatch)
{
  for (const unsigned int degree : {1, 2, 3})
    for (const unsigned int other_degree : {1, 2})
    {
      const ContactSurface upper = lines_between(-1, 1, 5, degree),
                           lower = lines_between(-1.5, 1.3, 7, other_degree);
      const MortarMap mortar = mortar_map(upper, lower, in_plane_strain);
      ASSERT_TRUE(mortar.cover.is_enough());
      EXPECT_EQ(mortar.map.rows(), static_cast<Eigen::Index>(upper.nodes.size()));
      EXPECT_EQ(mortar.map.cols(), static_cast<Eigen::Index>(lower.nodes.size()));
      const VectorXd seen = mortar.map * at_nodes(lower, 0.7, 0);
      EXPECT_LE((seen - at_nodes(upper, 0.7, 0)).norm(), 1e-12);
      const VectorXd forces = at_nodes(upper, 1, 0.3), passed = mortar.map.transpose() * forces;
      EXPECT_NEAR(passed.sum(), forces.sum(), 1e-12);
    }
  const MortarMap alike = mortar_map(lines_between(-1, 1, 4, 2), lines_between(-1, 1, 4, 2), in_plane_strain);
  EXPECT_LE((Eigen::MatrixXd(alike.map) - Eigen::MatrixXd::Identity(9, 9)).norm(), 1e-12);
}

TEST(Strip, IsNotCoveredBesideTheOtherOne)
{
  EXPECT_FALSE(mortar_map(lines_between(-1, 1, 4, 1), lines_between(-0.5, 1, 4, 1), in_plane_strain)
                   .cover.is_enough());
}
} // namespace orthocone::test
