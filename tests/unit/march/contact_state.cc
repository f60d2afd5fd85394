// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/march/contact_state.h>
#include <orthocone/march/march.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace orthocone::test
{
namespace
{
using Eigen::Vector3d;

/// The state of a node with unit compliance behind a step that takes it from `gap_before` (mm), without
/// force, to contact with a force (N). It slips by (0.1, 0) mm on its way.
ContactState closed_from(const double gap_before, const Vector3d &force)
{
  const DenseCompliance compliance(Eigen::Matrix3d::Identity());
  const ContactSystem system(compliance, {OrthotropicFriction{0.3, 0.3, 0.3, 0.3}});
  ContactState state(Vector3d(gap_before, 0, 0));
  const ContactStep problem(system, Vector3d(0, 0.1, 0) - force); // so that the displacement is (0, 0.1, 0)
  advance(state, problem, Eigen::VectorXd::Ones(1), force, {});
  return state;
}

/// A cylinder over a shallow bowl, which touches in the middle first.
Parameters curved(const double friction)
{
  Parameters parameters;
  parameters.mesh.core_cells = parameters.mesh.rings = 4;
  parameters.mesh.layers = 2;
  parameters.mesh.degree = 1;
  parameters.friction.mu = {{friction, friction}};
  parameters.obstacle.gap = "0.003 + (x^2 + y^2)/1e4";
  parameters.contact_solver.tolerance = 1e-12;
  return parameters;
}

/// What a run of few steps says of its energies.
struct Balance
{
  double work = 0;        ///< N mm
  double dissipation = 0; ///< N mm
  double stored = 0;      ///< N mm
  unsigned int n_touching = 0;
  double largest_stored = 0; ///< N mm
  double largest_rest = 0;   ///< of work - dissipation - stored, N mm
};

Balance march_balance(const Parameters &parameters)
{
  const Scene scene(parameters, choose_model(parameters));
  StepSolver solver(scene);
  ContactState state(scene.gaps());
  Balance balance;
  for (const LoadStep &step : LoadProgram(parameters.load).steps())
  {
    const ContactState before = state;
    EXPECT_TRUE(solver.solve(state, step).converged);
    solver.accept(before, state, step);
    NodeVector moved;
    scene.compliance().vmult(moved, state.force);
    const double n_copies = scene.symmetry().n_copies();
    balance.work = state.work;
    balance.dissipation = n_copies * state.dissipated_energy.sum();
    balance.stored = 0.5 * n_copies * state.force.dot(moved);
    balance.n_touching = static_cast<unsigned int>(std::count_if(state.status.begin(), state.status.end(),
                                                                 [](const NodeStatus status)
                                                                 { return status != NodeStatus::open; }));
    balance.largest_stored = std::max(balance.largest_stored, balance.stored);
    balance.largest_rest =
        std::max(balance.largest_rest, std::abs(balance.work - balance.dissipation - balance.stored));
  }
  return balance;
}
} // namespace

// A node that closes half-way of a step slips on the obstacle for half of the way.
TEST(Touching, ANodeThatClosesSlipsForItsShareOfTheStep)
{
  const Vector3d slipping(1, -0.3, 0);
  const ContactState whole = closed_from(0, slipping);
  EXPECT_NEAR(whole.accumulated_slip[0], 0.1, 1e-15);
  EXPECT_NEAR(whole.dissipated_energy[0], 0.5 * 0.3 * 0.1, 1e-15);
  const ContactState half = closed_from(1, slipping);
  EXPECT_NEAR(half.accumulated_slip[0], 0.05, 1e-15);
  EXPECT_NEAR(half.dissipated_energy[0], 0.5 * whole.dissipated_energy[0], 1e-15);
  EXPECT_NEAR(half.displacement[1], 0.1, 1e-15) << "the whole way moves the node along the obstacle";
  const ContactState rounding = closed_from(1e-14, slipping);
  EXPECT_NEAR(rounding.dissipated_energy[0], whole.dissipated_energy[0], 1e-12);
}

// Without friction all work is stored, whatever the steps, because contact forces do none: also where nodes
// close and open within them.
TEST(Touching, APressWithoutFrictionBalances)
{
  for (const unsigned int n_steps : {1, 3})
  {
    Parameters parameters = curved(0);
    parameters.load.legs = {move_to(0, 0, -0.05, n_steps), move_to(0, 0, -0.01, n_steps),
                            move_to(0, 0, 0, 1)};
    const Balance balance = march_balance(parameters);
    EXPECT_GT(balance.largest_stored, 1);
    EXPECT_LE(balance.largest_rest, 1e-9 * balance.largest_stored) << n_steps;
    EXPECT_EQ(balance.n_touching, 0u);
    EXPECT_NEAR(balance.work, 0, 1e-9 * balance.largest_stored);
  }
}

// With friction the work of a press and of its return is what friction dissipates, to the order of the steps.
TEST(Touching, WorkOfAClosedLoopIsDissipated)
{
  const auto error_of = [](const unsigned int n_steps)
  {
    Parameters parameters = curved(0.3);
    parameters.load.legs = {move_to(0, 0, -0.05, n_steps), move_to(0, 0, 0, n_steps)};
    const Balance balance = march_balance(parameters);
    EXPECT_EQ(balance.stored, 0);
    EXPECT_GT(balance.dissipation, 0);
    return std::abs(balance.work / balance.dissipation - 1);
  };
  const double coarse = error_of(4), fine = error_of(16);
  EXPECT_LT(coarse, 0.2);
  EXPECT_LT(fine, 0.5 * coarse);
}
} // namespace orthocone::test
