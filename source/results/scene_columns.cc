// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Columns of history.csv that a scene with loads, or with several contact surfaces, has behind the others.
#include <orthocone/results/tables.h>
#include <orthocone/scene/options.h>

#include <algorithm>
#include <array>

namespace orthocone
{
Columns<SolvedStep> with_surfaces(Columns<SolvedStep> columns, const std::vector<std::string> &surfaces)
{
  struct Sum
  {
    const char *name, *unit, *how;
    double (*of)(const SurfaceTotals &);
  };
  using S = SurfaceTotals;
  static const std::array<Sum, 8> sums{
      {{"force_x", "N", "force of the counterface on this contact surface along x",
        [](const S &s) { return s.force[0]; }},
       {"force_y", "N", "the same along y", [](const S &s) { return s.force[1]; }},
       {"force_z", "N", "the same along z", [](const S &s) { return s.force[2]; }},
       {"normal_force", "N", "sum of the normal forces of its nodes",
        [](const S &s) { return s.normal_force; }},
       {"contact_area", "mm^2", "area of its nodes in contact", [](const S &s) { return s.contact_area; }},
       {"max_pressure", "MPa", "largest pressure on it", [](const S &s) { return s.max_pressure; }},
       {"max_slip", "mm", "largest slip of its nodes in contact", [](const S &s) { return s.max_slip; }},
       {"total_dissipation", "N mm", "energy that friction has dissipated on it since the start",
        [](const S &s) { return s.total_dissipation; }}}};
  if (surfaces.size() < 2)
    return columns;
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    std::string name = surfaces[i];
    std::replace(name.begin(), name.end(), ' ', '-');
    for (const Sum &sum : sums)
      columns.emplace_back(name + "_" + sum.name, sum.unit, sum.how,
                           [i, of = sum.of](const SolvedStep &s) { return of(s.totals.surfaces[i]) + 0.; });
  }
  return columns;
}

Columns<SolvedStep> with_loads(Columns<SolvedStep> columns, const std::vector<Load> &loads)
{
  for (std::size_t i = 0; i < loads.size(); ++i)
  {
    const auto k = static_cast<Eigen::Index>(i);
    const Conjugate conjugate = loads[i].kind->conjugate();
    columns.emplace_back(loads[i].name, loads[i].kind->unit(), loads[i].text(),
                         [k](const SolvedStep &s) { return s.totals.loads[k] + 0.; });
    const bool is_mean = loads[i].kind->acts_by_traction();
    columns.emplace_back(loads[i].name + "_" + conjugate.suffix, conjugate.unit, conjugate.how,
                         [k, is_mean](const SolvedStep &s)
                         { return s.totals.conjugates[k] / (is_mean ? s.totals.load_areas[k] : 1) + 0.; });
  }
  return columns;
}
} // namespace orthocone
