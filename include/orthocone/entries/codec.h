// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// What the text of an entry means: each codec turns a text into a value, or into what is allowed instead, and
// a value into its text. Nothing here throws.
#pragma once

#include <orthocone/base/text.h>
#include <orthocone/entries/expression.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace orthocone
{
/// Texts of values of the type T.
template<typename T>
struct Codec
{
  std::string allowed; ///< what follows "allowed is"
  /// The value of a text, or nothing. Then `instead`, which has the text of `allowed`, may become what is
  /// allowed to a user who gave this text.
  std::function<std::optional<T>(const std::string &text, std::string &instead)> parse;
  std::function<std::string(const T &)> print;
};

/// Interval of numbers, open at both ends unless said otherwise, and how messages describe it.
struct NumberRange
{
  double lower = -1e300;
  double upper = 1e300;
  bool includes_lower = false;
  bool includes_upper = false;

  bool contains(double value) const;
  std::string describe() const; ///< "> 0 and < 1", without limits that no scene reaches

  /// The same, with a limit that no scene reaches if `value` is beyond it.
  std::string describe_for(const std::string &value) const;
};

constexpr NumberRange any_number{};
constexpr NumberRange positive{0, 1e300, false, false};

Codec<double> number_codec(const NumberRange &range);

/// A percentage written with its sign, or 0.
Codec<double> percentage_codec(const NumberRange &range);

Codec<unsigned int> count_codec(unsigned int lower, unsigned int upper);

/// Three numbers, separated by commas.
Codec<std::array<double, 3>> three_numbers_codec(const NumberRange &range);

/// Two or three numbers > 0, or whole numbers from 1 to `most`, separated by commas; of two the third is 0.
Codec<std::array<double, 3>> two_or_three_numbers_codec();
Codec<std::array<unsigned int, 3>> two_or_three_counts_codec(unsigned int most);

/// yes or no.
Codec<bool> yes_no_codec();

/// Path of a file, or nothing.
Codec<std::string> path_codec();

/// A number, or an expression of x, y and z. Constant ones must lie in the range.
Codec<Expression> expression_codec(const NumberRange &range);

/// What is wrong with the first of these texts that is no expression, behind "; ", or "".
std::string fault_in_expressions(const std::vector<std::string> &texts);

/// Table of the words of an enumeration, as users write them; specialised for each enumeration.
template<typename Enum>
struct Words;

/// The first word of an enumerator.
template<typename Enum>
std::string to_word(const Enum value)
{
  for (const auto &[enumerator, word] : Words<Enum>::table)
    if (enumerator == value)
      return std::string(word);
  return {};
}

/// The enumerator of a word, or nothing.
template<typename Enum>
std::optional<Enum> from_word(const std::string_view text)
{
  for (const auto &[enumerator, word] : Words<Enum>::table)
    if (word == text)
      return enumerator;
  return std::nullopt;
}

/// One of the words of an enumeration.
template<typename Enum>
Codec<Enum> word_codec()
{
  std::string words;
  for (const auto &entry : Words<Enum>::table)
    words += (words.empty() ? "" : " | ") + std::string(entry.second);
  return {words, [](const std::string &text, std::string &) { return from_word<Enum>(text); },
          [](const Enum value) { return to_word(value); }};
}

/// A list of what `item` reads, separated by `separator` (printed with the blanks of `printed_separator`),
/// possibly empty. `may_follow(items, item)` says whether an item may stand behind those before it.
template<typename T>
Codec<std::vector<T>>
list_codec(const std::string &allowed, const char separator, const std::string &printed_separator,
           const std::function<std::optional<T>(const std::string &)> &parse_item,
           const std::function<std::string(const T &)> &print_item,
           const std::function<bool(const std::vector<T> &, const T &)> &may_follow = {})
{
  const auto parse = [=](const std::string &text, std::string &) -> std::optional<std::vector<T>>
  {
    std::vector<T> items;
    if (trimmed(text).empty())
      return items;
    for (const std::string &piece : split(text, separator))
    {
      const std::optional<T> item = parse_item(piece);
      if (!item || (may_follow && !may_follow(items, *item)))
        return std::nullopt;
      items.push_back(*item);
    }
    return items;
  };
  const auto print = [=](const std::vector<T> &items)
  {
    std::string text;
    for (const T &item : items)
      text += (&item == items.data() ? "" : printed_separator) + print_item(item);
    return text;
  };
  return {allowed, parse, print};
}
} // namespace orthocone
