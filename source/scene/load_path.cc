// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/load_path.h>

namespace orthocone
{
std::vector<PathLeg> load_path(const LoadOptions &load)
{
  std::vector<PathLeg> path;
  Drives reached{};
  const auto pass = [&](const std::vector<Leg> &legs, const char *const entry, const unsigned int cycle)
  {
    for (const Leg &leg : legs)
    {
      const auto number = static_cast<unsigned int>(&leg - legs.data()) + 1;
      path.push_back({&leg, std::string("Load program/") + entry, number, cycle, reached, {}});
      for (unsigned int i = 0; i < n_rigid_components; ++i)
        reached[i] = leg.targets[i].value_or(reached[i]);
      path.back().after = reached;
    }
  };
  pass(load.preload, "Preload", 0);
  for (unsigned int cycle = 1; cycle <= std::min(load.cycles, 2u); ++cycle)
    pass(load.legs, "Legs", cycle);
  return path;
}
} // namespace orthocone
