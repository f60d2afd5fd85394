// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "refined_body.h"

#include <gtest/gtest.h>

namespace orthocone::test
{
using Eigen::VectorXd;

/// A pressed base: at most eight V-cycles for eight digits, whatever degree, shape, model and number of
/// cells.
TEST(VCycle, MakesConjugateGradientsFast)
{
  constexpr unsigned int most_iterations = 8;
  struct Case
  {
    BodyShape shape;
    unsigned int degree, refinements;
    SymmetryPlanes planes;
  };
  for (const Case &one : {Case{BodyShape::cylinder, 1, 2, quarter}, Case{BodyShape::cylinder, 2, 0, full},
                          Case{BodyShape::cylinder, 2, 0, half_x}, Case{BodyShape::cylinder, 2, 1, quarter},
                          Case{BodyShape::cylinder, 3, 1, quarter}, Case{BodyShape::box, 2, 1, quarter},
                          Case{BodyShape::box, 3, 1, half_y}})
  {
    const RefinedBody refined(shape_of(one.shape), even_mesh(one.degree, one.refinements), one.planes);
    EXPECT_LE(iterations(refined, pressed_base(refined), most_iterations), most_iterations)
        << one.degree << " " << one.refinements;
  }
}

/// Cells of three sizes cost no more.
TEST(VCycle, MakesConjugateGradientsFastBesideHangingNodes)
{
  constexpr unsigned int most_iterations = 8;
  for (const unsigned int degree : {1U, 2U, 3U})
  {
    const RefinedBody refined(default_geometry, uneven_mesh(degree), quarter);
    const auto forces = refined.all(random_numbers(refined.body.discretization.n_free(), 3));
    EXPECT_LE(iterations(refined, forces, most_iterations), most_iterations) << degree;
  }
}

/// With the projected divergence, the V-cycles do not grow with lambda without bound.
TEST(VCycle, SolvesNearlyIncompressibleBodies)
{
  constexpr unsigned int most_iterations = 55;
  for (const double poisson_ratio : {0.49, 0.4999})
  {
    MeshOptions mesh = uneven_mesh(2);
    mesh.volumetric_quadrature = VolumetricQuadrature::projected;
    MaterialOptions material;
    material.poisson_ratio = poisson_ratio;
    const RefinedBody refined(default_geometry, mesh, quarter, LocalAxes(0), CoarseMethod::by_size, material);
    const auto forces = refined.all(random_numbers(refined.body.discretization.n_free(), 3));
    EXPECT_LE(iterations(refined, forces, most_iterations), most_iterations) << poisson_ratio;
  }
}

TEST(ElasticSolver, SolvesAsTheFactorization)
{
  for (const MeshOptions &mesh : {even_mesh(2, 1), uneven_mesh(2)})
  {
    RefinedBody refined(default_geometry, mesh, quarter);
    const VectorXd forces = random_numbers(refined.body.discretization.n_free(), 5);
    const VectorXd u = refined.free(refined.elastic.solve(refined.all(forces), 1e-12));
    EXPECT_LE((refined.body.stiffness.vmult(u) - forces).norm(), 1e-11 * forces.norm());
    const VectorXd expected = refined.body.factor.solve(forces);
    EXPECT_LE((u - expected).norm(), 1e-10 * expected.norm());
  }
}

/// Proportional and combined forces cost no V-cycle any more, and the same ones give the same bytes.
TEST(ElasticSolver, StartsFromWhatItKnows)
{
  RefinedBody refined(default_geometry, even_mesh(2, 0), quarter);
  const unsigned int n = refined.body.discretization.n_free();
  const VectorXd a = random_numbers(n, 1), b = random_numbers(n, 2);
  const VectorXd first = refined.free(refined.elastic.solve(refined.all(a), 1e-12));
  refined.elastic.solve(refined.all(b), 1e-12);
  const unsigned long n_cycles = refined.cycle.n_cycles();
  const VectorXd again = refined.free(refined.elastic.solve(refined.all(a), 1e-12));
  EXPECT_EQ(first, again);
  const VectorXd both = refined.free(refined.elastic.solve(refined.all(2 * a - b), 1e-11));
  EXPECT_EQ(refined.cycle.n_cycles(), n_cycles);
  EXPECT_LE((refined.body.stiffness.vmult(both) - 2 * a + b).norm(), 2e-11 * (2 * a - b).norm());
}

/// A solver that is given what another one has settled answers as that, to the last bit.
TEST(ElasticSolver, GoesOnFromSettledStates)
{
  RefinedBody refined(default_geometry, even_mesh(2, 0), quarter);
  const unsigned int n = refined.body.discretization.n_free();
  ElasticSolver other(refined.stiffness, refined.cycle);
  for (const unsigned int seed : {1U, 2U, 3U})
  {
    const VectorXd forces = random_numbers(n, seed);
    refined.elastic.solve(refined.all(forces + random_numbers(n, 10)), 1e-9); // what was only tried
    other.restore(refined.elastic.forget_trials(refined.all(forces), 1e-12));
  }
  const VectorXd next = random_numbers(n, 3) + 0.1 * random_numbers(n, 4);
  EXPECT_EQ(refined.free(refined.elastic.solve(refined.all(next), 1e-12)),
            refined.free(other.solve(refined.all(next), 1e-12)));
}
} // namespace orthocone::test
