// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/load_path.h>

#include <orthocone/base/text.h>

namespace orthocone
{
namespace
{
std::string place_of(const Leg &leg, const std::vector<Leg> &legs)
{
  return leg.row ? "line " + std::to_string(leg.row->line) : "leg " + std::to_string(&leg - legs.data() + 1);
}

/// Sets which cycle the leg belongs to, when its legs are passed through for the `pass`-th time.
void set_cycle(PathLeg &path_leg, const std::vector<Leg> &legs, const unsigned int pass)
{
  const Leg &leg = *path_leg.leg;
  const bool is_first = &leg == &legs.front(), is_last = &leg == &legs.back();
  if (leg.row)
  {
    path_leg.cycle = pass + leg.row->cycle - 1;
    path_leg.begins_cycle = is_first || leg.row->cycle != (&leg)[-1].row->cycle;
    path_leg.ends_cycle = leg.row->ends_cycle;
    return;
  }
  path_leg.cycle = pass;
  path_leg.begins_cycle = is_first;
  path_leg.ends_cycle = is_last && pass > 0;
}
} // namespace

std::vector<PathLeg> load_path(const LoadOptions &load)
{
  std::vector<PathLeg> path;
  Drives reached{};
  std::vector<double> loads(load.loads.size(), 0);
  const auto pass_through =
      [&](const std::vector<Leg> &legs, const std::string &entry, const unsigned int pass)
  {
    for (const Leg &leg : legs)
    {
      path.push_back({&leg, "Load program/" + entry, place_of(leg, legs), 0, false, false, reached, {}});
      set_cycle(path.back(), legs, pass);
      for (unsigned int i = 0; i < n_rigid_components; ++i)
        reached[i] = leg.targets[i].value_or(reached[i]);
      path.back().after = reached;
      path.back().loads_before = loads;
      for (std::size_t k = 0; k < loads.size(); ++k)
        loads[k] = leg.load(load.loads[k].name).value_or(loads[k]);
      path.back().loads_after = loads;
    }
  };
  pass_through(load.preload, "Preload", 0);
  for (unsigned int pass = 1; pass <= std::min(load.cycles, 2u); ++pass)
    pass_through(load.cycle_legs(),
                 load.program_file.empty() ? "Legs" : "Program file = " + shown_path(load.program_file),
                 pass);
  return path;
}
} // namespace orthocone
