// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>

namespace orthocone
{
/// Reads words of a section of a mesh file, one after the other. All faults throw InputError with the file's
/// path.
class SectionReader
{
public:
  /// `path` and `section` are the names in messages.
  SectionReader(std::string path, std::string section, const std::string &text)
      : path_(std::move(path)),
        section_(std::move(section)),
        text_(text)
  {
  }

  double number()
  {
    const char *const from = next();
    char *end = nullptr;
    const double value = std::strtod(from, &end);
    if (end == from || !std::isfinite(value))
      fail_at(from, "a number");
    place_ = static_cast<std::size_t>(end - text_.c_str());
    return value;
  }

  long whole()
  {
    const char *const from = next();
    char *end = nullptr;
    const long value = std::strtol(from, &end, 10);
    if (end == from || (*end != '\0' && std::isspace(static_cast<unsigned char>(*end)) == 0))
      fail_at(from, "a whole number");
    place_ = static_cast<std::size_t>(end - text_.c_str());
    return value;
  }

  /// A whole number within bounds, both allowed.
  long whole_between(const long least, const long most)
  {
    const char *const from = next();
    const long value = whole();
    if (value < least || value > most)
      fail_at(from, "a whole number from " + std::to_string(least) + " to " + std::to_string(most));
    return value;
  }

  /// The number of a node or an element.
  long number_of_thing() { return whole_between(1, largest_number); }

  /// The number of an entity, or of a physical group, which may have a sign.
  long number_of_group() { return whole_between(-largest_number, largest_number); }

  long dimension() { return whole_between(0, 3); }

  /// Passes the least and the largest number of nodes or elements.
  void skip_range()
  {
    whole_between(0, largest_number);
    whole_between(0, largest_number);
  }

  /// How many things follow: never more than there are letters.
  std::size_t count()
  {
    const char *const from = next();
    const long value = whole();
    if (value < 0 || static_cast<std::size_t>(value) > text_.size())
      fail_at(from, "a count that is not larger than the section");
    return static_cast<std::size_t>(value);
  }

  void skip(const std::size_t n)
  {
    for (std::size_t i = 0; i < n; ++i)
      number();
  }

  /// Passes what is left of a line.
  void skip_line() { place_ = std::min(text_.find('\n', place_), text_.size()); }

  /// The text between the next two quotation marks.
  std::string quoted()
  {
    const std::size_t first = text_.find('"', place_), last = text_.find('"', first + 1);
    if (first == std::string::npos || last == std::string::npos)
      fail_at(next(), "a name in quotation marks");
    place_ = last + 1;
    return trimmed(text_.substr(first + 1, last - first - 1));
  }

  void require_end()
  {
    place_ = std::min(text_.find_first_not_of(" \t\n", place_), text_.size());
    if (place_ < text_.size())
      fail_at(text_.c_str() + place_, "the end of the section, which contains more than it announces");
  }

  [[noreturn]] void fail_at(const char *const from, const std::string &wanted) const
  {
    const std::string rest(from);
    throw InputError(path_ + ": section " + section_ + " has '" +
                     shown(rest.substr(0, rest.find_first_of(" \t\n"))) + "': allowed is " + wanted);
  }

private:
  const char *next()
  {
    place_ = text_.find_first_not_of(" \t\n", place_);
    if (place_ == std::string::npos)
      throw InputError(
          path_ + ": section " + section_ +
          " contains less than it announces: the file is cut off or damaged; write it anew with gmsh");
    return text_.c_str() + place_;
  }

  /// Gmsh's numbers are int, and a reader that finds a larger one in its stream may never end.
  static constexpr long largest_number = 2147483647;

  std::string path_;
  std::string section_;
  const std::string &text_;
  std::size_t place_ = 0;
};

/// The sections of a mesh file by their names, such as "$Nodes", without their first and last lines. Throws
/// InputError if the text does not begin with $MeshFormat, or has a section without end, or one twice.
std::map<std::string, std::string> sections_of(const std::string &path, const std::string &text);
} // namespace orthocone
