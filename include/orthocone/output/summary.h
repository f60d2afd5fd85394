// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/accuracy/step_search.h>
#include <orthocone/base/phases.h>
#include <orthocone/base/threads.h>
#include <orthocone/contact/solvers/contact_solver.h>
#include <orthocone/output/peaks.h>
#include <orthocone/output/zone_record.h>
#include <orthocone/results/cycles.h>
#include <orthocone/results/step_checks.h>
#include <orthocone/scene/load_program.h>
#include <orthocone/scene/model_choice.h>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace orthocone
{
/// The strongest friction under which no node can wedge, and the place where one would wedge first.
struct CriticalFrictionRecord
{
  double factor = 0;                      ///< CriticalFriction::factor
  std::array<double, 2> position{{0, 0}}; ///< mm
};

/// Sums and peaks over the steps, also over interruptions, and what is known before the first step.
struct RunRecord
{
  /// Adds a step. `before` are the totals of the step before.
  void add_step(unsigned int step, const Totals &before, const Totals &totals, const SolverReport &report,
                const StepChecks &checks);

  /// Adds cycles that are jumped.
  void add_jump(const CycleRow &jumped);

  /// The largest energy that flowed: stored, done in a step, or dissipated in all, N mm.
  double energy_scale() const;

  unsigned int n_iterations = 0;
  unsigned long n_v_cycles = 0; ///< ElasticBody::n_v_cycles() of this run and of those before the checkpoint
  double largest_residual = 0;
  Verdict verdict = Verdict::converged; ///< of the last step that was tried
  Folds folds{};                        ///< of the same step; not kept in checkpoints
  double largest_energy = 0;            ///< StepChecks::energy, N mm
  Peaks peaks{};
  std::pair<double, unsigned int> energy_defect{0, 0};       ///< the largest, and its step
  std::pair<double, unsigned int> wear_of_flattening{0, 0};  ///< StepChecks::wear_of_flattening, and its step
  std::pair<double, unsigned int> slip_of_change{0, 0};      ///< StepChecks::slip_of_change, and its step
  std::pair<double, unsigned int> flattening{0, 0};          ///< MotionChecks::flattening, and its step
  std::pair<double, unsigned int> pressure_of_modulus{0, 0}; ///< MotionChecks::pressure_of_modulus, likewise
  std::pair<double, unsigned int> slide_of_face{0, 0};       ///< MotionChecks::slide_of_face, likewise
  std::pair<double, unsigned int> border{0, 0};              ///< MotionChecks::border, likewise
  std::pair<double, unsigned int> change_of_factor{0, 0};    ///< StepChecks::change_of_factor, likewise
  std::pair<double, unsigned int> largest_factor{0, 0};      ///< FactorRange::largest, likewise
  double energy_of_fall = 0; ///< StepChecks::energy_of_fall of all steps, N mm
  ZoneRecord zones{};
  // Energies of all steps, those of jumped cycles included (docs/theory.md, section 4), N mm.
  double work = 0;        ///< of the upper face
  double dissipation = 0; ///< by friction
  double into_wear = 0;   ///< that left the body with worn material
  double stored = 0;      ///< elastic energy at the end
  double missing = 0;     ///< sum of |work - change of elastic energy - dissipation - into_wear| of the steps
  std::optional<AccuracyEstimate> accuracy{}; ///< where Mesh/Accuracy chose the mesh
  std::optional<StepAccuracy> steps{};        ///< where Load program/Accuracy divided the steps
  CriticalFrictionRecord critical_friction{}; ///< of the model, not kept in checkpoints
  ThreadChoice threads{};                     ///< of the present run
  double stretch = 1; ///< Body::stretch() where multigrid solves the body; not kept in checkpoints
  /// scene_warnings(), found once, because files may change while a run goes on; not
  /// kept in checkpoints
  std::vector<std::string> of_files{};
  PhaseSeconds seconds{};
  double total_seconds = 0;
};

/// All that summary.json states.
struct Summary
{
  std::string status; ///< "complete", or why not
  const Parameters &parameters;
  const ModelChoice &model;
  const BodyUnknowns &unknowns;
  unsigned int n_steps;
  unsigned int n_solved;
  const Totals &totals; ///< at the end
  const RunRecord &record;
  const CycleMemory &cycles;
};

/// Text of summary.json.
std::string summary_json(const Summary &summary);

/// The same for a run that failed before its first step.
std::string summary_json_before_steps(const std::string &status, const Parameters &parameters);

/// The text of a summary with another status; unchanged if the text is no summary.
std::string summary_json_with_status(const std::string &text, const std::string &status);

/// Warnings of the model before the first step, besides parameter_warnings().
std::vector<std::string> model_warnings(const RunRecord &record);

/// The defect that the load steps leave in the energy balance, in a line: an error of work and dissipation
/// that more steps reduce.
std::string describe_energy(const RunRecord &record, bool has_loads);

/// "critical friction 7.21 times the given one, at (9.95, 0.98) mm".
std::string describe(const CriticalFrictionRecord &critical);

/// parameter_warnings(), model_warnings(), and warnings of the steps so far.
std::vector<std::string> all_warnings(const Parameters &parameters, const RunRecord &record);

/// The wall times of the phases, in a line.
std::string describe_seconds(const RunRecord &record);
} // namespace orthocone
