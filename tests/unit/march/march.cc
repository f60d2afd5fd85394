// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/march/march.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
namespace
{
Parameters small()
{
  Parameters parameters;
  parameters.mesh.core_cells = parameters.mesh.rings = 2;
  parameters.mesh.layers = parameters.mesh.degree = 1;
  parameters.load.legs = {move_to(0, 0, -0.1, 2), move_to(0, 0, -0.05, 2)};
  return parameters;
}

/// Writes down what it is told, as "next 1, solved 1, accepted 1".
class Recorder : public MarchObserver
{
public:
  bool goes_on(const LoadStep &next) override
  {
    told += "next " + std::to_string(next.number) + ", ";
    return next.number != stop_before;
  }
  bool accepts(const MarchedStep &solved) override
  {
    EXPECT_LT(solved.before.step, solved.step.number);
    EXPECT_EQ(solved.after.step, solved.step.number);
    told += "solved " + std::to_string(solved.step.number) + ", ";
    return solved.step.number != wrong_step;
  }
  void accepted(ContactState &state) override
  {
    told += "accepted " + std::to_string(state.step) + ", ";
    if (state.step == jump_from)
      state.step = jump_to;
  }
  void failed(const LoadStep &step, const SolverReport &report, double) override
  {
    EXPECT_FALSE(report.converged);
    told += "failed " + std::to_string(step.number);
  }

  std::string told;
  unsigned int stop_before = 0, wrong_step = 0, jump_from = 0, jump_to = 0;
};

MarchEnd marched(const Parameters &parameters, Recorder &recorder, unsigned int &last_step)
{
  const Scene scene(parameters, choose_model(parameters));
  StepSolver solver(scene);
  ContactState state(scene.gaps());
  const MarchEnd end = march(load_steps(parameters.load), solver, state, recorder);
  last_step = state.step;
  return end;
}
} // namespace

TEST(March, TellsOfEveryStep)
{
  Recorder recorder;
  unsigned int last = 0;
  EXPECT_EQ(marched(small(), recorder, last), MarchEnd::done);
  EXPECT_EQ(last, 4u);
  EXPECT_EQ(recorder.told, "next 1, solved 1, accepted 1, next 2, solved 2, accepted 2, next 3, solved 3, "
                           "accepted 3, next 4, solved 4, accepted 4, ");
}

TEST(March, EndsWhereItsObserverSaysSo)
{
  Recorder stopper, judge;
  unsigned int last = 0;
  stopper.stop_before = 2;
  EXPECT_EQ(marched(small(), stopper, last), MarchEnd::stopped);
  EXPECT_EQ(last, 1u);
  EXPECT_EQ(stopper.told, "next 1, solved 1, accepted 1, next 2, ");
  judge.wrong_step = 2;
  EXPECT_EQ(marched(small(), judge, last), MarchEnd::refused);
  EXPECT_EQ(last, 1u) << "a wrong step is not accepted";
}

TEST(March, GoesOnBehindTheStateThatAnObserverLeaves)
{
  Recorder jumper;
  unsigned int last = 0;
  jumper.jump_from = 1;
  jumper.jump_to = 3;
  Parameters parameters = small();
  EXPECT_EQ(marched(parameters, jumper, last), MarchEnd::done);
  EXPECT_EQ(jumper.told, "next 1, solved 1, accepted 1, next 4, solved 4, accepted 4, ");
}

TEST(March, EndsAtAStepThatIsNotSolved)
{
  Recorder recorder;
  unsigned int last = 0;
  Parameters parameters = small();
  parameters.contact_solver.method = "box3";
  parameters.contact_solver.maximum_iterations = 1;
  EXPECT_EQ(marched(parameters, recorder, last), MarchEnd::unsolved);
  EXPECT_EQ(last, 0u);
  EXPECT_EQ(recorder.told, "next 1, failed 1");
}
} // namespace orthocone::test
