// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "contact/solvers/rescue/friction_path.h"

#include "contact/contact_problems.h"

#include <orthocone/base/numbers.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace orthocone::test
{
using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace
{
/// Random numbers in place of a body: nodes feel each other as strongly as themselves, in all directions.
class RandomProblem
{
public:
  /// `load` (N) presses a face that holds the nodes, which cannot tilt; without one the nodes are held in
  /// place.
  RandomProblem(const unsigned int seed, const Index n_nodes, const double load = 0)
      : random_(seed),
        compliance_(positive(3 * n_nodes)),
        system_(compliance_, laws(n_nodes)),
        step_(system_, vector(3 * n_nodes),
              load > 0 ? FreeFace(Vector3d::UnitX().replicate(n_nodes, 1), VectorXd::Constant(1, load))
                       : FreeFace())
  {
  }

  const ContactStep &step() const { return step_; }

private:
  double number(const double from, const double to)
  {
    return std::uniform_real_distribution<double>(from, to)(random_);
  }
  VectorXd vector(const Index n)
  {
    return VectorXd::NullaryExpr(n, [&](Index) { return number(-1, 1); });
  }
  MatrixXd positive(const Index n)
  {
    const MatrixXd root = MatrixXd::NullaryExpr(n, n, [&](Index, Index) { return number(-1, 1); });
    return root * root.transpose() + 0.05 * MatrixXd::Identity(n, n);
  }
  FrictionLaws laws(const Index n)
  {
    const double mu_x = number(0.1, 2), mu_y = number(0.1, 2);
    return {static_cast<std::size_t>(n), OrthotropicFriction{mu_x, mu_y, number(0.1, 2), number(0.1, 2)}};
  }

  std::mt19937 random_;
  DenseCompliance compliance_;
  ContactSystem system_;
  ContactStep step_;
};

/// The path from the solution with a share of friction.
FrictionPath path_of(const ContactStep &step, const double share = 0.01)
{
  VectorXd start = VectorXd::Zero(step.n_unknowns());
  const SolverReport report =
      solve_step(step.with_factors(FrictionPieces(step).factors(share)), solver_options("newton"), start);
  EXPECT_TRUE(report.converged);
  return FrictionPath(step, start, share);
}

bool follow(FrictionPath &path)
{
  constexpr unsigned int plenty = 2000;
  constexpr double no_bound = 1e300;
  return path.follow(plenty, no_bound);
}

/// The number of solutions of a node's step that are found without any solver: the stuck one, and the
/// directions e of the reduced force of a sliding node. With N from d_n = 0 its slip must oppose e, which is
/// a change of sign of a function of the direction.
unsigned int n_solutions(const ContactStep &step, const double factor)
{
  constexpr unsigned int n_directions = 200000;
  const FrictionLaw law = step.law(0).scaled(factor);
  const Matrix3d w = *step.system().compliance().dense();
  const Vector3d stuck = -w.lu().solve(step.q());
  unsigned int n = step.q()[0] >= 0 ? 1 : 0; // open
  n += stuck[0] > 0 && law.load(stuck.tail<2>()) <= stuck[0] ? 1 : 0;
  const auto slip_under = [&](const double angle)
  {
    const Vector2d e(std::cos(angle), std::sin(angle)), tangential = law.force(e);
    const Vector3d unit(1, tangential[0], tangential[1]);
    const double normal = -step.q()[0] / (w * unit)[0];
    const Vector3d d = step.q() + normal * (w * unit);
    const Vector2d g = law.reduced_slip(d.tail<2>());
    return Vector3d(g[0] * e[1] - g[1] * e[0], -g.dot(e), normal);
  };
  Vector3d before = slip_under(0);
  for (unsigned int i = 1; i <= n_directions; ++i)
  {
    const Vector3d here = slip_under(2 * pi * i / n_directions);
    if (before[0] * here[0] < 0 && here[1] > 0 && here[2] > 0 && before[2] > 0)
      ++n;
    before = here;
  }
  return n;
}
} // namespace

// Every step has a solution, and the path to it from no friction is bounded (docs/theory.md, section 8), so
// that it must arrive, however often it turns back.
TEST(FrictionPath, ArrivesAtASolution)
{
  unsigned int n_folded = 0;
  for (const Index n_nodes : {1, 2, 4, 8})
    for (unsigned int seed = 0; seed < 100; ++seed)
    {
      const RandomProblem random(seed, n_nodes);
      FrictionPath path = path_of(random.step());
      EXPECT_TRUE(follow(path)) << n_nodes << " nodes, seed " << seed;
      EXPECT_LE(random.step().residual(path.unknowns()), 1e-9) << n_nodes << " nodes, seed " << seed;
      n_folded += path.folds().n > 0 ? 1 : 0;
    }
  EXPECT_GT(n_folded, 5);
}

TEST(FrictionPath, ArrivesWhereAForceDrivesTheFace)
{
  unsigned int n_folded = 0;
  for (const Index n_nodes : {2, 5})
    for (unsigned int seed = 0; seed < 60; ++seed)
    {
      const RandomProblem random(seed, n_nodes, 3);
      FrictionPath path = path_of(random.step());
      EXPECT_TRUE(follow(path)) << n_nodes << " nodes, seed " << seed;
      EXPECT_LE(random.step().residual(path.unknowns()), 1e-9) << n_nodes << " nodes, seed " << seed;
      n_folded += path.folds().n > 0 ? 1 : 0;
    }
  EXPECT_GT(n_folded, 0U);
}

// Two solutions meet in a fold: behind it there are two fewer.
TEST(FrictionPath, FoldsWhereSolutionsMeet)
{
  constexpr double near = 1e-2;
  unsigned int n_folded = 0;
  for (unsigned int seed = 0; seed < 400; ++seed)
  {
    const RandomProblem random(seed, 1);
    FrictionPath path = path_of(random.step());
    follow(path);
    if (path.folds().n == 0)
      continue;
    ++n_folded;
    const double first = FrictionPieces(random.step()).factors(path.folds().first_share)[0];
    EXPECT_EQ(n_solutions(random.step(), first * (1 - near)),
              n_solutions(random.step(), first * (1 + near)) + 2)
        << "seed " << seed << " at " << first;
  }
  EXPECT_GT(n_folded, 3);
}

// A problem whose path folds twice on its way, and arrives after a hundred factorizations.
TEST(FrictionPath, RescuesOrSaysWhereTheFirstFoldIs)
{
  constexpr unsigned int folding = 25;
  const RandomProblem random(folding, 1);
  FrictionPath path = path_of(random.step());
  follow(path);
  ASSERT_EQ(path.folds().n, 2U);
  for (const unsigned int most_iterations : {70U, 1000U})
  {
    ContactSolverOptions options = solver_options("newton", 1e-10);
    options.maximum_iterations = most_iterations;
    VectorXd unknowns = VectorXd::Zero(3);
    const auto report = make_contact_solver(random.step().system(), options)->rescue(random.step(), unknowns);
    ASSERT_TRUE(report);
    EXPECT_NEAR(report->folds.first_share, path.folds().first_share, 1e-6);
    EXPECT_EQ(report->converged, most_iterations == 1000U);
    EXPECT_EQ(report->verdict, report->converged ? Verdict::converged : Verdict::several);
    EXPECT_EQ(random.step().residual(unknowns) <= options.tolerance, report->converged);
    EXPECT_EQ(unknowns.isZero(0), !report->converged);
  }
}

// Sweeps have no such thing.
TEST(FrictionPath, IsForTheDefaultMethod)
{
  const RandomProblem random(0, 2);
  VectorXd unknowns = VectorXd::Zero(6);
  EXPECT_FALSE(make_contact_solver(random.step().system(), solver_options("gauss-seidel"))
                   ->rescue(random.step(), unknowns));
}
} // namespace orthocone::test
