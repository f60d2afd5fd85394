// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/results/cycles.h>

#include <orthocone/base/numbers.h>
#include <orthocone/base/text.h>
#include <orthocone/results/held_face.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace orthocone
{
using Eigen::Index;

namespace
{
double largest_of_nodes(const NodeVector &vectors)
{
  double largest = 0;
  for (Index node = 0; node < vectors.size() / 3; ++node)
    largest = std::max(largest, vectors.segment<3>(3 * node).norm());
  return largest;
}

double largest_force_of_nodes(const NodeVector &forces, const Eigen::VectorXd &shares)
{
  double largest = 0;
  for (Index node = 0; node < shares.size(); ++node)
    largest = std::max(largest, forces.segment<3>(3 * node).norm() / shares[node]);
  return largest;
}

/// Within which cycles count as alike; 0: nobody asks.
double tolerance_of(const LoadOptions &load)
{
  double tolerance = load.jump_when_periodic;
  for (const auto &rule : load.stops)
    tolerance = std::max(tolerance, rule->periodic_within());
  return tolerance;
}

LoopPoint loop_point(const ContactState &state, const Totals &totals)
{
  const Eigen::Vector3d way = state.motion.translation();
  return {way.head<2>(), -totals.force.head<2>(), totals.force[2], way[2]};
}

void add_factor(CycleRow &row, const FactorRange &factor)
{
  row.least_factor = row.largest_factor == 0 ? factor.least : std::min(row.least_factor, factor.least);
  row.largest_factor = std::max(row.largest_factor, factor.largest);
}

/// What a row has of the end of its cycles.
void set_end(CycleRow &row, const Totals &totals)
{
  row.force_z = totals.force[2];
  row.max_accumulated_slip = totals.max_accumulated_slip;
  row.total_dissipation = totals.total_dissipation;
  row.worn_volume = totals.worn_volume;
  row.max_wear_depth = totals.max_wear_depth;
}
} // namespace

double change_of_state(const ContactState &start, const ContactState &end, const Eigen::VectorXd &shares,
                       const double largest_force, const double length, const double reach)
{
  const RigidMotion change{end.motion.components - start.motion.components};
  const double held = std::max(change.translation().cwiseAbs().maxCoeff(), reach * change.rotation().norm());
  const double moved = std::max(held, largest_of_nodes(end.displacement - start.displacement));
  // Where forces drive the face, the load program does not have its motion.
  const double way = std::max(largest_way(start.motion, reach), largest_way(end.motion, reach));
  const double of_forces = relative(largest_force_of_nodes(end.force - start.force, shares), largest_force);
  const double of_law = std::max(of_forces, change_of_factor(start, end));
  const double scale = std::max(length, way);
  // Where loads alone drive the body, no motion says what is large, and forces decide.
  return scale > 0 ? std::max(of_law, relative(moved, scale)) : of_law;
}

void jump(ContactState &state, const ContactState &start, const unsigned int n, const unsigned int n_steps)
{
  state.accumulated_slip += n * (state.accumulated_slip - start.accumulated_slip);
  state.dissipated_energy += n * (state.dissipated_energy - start.dissipated_energy);
  state.wear_depth += n * (state.wear_depth - start.wear_depth);
  state.work += n * (state.work - start.work);
  state.step += n * n_steps;
}

bool operator==(const StepRange &a, const StepRange &b)
{
  return a.first == b.first && a.last == b.last;
}

unsigned int CycleMemory::n_jumped_steps() const
{
  unsigned int n = 0;
  for (const StepRange &range : jumped)
    n += range.last - range.first + 1;
  return n;
}

CycleWatch::CycleWatch(const LoadOptions &load, const Eigen::VectorXd &shares, const Eigen::VectorXd &areas,
                       const double reach, WearJumps wear, FrictionJumps friction)
    : load_(load),
      n_steps_(static_cast<unsigned int>(LoadProgram(load).n_steps_of_cycle())),
      reach_(reach),
      length_(largest_way(load, reach)),
      shares_(shares),
      areas_(areas),
      wear_(std::move(wear)),
      friction_(std::move(friction)),
      memory_(shares.size())
{
}

void CycleWatch::begin_cycle(const LoadStep &step, const ContactState &before, const Totals &totals)
{
  memory_.start = before;
  memory_.start_dissipation = totals.total_dissipation;
  memory_.largest_nodal_force = largest_force_of_nodes(before.force, shares_);
  memory_.largest_force = 0;
  memory_.row = CycleRow();
  memory_.row.cycle = step.cycle;
  memory_.loop = {loop_point(before, totals)};
}

std::optional<CycleRow> CycleWatch::add_step(const LoadStep &step, const ContactState &before,
                                             const SolvedStep &solved)
{
  if (step.cycle == 0)
    return std::nullopt;
  if (step.phase == 0)
    begin_cycle(step, before, solved.before);
  CycleRow &row = memory_.row;
  const Totals &totals = solved.totals;
  memory_.largest_nodal_force =
      std::max(memory_.largest_nodal_force, largest_force_of_nodes(solved.state.force, shares_));
  if (totals.force.norm() > memory_.largest_force)
  {
    memory_.largest_force = totals.force.norm();
    row.peak_force_z = totals.force[2];
    if (totals.factor)
      row.mean_factor = totals.factor->mean;
  }
  if (totals.factor)
    add_factor(row, *totals.factor);
  memory_.loop.push_back(loop_point(solved.state, totals));
  row.max_slip = std::max(row.max_slip, totals.max_slip);
  row.work += solved.checks.work;
  row.into_wear += solved.checks.into_wear;
  row.missing += solved.checks.energy_defect * solved.checks.energy;
  row.iterations += solved.report.iterations;
  if (!step.ends_cycle)
    return std::nullopt;
  complete(solved.state, totals);
  return row;
}

void CycleWatch::set_row(const ContactState &end, const Totals &totals)
{
  CycleRow &row = memory_.row;
  row.last_step = end.step;
  set_end(row, totals);
  row.accumulated_slip = (end.accumulated_slip - memory_.start.accumulated_slip).maxCoeff();
  row.dissipation = totals.total_dissipation - memory_.start_dissipation;
  row.change = memory_.change;
  row.wear_error = memory_.wear.error;
  row.factor_error = memory_.friction.error;
  row.loop = loop_figures(memory_.loop);
  row.worst_energy =
      ((end.dissipated_energy - memory_.start.dissipated_energy).array() / areas_.array()).maxCoeff();
  row.worst_wear = (end.wear_depth - memory_.start.wear_depth).maxCoeff();
}

void CycleWatch::complete(const ContactState &end, const Totals &totals)
{
  memory_.n_completed = memory_.row.cycle;
  memory_.change = change_of_state(memory_.start, end, shares_, memory_.largest_nodal_force, length_, reach_);
  const double tolerance = tolerance_of(load_);
  if (tolerance == 0 || !(memory_.change <= tolerance))
    memory_.periodic_since = 0;
  else if (memory_.periodic_since == 0)
    memory_.periodic_since = memory_.row.cycle;
  set_row(end, totals);
  ask_rules(memory_.row);
  n_to_jump_ = is_to_stop() ? 0 : n_alike(end);
  memory_.row.wear_error = memory_.wear.error;
  memory_.row.factor_error = memory_.friction.error;
}

void CycleWatch::ask_rules(const CycleRow &row)
{
  why_to_stop_.clear();
  for (const auto &rule : load_.stops)
    if (why_to_stop_.empty())
      why_to_stop_ = rule->why_to_stop(row);
}

/// Cycles that may be jumped behind the one that ends here.
unsigned int CycleWatch::n_alike(const ContactState &end)
{
  if (memory_.n_completed >= load_.cycles)
    return 0;
  const unsigned int left = load_.cycles - memory_.n_completed - 1;
  if (wear_.are_wanted() || friction_.are_wanted())
    return n_followed(end, left);
  const bool is_periodic = load_.jump_when_periodic > 0 && memory_.periodic_since > 0;
  return is_periodic ? std::min(load_.jump_cycles, left) : 0;
}

/// Cycles that wear, or change friction, so little that their sum is like as many computed ones.
unsigned int CycleWatch::n_followed(const ContactState &end, const unsigned int left)
{
  unsigned int n = left;
  if (friction_.are_wanted())
    n = friction_.after_cycle(memory_.start, end, memory_.n_completed, n);
  if (wear_.are_wanted())
  {
    const unsigned int of_wear = wear_.after_cycle(memory_.start, end, left);
    n = std::min(n, of_wear);
    if (n < of_wear)
      wear_.shorten(n);
  }
  if (n > 0)
    friction_.begin_jump(memory_.start, end, n);
  memory_.wear = wear_.memory();
  memory_.friction = friction_.memory();
  return n;
}

void CycleWatch::restore(const CycleMemory &memory, const ContactState &state, const Totals &totals)
{
  memory_ = memory;
  wear_.restore(memory.wear);
  friction_.restore(memory.friction);
  if (memory.row.last_step == 0)
    return; // in the middle of a cycle
  set_row(state, totals);
  memory_.row.cycle = memory.n_completed;
  ask_rules(memory_.row);
}

CycleRow CycleWatch::jump_cycles(ContactState &state, const unsigned int n)
{
  const unsigned int first = state.step + 1;
  jump(state, memory_.start, n, n_steps_);
  memory_.jumped.push_back({first, state.step});
  memory_.n_completed += n;
  CycleRow row = memory_.row;
  row.cycle = memory_.n_completed;
  row.n_cycles = n;
  row.last_step = state.step;
  row.accumulated_slip *= n;
  row.worst_energy *= n;
  row.worst_wear *= n;
  row.work *= n;
  row.into_wear *= n;
  row.missing *= n;
  row.iterations = 0;
  return row;
}

void CycleWatch::end_jump(CycleRow &row, const Totals &totals)
{
  row.dissipation = totals.total_dissipation - memory_.row.total_dissipation;
  set_end(row, totals);
  ask_rules(row);
}

std::string describe(const CycleRow &row, const unsigned int n_cycles)
{
  return "cycle " + std::to_string(row.cycle) + " of " + std::to_string(n_cycles) + ": change " +
         to_text(row.change) + ", dissipation " + to_text(row.dissipation) + " N mm, accumulated slip " +
         to_text(row.accumulated_slip) + " mm";
}

/// What a jump of cycles that are not periodic says of wear.
static std::string worn_text(const CycleRow &row)
{
  return "largest depth " + to_text(row.max_wear_depth) + " mm, worn volume " + to_text(row.worn_volume) +
         " mm^3 (+- " + to_text(std::abs(row.wear_error)) + " by jumps)";
}

std::string describe_jump(const CycleRow &row, const CycleMemory &memory, const double tolerance)
{
  const std::string jumps = "jumps " + std::to_string(row.n_cycles) + " cycles",
                    to_cycle = " like the last one, to cycle " + std::to_string(row.cycle) + ": ";
  if (memory.friction.n_jumped > 0)
    return jumps + " that slip" + to_cycle + "accumulated slip " + to_text(row.max_accumulated_slip) +
           " mm, error of the mean factor of friction " + to_text(std::abs(row.factor_error)) + " by jumps" +
           (row.worn_volume > 0 ? ", " + worn_text(row) : "");
  if (memory.periodic_since == 0)
    return jumps + " that wear" + to_cycle + worn_text(row);
  return "periodic since cycle " + std::to_string(memory.periodic_since) + ": change " +
         to_text(memory.change) + " <= Load program/Jump when periodic = " + to_text(tolerance) + "; " +
         jumps + ", to load step " + std::to_string(row.last_step);
}
} // namespace orthocone
