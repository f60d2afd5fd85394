// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/results/fretting_loop.h>
#include <orthocone/results/friction_jumps.h>
#include <orthocone/results/solved_step.h>
#include <orthocone/results/wear_jumps.h>
#include <orthocone/scene/cycle_row.h>
#include <orthocone/scene/load_program.h>
#include <orthocone/scene/options.h>

#include <optional>
#include <string>
#include <vector>

namespace orthocone
{
/// Largest difference between the states at both ends of a cycle: of nodal forces relative to `largest_force`
/// (N), of displacements of nodes and held face relative to `length` (mm); a rotation counts with `reach`
/// (mm), the largest distance of a node from its centre. Nodal forces are those of single nodes of the whole
/// body, whatever part is modelled (`shares` are ModelSymmetry::force_shares()). The change of the factor of
/// friction with memory counts, too. The law knows no rate, and the state is its whole memory: a cycle that
/// ends as it began is repeated by all that follow. docs/theory.md, section 6.
double change_of_state(const ContactState &start, const ContactState &end, const Eigen::VectorXd &shares,
                       double largest_force, double length, double reach = 0);

/// Moves `state` over `n` cycles like the one from `start` to `state`: accumulated slip, dissipation and wear
/// grow as in that cycle, the step number by `n_steps` a cycle. Nothing else changes.
void jump(ContactState &state, const ContactState &start, unsigned int n, unsigned int n_steps);

/// Steps that were jumped, both ends included.
struct StepRange
{
  unsigned int first;
  unsigned int last;
};

bool operator==(const StepRange &a, const StepRange &b);

/// The data of a cycle's steps, and of the cycles before, that are stored until its end.
struct CycleMemory
{
  explicit CycleMemory(Eigen::Index n_nodes = 0)
      : start(n_nodes)
  {
  }

  ContactState start;              ///< start of the present or last cycle
  double start_dissipation = 0;    ///< Totals::total_dissipation at the start, N mm
  double largest_nodal_force = 0;  ///< in the cycle, from its start on, N
  double largest_force = 0;        ///< norm of the total force, N
  CycleRow row;                    ///< of the cycle so far
  unsigned int n_completed = 0;    ///< cycles, including jumped ones
  double change = 0;               ///< of the last completed cycle
  unsigned int periodic_since = 0; ///< first of the unbroken row of periodic cycles up to now; 0 = none
  std::vector<StepRange> jumped;
  std::vector<LoopPoint> loop; ///< the start of the cycle and its steps so far
  WearMemory wear;
  FrictionJumpMemory friction;

  /// Number of steps that were jumped.
  unsigned int n_jumped_steps() const;
};

/// Watches the cycles of a load program: what each of them did, whether the response is periodic, and what is
/// then to be done.
class CycleWatch
{
public:
  /// `areas`: of the nodes of the model, mm^2. `reach`: reach_of() the body, mm.
  CycleWatch(const LoadOptions &load, const Eigen::VectorXd &shares, const Eigen::VectorXd &areas,
             double reach = 0, WearJumps wear = {{}, {}}, FrictionJumps friction = {});

  /// To be called with every accepted step; `before` is the state before it. Returns the row of a cycle that
  /// this step completes.
  std::optional<CycleRow> add_step(const LoadStep &step, const ContactState &before,
                                   const SolvedStep &solved);

  /// Whether a StopRule ends the run here, and its sentence.
  bool is_to_stop() const { return !why_to_stop_.empty(); }
  const std::string &why_to_stop() const { return why_to_stop_; }

  /// How many cycles are to be jumped now. The last cycle of the program is always computed.
  unsigned int n_to_jump() const { return n_to_jump_; }

  /// Jumps `n` cycles like the last one. The totals of the row are not set: end_jump() does that.
  CycleRow jump_cycles(ContactState &state, unsigned int n);
  void end_jump(CycleRow &row, const Totals &totals);

  const CycleMemory &memory() const { return memory_; }

  /// Goes on from the memory of a run that has come to `state`.
  void restore(const CycleMemory &memory, const ContactState &state, const Totals &totals);

private:
  void begin_cycle(const LoadStep &step, const ContactState &before, const Totals &totals);
  void complete(const ContactState &end, const Totals &totals);
  void set_row(const ContactState &end, const Totals &totals);
  void ask_rules(const CycleRow &row);
  unsigned int n_alike(const ContactState &end);
  unsigned int n_followed(const ContactState &end, unsigned int left);

  const LoadOptions load_;
  const unsigned int n_steps_;   ///< of a cycle
  const double reach_;           ///< mm
  const double length_;          ///< largest_way()
  const Eigen::VectorXd shares_; ///< ModelSymmetry::force_shares()
  const Eigen::VectorXd areas_;
  WearJumps wear_;
  FrictionJumps friction_;
  unsigned int n_to_jump_ = 0;
  std::string why_to_stop_;
  CycleMemory memory_;
};

/// Sentences for the log.
std::string describe(const CycleRow &row, unsigned int n_cycles);
std::string describe_jump(const CycleRow &row, const CycleMemory &memory, double tolerance);
} // namespace orthocone
