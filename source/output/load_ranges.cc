// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/output/load_ranges.h>

#include <orthocone/base/text.h>
#include <orthocone/scene/legs.h>

#include <algorithm>
#include <cmath>

namespace orthocone
{
namespace
{
/// The range of the targets that `target_of` finds in the legs; nothing where no leg has one.
template<typename TargetOf>
std::optional<LoadRange> range_of(const LoadOptions &load, const TargetOf &target_of)
{
  std::optional<LoadRange> range;
  for (const auto *const legs : {&load.preload, &load.cycle_legs()})
    for (const Leg &leg : *legs)
      if (const std::optional<double> target = target_of(leg))
      {
        if (!range)
          range.emplace();
        range->least = std::min(range->least, *target);
        range->largest = std::max(range->largest, *target);
      }
  return range;
}

/// The ranges of the components that motions drive, or forces.
void add_components(const LoadOptions &load, const bool by_force, std::vector<LoadRange> &ranges)
{
  for (unsigned int i = 0; i < n_rigid_components; ++i)
  {
    auto range = range_of(load,
                          [&](const Leg &leg)
                          {
                            const auto &target = leg.targets[i];
                            return target && target->by_force == by_force ? std::optional(target->value)
                                                                          : std::nullopt;
                          });
    if (!range || (!by_force && range->least == range->largest))
      continue;
    range->name = by_force ? wrench_names[i] : motion_names[i];
    range->unit = unit_of(range->name, load.loads);
    range->number = i;
    ranges.push_back(*range);
  }
}

} // namespace

std::string LoadRange::text() const
{
  const bool has_both_signs = least < 0 && largest > 0;
  return (has_both_signs ? to_text(least) + " to " + to_text(largest)
                         : to_text(-least > largest ? least : largest)) +
         (unit.empty() ? "" : " " + unit);
}

std::vector<LoadRange> load_ranges(const LoadOptions &load)
{
  std::vector<LoadRange> ranges;
  add_components(load, false, ranges);
  add_components(load, true, ranges);
  for (const Load &declared : load.loads)
  {
    LoadRange range =
        range_of(load, [&](const Leg &leg) { return leg.load(declared.name); }).value_or(LoadRange());
    range.name = declared.name;
    range.unit = declared.kind->unit();
    range.number = n_rigid_components + static_cast<unsigned int>(&declared - load.loads.data());
    ranges.push_back(std::move(range));
  }
  return ranges;
}

} // namespace orthocone
