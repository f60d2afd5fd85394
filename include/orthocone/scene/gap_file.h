// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <string>
#include <vector>

namespace orthocone
{
/// Gaps on a regular grid: node (i, j) is at first + spacing * (i, j), mm.
struct GapGrid
{
  double first_x, spacing_x, first_y, spacing_y; ///< mm; the spacings are > 0
  std::size_t n_x, n_y;                          ///< at least 2
  std::vector<double> gap;                       ///< n_x n_y, mm, finite; x runs fastest

  /// Whether a place (mm) is on the grid, up to rounding.
  bool contains(double x, double y) const;

  /// The gap (mm) at a place (mm), bilinear between the nodes; beyond the grid it is the gap at the nearest
  /// place of the grid.
  double value(double x, double y) const;
};

/// Reads a text file: the line "x0 dx nx y0 dy ny", then ny lines of nx numbers, mm; '#' begins a comment.
/// Throws FileError if it cannot be read, and InputError with file and line for everything else, also for
/// missing values.
GapGrid read_gap_file(const std::string &file_name);
} // namespace orthocone
