// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "body/fe/stress_patches.h"

#include "body/bodies.h"

#include <orthocone/body/body.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
namespace
{
BodyOptions small_block(const unsigned int degree)
{
  BodyOptions options;
  options.geometry.shape = BodyShape::box;
  options.geometry.sizes = {{3, 2, 1}};
  options.mesh.cells = {{3, 2, 2}};
  options.mesh.degree = degree;
  return options;
}
} // namespace

// A patch that finds no room is made anew, and is the same.
TEST(StressPatches, AreKeptWhileThereIsRoom)
{
  const Body body(small_block(2), ModelSymmetry());
  const StressPatches<3> kept(body.solid()), forgotten(body.solid(), 0);
  const auto material = body.solid().dof_handler().begin_active()->material_id();
  const auto first = kept.patch(0, material), made = forgotten.patch(0, material);
  EXPECT_EQ(kept.patch(0, material), first);
  EXPECT_NE(forgotten.patch(0, material), made);
  EXPECT_TRUE(made->inverse == first->inverse);
  EXPECT_TRUE(made->inverse_of_projected == first->inverse_of_projected);
}

// The projection of a polynomial that is one of the cell's own is this polynomial.
TEST(StressPatches, ProjectPolynomialsOfOneDegreeLessToThemselves)
{
  for (const unsigned int degree : {1, 2, 3})
  {
    BodyOptions options = small_block(degree);
    options.mesh.volumetric_quadrature = VolumetricQuadrature::projected;
    const Body body(options, ModelSymmetry());
    const StressPatches<3> patches(body.solid());
    const auto cell = body.solid().dof_handler().begin_active();
    const auto patch = patches.patch(cell->vertex_index(7), cell->material_id());
    const dealii::Point<3> place(0.3, 0.2, 0.1);
    for (const auto &[of, projection] : patch->members)
    {
      const Eigen::VectorXd projected = projection.transpose() * patches.values_in(of.cell, place);
      // The first polynomial is 1, and of degree 2 on the second one is linear.
      EXPECT_NEAR(projected[0], 1, 1e-12);
      if (degree >= 2)
      {
        EXPECT_NEAR(projected[1], patches.values(*patch, StressPatches<3>::image_of(place, of))[1], 1e-12);
      }
    }
  }
}
} // namespace orthocone::test
