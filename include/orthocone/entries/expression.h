// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <functional>
#include <string>

namespace orthocone
{
/// A number, or an expression of x, y and z (mm) in the syntax of muParser, with pi and without random
/// numbers.
class Expression
{
public:
  /// Throws InputError for a text that is no expression; the sentence quotes the part that is wrong.
  explicit Expression(const std::string &text = "0");

  /// The value at x, y, z (mm): any number, also infinite or NaN.
  double value(const double x, const double y, const double z = 0) const { return value_(x, y, z); }

  /// Whether the expression contains none of x, y and z.
  bool is_constant() const { return is_constant_; }

  /// Whether the expression contains z.
  bool has_z() const { return has_z_; }

  /// The text as it was given.
  const std::string &text() const { return text_; }

private:
  std::string text_;
  bool is_constant_ = true;
  bool has_z_ = false;
  std::function<double(double, double, double)> value_;
};
} // namespace orthocone
