// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/text.h>
#include <orthocone/body/shapes/shape_kind.h>
#include <orthocone/entries/names.h>
#include <orthocone/output/scene_description.h>

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
  constexpr unsigned int first_rotation = 3;
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
    range->unit = i < first_rotation ? (by_force ? "N" : "mm") : (by_force ? "N mm" : "degrees");
    range->number = i;
    ranges.push_back(*range);
  }
}

/// What the name of the surface says is held, and how.
std::string held_text(const GeometryOptions &geometry)
{
  const std::vector<std::string> names = kind_of(geometry).surfaces(geometry);
  const std::string name = geometry.is_from_file() ? shown(geometry.held_surface)
                           : names.empty()         ? std::string("top")
                                                   : names[1];
  if (name.empty() || geometry.top_face == TopFace::free)
    return "none: supports, loads and contact hold the body";
  if (geometry.top_face == TopFace::guided)
    return name + ", guided: " + (geometry.is_lower ? "held" : "moved") + " along z, free sideways";
  return name + ", clamped: " + (geometry.is_lower ? "does not move" : "moves as a rigid plate");
}

std::string supports_line(const GeometryOptions &geometry, const std::string &heading)
{
  std::string text;
  for (const Support &support : geometry.supports)
  {
    text += (text.empty() ? "" : " ; ") + shown(support.surface) + ":";
    for (unsigned int d = 0; d < 3; ++d)
      text += support.directions[d] ? std::string(" ") + "xyz"[d] : "";
  }
  return text.empty() ? "" : heading + text + "\n";
}
} // namespace

std::string material_text(const MaterialOptions &material)
{
  std::string text = material.is_isotropic() ? "E " + to_text(material.young_modulus) + " MPa, nu " +
                                                   to_text(material.poisson_ratio)
                                             : material.law.word();
  if (!material.regions.empty())
    text += "; regions " + material.regions_text();
  if (material.thermal_expansion != 0)
    text += "; thermal expansion " + to_text(material.thermal_expansion) + " 1/K";
  return text;
}

std::string LoadRange::text() const
{
  const bool has_both_signs = least < 0 && largest > 0;
  return (has_both_signs ? to_text(least) + " to " + to_text(largest)
                         : to_text(-least > largest ? least : largest)) +
         " " + unit;
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

std::string describe_materials(const Parameters &parameters)
{
  std::string text = "material       " + material_text(parameters.material) + "\n";
  if (parameters.obstacle.kind.chosen().is_body())
    text += "lower material " + material_text(parameters.lower.material) + "\n";
  return text;
}

std::string describe_held(const Parameters &parameters)
{
  std::string text = "held face      " + held_text(parameters.geometry) + "\n" +
                     supports_line(parameters.geometry, "supports       ");
  if (parameters.obstacle.kind.chosen().is_body())
    text += "lower held     " + held_text(parameters.lower.geometry) + "\n" +
            supports_line(parameters.lower.geometry, "lower supports ");
  return text;
}

std::string describe_drive(const LoadOptions &load)
{
  std::string face, loads;
  for (const LoadRange &range : load_ranges(load))
    if (range.number < n_rigid_components)
      face += (face.empty() ? "driven by      " : ", ") + range.name + " " + range.text();
    else
      loads += (loads.empty() ? "loads          " : "               ") +
               load.loads[range.number - n_rigid_components].text() + ", " + range.text() + "\n";
  return (face.empty() ? "" : face + "\n") + loads;
}
} // namespace orthocone
