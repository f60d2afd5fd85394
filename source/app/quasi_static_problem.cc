// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "quasi_static_problem.h"

#include "interrupt.h"
#include "step_messages.h"

#include <orthocone/base/blas_threads.h>
#include <orthocone/base/text.h>
#include <orthocone/base/version.h>
#include <orthocone/contact/problem/critical_friction.h>
#include <orthocone/parameters/parameters.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

namespace orthocone
{
QuasiStaticProblem::QuasiStaticProblem(const Parameters &parameters, const ModelChoice &choice,
                                       const RunFolder &folder, Log &log, ChosenMesh chosen)
    : parameters_(parameters),
      folder_(folder),
      log_(log),
      steps_(load_steps(parameters.load)),
      chosen_(with_scene(std::move(chosen), choice)),
      scene_(*chosen_.scene),
      solver_(scene_),
      evaluator_(scene_),
      state_(scene_.gaps()),
      critical_friction_(critical_friction_of_model()),
      checker_(scene_, parameters_.checks, parameters_.contact_solver.tolerance),
      cycles_(parameters_.load, scene_.symmetry().force_shares(scene_.surface()),
              reach_of(scene_.surface(), parameters_.geometry)),
      output_(folder_, parameters_.output, scene_, evaluator_),
      checkpoint_pause_(parameters.output.checkpoint_seconds)
{
  solver_.restore(chosen_.starts);
  record_.accuracy = chosen_.accuracy;
  record_.critical_friction = critical_friction_;
  record_.seconds = scene_.seconds();
  // The search built the model, too.
  if (chosen_.accuracy)
    record_.seconds.mesh_search = chosen_.search_seconds - scene_.seconds().sum();
  seconds_before_ = chosen_.search_seconds;
  log_.line(describe(critical_friction_));
  for (const std::string &warning : model_warnings(record_))
    log_.line("warning: " + warning);
}

ChosenMesh QuasiStaticProblem::with_scene(ChosenMesh chosen, const ModelChoice &choice) const
{
  if (chosen.scene)
    announce(choice, chosen.scene->body());
  else
    chosen.scene =
        std::make_unique<Scene>(parameters_, choice, [&](const Body &body) { announce(choice, body); });
  return chosen;
}

/// Tells what is going to be computed, and with what, before the long work begins.
void QuasiStaticProblem::announce(const ModelChoice &choice, const Body &body) const
{
  log_.line(describe_model(parameters_, choice, body.unknowns(), steps_.size()));
  tell_versions_and_warnings(parameters_, log_);
}

CriticalFrictionRecord QuasiStaticProblem::critical_friction_of_model() const
{
  const CriticalFriction critical = critical_friction(scene_.system());
  const auto &position = scene_.surface().nodes[critical.node].position;
  return {critical.factor, {{position[0], position[1]}}};
}

QuasiStaticProblem::Outcome QuasiStaticProblem::run(const std::optional<Checkpoint> &checkpoint,
                                                    const std::function<void()> &on_resumed)
{
  const BlasThreads threads(state_.force.size()); // also for what a resumed run computes again
  begin(checkpoint);
  if (checkpoint && on_resumed)
    on_resumed();
  try
  {
    const Outcome outcome = march();
    finish(outcome);
    return outcome;
  }
  catch (const FileError &error)
  {
    finish_if_possible({ExitCode::file_error, error.what()});
    throw;
  }
  catch (const std::bad_alloc &)
  {
    finish_if_possible({ExitCode::unsolved_step, "memory runs out"});
    throw;
  }
}

/// The failure before is the one to tell; a disk that is full is likely to be so for the summary, too.
void QuasiStaticProblem::finish_if_possible(const Outcome &outcome)
{
  try
  {
    finish(outcome);
  }
  catch (const std::exception &)
  {
  }
}

void QuasiStaticProblem::begin(const std::optional<Checkpoint> &checkpoint)
{
  if (!checkpoint)
  {
    output_.start();
    return;
  }
  if (checkpoint->state.n_nodes() != state_.n_nodes())
    throw FileError(folder_.path() + ": the checkpoint is of " + std::to_string(checkpoint->state.n_nodes()) +
                    " contact nodes, the model has " + std::to_string(state_.n_nodes()) +
                    "; was it written by another version of the program (" + checkpoint->program + ")?");
  cycles_.restore(checkpoint->cycles);
  output_.return_to(checkpoint->state.step, checkpoint->tables, checkpoint->fields);
  log_.line("resumed after load step " + std::to_string(checkpoint->state.step) + " of " +
            std::to_string(steps_.size()));
  if (checkpoint->program != program_version())
    log_.line("warning: the steps before were computed by version " + checkpoint->program +
              ", these are by " + program_version() + "; last digits may differ");
  state_ = checkpoint->state;
  solver_.restore(checkpoint->starts);
  totals_ = compute_totals(evaluator_, state_);
  record_ = checkpoint->record;
  record_.critical_friction = critical_friction_;
  record_.seconds.add(scene_.seconds());
  seconds_before_ = record_.total_seconds;
}

QuasiStaticProblem::Outcome QuasiStaticProblem::march()
{
  log_.start_steps(state_.step, steps_);
  let_steps_finish();
  for (const LoadStep &step : steps_)
  {
    if (step.number <= state_.step)
      continue;
    if (cycles_.is_to_stop())
      break;
    if (stop_is_requested())
    {
      save_checkpoint();
      return {ExitCode::interrupted, "interrupted after load step " + std::to_string(state_.step) + " of " +
                                         std::to_string(steps_.size()) +
                                         "; the same command with --resume goes on"};
    }
    const Outcome outcome = advance_to(step);
    if (outcome.code != ExitCode::done)
      return with_checkpoint(outcome);
    if (since_checkpoint_.seconds() >= checkpoint_pause_)
      save_checkpoint();
  }
  save_checkpoint();
  return {};
}

void QuasiStaticProblem::write(const SolvedStep &solved)
{
  timed(record_.seconds.output,
        [&]
        {
          output_.write(solved);
          log_.progress(solved.step, solved.totals, solved.report);
        });
}

std::string QuasiStaticProblem::failure_text(const LoadStep &step, const SolverReport &report) const
{
  const LoadStep told = step.resolved(solver_.leg_begin(state_, step));
  if (report.verdict == Verdict::unbalanced)
    return no_equilibrium_text(told, steps_, solver_.carried_share(state_, step));
  return unsolved_step_text(told, steps_, parameters_.contact_solver, report,
                            scene_.surface().nodes[report.worst_node]);
}

/// One that fails a check is neither accepted nor written.
QuasiStaticProblem::Outcome QuasiStaticProblem::advance_to(const LoadStep &step)
{
  ContactState next = state_;
  double seconds = 0;
  const SolverReport report = timed(seconds, [&] { return solver_.solve(next, step); });
  record_.seconds.contact += seconds;
  if (!report.converged)
  {
    record_.verdict = report.verdict;
    return {ExitCode::unsolved_step, failure_text(step, report)};
  }
  const Totals totals = compute_totals(evaluator_, next);
  const StepChecks checks =
      timed(record_.seconds.checks,
            [&] {
              return checker_.check({state_, totals_}, {next, totals}, report, record_.largest_energy);
            });
  if (const auto which = checker_.violation(checks))
    return {ExitCode::unsolved_step, wrong_step_text(step.resolved(next.leg_begin), steps_, *which)};
  const SolvedStep solved{next,
                          totals_,
                          totals,
                          report,
                          checks,
                          seconds,
                          step.resolved(next.leg_begin),
                          parameters_.contact_solver.method,
                          step.driven(scene_.symmetry(), parameters_.geometry.top_face)};
  write(solved);
  if (report.is_released)
    log_.line("nothing presses any more: the top opens the contact at u_z = " + to_text(next.motion[2]) +
              " mm");
  const auto cycle = cycles_.add_step(step, state_, solved);
  solver_.accept(state_, next, step);
  record_.add_step(step.number, totals_, totals, report, checks);
  state_ = std::move(next);
  totals_ = totals;
  if (cycle)
    timed(record_.seconds.output, [&] { end_cycle(*cycle); });
  return {};
}

/// Tells of a cycle, and ends the run or jumps the next cycles if these would be like it.
void QuasiStaticProblem::end_cycle(const CycleRow &row)
{
  output_.write(row);
  log_.note(describe(row, parameters_.load.cycles));
  if (cycles_.is_to_stop())
  {
    log_.line(describe_stop(cycles_.memory(), parameters_.load.stop_when_periodic));
    output_.end_with(state_);
  }
  if (const unsigned int n = cycles_.n_to_jump(); n > 0)
  {
    CycleRow jumped = cycles_.jump_cycles(state_, n);
    totals_ = compute_totals(evaluator_, state_);
    jumped.dissipation = totals_.total_dissipation - row.total_dissipation;
    jumped.total_dissipation = totals_.total_dissipation;
    jumped.max_accumulated_slip = totals_.max_accumulated_slip;
    output_.write(jumped);
    log_.line(describe_jump(jumped, cycles_.memory(), parameters_.load.jump_when_periodic));
  }
}

/// Saves the state before the step that failed; what is told first is why it failed.
QuasiStaticProblem::Outcome QuasiStaticProblem::with_checkpoint(Outcome outcome)
{
  try
  {
    save_checkpoint();
  }
  catch (const FileError &error)
  {
    outcome.message += std::string(" No checkpoint: ") + error.what();
  }
  return outcome;
}

void QuasiStaticProblem::save_checkpoint()
{
  const Stopwatch watch;
  record_.total_seconds = seconds_before_ + total_.seconds();
  output_.flush();
  Parameters given = parameters_;
  given.mesh = chosen_.requested;
  write_checkpoint(folder_,
                   {entry_values(given), entry_values(parameters_), program_version(), folder_.tables(),
                    output_.fields(), state_, solver_.memory(), cycles_.memory(), record_});
  since_checkpoint_ = Stopwatch();
  record_.seconds.output += watch.seconds();
  // Writing takes a twentieth of the time at most, unless every step was asked for.
  constexpr double least_pause = 20; // in multiples of the time that the writing takes
  const double asked = parameters_.output.checkpoint_seconds;
  checkpoint_pause_ = asked == 0 ? 0 : std::max(asked, least_pause * watch.seconds());
}

void QuasiStaticProblem::finish(const Outcome &outcome)
{
  record_.total_seconds = seconds_before_ + total_.seconds();
  const std::string status = outcome.code == ExitCode::done ? "complete" : outcome.message;
  folder_.write("summary.json", summary_json({status, parameters_, scene_.choice(), scene_.body().unknowns(),
                                              static_cast<unsigned int>(steps_.size()),
                                              state_.step - cycles_.memory().n_jumped_steps(),
                                              totals_.total_dissipation, record_, cycles_.memory()}));
  // Those of the parameters and of the model were told at the beginning.
  const auto warnings = all_warnings(parameters_, record_);
  for (std::size_t i = parameter_warnings(parameters_).size() + model_warnings(record_).size();
       i < warnings.size(); ++i)
    log_.line("warning: " + warnings[i]);
  log_.line(describe_energy(record_));
  log_.line(describe_seconds(record_) + "; files in " + folder_.path());
  output_.flush();
}
} // namespace orthocone
