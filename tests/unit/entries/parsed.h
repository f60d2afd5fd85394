// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/entries/codec.h>

namespace orthocone::test
{
/// What a codec reads in a text, or nothing; `instead` becomes what it allows to who gave this text.
template<typename T>
std::optional<T> parsed(const Codec<T> &codec, const std::string &text, std::string *const instead = nullptr)
{
  std::string allowed = codec.allowed;
  auto value = codec.parse(text, allowed);
  if (instead != nullptr)
    *instead = allowed;
  return value;
}
} // namespace orthocone::test
