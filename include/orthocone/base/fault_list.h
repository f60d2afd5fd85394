// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <string>
#include <vector>

namespace orthocone
{
/// Faults of one thing, which are told together.
class FaultList
{
public:
  static constexpr std::size_t most_told = 4; ///< in a line that a terminal shows whole

  void add(const std::string &fault) { faults_.push_back(fault); }
  bool is_empty() const { return faults_.empty(); }

  /// "a; b; and 3 faults more", in the order in which they were found; "" if there are none.
  std::string text() const;

  /// Throws InputError with `begin`, the text and `end`, if there is a fault.
  void throw_if_any(const std::string &begin = "", const std::string &end = "") const;

private:
  std::vector<std::string> faults_;
};

/// "a", "a and b", "a, b and c", or of more than four things "a, b, c and 12 more".
std::string enumeration(const std::vector<std::string> &things);
} // namespace orthocone
