// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/simulation/quasi_static_problem.h>

#include <orthocone/contact/critical_friction.h>
#include <orthocone/parameters/parameters.h>
#include <orthocone/parameters/text.h>
#include <orthocone/simulation/blas_threads.h>
#include <orthocone/simulation/diagnosis.h>
#include <orthocone/simulation/interrupt.h>
#include <orthocone/simulation/version.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <sstream>
#include <utility>

namespace orthocone
{
QuasiStaticProblem::QuasiStaticProblem(const Parameters &parameters, const ModelChoice &choice,
                                       const RunFolder &folder, Log &log, ChosenMesh chosen)
    : parameters_(parameters),
      folder_(folder),
      log_(log),
      steps_(load_steps(parameters.load)),
      chosen_(with_model(std::move(chosen), choice)),
      model_(*chosen_.model),
      state_(model_.initial_state()),
      critical_friction_(critical_friction_of_model()),
      checker_(parameters_, choice.symmetry, model_.condensed(), model_.stiffness()),
      cycles_(parameters_.load, choice.symmetry.force_shares(model_.surface())),
      output_(folder_, parameters_, model_),
      checkpoint_pause_(parameters.output.checkpoint_seconds)
{
  record_.accuracy = chosen_.accuracy;
  record_.critical_friction = critical_friction_;
  record_.seconds = model_.seconds();
  // The search built the model, too.
  if (chosen_.accuracy)
    record_.seconds.mesh_search = chosen_.search_seconds - model_.seconds().sum();
  seconds_before_ = chosen_.search_seconds;
  log_.line(describe(critical_friction_));
  for (const std::string &warning : model_warnings(record_))
    log_.line("warning: " + warning);
}

ChosenMesh QuasiStaticProblem::with_model(ChosenMesh chosen, const ModelChoice &choice) const
{
  if (chosen.model)
    announce(choice, chosen.model->body());
  else
    chosen.model = std::make_unique<ContactModel>(parameters_, choice,
                                                  [&](const Body &body) { announce(choice, body); });
  return chosen;
}

/// Tells what is going to be computed, and with what, before the long work begins.
void QuasiStaticProblem::announce(const ModelChoice &choice, const Body &body) const
{
  log_.line(describe_model(parameters_, choice, body.unknowns(), steps_.size()));
  for (const auto &[name, version] : versions())
    log_.line(name + " " + version);
  for (const std::string &warning : parameter_warnings(parameters_))
    log_.line("warning: " + warning);
}

CriticalFrictionRecord QuasiStaticProblem::critical_friction_of_model() const
{
  const CriticalFriction critical = critical_friction(model_.problem());
  const auto &position = model_.surface().nodes[critical.node].position;
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
  model_.solver().restore(checkpoint->starts);
  totals_ = model_.totals(state_);
  record_ = checkpoint->record;
  record_.critical_friction = critical_friction_;
  record_.seconds.add(model_.seconds());
  seconds_before_ = record_.total_seconds;
}

QuasiStaticProblem::Outcome QuasiStaticProblem::march()
{
  log_.start_steps(state_.step);
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

/// Solves, checks and writes a step. One that fails a check is neither accepted nor written.
QuasiStaticProblem::Outcome QuasiStaticProblem::advance_to(const LoadStep &step)
{
  ContactState next = state_;
  double seconds = 0;
  const SolverReport report = timed(seconds, [&] { return model_.solver().solve(next, step); });
  record_.seconds.contact += seconds;
  if (!report.converged)
  {
    record_.verdict = report.verdict;
    return failure(step, report);
  }
  const Totals totals = model_.totals(next);
  const StepChecks checks =
      timed(record_.seconds.checks,
            [&] {
              return checker_.check({state_, totals_}, {next, totals}, report, record_.largest_energy);
            });
  if (const auto which = checker_.violation(checks))
    return violation(step, *which);
  const SolvedStep solved{next, totals_, totals, report, checks, seconds};
  timed(record_.seconds.output,
        [&]
        {
          output_.write(solved);
          log_.progress(step, steps_.size(), totals, report);
        });
  const auto cycle = cycles_.add_step(step, state_, solved);
  model_.solver().accept(state_, next, step);
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
    totals_ = model_.totals(state_);
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
                    output_.fields(), state_, model_.solver().memory(), cycles_.memory(), record_});
  since_checkpoint_ = Stopwatch();
  record_.seconds.output += watch.seconds();
  // A large checkpoint on a slow disk is not to take more than a twentieth of the time, unless every step was
  // asked for.
  constexpr double least_pause = 20; // in multiples of the time that the writing takes
  const double asked = parameters_.output.checkpoint_seconds;
  checkpoint_pause_ = asked == 0 ? 0 : std::max(asked, least_pause * watch.seconds());
}

void QuasiStaticProblem::finish(const Outcome &outcome)
{
  record_.total_seconds = seconds_before_ + total_.seconds();
  const std::string status = outcome.code == ExitCode::done ? "complete" : outcome.message;
  folder_.write("summary.json", summary_json({status, parameters_, model_.choice(), model_.body().unknowns(),
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

QuasiStaticProblem::Outcome QuasiStaticProblem::failure(const LoadStep &step,
                                                        const SolverReport &report) const
{
  const auto &place = model_.surface().nodes[report.worst_node].position;
  const ContactSolverOptions &options = parameters_.contact_solver;
  std::ostringstream text;
  text << "load step " << step.number << " of " << steps_.size() << " (u_z = " << to_text(step.top[2])
       << " mm) is not solved by " << to_word(options.method) << ", not even in eighths: residual "
       << report.residual << " > tolerance " << options.tolerance << ", penetration " << report.penetration
       << " mm, worst node at (" << place[0] << ", " << place[1] << ") mm after " << report.iterations
       << " iterations.\nThe files of the steps before stay. " << diagnosis(options, report);
  return {ExitCode::unsolved_step, text.str()};
}

QuasiStaticProblem::Outcome QuasiStaticProblem::violation(const LoadStep &step,
                                                          const std::string &which) const
{
  return {ExitCode::unsolved_step,
          "load step " + std::to_string(step.number) + " of " + std::to_string(steps_.size()) +
              " (u_z = " + to_text(step.top[2]) + " mm) is solved, but not right: " + which +
              ".\nThe files of the steps before stay; section Checks has the bounds."};
}
} // namespace orthocone
