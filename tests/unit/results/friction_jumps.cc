// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/results/friction_jumps.h>

#include "results/scenes.h"

namespace orthocone::test
{
namespace
{
/// Running-in over cycles: in each of them all nodes slip as far as in the others, and dissipate as their
/// friction lets them, dw/dn = rate F(w) with F = 1/(1 + w).
class RunningIn
{
public:
  explicit RunningIn(const double bound)
      : scene_(parameters(bound)),
        friction_(scene_.scene),
        jumps_(scene_.scene)
  {
  }

  /// Marches `n_cycles` with jumps; returns the number of computed cycles.
  unsigned int march(const unsigned int n_cycles)
  {
    unsigned int n_computed = 0;
    for (unsigned int cycle = 1; cycle <= n_cycles; ++cycle, ++n_computed)
    {
      const ContactState start = state_;
      const Eigen::VectorXd factors = friction_.factors(state_, cycle);
      state_.accumulated_slip.array() += 1e-3;
      state_.dissipated_energy += rate * scene_.scene.pressed_areas().cwiseProduct(factors);
      const unsigned int n = jumps_.after_cycle(start, state_, cycle, n_cycles - cycle);
      if (n == 0)
        continue;
      jumps_.begin_jump(start, state_, n);
      const Eigen::VectorXd now = friction_.values(state_, cycle + 1);
      state_.dissipated_energy += n * (state_.dissipated_energy - start.dissipated_energy);
      state_.accumulated_slip += n * (state_.accumulated_slip - start.accumulated_slip);
      const Eigen::VectorXd behind = friction_.values(state_, cycle + n + 1);
      largest_change_ = std::max(largest_change_, 1 - behind[0] / now[0]);
      cycle += n;
    }
    return n_computed;
  }

  double energy() const { return state_.dissipated_energy[0] / scene_.scene.pressed_areas()[0]; }
  double factor(const unsigned int cycle) const { return friction_.values(state_, cycle)[0]; }
  const FrictionJumps &jumps() const { return jumps_; }
  double largest_change() const { return largest_change_; }

  static constexpr double rate = 4e-3;

private:
  static Parameters parameters(const double bound)
  {
    Parameters parameters = small_scene();
    parameters.mesh.core_cells = parameters.mesh.rings = 2;
    parameters.friction.factor = FrictionFactor("1/(1 + w)");
    parameters.load.jump_change_of_friction = bound;
    parameters.load.jump_cycles = 100000;
    return parameters;
  }

  TestScene scene_;
  FrictionMemory friction_;
  FrictionJumps jumps_;
  ContactState state_{scene_.scene.gaps()};
  double largest_change_ = 0;
};
} // namespace

// (1 + w)^2 = 1 + 2 rate n: jumps come near it, nearer the shorter they are, and bound what they err by.
TEST(FrictionJumps, ErrByLessThanTheyEstimate)
{
  constexpr unsigned int n_cycles = 1000;
  const double exact = 1 / std::sqrt(1 + 2 * RunningIn::rate * n_cycles);
  double last_error = 1;
  for (const double largest : {0.1, 0.03, 0.01})
  {
    RunningIn run(largest);
    const unsigned int n_computed = run.march(n_cycles);
    const double error = exact - run.factor(n_cycles + 1); // each jump goes on at the rate of its beginning
    EXPECT_GT(error, 0) << largest;
    EXPECT_GT(run.largest_change(), 0.5 * largest);
    EXPECT_LE(run.largest_change(), largest);
    EXPECT_GE(run.jumps().memory().error / error, 1) << largest;
    EXPECT_LE(run.jumps().memory().error / error, 5) << largest;
    EXPECT_LT(error, 0.5 * last_error);
    EXPECT_LT(n_computed, n_cycles / 4);
    last_error = error;
  }
}

TEST(FrictionJumps, AreNotMadeUnasked)
{
  RunningIn run(0);
  EXPECT_FALSE(run.jumps().are_wanted());
  EXPECT_EQ(run.march(20), 20u);
}
} // namespace orthocone::test
