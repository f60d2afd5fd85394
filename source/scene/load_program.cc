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
LoadStep step_of(const Leg &leg, const Drives &reached, const unsigned int k, const unsigned int n,
                 const Place &place)
{
  LoadStep step{{}, place.number, k, place.cycle, place.phase};
  step.share = static_cast<double>(k) / n;
  for (unsigned int i = 0; i < n_rigid_components; ++i)
    set_component(step, i, reached[i], leg);
  return step;
}

/// The steps of the legs of one cycle, or of the preload.
class CycleSteps
{
public:
  CycleSteps(const std::vector<Leg> &legs, std::vector<LoadStep> &steps)
      : steps_(steps)
  {
    for (const Leg &leg : legs)
      phase_of_part_ += leg.steps;
  }

  void append(const PathLeg &path_leg)
  {
    const Leg &leg = *path_leg.leg;
    for (unsigned int k = 1; k <= leg.steps; ++k)
    {
      const auto number = static_cast<unsigned int>(steps_.size()) + 1;
      steps_.push_back(step_of(leg, path_leg.before, k, leg.steps, {number, path_leg.cycle, phase_++}));
      for (unsigned int part = 1; leg.parts > 1 && part <= leg.parts; ++part)
        steps_.back().parts.push_back(step_of(leg, path_leg.before, (k - 1) * leg.parts + part,
                                              leg.steps * leg.parts,
                                              {number, path_leg.cycle, phase_of_part_ + part - 1}));
      phase_of_part_ += leg.parts;
    }
  }

private:
  std::vector<LoadStep> &steps_;
  unsigned int phase_ = 0;
  unsigned int phase_of_part_ = 0; // behind the phases of all steps: StartForces distinguishes both
};

/// Whether `test` holds for a target of a component.
template<typename Test>
bool any_target(const LoadOptions &load, const unsigned int component, const Test &test)
{
  for (const auto *const legs : {&load.preload, &load.legs})
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
  std::vector<LoadStep> steps;
  std::size_t n_preload = 0;
  std::optional<CycleSteps> cycle;
  for (const PathLeg &leg : load_path(load_))
  {
    if (leg.number == 1)
      cycle.emplace(leg.cycle == 0 ? load_.preload : load_.legs, steps);
    cycle->append(leg);
    n_preload = leg.cycle == 0 ? steps.size() : n_preload;
  }
  const std::size_t n_cycle = (n_steps() - n_preload) / std::max(1U, load_.cycles);
  return {std::move(steps), n_cycle, n_steps()};
}

std::size_t LoadProgram::n_steps() const
{
  std::size_t n = 0;
  for (const Leg &leg : load_.preload)
    n += leg.steps;
  for (const Leg &leg : load_.legs)
    n += std::size_t(load_.cycles) * leg.steps;
  return n;
}

double LoadProgram::n_solved_parts() const
{
  double n = 0;
  for (const Leg &leg : load_.preload)
    n += static_cast<double>(leg.steps) * leg.parts;
  for (const Leg &leg : load_.legs)
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
  for (const auto *const legs : {&load_.preload, &load_.legs})
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
             (component < first_rotation ? "moves the top along " : "turns the top about ") +
             "xyz"[component % first_rotation];
  return {};
}
} // namespace orthocone
