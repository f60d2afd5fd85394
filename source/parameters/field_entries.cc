// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "entries.h"

#include <orthocone/base/errors.h>

#include <algorithm>

namespace orthocone::entries
{
namespace
{
using Pair = std::array<Expression, 2>;

constexpr const char *associated = "associated";
constexpr const char *collinear = "collinear";

/// The pieces between commas outside parentheses.
std::vector<std::string> arguments(const std::string &text)
{
  std::vector<std::string> pieces(1);
  int depth = 0;
  for (const char c : text)
  {
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (c == ',' && depth <= 0)
      pieces.emplace_back();
    else
      pieces.back() += c;
  }
  std::transform(pieces.begin(), pieces.end(), pieces.begin(), trimmed);
  return pieces;
}

/// The fault in the first of these texts that is no expression, or "".
std::string fault_in(const std::vector<std::string> &texts)
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

/// Reads two expressions. Constant ones must be > 0, or both 0 if `may_be_none`.
std::optional<Pair> parse_pair(const std::string &text, const bool may_be_none)
{
  const auto pieces = arguments(text);
  if (pieces.size() != 2 || !fault_in(pieces).empty())
    return std::nullopt;
  const Pair pair{{Expression(pieces[0]), Expression(pieces[1])}};
  const auto is_none = [](const Expression &e) { return e.is_constant() && e.value(0, 0) == 0; };
  const auto is_fine = [](const Expression &e)
  { return !e.is_constant() || positive.contains(e.value(0, 0)); };
  const bool is_allowed =
      (may_be_none && is_none(pair[0]) && is_none(pair[1])) || (is_fine(pair[0]) && is_fine(pair[1]));
  return is_allowed ? std::optional<Pair>(pair) : std::nullopt;
}

/// Describes the limit that no scene reaches, if a number of the text is beyond it, and the fault in the
/// text.
std::string describe_pair(const std::string &text, const std::string &behind_range)
{
  const auto pieces = arguments(text);
  std::string range = positive.describe();
  for (const std::string &piece : pieces)
    if (const std::string more = positive.describe_for(piece);
        parse_number(piece) && more.size() > range.size())
      range = more;
  return "two numbers" + range + behind_range + (pieces.size() == 2 ? fault_in(pieces) : "");
}

template<typename Numbers>
void assign(const Pair &pair, Numbers &numbers, std::optional<Pair> &varying)
{
  numbers = std::array<double, 2>{{pair[0].value(0, 0), pair[1].value(0, 0)}};
  varying = pair[0].is_constant() && pair[1].is_constant() ? std::nullopt : std::optional<Pair>(pair);
}

std::string pair_text(const std::array<double, 2> &pair, const std::optional<Pair> &varying)
{
  return varying ? (*varying)[0].text() + ", " + (*varying)[1].text()
                 : to_text(pair[0]) + ", " + to_text(pair[1]);
}

void assign_slip_potential(const std::string &text, FrictionOptions &friction)
{
  friction.slip_potential = std::nullopt;
  friction.varying_slip_potential = std::nullopt;
  friction.is_collinear_by_word = text == collinear;
  if (text != collinear && text != associated)
    assign(*parse_pair(text, false), friction.slip_potential, friction.varying_slip_potential);
}
void add_expression(EntryTable &table, const std::string &name, const std::string &value, const Range &range,
                    const std::string &help, const std::function<void(const Expression &)> &assign)
{
  const std::string allowed = "a number" + range.describe() + ", or an expression of x and y";
  const auto test = [range](const std::string &text)
  {
    if (!fault_in({text}).empty())
      return false;
    const Expression expression(text);
    return !expression.is_constant() || range.contains(expression.value(0, 0));
  };
  table.add(name, value,
            Allowed(allowed, test, [allowed](const std::string &text) { return allowed + fault_in({text}); }),
            help, [assign](const std::string &text) { assign(Expression(text)); });
}
} // namespace

void add_coefficients(EntryTable &table, const std::string &name, FrictionOptions &friction,
                      const std::string &help)
{
  const auto allowed = [](const std::string &text) {
    return describe_pair(text, " (or both 0: no friction) separated by a comma, or expressions of x and y");
  };
  table.add(name, pair_text(friction.mu, friction.varying_mu),
            Allowed(
                allowed("1, 1"), [](const std::string &text) { return parse_pair(text, true).has_value(); },
                allowed),
            help,
            [&friction](const std::string &text)
            { assign(*parse_pair(text, true), friction.mu, friction.varying_mu); });
}

void add_slip_potential(EntryTable &table, const std::string &name, FrictionOptions &friction,
                        const std::string &help)
{
  const auto allowed = [](const std::string &text)
  {
    return "associated, or " +
           describe_pair(text, " separated by a comma, or collinear, or expressions of x and y");
  };
  const std::string given = friction.is_collinear_by_word ? collinear
                            : friction.slip_potential
                                ? pair_text(*friction.slip_potential, friction.varying_slip_potential)
                                : associated;
  const auto test = [](const std::string &text)
  { return text == associated || text == collinear || parse_pair(text, false).has_value(); };
  table.add(name, given, Allowed(allowed("1, 1"), test, allowed), help,
            [&friction](const std::string &text) { assign_slip_potential(text, friction); });
}

void add_angle(EntryTable &table, const std::string &name, FrictionOptions &friction, const std::string &help)
{
  const auto assign = [&friction](const Expression &angle)
  {
    friction.angle = angle.value(0, 0);
    friction.varying_angle = angle.is_constant() ? std::nullopt : std::optional<Expression>(angle);
  };
  add_expression(table, name,
                 friction.varying_angle ? friction.varying_angle->text() : to_text(friction.angle),
                 Range{-360, 360, true, true}, help, assign);
}

void add_gap(EntryTable &table, const std::string &name, std::string &gap, const std::string &help)
{
  add_expression(table, name, gap, any_number, help, [&gap](const Expression &given) { gap = given.text(); });
}

void add_path(EntryTable &table, const std::string &name, std::string &value, const std::string &help)
{
  const auto test = [](const std::string &text)
  {
    return std::none_of(text.begin(), text.end(),
                        [](const unsigned char c) { return c < ' ' || c == '#' || c == '\\'; });
  };
  table.add_path(name, value, Allowed("a path without '#' and '\\', or nothing", test), help,
                 [&value, &table](const std::string &text) { value = table.path_of(text); });
}
} // namespace orthocone::entries
