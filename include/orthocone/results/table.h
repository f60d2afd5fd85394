// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The shape of a CSV file: header and rows come from one list of columns, so that a new column is one line.
#pragma once

#include <orthocone/base/text.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace orthocone
{
/// The text of a value in a table.
inline std::string cell(const double value)
{
  return to_text(value);
}
inline std::string cell(const std::optional<double> &value)
{
  return value ? to_text(*value) : "nan"; // a word that readers of tables take for a missing number
}
inline std::string cell(const unsigned int value)
{
  return std::to_string(value);
}
inline std::string cell(const std::string &value)
{
  return value;
}

/// A column of a table whose rows are made of a `Row`.
template<typename Row>
struct Column
{
  /// `value_of`: number, count or word of a row. `unit`: empty for counts, shares and words.
  template<typename ValueOf>
  Column(std::string name_, std::string unit_, std::string how_, const ValueOf &value_of)
      : name(std::move(name_)),
        unit(std::move(unit_)),
        how(std::move(how_)),
        of([value_of](const Row &row) { return cell(value_of(row)); })
  {
  }

  std::string name; ///< in the header of the file
  std::string unit;
  std::string how; ///< what the number means
  std::function<std::string(const Row &)> of;
};

template<typename Row>
using Columns = std::vector<Column<Row>>;

/// The first line of a table, with its end.
template<typename Row>
std::string header_line(const Columns<Row> &columns)
{
  std::string text;
  for (const Column<Row> &column : columns)
    text += (text.empty() ? "" : ",") + std::string(column.name);
  return text + "\n";
}

/// A line of a table, with its end.
template<typename Row>
std::string row_line(const Columns<Row> &columns, const Row &row)
{
  std::string text;
  for (const Column<Row> &column : columns)
    text += (text.empty() ? "" : ",") + column.of(row);
  return text + "\n";
}
} // namespace orthocone
