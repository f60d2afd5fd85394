// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/entries/codec.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace orthocone
{
/// Whether the name of a physical group has no character that separates names or begins a comment.
inline bool is_group_name(const std::string &text)
{
  return std::none_of(text.begin(), text.end(),
                      [](const unsigned char c) { return c < ' ' || std::string("#\\,;:").find(c) < 5; });
}

/// Names of surfaces, separated by commas, or nothing.
inline Codec<std::vector<std::string>> group_names_codec()
{
  return list_codec<std::string>(
      "names or numbers separated by commas, or nothing", ',', ", ",
      [](const std::string &text)
      { return !text.empty() && is_group_name(text) ? std::optional<std::string>(text) : std::nullopt; },
      [](const std::string &name) { return name; });
}
} // namespace orthocone
