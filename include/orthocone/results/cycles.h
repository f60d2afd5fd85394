// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/results/solved_step.h>
#include <orthocone/results/wear_jumps.h>
#include <orthocone/scene/load_program.h>
#include <orthocone/scene/options.h>

#include <optional>
#include <vector>

namespace orthocone
{
/// Largest difference between the states at both ends of a cycle: of nodal forces relative to `largest_force`
/// (N), of displacements of nodes and held face relative to `length` (mm); a rotation counts with `reach`
/// (mm), the largest distance of a node from its centre. Nodal forces are those of single nodes of the whole
/// body, whatever part is modelled (`shares` are ModelSymmetry::force_shares()). The law knows no rate, and
/// the state is its whole memory: a cycle that ends as it began is repeated by all that follow.
/// docs/theory.md, section 6.
double change_of_state(const ContactState &start, const ContactState &end, const Eigen::VectorXd &shares,
                       double largest_force, double length, double reach = 0);

/// Moves `state` over `n` cycles like the one from `start` to `state`: accumulated slip, dissipation and wear
/// grow as in that cycle, the step number by `n_steps` a cycle. Nothing else changes.
void jump(ContactState &state, const ContactState &start, unsigned int n, unsigned int n_steps);

/// A row of cycles.csv: a completed cycle, or several that are jumped.
struct CycleRow
{
  unsigned int cycle = 0;          ///< the last of the row, counted from 1
  unsigned int n_cycles = 1;       ///< that the row stands for
  unsigned int last_step = 0;      ///< number of the last step of `cycle`
  double peak_force_z = 0;         ///< when the total force is largest, N
  double force_z = 0;              ///< at the end, N
  double max_slip = 0;             ///< largest in the cycle, mm
  double max_accumulated_slip = 0; ///< at the end, since the start of the run, mm
  double accumulated_slip = 0;     ///< largest of a node in the cycles of the row, mm
  double dissipation = 0;          ///< in the cycles of the row, N mm
  double total_dissipation = 0;    ///< at the end, since the start of the run, N mm
  double work = 0;                 ///< of the upper face in the cycles of the row, N mm
  double into_wear = 0;            ///< the part of it that leaves the body with worn material, N mm
  double missing = 0;              ///< what the steps leave of the energy balance, N mm
  double change = 0;               ///< change_of_state() of the (last computed) cycle
  unsigned int iterations = 0;     ///< of the contact solver
  double worn_volume = 0;          ///< at the end, mm^3
  double max_wear_depth = 0;       ///< at the end, mm
  double wear_error = 0;           ///< WearMemory::error at the end, mm^3
};

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
  WearMemory wear;

  /// Number of steps that were jumped.
  unsigned int n_jumped_steps() const;
};

/// Watches the cycles of a load program: what each of them did, whether the response is periodic, and what is
/// then to be done.
class CycleWatch
{
public:
  /// `reach`: reach_of() the body, mm.
  CycleWatch(const LoadOptions &load, const Eigen::VectorXd &shares, double reach = 0,
             WearJumps wear = {{}, {}});

  /// To be called with every accepted step; `before` is the state before it. Returns the row of a cycle that
  /// this step completes.
  std::optional<CycleRow> add_step(const LoadStep &step, const ContactState &before,
                                   const SolvedStep &solved);

  /// Whether the run is to end here because its response is periodic.
  bool is_to_stop() const;

  /// How many cycles are to be jumped now. The last cycle of the program is always computed.
  unsigned int n_to_jump() const { return n_to_jump_; }

  /// Jumps `n` cycles like the last one. The totals of the row are not set.
  CycleRow jump_cycles(ContactState &state, unsigned int n);

  const CycleMemory &memory() const { return memory_; }
  void restore(const CycleMemory &memory);

private:
  void begin_cycle(const LoadStep &step, const ContactState &before, const Totals &totals);
  void complete(const ContactState &end, const Totals &totals);
  unsigned int n_alike(const ContactState &end);

  const LoadOptions load_;
  const unsigned int n_steps_;   ///< of a cycle
  const double reach_;           ///< mm
  const double length_;          ///< largest_way()
  const Eigen::VectorXd shares_; ///< ModelSymmetry::force_shares()
  WearJumps wear_;
  unsigned int n_to_jump_ = 0;
  CycleMemory memory_;
};

/// Sentences for the log.
std::string describe(const CycleRow &row, unsigned int n_cycles);
std::string describe_stop(const CycleMemory &memory, double tolerance);
std::string describe_jump(const CycleRow &row, const CycleMemory &memory, double tolerance);
} // namespace orthocone
