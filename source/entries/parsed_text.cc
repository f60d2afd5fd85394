// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "parsed_text.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/numbers.h>
#include <orthocone/base/text.h>

#include <array>
#include <iostream>
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
} // namespace

bool has_word(const std::string &text, const std::string &words)
{
  return std::regex_search(text, std::regex("(^|[^A-Za-z0-9_.])(" + words + ")([^A-Za-z0-9_]|$)"));
}

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

std::shared_ptr<ParsedText> parsed_text(const std::string &text, const std::string &variables,
                                        std::map<std::string, double> constants, const bool has_time)
{
  auto parser = std::make_shared<ParsedText>(1);
  const SilentErrors silent;
  constants["pi"] = pi;
  try
  {
    parser->initialize(variables, text, constants, has_time);
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
} // namespace orthocone
