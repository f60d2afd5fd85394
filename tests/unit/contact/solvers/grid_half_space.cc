// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Contact of half-spaces without a mesh and without a matrix, against closed forms.
#include <orthocone/surface/grid_half_space.h>

#include "contact/contact_problems.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace orthocone::test
{
using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace
{
/// A ball of radius 1 on a plane of the same material, in units of the radius and of E* = E / (2 (1 - nu^2))
/// = 1, pressed by `approach`: the contact has the radius a = sqrt(approach), and carries 4/3 a^3 (Hertz).
class Ball
{
public:
  Ball(const Index n, const double poisson_ratio, const FrictionLaw &law, const double approach)
      : approach_(approach),
        grid_(grid_of(n, std::sqrt(approach))),
        half_space_(grid_, half_space(poisson_ratio), half_space(poisson_ratio)),
        system_(half_space_, FrictionLaws(grid_.n_nodes(), law))
  {
  }

  double radius() const { return std::sqrt(approach_); }
  double hertz() const { return 4. / 3 * std::pow(radius(), 3); }
  double area() const { return grid_.width * grid_.height; }

  /// The forces where the ball is moved along x, from a state without friction forces.
  VectorXd solved(const double motion)
  {
    const ContactStep step(system_, free(motion));
    VectorXd force = VectorXd::Zero(step.n_unknowns());
    report = solve_step(step, solver_options("newton", 1e-8), force);
    EXPECT_TRUE(report.converged) << report.residual;
    return force;
  }

  SolverReport report;

private:
  static HalfSpace half_space(const double poisson_ratio)
  {
    return {2 * (1 - poisson_ratio * poisson_ratio), poisson_ratio};
  }
  static SurfaceGrid grid_of(const Index n, const double radius)
  {
    const double width = 2.4 * radius / static_cast<double>(n);
    return {n, n, width, width};
  }
  VectorXd free(const double motion) const
  {
    VectorXd q(3 * grid_.n_nodes());
    for (Index node = 0; node < grid_.n_nodes(); ++node)
    {
      const auto middle = [](const Index n) { return static_cast<double>(n - 1) / 2; };
      const double x = grid_.width * (static_cast<double>(node % grid_.n_x) - middle(grid_.n_x));
      const double y = grid_.height * (static_cast<double>(node / grid_.n_x) - middle(grid_.n_y));
      q.segment<3>(3 * node) << (x * x + y * y) / 2 - approach_, motion, 0;
    }
    return q;
  }

  double approach_;
  SurfaceGrid grid_;
  GridHalfSpace half_space_;
  ContactSystem system_;
};

/// Waves of no common period, as a rough surface has them, about 1 high at most; i and j count patches.
double rough(const Index node, const Index n)
{
  const auto i = static_cast<double>(node % n), j = static_cast<double>(node / n);
  return std::cos(2.3 * i + 0.7 * j) + std::sin(1.1 * i - 1.9 * j) + std::cos(0.4 * i + 2.9 * j);
}

/// Normal forces (n) on a rough surface without friction, W p = -gap where p > 0, by factorizations of the
/// normal part of W between the nodes that touch (primal-dual active sets).
VectorXd pressed(const GridHalfSpace &half_space, const VectorXd &gap)
{
  const SurfaceGrid &grid = half_space.grid();
  const Index n = grid.n_nodes();
  Eigen::MatrixXd w(n, n);
  for (Index a = 0; a < n; ++a)
    for (Index b = 0; b < n; ++b)
      w(a, b) = half_space.block(a % grid.n_x - b % grid.n_x, a / grid.n_x - b / grid.n_x)(0, 0);
  VectorXd force = VectorXd::Zero(n);
  std::vector<Index> touching, before{-1};
  for (unsigned int k = 0; k < 50 && touching != before; ++k)
  {
    before = touching;
    const VectorXd open = gap + w * force;
    touching.clear();
    for (Index a = 0; a < n; ++a)
      if (force[a] - open[a] / w(0, 0) > 0)
        touching.push_back(a);
    force.setZero();
    const Eigen::MatrixXd between = w(touching, touching);
    const VectorXd right_side = -gap(touching), solution = between.llt().solve(right_side);
    force(touching) = solution;
  }
  EXPECT_EQ(touching, before);
  return force;
}

double sum(const VectorXd &force, const Index component)
{
  double sum = 0;
  for (Index i = component; i < force.size(); i += 3)
    sum += force[i];
  return sum;
}
} // namespace

// Force and largest pressure, which is 2 a / pi E*; second order in the width of the patches.
TEST(GridHalfSpaceContact, IsHertz)
{
  double last_error = 1;
  for (const Index n : {16, 32, 64})
  {
    Ball ball(n, 0.3, OrthotropicFriction{0, 0, 1, 1}, 0.01);
    const VectorXd force = ball.solved(0);
    const double error = std::abs(sum(force, 0) / ball.hertz() - 1);
    EXPECT_LT(error, 0.5 * last_error) << n;
    last_error = error;
    if (n == 64)
    {
      EXPECT_LT(error, 5e-3);
      EXPECT_NEAR(force.maxCoeff() / ball.area(), 2 * ball.radius() / M_PI, 5e-3 * 2 * ball.radius() / M_PI);
    }
  }
}

// At nu = 0 shear tractions move what they act on along themselves alone, as Cattaneo and Mindlin assume:
// what slips carries mu times the pressure of Hertz, less that of a smaller contact, whose radius obeys c^2 =
// a^2 - motion / mu (Jaeger; Ciavarella).
TEST(GridHalfSpaceContact, IsCattaneoWithoutPoissonEffect)
{
  constexpr double mu = 0.3, approach = 0.01;
  Ball ball(64, 0, OrthotropicFriction{mu, mu, 1, 1}, approach);
  for (const double share : {0.2, 0.5, 0.8})
  {
    const double c = ball.radius() * std::sqrt(1 - share);
    const VectorXd force = ball.solved(share * mu * approach);
    const double exact = -mu * (ball.hertz() - 4. / 3 * c * c * c);
    EXPECT_NEAR(sum(force, 1), exact, 5e-3 * std::abs(exact)) << share;
    EXPECT_NEAR(sum(force, 2), 0, 1e-6 * std::abs(exact));
  }
}

// Iterations of Newton's method do not grow with the grid, also where the law is orthotropic and slip is not
// associated.
TEST(GridHalfSpaceContact, TakesAsManyIterationsOnAFinerGrid)
{
  for (const OrthotropicFriction &law : {case_a, case_b, case_c})
  {
    unsigned int most = 0;
    for (const Index n : {16, 32, 64})
    {
      Ball ball(n, 0.3, law, 0.01);
      ball.solved(0.5 * law.mu_x * 0.01);
      most = std::max(most, ball.report.iterations);
    }
    EXPECT_LE(most, 15U);
  }
}

// A rough surface touches at the same nodes, and with the same forces, where products are by FFT and where
// they are those of a matrix that its own solver works with; with friction that is orthotropic and not
// associated.
TEST(GridHalfSpaceContact, IsThatOfTheDenseMatrix)
{
  constexpr Index n = 16;
  const SurfaceGrid grid{n, n, 0.1, 0.12};
  const GridHalfSpace half_space(grid, {1000, 0.3});
  Eigen::MatrixXd w(3 * n * n, 3 * n * n);
  for (Index a = 0; a < n * n; ++a)
    for (Index b = 0; b < n * n; ++b)
      w.block<3, 3>(3 * a, 3 * b) = half_space.block(a % n - b % n, a / n - b / n);
  const DenseCompliance dense(w);
  VectorXd q(3 * n * n);
  for (Index node = 0; node < n * n; ++node)
  {
    q.segment<3>(3 * node) << 1e-3 * (rough(node, n) - 0.5), 3e-4, -1e-4;
  }
  const FrictionLaws laws(n * n, OrthotropicFriction{0.3, 0.15, 1, 0.4});
  const auto solved = [&](const Compliance &compliance)
  {
    const ContactSystem system(compliance, laws);
    const ContactStep step(system, q);
    VectorXd force = VectorXd::Zero(step.n_unknowns());
    EXPECT_TRUE(solve_step(step, solver_options("newton", 1e-13), force).converged);
    return force;
  };
  const VectorXd by_matrix = solved(dense), by_transform = solved(half_space);
  EXPECT_LT((by_transform - by_matrix).norm(), 1e-9 * by_matrix.norm());
  EXPECT_GT((by_matrix(Eigen::seqN(0, n * n, 3)).array() > 0).count(), n * n / 8) << "some patches touch";
  EXPECT_LT((by_matrix(Eigen::seqN(0, n * n, 3)).array() > 0).count(), n * n) << "and some do not";
}

TEST(GridHalfSpaceContact, PressesARoughSurfaceAsActiveSetsDo)
{
  constexpr Index n = 32;
  const GridHalfSpace half_space({n, n, 0.1, 0.12}, {1000, 0.3});
  const VectorXd gap =
      VectorXd::NullaryExpr(n * n, [](const Index node) { return 1e-3 * (rough(node, n) - 1); });
  VectorXd q = VectorXd::Zero(3 * n * n);
  q(Eigen::seqN(0, n * n, 3)) = gap;
  const ContactSystem system(half_space, FrictionLaws(n * n, OrthotropicFriction{0, 0, 1, 1}));
  const ContactStep step(system, q);
  VectorXd force = VectorXd::Zero(step.n_unknowns());
  EXPECT_TRUE(solve_step(step, solver_options("newton", 1e-13), force).converged);
  const VectorXd expected = pressed(half_space, gap);
  EXPECT_LE((force(Eigen::seqN(0, n * n, 3)) - expected).norm(), 1e-9 * expected.norm());
}

// Without Poisson effect, a rough surface that is sheared along an axis of friction carries mu times the
// pressure less that of a smaller approach, by motion / mu: the theorem of Jaeger and Ciavarella, whatever
// the slip rule, since slip is along the axis.
TEST(GridHalfSpaceContact, ShearsARoughSurfaceAsTwoPressedOnes)
{
  constexpr Index n = 24;
  constexpr double mu = 0.3, motion = 2e-4;
  const GridHalfSpace half_space({n, n, 0.1, 0.12}, {1000, 0}, HalfSpace{1000, 0});
  VectorXd gap(n * n), q(3 * n * n);
  for (Index node = 0; node < n * n; ++node)
  {
    gap[node] = 1e-3 * (rough(node, n) - 1);
    q.segment<3>(3 * node) << gap[node], motion, 0;
  }
  const ContactSystem system(half_space, FrictionLaws(n * n, OrthotropicFriction{mu, 0.15, 1, 0.4}));
  const ContactStep step(system, q);
  VectorXd force = VectorXd::Zero(step.n_unknowns());
  EXPECT_TRUE(solve_step(step, solver_options("newton", 1e-12), force).converged);
  const VectorXd all = pressed(half_space, gap),
                 less = pressed(half_space, gap + VectorXd::Constant(n * n, motion / mu));
  EXPECT_LE((force(Eigen::seqN(0, n * n, 3)) - all).norm(), 1e-9 * all.norm());
  EXPECT_LE((force(Eigen::seqN(1, n * n, 3)) + mu * (all - less)).norm(), 1e-8 * mu * all.norm());
  EXPECT_LE(force(Eigen::seqN(2, n * n, 3)).norm(), 1e-8 * mu * all.norm());
  EXPECT_GT((less.array() > 0).count(), 0) << "some patches stick";
  EXPECT_LT((less.array() > 0).count(), (all.array() > 0).count()) << "and some slip";
}
} // namespace orthocone::test
