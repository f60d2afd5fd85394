// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "quasi_static_problem.h"

#include "interrupt.h"
#include "step_messages.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/ranks.h>
#include <orthocone/base/text.h>
#include <orthocone/base/threads.h>
#include <orthocone/base/version.h>
#include <orthocone/contact/problem/critical_friction.h>
#include <orthocone/march/rank_memory.h>
#include <orthocone/output/answers.h>
#include <orthocone/output/model_text.h>
#include <orthocone/scene/contact_mesh.h>
#include <orthocone/scene/mesh_files.h>
#include <orthocone/scene/parameters.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

namespace orthocone
{
QuasiStaticProblem::QuasiStaticProblem(ChosenModel chosen, const ModelChoice &choice, RunFolder &folder,
                                       Log &log, ThreadChooser &threads)
    : parameters_(chosen.parameters),
      folder_(folder),
      log_(log),
      steps_(LoadProgram(parameters_.load).steps()),
      threads_(threads),
      chosen_(with_scene(std::move(chosen), choice)),
      scene_(*chosen_.scene),
      solver_(scene_),
      evaluator_(scene_),
      state_(scene_.gaps(), scene_.n_loads()),
      critical_friction_(critical_friction_of_model()),
      checker_(scene_, parameters_.checks, parameters_.contact_solver.tolerance),
      cycles_(parameters_.load, scene_.symmetry().force_shares(scene_.surface()), scene_.pressed_areas(),
              reach_of(scene_.body().unknowns()),
              WearJumps(parameters_.wear, scene_.symmetry().n_copies() * scene_.pressed_areas()),
              FrictionJumps(scene_)),
      output_(folder_, parameters_.output, scene_, evaluator_),
      gap_file_(input_files_checksum(parameters_)),
      checkpoint_pause_(parameters_.output.checkpoint_seconds)
{
  solver_.restore(chosen_.starts);
  record_.threads = threads_.chosen();
  record_.accuracy = chosen_.accuracy;
  record_.steps = chosen_.steps;
  record_.critical_friction = critical_friction_;
  if (parameters_.mesh.backend == BodyBackend::multigrid)
    record_.stretch = scene_.body().mesh().stretch();
  record_.of_files = scene_warnings(parameters_, scene_.symmetry());
  record_.seconds = scene_.seconds();
  // The search for a mesh built the model, too.
  record_.seconds.mesh_search = chosen_.search_seconds - (chosen_.accuracy ? scene_.seconds().sum() : 0);
  seconds_before_ = chosen_.search_seconds;
  log_.line(describe(critical_friction_));
  for (const std::string &warning : model_warnings(record_))
    log_.line("warning: " + warning);
}

ChosenModel QuasiStaticProblem::with_scene(ChosenModel chosen, const ModelChoice &choice) const
{
  if (chosen.scene)
    announce(choice, chosen.scene->body().mesh());
  else
    chosen.scene =
        std::make_unique<Scene>(parameters_, choice, [&](const Body &body) { announce(choice, body); });
  return chosen;
}

/// Reports what is going to be computed, and with what, before the long work begins.
void QuasiStaticProblem::announce(const ModelChoice &choice, const Body &body) const
{
  log_.line(describe_model(parameters_, choice, body.unknowns()));
  if (n_ranks() > 1)
    log_.line("processes      " + std::to_string(n_ranks()));
  const ThreadChoice &threads = threads_.choose(body.unknowns().size().dofs);
  log_.line("threads        " + std::to_string(threads.number) + " (" + threads.reason + ")");
  report_versions_and_warnings(parameters_, log_);
}

CriticalFrictionRecord QuasiStaticProblem::critical_friction_of_model() const
{
  const CriticalFriction critical = critical_friction(scene_.system());
  const auto &position = scene_.surface().nodes[critical.node].position;
  const double of_start = parameters_.friction.factor.at_start(parameters_.load.first_cycle());
  return {critical.factor / of_start, {{position[0], position[1]}}};
}

Ending QuasiStaticProblem::run(const std::optional<Checkpoint> &checkpoint,
                               const std::function<void()> &on_resumed)
{
  // Also for the parts that a resumed run computes again. Without a matrix BLAS adds vectors alone.
  const BlasThreads threads(scene_.body().mesh().has_mesh() ? state_.force.size() : 0);
  begin(checkpoint);
  if (checkpoint && on_resumed)
    on_resumed();
  try
  {
    const Ending outcome = march_on();
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

/// The earlier failure is the one to report; a disk that is full is likely to be full for the summary, too.
void QuasiStaticProblem::finish_if_possible(const Ending &outcome)
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
  if (checkpoint->state.loads.size() != state_.loads.size())
    throw FileError(folder_.path() + ": the checkpoint is of " +
                    std::to_string(checkpoint->state.loads.size()) + " loads, the load program has " +
                    std::to_string(state_.loads.size()));
  if (checkpoint->state.n_nodes() != state_.n_nodes())
    throw FileError(folder_.path() + ": the checkpoint is of " + std::to_string(checkpoint->state.n_nodes()) +
                    " contact nodes, the model has " + std::to_string(state_.n_nodes()) +
                    "; was it written by another version of the program (" + checkpoint->program + ")?");
  output_.return_to(checkpoint->state.step, checkpoint->tables, checkpoint->fields);
  log_.line("resumed after load step " + std::to_string(checkpoint->state.step) + " of " +
            std::to_string(steps_.size()));
  if (checkpoint->program != program_version())
    log_.line("warning: the earlier steps were computed by version " + checkpoint->program +
              ", these are by " + program_version() + "; results may differ in their last digits");
  state_ = checkpoint->state;
  solver_.restore(checkpoint->starts);
  if (checkpoint->n_ranks != n_ranks())
    solver_.remember_body(state_);
  totals_ = compute_totals(evaluator_, state_);
  cycles_.restore(checkpoint->cycles, state_, totals_);
  RunRecord before = checkpoint->record;
  before.stretch = record_.stretch;
  before.of_files = record_.of_files;
  record_ = std::move(before);
  record_.threads = threads_.chosen();
  record_.critical_friction = critical_friction_;
  record_.seconds.add(scene_.seconds());
  seconds_before_ = record_.total_seconds;
  v_cycles_before_ = record_.n_v_cycles;
}

void QuasiStaticProblem::take_stock()
{
  record_.total_seconds = seconds_before_ + total_.seconds();
  record_.n_v_cycles = v_cycles_before_ + scene_.body().n_v_cycles();
}

/// Saves the state before the step that failed; the message begins with why it failed.
Ending QuasiStaticProblem::with_checkpoint(Ending outcome)
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
  take_stock();
  StartMemory starts = gathered(solver_.memory());
  output_.flush();
  if (is_first_rank())
    write_checkpoint(folder_, {entry_values(chosen_.given), entry_values(parameters_), gap_file_,
                               program_version(), folder_.tables(), output_.fields(), state_,
                               std::move(starts), cycles_.memory(), record_, n_ranks()});
  since_checkpoint_ = Stopwatch();
  record_.seconds.output += watch.seconds();
  // Writing takes a twentieth of the time at most, unless every step was asked for.
  constexpr double least_pause = 20; // in multiples of the time that the writing takes
  const double asked = parameters_.output.checkpoint_seconds;
  checkpoint_pause_ = asked == 0 ? 0 : std::max(asked, least_pause * watch.seconds());
}

void QuasiStaticProblem::finish(const Ending &outcome)
{
  take_stock();
  const std::string status = outcome.code == ExitCode::done ? "complete" : outcome.message;
  const Summary summary{status,
                        parameters_,
                        scene_.choice(),
                        scene_.body().unknowns(),
                        static_cast<unsigned int>(steps_.size()),
                        state_.step - cycles_.memory().n_jumped_steps(),
                        totals_,
                        record_,
                        cycles_.memory()};
  folder_.write("summary.json", summary_json(summary));
  log_.line(describe(answers(summary)));
  // The warnings of the parameters and of the model were reported at the beginning.
  const auto warnings = all_warnings(parameters_, record_);
  for (std::size_t i = parameter_warnings(parameters_).size() + model_warnings(record_).size();
       i < warnings.size(); ++i)
    log_.line("warning: " + warnings[i]);
  log_.line(describe_energy(record_, !parameters_.load.loads.empty()));
  if (record_.n_v_cycles > 0)
    log_.line("multigrid: " + std::to_string(record_.n_v_cycles) + " V-cycles on the finest mesh");
  log_.line(describe_seconds(record_) + "; files in " + folder_.path());
  output_.flush();
}

Ending QuasiStaticProblem::march_on()
{
  log_.start_steps(state_.step, steps_);
  let_steps_finish();
  outcome_ = {};
  try
  {
    switch (march(steps_, solver_, state_, *this))
    {
    case MarchEnd::done:
    case MarchEnd::stopped:
      save_checkpoint();
      return outcome_;
    case MarchEnd::unsolved:
    case MarchEnd::refused:
      break;
    }
  }
  catch (const SolveError &error)
  {
    outcome_ = {ExitCode::unsolved_step, broken_step_text(steps_[state_.step], steps_, error.what())};
  }
  return with_checkpoint(outcome_);
}

bool QuasiStaticProblem::goes_on(const LoadStep &)
{
  if (cycles_.is_to_stop())
    return false;
  if (const unsigned int n_computed = state_.step - cycles_.memory().n_jumped_steps();
      n_computed >= most_solved_parts)
  {
    outcome_ = {ExitCode::unsolved_step, too_few_jumps_text(n_computed, steps_.size() - state_.step)};
    return false;
  }
  if (!is_to_stop())
    return true;
  outcome_ = {ExitCode::interrupted, "interrupted after load step " + std::to_string(state_.step) + " of " +
                                         std::to_string(steps_.size()) +
                                         "; the same command with --resume goes on"};
  return false;
}

/// A signal stops a step between two iterations; --resume begins with the whole step.
bool QuasiStaticProblem::is_to_stop()
{
  return any_rank(stop_is_requested());
}

void QuasiStaticProblem::failed(const LoadStep &step, const SolverReport &report, const double seconds)
{
  record_.seconds.contact += seconds;
  record_.verdict = report.verdict;
  record_.folds = report.folds;
  outcome_ = {ExitCode::unsolved_step, failure_text(step, report)};
  write_unsolved(step);
}

/// The earlier failure is the one to report: a file that cannot be written is only named.
void QuasiStaticProblem::write_unsolved(const LoadStep &step)
{
  try
  {
    timed(record_.seconds.output, [&] { output_.write_unsolved(step, *solver_.unsolved()); });
  }
  catch (const FileError &error)
  {
    outcome_.message += std::string(" No problem file: ") + error.what();
  }
}

std::string QuasiStaticProblem::failure_text(const LoadStep &step, const SolverReport &report) const
{
  const LoadStep reported = step.resolved(solver_.leg_begin(state_, step));
  if (report.verdict == Verdict::unbalanced)
    return no_equilibrium_text(reported, steps_, solver_.carried_share(state_, step),
                               scene_.body().unknowns());
  return unsolved_step_text(reported, steps_, parameters_.contact_solver, report, scene_);
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

/// Checks and writes a step. A step that fails a check is neither accepted nor written.
bool QuasiStaticProblem::accepts(const MarchedStep &marched)
{
  const ContactState &next = marched.after;
  record_.seconds.contact += marched.seconds;
  const Totals totals = compute_totals(evaluator_, next);
  const StepChecks checks = timed(record_.seconds.checks,
                                  [&]
                                  {
                                    return checker_.check({marched.before, totals_}, {next, totals},
                                                          marched.report, record_.largest_energy);
                                  });
  const LoadStep reported = marched.step.resolved(next.leg_begin);
  if (const auto which = checker_.violation(checks))
  {
    outcome_ = {ExitCode::unsolved_step, wrong_step_text(reported, steps_, *which, parameters_.mesh.backend)};
    return false;
  }
  const SolvedStep solved{
      next,
      totals_,
      totals,
      marched.report,
      checks,
      marched.seconds,
      reported,
      parameters_.contact_solver.method,
      marched.step.driven(scene_.symmetry(), parameters_.geometry.top_face),
      static_cast<unsigned int>(scene_.body().n_v_cycles() - v_cycles_written_),
      static_cast<unsigned int>(scene_.compliance().n_gmres_iterations() - gmres_written_)};
  v_cycles_written_ += solved.n_v_cycles;
  gmres_written_ += solved.n_gmres_iterations;
  write(solved);
  if (marched.report.is_released)
    log_.line("the contact opens, because nothing presses the body any more, at u_z = " +
              to_text(next.motion[2] + 0.) + " mm"); // -0 is 0
  ended_cycle_ = cycles_.add_step(marched.step, marched.before, solved);
  record_.add_step(marched.step.number, totals_, totals, marched.report, checks);
  totals_ = totals;
  return true;
}

void QuasiStaticProblem::accepted(ContactState &state)
{
  if (ended_cycle_)
    timed(record_.seconds.output, [&] { end_cycle(*ended_cycle_, state); });
  if (of_first_rank(since_checkpoint_.seconds() >= checkpoint_pause_))
    save_checkpoint();
}

/// Reports a cycle, and ends the run or jumps the next cycles if these would be like it.
void QuasiStaticProblem::end_cycle(const CycleRow &row, ContactState &state)
{
  output_.write(row);
  log_.note(describe(row, parameters_.load.n_cycles()));
  if (const unsigned int n = cycles_.n_to_jump(); n > 0)
  {
    CycleRow jumped = cycles_.jump_cycles(state, n);
    totals_ = compute_totals(evaluator_, state);
    cycles_.end_jump(jumped, totals_);
    record_.add_jump(jumped);
    output_.write(jumped);
    log_.line(describe_jump(jumped, cycles_.memory(), parameters_.load.jump_when_periodic));
  }
  if (cycles_.is_to_stop())
  {
    log_.line(cycles_.why_to_stop());
    output_.end_with(state);
  }
}
} // namespace orthocone
