// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Held faces that forces drive: the same states as by motions, equilibrium with what was asked for, and none
// beyond what friction carries.
#include "results/scenes.h"

#include <orthocone/base/numbers.h>
#include <orthocone/results/step_checks.h>

namespace orthocone::test
{
namespace
{
Leg leg_of(const std::vector<std::tuple<unsigned int, bool, double>> &targets, const unsigned int steps)
{
  Leg leg;
  for (const auto &[component, by_force, value] : targets)
    leg.targets[component] = Drive{by_force, value};
  leg.steps = steps;
  return leg;
}

constexpr unsigned int x = 0, y = 1, z = 2, ry = 4, rz = 5;
constexpr bool motion = false, force = true;

/// The last state of a march whose every step passes the program's checks.
ContactState checked_march(const Parameters &parameters)
{
  TestScene scene(parameters);
  StepChecker checker(scene.scene, parameters.checks, parameters.contact_solver.tolerance);
  double energy = 0;
  scene.march(
      [&](const ContactState &before, const ContactState &after, const LoadStep &step)
      {
        const Totals first = compute_totals(scene.evaluator, before),
                     last = compute_totals(scene.evaluator, after);
        SolverReport report;
        const StepChecks checks = checker.check({before, first}, {after, last}, report, energy);
        energy = checks.energy;
        EXPECT_FALSE(checker.violation(checks))
            << "step " << step.number << " " << *checker.violation(checks);
      });
  return scene.state;
}
} // namespace

// Pressed by a motion, then by the force that this motion took: the same states on the way to other loads,
// for every method that solves scenes.
TEST(Forces, GiveTheStatesOfTheMotionsThatTheyTake)
{
  Parameters by_motion = full_scene();
  by_motion.contact_solver.tolerance = 1e-12;
  by_motion.load.legs = {leg_of({{z, motion, -0.05}}, 2), leg_of({{z, motion, -0.05}, {x, motion, 0.01}}, 2)};
  TestScene moved(by_motion);
  std::vector<Wrench> wrenches;
  moved.march([&](const ContactState &, const ContactState &after, const LoadStep &)
              { wrenches.push_back(moved.scene.held_wrench(after.force, after.motion)); });
  for (const char *const method : {"newton", "gauss-seidel", "uzawa", "feng2006"})
  {
    Parameters by_force = by_motion;
    by_force.contact_solver.method = method;
    by_force.contact_solver.maximum_iterations = 100000;
    by_force.load.legs.clear();
    for (const Wrench &wrench : wrenches)
      by_force.load.legs.push_back(leg_of({{z, force, wrench[z]}, {x, force, wrench[x]}}, 1));
    const ContactState state = checked_march(by_force);
    SCOPED_TRACE(method);
    EXPECT_LE(largest_difference(state.motion.components, moved.state.motion.components), 1e-8);
    EXPECT_LE(largest_difference(state.force, moved.state.force), 1e-8);
    EXPECT_LE(largest_difference(state.displacement, moved.state.displacement), 1e-8);
  }
}

TEST(Forces, OfAQuarterAreThoseOfTheWholeBody)
{
  for (const ModelKind model : {ModelKind::full, ModelKind::half, ModelKind::quarter})
  {
    Parameters parameters = full_scene();
    parameters.mesh.model = model;
    parameters.load.legs = {leg_of({{z, force, -1e5}}, 2), leg_of({{z, force, -4e4}}, 3)};
    TestScene scene(parameters);
    scene.march();
    EXPECT_NEAR(scene.totals().force[2], 4e4, 1e-6 * 4e4);
  }
}

// Nothing presses at the end: no forces, and the face just opens.
TEST(Forces, OfZeroOpenTheContactByTheFirstMotionThatDoes)
{
  Parameters parameters = full_scene();
  parameters.load.legs = {leg_of({{z, force, -1e5}}, 2), leg_of({{z, force, 0}}, 4)};
  TestScene scene(parameters);
  scene.march();
  EXPECT_EQ(scene.totals().force.norm(), 0);
  EXPECT_NEAR(scene.state.motion[z], 0, 1e-15);
}

// The face stays where the shear has moved it, and its body hangs on it without strain.
TEST(Forces, OfZeroOpenASlippedContact)
{
  Parameters parameters = full_scene();
  parameters.contact_solver.tolerance = 1e-10;
  parameters.load.legs = {leg_of({{z, force, -1e5}}, 1), leg_of({{x, force, 2e4}}, 2),
                          leg_of({{z, force, 0}, {x, force, 0}}, 2)};
  const ContactState state = checked_march(parameters);
  EXPECT_EQ(state.force.norm(), 0);
  EXPECT_GT(state.motion[x], 1e-4);
}

// Friction carries mu F_z along x when all slips: gross sliding at 0.3 F_z by the ellipse of the paper's case
// B.
TEST(Forces, HaveNoEquilibriumBeyondGrossSliding)
{
  Parameters parameters = full_scene();
  parameters.contact_solver.tolerance = 1e-10;
  constexpr double pressing = -1e5;
  parameters.load.legs = {leg_of({{z, force, pressing}, {ry, motion, 0}}, 1),
                          leg_of({{x, force, 2 * 0.3e5}}, 1)};
  const TestScene scene(parameters);
  StepSolver solver(scene.scene);
  ContactState state = scene.state;
  const auto steps = LoadProgram(parameters.load).steps();
  ASSERT_TRUE(solver.solve(state, steps[0]).converged);
  solver.accept(scene.state, state, steps[0]);
  const ContactState before = state;
  const SolverReport report = solver.solve(state, steps[1]);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.verdict, Verdict::unbalanced);
  EXPECT_EQ(state.force, before.force);
  EXPECT_NEAR(solver.carried_share(before, steps[1]), 0.5, 0.02);
}

// Friction carries mu F = 0.3e5 N along x, and no moment above mu F R: whatever the pressure, no node is
// farther from the axis. A little above, iterations hardly move.
TEST(Forces, JustBeyondWhatFrictionCarriesHaveNoEquilibrium)
{
  constexpr double pressing = -1e5, carried = 0.3e5;
  const double radius = full_scene().geometry.radius;
  for (const auto &[component, load] :
       {std::pair(x, 1.0003 * carried), std::pair(x, 1.7 * carried), std::pair(rz, 1.01 * carried * radius),
        std::pair(rz, 0.9 * carried * radius)})
  {
    Parameters parameters = full_scene();
    parameters.friction.mu = {{0.3, 0.3}};
    parameters.friction.slip_potential = std::nullopt;
    parameters.load.legs = {leg_of({{z, force, pressing}}, 1), leg_of({{component, force, load}}, 1)};
    const TestScene scene(parameters);
    StepSolver solver(scene.scene);
    ContactState state = scene.state;
    const auto steps = LoadProgram(parameters.load).steps();
    ASSERT_TRUE(solver.solve(state, steps[0]).converged);
    solver.accept(scene.state, state, steps[0]);
    EXPECT_EQ(solver.solve(state, steps[1]).verdict, Verdict::unbalanced) << component << " " << load;
  }
}

TEST(Forces, ThatPullHaveNoEquilibrium)
{
  Parameters parameters = full_scene();
  parameters.load.legs = {leg_of({{z, force, -1e5}}, 1), leg_of({{z, force, 1e3}}, 1)};
  const TestScene scene(parameters);
  StepSolver solver(scene.scene);
  ContactState state = scene.state;
  const auto steps = LoadProgram(parameters.load).steps();
  ASSERT_TRUE(solver.solve(state, steps[0]).converged);
  EXPECT_EQ(solver.solve(state, steps[1]).verdict, Verdict::unbalanced);
}

// These fail where there is an equilibrium, and must not say that there is none.
TEST(Forces, AreNotBlamedByMethodsForStudy)
{
  for (const char *const method : {"box3", "plain-newton"})
  {
    Parameters parameters = full_scene();
    parameters.contact_solver.method = method;
    parameters.contact_solver.maximum_iterations = 50;
    parameters.load.legs = {leg_of({{z, force, -1e5}}, 1)};
    const TestScene scene(parameters);
    ContactState state = scene.state;
    const SolverReport report = StepSolver(scene.scene).solve(state, LoadProgram(parameters.load).steps()[0]);
    EXPECT_TRUE(report.converged || report.verdict != Verdict::unbalanced) << method;
  }
}

// A turn by a motion takes a moment; this moment gives the turn. Work and energies include both.
TEST(Rotations, AreDrivenByMotionsAndByMoments)
{
  Parameters parameters = full_scene();
  parameters.load.legs = {leg_of({{z, motion, -0.05}}, 1),
                          leg_of({{rz, motion, 0.02}, {ry, motion, 0.01}}, 2)};
  const ContactState turned = checked_march(parameters);
  EXPECT_NEAR(turned.motion[rz], 0.02 * pi / 180, 1e-15);
  const TestScene scene(parameters);
  const Wrench wrench = scene.scene.held_wrench(turned.force, turned.motion);
  EXPECT_GT(std::abs(wrench[rz]), 0);
  Parameters by_moment = parameters;
  by_moment.load.legs[1] = leg_of({{rz, force, wrench[rz]}, {ry, force, wrench[ry]}}, 2);
  const ContactState back = checked_march(by_moment);
  // The moments of the legs rise evenly, the motions do not quite: slip depends on the path a little.
  EXPECT_NEAR(back.motion[rz], turned.motion[rz], 2e-3 * turned.motion[rz]);
  EXPECT_NEAR(scene.scene.held_wrench(back.force, back.motion)[rz], wrench[rz], 1e-6 * std::abs(wrench[rz]));
}

// A component that a leg takes over from the other kind starts from where the face is.
TEST(Forces, TakeOverFromMotionsWhereTheFaceIs)
{
  Parameters parameters = full_scene();
  parameters.load.legs = {leg_of({{z, motion, -0.05}}, 1), leg_of({{z, force, -5e4}}, 2),
                          leg_of({{z, motion, -0.05}}, 2)};
  TestScene scene(parameters);
  std::vector<double> pressing, sunk;
  scene.march(
      [&](const ContactState &, const ContactState &after, const LoadStep &)
      {
        pressing.push_back(scene.scene.held_wrench(after.force, after.motion)[z]);
        sunk.push_back(after.motion[z]);
      });
  EXPECT_NEAR(pressing[1], 0.5 * (pressing[0] - 5e4), 1e-6 * 5e4);
  EXPECT_NEAR(pressing[2], -5e4, 1e-6 * 5e4);
  EXPECT_NEAR(sunk[3], 0.5 * (sunk[2] - 0.05), 1e-12);
  EXPECT_NEAR(sunk[4], -0.05, 1e-15);
}
} // namespace orthocone::test
