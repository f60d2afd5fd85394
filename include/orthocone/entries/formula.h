// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <array>
#include <memory>
#include <string>

namespace orthocone
{
/// An expression of six numbers with names of their own, in the syntax of Expression. The last two should
/// have few values at a time, because the text is read anew for each. Only one thread at a time may ask for
/// values.
class Formula
{
public:
  static constexpr std::size_t n_names = 6;
  using Names = std::array<std::string, n_names>;
  using Values = std::array<double, n_names>;

  /// Throws InputError for a text that is no expression; the sentence quotes the part that is wrong.
  Formula(const std::string &text, const Names &names);

  /// Any number, also infinite or NaN.
  double value(const Values &values) const;

  /// Whether the expression contains the name with this number.
  bool has(std::size_t name) const;

  /// Whether it contains none of them.
  bool is_constant() const;

  /// The text as it was given.
  const std::string &text() const { return text_; }

private:
  struct Parser;

  std::string text_;
  Names names_;
  std::shared_ptr<Parser> parser_;
};
} // namespace orthocone
