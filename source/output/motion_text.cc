// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/output/motion_text.h>

#include <orthocone/base/numbers.h>
#include <orthocone/base/text.h>
#include <orthocone/scene/legs.h>

#include <algorithm>
#include <sstream>

namespace orthocone
{
namespace
{
constexpr unsigned int along_z = 2;
constexpr unsigned int first_rotation = 3;

/// Forces on the way are computed: their last digits mean nothing.
std::string rounded(const double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

/// Name and value of a component, as users write them.
std::string text_of(const LoadStep &step, const unsigned int component, const std::string &between)
{
  const std::string name = (step.by_force[component] ? wrench_names : motion_names)[component];
  const double motion = step.motion[component] / (component >= first_rotation ? radians_per_degree : 1);
  return name + between + (step.by_force[component] ? rounded(step.force[component]) : to_text(motion)) +
         " " + unit_of(name, {});
}

bool is_driven(const LoadStep &step, const unsigned int component)
{
  return step.motion[component] != 0 || step.force[component] != 0;
}
} // namespace

MotionText::MotionText(const std::vector<LoadStep> &steps, std::vector<Load> loads)
    : loads_(std::move(loads))
{
  for (unsigned int component = 0; component < n_rigid_components; ++component)
    if (std::any_of(steps.begin(), steps.end(),
                    [&](const LoadStep &step) { return is_driven(step, component); }))
      moving_.push_back(component);
}

std::string MotionText::operator()(const LoadStep &step, const std::string &between) const
{
  std::string text = moving_.empty() && !loads_.empty() ? "" : text_of_face(step, between);
  for (std::size_t k = 0; k < loads_.size(); ++k)
  {
    const std::string unit = loads_[k].kind->unit();
    text += (text.empty() ? "" : ", ") + loads_[k].name + between + rounded(step.loads[k]) +
            (unit.empty() ? "" : " " + unit);
  }
  return text;
}

std::string MotionText::text_of_face(const LoadStep &step, const std::string &between) const
{
  if ((moving_.empty() || (moving_.size() == 1 && moving_.front() == along_z)) && !step.by_force[along_z])
    return "u_z" + between + to_text(step.motion[along_z]) + " mm";
  std::string text;
  for (const unsigned int component : moving_)
    text += (text.empty() ? "" : ", ") + text_of(step, component, between);
  return text;
}
} // namespace orthocone
