// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/errors.h>
#include <orthocone/scene/load_program.h>
#include <orthocone/scene/model_choice.h>

#include <gtest/gtest.h>

#include <functional>
#include <set>

namespace orthocone::test
{
namespace
{
Parameters scene()
{
  Parameters parameters;
  parameters.load.legs = {move_to(0, 0, -0.1, 5), move_to(0, 0, 0, 10)};
  return parameters;
}

std::string chosen(const Parameters &parameters)
{
  return choose_model(parameters).symmetry.name();
}
} // namespace

TEST(LoadProgram, PassesThroughPreloadAndCycles)
{
  LoadOptions load;
  load.preload = {move_to(0, 0, -0.02, 2)};
  load.legs = {move_to(0.01, 0, -0.1, 2), move_to(0, 0, -0.02, 4)};
  load.cycles = 3;
  const auto steps = LoadProgram(load).steps();
  ASSERT_EQ(steps.size(), 2u + 3 * 6);
  EXPECT_EQ(LoadProgram(load).n_steps(), steps.size());
  EXPECT_EQ(LoadProgram(load).first_cycle().n_steps(), 2u + 6);
  EXPECT_EQ(steps[0].motion, moved_by(0, 0, -0.01));
  EXPECT_EQ(steps[0].cycle, 0u);
  EXPECT_EQ(steps[2].motion, moved_by(0.005, 0, -0.06));
  EXPECT_EQ(steps[2].cycle, 1u);
  EXPECT_EQ(steps[4].step_of_leg, 1u);
  for (std::size_t i = 0; i < steps.size(); ++i)
    EXPECT_EQ(steps[i].number, i + 1);
  for (std::size_t i = 8; i < steps.size(); ++i)
  {
    EXPECT_EQ(steps[i].motion, steps[i - 6].motion); // to the last bit
    EXPECT_EQ(steps[i].phase, steps[i - 6].phase);
  }
}

/// Cycles behind the second one are made when they are asked for.
TEST(LoadProgram, TakesNoMemoryForManyCycles)
{
  LoadOptions load;
  load.preload = {move_to(0, 0, -0.02, 5)};
  load.legs = {move_to(0.01, 0, -0.1, 8), move_to(0, 0, -0.02, 8)};
  load.legs[1].parts = 2;
  load.cycles = 100000;
  const LoadSteps steps = LoadProgram(load).steps();
  EXPECT_EQ(steps.size(), 5u + 1600000);
  EXPECT_EQ(steps.different().size(), 5u + 2 * 16);
  const LoadStep last = steps[steps.size() - 1], early = steps[5 + 2 * 16 - 1];
  EXPECT_EQ(last.number, steps.size());
  EXPECT_EQ(last.cycle, load.cycles);
  EXPECT_EQ(last.motion, early.motion);
  EXPECT_EQ(last.phase, early.phase);
  ASSERT_EQ(last.parts.size(), 2u);
  EXPECT_EQ(last.parts[0].cycle, load.cycles);
  EXPECT_EQ(last.parts[0].number, steps.size());
  EXPECT_EQ(last.parts[0].motion, early.parts[0].motion);
  EXPECT_EQ(steps[5 + 2 * 16].cycle, 3u);
}

TEST(LoadProgram, HasThePartsThatSmallerStepsWouldBe)
{
  LoadOptions load, smaller;
  Leg pressed = move_to(0, 0.003, -0.1, 2), pushed;
  pushed.targets[0] = Drive{true, 1000};
  pushed.steps = 3;
  load.preload = smaller.preload = {pressed};
  load.legs = smaller.legs = {pushed, pressed};
  load.cycles = smaller.cycles = 2;
  load.preload[0].parts = 2;
  load.legs[0].parts = 5;
  smaller.preload[0].steps *= 2;
  smaller.legs[0].steps *= 5;
  std::vector<LoadStep> parts;
  for (const LoadStep &step : LoadProgram(load).steps())
  {
    if (step.parts.empty())
      parts.push_back(step);
    else
      EXPECT_EQ(step.parts.back().motion, step.motion);
    parts.insert(parts.end(), step.parts.begin(), step.parts.end());
  }
  const auto steps = LoadProgram(smaller).steps();
  EXPECT_EQ(LoadProgram(load).n_solved_parts(), steps.size());
  ASSERT_EQ(parts.size(), steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    EXPECT_EQ(parts[i].motion, steps[i].motion) << i; // to the last bit
    EXPECT_EQ(parts[i].force.components, steps[i].force.components) << i;
    EXPECT_EQ(parts[i].share, steps[i].share) << i;
    EXPECT_EQ(parts[i].cycle, steps[i].cycle) << i;
    EXPECT_EQ(parts[i].from_present, steps[i].from_present) << i;
  }
}

/// Forces to start from are remembered by the phase.
TEST(LoadProgram, TellsPartsFromStepsByTheirPhases)
{
  LoadOptions load;
  load.legs = {move_to(0, 0, -0.1, 5), move_to(0.02, 0, -0.05, 10), move_to(0, 0, 0, 30)};
  load.legs[1].parts = 4;
  std::set<unsigned int> phases;
  unsigned int n = 0;
  for (const LoadStep &step : LoadProgram(load).steps())
    for (const LoadStep &solved : step.parts.empty() ? std::vector<LoadStep>{step} : step.parts)
    {
      phases.insert(solved.phase);
      ++n;
    }
  EXPECT_EQ(n, 75u);
  EXPECT_EQ(phases.size(), n);
}

TEST(LoadProgram, WritesPositionsAsUsersWould)
{
  const auto steps = LoadProgram(scene().load).steps();
  EXPECT_EQ(steps[2].motion[2], -0.06);
  EXPECT_EQ(steps[11].motion[2], -0.03);
  EXPECT_EQ(steps[14].motion[2], 0);
}

TEST(ModelChoice, TakesTheSmallestExactModel)
{
  Parameters parameters = scene();
  EXPECT_EQ(chosen(parameters), "quarter");
  parameters.friction.angle = 90;
  EXPECT_EQ(chosen(parameters), "quarter");
  parameters.friction.angle = 30;
  EXPECT_EQ(chosen(parameters), "full");
  parameters.friction.mu = {{0.2, 0.2}};
  parameters.friction.slip_potential = std::array<double, 2>{{0.3, 0.15}};
  EXPECT_EQ(chosen(parameters), "full"); // the slip ellipse is still turned
  parameters.friction.slip_potential = std::array<double, 2>{{0.7, 0.7}};
  parameters.mesh.core_cells = 3;
  EXPECT_EQ(chosen(parameters), "axisymmetric");
  parameters.mesh.core_cells = 4;
  EXPECT_EQ(chosen(parameters), "axisymmetric");
  parameters.load.preload = {move_to(0.1, 0, 0, 1)};
  EXPECT_EQ(chosen(parameters), "half");
  EXPECT_TRUE(choose_model(parameters).symmetry.planes().normal_to_y);
  parameters.load.legs.push_back(move_to(0, 0.1, 0, 1));
  EXPECT_EQ(chosen(parameters), "full");
  parameters = scene();
  parameters.mesh.core_cells = 3;
  EXPECT_EQ(chosen(parameters), "full");
}

TEST(ModelChoice, RejectsWhatIsNotExactAndSaysWhatIs)
{
  Parameters parameters = scene();
  parameters.load.legs.push_back(move_to(0.1, 0, 0, 1));
  parameters.mesh.model = ModelKind::quarter;
  try
  {
    choose_model(parameters);
    FAIL() << "a quarter with a tangential leg was accepted";
  }
  catch (const InputError &error)
  {
    EXPECT_NE(std::string(error.what()).find("possible models are full, half"), std::string::npos)
        << error.what();
  }
  parameters.mesh.model = ModelKind::half;
  EXPECT_EQ(chosen(parameters), "half");
  parameters = scene();
  parameters.geometry.top_face = TopFace::guided;
  EXPECT_EQ(chosen(parameters), "quarter");
  parameters.mesh.model = ModelKind::full;
  EXPECT_THROW(choose_model(parameters), InputError);
  parameters.friction.mu = {{0.2, 0.2}};
  EXPECT_THROW(choose_model(parameters), InputError);
  parameters.mesh.model = ModelKind::automatic;
  EXPECT_EQ(chosen(parameters), "axisymmetric");
}

TEST(ModelChoice, RevolvesOnlyWhatIsTheSameAllAround)
{
  const auto complaint = [](const std::function<void(Parameters &)> &spoil)
  {
    Parameters parameters = scene();
    parameters.friction.mu = {{0.2, 0.2}};
    parameters.mesh.model = ModelKind::axisymmetric;
    parameters.mesh.degree = 4;
    spoil(parameters);
    try
    {
      return choose_model(parameters).symmetry.name();
    }
    catch (const InputError &error)
    {
      return std::string(error.what());
    }
  };
  EXPECT_EQ(complaint([](Parameters &) {}), "axisymmetric");
  EXPECT_EQ(
      complaint([](Parameters &p) { p.friction.mu[1] = 0.21; }),
      "Mesh/Model = axisymmetric is not possible: Friction/Coefficients = 0.2, 0.21 differ, which makes "
      "friction orthotropic; possible models are full, half, quarter");
  EXPECT_EQ(
      complaint(
          [](Parameters &p) {
            p.friction.slip_potential = std::array<double, 2>{{0.2, 0.21}};
          }),
      "Mesh/Model = axisymmetric is not possible: Friction/Slip potential = 0.2, 0.21 differ, which makes "
      "slip orthotropic; possible models are full, half, quarter");
  EXPECT_EQ(complaint([](Parameters &p) { p.load.legs[0].targets[1]->value = 0.1; }),
            "Mesh/Model = axisymmetric is not possible: the load program moves the held face along y; "
            "possible models are full, half");
  EXPECT_EQ(complaint([](Parameters &p) { p.mesh.model = ModelKind::quarter; }),
            "Mesh/Degree = 4 with the quarter model: allowed is a whole number from 1 to 3, or Mesh/Model = "
            "axisymmetric");
}

TEST(ModelChoice, TakesTheTwistForARoundBodyThatTurns)
{
  Parameters parameters = scene();
  parameters.friction.mu = {{0.2, 0.2}};
  parameters.load.legs[0].targets[5] = Drive{false, 0.1};
  const ModelChoice choice = choose_model(parameters);
  EXPECT_EQ(choice.symmetry.full_name(), "axisymmetric with twist");
  EXPECT_NE(choice.reason.find("with the twist, because the load program turns the held face about z"),
            std::string::npos)
      << choice.reason;
  parameters.mesh.backend = BodyBackend::multigrid; // which has no sections
  EXPECT_EQ(chosen(parameters), "full");
}

TEST(LoadProgram, KeepsComponentsThatALegDoesNotName)
{
  LoadOptions load;
  Leg down, sideways;
  down.targets[2] = Drive{false, -0.1};
  sideways.targets[0] = Drive{false, 0.02};
  sideways.steps = 2;
  load.legs = {down, sideways};
  load.cycles = 2;
  const auto steps = LoadProgram(load).steps();
  ASSERT_EQ(steps.size(), 6u);
  EXPECT_EQ(steps[1].motion, moved_by(0.01, 0, -0.1));
  EXPECT_EQ(steps[2].motion, moved_by(0.02, 0, -0.1));
  EXPECT_EQ(steps[3].motion, moved_by(0.02, 0, -0.1)) << "the second cycle begins where the first one ends";
}
} // namespace orthocone::test
