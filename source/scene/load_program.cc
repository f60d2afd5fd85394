// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/load_program.h>

#include <orthocone/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

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
  return !drive.by_force && component >= first_rotation ? pi / 180 : 1;
}

using Drives = std::array<Drive, n_rigid_components>;

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
LoadStep step_of(const Leg &leg, const Drives &drives, const unsigned int k, const unsigned int n,
                 const Place &place)
{
  LoadStep step{{}, place.number, k, place.cycle, place.phase};
  step.share = static_cast<double>(k) / n;
  for (unsigned int i = 0; i < n_rigid_components; ++i)
    set_component(step, i, drives[i], leg);
  return step;
}

/// Appends the steps of `legs`. The first leg starts from `drives`, which become the end of the last leg.
void append(const std::vector<Leg> &legs, const unsigned int cycle, Drives &drives,
            std::vector<LoadStep> &steps)
{
  unsigned int phase = 0;
  unsigned int phase_of_part = 0; // behind the phases of all steps: StartForces distinguishes both
  for (const Leg &leg : legs)
    phase_of_part += leg.steps;
  for (const Leg &leg : legs)
  {
    for (unsigned int k = 1; k <= leg.steps; ++k)
    {
      const auto number = static_cast<unsigned int>(steps.size()) + 1;
      steps.push_back(step_of(leg, drives, k, leg.steps, {number, cycle, phase++}));
      for (unsigned int part = 1; leg.parts > 1 && part <= leg.parts; ++part)
        steps.back().parts.push_back(step_of(leg, drives, (k - 1) * leg.parts + part, leg.steps * leg.parts,
                                             {number, cycle, phase_of_part + part - 1}));
      phase_of_part += leg.parts;
    }
    for (unsigned int i = 0; i < n_rigid_components; ++i)
      drives[i] = leg.targets[i].value_or(drives[i]);
  }
}

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

bool FaceTarget::has_forces() const
{
  return std::find(by_force.begin(), by_force.end(), true) != by_force.end();
}

bool FaceTarget::is_release() const
{
  constexpr unsigned int normal = 2;
  return by_force[normal] && force.components.isZero(0);
}

FaceTarget LoadStep::target(const FaceState &begin) const
{
  FaceTarget target{by_force, motion, force};
  for (unsigned int i = 0; i < n_rigid_components; ++i)
    if (from_present[i] && by_force[i])
      target.force[i] = begin.wrench[i] + share * (force[i] - begin.wrench[i]);
    else if (from_present[i])
      target.motion[i] = begin.motion[i] + share * (motion[i] - begin.motion[i]);
  return target;
}

LoadStep LoadStep::resolved(const FaceState &begin) const
{
  LoadStep step = *this;
  const FaceTarget end = target(begin);
  step.motion = end.motion;
  step.force = end.force;
  return step;
}

std::string LoadStep::driven(const ModelSymmetry &symmetry, const TopFace top_face) const
{
  constexpr unsigned int first_rotation = 3, normal = 2;
  const bool turns =
      std::any_of(motion.components.data() + first_rotation, motion.components.data() + n_rigid_components,
                  [](const double rotation) { return rotation != 0; });
  std::string names;
  for (unsigned int i = 0; i < n_rigid_components; ++i)
  {
    const bool is_named = i < first_rotation || turns || by_force[i];
    if (is_named && (i == normal || top_face == TopFace::clamped) &&
        (i < first_rotation || symmetry.leaves(i)))
      names += std::string(names.empty() ? "" : " ") + (by_force[i] ? wrench_names[i] : motion_names[i]);
  }
  return names;
}

std::vector<LoadStep> load_steps(const LoadOptions &load)
{
  Drives drives{};
  std::vector<LoadStep> steps;
  append(load.preload, 0, drives, steps);
  for (unsigned int cycle = 1; cycle <= load.cycles; ++cycle)
    append(load.legs, cycle, drives, steps);
  return steps;
}

double n_solved_parts(const LoadOptions &load)
{
  double n = 0;
  for (const Leg &leg : load.preload)
    n += static_cast<double>(leg.steps) * leg.parts;
  for (const Leg &leg : load.legs)
    n += static_cast<double>(load.cycles) * leg.steps * leg.parts;
  return n;
}

double largest_motion(const LoadOptions &load, const unsigned int direction)
{
  double largest = 0;
  for (const auto *const legs : {&load.preload, &load.legs})
    for (const Leg &leg : *legs)
      largest = std::max(largest, std::abs(leg.motion(direction).value_or(0)));
  return largest;
}

double largest_motion(const LoadOptions &load)
{
  return std::max({largest_motion(load, 0), largest_motion(load, 1), largest_motion(load, 2)});
}

bool drives(const LoadOptions &load, const unsigned int component)
{
  return any_target(load, component, [](const Drive &drive) { return drive.value != 0; });
}

bool is_driven_by_force(const LoadOptions &load, const unsigned int component)
{
  return any_target(load, component, [](const Drive &drive) { return drive.by_force; });
}
} // namespace orthocone
