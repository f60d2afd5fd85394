// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The work of the program around each step of its march: checks, tables, cycles, checkpoints.
#include "interrupt.h"
#include "quasi_static_problem.h"
#include "step_messages.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/ranks.h>
#include <orthocone/base/text.h>

namespace orthocone
{
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
    return no_equilibrium_text(reported, steps_, solver_.carried_share(state_, step));
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
    outcome_ = {ExitCode::unsolved_step, wrong_step_text(reported, steps_, *which)};
    return false;
  }
  const SolvedStep solved{next,
                          totals_,
                          totals,
                          marched.report,
                          checks,
                          marched.seconds,
                          reported,
                          parameters_.contact_solver.method,
                          marched.step.driven(scene_.symmetry(), parameters_.geometry.top_face),
                          static_cast<unsigned int>(scene_.body().n_v_cycles() - v_cycles_written_)};
  v_cycles_written_ += solved.n_v_cycles;
  write(solved);
  if (marched.report.is_released)
    log_.line("nothing presses any more: the top opens the contact at u_z = " + to_text(next.motion[2] + 0.) +
              " mm"); // -0 is 0
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
  log_.note(describe(row, parameters_.load.cycles));
  if (cycles_.is_to_stop())
  {
    log_.line(describe_stop(cycles_.memory(), parameters_.load.stop_when_periodic));
    output_.end_with(state);
  }
  if (const unsigned int n = cycles_.n_to_jump(); n > 0)
  {
    CycleRow jumped = cycles_.jump_cycles(state, n);
    totals_ = compute_totals(evaluator_, state);
    jumped.dissipation = totals_.total_dissipation - row.total_dissipation;
    jumped.total_dissipation = totals_.total_dissipation;
    jumped.max_accumulated_slip = totals_.max_accumulated_slip;
    jumped.worn_volume = totals_.worn_volume;
    jumped.max_wear_depth = totals_.max_wear_depth;
    record_.add_jump(jumped);
    output_.write(jumped);
    log_.line(describe_jump(jumped, cycles_.memory(), parameters_.load.jump_when_periodic));
  }
}
} // namespace orthocone
