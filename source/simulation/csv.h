// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/parameters/text.h>

#include <string>

namespace orthocone::csv
{
inline std::string cell(const double value)
{
  return to_text(value);
}
inline std::string cell(const unsigned int value)
{
  return std::to_string(value);
}
inline std::string cell(const std::string &value)
{
  return value;
}

/// A line of a CSV file.
template<typename... Values>
std::string row(const Values &...values)
{
  std::string text;
  ((text += (text.empty() ? "" : ",") + cell(values)), ...);
  return text + "\n";
}
} // namespace orthocone::csv
