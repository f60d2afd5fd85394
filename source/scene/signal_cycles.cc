// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Cycles of a measured signal v_0, v_1, ..., which is noisy, need not begin in the middle of its range, and
// has as many rows a cycle as the machine wrote. Let R = max v - min v, and let s be the value from which the
// program sets out. A cycle goes from s to both extremes, the upper quarter v >= max v - R/4 and the lower
// quarter v <= min v + R/4, and back to s. So between the second extreme of a cycle and the first extreme of
// the next one, it ends at the row that is nearest to s, at the last one of equally near rows, which a pause
// belongs to. Quarters are wider than noise, and both have to be visited, so that noise at one of them makes
// no cycle. The last cycle is complete if it comes back to s within R/8. This is the counting of full ranges
// about a reference (ASTM E1049, level crossings restricted to those between opposite extremes).
#include "signal_cycles.h"

#include <algorithm>
#include <cmath>

namespace orthocone
{
namespace
{
/// Values of a component in the rows, and where it sets out.
struct Signal
{
  std::vector<double> values;
  double start = 0;

  double least() const { return *std::min_element(values.begin(), values.end()); }
  double largest() const { return *std::max_element(values.begin(), values.end()); }
  double range() const { return largest() - least(); }
};

/// Where the component sets out: where the preload left it, if it was driven in the same way.
double start_of(const std::size_t component, const Drive &first_row, const std::vector<Leg> &preload)
{
  Drive start{first_row.by_force, 0};
  for (const Leg &leg : preload)
    start = leg.targets[component].value_or(start);
  return start.by_force == first_row.by_force ? start.value : first_row.value;
}

/// Where a load sets out: where the preload left it.
double start_of(const std::string &load, const std::vector<Leg> &preload)
{
  double start = 0;
  for (const Leg &leg : preload)
    start = leg.load(load).value_or(start);
  return start;
}

/// The first load that changes in the file.
Signal signal_of_loads(const std::vector<Leg> &rows, const std::vector<Leg> &preload)
{
  for (const auto &[name, first] : rows.front().loads)
  {
    Signal signal{{}, start_of(name, preload)};
    for (const Leg &row : rows)
      signal.values.push_back(row.load(name).value_or(first));
    if (signal.range() > 0)
      return signal;
  }
  return {};
}

/// The first component that changes in the file: tangential ones and the twist come first, and loads last.
Signal signal_of(const std::vector<Leg> &rows, const std::vector<Leg> &preload)
{
  constexpr std::array<std::size_t, n_rigid_components> by_importance{{0, 1, 5, 2, 3, 4}};
  for (const std::size_t component : by_importance)
  {
    if (!rows.front().targets[component])
      continue;
    Signal signal;
    signal.start = start_of(component, *rows.front().targets[component], preload);
    for (const Leg &row : rows)
      signal.values.push_back(row.targets[component]->value);
    if (signal.range() > 0)
      return signal;
  }
  return signal_of_loads(rows, preload);
}

/// Finds the rows at which cycles end.
class CycleSearch
{
public:
  explicit CycleSearch(const Signal &signal)
      : signal_(signal),
        low_(signal.least() + signal.range() / 4),
        high_(signal.largest() - signal.range() / 4)
  {
  }

  /// The numbers of the rows behind the last ones of the cycles, and in front the first row of the first
  /// cycle.
  std::vector<std::size_t> ends()
  {
    for (std::size_t row = 0; row < signal_.values.size(); ++row)
      pass(row);
    if (stage_ == Stage::returns && distance(nearest_) <= signal_.range() / 8)
      ends_.push_back(nearest_ + 1);
    return ends_;
  }

private:
  enum class Stage
  {
    begins,  ///< no extreme yet
    went,    ///< to the first extreme
    returns, ///< from the second one
  };

  double distance(const std::size_t row) const { return std::abs(signal_.values[row] - signal_.start); }

  /// 1 in the upper quarter, -1 in the lower one.
  int extreme(const std::size_t row) const
  {
    return signal_.values[row] >= high_ ? 1 : signal_.values[row] <= low_ ? -1 : 0;
  }

  /// Whether the cycle goes to this extreme first: not to one where it sets out.
  bool is_first(const int side) const
  {
    const int start_side = signal_.start >= high_ ? 1 : signal_.start <= low_ ? -1 : 0;
    return side != 0 && (first_ != 0 ? side == first_ : side != start_side);
  }

  void pass(const std::size_t row)
  {
    const int side = extreme(row);
    if (stage_ == Stage::begins && is_first(side))
    {
      first_ = side;
      ends_.push_back(row_behind_start(row));
      stage_ = Stage::went;
    }
    else if (stage_ == Stage::went && side == -first_)
    {
      nearest_ = row;
      stage_ = Stage::returns;
    }
    else if (stage_ == Stage::returns && is_first(side))
    {
      ends_.push_back(nearest_ + 1);
      stage_ = Stage::went;
    }
    else if (stage_ == Stage::returns && distance(row) <= distance(nearest_))
      nearest_ = row;
  }

  /// The row behind the last one that is as near to the start as the start itself, before the first extreme.
  std::size_t row_behind_start(const std::size_t extreme_row) const
  {
    std::size_t behind = 0;
    for (std::size_t row = 0; row < extreme_row; ++row)
      if (distance(row) <= signal_.range() / 1000)
        behind = row + 1;
    return behind;
  }

  const Signal &signal_;
  const double low_, high_;
  Stage stage_ = Stage::begins;
  int first_ = 0; ///< the side of the extreme that cycles visit first
  std::size_t nearest_ = 0;
  std::vector<std::size_t> ends_;
};
} // namespace

void find_cycles(std::vector<Leg> &rows, const std::vector<Leg> &preload)
{
  const Signal signal = signal_of(rows, preload);
  std::vector<std::size_t> ends;
  if (!signal.values.empty())
    ends = CycleSearch(signal).ends();
  if (ends.size() < 2)
    ends = {0, rows.size()};
  unsigned int cycle = 0;
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    if (cycle < ends.size() && row == ends[cycle])
      ++cycle;
    rows[row].row->cycle = cycle;
    rows[row].row->ends_cycle = cycle > 0 && cycle < ends.size() && row + 1 == ends[cycle];
  }
}
} // namespace orthocone
