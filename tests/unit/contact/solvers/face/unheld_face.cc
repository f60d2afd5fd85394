// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Faces that forces drive, and that wear has left without contact or with too little to hold them.
#include "contact/solvers/face/unheld_face.h"
#include "contact/contact_problems.h"
#include "contact/solvers/newton/linearization.h"

#include <gtest/gtest.h>

#include <utility>

namespace orthocone::test
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
constexpr Index n_side = 5, n_grid = n_side * n_side;

/// A compliance that gives away no matrix, as that of multigrid.
class HiddenCompliance : public DenseCompliance
{
public:
  using DenseCompliance::DenseCompliance;
  const DenseView *dense() const override { return nullptr; }
  std::unique_ptr<ConditionSolver> condition_solver(const double softness) const override
  {
    return std::make_unique<Solver>(*this, DenseCompliance::condition_solver(softness));
  }

private:
  /// Says how far the nodes move, too.
  class Solver : public ConditionSolver
  {
  public:
    Solver(const HiddenCompliance &compliance, std::unique_ptr<ConditionSolver> dense)
        : compliance_(compliance),
          dense_(std::move(dense))
    {
    }

    ContactChange solve(const ContactConditions &conditions, const double accuracy) const override
    {
      ContactChange change = dense_->solve(conditions, accuracy);
      compliance_.vmult(change.displacement, change.force);
      change.displacement += conditions.face * change.face;
      return change;
    }

  private:
    const HiddenCompliance &compliance_;
    std::unique_ptr<ConditionSolver> dense_;
  };
};

double x_of(const Index node)
{
  return static_cast<double>(node % n_side) - 2;
}

/// A face that moves along the normal and may tilt about y, under a pressure of `force` in the middle.
FreeFace face_that_may_tilt(const double force)
{
  MatrixXd motions = MatrixXd::Zero(3 * n_grid, 2);
  for (Index node = 0; node < n_grid; ++node)
    motions.row(3 * node) << 1, x_of(node);
  return {motions, Eigen::Vector2d(force, 0)};
}

/// Adds `depth` and `slope` times x to the gaps.
NodeVector worn(NodeVector q, const double depth, const double slope)
{
  for (Index node = 0; node < n_grid; ++node)
    q[3 * node] += depth + slope * (x_of(node) + 2);
  return q;
}

struct Worn
{
  explicit Worn(const OrthotropicFriction &law)
      : hidden(grid_compliance(n_side)),
        dense(grid_compliance(n_side)),
        system(hidden, FrictionLaws(n_grid, law)),
        system_with_matrix(dense, FrictionLaws(n_grid, law))
  {
  }

  VectorXd way(const ContactStep &step, const VectorXd &unknowns) const
  {
    const NodeVector d = step.displacement(unknowns);
    return increment_of_unheld_face(step, unknowns, d, linearize(step, unknowns, d).conditions, 1);
  }

  /// Forces of the nodes (N) if each of them were a spring.
  VectorXd spring_forces(const ContactStep &step, const VectorXd &unknowns) const
  {
    const NodeVector d = step.displacement(unknowns);
    VectorXd forces(n_grid);
    for (Index node = 0; node < n_grid; ++node)
      forces[node] = std::max(0., unknowns[3 * node] - system.rho(node) * d[3 * node]);
    return forces;
  }

  HiddenCompliance hidden;
  DenseCompliance dense;
  ContactSystem system, system_with_matrix;
};

void move(VectorXd &unknowns, const VectorXd &way)
{
  unknowns.tail(way.size()) += way;
}
} // namespace

TEST(UnheldFace, ComesToWhereItsLoadIsCarried)
{
  const Worn grid(case_c);
  const double load = 7;
  const NodeVector flat = NodeVector::Zero(3 * n_grid);
  for (const double slope : {0., 0.1, 3.})
  {
    const ContactStep step(grid.system, worn(flat, 20, slope), face_that_may_tilt(load));
    VectorXd unknowns = VectorXd::Zero(step.n_unknowns());
    EXPECT_EQ(grid.spring_forces(step, unknowns).sum(), 0);
    move(unknowns, grid.way(step, unknowns));
    EXPECT_NEAR(grid.spring_forces(step, unknowns).sum(), load, 1e-12 * load);
  }
}

TEST(UnheldFace, TurnsAboutTheNodesThatHoldIt)
{
  const Worn grid(case_c);
  const NodeVector flat = NodeVector::Zero(3 * n_grid);
  const ContactStep step(grid.system, worn(flat, 0, 3), face_that_may_tilt(7));
  VectorXd unknowns = VectorXd::Zero(step.n_unknowns());
  unknowns.tail(2) = step.face().unknowns(Eigen::Vector2d(-1, 0)); // to where the lower edge penetrates
  const NodeVector before = step.displacement(unknowns);
  move(unknowns, grid.way(step, unknowns));
  const NodeVector after = step.displacement(unknowns);
  const VectorXd carried = grid.spring_forces(step, unknowns);
  Index n_closed = 0, n_more = 0;
  for (Index node = 0; node < n_grid; ++node)
  {
    if (before[3 * node] < 0)
    {
      ++n_closed;
      EXPECT_NEAR(after[3 * node], before[3 * node], 1e-12);
    }
    else
      n_more += carried[node] > 0 ? 1 : 0;
  }
  EXPECT_EQ(n_closed, n_side);
  EXPECT_GT(n_more, 0);
  EXPECT_EQ(grid.way(step, unknowns).size(), 0); // it is held now
}

TEST(UnheldFace, StaysWhereItMeetsNothing)
{
  const Worn grid(case_c);
  const NodeVector open = worn(NodeVector::Zero(3 * n_grid), 1, 0);
  MatrixXd along = MatrixXd::Zero(3 * n_grid, 1);
  for (Index node = 0; node < n_grid; ++node)
    along(3 * node + 1, 0) = 1;
  const VectorXd one = VectorXd::Ones(1);
  for (const FreeFace &face :
       {face_that_may_tilt(-7), face_that_may_tilt(0), FreeFace(along, one), FreeFace()})
  {
    const ContactStep step(grid.system, open, face);
    EXPECT_EQ(grid.way(step, VectorXd::Zero(step.n_unknowns())).size(), 0);
  }
}

// A step on a surface that the step before has worn far deeper than pressure had flattened it.
TEST(UnheldFace, NewtonFindsTheForcesOfTheSweepsBehindDeepWear)
{
  for (const OrthotropicFriction &law : case_laws)
  {
    const Worn grid(law);
    const NodeVector push = 0.1 * GridProblem::free_displacement(n_side, 5);
    const FreeFace face = face_that_may_tilt(7);
    const ContactSolverOptions options = solver_options("newton");
    const ContactStep first(grid.system_with_matrix, push, face);
    VectorXd start = VectorXd::Zero(first.n_unknowns());
    ASSERT_TRUE(solve_step(first, options, start).converged);
    for (const double slope : {0., 0.3, 3., 30.})
    {
      const NodeVector q = worn(push, 50, slope);
      VectorXd unknowns = start, swept = start;
      const SolverReport report = solve_step(ContactStep(grid.system, q, face), options, unknowns);
      EXPECT_TRUE(report.converged) << to_word(report.verdict) << " " << report.residual;
      EXPECT_LT(report.iterations, 25u);
      const ContactStep with_matrix(grid.system_with_matrix, q, face);
      ASSERT_TRUE(solve_step(with_matrix, solver_options("gauss-seidel"), swept).converged);
      EXPECT_LT((unknowns - swept).norm(), 1e-8 * swept.norm());
    }
  }
}
} // namespace orthocone::test
