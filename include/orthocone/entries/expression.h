// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <functional>
#include <string>

namespace orthocone
{
/// A number, or an expression of x and y (mm) in the syntax of muParser, with pi and without random numbers.
class Expression
{
public:
  /// Throws InputError for a text that is no expression; the sentence quotes the part that is wrong.
  explicit Expression(const std::string &text = "0");

  /// The value at x, y (mm): any number, also infinite or NaN.
  double value(const double x, const double y) const { return value_(x, y); }

  /// Whether the expression contains neither x nor y.
  bool is_constant() const { return is_constant_; }

  /// The text as it was given.
  const std::string &text() const { return text_; }

private:
  std::string text_;
  bool is_constant_ = true;
  std::function<double(double, double)> value_;
};
} // namespace orthocone
