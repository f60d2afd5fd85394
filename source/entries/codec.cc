// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/entries/codec.h>

#include <orthocone/base/errors.h>

#include <cstdlib>

namespace orthocone
{
namespace
{
std::string describe_range(const NumberRange &range, const bool with_lower, const bool with_upper)
{
  std::string text;
  if (with_lower)
    text += (range.includes_lower ? " >= " : " > ") + to_text(range.lower);
  if (with_upper)
    text += std::string(text.empty() ? "" : " and") + (range.includes_upper ? " <= " : " < ") +
            to_text(range.upper);
  return text;
}

template<typename T>
std::string three_text(const std::array<T, 3> &value, const std::function<std::string(T)> &print)
{
  return print(value[0]) + ", " + print(value[1]) + ", " + print(value[2]);
}

/// What `print` makes of two numbers, or of three where the third is not 0.
template<typename Number>
std::string two_or_three_text(const std::array<Number, 3> &value,
                              const std::function<std::string(Number)> &print)
{
  return value[2] != 0 ? three_text<Number>(value, print) : print(value[0]) + ", " + print(value[1]);
}

/// Two or three of what `parse` reads.
template<typename Number, typename Parse>
std::optional<std::array<Number, 3>> two_or_three(const std::string &text, const Parse &parse)
{
  const auto parts = split(text, ',');
  std::array<Number, 3> all{};
  if (parts.size() < 2 || parts.size() > all.size())
    return std::nullopt;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    const auto number = parse(parts[i]);
    if (!number)
      return std::nullopt;
    all[i] = *number;
  }
  return all;
}
} // namespace

bool NumberRange::contains(const double value) const
{
  return (value > lower || (includes_lower && value == lower)) &&
         (value < upper || (includes_upper && value == upper));
}

std::string NumberRange::describe() const
{
  return describe_range(*this, lower > any_number.lower, upper < any_number.upper);
}

std::string NumberRange::describe_for(const std::string &value) const
{
  const double number = std::strtod(value.c_str(), nullptr); // infinite for 1e999
  return describe_range(*this, lower > any_number.lower || number <= lower,
                        upper < any_number.upper || number >= upper);
}

Codec<double> number_codec(const NumberRange &range)
{
  const auto parse = [range](const std::string &text, std::string &instead)
  {
    instead = "a number" + range.describe_for(text);
    const auto number = parse_number(text);
    return number && range.contains(*number) ? number : std::nullopt;
  };
  return {"a number" + range.describe(), parse, to_text};
}

Codec<double> percentage_codec(const NumberRange &range)
{
  const auto parse = [range](const std::string &text, std::string &)
  {
    const auto number = parse_percentage(text);
    return number && (*number == 0 || range.contains(*number)) ? number : std::nullopt;
  };
  return {"0, or a percentage" + range.describe() + " such as 1 %", parse,
          [](const double value) { return value == 0 ? "0" : to_text(value) + " %"; }};
}

Codec<unsigned int> count_codec(const unsigned int lower, const unsigned int upper)
{
  const auto parse = [lower, upper](const std::string &text, std::string &)
  {
    const auto count = parse_count(text);
    return count && *count >= lower && *count <= upper ? count : std::nullopt;
  };
  return {"a whole number from " + std::to_string(lower) + " to " + std::to_string(upper), parse,
          [](const unsigned int value) { return std::to_string(value); }};
}

Codec<std::array<double, 3>> three_numbers_codec(const NumberRange &range)
{
  const auto parse = [range](const std::string &text, std::string &) -> std::optional<std::array<double, 3>>
  {
    const auto numbers = parse_numbers(text, 3, ',');
    if (!numbers || !std::all_of(numbers->begin(), numbers->end(),
                                 [&](const double number) { return range.contains(number); }))
      return std::nullopt;
    return {{{(*numbers)[0], (*numbers)[1], (*numbers)[2]}}};
  };
  return {"three numbers" + range.describe() + " separated by commas", parse,
          [](const std::array<double, 3> &value) { return three_text<double>(value, to_text); }};
}

Codec<bool> yes_no_codec()
{
  const auto parse = [](const std::string &text, std::string &) -> std::optional<bool>
  { return text == "yes" || text == "no" ? std::optional(text == "yes") : std::nullopt; };
  return {"yes | no", parse, [](const bool value) { return std::string(value ? "yes" : "no"); }};
}

Codec<std::array<double, 3>> two_or_three_numbers_codec()
{
  const auto parse_one = [](const std::string &text)
  {
    const auto number = parse_number(text);
    return number && positive.contains(*number) ? number : std::nullopt;
  };
  return {"two or three numbers" + positive.describe() + " separated by commas",
          [parse_one](const std::string &text, std::string &)
          { return two_or_three<double>(text, parse_one); },
          [](const std::array<double, 3> &value) { return two_or_three_text<double>(value, to_text); }};
}

Codec<std::array<unsigned int, 3>> two_or_three_counts_codec(const unsigned int most)
{
  const auto parse_one = [most](const std::string &text)
  {
    const auto count = parse_count(text);
    return count && *count >= 1 && *count <= most ? count : std::nullopt;
  };
  return {"two or three whole numbers from 1 to " + std::to_string(most) + " separated by commas",
          [parse_one](const std::string &text, std::string &)
          { return two_or_three<unsigned int>(text, parse_one); },
          [](const std::array<unsigned int, 3> &value)
          {
            return two_or_three_text<unsigned int>(value, [](const unsigned int count)
                                                   { return std::to_string(count); });
          }};
}

Codec<std::string> path_codec()
{
  const auto parse = [](const std::string &text, std::string &)
  {
    const bool is_path = std::none_of(text.begin(), text.end(),
                                      [](const unsigned char c) { return c < ' ' || c == '#' || c == '\\'; });
    return is_path ? std::optional<std::string>(text) : std::nullopt;
  };
  return {"a path without '#' and '\\', or nothing", parse, [](const std::string &path) { return path; }};
}

Codec<Expression> expression_codec(const NumberRange &range)
{
  const std::string allowed = "a number" + range.describe() + ", or an expression of x, y and z";
  const auto parse = [range](const std::string &text, std::string &instead) -> std::optional<Expression>
  {
    const std::string fault = fault_in_expressions({text});
    instead += fault;
    if (!fault.empty())
      return std::nullopt;
    Expression expression(text);
    if (expression.is_constant() && !range.contains(expression.value(0, 0)))
      return std::nullopt;
    return expression;
  };
  return {allowed, parse, [](const Expression &expression) { return expression.text(); }};
}

std::string fault_in_expressions(const std::vector<std::string> &texts)
{
  for (const std::string &text : texts)
    try
    {
      Expression{text};
    }
    catch (const InputError &error)
    {
      return std::string("; ") + (texts.size() > 1 ? "in '" + shown(text) + "' " : "") + error.what();
    }
  return {};
}
} // namespace orthocone
