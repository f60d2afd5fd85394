// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/entries/expression.h>

#include <orthocone/base/errors.h>
#include <orthocone/base/numbers.h>
#include <orthocone/base/text.h>

#include <deal.II/base/function_parser.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <memory>
#include <regex>
#include <sstream>
#include <utility>

namespace orthocone
{
namespace
{
/// Keeps what the library prints off the screen: the program words its own messages.
class SilentErrors
{
public:
  SilentErrors()
      : before_(std::cerr.rdbuf(text_.rdbuf()))
  {
  }
  ~SilentErrors() { std::cerr.rdbuf(before_); }
  SilentErrors(const SilentErrors &) = delete;
  SilentErrors &operator=(const SilentErrors &) = delete;

private:
  std::ostringstream text_;
  std::streambuf *before_;
};

/// Whether the text has one of these words, not as a part of a longer word.
bool has_word(const std::string &text, const std::string &words)
{
  return std::regex_search(text, std::regex("(^|[^A-Za-z0-9_.])(" + words + ")([^A-Za-z0-9_]|$)"));
}

/// Refuses what the library would accept, but users do not mean.
void check_form(const std::string &text)
{
  constexpr std::size_t longest = 1000; // the search for words is recursive
  if (text.empty())
    throw InputError("it is empty");
  if (text.size() > longest)
    throw InputError("it is longer than " + std::to_string(longest) + " characters");
  for (const char c : text)
    if (static_cast<unsigned char>(c) < ' ' || c == ';' || c == '"')
      throw InputError("'" + shown(std::string(1, c)) + "' is not allowed in it");
  if (std::regex_search(text, std::regex("(^|[^=<>!])=([^=]|$)")))
    throw InputError("'=' is no comparison; '==' is one");
  if (has_word(text, "rand|rand_seed"))
    throw InputError("random numbers are not allowed in it");
  int depth = 0;
  for (const char c : text)
  {
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (c == ',' && depth == 0)
      throw InputError("a ',' stands outside of parentheses");
  }
}

/// The library's message in the words of this program; what it quotes is a part of the expression.
std::string in_our_words(const std::string &message)
{
  static const std::array<std::pair<const char *, const char *>, 11> words{
      {{"Unexpected token", " is not known"},
       {"Unexpected variable", " needs an operator before it"},
       {"Unexpected value", " needs an operator before it"},
       {"Unexpected function", " needs an operator before it"},
       {"Unexpected operator", " has nothing before it"},
       {"Unexpected parenthesis", " is not expected where it is"},
       {"Missing parenthesis", "a ')' is missing"},
       {"Unexpected end", "it ends too early"},
       {"Too few parameters", " has too few arguments"},
       {"Too many parameters", " has too many arguments"},
       {"If-then-else", "a '?' has no ':'"}}};
  std::smatch quoted;
  const bool has_quote = std::regex_search(message, quoted, std::regex("\"([^\"]*)\""));
  for (const auto &[beginning, meaning] : words)
    if (message.find(beginning) != std::string::npos && (meaning[0] != ' ' || has_quote))
      return meaning[0] == ' ' ? "'" + shown(trimmed(quoted[1])) + "'" + meaning : meaning;
  return "it is not understood";
}

std::shared_ptr<const dealii::FunctionParser<3>> parser_of(const std::string &text)
{
  auto parser = std::make_shared<dealii::FunctionParser<3>>(1);
  const SilentErrors silent;
  try
  {
    parser->initialize("x,y,z", text, {{"pi", pi}}, false);
    parser->value(dealii::Point<3>()); // only this finds some faults
  }
  catch (const dealii::ExceptionBase &error)
  {
    std::ostringstream message;
    error.print_info(message);
    throw InputError(in_our_words(message.str()));
  }
  return parser;
}
} // namespace

Expression::Expression(const std::string &text)
    : text_(text)
{
  if (const auto number = parse_number(text))
  {
    value_ = [value = *number](double, double, double) { return value; };
    return;
  }
  check_form(text);
  is_constant_ = !has_word(text, "x|y|z");
  has_z_ = has_word(text, "z");
  value_ = [parser = parser_of(text)](const double x, const double y, const double z)
  { return parser->value(dealii::Point<3>(x, y, z)); };
}
} // namespace orthocone
