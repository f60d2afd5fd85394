// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/gap_file.h>

#include <orthocone/entries/text_file.h>

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <sstream>

namespace orthocone
{
namespace
{
constexpr const char *head_form = "'x0 dx nx y0 dy ny' (mm, mm, at least 2; the same of y)";

/// A line with more than a comment.
struct Row
{
  std::vector<std::string> words;
  std::string place; ///< "file:line"
};

/// Reads the next such line. Returns false at the end.
bool next_row(std::istream &stream, const std::string &name, unsigned int &line, Row &row)
{
  for (std::string text; std::getline(stream, text);)
  {
    std::istringstream words(text.substr(0, text.find('#')));
    row = {{std::istream_iterator<std::string>(words), {}}, name + ":" + std::to_string(++line)};
    if (!row.words.empty())
      return true;
  }
  return false;
}

GapGrid read_head(const Row &row)
{
  std::string all;
  for (const std::string &word : row.words)
    all += (all.empty() ? "" : " ") + word;
  const auto fail = [&] { return InputError(row.place + ": '" + shown(all) + "': allowed is " + head_form); };
  if (row.words.size() != 6)
    throw fail();
  std::array<std::optional<double>, 4> numbers;
  std::transform(row.words.begin(), row.words.begin() + 2, numbers.begin(), parse_number);
  std::transform(row.words.begin() + 3, row.words.begin() + 5, numbers.begin() + 2, parse_number);
  const auto n_x = parse_count(row.words[2]), n_y = parse_count(row.words[5]);
  if (!numbers[0] || !numbers[1] || !numbers[2] || !numbers[3] || !n_x || !n_y)
    throw fail();
  if (*numbers[1] <= 0 || *numbers[3] <= 0 || *n_x < 2 || *n_y < 2)
    throw fail();
  return {*numbers[0], *numbers[1], *numbers[2], *numbers[3], *n_x, *n_y, {}};
}

void append(const Row &row, GapGrid &grid)
{
  if (row.words.size() != grid.n_x)
    throw InputError(row.place + ": has " + std::to_string(row.words.size()) + " numbers: allowed are nx = " +
                     std::to_string(grid.n_x) + " in each row, without holes");
  for (std::size_t i = 0; i < row.words.size(); ++i)
    if (const auto number = parse_number(row.words[i]))
      grid.gap.push_back(*number);
    else
      throw InputError(row.place + ": number " + std::to_string(i + 1) + " is '" + shown(row.words[i]) +
                       "': allowed is a finite number (mm), because a grid has no holes");
}

/// The interval of a place, and the place's share of it, between 0 and 1.
std::pair<std::size_t, double> locate(const double place, const double first, const double spacing,
                                      const std::size_t n)
{
  const double position = std::clamp((place - first) / spacing, 0., static_cast<double>(n - 1));
  const std::size_t i = std::min(static_cast<std::size_t>(position), n - 2);
  return {i, position - static_cast<double>(i)};
}
} // namespace

bool GapGrid::contains(const double x, const double y) const
{
  constexpr double rounding = 1e-9;
  const auto is_inside = [](const double place, const double first, const double spacing, const std::size_t n)
  {
    const double position = (place - first) / spacing, last = static_cast<double>(n - 1);
    return position >= -rounding * last && position <= (1 + rounding) * last;
  };
  return is_inside(x, first_x, spacing_x, n_x) && is_inside(y, first_y, spacing_y, n_y);
}

double GapGrid::value(const double x, const double y) const
{
  const auto [i, s] = locate(x, first_x, spacing_x, n_x);
  const auto [j, t] = locate(y, first_y, spacing_y, n_y);
  const double *const below = &gap[j * n_x + i], *const above = below + n_x;
  return (1 - t) * ((1 - s) * below[0] + s * below[1]) + t * ((1 - s) * above[0] + s * above[1]);
}

GapGrid read_gap_file(const std::string &file_name)
{
  const std::string name = shown_path(file_name);
  std::istringstream stream(with_plain_lines(read_text_file(file_name, "", gap_grid_file)));
  unsigned int line = 0;
  Row row;
  if (!next_row(stream, name, line, row))
    throw InputError(name + ": has no line but comments: allowed is " + head_form + ", then ny rows");
  GapGrid grid = read_head(row);
  std::size_t n_rows = 0;
  for (; next_row(stream, name, line, row); ++n_rows)
  {
    if (n_rows == grid.n_y)
      throw InputError(row.place + ": is a row too many: allowed are ny = " + std::to_string(grid.n_y));
    append(row, grid);
  }
  if (n_rows != grid.n_y)
    throw InputError(name + ": has " + std::to_string(n_rows) +
                     " rows: allowed are ny = " + std::to_string(grid.n_y) + ", without holes");
  return grid;
}
} // namespace orthocone
