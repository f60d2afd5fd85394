// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/scene/options.h>

#include <string>
#include <vector>

namespace orthocone
{
/// The values that the legs give to a component of the held face, or to a load.
struct LoadRange
{
  std::string name; ///< "uz", "Fz", or that of the load
  std::string unit;
  unsigned int number; ///< of the component, 0 to 5, or 6 + k for load k
  double least = 0, largest = 0;

  /// "-350 to 350 N", or the one value that is farthest from zero.
  std::string text() const;
};

/// The ranges of what the legs drive: motions, then forces, then loads. Motions that stay zero are left out,
/// whereas a force of zero says that the face is free to move.
std::vector<LoadRange> load_ranges(const LoadOptions &load);
} // namespace orthocone
