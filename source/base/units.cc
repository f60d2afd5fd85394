// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/units.h>

#include <orthocone/base/numbers.h>
#include <orthocone/base/text.h>

#include <algorithm>
#include <cctype>
#include <vector>

namespace orthocone
{
namespace
{
/// A unit is `times / over` of the program's. Of powers of ten one of both is 1, because a quotient of whole
/// numbers rounds once: 7 um are the 0.007 mm that a user would have written.
struct Unit
{
  std::string word;
  double times = 1;
  double over = 1;
};

/// The units of a quantity. The first one is the program's, and those that are the same follow it.
struct Quantity
{
  std::string name;
  std::vector<Unit> units;
};

const std::vector<Quantity> &quantities()
{
  constexpr double degrees = 1 / radians_per_degree;
  static const std::vector<Quantity> all{
      {"length",
       {{"mm"},
        {"um", 1, 1e3},
        {"\u00b5m", 1, 1e3},
        {"\u03bcm", 1, 1e3},
        {"nm", 1, 1e6},
        {"cm", 10},
        {"m", 1e3}}},
      {"force", {{"N"}, {"kN", 1e3}, {"MN", 1e6}, {"mN", 1, 1e3}}},
      {"stress",
       {{"MPa"}, {"N/mm^2"}, {"N/mm2"}, {"GPa", 1e3}, {"kPa", 1, 1e3}, {"Pa", 1, 1e6}, {"bar", 1, 10}}},
      {"angle", {{"degrees"}, {"degree"}, {"deg"}, {"\u00b0"}, {"rad", degrees}, {"mrad", degrees, 1e3}}},
      {"moment", {{"N mm"}, {"Nmm"}, {"N m", 1e3}, {"Nm", 1e3}, {"kN m", 1e6}, {"kNm", 1e6}}},
      {"time", {{"s"}, {"ms", 1, 1e3}, {"min", 60}, {"h", 3600}}},
      {"temperature", {{"K"}, {"degC"}}}, // differences
      {"expansion", {{"1/K"}, {"/K"}, {"ppm/K", 1, 1e6}, {"um/(m K)", 1, 1e6}}},
      {"wear coefficient",
       {{"MPa\u207b\u00b9"},
        {"1/MPa"},
        {"mm^2/N"},
        {"mm^3/(N mm)"},
        {"mm^3/Nmm"},
        {"mm3/Nmm"},
        {"1/GPa", 1, 1e3},
        {"1/Pa", 1e6},
        {"mm^3/(N m)", 1, 1e3},
        {"mm^3/Nm", 1, 1e3},
        {"mm3/Nm", 1, 1e3}}}};
  return all;
}

const Unit *find_unit(const Quantity &quantity, const std::string &word)
{
  const auto found = std::find_if(quantity.units.begin(), quantity.units.end(),
                                  [&](const Unit &unit) { return unit.word == word; });
  return found == quantity.units.end() ? nullptr : &*found;
}

/// The quantity with this unit, or null.
const Quantity *find_quantity(const std::string &word)
{
  const auto &all = quantities();
  const auto found = std::find_if(
      all.begin(), all.end(), [&](const Quantity &quantity) { return find_unit(quantity, word) != nullptr; });
  return found == all.end() ? nullptr : &*found;
}

/// The quantity whose unit in the program this is, or null.
const Quantity *measured_in(const std::string &unit)
{
  const Quantity *const quantity = find_quantity(unit);
  return quantity != nullptr && quantity->units.front().word == unit ? quantity : nullptr;
}

/// A number and the word behind it, if the text begins with a number and goes on.
struct NumberWithWord
{
  double number;
  std::string word;
};

std::optional<NumberWithWord> number_with_word(const std::string &text)
{
  const std::string whole = trimmed(text);
  std::size_t end = whole.find_first_not_of("+-.0123456789");
  // An exponent belongs to the number where digits follow.
  if (end != std::string::npos && end > 0 && (whole[end] == 'e' || whole[end] == 'E'))
    if (const std::size_t after = whole.find_first_not_of("+-0123456789", end + 1); after != end + 1)
      end = after;
  if (end == std::string::npos || end == 0)
    return std::nullopt;
  const auto number = parse_number(trimmed(whole.substr(0, end)));
  return number ? std::optional(NumberWithWord{*number, trimmed(whole.substr(end))}) : std::nullopt;
}
/// Whether a word is not a part of an expression such as 2 x.
bool looks_like_unit(const std::string &word)
{
  return word.size() > 1 && std::isalpha(static_cast<unsigned char>(word[0])) != 0 &&
         word.find_first_of("xy()*+-,;") == std::string::npos;
}
} // namespace

std::optional<double> in_unit(const std::string &unit, const double value, const std::string &given)
{
  if (given == unit)
    return value;
  const Quantity *const quantity = measured_in(unit);
  const Unit *const other = quantity != nullptr ? find_unit(*quantity, given) : nullptr;
  return other != nullptr ? std::optional(value * other->times / other->over) : std::nullopt;
}

bool has_other_units(const std::string &unit)
{
  return measured_in(unit) != nullptr;
}

std::string units_like(const std::string &unit)
{
  const Quantity *const quantity = measured_in(unit);
  if (quantity == nullptr)
    return unit;
  std::string all;
  for (const Unit &other : quantity->units)
    if (other.word != "\u03bcm") // which looks like that before it
      all += (all.empty() ? "" : ", ") + other.word;
  return all;
}

std::string quantity_of_unit(const std::string &word)
{
  const Quantity *const quantity = find_quantity(word);
  return quantity != nullptr ? quantity->name : "";
}

std::optional<double> parse_quantity(const std::string &text, const std::string &unit)
{
  if (const auto number = parse_number(trimmed(text)))
    return number;
  const auto found = number_with_word(text);
  return found ? in_unit(unit, found->number, found->word) : std::nullopt;
}

std::string without_units(const std::string &text, const std::string &unit)
{
  if (!has_other_units(unit))
    return text;
  std::string plain;
  bool changes = false;
  for (const std::string &piece : split(text, ','))
  {
    const auto found = number_with_word(piece);
    const auto value = found ? in_unit(unit, found->number, found->word) : std::nullopt;
    changes = changes || value;
    plain += (plain.empty() ? "" : ", ") + (value ? to_text(*value) : piece);
  }
  return changes ? plain : text;
}

std::string fault_of_units(const std::string &text, const std::string &unit)
{
  for (const std::string &piece : split(text, ','))
    if (const auto found = number_with_word(piece))
    {
      const std::string quantity = quantity_of_unit(found->word);
      if (!quantity.empty() && !in_unit(unit, 1, found->word))
        return "; " + found->word + " is a unit of " + quantity + ", and this entry has " +
               (has_other_units(unit) ? units_like(unit) : "no unit");
      if (quantity.empty() && has_other_units(unit) && looks_like_unit(found->word))
        return "; " + shown(found->word) + " is none of the units " + units_like(unit);
    }
  return {};
}
} // namespace orthocone
