// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/output/zone_record.h>

#include <orthocone/base/text.h>
#include <orthocone/body/shapes/shape_kind.h>
#include <orthocone/scene/parameters.h>

#include <algorithm>
#include <cmath>

namespace orthocone
{
namespace
{
constexpr double least_spacings = 4; // docs/accuracy.md, "Zones that the mesh does not resolve"

bool is_narrow(const double width)
{
  return width > 0 && width < least_spacings;
}

std::string in_spacings(const double width)
{
  const double rounded = std::round(width);
  return rounded <= 1 ? "one node spacing" : to_text(rounded) + " node spacings";
}
} // namespace

void ZoneRecord::add_step(const unsigned int step, const double normal_force, const ZoneWidths &widths)
{
  constexpr double nearly_largest = 0.9;
  contact = std::max(contact, widths.contact);
  load = std::max(load, widths.load);
  rim_touches = rim_touches || widths.rim_touches;
  largest_force = std::max(largest_force, normal_force);
  if (normal_force < nearly_largest * largest_force)
    return; // an opening contact
  if (widths.stick >= least_spacings)
  {
    if (narrow.second != 0 && (grown.second == 0 || narrow.first < grown.first))
      grown = narrow;
    narrow = {};
    is_stick_resolved = true;
  }
  else if (widths.stick == 0 || widths.contact < least_spacings)
  {
    narrow = {};
    is_stick_resolved = false;
  }
  else if (is_stick_resolved && (narrow.second == 0 || widths.stick < narrow.first))
    narrow = {widths.stick, step};
}

std::vector<std::string> zone_warnings(const Parameters &parameters, const ZoneRecord &record)
{
  std::vector<std::string> warnings;
  const auto warn = [&](const std::string &what, const double width, const std::string &wrong)
  {
    warnings.push_back(
        what + " is " + in_spacings(width) + " wide where it is widest, but needs at least four; " + wrong +
        " may be wrong by tens of percent: take " + kind_of(parameters.geometry).finer_cells(parameters));
  };
  if (is_narrow(record.contact))
    warn("Mesh: in all load steps the contact", record.contact, "pressure, slip and dissipation");
  else if (is_narrow(record.load))
    warn("Mesh: in all load steps the part of the contact that carries the load", record.load,
         "pressure, slip and dissipation");
  const auto &stick = record.grown.second != 0 ? record.grown : record.narrow;
  if (stick.second != 0)
    warn("load step " + std::to_string(stick.second) + ": the stick zone", stick.first,
         "its size, and slip and dissipation around it,");
  if (const std::string rim = coarse_rim_warning(parameters);
      record.rim_touches && !rim.empty() && !rim_surely_touches(parameters))
    warnings.push_back(rim);
  return warnings;
}
} // namespace orthocone
