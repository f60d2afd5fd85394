// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <algorithm>
#include <string>

namespace orthocone
{
/// Whether the name of a physical group has no character that separates names or begins a comment.
inline bool is_group_name(const std::string &text)
{
  return std::none_of(text.begin(), text.end(),
                      [](const unsigned char c) { return c < ' ' || std::string("#\\,;:").find(c) < 5; });
}
} // namespace orthocone
