// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "ending.h"
#include "thread_chooser.h"

#include <orthocone/accuracy/mesh_search.h>
#include <orthocone/base/errors.h>
#include <orthocone/march/march.h>
#include <orthocone/output/checkpoint.h>
#include <orthocone/output/log.h>
#include <orthocone/output/run_output.h>

namespace orthocone
{
/// Takes a body on an obstacle through a load program, step after step. It owns every module by value; the
/// member list is the wiring diagram of the program.
class QuasiStaticProblem : private MarchObserver
{
public:
  /// Builds, factorizes and condenses the body, unless `chosen` has it already; writes only the log. Throws
  /// InputError or FileError. `folder`, `log` and `threads` must outlive the problem.
  QuasiStaticProblem(ChosenModel chosen, const ModelChoice &choice, RunFolder &folder, Log &log,
                     ThreadChooser &threads);

  /// Solves all steps and writes the run folder, from the start or from a checkpoint on. The files of solved
  /// steps stay if one fails. `on_resumed` is called once the files have their content at the checkpoint.
  Ending run(const std::optional<Checkpoint> &checkpoint, const std::function<void()> &on_resumed = {});

private:
  ChosenModel with_scene(ChosenModel chosen, const ModelChoice &choice) const;
  void announce(const ModelChoice &choice, const Body &body) const;
  CriticalFrictionRecord critical_friction_of_model() const;
  void begin(const std::optional<Checkpoint> &checkpoint);
  Ending march_on();
  bool goes_on(const LoadStep &next) override;
  bool is_to_stop() override;
  bool accepts(const MarchedStep &marched) override;
  void accepted(ContactState &state) override;
  void failed(const LoadStep &step, const SolverReport &report, double seconds) override;
  std::string failure_text(const LoadStep &step, const SolverReport &report) const;
  void write(const SolvedStep &solved);
  void write_unsolved(const LoadStep &step);
  void end_cycle(const CycleRow &row, ContactState &state);
  Ending with_checkpoint(Ending outcome);
  void save_checkpoint();
  void take_stock();
  void finish(const Ending &outcome);
  void finish_if_possible(const Ending &outcome);

  const Parameters parameters_;
  RunFolder &folder_;
  Log &log_;
  const LoadSteps steps_;
  Stopwatch total_;
  ThreadChooser &threads_;
  const ChosenModel chosen_;
  const Scene &scene_; ///< owned by chosen_
  StepSolver solver_;
  const ContactFieldEvaluator evaluator_;
  ContactState state_;
  const CriticalFrictionRecord critical_friction_;
  RunRecord record_;
  Totals totals_; ///< of state_
  StepChecker checker_;
  CycleWatch cycles_;
  RunOutput output_;
  Ending outcome_{};                      ///< why the march did not go on
  std::optional<CycleRow> ended_cycle_{}; ///< a cycle that the last step has ended
  Stopwatch since_checkpoint_;
  const std::uint32_t gap_file_;       ///< input_files_checksum()
  double checkpoint_pause_;            ///< least seconds to the next one
  double seconds_before_ = 0;          ///< wall time of the runs before the checkpoint
  unsigned long v_cycles_before_ = 0;  ///< V-cycles of these runs
  unsigned long v_cycles_written_ = 0; ///< V-cycles of this run that timing.csv has
  unsigned long gmres_written_ = 0;    ///< the same of iterations of GMRES
};
} // namespace orthocone
