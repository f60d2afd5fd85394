// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/load_program.h>

#include <orthocone/base/numbers.h>
#include <orthocone/scene/load_path.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace orthocone
{
namespace
{
/// Point between the ends of a leg, with the 15 digits that a user would write: -0.06, not
/// -0.06000000000000001.
double between(const double start, const double end, const double share)
{
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.15g", start + (end - start) * share);
  const double position = std::strtod(text.data(), nullptr);
  // The last digits of a difference are rounding: 0.1 - 0.07 is not 0.03.
  constexpr double rounding = 1e-15;
  return std::abs(position) < rounding * std::max(std::abs(start), std::abs(end)) ? 0 : position;
}

/// Factor from the unit of users, who write rotations in degrees.
double unit_of(const Drive &drive, const unsigned int component)
{
  constexpr unsigned int first_rotation = 3;
  return !drive.by_force && component >= first_rotation ? radians_per_degree : 1;
}

/// Sets a component of a step that ends at the `share` of its leg, which starts from `before`.
void set_component(LoadStep &step, const unsigned int i, const Drive &before, const Leg &leg)
{
  const Drive target = leg.targets[i].value_or(before);
  step.by_force[i] = target.by_force;
  step.from_present[i] = target.by_force != before.by_force;
  const bool is_end = step.share == 1 || step.from_present[i];
  const double value = is_end ? target.value : between(before.value, target.value, step.share);
  (target.by_force ? step.force[i] : step.motion[i]) = unit_of(target, i) * value;
}

/// The place of a step or a part in the program.
struct Place
{
  unsigned int number;
  unsigned int cycle;
  unsigned int phase;
};

/// Step k of the n equal steps of a leg.
LoadStep step_of(const PathLeg &path_leg, const unsigned int k, const unsigned int n, const Place &place)
{
  LoadStep step{{}, place.number, k, place.cycle, place.phase};
  step.share = static_cast<double>(k) / n;
  for (unsigned int i = 0; i < n_rigid_components; ++i)
    set_component(step, i, path_leg.before[i], *path_leg.leg);
  for (std::size_t l = 0; l < path_leg.loads_after.size(); ++l)
    step.loads.push_back(step.share == 1
                             ? path_leg.loads_after[l]
                             : between(path_leg.loads_before[l], path_leg.loads_after[l], step.share));
  return step;
}

std::size_t n_steps_of(const std::vector<Leg> &legs)
{
  std::size_t n = 0;
  for (const Leg &leg : legs)
    n += leg.steps;
  return n;
}

/// The time (s) from one row of the program file to the next, the mean of all; 0 where it has no times.
double row_time(const std::vector<Leg> &rows)
{
  if (rows.size() < 2 || !rows.front().row->time)
    return 0;
  return (*rows.back().row->time - *rows.front().row->time) / static_cast<double>(rows.size() - 1);
}

/// Makes the steps of a load path.
class PathSteps
{
public:
  explicit PathSteps(const LoadOptions &load)
      : load_(load),
        row_time_(row_time(load.rows))
  {
  }

  void append(const PathLeg &path_leg)
  {
    const Leg &leg = *path_leg.leg;
    if (path_leg.begins_cycle)
    {
      phase_ = 0;
      phase_of_part_ =
          static_cast<unsigned int>(n_steps_of(path_leg.cycle == 0 ? load_.preload : load_.cycle_legs()));
    }
    for (unsigned int k = 1; k <= leg.steps; ++k)
    {
      const auto number = static_cast<unsigned int>(steps_.size()) + 1;
      steps_.push_back(step_of(path_leg, k, leg.steps, {number, path_leg.cycle, phase_++}));
      steps_.back().ends_cycle = path_leg.ends_cycle && k == leg.steps;
      set_time(steps_.back(), path_leg);
      append_parts(path_leg, k);
    }
  }

  /// The time (s) of all rows.
  double cycle_time() const { return row_time_ * static_cast<double>(load_.rows.size()); }

  std::vector<LoadStep> &steps() { return steps_; }

private:
  /// The parts of the step `k` of a leg.
  void append_parts(const PathLeg &path_leg, const unsigned int k)
  {
    const Leg &leg = *path_leg.leg;
    LoadStep &step = steps_.back();
    for (unsigned int part = 1; leg.parts > 1 && part <= leg.parts; ++part)
      step.parts.push_back(step_of(path_leg, (k - 1) * leg.parts + part, leg.steps * leg.parts,
                                   {step.number, step.cycle, phase_of_part_ + part - 1}));
    phase_of_part_ += leg.parts;
  }

  /// Time passes evenly from row to row, and to the first row as from one to the next. The preload takes
  /// none.
  void set_time(LoadStep &step, const PathLeg &path_leg)
  {
    const std::optional<SignalRow> &row = path_leg.leg->row;
    if (load_.rows.empty() || !load_.rows.front().row->time)
      return;
    if (!row)
    {
      step.time = *load_.rows.front().row->time - row_time_;
      return;
    }
    const bool is_first = path_leg.leg == &load_.rows.front();
    const double before = is_first ? *row->time - row_time_ : *(path_leg.leg - 1)->row->time;
    step.seconds = (*row->time - before) / path_leg.leg->steps;
    const unsigned int n_passed = path_leg.cycle - row->cycle;
    step.time = between(before, *row->time, step.share) + n_passed * cycle_time();
  }

  const LoadOptions &load_;
  const double row_time_; ///< s
  std::vector<LoadStep> steps_;
  unsigned int phase_ = 0;
  unsigned int phase_of_part_ = 0; // behind the phases of all steps: StartForces distinguishes both
};

/// Whether `test` holds for a target of a component.
template<typename Test>
bool any_target(const LoadOptions &load, const unsigned int component, const Test &test)
{
  for (const auto *const legs : {&load.preload, &load.cycle_legs()})
    for (const Leg &leg : *legs)
      if (leg.targets[component] && test(*leg.targets[component]))
        return true;
  return false;
}
} // namespace

LoadProgram::LoadProgram(LoadOptions load)
    : load_(std::move(load))
{
}

LoadSteps LoadProgram::steps() const
{
  PathSteps path(load_);
  for (const PathLeg &leg : load_path(load_))
    path.append(leg);
  return {std::move(path.steps()), n_steps_of_cycle(), n_steps(), path.cycle_time(), load_.loads};
}

std::size_t LoadProgram::n_steps() const
{
  return n_steps_of(load_.preload) + load_.cycles * n_steps_of_cycle();
}

std::size_t LoadProgram::n_steps_of_cycle() const
{
  return n_steps_of(load_.cycle_legs());
}

double LoadProgram::n_solved_parts() const
{
  double n = 0;
  for (const Leg &leg : load_.preload)
    n += static_cast<double>(leg.steps) * leg.parts;
  for (const Leg &leg : load_.cycle_legs())
    n += static_cast<double>(load_.cycles) * leg.steps * leg.parts;
  return n;
}

LoadProgram LoadProgram::first_cycle() const
{
  LoadOptions load = load_;
  load.cycles = std::min(1U, load.cycles);
  return LoadProgram(std::move(load));
}

double LoadProgram::largest_motion(const unsigned int direction) const
{
  double largest = 0;
  for (const auto *const legs : {&load_.preload, &load_.cycle_legs()})
    for (const Leg &leg : *legs)
      largest = std::max(largest, std::abs(leg.motion(direction).value_or(0)));
  return largest;
}

double LoadProgram::largest_motion() const
{
  return std::max({largest_motion(0), largest_motion(1), largest_motion(2)});
}

bool LoadProgram::drives(const unsigned int component) const
{
  return any_target(load_, component, [](const Drive &drive) { return drive.value != 0; });
}

bool LoadProgram::is_driven_by_force(const unsigned int component) const
{
  return any_target(load_, component, [](const Drive &drive) { return drive.by_force; });
}

bool LoadProgram::has_forces() const
{
  for (unsigned int component = 0; component < n_rigid_components; ++component)
    if (is_driven_by_force(component))
      return true;
  return false;
}

std::string LoadProgram::asymmetry(const ModelSymmetry &symmetry) const
{
  constexpr unsigned int first_rotation = 3;
  for (unsigned int component = 0; component < n_rigid_components; ++component)
    if (drives(component) && !symmetry.leaves(component))
      return std::string("the load program ") +
             (component < first_rotation ? "moves the held face along " : "turns the held face about ") +
             "xyz"[component % first_rotation];
  return {};
}
} // namespace orthocone
