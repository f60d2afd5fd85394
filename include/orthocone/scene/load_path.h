// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/scene/options.h>

namespace orthocone
{
/// What drives the components of the held face, in users' units.
using Drives = std::array<Drive, n_rigid_components>;

/// A leg of a load program with what drives the held face before and behind it.
struct PathLeg
{
  const Leg *leg;
  std::string entry;  ///< "Load program/Preload", "Load program/Legs", or the program file
  std::string place;  ///< in the entry: "leg 2" or "line 3"
  unsigned int cycle; ///< 0 in the preload
  bool begins_cycle;  ///< or the preload
  bool ends_cycle;    ///< not the preload
  Drives before, after;
  std::vector<double> loads_before{}, loads_after{}; ///< of LoadOptions::loads

  /// Where a component is behind the leg, mm or degrees; 0 where a force drives it, because it is unknown.
  double motion(const unsigned int component) const
  {
    return after[component].by_force ? 0 : after[component].value;
  }
};

/// The way of the held face through the load program, leg by leg: the preload, and the legs twice, if they
/// are repeated. The first time they start from the end of the preload, and then from their own end, so that
/// they are passed through later as the second time. `load` must outlive the result.
std::vector<PathLeg> load_path(const LoadOptions &load);
} // namespace orthocone
