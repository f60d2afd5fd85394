// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/march/march.h>

#include <gtest/gtest.h>

#include <cmath>

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

/// Records its calls, as "next 1, solved 1, accepted 1".
class Recorder : public MarchObserver
{
public:
  bool goes_on(const LoadStep &next) override
  {
    calls += "next " + std::to_string(next.number) + ", ";
    return next.number != stop_before;
  }
  bool accepts(const MarchedStep &solved) override
  {
    EXPECT_LT(solved.before.step, solved.step.number);
    EXPECT_EQ(solved.after.step, solved.step.number);
    calls += "solved " + std::to_string(solved.step.number) + ", ";
    return solved.step.number != wrong_step;
  }
  void accepted(ContactState &state) override
  {
    calls += "accepted " + std::to_string(state.step) + ", ";
    if (state.step == jump_from)
      state.step = jump_to;
  }
  void failed(const LoadStep &step, const SolverReport &report, double) override
  {
    EXPECT_FALSE(report.converged);
    calls += "failed " + std::to_string(step.number);
  }

  std::string calls;
  unsigned int stop_before = 0, wrong_step = 0, jump_from = 0, jump_to = 0;
};

/// Gives the second step up at one of its iterations.
class Stopper : public Recorder
{
public:
  bool goes_on(const LoadStep &next) override
  {
    is_second = next.number == 2;
    return Recorder::goes_on(next) && !is_asked;
  }
  bool is_to_stop() override
  {
    is_asked = is_asked || (is_second && ++n_iterations == stop_at);
    return is_asked;
  }

  bool is_second = false, is_asked = false;
  unsigned int n_iterations = 0, stop_at = 0;
};

MarchEnd marched(const Parameters &parameters, Recorder &recorder, unsigned int &last_step)
{
  const Scene scene(parameters, choose_model(parameters));
  StepSolver solver(scene);
  ContactState state(scene.gaps());
  const MarchEnd end = march(LoadProgram(parameters.load).steps(), solver, state, recorder);
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
  EXPECT_EQ(recorder.calls, "next 1, solved 1, accepted 1, next 2, solved 2, accepted 2, next 3, solved 3, "
                            "accepted 3, next 4, solved 4, accepted 4, ");
}

TEST(March, EndsWhereItsObserverSaysSo)
{
  Recorder stopper, judge;
  unsigned int last = 0;
  stopper.stop_before = 2;
  EXPECT_EQ(marched(small(), stopper, last), MarchEnd::stopped);
  EXPECT_EQ(last, 1u);
  EXPECT_EQ(stopper.calls, "next 1, solved 1, accepted 1, next 2, ");
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
  EXPECT_EQ(jumper.calls, "next 1, solved 1, accepted 1, next 4, solved 4, accepted 4, ");
}

// A scheduler kills what does not end soon, and a step, here of four parts, may take an hour.
TEST(March, StopsBetweenIterationsAndLosesNothing)
{
  Parameters parameters = small();
  parameters.load.legs = {move_to(0, 0, -0.1, 2), move_to(0.02, 0, -0.1, 2)};
  parameters.load.legs[0].parts = 4;
  const Scene scene(parameters, choose_model(parameters));
  const auto steps = LoadProgram(parameters.load).steps();
  StepSolver whole_solver(scene), solver(scene);
  ContactState whole(scene.gaps()), state(scene.gaps());
  Stopper counter, stopper;
  Recorder others;
  EXPECT_EQ(march(steps, whole_solver, whole, counter), MarchEnd::done);
  stopper.stop_at = counter.n_iterations - 1; // in the last part
  EXPECT_EQ(march(steps, solver, state, stopper), MarchEnd::stopped);
  EXPECT_EQ(stopper.calls, "next 1, solved 1, accepted 1, next 2, next 2, ");
  EXPECT_EQ(march(steps, solver, state, others), MarchEnd::done);
  EXPECT_EQ(state.force, whole.force);
  EXPECT_EQ(state.displacement, whole.displacement);
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
  EXPECT_EQ(recorder.calls, "next 1, failed 1");
}

/// Remembers the problem of the step that is not solved.
class Keeper : public MarchObserver
{
public:
  explicit Keeper(const StepSolver &solver)
      : solver_(solver)
  {
  }
  bool accepts(const MarchedStep &) override { return !solver_.unsolved(); }
  void failed(const LoadStep &, const SolverReport &, double) override { q = solver_.unsolved()->q(); }

  NodeVector q;

private:
  const StepSolver &solver_;
};

// Without forces a plane base sinks in by the motion of the whole step, or of its first part. Half of it
// would be that of a step that is halved.
TEST(StepSolver, NamesTheProblemThatItFailedOnFirst)
{
  for (const unsigned int parts : {1, 4})
  {
    Parameters parameters = small();
    parameters.load.legs = {move_to(0, 0, -0.1, 1)};
    parameters.load.legs[0].parts = parts;
    parameters.contact_solver.method = "box3";
    parameters.contact_solver.maximum_iterations = 1;
    const Scene scene(parameters, choose_model(parameters));
    StepSolver solver(scene);
    Keeper keeper(solver);
    ContactState state(scene.gaps());
    EXPECT_EQ(march(LoadProgram(parameters.load).steps(), solver, state, keeper), MarchEnd::unsolved);
    ASSERT_EQ(keeper.q.size(), state.force.size());
    EXPECT_NEAR(keeper.q[0], -0.1 / parts, 1e-12) << parts << " parts";
    parameters.contact_solver = {};
    const Scene easy(parameters, choose_model(parameters));
    StepSolver good(easy);
    Keeper nothing(good);
    ContactState other(easy.gaps());
    EXPECT_EQ(march(LoadProgram(parameters.load).steps(), good, other, nothing), MarchEnd::done);
  }
}

/// Case B on few cells, pressed, moved and released.
Parameters moved()
{
  Parameters parameters = small();
  parameters.load.legs = {move_to(0, 0, -0.1, 1), move_to(0.02, 0.01, -0.05, 2)};
  return parameters;
}

TEST(March, SolvesPartsAsSmallerSteps)
{
  Parameters divided = moved(), smaller = moved();
  divided.load.legs[1].parts = 3;
  smaller.load.legs[1].steps = 6;
  const Scene scene(smaller, choose_model(smaller));
  StepSolver by_parts(scene), by_steps(scene);
  ContactState state(scene.gaps()), other(scene.gaps());
  Recorder recorder;
  EXPECT_EQ(march(LoadProgram(divided.load).steps(), by_parts, state, recorder), MarchEnd::done);
  EXPECT_EQ(recorder.calls, "next 1, solved 1, accepted 1, next 2, solved 2, accepted 2, next 3, solved 3, "
                            "accepted 3, ");
  MarchObserver silent;
  EXPECT_EQ(march(LoadProgram(smaller.load).steps(), by_steps, other, silent), MarchEnd::done);
  EXPECT_EQ(state.step, 3u);
  EXPECT_EQ(state.force, other.force); // to the last bit: all that a part starts from is the same
  EXPECT_EQ(state.displacement, other.displacement);
  EXPECT_EQ(state.dissipated_energy, other.dissipated_energy);
  EXPECT_EQ(state.work, other.work);
  EXPECT_EQ(by_parts.memory().change, by_steps.memory().change);
}

// A step is as good as the worst of its parts: the report has the largest residual, all iterations.
TEST(March, ReportsTheWorstOfTheParts)
{
  Parameters divided = moved(), smaller = moved();
  divided.load.legs[1].parts = 3;
  smaller.load.legs[1].steps = 6;
  const Scene scene(smaller, choose_model(smaller));
  StepSolver by_parts(scene), by_steps(scene);
  ContactState state(scene.gaps()), other(scene.gaps());
  std::vector<SolverReport> reports;
  for (const LoadStep &step : LoadProgram(smaller.load).steps())
  {
    const ContactState before = other;
    reports.push_back(by_steps.solve(other, step));
    by_steps.accept(before, other, step);
  }
  for (const LoadStep &step : LoadProgram(divided.load).steps())
  {
    const ContactState before = state;
    const SolverReport report = by_parts.solve(state, step);
    by_parts.accept(before, state, step);
    const std::size_t first = step.number == 1 ? 0 : 3 * step.number - 5, n = step.number == 1 ? 1 : 3;
    double worst = 0;
    unsigned int iterations = 0;
    for (std::size_t i = first; i < first + n; ++i)
    {
      worst = std::max(worst, reports[i].residual);
      iterations += reports[i].iterations;
    }
    EXPECT_EQ(report.residual, worst) << step.number;
    EXPECT_EQ(report.iterations, iterations) << step.number;
  }
  EXPECT_NE(reports[1].residual, reports[3].residual) << "a test that cannot fail";
}

/// Two of three parts of the second step are carried, the third is not.
TEST(March, LeavesNothingOfAStepWhosePartIsNotSolved)
{
  Parameters parameters = moved();
  parameters.load.legs[1] = Leg();
  parameters.load.legs[1].targets[0] = Drive{true, 1};
  parameters.load.legs[1].parts = 3;
  const Scene scene(parameters, choose_model(parameters));
  StepSolver solver(scene);
  ContactState state(scene.gaps());
  MarchObserver silent;
  const LoadOptions pressed{{}, {parameters.load.legs[0]}};
  ASSERT_EQ(march(LoadProgram(pressed).steps(), solver, state, silent), MarchEnd::done);
  const double carried = parameters.friction.mu[0] * scene.held_wrench(state.force, state.motion)[2];
  parameters.load.legs[1].targets[0] = Drive{true, 1.2 * std::abs(carried)};
  Recorder recorder;
  const ContactState before = state;
  const StartMemory starts = solver.memory();
  EXPECT_EQ(march(LoadProgram(parameters.load).steps(), solver, state, recorder), MarchEnd::unsolved);
  EXPECT_EQ(recorder.calls, "next 2, failed 2");
  EXPECT_EQ(state.step, 1u);
  EXPECT_EQ(state.force, before.force);
  EXPECT_EQ(state.work, before.work);
  EXPECT_EQ(solver.memory().change, starts.change);
  EXPECT_EQ(solver.memory().of_phase.size(), starts.of_phase.size());
}

TEST(March, ForgetsThePartsOfAStepThatIsRefused)
{
  Parameters parameters = moved();
  parameters.load.legs[1].parts = 2;
  const Scene scene(parameters, choose_model(parameters));
  StepSolver solver(scene);
  ContactState state(scene.gaps());
  Recorder judge;
  judge.wrong_step = 2;
  EXPECT_EQ(march(LoadProgram(parameters.load).steps(), solver, state, judge), MarchEnd::refused);
  EXPECT_EQ(state.step, 1u);
  EXPECT_EQ(solver.memory().of_phase.size(), 1u);
}
} // namespace orthocone::test
