// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <vector>

namespace orthocone
{
/// Which of some sectors around the origin has a direction, without angles of its own: directions are ordered
/// by the place where they leave the square |x| + |y| = 1, counted from -x to the left.
class DirectionSearch
{
public:
  DirectionSearch() = default;

  /// `angles` (radians) at which the sectors begin ascend within less than one turn.
  explicit DirectionSearch(const std::vector<double> &angles)
  {
    for (const double angle : angles)
      places_.push_back(place({std::cos(angle), std::sin(angle)}));
    const auto least = std::min_element(places_.begin(), places_.end());
    first_ = static_cast<std::size_t>(least - places_.begin());
    std::rotate(places_.begin(), least, places_.end());
  }

  std::size_t sector_of(const Eigen::Vector2d &direction) const
  {
    const auto above = std::upper_bound(places_.begin(), places_.end(), place(direction));
    // What lies before the first beginning lies in the last sector.
    const auto behind = static_cast<std::size_t>(above - places_.begin()) + places_.size() - 1;
    return (first_ + behind) % places_.size();
  }

private:
  /// From -2 to 2.
  static double place(const Eigen::Vector2d &v)
  {
    const double y = v[1] / (std::abs(v[0]) + std::abs(v[1]));
    if (v[0] >= 0)
      return y;
    return v[1] >= 0 ? 2 - y : -2 - y;
  }

  std::vector<double> places_;
  std::size_t first_ = 0; ///< the sector that begins at the first place
};
} // namespace orthocone
