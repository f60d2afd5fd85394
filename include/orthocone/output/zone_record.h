// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/results/contact_zones.h>
#include <orthocone/scene/options.h>

#include <string>
#include <utility>
#include <vector>

namespace orthocone
{
/// How well the mesh resolves contact, stick and load over the steps of a run. A contact that opens and a
/// stick zone that vanishes pass through all widths. So the contact counts where it is widest, and a stick
/// zone where it has been resolved, is narrow while the load is at its largest, and does not vanish then.
struct ZoneRecord
{
  /// Adds a step with a normal force of the counterface on the body (N).
  void add_step(unsigned int step, double normal_force, const ZoneWidths &widths);

  double contact = 0; ///< widest contact, node spacings
  double load = 0;    ///< widest part that carries the load, node spacings
  bool rim_touches = false;
  double largest_force = 0;                 ///< N
  bool is_stick_resolved = false;           ///< whether a resolved stick zone has not vanished since
  std::pair<double, unsigned int> narrow{}; ///< width and step of the narrow stick zone that is there now
  std::pair<double, unsigned int> grown{};  ///< of the narrowest one that has grown again
};

/// Warnings of zones that the mesh does not resolve, which name the entries that do.
std::vector<std::string> zone_warnings(const Parameters &parameters, const ZoneRecord &record);
} // namespace orthocone
