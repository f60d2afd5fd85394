// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/program_file.h>

#include "signal_cycles.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/numbers.h>
#include <orthocone/base/text.h>
#include <orthocone/entries/text_file.h>
#include <orthocone/scene/legs.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace orthocone
{
namespace
{
constexpr TextFileKind program_text{"a CSV file with a header and a row a step", 100,
                                    "a header and at least one row are wanted"};

/// What a name measures: its unit, and factors from others that users may write.
struct Quantity
{
  const char *unit;
  std::vector<OtherUnit> others;
};

/// The same of a component, a load, "time" or "cycle".
Quantity quantity_of(const std::string &name, const std::vector<Load> &loads)
{
  constexpr double degrees = 1 / radians_per_degree;
  static const Quantity length{
      "mm", {{"um", 1e-3}, {"\u00b5m", 1e-3}, {"\u03bcm", 1e-3}, {"nm", 1e-6}, {"m", 1e3}}},
      angle{"degrees",
            {{"deg", 1}, {"degree", 1}, {"\u00b0", 1}, {"rad", degrees}, {"mrad", degrees / 1000}}},
      force{"N", {{"kN", 1e3}, {"mN", 1e-3}}},
      moment{"N mm", {{"Nmm", 1}, {"N m", 1e3}, {"Nm", 1e3}, {"kN m", 1e6}, {"kNm", 1e6}}},
      time{"s", {{"ms", 1e-3}, {"min", 60}, {"h", 3600}}}, number{"", {}};
  for (const Load &load : loads)
    if (load.name == name)
      return {load.kind->unit(), load.kind->other_units()};
  if (name == "time")
    return time;
  if (name == "cycle")
    return number;
  return name[0] == 'u' ? length : name[0] == 'r' ? angle : name[0] == 'F' ? force : moment;
}

/// A column of the file. Its name is that of a component, "time" or "cycle".
struct SignalColumn
{
  std::string name;
  double factor = 1; ///< from its unit to the unit of the program
};

class ProgramFile
{
public:
  explicit ProgramFile(const LoadOptions &load)
      : name_(shown_path(load.program_file)),
        loads_(load.loads),
        steps_per_row_(load.steps_per_row)
  {
    std::istringstream stream(with_plain_lines(read_text_file(load.program_file, "", program_text)));
    for (std::string line; std::getline(stream, line);)
      if (++line_; !trimmed(line).empty() && trimmed(line)[0] != '#')
        columns_.empty() ? read_header(line) : read_row(line);
    if (rows_.empty())
      throw InputError(name_ + ": has no row behind its header: allowed is " + program_text.if_empty);
  }

  std::vector<Leg> &rows() { return rows_; }

  bool has(const std::string &column) const
  {
    return std::any_of(columns_.begin(), columns_.end(),
                       [&](const SignalColumn &known) { return known.name == column; });
  }

private:
  [[noreturn]] void refuse(const std::string &why) const
  {
    throw InputError(name_ + ":" + std::to_string(line_) + ": " + why);
  }

  void read_header(const std::string &line);
  SignalColumn read_column(const std::string &cell) const;
  double factor_of(const std::string &column, const std::string &unit) const;
  void read_row(const std::string &line);
  double read_number(const std::string &cell, std::size_t column) const;
  void take(const SignalColumn &column, double value, Leg &leg) const;
  void take_cycle(double value, SignalRow &row) const;

  const std::string name_;
  const std::vector<Load> &loads_;
  const unsigned int steps_per_row_;
  unsigned int line_ = 0;
  char separator_ = ',';
  std::vector<SignalColumn> columns_;
  std::vector<Leg> rows_;
};

/// The cells of a line, also an empty one at its end.
std::vector<std::string> cells_of(const std::string &line, const char separator)
{
  std::vector<std::string> cells = split(line, separator);
  if (line.back() == separator)
    cells.emplace_back();
  return cells;
}

std::string without_quotes(const std::string &cell)
{
  const bool is_quoted = cell.size() >= 2 && cell.front() == '"' && cell.back() == '"';
  return is_quoted ? trimmed(cell.substr(1, cell.size() - 2)) : cell;
}

void ProgramFile::read_header(const std::string &line)
{
  for (const char separator : {'\t', ';', ','})
    if (line.find(separator) != std::string::npos)
    {
      separator_ = separator;
      break;
    }
  Leg leg;
  unsigned int n_times = 0, n_cycles = 0, n_components = 0;
  for (const std::string &cell : cells_of(line, separator_))
  {
    columns_.push_back(read_column(without_quotes(cell)));
    const std::string &name = columns_.back().name;
    if (++(name == "time" ? n_times : name == "cycle" ? n_cycles : n_components); n_times > 1 || n_cycles > 1)
      refuse("column '" + name + "' is there twice: allowed is one");
    if (name != "time" && name != "cycle")
      if (const std::string instead = set_target(name, 0, loads_, leg); !instead.empty())
        refuse("column '" + shown(cell) + "': allowed is " + instead);
  }
  if (n_components == 0)
    refuse("no column drives the held face: allowed are components such as ux, Fx or Fz, and loads");
}

/// Reads "NAME", "NAME [UNIT]" or "NAME (UNIT)".
SignalColumn ProgramFile::read_column(const std::string &cell) const
{
  const std::size_t bracket = cell.find_first_of("[(");
  const std::string name = trimmed(cell.substr(0, bracket));
  if (name.empty())
    refuse("column " + std::to_string(columns_.size() + 1) +
           " has no name: allowed are time, cycle, and components such as ux, Fx or Fz");
  Leg leg;
  if (const std::string instead = name == "time" || name == "cycle" ? "" : set_target(name, 0, loads_, leg);
      !instead.empty())
    refuse("column '" + shown(cell) + "': allowed is time, cycle, or " + instead);
  if (bracket == std::string::npos)
    return {name, 1};
  const char end = cell[bracket] == '[' ? ']' : ')';
  if (cell.back() != end)
    refuse("column '" + shown(cell) +
           "': allowed is a name, or a name with its unit in brackets, such as 'ux [mm]'");
  return {name, factor_of(name, trimmed(cell.substr(bracket + 1, cell.size() - bracket - 2)))};
}

double ProgramFile::factor_of(const std::string &column, const std::string &unit) const
{
  const Quantity quantity = quantity_of(column, loads_);
  if (unit == quantity.unit)
    return 1;
  std::string all = quantity.unit;
  for (const auto &[other, factor] : quantity.others)
    if (unit == other)
      return factor;
    else
      all += std::string(", ") + other;
  refuse("column '" + column + "' has the unit '" + shown(unit) + "': allowed " +
         (all.empty() ? "is none" : "are " + all));
}

/// Reads a row as a leg to where its components are.
void ProgramFile::read_row(const std::string &line)
{
  const std::vector<std::string> cells = cells_of(line, separator_);
  if (cells.size() != columns_.size())
    refuse("has " + std::to_string(cells.size()) + (cells.size() == 1 ? " cell" : " cells") +
           ": allowed are the " + std::to_string(columns_.size()) + " of the header" +
           (separator_ == ',' && cells.size() > columns_.size()
                ? "; with a decimal comma write ';' between the columns, and a decimal point"
                : ""));
  Leg leg;
  leg.steps = steps_per_row_;
  leg.row = SignalRow{line_};
  for (std::size_t i = 0; i < columns_.size(); ++i)
    take(columns_[i], read_number(without_quotes(cells[i]), i), leg);
  rows_.push_back(leg);
}

double ProgramFile::read_number(const std::string &cell, const std::size_t column) const
{
  const auto number = parse_number(cell);
  if (!number)
    refuse("column '" + columns_[column].name + "' is '" + shown(cell) + "': allowed is a finite number" +
           (cell.empty()                          ? ", because a signal has no gaps"
            : cell.find(',') != std::string::npos ? " with a decimal point"
                                                  : ""));
  return *number;
}

void ProgramFile::take(const SignalColumn &column, const double value, Leg &leg) const
{
  if (column.name == "cycle")
    take_cycle(value, *leg.row);
  else if (column.name != "time")
    set_target(column.name, column.factor * value, loads_, leg);
  else if (leg.row->time = column.factor * value; !rows_.empty() && *rows_.back().row->time >= *leg.row->time)
    refuse("column 'time' is " + to_text(value) + " and does not increase: allowed is more than " +
           to_text(*rows_.back().row->time / column.factor));
}

void ProgramFile::take_cycle(const double value, SignalRow &row) const
{
  const unsigned int before = rows_.empty() ? 0 : rows_.back().row->cycle;
  if (value != before && value != before + 1.)
    refuse("column 'cycle' is " + to_text(value) + ": allowed is " + std::to_string(before) + " or " +
           std::to_string(before + 1) + "; cycles count from 1, and 0 is before the first one");
  row.cycle = static_cast<unsigned int>(value);
}

/// A cycle ends in front of the next one, and the last one where the file does.
void end_counted_cycles(std::vector<Leg> &rows)
{
  for (std::size_t i = 0; i < rows.size(); ++i)
    rows[i].row->ends_cycle =
        rows[i].row->cycle > 0 && (i + 1 == rows.size() || rows[i + 1].row->cycle != rows[i].row->cycle);
}

/// All rows are the one cycle that is repeated.
void make_one_cycle(std::vector<Leg> &rows)
{
  for (Leg &leg : rows)
    leg.row->cycle = 1;
  rows.back().row->ends_cycle = true;
}
} // namespace

void declare_program_file(LoadOptions &load, Section &section)
{
  const Condition has_rows{[&load] { return !load.program_file.empty(); },
                           [] { return std::string("Load program/Program file = "); }};
  section
      .add("Program file", load.program_file, path_codec(),
           "CSV file (',', ';' or tab) with a signal that drives the held face in place of Legs. Its first "
           "line names components, with units in brackets, such as 'time [s], Fz [kN], ux [um]', and each "
           "row gives the values to which they go next. A column 'time' is kept in history.csv. A cycle "
           "begins where a column 'cycle' counts on; without such a column the program finds the cycles in "
           "the signal, or with Cycles > 1 takes the whole file as one cycle.")
      .path(load.program_file)
      .also_called({"signal", "load file", "legs file", "amplitude file", "csv"});
  section
      .add("Steps per row", load.steps_per_row, count_codec(1, 1000),
           "Number of load steps from each row of the Program file to the next one.")
      .only_if(has_rows);
}

void read_program_file(LoadOptions &load)
{
  if (load.program_file.empty())
    return;
  ProgramFile file(load);
  load.rows = std::move(file.rows());
  if (file.has("cycle") && load.cycles > 1)
    throw InputError(
        "Load program/Cycles = " + std::to_string(load.cycles) +
        " with a column 'cycle' in Load program/Program file = " + shown_path(load.program_file) +
        ": allowed is 1, or a file without that column, which is repeated as a whole");
  if (file.has("cycle"))
    end_counted_cycles(load.rows);
  else if (load.cycles > 1)
    make_one_cycle(load.rows);
  else
    find_cycles(load.rows, load.preload);
}
} // namespace orthocone
