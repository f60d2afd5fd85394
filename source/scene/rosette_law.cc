// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Measured friction: a table of forces over the direction of slip.
#include <orthocone/base/errors.h>
#include <orthocone/base/numbers.h>
#include <orthocone/base/text.h>
#include <orthocone/contact/law/rosette.h>
#include <orthocone/entries/text_file.h>
#include <orthocone/scene/options.h>
#include <orthocone/scene/surface_sample.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace orthocone
{
namespace
{
constexpr TextFileKind rosette_file{"a text file with measured friction", 10, "rows of friction are wanted"};
constexpr double most_tables = 1000;

/// The tables of a file, which a line 'table' separates. Places read "file:line".
class RosetteReader
{
public:
  explicit RosetteReader(const std::string &path)
      : name_(shown_path(path))
  {
    std::istringstream lines(with_plain_lines(read_text_file(path, "", rosette_file)));
    for (std::string line; std::getline(lines, line);)
    {
      ++line_;
      const std::string text = trimmed(line.substr(0, line.find('#')));
      if (text.compare(0, heading.size(), heading) == 0)
        begin_table();
      else if (!text.empty())
        read_row(text);
    }
    finish_table();
  }

  std::vector<std::shared_ptr<const Rosette>> tables() && { return std::move(tables_); }

private:
  static constexpr std::string_view heading = "table";

  void begin_table()
  {
    if (!tables_.empty() || !rows_.empty())
      finish_table();
    beginning_ = line_;
  }

  /// The three numbers of a line, which blanks, tabs, commas or semicolons separate.
  void read_row(std::string text)
  {
    std::replace_if(
        text.begin(), text.end(), [](const char c) { return c == ',' || c == ';' || c == '\t'; }, ' ');
    std::istringstream words(text);
    std::vector<std::optional<double>> numbers;
    for (std::string word; words >> word;)
      numbers.push_back(parse_number(word));
    if (numbers.size() != 3 || std::count(numbers.begin(), numbers.end(), std::nullopt) > 0)
      throw InputError(name_ + ":" + std::to_string(line_) + ": '" + shown(trimmed(text)) +
                       "': allowed is a line 'angle mu_along mu_across' of three numbers (degrees, 1, 1), or "
                       "'table', where another one begins");
    rows_.push_back({*numbers[0] * radians_per_degree, *numbers[1], *numbers[2]});
  }

  void finish_table()
  {
    constexpr std::size_t most_rows = 3600;
    const std::string place =
        name_ + (beginning_ > 0 ? ":" + std::to_string(beginning_) + ": the table that begins here " : ": ");
    if (rows_.size() > most_rows)
      throw InputError(place + "has " + std::to_string(rows_.size()) + " rows: allowed are " +
                       std::to_string(most_rows) + ", ten for each degree");
    try
    {
      tables_.push_back(std::make_shared<const Rosette>(std::exchange(rows_, {})));
    }
    catch (const std::invalid_argument &error)
    {
      throw InputError(place + error.what());
    }
  }

  std::string name_;
  unsigned int line_ = 0, beginning_ = 0; ///< the line 'table', if there is one
  std::vector<Rosette::Row> rows_;
  std::vector<std::shared_ptr<const Rosette>> tables_;
};

/// The weighted mean of two measured laws, f = (1 - t) f_1 + t f_2, at the rows of both. Throws
/// std::invalid_argument where it is not well posed.
FrictionLaw mean_law(const Rosette &first, const Rosette &second, const double t)
{
  std::set<double> angles;
  for (const Rosette *const table : {&first, &second})
    for (const double angle : table->angles())
      if (const auto above = angles.lower_bound(angle - Rosette::same_angle);
          above == angles.end() || *above > angle + Rosette::same_angle)
        angles.insert(angle);
  std::vector<Rosette::Row> rows;
  for (const double angle : angles)
  {
    const Rosette::Row a = first.row(angle), b = second.row(angle);
    rows.push_back({angle, (1 - t) * a.along + t * b.along, (1 - t) * a.across + t * b.across});
  }
  return FrictionLaw(std::make_shared<const Rosette>(std::move(rows)));
}

class RosetteOptions : public FrictionLawOptions
{
public:
  std::unique_ptr<FrictionLawOptions> clone() const override
  {
    return std::make_unique<RosetteOptions>(*this);
  }

  void declare(Section &section, const Condition &is_chosen) override
  {
    section
        .add("Rosette", file_, path_codec(),
             "Text file with measured friction: a line 'angle mu_along mu_across' for each direction of "
             "slip, at least 8 all around, in any order, and comments behind #. The angle (degrees, from the "
             "first axis of friction) is that of the direction against which the body slips, mu_along the "
             "coefficient of friction along it, and mu_across that of the force across it, positive to its "
             "left. Several tables each begin with a line 'table' (Rosette weight). "
             "The path is relative to the folder of the parameter file.")
        .path(file_)
        .only_if(is_chosen)
        .also_called({"friction table", "friction file"});
    section
        .add("Rosette weight", weight_, expression_codec(NumberRange{0, most_tables, true, true}),
             "Which of several tables holds, counted from 0, as a number or an expression of x, y and z: "
             "if(x<0,0,1) takes the second one from x = 0 on, and between two whole numbers forces are the "
             "weighted mean of both tables, in steps of 0.01.")
        .only_if(is_chosen)
        .also_called({"table"});
  }

  bool varies(const FrictionOptions &) const override { return !weight_.is_constant(); }

  FrictionLaw law(const FrictionOptions &, const Eigen::Vector3d &place) const override
  {
    if (file_.empty())
      throw InputError(
          "Friction/Law = rosette without Friction/Rosette: allowed is the name of a file with lines "
          "'angle mu_along mu_across', or Law = ellipses");
    if (read_ != file_)
    {
      tables_ = RosetteReader(file_).tables();
      laws_.clear();
      read_ = file_;
    }
    const int step = step_of(weight_.value(place[0], place[1], place[2]), place);
    const auto made = laws_.find(step);
    return made != laws_.end() ? made->second : laws_.emplace(step, law_of(step, place)).first->second;
  }

private:
  static constexpr int steps = 100; // between two tables, so that laws are few and nodes share them

  int step_of(const double weight, const Eigen::Vector3d &place) const
  {
    const auto most = static_cast<double>(tables_.size() - 1);
    if (!(weight >= 0 && weight <= most))
      throw InputError("Friction/Rosette weight = " + weight_.text() + " is " + value_text(weight) + " at " +
                       place_text(place) + " of the contact surface: allowed are numbers from 0 to " +
                       to_text(most) + ", because " + shown_path(file_) + " has " +
                       std::to_string(tables_.size()) + (most > 0 ? " tables" : " table"));
    return static_cast<int>(std::lround(steps * weight));
  }

  FrictionLaw law_of(const int step, const Eigen::Vector3d &place) const
  {
    const auto first = static_cast<std::size_t>(step / steps);
    if (step % steps == 0)
      return FrictionLaw(tables_[first]);
    const double t = static_cast<double>(step % steps) / steps;
    try
    {
      return mean_law(*tables_[first], *tables_[first + 1], t);
    }
    catch (const std::invalid_argument &error)
    {
      throw InputError("Friction/Rosette weight = " + weight_.text() + " at " + place_text(place) +
                       " of the contact surface: the mean of tables " + std::to_string(first) + " and " +
                       std::to_string(first + 1) + " of " + shown_path(file_) + " " + error.what());
    }
  }

  std::string file_;
  Expression weight_{"0"};
  // The file is read, and each law is made, once.
  mutable std::string read_;
  mutable std::vector<std::shared_ptr<const Rosette>> tables_;
  mutable std::map<int, FrictionLaw> laws_;
};
} // namespace

Kind<FrictionLawOptions> rosette_law()
{
  return {"rosette", "friction as it is measured, over the direction of slip (Rosette)",
          [] { return std::make_unique<RosetteOptions>(); }};
}
} // namespace orthocone
