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
  /// Throws InputError for a text that is no expression; the sentence quotes what is wrong in it.
  explicit Expression(const std::string &text = "0");

  /// May be any number, also infinite or NaN.
  double value(const double x, const double y) const { return value_(x, y); }

  /// Whether neither x nor y is in it.
  bool is_constant() const { return is_constant_; }

  /// As it was given.
  const std::string &text() const { return text_; }

private:
  std::string text_;
  bool is_constant_ = true;
  std::function<double(double, double)> value_;
};
} // namespace orthocone
