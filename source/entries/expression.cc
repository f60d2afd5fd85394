// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/entries/expression.h>

#include "parsed_text.h"

#include <orthocone/base/text.h>

#include <memory>

namespace orthocone
{
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
  value_ = [parser = std::shared_ptr<const ParsedText>(parsed_text(text, "x,y,z"))](
               const double x, const double y, const double z)
  { return parser->value(dealii::Point<3>(x, y, z)); };
}
} // namespace orthocone
