// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "results/scenes.h"

#include <orthocone/results/step_checks.h>

#include <limits>

namespace orthocone::test
{
namespace
{
/// A scene whose steps are checked as the program does it.
struct CheckedScene : TestScene
{
  explicit CheckedScene(const Parameters &parameters_)
      : TestScene(parameters_),
        checker(scene, parameters.checks, parameters.contact_solver.tolerance)
  {
  }

  StepChecks check(const ContactState &before, const ContactState &after)
  {
    const Totals totals_before = compute_totals(evaluator, before);
    const Totals totals_after = compute_totals(evaluator, after);
    return checker.check({before, totals_before}, {after, totals_after}, {}, totals_before.elastic_energy);
  }

  StepChecker checker;
};

/// What the checker says of a step of the paper's cycle that `spoil` has changed.
std::string complaint(const unsigned int number, const std::function<void(ContactState &)> &spoil)
{
  CheckedScene scene(small_scene());
  std::string text;
  scene.march(
      [&](const ContactState &before, const ContactState &after, const LoadStep &step)
      {
        ContactState state = after;
        if (step.number == number)
        {
          spoil(state);
          text = scene.checker.violation(scene.check(before, state)).value_or("none");
        }
      });
  return text;
}
} // namespace

// The bounds leave room: also to one single step down and up, where slip and force change most.
TEST(StepChecks, PassWhatIsSolved)
{
  for (const auto &p : slip_ellipses)
    for (const unsigned int n_steps : {1, 5})
    {
      Parameters parameters = small_scene(2);
      parameters.friction.slip_potential = p;
      parameters.load.legs = {move_to(0, 0, -0.1, n_steps), move_to(0, 0, -0.01, n_steps),
                              move_to(0.01, 0, -0.05, n_steps), move_to(0, 0, 0, n_steps)};
      CheckedScene scene(parameters);
      scene.march(
          [&](const ContactState &before, const ContactState &after, const LoadStep &step)
          {
            const StepChecks checks = scene.check(before, after);
            EXPECT_FALSE(scene.checker.violation(checks)) << step.number;
            EXPECT_LE(checks.equilibrium, 1e-11) << step.number;
            EXPECT_LE(checks.energy_defect, 0.02) << step.number;
          });
    }
}

TEST(StepChecks, FindAStateThatTheBodyDoesNotHave)
{
  EXPECT_EQ(complaint(3, [](ContactState &) {}), "none");
  const auto starts_with = [](const std::string &text, const std::string &start)
  { return text.compare(0, start.size(), start) == 0; };
  // A contact node that is not where the forces put it, and a force that the others do not know of.
  EXPECT_TRUE(starts_with(complaint(3, [](ContactState &state) { state.displacement[7] += 1e-8; }),
                          "Checks/Equilibrium: "));
  EXPECT_TRUE(
      starts_with(complaint(8, [](ContactState &state) { state.force[9] += 1; }), "Checks/Equilibrium: "));
  EXPECT_TRUE(starts_with(complaint(15, [](ContactState &state) { state.displacement[1] += 1e-6; }),
                          "Checks/Equilibrium: "));
  EXPECT_TRUE(starts_with(complaint(5, [](ContactState &state) { state.dissipated_energy[4] += 0.1; }),
                          "Checks/Energy identity: "));
  EXPECT_TRUE(starts_with(complaint(9, [](ContactState &state) { state.dissipated_energy[6] *= 0.9; }),
                          "Checks/Energy identity: "));
  EXPECT_NE(complaint(2, [](ContactState &state)
                      { state.accumulated_slip[3] = std::numeric_limits<double>::infinity(); })
                .find("no longer numbers"),
            std::string::npos);
  EXPECT_NE(
      complaint(2, [](ContactState &state) { state.force[0] = std::numeric_limits<double>::quiet_NaN(); })
          .find("no longer numbers"),
      std::string::npos);
}

// The identity holds for any forces and any motion of the held face: work that left out a rotation, or took
// the wrong arms, would break it.
TEST(StepChecks, RotationsDoWorkOnMoments)
{
  Parameters parameters = small_scene();
  parameters.mesh.model = ModelKind::full;
  parameters.friction.angle = 30;
  CheckedScene scene(parameters);
  const Eigen::Matrix3d turn = scene.scene.axes().global_in_local(0);
  const auto state_of = [&](const RigidMotion &motion, const double phase)
  {
    ContactState state = scene.state;
    state.motion = motion;
    for (Eigen::Index i = 0; i < state.force.size(); ++i)
      state.force[i] = 100 * std::sin(phase + static_cast<double>(i * i));
    scene.condensed.compliance().vmult(state.displacement, state.force);
    for (Eigen::Index node = 0; node < state.n_nodes(); ++node)
    {
      const Eigen::Vector3d moved = motion.at(scene.evaluator.arm(node));
      state.displacement.segment<3>(3 * node) += turn.transpose() * moved;
    }
    return state;
  };
  RigidMotion motion;
  const ContactState before = state_of(motion, 0);
  motion.components << 0.01, -0.02, -0.1, 0.003, -0.002, 0.004;
  const ContactState after = state_of(motion, 1);
  const Totals first = compute_totals(scene.evaluator, before);
  const Totals last = compute_totals(scene.evaluator, after);
  SolverReport report;
  const StepChecks checks = scene.checker.check({before, first}, {after, last}, report, 0);
  report.n_parts = 2; // the dissipation of these states is no solver's
  EXPECT_LE(scene.checker.check({before, first}, {after, last}, report, 0).energy_identity, 1e-11);
  const Eigen::Vector3d moment = 0.5 * (first.moment + last.moment);
  EXPECT_GT(std::abs(moment.dot(motion.rotation())), 0.01 * checks.energy);
  EXPECT_NEAR(checks.work,
              -0.5 * (first.force + last.force).dot(motion.translation()) - moment.dot(motion.rotation()),
              1e-9 * checks.energy);
}

/// Work of the held face in steps that turn it, as the checks see it and as the march adds it up, and what is
/// missing in the energy balance of a step at most.
std::array<double, 3> works_of(const unsigned int parts)
{
  Parameters parameters = full_scene();
  parameters.load.legs = {move_to(0, 0, -0.1, 1), move_to(0.01, 0, -0.05, 2)};
  parameters.load.legs[1].targets[5] = Drive{false, 0.1};
  parameters.load.legs[1].parts = parts;
  CheckedScene scene(parameters);
  StepSolver solver(scene.scene);
  std::array<double, 3> works{};
  for (const LoadStep &step : LoadProgram(parameters.load).steps())
  {
    const ContactState before = scene.state;
    const Totals totals = scene.totals();
    const SolverReport report = solver.solve(scene.state, step);
    EXPECT_TRUE(report.converged);
    EXPECT_EQ(report.n_parts, step.step_of_leg == 1 && step.number == 1 ? 1u : parts);
    const Totals now = scene.totals();
    const StepChecks checks = scene.checker.check({before, totals}, {scene.state, now}, report, 0);
    EXPECT_FALSE(scene.checker.violation(checks));
    works[0] += checks.work;
    works[2] = std::max(works[2], checks.energy_defect);
    solver.accept(before, scene.state, step);
  }
  works[1] = scene.state.work;
  return works;
}

TEST(StepChecks, TakeTheWorkOfAllParts)
{
  const auto in_one = works_of(1), in_parts = works_of(8);
  EXPECT_NEAR(in_one[0], in_one[1], 1e-9 * std::abs(in_one[0])) << "by the totals and by the held face";
  EXPECT_NEAR(in_parts[0], in_parts[1], 1e-9 * std::abs(in_parts[0]));
  EXPECT_LT(in_parts[2], 0.2 * in_one[2]) << "what steps leave of the energy balance falls with their parts";
}

TEST(StepChecks, NameTheEntryOfTheBound)
{
  CheckedScene scene(small_scene());
  const auto named = [&](const LawErrors &law, const std::string &entry)
  {
    StepChecks checks;
    checks.law = law;
    const std::string text = scene.checker.violation(checks).value_or("none");
    return text.find("Checks/" + entry + ": ") == 0;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double wrong : {1e-3, nan})
  {
    EXPECT_TRUE(named({wrong, 0, 0, 0}, "Penetration"));
    EXPECT_TRUE(named({0, wrong, 0, 0}, "Complementarity"));
    EXPECT_TRUE(named({0, 0, wrong, 0}, "Friction cone"));
    EXPECT_TRUE(named({0, 0, 0, wrong}, "Slip rule"));
  }
  EXPECT_FALSE(scene.checker.violation(StepChecks()));
}
} // namespace orthocone::test
