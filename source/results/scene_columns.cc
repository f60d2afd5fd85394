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

namespace
{
/// The columns of a row's factor of friction; nan where no node is in contact. `extremes` and `mean` say
/// when.
template<typename Row>
void add_factor(Columns<Row> &columns, std::optional<FactorRange> (*const factor)(const Row &),
                const std::string &extremes, const std::string &mean)
{
  const std::string is_set = ", where Friction/Factor is set";
  const auto of = [factor](double FactorRange::*const part)
  {
    return [factor, part](const Row &row)
    {
      const std::optional<FactorRange> range = factor(row);
      return range ? std::optional<double>((*range).*part) : std::nullopt;
    };
  };
  columns.emplace_back("min_friction_factor", "",
                       "least factor of friction of a node in contact" + extremes + is_set,
                       of(&FactorRange::least));
  columns.emplace_back("mean_friction_factor", "",
                       "mean factor of friction over the area in contact" + mean + is_set,
                       of(&FactorRange::mean));
  columns.emplace_back("max_friction_factor", "",
                       "largest factor of friction of a node in contact" + extremes + is_set,
                       of(&FactorRange::largest));
}
} // namespace

Columns<SolvedStep> with_factor(Columns<SolvedStep> columns, const FrictionOptions &friction)
{
  if (friction.has_factor())
    add_factor<SolvedStep>(
        columns, [](const SolvedStep &s) { return s.totals.factor; }, "", "");
  return columns;
}

Columns<CycleRow> with_factor(Columns<CycleRow> columns, const FrictionOptions &friction)
{
  if (!friction.has_factor())
    return columns;
  add_factor<CycleRow>(
      columns,
      [](const CycleRow &c)
      {
        return c.mean_factor > 0 ? std::optional(FactorRange{c.least_factor, c.mean_factor, c.largest_factor})
                                 : std::nullopt;
      },
      " in the cycle", " at the largest total force of the cycle");
  columns.emplace_back(
      "friction_factor_error", "",
      "estimated error that jumps cause in the mean factor of friction of the nodes that slip, where "
      "Friction/Factor is set",
      [](const CycleRow &c) { return c.factor_error; });
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
