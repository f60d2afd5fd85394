// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// What depends on the path: dissipation, energy, memory of slip, and steps that are halved.
#include "results/scenes.h"

namespace orthocone::test
{
using Eigen::Index;
using Eigen::Vector2d;
using Eigen::Vector3d;

// Friction takes energy at every node in every step: by the law -r.du, and as it is reported.
TEST(History, FrictionNeverDrives)
{
  for (const unsigned int degree : {1, 2})
    for (const auto &p : slip_ellipses)
    {
      Parameters parameters = small_scene(degree);
      parameters.friction.slip_potential = p;
      parameters.load.legs.push_back(move_to(0, 0, -0.1, 1));
      parameters.load.legs.push_back(move_to(0.1, 0.05, -0.1, 2));
      parameters.load.legs.push_back(move_to(-0.1, 0, -0.02, 2));
      parameters.load.legs.push_back(move_to(-0.1, 0.1, 0.1, 1));
      TestScene scene(parameters);
      scene.march(
          [](const ContactState &before, const ContactState &after, const LoadStep &step)
          {
            const double largest = after.dissipated_energy.maxCoeff();
            for (Index i = 0; i < after.n_nodes(); ++i)
            {
              const Vector2d change =
                  after.displacement.segment<2>(3 * i + 1) - before.displacement.segment<2>(3 * i + 1);
              EXPECT_LE(after.force.segment<2>(3 * i + 1).dot(change), 1e-9) << "step " << step.number;
              EXPECT_GE(after.dissipated_energy[i] - before.dissipated_energy[i], -1e-10 * largest)
                  << "step " << step.number << " node " << i;
            }
          });
    }
}

namespace
{
/// |work of the top - elastic energy - dissipation| over a program with reversals, relative to the
/// dissipation.
double energy_defect(const std::array<double, 2> &p, const unsigned int refinement)
{
  Parameters parameters = small_scene(1);
  parameters.friction.slip_potential = p;
  parameters.load.legs = {move_to(0, 0, -0.1, 2 * refinement), move_to(0.004, 0.003, -0.08, 3 * refinement),
                          move_to(0, 0, -0.03, 4 * refinement)};
  TestScene scene(parameters);
  Totals last;
  double work = 0;
  scene.march(
      [&](const ContactState &before, const ContactState &after, const LoadStep &)
      {
        const Totals now = scene.totals();
        for (unsigned int d = 0; d < 3; ++d)
          work -= 0.5 * (last.force[d] + now.force[d]) * (after.motion[d] - before.motion[d]);
        last = now;
      });
  return std::abs(work - last.elastic_energy - last.total_dissipation) / last.total_dissipation;
}
} // namespace

// Work of the top = change of elastic energy + dissipation, up to a defect of the time integration that falls
// with the steps.
TEST(History, EnergyBalancesBetterWithSmallerSteps)
{
  for (const auto &p : slip_ellipses)
  {
    const double coarse = energy_defect(p, 1);
    const double fine = energy_defect(p, 8);
    EXPECT_LE(coarse, 0.05);
    EXPECT_LE(fine, coarse / 4) << "coarse " << coarse << " fine " << fine;
  }
}

// Down and up again: everything is undone, every node has slid there and back, and the dissipation of both
// cycles is the same.
TEST(History, FullUnloadingErasesTheHistory)
{
  for (const auto &p : slip_ellipses)
  {
    Parameters parameters = small_scene(1);
    parameters.friction.slip_potential = p;
    parameters.load.cycles = 2;
    TestScene scene(parameters);
    std::vector<NodeVector> forces;
    double largest_slip = 0;
    double dissipation_of_first_cycle = 0;
    scene.march(
        [&](const ContactState &, const ContactState &after, const LoadStep &step)
        {
          forces.push_back(after.force);
          largest_slip = std::max(largest_slip, scene.totals().max_slip);
          if (step.cycle == 1)
            dissipation_of_first_cycle = scene.totals().total_dissipation;
        });
    EXPECT_EQ(scene.totals().force.norm(), 0);
    EXPECT_EQ(scene.totals().n_stick + scene.totals().n_slip, 0u);
    EXPECT_LE(scene.totals().max_slip, 1e-14);
    EXPECT_GE(scene.totals().max_accumulated_slip, 4 * largest_slip * (1 - 1e-12));
    EXPECT_NEAR(scene.totals().total_dissipation / dissipation_of_first_cycle, 2, closeness);
    for (std::size_t i = 0; i < forces.size() / 2; ++i)
      EXPECT_LE((forces[i] - forces[i + forces.size() / 2]).norm(), closeness * forces[4].norm());
  }
}

namespace
{
/// The last step of the scene's program, from the end of the step before, with few iterations; the steps
/// before are solved as usual.
SolverReport solve_last_step(TestScene &scene, const unsigned int most_iterations)
{
  const LoadSteps steps = LoadProgram(scene.parameters.load).steps();
  StepSolver patient(scene.scene);
  for (std::size_t i = 0; i + 1 < steps.size(); ++i)
    EXPECT_TRUE(patient.solve(scene.state, steps[i]).converged);
  ContactSolverOptions options = scene.parameters.contact_solver;
  options.maximum_iterations = most_iterations;
  return StepSolver(scene.scene, options).solve(scene.state, steps[steps.size() - 1]);
}
} // namespace

namespace
{
double relative_difference(const Eigen::VectorXd &a, const Eigen::VectorXd &b)
{
  return (a - b).norm() / b.norm();
}

/// The program with its last leg, one step, cut at the given shares of it.
Parameters with_ends_of_last_leg(Parameters parameters, const std::vector<double> &ends)
{
  auto &legs = parameters.load.legs;
  const Leg start = legs[legs.size() - 2];
  const Leg end = legs.back();
  legs.pop_back();
  for (const double share : ends)
  {
    Leg leg = move_to(0, 0, 0, 1);
    for (unsigned int d = 0; d < 3; ++d)
      leg.targets[d]->value = *start.motion(d) + share * (*end.motion(d) - *start.motion(d));
    legs.push_back(leg);
  }
  return parameters;
}
} // namespace

// A step that fails is halved from the state before it: the answer is that of explicit sub-steps. If these
// fail, too, nothing of the attempt is left.
TEST(History, AFailedStepIsHalvedWithItsSlipHistoryRolledBack)
{
  Parameters parameters = small_scene(1);
  parameters.friction.slip_potential =
      std::array<double, 2>{{0.02, 0.4}}; // needs more iterations at once than in parts
  parameters.contact_solver.method = "gauss-seidel";
  parameters.load.legs = {move_to(0, 0, -0.1, 1), move_to(0, 0, -0.05, 1), move_to(0.005, 0.01, -0.09, 1)};
  TestScene failed(parameters);
  EXPECT_FALSE(solve_last_step(failed, 1).converged);
  EXPECT_EQ(failed.state.step, 2u);
  TestScene before(parameters);
  EXPECT_FALSE(solve_last_step(before, 2).converged);
  EXPECT_EQ(failed.state.force, before.state.force);
  EXPECT_EQ(failed.state.displacement, before.state.displacement);
  EXPECT_EQ(failed.state.dissipated_energy, before.state.dissipated_energy);

  parameters.contact_solver.method = "newton";
  TestScene whole(parameters);
  const unsigned int too_few = solve_last_step(whole, 5000).iterations - 1;
  TestScene halved(parameters);
  const SolverReport report = solve_last_step(halved, too_few);
  ASSERT_TRUE(report.converged);
  EXPECT_GT(report.iterations, too_few); // the failed attempts count
  EXPECT_GT(relative_difference(halved.state.force, whole.state.force), 1e-6);
  // Each of the two halves may have been halved again: that depends on iterations, and so on the processor.
  double least = 1;
  for (const std::vector<double> &ends :
       {std::vector<double>{0.5, 1}, {0.25, 0.5, 1}, {0.5, 0.75, 1}, {0.25, 0.5, 0.75, 1}})
  {
    TestScene stepwise(with_ends_of_last_leg(parameters, ends));
    stepwise.march();
    least = std::min(least, std::max(relative_difference(stepwise.state.force, halved.state.force),
                                     relative_difference(stepwise.state.dissipated_energy,
                                                         halved.state.dissipated_energy)));
  }
  EXPECT_LE(least, closeness);
}

TEST(History, PartialUnloadingKeepsTheHistory)
{
  Parameters parameters = small_scene(1);
  parameters.load.preload = {move_to(0, 0, -0.02, 1)};
  parameters.load.legs = {move_to(0, 0, -0.1, 3), move_to(0, 0, -0.02, 5)};
  TestScene scene(parameters);
  Eigen::VectorXd preloaded;
  scene.march(
      [&](const ContactState &, const ContactState &after, const LoadStep &step)
      {
        if (step.number == 1)
          preloaded = after.displacement;
      });
  EXPECT_GT((scene.state.displacement - preloaded).norm(), 0.1 * preloaded.norm());
}

namespace
{
/// What a node with unit compliance dissipates in a step that takes it from a state to another by the slip
/// (0.1, 0).
double dissipated(const Vector3d &force_before, const Vector3d &force_after, const double gap)
{
  const DenseCompliance compliance(Eigen::Matrix3d::Identity());
  const ContactSystem system(compliance, {OrthotropicFriction{0.3, 0.3, 0.3, 0.3}});
  ContactState state(1);
  state.force = force_before;
  state.status = {NodeStatus::slip};
  const ContactStep problem(system,
                            step_displacement(Vector3d(gap, 0.1, 0) - force_after,
                                              Vector3d::Zero())); // so that the displacement is (gap, 0.1, 0)
  advance(state, problem, Eigen::VectorXd::Ones(1), force_after, {});
  return state.dissipated_energy[0];
}
} // namespace

// A node that just leaves the plane, or that carried no force before, may do so by rounding.
TEST(History, RoundingDoesNotDecideOnDissipation)
{
  constexpr double rounding = 1e-14;
  const Vector3d none = Vector3d::Zero(), slipping(1, -0.3, 0);
  const double leaving = dissipated(slipping, none, 0);
  EXPECT_NEAR(leaving, 0.5 * 0.3 * 0.1, 1e-15); // the force falls in proportion
  EXPECT_NEAR(dissipated(slipping, none, rounding), leaving, 1e-12);
  EXPECT_NEAR(dissipated(slipping, none, 1), 0.5 * leaving, 1e-15); // in contact for half of the step
  const double loading = dissipated(none, slipping, 0);
  for (const double noise : {-rounding, rounding})
    EXPECT_NEAR(dissipated({rounding, noise, 0}, slipping, 0), loading, 1e-12);
  EXPECT_NEAR(dissipated({1, 0.3, 0}, slipping, 0), 0.3 * 0.1, 1e-15); // all of the slip after the reversal
}
} // namespace orthocone::test
