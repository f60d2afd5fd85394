// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "direction_search.h"
#include "rosette_sector.h"

#include <orthocone/contact/law/rosette.h>

#include <vector>

namespace orthocone
{
/// The sectors of a table, which meet in its rows, and which of them has a direction e(a) or e(b).
struct RosetteTable
{
  const RosetteSector &with_slip(const Eigen::Vector2d &direction) const
  {
    return sectors[of_slip.sector_of(direction)];
  }
  const RosetteSector &with_force(const Eigen::Vector2d &direction) const
  {
    return sectors[of_force.sector_of(direction)];
  }

  std::vector<double> slip_angles; ///< of the rows, ascending; sector i begins at row i
  std::vector<RosetteSector> sectors;
  DirectionSearch of_slip, of_force;
};

/// Joins rows so that the derivative of the force is continuous (docs/theory.md, section 1, "The circle").
/// Throws std::invalid_argument where Rosette does.
RosetteTable make_rosette_table(std::vector<Rosette::Row> rows);
} // namespace orthocone
